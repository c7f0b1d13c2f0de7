// SPDX-License-Identifier: MIT
#pragma once

#include "effect_text.h"
#include "glsl_syntax.h"

namespace franken {

/// Whether a choice can be one of an effect, or of none.
bool isEffect(const EffectChoice& choice);

/// "effect.missing"; `which` is "'fog'" or "in slot 3".
Error missingEffect(const std::string& which);

Error badEffect(const char* code, std::string_view file, int line, std::string what, std::string remedy);

/// The word of an effect is told from those of choices, and from files' names.
Result<void> checkEffectName(std::string_view name);

/// "fog@5d0b1a3c", whether there is such an effect or not.
bool isEffectWord(std::string_view word);

/// No name of FrankenShader's, of GLSL or of an earlier declaration. `line` is that in the file.
Result<void> checkFree(const Effect::Text& effect, std::string_view declared, int line);

/// Finds the function of a section, checks its head, and fills in the call and the traits.
Result<void> readHook(Effect::Text& effect, Effect::Text::Hook& hook);

} // namespace franken
