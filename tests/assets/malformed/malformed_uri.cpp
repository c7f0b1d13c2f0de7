// SPDX-License-Identifier: MIT
#include "malformed/malformed.h"
#include "malformed/pictures.h"

namespace {

const std::string kPoints(36, '\0');

/// A triangle whose buffer has this URI.
MalformedFile buffer(const std::string& name, const std::string& uri, const std::string& code,
                     std::vector<std::pair<std::string, std::string>> beside = {{"inside.bin", kPoints}}) {
    GltfBuilder file;
    file.setTriangle();
    file.json["buffers"] = {{{"byteLength", 36}, {"uri", uri}}};
    return {"uri/" + name,    "gltf", file.bytes(false), code, code.empty() ? "" : "/buffers/0",
            std::move(beside)};
}

/// A model whose image has this URI: it loads without it.
MalformedFile image(const std::string& name, const std::string& uri) {
    GltfBuilder file = soundModel();
    file.json["images"] = {{{"uri", uri}}};
    return {"uri/image-" + name, "gltf", file.bytes(false), "", "", {{"inside.png", pictures::png(4, 4)}}};
}

} // namespace

// Links, pipes and folders, which are no bytes, are made by the test itself.
std::vector<MalformedFile> malformedUris() {
    const char* const kCode = "gltf.buffer";
    return {
        buffer("sound", "inside.bin", ""),
        buffer("with-escapes", "%69nside%2Ebin", ""),
        buffer("with-a-lone-percent", "inside%.bin", kCode),
        buffer("empty", "", kCode),
        buffer("missing", "missing.bin", kCode),
        buffer("folder", ".", kCode),
        buffer("the-model-itself", "model.gltf", ""),
        buffer("too-short", "short.bin", kCode, {{"short.bin", kPoints.substr(1)}}),
        buffer("empty-file", "empty.bin", kCode, {{"empty.bin", ""}}),
        buffer("parent", "../inside.bin", kCode),
        buffer("parent-below", "folder/../../inside.bin", kCode),
        buffer("parent-escaped", "%2e%2e/inside.bin", kCode),
        buffer("parent-escaped-twice", "%252e%252e/inside.bin", kCode),
        buffer("slash-escaped", "..%2Finside.bin", kCode),
        buffer("absolute", "/etc/passwd", kCode),
        buffer("absolute-escaped", "%2Fetc%2Fpasswd", kCode),
        buffer("two-slashes", "//localhost/inside.bin", kCode),
        buffer("backslashes", "..\\inside.bin", kCode),
        buffer("scheme-file", "file:///etc/passwd", kCode),
        buffer("scheme-http", "http://localhost/inside.bin", kCode),
        buffer("scheme-of-one-letter", "C:\\inside.bin", kCode),
        buffer("zero-byte", "inside.bin%00.png", kCode),
        buffer("device", "/dev/zero", kCode),
        buffer("process-file", "/proc/self/mem", kCode),
        buffer("100000-letters", std::string(100000, 'x'), kCode),
        buffer("line-feed", "a\nb", kCode),
        buffer("data-without-comma", "data:application/octet-stream;base64", kCode),
        buffer("data-not-base64", "data:;base64,!!!!", kCode),
        buffer("data-too-short", "data:;base64,AAAA", kCode),
        buffer("data-without-base64", "data:," + std::string(36, 'A'), ""),
        buffer("data-of-escapes", "data:,%00%0", kCode),
        image("missing", "missing.png"),
        image("parent", "../inside.png"),
        image("absolute", "/etc/passwd"),
        image("empty", ""),
        image("data-not-base64", "data:image/png;base64,?"),
        image("text", "data:text/plain,hello"),
    };
}
