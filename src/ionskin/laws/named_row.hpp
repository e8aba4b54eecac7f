// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/error.hpp"

#include <algorithm>
#include <span>
#include <string>
#include <string_view>

namespace ionskin::laws {

/// Finds the row of a table by its member `name`. Throws InternalError when there is none, since
/// the schema has already checked the name.
/// @param kind what the rows are, for the message, such as "circuit"
template <class Row>
const Row& named_row(std::span<const Row> rows, std::string_view name, std::string_view kind) {
  const auto found = std::ranges::find(rows, name, &Row::name);
  if (found == rows.end()) {
    throw InternalError("no " + std::string(kind) + " is named " + std::string(name));
  }
  return *found;
}

} // namespace ionskin::laws
