// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/draw_state.h"
#include "franken/log.h"
#include "franken/result.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace FRANKEN_API franken {

/// The programs that a run needed, kept for the warm-up of the next one: a text file, which `frankenshader
/// dump --manifest` and the other commands read as well.
///
///     # FrankenShader manifest, schema 2
///     basecolor.normal+sun1 wrap0=cr wrap1=rr
///     blend+sun1
///     # end 2 5d0b1a3c
///
/// `wrapN=st` says how unit N's texture wraps along s and t (r repeats, c clamps, m mirrors) if not in the
/// usual way; `blend=on` and `blend=off` appear if a program is blended though its name does not say so, or
/// the other way round. The last line has the number of programs and the CRC-32 of everything before it, by
/// which a cut or changed file is recognised. A list written by hand needs neither first nor last line.
///
/// A program with an effect of the application's (effect.h) is named with it and a hash of its text. All
/// functions take the snippets of the run. A program whose effect they have not got, or with another text, is
/// skipped, and the log says which effect and what to do; a file keeps the former when programs are added. A
/// program that is to be written, but whose effect the snippets have not got, has no name and is left out.
///
/// Needs no GL; any thread.
inline constexpr std::size_t kMaxManifestBytes = std::size_t{1} << 20;

/// A manifest of these uses, whole.
std::string toManifest(std::span<const ProgramUse> uses, const SnippetSet& snippets = SnippetSet::builtIn());

/// Returns all programs or fails with "manifest.schema" (another version's), "manifest.damaged" (cut or
/// changed), "manifest.line" (a word is wrong), "manifest.empty" (a list by hand without a name) and
/// "manifest.size". Errors call the text `name`.
Result<std::vector<ProgramUse>> parseManifest(std::string_view text, const std::string& name,
                                              const SnippetSet& snippets = SnippetSet::builtIn(),
                                              const Log& log = {});

/// Fails as parseManifest() does, and with "manifest.read".
Result<std::vector<ProgramUse>> readManifest(const std::filesystem::path& file,
                                             const SnippetSet& snippets = SnippetSet::builtIn(),
                                             const Log& log = {});

/// The same for a program's start: where reading fails, one log line says why, and the list is empty.
std::vector<ProgramUse> readManifestOrNothing(const std::filesystem::path& file, const Log& log,
                                              const SnippetSet& snippets = SnippetSet::builtIn());

/// Writes the list: the path holds the old or the complete new file, even if the power fails (see
/// file_writer.h). Replaces only manifests of this library, damaged ones and those of another schema
/// included, or creates the file. Fails, and leaves the file as it was, with
///
///     manifest.write     it cannot be written, or what is there cannot be read
///     manifest.foreign   what is there is something else, or a list by hand
///     manifest.size      it would be larger than kMaxManifestBytes
Result<void> writeManifest(const std::filesystem::path& file, std::span<const ProgramUse> uses,
                           const SnippetSet& snippets = SnippetSet::builtIn());

/// Adds the programs that the file lacks, and writes it if there are any. Programs that other threads or
/// processes add at the same time stay. A list written by hand keeps its text and comments, and gets lines at
/// its end. Fails as writeManifest() does.
Result<void> appendToManifest(const std::filesystem::path& file, std::span<const ProgramUse> uses,
                              const SnippetSet& snippets = SnippetSet::builtIn());

} // namespace franken
