// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <span>
#include <string>
#include <string_view>

namespace ionskin::apps {

/// Publication of a method that ionskin uses, as an entry of BibTeX.
struct Reference {
  std::string_view key;     ///< key of the BibTeX entry
  std::string_view purpose; ///< purpose for which ionskin uses the method, in words
  std::string_view type;    ///< type of the BibTeX entry: "article" or "book"
  std::string_view author;
  std::string_view title;
  std::string_view place; ///< further BibTeX fields, such as "journal = {...}, volume = {1}"
  int year;
  std::string_view doi;
  bool (*used)(const Case&); ///< true if the case uses the method
  /// Words on the fields that no second source confirmed, printed above the entry; empty for none.
  std::string_view unconfirmed = "";
};

/// All publications of methods that ionskin uses.
std::span<const Reference> references();

/// BibTeX text of a publication, below a comment that says what ionskin uses it for.
std::string bibtex(const Reference& reference);

} // namespace ionskin::apps
