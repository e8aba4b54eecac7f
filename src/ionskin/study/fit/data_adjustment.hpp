// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/output/ion_solution.hpp"
#include "ionskin/study/store/fit_data.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace ionskin::study {

/// Properties of an instrument's record that make it depart from the signal of a run: measured(t) =
/// gain * signal(t - time_shift) + baseline + drift * (t - first t), where first t is the first
/// row.
struct DataAdjustment {
  double time_shift = 0; ///< delay of the record's clock [s]
  double baseline = 0;   ///< [unit of the data]
  double drift = 0;      ///< [unit of the data / s]
  double gain = 1;       ///< negative where the electrodes are swapped [1]

  /// Member for a key of `data_keys`.
  double& of(std::string_view key);
};

/// Names of the four properties of the record that a fit may free beside the keys of a case:
/// "data.time_shift", "data.baseline", "data.drift" and "data.gain".
const std::vector<std::string>& data_keys();
/// True if a key is one of `data_keys`.
bool is_data_key(std::string_view key);
/// Unit of a key of `data_keys`.
/// @param unit of the data
std::string data_key_unit(std::string_view key, const std::string& unit);

/// Predicts the record of an instrument from a solution, one value per row of the data, in the unit
/// of the data. Before its start the run is at rest, and after its end charges stay constant.
/// @param adjustment clock, gain, baseline and drift of the record
std::vector<double> predict(const FitData& data, const electrochemistry::IonSolution& ions,
                            const DataAdjustment& adjustment);

/// Predicts the record of an instrument whose clock is late by `time_shift` [s] and that departs
/// from the signal in no other way; one value per row of the data.
std::vector<double> predict_shifted(const FitData& data, const electrochemistry::IonSolution& ions,
                                    double time_shift);

/// Copy of the data with `time_shift` [s] subtracted from all times.
FitData without_shift(FitData data, double time_shift);

} // namespace ionskin::study
