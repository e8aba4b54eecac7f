// SPDX-License-Identifier: Apache-2.0
#include "case_source.hpp"

#include "ionskin/base/text.hpp"
#include "ionskin/case/text/number_table.hpp"
#include "ionskin/units/unit_system.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

namespace ionskin::python {
namespace {

namespace py = pybind11;

/// One tuple per column: its name, its unit or None, its first value, the array of distances from
/// it or None where it holds no numbers, and the first cell of text with its line.
py::list number_table(const std::string& path, const std::string& kind) {
  py::list result;
  for (const NumberColumn& column : read_number_table(path, kind)) {
    const py::object values =
        column.numbers
            ? py::object(py::array_t<double>(static_cast<py::ssize_t>(column.since_first.size()),
                                             column.since_first.data()))
            : py::object(py::none());
    result.append(py::make_tuple(column.title.name, column.title.unit, column.first, values,
                                 base::shown(column.text), column.text_line));
  }
  return result;
}

} // namespace

void add_table_bindings(py::module_& module) {
  module.def("number_table", &number_table);
  module.def("convert_unit", &units::convert_unit);
}

} // namespace ionskin::python
