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

/// Parameter that a fit varies, in SI units. A key of the case keeps its sign, as the fit works on
/// the logarithm of its magnitude; a key of the data (`data_keys`) is varied linearly.
struct FitParameter {
  std::string key, unit; ///< unit is empty for a key of the data until the data are known
  /// Initial value.
  double start = 0;
  /// Range of the magnitude that the key allows; infinite for a key of the data.
  double lowest = 0, highest = 0;
};

struct FitModelOptions {
  int threads = 1;
  base::ProgressCallback progress = base::no_progress;
};

/// A case as a function of a few of its numbers, the model that a fit evaluates. Study 1 is solved
/// once for all values that do not change it, and every answer is stored. The model works with
/// several threads, but is to be called from one at a time.
class FitModel {
public:
  using Ions = std::shared_ptr<const electrochemistry::IonSolution>;

  /// Reads and checks the case and makes one parameter of each free key.
  /// @param text, path, set_edits the case; `path` is used in messages and for relative file names
  /// @param free keys of the case with a single real number that is not 0, and keys of the data
  /// Throws UserError for any other key, and for everything that is wrong with the case.
  FitModel(std::string text, std::string path, std::vector<std::string> set_edits,
           const std::vector<std::string>& free, FitModelOptions options);

  const std::vector<FitParameter>& parameters() const { return parameters_; }
  /// True if a key is one of the parameters.
  bool frees(std::string_view key) const;
  const Case& start_case() const { return start_case_; }
  const std::string& path() const { return path_; }
  /// Reads the case at other values of the parameters.
  /// @param values one per parameter [SI]; values of keys of the data change nothing
  Case case_at(const std::vector<double>& values) const;

  /// Stores the charges of a taxel in all further answers, for data from that taxel.
  /// @param taxel its name; empty for none
  void keep_taxel(std::string taxel) { taxel_ = std::move(taxel); }

  /// First and last instant of the run [s]; reads the strain history where the case gives one.
  std::pair<double, double> span();

  /// Stores every further answer in a log, and takes answers from it instead of solving them again.
  /// @param log must outlive this model
  void keep_answers_in(FitLog& log) { log_ = &log; }

  /// Solves the case at each point, in parallel, unless its answer is stored.
  /// @param points one value per parameter each [SI]; values of keys of the data change nothing
  /// @returns for each point the part of the solution that data need; null where there is none
  /// Throws Interrupted.
  std::vector<Ions> solutions(const std::vector<std::vector<double>>& points);
  /// Values of a point that belong to keys of the data; keys that are not free have no effect (gain
  /// 1, others 0).
  /// @param point one value per parameter [SI]
  DataAdjustment adjustment_at(const std::vector<double>& point) const;

  /// Estimates the numerical error of the fitted curve, half the width of an error band with one
  /// entry per row of the data [unit of the data]; empty where it cannot be estimated. Solves the
  /// coarser solutions of Study 1, so it is meant for the end of a fit.
  /// @param point values of the parameters [SI]
  /// Throws SolverError, Interrupted.
  std::vector<double> errors(const FitData& data, const std::vector<double>& point);

  /// Number of ion transport solutions solved by this model.
  std::size_t ion_solves() const { return ion_solves_; }
  std::size_t evaluations_taken_up() const { return log_ != nullptr ? log_->taken_up() : 0; }
  std::size_t mechanics_solves() const { return mechanics_solves_; }
  /// Reason why the last point without a solution had none; empty when all points had one.
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
  std::map<std::vector<double>, FitAnswer> answers_; ///< by the values of the keys of the case
  std::mutex answers_mutex_;
  FitLog* log_ = nullptr;
  std::size_t ion_solves_ = 0, mechanics_solves_ = 0;
  std::string last_failure_;
};

} // namespace ionskin::study
