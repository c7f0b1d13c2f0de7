// SPDX-License-Identifier: MIT
#pragma once

#include "cost_gate.h"
#include "diff_folder.h"
#include "explanation.h"
#include "finding.h"
#include "program.h"
#include "selection.h"

#include <optional>
#include <string>
#include <vector>

namespace franken::cli {

/// Raised when a member of the output below changes its meaning or goes; new members may come at any time.
inline constexpr int kJsonSchema = 1;

// One document a command, ended by a newline. All begin with "schema" and "command".

std::string listJson(const std::vector<Permutation>& listed, const Selected& selected);

/// What `list --words` tells: the choices, and the words and meanings of their values.
std::string wordsJson();

/// Whether the programs' texts are in files beside the document, which names them, or in the document.
enum class Texts { InFiles, Inline };

/// The document of `dump`, a piece at a time: begin(), program() for each, end().
class DumpJson {
public:
    explicit DumpJson(Texts texts) : m_texts(texts) {}
    std::string begin() const;
    std::string program(const Program& program);
    std::string end() const;

private:
    Texts m_texts;
    bool m_first = true;
};

std::string explainJson(const Explanation& explanation);
std::string diffJson(const Program& first, const Program& second, const std::string& vertex,
                     const std::string& fragment);
std::string diffFolderJson(const std::string& folder, const std::vector<FolderProgram>& programs);
std::string checkJson(std::size_t programs, const std::vector<std::string>& profiles, bool glslangAsked,
                      const std::vector<Finding>& findings);

/// Findings where there is a gate.
std::string costJson(const std::vector<Bill>& bills, const std::optional<GateFindings>& gate);

/// What is answered in place of a document where a command fails.
std::string errorsJson(const std::vector<Error>& errors);

} // namespace franken::cli
