// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/data/skin_data.hpp"
#include "ionskin/live/training/charge_fit.hpp"
#include "ionskin/live/training/full_run.hpp"

#include <vector>

namespace ionskin::live {

/// All cosine waves over the columns of the ion grid, except the mean, each with its relaxation
/// rate, docs/model.md (34): (D/lambda) alpha tanh(alpha h/2), where alpha is the wave number of
/// the second differences between columns. The weights are empty.
SpreadMap all_waves(const FullRun& run);

/// Fills `spread` of the records: the states of the given waves, summed over each taxel.
/// @param run of the full model
/// @param records of the taxels of this run
void record_spread(const FullRun& run, const SpreadMap& map, std::vector<ChargeRecord>& records);

/// Time integral of the square of the charge that each wave brings into the taxels, summed over the
/// taxels [wave] [C2 s].
/// @param map waves with weights
std::vector<double> wave_energies(const FullRun& run, const SpreadMap& map);

/// Concatenates the records of several runs.
std::vector<ChargeRecord> joined(const std::vector<std::vector<ChargeRecord>>& of_runs);

/// Chooses the waves of spreading charge that the taxels need, and fills `spread` of the records
/// with their states. Chooses none where the fit without waves meets the rows it did not see to 1 %
/// of the largest charge, or where waves do not lower that error by a tenth; otherwise the fewest
/// waves such that all others together contribute less than a thousandth of the charges.
/// @param records of the taxels of each run
/// @param inputs number of inputs of a record
/// @param rates of the first-order states [1/s]
/// @returns waves without weights
SpreadMap find_spread(const std::vector<FullRun>& runs,
                      std::vector<std::vector<ChargeRecord>>& records, std::size_t inputs,
                      const std::vector<double>& rates);

} // namespace ionskin::live
