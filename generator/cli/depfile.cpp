// SPDX-License-Identifier: MIT
#include "depfile.h"

namespace franken::cli {
namespace {

std::string escaped(const std::string& name) {
    std::string text;
    for (std::size_t i = 0; i < name.size(); ++i) {
        const char c = name[i];
        if (c == '$')
            text += '$';
        if (c == ' ' || c == '#')
            text += '\\';
        text += c;
    }
    return text;
}

} // namespace

std::string depfileText(const std::string& target, const std::vector<std::string>& sources) {
    std::string text = escaped(target) + ":";
    for (const std::string& source : sources)
        text += " \\\n  " + escaped(source);
    return text + "\n";
}

} // namespace franken::cli
