// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/text/case_text.hpp"

#include <string>

namespace ionskin {

/// Applies one `--set key=value` to the text of a case in place: comments and order stay. A key
/// that is not there yet is added to its table, a table that is not there yet to the end.
/// @param argument "contact.friction=0.3", "motion.stroke=3 mm", "skin.layers[1].thickness=50 um",
///   "output.fields=[0.5 s, 1 s]"; entries count from 0; a bare word or a quantity needs no quotes
/// Throws UserError pointing into the argument. Whether the key exists is for the reader to say.
void apply_set_edit(CaseText& text, const std::string& argument);

/// The TOML text of a value as typed on a command line: kept when it is TOML, else quoted.
std::string toml_value_text(const std::string& typed);

} // namespace ionskin
