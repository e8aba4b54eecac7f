// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/case/text/case_text.hpp"
#include "ionskin/case/text/toml_text.hpp"

#include <optional>
#include <string>
#include <vector>

namespace ionskin {

/// The choices, such as motion.kind, that `--set` edits change, and their consequences. Keys that
/// have an effect in the case without edits may have none with them, and the other way round.
struct EditedChoices {
  std::string words;                 ///< all edited choices: "motion.kind = \"waypoints\""
  std::vector<Pointer> places;       ///< positions of their values
  Case before;                       ///< the case without edits, unchecked
  std::vector<std::string> left_out; ///< keys of the file that have no effect with the edits
};

/// Finds the edits that change a choice, and leaves out the keys of the file that lose their effect
/// through them: comments out their lines, or removes them from an inline table. Keys that edits
/// set stay, for the checks to refuse. Returns empty if no choice is edited.
/// @param text text with the edits; changed if keys are left out
/// @param values the parsed `text`; changed with it
/// @param original the text without edits
/// @param set_edits the edits, "key=value" each
std::optional<EditedChoices> fit_to_edited_choices(CaseText& text, TomlText& values,
                                                   const std::string& original,
                                                   const std::vector<std::string>& set_edits);

} // namespace ionskin
