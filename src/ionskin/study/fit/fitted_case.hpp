// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/study/fit/fit_model.hpp"

#include <string>
#include <vector>

namespace ionskin::study {

/// Text of the case at fitted values, in TOML, with a first line that names the fitted keys and the
/// data. Comments behind a fitted value and in the lines directly above are left out, as they are
/// about the former value.
/// @param values one per parameter [SI]
/// @param data name of the data that were fitted
std::string fitted_case_text(const FitModel& model, const std::vector<double>& values,
                             const std::string& data);

} // namespace ionskin::study
