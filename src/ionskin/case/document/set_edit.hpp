// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/text/case_text.hpp"

#include <string>
#include <vector>

namespace ionskin {

class TomlText;

/// Applies edits `--set key=value` to the text of a case, with the result of one after another.
/// Comments and the order of the text are preserved. The text is parsed only once for all edits
/// that are independent of one another.
/// @param text changed in place
/// @param arguments "contact.friction=0.3", "motion.stroke=3 mm", "skin.layers[1].thickness=50 um",
///   "output.fields=[0.5 s, 1 s]"; entries count from 0; a bare word or a quantity needs no quotes
/// @return the edited text, parsed
/// Throws UserError when the text is not TOML, and one that points into an edit that cannot be
/// made.
TomlText apply_set_edits(CaseText& text, const std::vector<std::string>& arguments);

/// Applies a single edit; see `apply_set_edits`.
void apply_set_edit(CaseText& text, const std::string& argument);

/// Converts a value as typed on a command line to TOML: unchanged if it is a TOML value, else in
/// quotes. The entries of a list are converted one by one.
std::string toml_value_text(const std::string& typed);

} // namespace ionskin
