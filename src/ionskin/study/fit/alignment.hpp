// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/output/ion_solution.hpp"
#include "ionskin/study/store/fit_data.hpp"

#include <vector>

namespace ionskin::study {

/// Shift of the clock of measured data, with the correlation of data and predicted signal that
/// results. Made by `best_alignment`.
struct Alignment {
  double time_shift = 0;  ///< delay of the data's clock [s]
  double correlation = 0; ///< Pearson's coefficient of data and signal, -1 to 1
};

/// Sign of the gain between signal and data: `kept` positive, or `free` to be negative, too.
enum class Sign { kept, free };

/// Finds the shift of the data's clock with which the data correlate best with the signal of a run,
/// among all shifts with which half of the shorter of data and run overlap. Searches on a grid of
/// 1/2048 of the longer of the two, on which both are averaged so that peaks of a single row are
/// not missed, then between the grid points.
/// @param ions solution from which the signal is predicted
/// @param sign `free`: a strong negative correlation counts as well as a positive one
Alignment best_alignment(const FitData& data, const electrochemistry::IonSolution& ions, Sign sign);

/// Standard deviation: root mean square about the mean, in the unit of the values.
double deviation(const std::vector<double>& values);

/// Pearson's correlation coefficient of two signals of one length, -1 to 1; 0 where one is
/// constant.
double correlation(const std::vector<double>& first, const std::vector<double>& second);

/// Result of `linear_fit`: gain [1], baseline [unit of the data], drift [unit of the data / s], and
/// the sum of squares of the residuals in `left`.
struct LinearFit {
  double gain = 0, baseline = 0, drift = 0, left = 0;
};

/// Fits data = gain * signal + baseline + drift * (t - first t) by linear least squares.
/// @param signal predicted signal, one value per row of the data
/// @param baseline, drift true if the term is fitted; otherwise it is 0
LinearFit linear_fit(const FitData& data, const std::vector<double>& signal, bool baseline,
                     bool drift);

} // namespace ionskin::study
