// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/study/fit/fit_model.hpp"

#include <string>
#include <vector>

namespace ionskin::study {

/// Explanation of the misfit by a shift, a baseline, a drift or a gain: those that were free, and
/// those that were not.
/// @param start, end the solutions at the start and at the optimum
/// @param point the optimum
std::vector<std::string> explain_misfit(const FitModel& model, const FitData& data,
                                        const electrochemistry::IonSolution& start,
                                        const electrochemistry::IonSolution& end,
                                        const std::vector<double>& point);

} // namespace ionskin::study
