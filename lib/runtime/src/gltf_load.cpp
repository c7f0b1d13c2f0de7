// SPDX-License-Identifier: MIT
#include <algorithm>
#include <exception>
#include <fstream>
#include <new>

#include "gltf_internal.h"

namespace franken {
namespace gltf {

bool Source::fail(std::string_view code, const std::string& where, std::string what, std::string remedy) {
    if (!error)
        error = Error{std::string(code), where.empty() ? file : file + ": " + where, std::move(what),
                      std::move(remedy)};
    return false;
}

void Source::warn(const std::string& where, const std::string& what) const {
    if (log)
        log(LogLevel::Warning, (where.empty() ? file : file + ": " + where) + ": " + what);
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

bool readFile(Source& source, const std::filesystem::path& path, std::vector<std::uint8_t>& bytes) {
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    const std::streamoff size = file ? static_cast<std::streamoff>(file.tellg()) : -1;
    if (size < 0 || std::filesystem::is_directory(path))
        return source.fail("gltf.file", "", "the file cannot be opened",
                           "check that it exists and may be read");
    // tinygltf counts in 32 bits.
    if (static_cast<std::size_t>(size) > std::min<std::size_t>(source.options.maxFileBytes, 0xFFFFFFFF))
        return source.fail("gltf.file", "", "the file has " + std::to_string(size) + " bytes, over the limit",
                           "raise LoadOptions::maxFileBytes if the file is to be trusted");
    bytes.resize(static_cast<std::size_t>(size));
    file.seekg(0);
    if (!file.read(reinterpret_cast<char*>(bytes.data()), size))
        return source.fail("gltf.file", "", "the file cannot be read", "check the medium that it is on");
    return true;
}

// Images are decoded later, on several threads, and only where a material uses them. Those in buffer views
// stay there, untouched: tinygltf has not checked that view.
bool keepEncoded(tinygltf::Image* image, const int, std::string*, std::string*, int, int,
                 const unsigned char* bytes, int size, void*) {
    if (image->bufferView < 0)
        image->image.assign(bytes, bytes + size);
    return true;
}

std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

bool parse(Source& source, const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
    tinygltf::TinyGLTF parser;
    parser.SetImageLoader(keepEncoded, nullptr);
    std::string errors, warnings;
    const std::string folder = path.parent_path().string();
    const auto size = static_cast<unsigned int>(bytes.size());
    const bool parsed =
        isBinary(bytes)
            ? parser.LoadBinaryFromMemory(&source.model, &errors, &warnings, bytes.data(), size, folder)
            : parser.LoadASCIIFromString(&source.model, &errors, &warnings,
                                         reinterpret_cast<const char*>(bytes.data()), size, folder);
    if (!parsed)
        return source.fail("gltf.json", "", "the parser refuses the file: " + firstLine(errors),
                           std::string(kFixExporter));
    // tinygltf takes inverse bind matrices to be required; glTF does not.
    if (!errors.empty() && errors.find("inverseBindMatrices") == std::string::npos)
        source.warn("", "the parser left something out: " + firstLine(errors));
    return true;
}

bool load(Source& source, const std::filesystem::path& path, Scene& scene) {
    std::vector<std::uint8_t> bytes;
    if (!readFile(source, path, bytes) || !checkContainer(source, bytes) || !parse(source, path, bytes))
        return false;
    bytes = {};
    if (!validateData(source) || !validateTree(source))
        return false;
    if (!source.model.animations.empty())
        source.warn("/animations", "animations are not played; the file is shown at rest");
    return readMaterials(source, scene) && readNodes(source, scene);
}

} // namespace
} // namespace gltf

Result<Scene> loadGltf(const std::filesystem::path& path, const LoadOptions& options, const Log& log) {
    gltf::Source source;
    source.file = path.string();
    source.options = options;
    source.log = log;
    Scene scene;
    try {
        if (gltf::load(source, path, scene))
            return scene;
    } catch (const std::bad_alloc&) {
        source.fail("gltf.limit", "", "there is not enough memory for the file", "make the model smaller");
    } catch (const std::exception& exception) {
        source.fail("gltf.json", "", std::string("the parser gives up: ") + exception.what(),
                    std::string(gltf::kFixExporter));
    }
    return *std::move(source.error);
}

} // namespace franken
