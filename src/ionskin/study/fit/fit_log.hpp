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

/// Answer of the model at one point: time, charges and voltage of the solution, which every column
/// of data follows from, of one taxel where the data are its, or why there is none.
struct FitAnswer {
  std::shared_ptr<const electrochemistry::IonSolution> ions;
  std::string failure; ///< empty when there is a solution
};

/// The part of a solution that a `FitAnswer` holds.
/// @param taxel that the data are of; empty for none
FitAnswer fit_answer(const electrochemistry::IonSolution& ions, const std::string& taxel = "");

/// The finished evaluations of a fit in a folder, a file each, written when it ends. A fit is
/// deterministic: one that finds its evaluations again goes the same way without solving them. Safe
/// to use from several threads.
class FitLog {
public:
  /// Takes up what this build left in the folder's subfolder `evaluations`; the folder must live
  /// on.
  explicit FitLog(results::OutputFolder& folder);

  /// The evaluation at a point, if it is in the log.
  /// @param point values of the free keys [SI]
  std::optional<FitAnswer> find(const std::vector<double>& point) const;
  void add(const std::vector<double>& point, const FitAnswer& answer);
  /// Number of evaluations that an earlier fit left.
  std::size_t taken_up() const { return taken_up_; }
  /// Removes the files and the folder: the fit is finished.
  void remove();

private:
  void take_up(const std::filesystem::path& path);

  results::OutputFolder& folder_;
  mutable std::mutex mutex_;
  std::map<std::vector<double>, FitAnswer> answers_;
  std::size_t taken_up_ = 0;
};

} // namespace ionskin::study
