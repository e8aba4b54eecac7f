// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/output/ion_solution.hpp"
#include "ionskin/study/store/fit_data.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace ionskin::study {

/// Departure of the record of an instrument from the signal of a run: measured(t) = gain * signal(t
/// - time_shift) + baseline + drift * (t - first t).
struct DataAdjustment {
  double time_shift = 0; ///< delay of the record's clock [s]
  double baseline = 0;   ///< [unit of the data]
  double drift = 0;      ///< [unit of the data / s]
  double gain = 1;       ///< negative where the electrodes are swapped [1]

  double& of(std::string_view key);
};

/// "data.time_shift" and so on: the keys of the record that a fit may free beside those of a case.
const std::vector<std::string>& data_keys();
bool is_data_key(std::string_view key);
/// Unit of such a key for data in `unit`.
std::string data_key_unit(std::string_view key, const std::string& unit);

/// Record that a run would leave, one entry per row. Before its beginning the run rests, and behind
/// its end its charges stay.
std::vector<double> predict(const FitData& data, const electrochemistry::IonSolution& ions,
                            const DataAdjustment& adjustment);

/// Record that a run would leave, one entry per row, on a clock that is late by `time_shift` [s]
/// and without any other departure.
std::vector<double> predict_shifted(const FitData& data, const electrochemistry::IonSolution& ions,
                                    double time_shift);

/// The data with a clock that is right.
FitData without_shift(FitData data, double time_shift);

} // namespace ionskin::study
