// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/study/fit/fit_model.hpp"

#include <string>
#include <vector>

namespace ionskin::study {

/// Checks that the data contain a signal.
/// Throws UserError where all values are 0, or are one and the same.
void require_signal(const FitData& data);

/// Initial values of the free keys of the data (`data_keys`): the time shift with which the data
/// correlate best with the signal of the start, then gain, baseline and drift by linear least
/// squares. Keys that are not free have no effect (gain 1, others 0).
/// @param start solution at the initial values of the case
DataAdjustment start_adjustment(const FitModel& model, const FitData& data,
                                const electrochemistry::IonSolution& start);

/// Compares the data with the signal of the start before any search: their sizes, their sign, a
/// time shift, and whether they correlate at all.
/// @param start solution at the initial values of the case
/// @param adjustment initial values of the keys of the data
/// @returns warnings, one sentence each
/// Throws UserError where no search can succeed: the start gives no signal, the sizes differ too
/// much, or the data correlate with the negative of the signal, or with the signal only when
/// shifted in time.
std::vector<std::string> compare_with_start(const FitModel& model, const FitData& data,
                                            const electrochemistry::IonSolution& start,
                                            const DataAdjustment& adjustment);

} // namespace ionskin::study
