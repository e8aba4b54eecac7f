// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/electrochemistry/output/ion_solution.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace ionskin::study {

/// A measured signal over time.
struct FitData {
  std::string column; ///< as in signals.csv or taxels.csv: "current_difference", "voltage_left"
  std::string unit;   ///< SI: "A"
  std::vector<double> time;   ///< [s], strictly ascending
  std::vector<double> values; ///< in `unit`
  bool at_one_rate = false;   ///< as `is_at_one_rate` finds it
};

/// Columns that a fit of a case can take, with their SI units: those of the electrodes, and of each
/// taxel those that taxels.csv has of it.
using FitColumns = std::map<std::string, std::string>;
FitColumns fit_columns(const Case& input);

/// The taxel that a column is of; empty for one of the whole electrodes.
std::string taxel_of(const std::string& column);

/// Reads a CSV file with units in its header, such as our own signals.csv and sampled.csv:
/// `time [s],current_difference [uA]`. Other columns are passed over, and so are rows without a
/// value, or that repeat the one before. What is read of spreadsheets and instruments tells
/// `CsvTable`.
/// @param known columns that the case can be compared with
/// @param column which one to take; may be empty when the file holds one that is known
/// Throws UserError with the line when the file cannot be read, a column or a unit is missing or
/// unknown, an entry is not a number, or the time does not ascend.
FitData read_fit_data(const std::filesystem::path& path, const FitColumns& known,
                      const std::string& column = "");

/// True if four in five intervals between the rows are alike.
bool is_at_one_rate(const FitData& data);

/// True if nothing comes before and after the run.
bool is_current(const FitData& data);

/// True if the values are means over an interval, as an instrument reads them: currents, and
/// voltages at one rate.
bool is_mean(const FitData& data);

/// Begin of the interval of each row of a current: at the row before. Of a record at one rate
/// (four in five intervals are alike) with rows missing, a row behind a gap stands for an interval
/// of that rate. The first interval is as long as the second, as far as the run has begun.
/// @param start of the run [s]
std::vector<double> interval_starts(const FitData& data, double start);

/// Drops the rows that a run from `start` on cannot answer: a current at or before its beginning.
/// Throws UserError when rows lie behind `end`, or none is left. [s]
void restrict_to_run(FitData& data, double start, double end);

/// Values of a run at the rows of the data, as our tables hold them: a charge at the instants; a
/// current as the charge gained over the row's interval, divided by it; a voltage at one rate as
/// its mean over that interval, else at the instants. Before its beginning and behind its end
/// charges stay. Between steps those of taxels are linear.
std::vector<double> predict(const FitData& data, const electrochemistry::IonSolution& ions);

} // namespace ionskin::study
