// SPDX-License-Identifier: MIT
#include <algorithm>
#include <exception>
#include <new>

#include "franken/file.h"
#include "gltf/internal.h"

namespace franken {
namespace gltf {

namespace {

constexpr std::size_t kMaxParserBytes = 0xFFFFFFFF; ///< tinygltf counts in 32 bits.

// Names and words of a file end up on terminals and in logs: on one line, and without what steers a terminal.
std::string printable(std::string text) {
    constexpr std::size_t kMaxChars = 400;
    if (text.size() > kMaxChars)
        text = text.substr(0, kMaxChars) + "...";
    for (char& c : text)
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)
            c = '?';
    return text;
}

} // namespace

bool Source::fail(std::string_view code, const std::string& where, std::string what,
                  std::string_view remedy) {
    if (!error)
        error = Error{std::string(code), where.empty() ? file : file + ": " + printable(where),
                      printable(std::move(what)), std::string(remedy)};
    return false;
}

bool Source::charge(std::size_t count, std::size_t bytesEach, const std::string& where) {
    if (count > room() / bytesEach)
        return fail("gltf.limit", where,
                    "the file needs more memory than the limit of " +
                        std::to_string(options.maxMemoryBytes >> 20) + " MiB",
                    "make the model smaller, or raise LoadOptions::maxMemoryBytes");
    charged += count * bytesEach;
    return true;
}

void Source::warn(const std::string& where, const std::string& what) const {
    if (log)
        log(LogLevel::Warning,
            (where.empty() ? file : file + ": " + printable(where)) + ": " + printable(what));
}

void Source::warnOnce(const std::string& what) {
    if (warned.insert(what).second)
        warn("", what);
}

bool Source::uses(std::string_view extension) const {
    return std::find(model.extensionsUsed.begin(), model.extensionsUsed.end(), extension) !=
           model.extensionsUsed.end();
}

namespace {

// Image bytes are read, and decoded, elsewhere.
bool ignoreImage(tinygltf::Image*, const int, std::string*, std::string*, int, int, const unsigned char*, int,
                 void*) {
    return true;
}

std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

bool parse(Source& source, const std::string& text) {
    tinygltf::TinyGLTF parser;
    parser.SetImageLoader(ignoreImage, nullptr);
    std::string errors, warnings;
    if (!parser.LoadASCIIFromString(&source.model, &errors, &warnings, text.data(),
                                    static_cast<unsigned int>(text.size()), ""))
        return source.fail("gltf.json", "", "the parser refuses the file: " + firstLine(errors));
    // tinygltf takes inverse bind matrices to be required; glTF does not.
    if (!errors.empty() && errors.find("inverseBindMatrices") == std::string::npos)
        source.warn("", "the parser left something out: " + firstLine(errors));
    source.model.bufferViews.pop_back();
    for (tinygltf::Accessor& accessor : source.model.accessors)
        if (accessor.bufferView == source.placeholderView)
            accessor.bufferView = kNone;
    return true;
}

bool load(Source& source, const std::filesystem::path* folder, Scene& scene) {
    std::string text;
    if (!source.charge(source.bytes.size(), 1, "") || !openContainer(source) || !readJson(source, text) ||
        !parse(source, text))
        return false;
    text = {};
    return validateData(source) && validateTree(source) && loadResources(source, folder) &&
           readMaterials(source, scene) && readNodes(source, scene);
}

Result<Scene> loadBytes(std::span<const std::uint8_t> bytes, const std::string& name,
                        const std::filesystem::path* folder, const LoadOptions& options, const Log& log) {
    Source source;
    source.file = name;
    source.options = options;
    source.log = log;
    source.bytes = bytes;
    Scene scene;
    try {
        if (load(source, folder, scene))
            return scene;
    } catch (const std::bad_alloc&) {
        source.fail("gltf.limit", "", "there is not enough memory for the file", "make the model smaller");
    } catch (const std::exception& exception) {
        source.fail("gltf.json", "", std::string("the parser gives up: ") + exception.what());
    }
    return *std::move(source.error);
}

} // namespace
} // namespace gltf

namespace {

constexpr const char* kRaiseFileLimit = "make it smaller, or raise LoadOptions::maxFileBytes";

} // namespace

Result<Scene> loadGltf(const std::filesystem::path& path, const LoadOptions& options, const Log& log) {
    const auto bytes = readFile(path, std::min(options.maxFileBytes, gltf::kMaxParserBytes));
    if (!bytes)
        return Error{"gltf.file", path.string(), bytes.error().what,
                     bytes.error().code == "file.size" ? kRaiseFileLimit : bytes.error().remedy};
    const std::filesystem::path folder = path.parent_path();
    return gltf::loadBytes(*bytes, path.string(), &folder, options, log);
}

Result<Scene> loadGltf(std::span<const std::uint8_t> file, const std::string& name,
                       const LoadOptions& options, const Log& log) {
    const std::size_t limit = std::min(options.maxFileBytes, gltf::kMaxParserBytes);
    if (file.size() > limit)
        return Error{"gltf.file", name, "the file is over the limit of " + std::to_string(limit) + " bytes",
                     kRaiseFileLimit};
    return gltf::loadBytes(file, name, nullptr, options, log);
}

} // namespace franken
