// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/study/fit/fit_model.hpp"

#include <string>
#include <vector>

namespace ionskin::study {

/// Explains what is left of the misfit after a fit: free keys of the data that explain most of it,
/// a time shift, baseline or drift that were not free but would, a saturated instrument, or
/// outliers.
/// @param start, end solutions at the start and at the optimum
/// @param point values of the parameters at the optimum [SI]
/// @returns sentences for the user; may be empty
std::vector<std::string> explain_misfit(const FitModel& model, const FitData& data,
                                        const electrochemistry::IonSolution& start,
                                        const electrochemistry::IonSolution& end,
                                        const std::vector<double>& point);

} // namespace ionskin::study
