// SPDX-License-Identifier: MIT
#include <algorithm>
#include <exception>
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
        return source.fail("gltf.json", "", "the parser refuses the file: " + firstLine(errors),
                           std::string(kFixExporter));
    // tinygltf takes inverse bind matrices to be required; glTF does not.
    if (!errors.empty() && errors.find("inverseBindMatrices") == std::string::npos)
        source.warn("", "the parser left something out: " + firstLine(errors));
    source.model.bufferViews.pop_back();
    for (tinygltf::Accessor& accessor : source.model.accessors)
        if (accessor.bufferView == source.placeholderView)
            accessor.bufferView = kNone;
    return true;
}

bool load(Source& source, const std::filesystem::path& path, Scene& scene) {
    std::string problem, text;
    // tinygltf counts in 32 bits.
    source.bytes = readFile(path, std::min<std::size_t>(source.options.maxFileBytes, 0xFFFFFFFF), problem);
    if (!problem.empty())
        return source.fail("gltf.file", "", problem,
                           "check that it exists, may be read, and is within the limits");
    if (!openContainer(source) || !readJson(source, text) || !parse(source, text))
        return false;
    if (!validateData(source) || !validateTree(source))
        return false;
    loadResources(source, path.parent_path());
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
