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

/// Names of the parts of a reported error, each from one numerical choice;
/// docs/errors-of-results.md defines them.
namespace error_parts {
inline constexpr const char* mechanics_mesh =
    "mechanics_mesh";                               ///< contact cells and elements of Study 1
inline constexpr const char* path = "path";         ///< load steps of Study 1
inline constexpr const char* handover = "handover"; ///< cells of the strain history
inline constexpr const char* transport_grid = "transport_grid"; ///< grid of Study 2
inline constexpr const char* time_steps = "time_steps";         ///< time steps of Study 2
/// Strain that does not respond to the water.
inline constexpr const char* decoupling = "decoupling";
inline constexpr const char* thin_layers = "thin_layers"; ///< limit of thin double layers
inline constexpr const char* rounding = "rounding";       ///< rounding of charges
} // namespace error_parts

/// Factor by which the differences of two solutions are multiplied in one part of an error, for a
/// metric or a signal [1]. For meshes and time steps it is 0.8, twice what Richardson's
/// extrapolation makes of a difference at the order of 1.8 that `ionskin verify` asserts (E3): a
/// grid convergence index with a factor of safety of 2, between the 3 of two meshes and the 1.25 of
/// three (Roache, Journal of Fluids Engineering 116, 1994, doi 10.1115/1.2910291). It covers every
/// order of convergence from 1.2 on. It is 1 for quantities made at the edges of the contact, which
/// converge in first order with the mesh of the mechanics (`hangs_on_edges`), and for all other
/// parts.
/// @param part one of `error_parts`
/// @param quantity name of the metric or signal
double safety(const std::string& part, const std::string& quantity);

/// Reason given for a metric without an error because its estimate is NaN or infinite.
inline constexpr const char* not_a_number = "its estimate is not a number";
/// Reason given for a metric without an error that is made from few readings at the onset of
/// sliding: a coarser solution may have fewer readings than it takes. This is no defect, and gives
/// no warning.
inline constexpr const char* too_few_readings =
    "a coarser solution has too few readings of the onset for it";

/// Results of two solutions that differ only in the fineness of one numerical choice, whose error
/// is estimated from their difference.
struct ErrorPair {
  std::string part; ///< one of `error_parts`
  const Signals* finer = nullptr;
  const Signals* coarser = nullptr;
};

/// Lower bounds and additional parts of the errors that do not come from pairs of solutions.
struct ErrorFloors {
  /// Least error of the part `path`, from the residuals of the contact, relative [1].
  double path = 0;
  /// Part `decoupling`: relative error of signals that water makes, as the strain does not respond
  /// to the water [1]; 0 under laws that move no water.
  double decoupling = 0;
  /// Part `thin_layers`: relative error of charges, currents and voltages by the limit of thin
  /// double layers [1]; 0 under other ion models.
  double thin_layers = 0;
  double charge = 0;          ///< error that rounding may leave in a charge [C]; 0 without currents
  double sample_interval = 0; ///< readout interval [s]
  /// Least errors of the part `mechanics_mesh`, by the name of a metric and in its unit.
  std::vector<readout::Metric> cells;
  /// True for each row of the sampled table outside the spikes of current at contact events.
  std::vector<bool> tail;
  ImposedErrors imposed; ///< errors of quantities that the case prescribes; they replace all parts
};

/// Relative error of a signal by its parts `decoupling` and `thin_layers` [1].
double relative_floor(const ErrorFloors& floors, const std::string& name, const std::string& unit);

/// Error of one column of a table from one pair of solutions: half the width of the error band
/// about each value, one entry per row [unit of the column]; NaN where there is no value.
/// @param values of the run
/// @param part one of `error_parts`
/// @param difference of the two solutions of the pair, on the same rows
/// @param column name of the signal
/// @param path_floor least width of the part `path`, relative to the value [1]
std::vector<double> pair_band(const std::vector<double>& values, const std::string& part,
                              const TableDifference& difference, const std::string& column,
                              double path_floor);

/// Combines pairs of solutions into the error estimate of all metrics and signals. The error of a
/// metric is the sum of its parts. Each part is the largest of the metric's own difference, the
/// relative differences of related metrics (`related_metrics`), and the relative norm over the run
/// of the difference of related signals, so that a difference that vanishes by chance does not pass
/// for no error. Metrics whose estimate is not a number get a reason instead.
/// @param base signals and metrics of the run itself
ErrorEstimate combine_errors(const Signals& base, const std::vector<ErrorPair>& pairs,
                             const ErrorFloors& floors);

} // namespace ionskin::study
