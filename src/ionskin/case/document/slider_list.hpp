// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/document/case_document.hpp"
#include "ionskin/case/text/toml_text.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace ionskin {

/// Number of entries of a list [[slider]]; 0 where a case writes its only slider as [slider].
/// Throws UserError for an empty list, and for one of too many sliders.
std::size_t listed_sliders(const TomlText& values);

/// Values of a case in which one slider of the list is alone: its entry stands as [slider], without
/// the tables `motion` and `contact` in it, whose keys stand in those of the case.
TomlText with_slider(const TomlText& values, std::size_t slider);

/// Name in the text of a key of a case of one slider, "slider[1].shape" of "slider.shape" and
/// "slider[1].motion.file" of a "motion.file" that stands in the entry; the same key where no list
/// is.
std::string listed_key(const TomlText& values, std::size_t slider, const std::string& key);

/// The case of all sliders. The keys in the entry of a slider are named by it, "slider[1].shape".
/// @param values those with the list
/// @param documents one for each slider, as `with_slider` makes its values
/// Throws UserError where the sliders do not go together.
CaseDocument joined_sliders(const TomlText& values, std::vector<CaseDocument> documents);

} // namespace ionskin
