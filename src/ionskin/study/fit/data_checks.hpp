// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/study/fit/fit_model.hpp"

#include <string>
#include <vector>

namespace ionskin::study {

/// Throws UserError where all values of the data are 0, or one and the same.
void require_signal(const FitData& data);

/// Start of the free keys of the data: the shift with which the data correlate best with the signal
/// of the start, and gain, baseline and drift by linear least squares there.
DataAdjustment start_adjustment(const FitModel& model, const FitData& data,
                                const electrochemistry::IonSolution& start);

/// Comparison of data and start before any search: their sizes, a shift, clipped rows, and whether
/// there is a likeness at all. Throws UserError where no search can succeed: the start gives no
/// signal, the data correlate with minus the model, or they do with the model only when shifted.
std::vector<std::string> compare_with_start(const FitModel& model, const FitData& data,
                                            const electrochemistry::IonSolution& start,
                                            const DataAdjustment& adjustment);

} // namespace ionskin::study
