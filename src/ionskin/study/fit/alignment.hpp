// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/output/ion_solution.hpp"
#include "ionskin/study/store/fit_data.hpp"

#include <vector>

namespace ionskin::study {

/// A shift of the data's clock, and how well the signal of a run follows the data with it.
struct Alignment {
  double time_shift = 0;  ///< [s]
  double correlation = 0; ///< of data and signal, -1 to 1
};

/// Sign of the gain: whether it may turn the signal.
enum class Sign { kept, free };

/// The shift, among all with which half of the shorter of data and run overlap, that lets the data
/// correlate best with the signal. It is sought in steps of 1/2048 of the longer of the two, with
/// means over the cells between them, so that peaks of a single row are found; then between steps.
Alignment best_alignment(const FitData& data, const electrochemistry::IonSolution& ions, Sign sign);

/// Root mean square about the mean.
double deviation(const std::vector<double>& values);

/// Correlation of two signals of one length; 0 where one is constant.
double correlation(const std::vector<double>& first, const std::vector<double>& second);

/// A straight line through data: value of the signals' factor, baseline and drift, and the sum of
/// squares that they leave.
struct LinearFit {
  double gain = 0, baseline = 0, drift = 0, left = 0;
};

/// data = gain * signal (+ baseline (+ drift * (t - first t))) by linear least squares.
LinearFit linear_fit(const FitData& data, const std::vector<double>& signal, bool baseline,
                     bool drift);

} // namespace ionskin::study
