// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/text/case_text.hpp"

#include <string>
#include <vector>

namespace ionskin {

class TomlText;

/// Applies edits `--set key=value` to the text of a case in place, as if one after another:
/// comments and order stay. The text is parsed once for all edits that have nothing to do with one
/// another.
/// @param arguments "contact.friction=0.3", "motion.stroke=3 mm", "skin.layers[1].thickness=50 um",
///   "output.fields=[0.5 s, 1 s]"; entries count from 0; a bare word or a quantity needs no quotes
/// @return the values of the text as it is now
/// Throws UserError where the text is not TOML, and pointing into an edit that cannot be made.
TomlText apply_set_edits(CaseText& text, const std::vector<std::string>& arguments);

void apply_set_edit(CaseText& text, const std::string& argument);

/// The TOML text of a value as typed on a command line: kept when it is TOML, else quoted.
std::string toml_value_text(const std::string& typed);

} // namespace ionskin
