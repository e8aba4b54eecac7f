// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/output/ion_solution.hpp"
#include "ionskin/results/output_folder.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace ionskin::study {

/// Answer of the model at one point of the search: the part of the ion solution from which every
/// column of data is predicted (time, charges, voltage, and one taxel where the data are from it),
/// or the reason why there is no solution.
struct FitAnswer {
  /// Reduced solution; null when there is none.
  std::shared_ptr<const electrochemistry::IonSolution> ions;
  std::string failure; ///< empty when there is a solution
};

/// Reduces a solution to the part that a `FitAnswer` holds.
/// @param taxel name of the taxel that the data are from; empty for none
FitAnswer fit_answer(const electrochemistry::IonSolution& ions, const std::string& taxel = "");

/// Finished evaluations of a fit, each in a file of its own in the output folder, so that an
/// interrupted fit can be resumed. A fit is deterministic: it repeats the same search and finds the
/// stored evaluations instead of solving them. Thread-safe.
class FitLog {
public:
  /// Reads the evaluations that this build of the program left in the subfolder `evaluations`.
  /// @param folder must outlive this object
  explicit FitLog(results::OutputFolder& folder);

  /// Evaluation at a point; empty if it is not in the log.
  /// @param point values of the free keys of the case [SI]
  std::optional<FitAnswer> find(const std::vector<double>& point) const;
  /// Adds an evaluation and writes its file.
  /// @param point values of the free keys of the case [SI]
  void add(const std::vector<double>& point, const FitAnswer& answer);
  /// Number of evaluations read from an earlier fit.
  std::size_t taken_up() const { return taken_up_; }
  /// Removes the files of all evaluations and their subfolder, once the fit is finished.
  void remove();

private:
  void take_up(const std::filesystem::path& path);

  results::OutputFolder& folder_;
  mutable std::mutex mutex_;
  std::map<std::vector<double>, FitAnswer> answers_;
  std::size_t taken_up_ = 0;
};

} // namespace ionskin::study
