// SPDX-License-Identifier: MIT
#pragma once

#include "effect_text.h"
#include "glsl_syntax.h"

namespace franken {

/// Whether a choice can be one of an effect, or of none.
bool isEffect(const EffectChoice& choice);

/// "permutation.range", for a choice that isEffect() is not true of.
Error noEffect(std::string where);

/// "effect.missing"; `which` is "'fog'" or "in slot 3".
Error missingEffect(const std::string& which);

/// An error of a text; `line` is 0 where it is of no line.
Error badEffect(const char* code, std::string_view file, int line, std::string what, std::string remedy);

/// Fails with "effect.name" for what does not have the form of a name, or is a word of a choice.
Result<void> checkEffectName(std::string_view name);

/// "fog@afb248b9", whether there is such an effect or not.
bool isEffectWord(std::string_view word);

/// Fails with "effect.clash" for a name that FrankenShader's snippets or GLSL have. `line` is that in the
/// file.
Result<void> checkFree(const Effect::Text& effect, std::string_view declared, int line);

/// Finds the function of a section, checks its head, and fills in the call and the traits.
Result<void> readHook(Effect::Text& effect, Effect::Text::Hook& hook);

} // namespace franken
