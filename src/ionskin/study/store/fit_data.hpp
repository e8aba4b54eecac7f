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
/// unknown, an entry is no number, or the time does not ascend.
FitData read_fit_data(const std::filesystem::path& path, const std::string& column = "");

/// Drops the rows that a run from `start` on cannot answer: a current at or before its beginning.
/// Throws UserError when rows lie behind `end`, or none is left. [s]
void restrict_to_run(FitData& data, double start, double end);

/// What a run says to the data: a charge or a voltage at the instants; a current as the charge
/// gained since the row before, divided by the time, which is what both our tables hold. The first
/// row's interval is as long as the second's, as far as the run has begun.
std::vector<double> predict(const FitData& data, const electrochemistry::IonSolution& ions);

} // namespace ionskin::study
