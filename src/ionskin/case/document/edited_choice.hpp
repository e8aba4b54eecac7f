// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/case/text/case_text.hpp"
#include "ionskin/case/text/toml_text.hpp"

#include <optional>
#include <string>
#include <vector>

namespace ionskin {

/// Keys such as motion.kind that `--set` gives another choice. What had a meaning in the case
/// without any edit may have none now, and the other way round.
struct EditedChoices {
  std::string words;           ///< "motion.kind = \"waypoints\"", of all of them
  std::vector<Pointer> places; ///< of their values
  Case before;
  std::vector<std::string> left_out; ///< keys of the file that have no meaning now
};

/// Finds the choices among edits, and turns what stands in the file and has lost its meaning by
/// them into comments; in an inline table it is removed. What edits set themselves stays, for the
/// checks to refuse. Empty where no choice is edited.
/// @param text, values with the edits; both are changed where something is left out
/// @param original the text without edits
std::optional<EditedChoices> fit_to_edited_choices(CaseText& text, TomlText& values,
                                                   const std::string& original,
                                                   const std::vector<std::string>& set_edits);

} // namespace ionskin
