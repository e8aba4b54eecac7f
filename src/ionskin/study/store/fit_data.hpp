// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/output/ion_solution.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace ionskin::study {

/// A measured signal over time.
struct FitData {
  std::string column;         ///< as in signals.csv: "current_difference"
  std::string unit;           ///< SI: "A"
  std::vector<double> time;   ///< [s], strictly ascending
  std::vector<double> values; ///< in `unit`
};

/// Columns that a fit can take, with their SI units.
const std::map<std::string, std::string>& fit_columns();

/// Reads a CSV file with units in its header, such as our own signals.csv and sampled.csv:
/// `time [s],current_difference [uA]`. Other columns are passed over, and so are rows without a
/// value, or that repeat the one before. What is read of spreadsheets and instruments tells
/// `CsvTable`.
/// @param column which one to take; may be empty when the file holds one that a fit can take
/// Throws UserError with the line when the file cannot be read, a column or a unit is missing or
/// unknown, an entry is not a number, or the time does not ascend.
FitData read_fit_data(const std::filesystem::path& path, const std::string& column = "");

/// True if the values are means over an interval.
bool is_current(const FitData& data);

/// Begin of the interval of each row of a current: at the row before. Of a record at one rate (four
/// in five intervals are alike) with rows missing, a row behind a gap stands for an interval of
/// that rate. The first interval is as long as the second, as far as the run has begun.
/// @param start of the run [s]
std::vector<double> interval_starts(const FitData& data, double start);

/// Drops the rows that a run from `start` on cannot answer: a current at or before its beginning.
/// Throws UserError when rows lie behind `end`, or none is left. [s]
void restrict_to_run(FitData& data, double start, double end);

/// Prediction of the data by a run: a charge or a voltage at the instants; a current as the charge
/// gained over the row's interval, divided by it, which is what both our tables hold. Before its
/// beginning and behind its end charges stay.
std::vector<double> predict(const FitData& data, const electrochemistry::IonSolution& ions);

} // namespace ionskin::study
