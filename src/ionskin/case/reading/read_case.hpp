// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"

#include <string>
#include <vector>

namespace ionskin {

/// Reads and checks a case file.
/// @param path TOML file; see the schema for its keys
/// @param set_edits "key=value" each, applied to the text in this order
/// Throws UserError with all mistakes that were found: what, where (line and caret), remedy.
Case read_case(const std::string& path, const std::vector<std::string>& set_edits = {});

/// Reads and checks a case file, and keeps where each value came from.
CaseDocument read_case_document(const std::string& path,
                                const std::vector<std::string>& set_edits = {});

/// Reads and checks the text of a case file.
/// @param path names it in messages; files that the case names are looked for in its folder
CaseDocument read_case_text(const std::string& text, const std::string& path,
                            const std::vector<std::string>& set_edits = {});

/// Checks each value that a text gives, by itself. Throws UserError for unknown keys and bad
/// values; missing keys and values that do not fit together are left to the reading.
void check_values(const std::string& text, const std::string& name,
                  const std::vector<std::string>& set_edits = {});

} // namespace ionskin
