// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/data/skin_data.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::live {

/// Training data of the charges of one region (the whole electrode, or a taxel) in a run of the
/// full model, with the inputs that drive them.
struct ChargeRecord {
  std::vector<double> time;  ///< [row] [s]
  std::vector<double> drive; ///< inputs as in `ChargeModel` [row][input] [m2]
  /// Charges of the top and the bottom electrode over the region [row] [C].
  std::array<std::vector<double>, 2> charge;
  /// States of the waves of spreading charge, summed over the region, per unit weight of each z
  /// level [row][level] [m2]; empty if no charge spreads.
  std::vector<double> spread;
};

/// Records that one charge model fits: of the whole electrode in all runs, or of all taxels.
struct ChargeGroup {
  std::vector<ChargeRecord> records;
  std::size_t inputs = 0; ///< number of inputs of a record
};

/// Chooses the rates of the first-order states from some candidates, one after the other, each so
/// that the charges of all groups are fitted best [1/s]. Each group counts by its error over the
/// size of its own charges: the charge of the electrode may be a small remainder of those of the
/// taxels. The fit uses the first two thirds of the rows; beyond `least` rates, more are taken as
/// long as each lowers the error on the last third by a tenth.
/// @param candidates [1/s]
/// @param least, most numbers of rates
/// @returns ascending rates
std::vector<double> choose_rates(const std::vector<ChargeGroup>& groups,
                                 const std::vector<double>& candidates, std::size_t least,
                                 std::size_t most);

/// Fitted charge model of a region.
struct ChargeFit {
  ChargeModel model;
  /// Weights of the spreading charge, the same for top and bottom [level] [C/m2]; empty if no
  /// charge spreads.
  std::vector<double> spread;
};

/// Fits a charge model by least squares over all rows of all records, weighted with the time
/// between the rows.
/// @param inputs number of inputs of a record
/// @param rates of the first-order states [1/s]
ChargeFit fit_charges(const std::vector<ChargeRecord>& records, std::size_t inputs,
                      const std::vector<double>& rates);

/// Rms error on the last third of the rows of a fit to the first two thirds, over the rms of the
/// charges there [1].
double unseen_error(const std::vector<ChargeRecord>& records, std::size_t inputs,
                    const std::vector<double>& rates);

} // namespace ionskin::live
