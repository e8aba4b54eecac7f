// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/skin_data.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::live {

/// One region's charges in a run of the full model, and the inputs that drove them.
struct ChargeRecord {
  std::vector<double> time;                  ///< [rows]
  std::vector<double> drive;                 ///< [row][input]
  std::array<std::vector<double>, 2> charge; ///< top, bottom [row] [C]
  /// Drive that spreads into the region from beside it [row][level]; empty where nothing does.
  std::vector<double> spread;
};

/// Rates, of some candidates, with which the charges of the records are met best, one after the
/// other [1/s]: fitted to the first two thirds of the rows, and as many more than the least as
/// lower the error on the other third by a tenth each.
std::vector<double> choose_rates(const std::vector<ChargeRecord>& records, std::size_t inputs,
                                 const std::vector<double>& candidates, std::size_t least,
                                 std::size_t most);

struct ChargeFit {
  ChargeModel model;
  std::vector<double> spread; ///< weight of what spreads, alike for both charges [level]
};

/// Least squares over all rows of all records, weighted with the time between them.
ChargeFit fit_charges(const std::vector<ChargeRecord>& records, std::size_t inputs,
                      const std::vector<double>& rates);

/// Rms that a fit to the first two thirds of the rows leaves of the others, over that of the
/// charges [1].
double unseen_error(const std::vector<ChargeRecord>& records, std::size_t inputs,
                    const std::vector<double>& rates);

} // namespace ionskin::live
