// SPDX-License-Identifier: MIT
#include "gltf/source.h"

#include "franken/printable.h"

namespace franken::gltf {
namespace {

// Names and words of a file end up on terminals and in logs.
std::string shown(const std::string& text) {
    constexpr std::size_t kMaxChars = 400;
    return printable(text.size() > kMaxChars ? text.substr(0, kMaxChars) + "..." : text);
}

bool isSoft(const std::string& code) {
    return code == "gltf.schema" || code == "gltf.type" || code == "gltf.value";
}

} // namespace

bool Source::fail(std::string_view code, const std::string& where, std::string what,
                  std::string_view remedy) {
    if (!error)
        error = Error{std::string(code), where.empty() ? file : file + ": " + shown(where), shown(what),
                      std::string(remedy)};
    return false;
}

bool Source::defer(const std::string& element) {
    if (!error || !isSoft(error->code))
        return false;
    faults.emplace(element, *std::move(error));
    error.reset();
    return true;
}

bool Source::need(const std::string& element) {
    const auto fault = faults.find(element);
    if (fault == faults.end())
        return true;
    if (!error)
        error = fault->second;
    return false;
}

void Source::warnOfUnneeded() const {
    if (log)
        for (const auto& [element, fault] : faults)
            log(LogLevel::Warning, fault.where + ": " + fault.what + "; nothing that is drawn needs it (" +
                                       fault.code + ") [" + std::string(kUnneeded) + "]");
}

bool Source::proceed(float done, std::string_view what) {
    if (options.cancel.stop_requested())
        return fail("gltf.cancelled", "", "loading was cancelled", "load it again when it is wanted");
    try {
        if (options.progress)
            options.progress(done, what);
    } catch (...) { // Nobody is there to be told of it.
        return true;
    }
    return true;
}

bool Source::charge(std::size_t count, std::size_t bytesEach, const std::string& where) {
    if (options.cancel.stop_requested())
        return proceed(0, where);
    if (count > room() / bytesEach)
        return fail("gltf.limit", where,
                    "the file needs more memory than the limit of " +
                        std::to_string(options.maxMemoryBytes >> 20) + " MiB",
                    "make the model smaller, or raise LoadOptions::maxMemoryBytes");
    charged += count * bytesEach;
    return true;
}

void Source::warn(std::string_view code, const std::string& where, const std::string& what) const {
    if (log)
        log(LogLevel::Warning, (where.empty() ? file : file + ": " + shown(where)) + ": " + shown(what) +
                                   " [" + std::string(code) + "]");
}

void Source::warnOnce(std::string_view code, const std::string& what) {
    if (warned.insert(what).second)
        warn(code, "", what);
}

} // namespace franken::gltf
