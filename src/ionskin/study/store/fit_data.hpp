// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/electrochemistry/output/ion_solution.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace ionskin::study {

/// A measured signal over time, read from a file by `read_fit_data`.
struct FitData {
  /// Name of the signal, as in signals.csv or taxels.csv: "current_difference", "voltage_left".
  std::string column;
  std::string unit; ///< SI unit of `values`, such as "A"
  /// Instants [s], strictly ascending; for means, the ends of their intervals.
  std::vector<double> time;
  std::vector<double> values; ///< in `unit`
  bool at_one_rate = false;   ///< result of `is_at_one_rate` for the rows as read
};

/// Names of the signals that measured data of a case can be compared with, each with its SI unit.
using FitColumns = std::map<std::string, std::string>;
/// Signals of a case that a fit can use: those of the electrodes, and for each taxel or line of a
/// crossbar those in taxels.csv.
FitColumns fit_columns(const Case& input);

/// Name of the taxel, or of the line of a crossbar, that a column belongs to; empty for a signal of
/// the whole electrodes.
std::string taxel_of(const std::string& column);

/// Reads the time and one signal from a CSV file with units in its header, such as our own
/// signals.csv and sampled.csv: `time [s],current_difference [uA]`. Other columns are ignored, and
/// so are rows without a value and rows that repeat the one before. `CsvTable` describes which
/// variants of CSV are understood.
/// @param known columns that the case can be compared with, see `fit_columns`
/// @param column name of the signal to read; may be empty when the file holds only one that is
/// known
/// Throws UserError with the line when the file cannot be read, a column or a unit is missing or
/// unknown, an entry is not a number, or the time does not ascend.
FitData read_fit_data(const std::filesystem::path& path, const FitColumns& known,
                      const std::string& column = "");

/// True if the rows are equally spaced in time: four in five of the intervals agree within 30 %
/// with their median.
bool is_at_one_rate(const FitData& data);

/// True if the signal is a current, which is 0 before and after the run.
bool is_current(const FitData& data);

/// True if each value is a mean over the interval that ends at its row, as an integrating
/// instrument reads it: currents, and voltages at one rate. Other values hold at the instant of
/// their row.
bool is_mean(const FitData& data);

/// Start of the interval of each row of averaged data [s]: as a rule the row before. In a record at
/// one rate, a row behind a gap stands for one interval of that rate, so that rows may be missing.
/// The first interval is as long as the second, but is cut at the start of the run.
/// @param start of the run [s]
std::vector<double> interval_starts(const FitData& data, double start);

/// Removes the rows at the beginning that a run cannot predict: instants before the run, and means
/// that end at its start.
/// @param start, end of the run [s]
/// Throws UserError when rows lie behind `end`, or no row is left.
void restrict_to_run(FitData& data, double start, double end);

/// Predicts the measured signal from a solution, one value per row of the data, in the unit of the
/// data. A charge, or a voltage that is not at one rate, is taken at the instant of the row; a
/// current is the charge gained over the row's interval divided by the interval; a voltage at one
/// rate is the mean over the interval. Before and after the run, charges stay constant. Between
/// time steps, signals of taxels are interpolated
/// linearly.
std::vector<double> predict(const FitData& data, const electrochemistry::IonSolution& ions);

} // namespace ionskin::study
