// SPDX-License-Identifier: MIT
#pragma once

#include "franken/api.h"
#include "franken/result.h"

#include <filesystem>
#include <memory>

namespace FRANKEN_API franken {

/// The snippets that programs are composed of. Everyone is served by those that the library was built with,
/// but for people who write snippets: they read the folder again when a file has changed, and build nothing.
///
/// A value that never changes and is cheap to copy (one reference is counted), safe on any thread. What has
/// been composed from a set holds nothing of it.
class SnippetSet {
public:
    /// The files of generator/glsl, as they were at build time. What is composed unless told otherwise.
    static const SnippetSet& builtIn();

    /// Reads vertex/NAME.glsl and fragment/NAME.glsl of a folder that is laid out as generator/glsl is: all
    /// snippets that the recipe names, and no others. Text may differ from the built-in one in everything but
    /// what the rest of this build relies on: attributes, uniforms and samplers can be left out, but new ones
    /// need a place in pack.h or interface.h, and so a build.
    ///
    /// Whether the GLSL compiles is for a driver to say. Fails, with file and line in `where`, with
    ///
    ///     snippet.file        cannot be read, or is larger than 64 KiB
    ///     snippet.syntax      breaks the contract of a snippet (generator/README.md)
    ///     snippet.interface   declares what no built-in snippet declares, or as another type
    static Result<SnippetSet> read(const std::filesystem::path& folder);

    /// All parts of programs; the generator's own business (src/library.h).
    struct Parts;
    const Parts& parts() const { return *m_parts; }

private:
    explicit SnippetSet(std::shared_ptr<const Parts> parts) : m_parts(std::move(parts)) {}

    std::shared_ptr<const Parts> m_parts;
};

} // namespace franken
