// SPDX-License-Identifier: MIT
#include "kiosk/config/read_config.h"

#include "franken/file.h"
#include "franken/printable.h"
#include "kiosk/config/setting.h"

#include <algorithm>
#include <cmath>
#include <map>

// Without exceptions it is a library of its own, of headers alone.
#define TOML_HEADER_ONLY 1
#define TOML_EXCEPTIONS 0
#include <toml++/toml.h>

namespace kiosk {

namespace {

using franken::Error;

constexpr std::size_t kMaxFileBytes = std::size_t{256} << 10;

std::string at(const std::string& name, const toml::source_region& source) {
    return name + ":" + std::to_string(source.begin.line) + ":" + std::to_string(source.begin.column);
}

/// Nothing for what no setting takes: tables, dates, lists of other things than texts.
std::optional<RawValue> rawValueOf(const toml::node& node) {
    if (const auto value = node.value_exact<bool>())
        return *value;
    if (const auto value = node.value_exact<std::int64_t>())
        return static_cast<long long>(*value);
    if (const auto value = node.value_exact<double>())
        return *value;
    if (const auto value = node.value_exact<std::string>())
        return *value;
    const toml::array* array = node.as_array();
    if (array == nullptr)
        return {};
    Texts texts;
    for (const toml::node& each : *array) {
        const auto text = each.value_exact<std::string>();
        if (!text)
            return {};
        texts.push_back(*text);
    }
    return texts;
}

/// Makes what a path setting names absolute.
void resolvePaths(const Setting& setting, const std::filesystem::path& folder, Config& config) {
    const auto resolve = [&folder](std::string& path) {
        if (!path.empty())
            path = (folder / path).lexically_normal().string();
    };
    if (const Text* text = std::get_if<Text>(&setting.kind); text != nullptr && text->isPath)
        resolve(text->of(config));
    if (const TextList* list = std::get_if<TextList>(&setting.kind); list != nullptr && list->isPath)
        std::for_each(list->of(config).begin(), list->of(config).end(), resolve);
}

class Reader {
public:
    Reader(std::string name, std::filesystem::path folder, ReadConfig& read)
        : m_name(std::move(name)), m_folder(std::move(folder)), m_read(read) {}

    void table(const toml::table& table, const std::string& prefix) {
        for (const auto& [key, node] : table) {
            const std::string full = prefix + std::string(key.str());
            if (const Setting* setting = findSetting(full))
                value(*setting, node);
            else if (node.is_table() && isSection(full))
                this->table(*node.as_table(), full + ".");
            else
                unknown(full, key.source());
        }
    }

private:
    static bool isSection(const std::string& name) {
        return std::any_of(settings().begin(), settings().end(),
                           [&name](const Setting& setting) { return setting.key.starts_with(name + "."); });
    }

    void value(const Setting& setting, const toml::node& node) {
        const std::optional<RawValue> raw = rawValueOf(node);
        const std::optional<std::string> fault =
            raw ? assign(setting, *raw, m_read.config) : std::optional<std::string>("is of another kind");
        if (!fault)
            return resolvePaths(setting, m_folder, m_read.config);
        m_read.faults.push_back({"config.value", at(m_name, node.source()),
                                 setting.key + " " + franken::printable(*fault), "give " + typeOf(setting)});
    }

    void unknown(const std::string& key, const toml::source_region& source) {
        const std::string nearest = nearestKey(key);
        m_read.faults.push_back(
            {"config.unknown-key", at(m_name, source), "there is no setting " + franken::printable(key),
             nearest.empty() ? "`kiosk settings` lists them" : nearest + " was probably meant"});
    }

    std::string m_name;
    std::filesystem::path m_folder;
    ReadConfig& m_read;
};

void applyOverrides(const Overrides& overrides, ReadConfig& read) {
    for (const auto& [key, text] : overrides) {
        const Setting* setting = findSetting(key);
        if (setting == nullptr) {
            read.faults.push_back({"config.unknown-key", "--" + key, "there is no setting of that name", ""});
            continue;
        }
        if (const auto fault = assign(*setting, rawValueOf(*setting, text), read.config))
            read.faults.push_back({"config.value", "--" + key,
                                   franken::printable("\"" + text + "\" " + *fault),
                                   "give " + typeOf(*setting)});
        else
            resolvePaths(*setting, std::filesystem::current_path(), read.config);
    }
}

/// The same key, button or gesture for two actions.
void checkBindings(const Bindings& bindings, const std::string& section, const std::string& name,
                   std::vector<Error>& faults) {
    std::map<std::string, std::string> actions;
    for (const auto& [action, triggers] : bindings)
        for (const std::string& trigger : triggers)
            if (const auto [entry, isNew] = actions.emplace(trigger, action); !isNew)
                faults.push_back({"config.twice", name,
                                  "\"" + trigger + "\" is given to both " + section + "." + entry->second +
                                      " and " + section + "." + action,
                                  "take it from one of them"});
}

void checkTogether(ReadConfig& read, const std::string& name) {
    checkBindings(read.config.keys, "keys", name, read.faults);
    checkBindings(read.config.buttons, "buttons", name, read.faults);
    checkBindings(read.config.touch, "touch", name, read.faults);
    if (read.config.screen.assumeConnected && read.config.screen.output.empty())
        read.faults.push_back({"config.together", name,
                               "screen.assume-connected is on, but screen.output is empty",
                               "name the output that has the screen"});
}

} // namespace

ReadConfig parseConfig(const std::string& text, const std::string& name,
                       const std::filesystem::path& folder) {
    ReadConfig read;
    const toml::parse_result parsed = toml::parse(franken::withoutByteOrderMark(text));
    if (parsed)
        Reader(name, folder, read).table(parsed.table(), {});
    else
        read.faults.push_back({"config.syntax", at(name, parsed.error().source()),
                               franken::printable(std::string(parsed.error().description())),
                               "see https://toml.io"});
    return read;
}

ReadConfig readConfig(const std::filesystem::path& file, const Overrides& overrides) {
    ReadConfig read;
    if (!file.empty()) {
        const auto bytes = franken::readFile(file, kMaxFileBytes);
        if (bytes)
            read = parseConfig({bytes->begin(), bytes->end()}, file.string(),
                               std::filesystem::absolute(file).parent_path());
        else
            read.faults.push_back(bytes.error());
    }
    applyOverrides(overrides, read);
    checkTogether(read, file.empty() ? "options" : file.string());
    return read;
}

std::vector<std::string> needRestart(const Config& before, const Config& after) {
    std::vector<std::string> keys;
    for (const Setting& setting : settings())
        if (setting.takes == Takes::Restart && valueText(setting, before) != valueText(setting, after))
            keys.push_back(setting.key);
    return keys;
}

} // namespace kiosk
