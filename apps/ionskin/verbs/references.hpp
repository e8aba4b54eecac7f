// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <span>
#include <string>
#include <string_view>

namespace ionskin::apps {

/// A publication of a method, and the cases that use the method.
struct Reference {
  std::string_view key;     ///< of BibTeX
  std::string_view purpose; ///< use of the method
  std::string_view type;    ///< of BibTeX: "article" or "book"
  std::string_view author;
  std::string_view title;
  std::string_view place; ///< further fields as BibTeX has them: "journal = {...}, volume = {1}"
  int year;
  std::string_view doi;
  bool (*used)(const Case&);
  /// Fields that no second source confirmed, in words; shown above the entry.
  std::string_view unconfirmed = "";
};

/// Publications of all methods.
std::span<const Reference> references();

/// The entry of BibTeX, below a comment that says what it is used for.
std::string bibtex(const Reference& reference);

} // namespace ionskin::apps
