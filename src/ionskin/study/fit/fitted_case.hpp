// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/study/fit/fit_model.hpp"

#include <string>
#include <vector>

namespace ionskin::study {

/// The text of the case at fitted values, which names at its head the fitted keys and the data. A
/// comment behind a fitted value, or in the lines right above it, tells of the value that stood
/// there: it is left out.
/// @param values one per parameter [SI]
/// @param data name of the data that were fitted
std::string fitted_case_text(const FitModel& model, const std::vector<double>& values,
                             const std::string& data);

} // namespace ionskin::study
