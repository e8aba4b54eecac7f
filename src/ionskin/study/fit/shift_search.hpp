// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/output/ion_solution.hpp"
#include "ionskin/study/store/fit_data.hpp"

#include <functional>
#include <vector>

namespace ionskin::study {

/// Shifts of the data's clock [s], ascending, that a search for the best one compares: an even
/// grid, the shifts at which an abrupt change of the signal passes from one row of the data to the
/// next, and the middle between each two of these. A current spike of microseconds puts its whole
/// charge into one row. The agreement of data and signal then jumps at these shifts, and the range
/// of shifts that puts two spikes into the right rows may be a thousandth of a row wide.
/// @param ions solution from which the signal is predicted
/// @param about, reach middle and half width of the range that is searched [s]
std::vector<double> shifts_to_compare(const FitData& data,
                                      const electrochemistry::IonSolution& ions, double about,
                                      double reach);

/// Shift at which a function is least, and its value there.
struct LeastOfShifts {
  double time_shift = 0; ///< [s]
  double value = 0;      ///< of the function, in its unit
};

/// Finds the least value of a function over given shifts, and between the two neighbours of the
/// best one.
/// @param shifts ascending, at least one [s]
LeastOfShifts least_of_shifts(const std::vector<double>& shifts,
                              const std::function<double(double time_shift)>& function);

} // namespace ionskin::study
