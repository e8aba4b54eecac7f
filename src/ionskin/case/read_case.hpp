// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case_document.hpp"

#include <string>
#include <vector>

namespace ionskin {

/// Reads and checks a case file.
/// @param path TOML file; see the schema for its keys
/// @param set_edits "key=value" each, applied to the text in this order
/// Throws UserError with all mistakes that were found: what, where (line and caret), remedy.
Case read_case(const std::string& path, const std::vector<std::string>& set_edits = {});

/// The same, keeping where each value came from.
CaseDocument read_case_document(const std::string& path,
                                const std::vector<std::string>& set_edits = {});

} // namespace ionskin
