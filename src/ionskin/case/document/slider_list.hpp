// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"
#include "ionskin/case/text/toml_text.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace ionskin {

/// Counts the entries of a list [[slider]]; 0 if the case has no such list, but one table [slider]
/// or none. Throws UserError when the list is empty, has more than `most_sliders` entries, or
/// entries that are not tables.
std::size_t listed_sliders(const TomlText& values);

/// Makes the values of a case with only one slider of the list: its entry becomes the table
/// [slider], and the keys of its own tables `motion` and `contact` override those of the case.
/// @param values a case with a list [[slider]]
/// @param slider index of the entry, from 0
TomlText with_slider(const TomlText& values, std::size_t slider);

/// Converts a key of the case that `with_slider` makes to its name in the user's text:
/// "slider.shape" to "slider[1].shape", and "motion.file" to "slider[1].motion.file" if the entry
/// has that key. Returns the key unchanged in a case without a list.
/// @param slider index of the entry, from 0
std::string listed_key(const TomlText& values, std::size_t slider, const std::string& key);

/// Joins the cases of single sliders to one case with all sliders. Records of keys in an entry of
/// the list get the names of the user's text, "slider[1].shape".
/// @param values the case with the list [[slider]]
/// @param documents one for each slider, read from the values that `with_slider` makes
/// Throws UserError when the sliders cannot be combined: different durations or numbers of cycles,
/// a drive, or adhesion.
CaseDocument joined_sliders(const TomlText& values, std::vector<CaseDocument> documents);

} // namespace ionskin
