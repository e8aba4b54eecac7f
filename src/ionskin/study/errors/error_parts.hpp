// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/readout/signals.hpp"
#include "ionskin/study/errors/imposed_quantities.hpp"
#include "ionskin/study/errors/signal_difference.hpp"
#include "ionskin/study/errors/stated_errors.hpp"
#include "ionskin/study/metrics/read_out.hpp"

#include <string>
#include <vector>

namespace ionskin::study {

/// Names of the parts of a stated error.
namespace error_parts {
inline constexpr const char* mechanics_mesh = "mechanics_mesh";
inline constexpr const char* path = "path";
inline constexpr const char* handover = "handover";
inline constexpr const char* transport_grid = "transport_grid";
inline constexpr const char* time_steps = "time_steps";
inline constexpr const char* decoupling = "decoupling";   ///< of the strain from the water
inline constexpr const char* thin_layers = "thin_layers"; ///< of the ion model of that name
inline constexpr const char* rounding = "rounding";
} // namespace error_parts

/// Factor with which the differences of a part are multiplied, for a metric or a signal. For meshes
/// and time steps that is 0.8, twice what Richardson's extrapolation makes of a difference at the
/// order of 1.8 that `ionskin verify` asserts (E3): a grid convergence index with a factor of
/// safety of 2, between the 3 of two meshes and the 1.25 of three (Roache, Journal of Fluids
/// Engineering 116, 1994, doi 10.1115/1.2910291). It covers every order of convergence from 1.2 on.
/// What hangs on the edges of the contact converges in first order: there the mesh of the mechanics
/// counts 1, as do all other parts.
double safety(const std::string& part, const std::string& quantity);

/// Reason that a metric whose estimate is NaN or infinite has none.
inline constexpr const char* not_a_number = "its estimate is not a number";
/// Reason that a metric from few readings at the onset of sliding has no estimate: a coarser
/// solution may have fewer of them than it takes. No defect, and no warning.
inline constexpr const char* too_few_readings =
    "a coarser solution has too few readings of the onset for it";

/// Results at two degrees of one numerical choice, all else alike: what it leaves is their
/// difference.
struct ErrorPair {
  std::string part;
  const Signals* finer = nullptr;
  const Signals* coarser = nullptr;
};

/// Floors of the errors beside the pairs.
struct ErrorFloors {
  double path = 0; ///< of interpolation and residuals of the contact, relative [1]
  /// Error that the strain, which does not follow the water, leaves in signals that it makes,
  /// relative [1]; 0 under other laws.
  double decoupling = 0;
  /// Error that the limit of thin double layers leaves in charges, currents and voltages, relative
  /// [1]; 0 under other ion models.
  double thin_layers = 0;
  double charge = 0;          ///< error that rounding may leave in a charge [C]; 0 without currents
  double sample_interval = 0; ///< of the readout [s]
  std::vector<readout::Metric> cells; ///< least error of the mesh, by the name of a metric
  std::vector<bool> tail;             ///< rows of the sampled table outside the contact spikes
  ImposedErrors imposed;              ///< of what the case gives: they are all that is stated of it
};

/// Half the width of the band that one pair makes about the values of a column, per row; NaN where
/// there is no value.
/// @param path_floor least width of the part `path` over the value [1]
std::vector<double> pair_band(const std::vector<double>& values, const std::string& part,
                              const TableDifference& difference, const std::string& column,
                              double path_floor);

/// Sums the pairs up. A part of a metric is the largest of its own difference, that of its
/// neighbours and the norm of the difference of its signal over the run, so that a difference that
/// happens to vanish is not taken for none. What is not a number is not estimated.
ErrorEstimate combine_errors(const Signals& base, const std::vector<ErrorPair>& pairs,
                             const ErrorFloors& floors);

} // namespace ionskin::study
