// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"

#include <string>
#include <vector>

namespace ionskin {

/// Reads and checks a case file.
/// @param path TOML file, with the keys of `schema`
/// @param set_edits "key=value" each, applied to the text in this order
/// Throws UserError with all mistakes found, each with its position (line and caret) and a remedy.
Case read_case(const std::string& path, const std::vector<std::string>& set_edits = {});

/// Reads and checks a case file, and stores the origin of each value; arguments and errors as of
/// `read_case`.
CaseDocument read_case_document(const std::string& path,
                                const std::vector<std::string>& set_edits = {});

/// Reads and checks the text of a case file; errors as of `read_case`.
/// @param path name of the text in messages; paths in the case are relative to its folder
/// @param set_edits "key=value" each, applied to the text in this order
CaseDocument read_case_text(const std::string& text, const std::string& path,
                            const std::vector<std::string>& set_edits = {});

/// Checks each value in the text of a case by itself. Missing keys and conflicts between keys are
/// not checked: `read_case` finds them.
/// @param name of the case, for messages
/// @param set_edits "key=value" each, applied to the text in this order
/// Throws UserError with all unknown keys and bad values.
void check_values(const std::string& text, const std::string& name,
                  const std::vector<std::string>& set_edits = {});

} // namespace ionskin
