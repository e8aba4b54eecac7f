// SPDX-License-Identifier: Apache-2.0
#include "case_source.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/case/schema/schema.hpp"
#include "ionskin/units/quantity.hpp"

#include <pybind11/stl.h>

namespace ionskin::python {
namespace {

namespace py = pybind11;

/// SI value and SI unit of a text that the key could hold, whatever its range; "1" for pure
/// numbers.
py::tuple key_quantity(const std::string& key, const std::string& text) {
  const auto entry = list_entry(key);
  const SchemaRow* row = find_row(key_pattern(entry ? entry->list : key));
  if (row == nullptr || row->type == ValueType::text || row->type == ValueType::choice ||
      row->type == ValueType::integer || (is_list(row->type) && !entry)) {
    throw UserError(key +
                    " is not a single real number of a case\n  = ionskin keys lists every key");
  }
  const auto read = [&text](units::Dimension dimension) {
    return py::make_tuple(units::parse_quantity(text, dimension),
                          units::dimension_info(dimension).si_unit);
  };
  try {
    return read(row->dimension);
  } catch (const UserError&) {
    if (!row->other_dimension) {
      throw;
    }
    try {
      return read(*row->other_dimension);
    } catch (const UserError&) {
    }
    throw;
  }
}

} // namespace

void add_key_bindings(py::module_& module) {
  module.def("key_quantity", &key_quantity);
}

} // namespace ionskin::python
