// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/progress.hpp"
#include "ionskin/case/case.hpp"
#include "ionskin/study/fit/data_adjustment.hpp"
#include "ionskin/study/fit/fit_log.hpp"
#include "ionskin/study/store/fit_data.hpp"
#include "ionskin/study/store/mechanics_record.hpp"

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ionskin::study {

/// One key that a fit varies, in SI units. A key of the case keeps its sign: the fit works on the
/// logarithm of its magnitude. One of the data (`data_keys`) is varied as it is.
struct FitParameter {
  std::string key, unit; ///< unit empty while it follows from the data
  double start = 0;
  double lowest = 0, highest = 0; ///< of the magnitude, within the key's range
};

struct FitModelOptions {
  int threads = 1;
  base::ProgressCallback progress = base::no_progress;
};

/// A case as a function of a few of its numbers. Study 1 is solved once for all values that leave
/// it the same; every answer is kept. For one thread at a time, which works with several.
class FitModel {
public:
  using Ions = std::shared_ptr<const electrochemistry::IonSolution>;

  /// @param text, path, set_edits the case; the path names it and anchors the files it names
  /// @param free keys of single real numbers that are not 0, and keys of the data
  /// Throws UserError for another key, and for everything that is wrong with the case.
  FitModel(std::string text, std::string path, std::vector<std::string> set_edits,
           const std::vector<std::string>& free, FitModelOptions options);

  const std::vector<FitParameter>& parameters() const { return parameters_; }
  bool frees(std::string_view key) const;
  const Case& start_case() const { return start_case_; }
  const std::string& path() const { return path_; }
  /// The case at other values of the parameters.
  Case case_at(const std::vector<double>& values) const;

  /// Keeps the charges of a taxel with those of the electrodes, for data of that taxel.
  /// @param taxel empty for none
  void keep_taxel(std::string taxel) { taxel_ = std::move(taxel); }

  /// First and last instant of the run [s].
  std::pair<double, double> span();

  /// Every solution from now on goes into the log, and values that are in the log are not solved
  /// again.
  /// @param log must outlive the model's answers
  void keep_answers_in(FitLog& log) { log_ = &log; }

  /// The solution of each point, as far as data need it; null where there is none.
  /// @param points one value per parameter each, in SI units; those of the data change nothing
  /// Throws Interrupted.
  std::vector<Ions> solutions(const std::vector<std::vector<double>>& points);
  /// The values of a point that belong to the data.
  DataAdjustment adjustment_at(const std::vector<double>& point) const;

  /// Half the width of the band of numerical errors about the fitted curve, one entry per row of
  /// the data; empty where they are not estimated. Solves the coarser solutions of Study 1: for the
  /// end of a fit. Throws SolverError, Interrupted.
  std::vector<double> errors(const FitData& data, const std::vector<double>& point);

  std::size_t ion_solves() const { return ion_solves_; }
  std::size_t evaluations_taken_up() const { return log_ != nullptr ? log_->taken_up() : 0; }
  std::size_t mechanics_solves() const { return mechanics_solves_; }
  /// Reason why there was none at last; empty when there always was.
  const std::string& last_failure() const { return last_failure_; }

private:
  using Mechanics = std::shared_ptr<const MechanicsRecord>;

  Mechanics mechanics_of(const Case& input);
  std::vector<double> of_case(const std::vector<double>& point) const;
  electrochemistry::IonSolution solve(const std::vector<double>& point, int threads);
  std::optional<FitAnswer> known_answer(const std::vector<double>& of_case) const;
  void find_answer(const std::vector<double>& point, int threads);

  std::string path_, text_, taxel_;
  std::vector<std::string> set_edits_;
  FitModelOptions options_;
  Case start_case_;
  std::vector<FitParameter> parameters_;
  std::mutex mechanics_mutex_;
  std::map<std::string, Mechanics> mechanics_;       ///< by `mechanics_hash`
  std::map<std::vector<double>, FitAnswer> answers_; ///< by the keys of the case
  std::mutex answers_mutex_;
  FitLog* log_ = nullptr;
  std::size_t ion_solves_ = 0, mechanics_solves_ = 0;
  std::string last_failure_;
};

} // namespace ionskin::study
