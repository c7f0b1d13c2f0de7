// SPDX-License-Identifier: MIT
#include "folder_manifest.h"

#include "list_reader.h"

namespace franken::cli {
namespace {

// The document, "programs", a program, its interface, a list of it, an entry, a list of that.
constexpr std::size_t kMaxDepth = 7;
constexpr std::size_t kMaxPrograms = 100'000, kMaxTextBytes = 4096;

class Reader : public ListReader {
public:
    Reader() : ListReader("programs", "programs", kMaxDepth) {}

    Result<std::vector<ListedProgram>> read(std::string_view text) {
        const bool whole = nlohmann::json::sax_parse(text, this);
        if (wrong().empty() && (!whole || !wasListed()))
            refuse("it lists no programs");
        if (!wrong().empty())
            return Error{"", "", wrong(), ""};
        return std::move(m_programs);
    }

    bool string(string_t& text) override {
        if (!scalar())
            return false;
        if (!isListing() || depth() != kInObject)
            return true;
        if (text.size() > kMaxTextBytes)
            return refuse("it has a name that is longer than a path may be");
        keep(text);
        return true;
    }

    bool start_object(std::size_t) override {
        if (!isListing() || depth() != kInList)
            return enter();
        if (m_programs.size() == kMaxPrograms)
            return refuse("it lists more programs than a folder has");
        m_programs.emplace_back();
        return enter();
    }

private:
    void keep(const std::string& text) {
        ListedProgram& program = m_programs.back();
        if (lastKey() == "name")
            program.name = text;
        else if (lastKey() == "vertex")
            program.vertex = text;
        else if (lastKey() == "fragment")
            program.fragment = text;
    }

    std::vector<ListedProgram> m_programs;
};

} // namespace

Result<std::vector<ListedProgram>> parseFolderManifest(std::string_view text) { return Reader().read(text); }

} // namespace franken::cli
