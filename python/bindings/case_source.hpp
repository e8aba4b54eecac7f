// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

namespace ionskin::python {

/// A case as the package keeps it: the text, the path that names it, and the edits in their order.
struct CaseSource {
  std::string text, path;
  std::vector<std::string> edits;
};

/// Source of an `ionskin.Case`.
CaseSource case_source(const pybind11::handle& python_case);

/// FitModel and fit_folder.
void add_fit_bindings(pybind11::module_& module);

/// key_quantity.
void add_key_bindings(pybind11::module_& module);

/// Tables of numbers from elsewhere, and units.
void add_table_bindings(pybind11::module_& module);

} // namespace ionskin::python
