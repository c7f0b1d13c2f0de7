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

/// What a run needed, kept for the warm-up of the next one. A file of text that `frankenshader dump
/// --manifest` and the other commands read as well:
///
///     # FrankenShader manifest, schema 2
///     basecolor.normal+sun1 wrap0=cr wrap1=rr
///     blend+sun1
///     # end 2 5d0b1a3c
///
/// `wrapN=st` says how unit N's texture wraps along s and t (r repeats, c clamps, m mirrors) where it is not
/// as usual; `blend=on` and `blend=off` stand where a program is blended though its name does not say so, or
/// the other way round. The last line counts the programs and has the CRC-32 of all before it, so that a file
/// that was cut anywhere, or changed, is told from a whole one. A list written by hand has no first line of
/// that kind and needs no last one.
///
/// Needs no GL; any thread.
inline constexpr std::size_t kMaxManifestBytes = std::size_t{1} << 20;

std::string toManifest(std::span<const ProgramUse> uses);

/// Fails, for all or nothing, with "manifest.schema" (another version's), "manifest.damaged" (cut or
/// changed), "manifest.line" (a word is wrong), "manifest.empty" (a list by hand without a name) and
/// "manifest.size". `name` is what errors call the text.
Result<std::vector<ProgramUse>> parseManifest(std::string_view text, const std::string& name);

/// Fails as parseManifest() does, and with "manifest.read".
Result<std::vector<ProgramUse>> readManifest(const std::filesystem::path& file);

/// The same for a start: where it fails, one line says why, and nothing is warmed up.
std::vector<ProgramUse> readManifestOrNothing(const std::filesystem::path& file, const Log& log);

/// Writes the list: the file is the old one or the whole new one, whenever the power goes (file_writer.h says
/// how). Only a file that is missing, is by us, or was by us and is damaged or of another schema is replaced.
/// Fails, and leaves the file as it was, with
///
///     manifest.write     it cannot be written, or what is there cannot be read
///     manifest.foreign   what is there is something else, or a list by hand
///     manifest.size      it would be larger than kMaxManifestBytes
Result<void> writeManifest(const std::filesystem::path& file, std::span<const ProgramUse> uses);

/// Adds what is not in the file yet, and writes it if there is any. What others add at the same time, threads
/// or processes, stays. A list by hand keeps its text and comments, and gets lines at its end. Fails as
/// writeManifest() does.
Result<void> appendToManifest(const std::filesystem::path& file, std::span<const ProgramUse> uses);

} // namespace franken
