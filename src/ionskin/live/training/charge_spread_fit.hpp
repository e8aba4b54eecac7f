// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/skin_data.hpp"
#include "ionskin/live/training/charge_fit.hpp"
#include "ionskin/live/training/full_run.hpp"

#include <vector>

namespace ionskin::live {

/// Every cosine wave over the columns of the ion grid with the rate at which it relaxes, docs/
/// model.md (34): (D/lambda) alpha tanh(alpha h/2), where alpha is that of the columns' second
/// differences. No weights.
SpreadMap all_waves(const FullRun& run);

/// Records of the charge that some waves bring into each taxel, in the records of the taxels of the
/// same run.
void record_spread(const FullRun& run, const SpreadMap& map, std::vector<ChargeRecord>& records);

/// Square of the charge that each wave brings into the taxels, over the time and all of them [C2
/// s].
std::vector<double> wave_energies(const FullRun& run, const SpreadMap& map);

/// Records of all runs, one after the other.
std::vector<ChargeRecord> joined(const std::vector<std::vector<ChargeRecord>>& of_runs);

/// The waves that spread into the taxels, without weights, and what they bring, into the records.
/// None where rows that were not fitted are met to 1 % of the largest charge without them, or where
/// they do not lower that error by a tenth; else the fewest without which all others would miss a
/// thousandth of the charges.
/// @param records of the taxels of each run
SpreadMap find_spread(const std::vector<FullRun>& runs,
                      std::vector<std::vector<ChargeRecord>>& records, std::size_t inputs,
                      const std::vector<double>& rates);

} // namespace ionskin::live
