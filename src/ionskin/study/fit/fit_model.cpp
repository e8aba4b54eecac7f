// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/fit/fit_model.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/case/reading/read_case.hpp"
#include "ionskin/case/schema/schema.hpp"
#include "ionskin/case/schema/suggest_key.hpp"
#include "ionskin/electrochemistry/equations/space_charge.hpp"
#include "ionskin/electrochemistry/equations/wall_potential.hpp"
#include "ionskin/electrochemistry/ion_transport.hpp"
#include "ionskin/mechanics/solve_contact.hpp"
#include "ionskin/parallel/task_pool.hpp"
#include "ionskin/poroelasticity/prescribed_load.hpp"
#include "ionskin/results/strain_file/strain_file.hpp"
#include "ionskin/study/errors/error_estimate.hpp"
#include "ionskin/study/run/run_folder.hpp"
#include "ionskin/study/run/solve_mechanics.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ionskin::study {
namespace {

[[noreturn]] void refuse(const std::string& key, const std::string& problem,
                         const std::string& remedy) {
  throw UserError(fmt::format("--free {}: {}\n  = {}", key, problem, remedy));
}

[[noreturn]] void refuse_unknown(const std::string& key) {
  const std::string nearest = suggest_key(key);
  refuse(key, "unknown key",
         nearest.empty() ? "ionskin check CASE.toml --explain lists the keys of a case"
                         : fmt::format("did you mean {}?", nearest));
}

/// Sets the range of the magnitude that the key's range allows for the sign of its value.
void set_bounds(const Range& range, FitParameter& parameter) {
  const bool positive = parameter.start > 0;
  const double near = positive ? range.lower : -range.upper;
  const double far = positive ? range.upper : -range.lower;
  parameter.lowest = std::max(0.0, near);
  parameter.highest = far;
}

/// Parameter of a key of the data; its start is found from the data later.
FitParameter make_data_parameter(const std::string& key) {
  if (!is_data_key(key)) {
    refuse(key, "unknown key of the data", fmt::format("known: {}", fmt::join(data_keys(), ", ")));
  }
  FitParameter parameter{key, "", DataAdjustment().of(key)};
  parameter.highest = std::numeric_limits<double>::infinity();
  return parameter;
}

FitParameter make_parameter(const CaseDocument& document, const std::string& key) {
  if (key.starts_with("data.")) {
    return make_data_parameter(key);
  }
  const SchemaRow* row = find_row(key_pattern(key));
  if (row == nullptr) {
    refuse_unknown(key);
  }
  if (row->type != ValueType::number && row->type != ValueType::quantity) {
    refuse(key, "only single real numbers can be fitted", "leave it out");
  }
  if (key == "readout.sample_interval" || key.starts_with("numerics.")) {
    refuse(key, "it says how to compute, not what", "leave it out");
  }
  const ValueRecord* record = document.find(key);
  if (record == nullptr) {
    refuse(key, "it has no value in this case", "give it one to start from");
  }
  FitParameter parameter{key, units::dimension_info(record->value.dimension).si_unit,
                         record->value.numbers.front()};
  if (parameter.start == 0) {
    refuse(key, "a fit cannot start from 0", "give it a value of the sign and size to expect");
  }
  set_bounds(row->range, parameter);
  return parameter;
}

} // namespace

FitModel::FitModel(std::string text, std::string path, std::vector<std::string> set_edits,
                   const std::vector<std::string>& free, FitModelOptions options)
    : path_(std::move(path)), text_(std::move(text)), set_edits_(std::move(set_edits)),
      options_(std::move(options)) {
  const CaseDocument document = read_case_text(text_, path_, set_edits_);
  start_case_ = document.input;
  start_case_.output.fields.clear();
  if (free.empty()) {
    throw UserError("the fit has no free key\n  = write --free KEY,KEY such as --free "
                    "coupling.coefficient,electrochemistry.diffusivity");
  }
  for (const std::string& key : free) {
    if (std::ranges::any_of(parameters_, [&](const auto& one) { return one.key == key; })) {
      refuse(key, "it is named twice", "name it once");
    }
    parameters_.push_back(make_parameter(document, key));
  }
}

Case FitModel::case_at(const std::vector<double>& values) const {
  std::vector<std::string> edits = set_edits_;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const FitParameter& parameter = parameters_[i];
    if (is_data_key(parameter.key)) {
      continue;
    }
    edits.push_back(parameter.unit == "1"
                        ? fmt::format("{}={}", parameter.key, values[i])
                        : fmt::format("{}={} {}", parameter.key, values[i], parameter.unit));
  }
  return read_case_text(text_, path_, edits).input;
}

FitModel::Mechanics FitModel::mechanics_of(const Case& input) {
  if (input.strain.kind == StrainSourceKind::prescribed) {
    MechanicsRecord record;
    record.history = poroelasticity::prescribed_history(input);
    return std::make_shared<const MechanicsRecord>(std::move(record));
  }
  const std::lock_guard lock(mechanics_mutex_);
  const bool from_file = input.strain.kind == StrainSourceKind::file;
  Mechanics& known = mechanics_[from_file ? input.strain.file : mechanics_hash(input)];
  if (known) {
    return known;
  }
  MechanicsRecord record;
  if (from_file) {
    record.history = results::read_strain_file(input.strain.file, input.skin);
  } else {
    base::Timers timers;
    mechanics::ContactOptions contact_options;
    contact_options.threads = options_.threads;
    contact_options.progress = options_.progress;
    Case alone = input;
    // `errors` solves the coarser solutions at the end of the fit.
    alone.numerics.error_estimate = false;
    record = record_mechanics(
        input, solve_mechanics(alone, {input.contact.friction}, contact_options, timers).front());
    ++mechanics_solves_;
  }
  known = std::make_shared<const MechanicsRecord>(std::move(record));
  return known;
}

std::pair<double, double> FitModel::span() {
  if (start_case_.strain.kind == StrainSourceKind::contact) {
    return {0.0, start_case_.motion.cycles * start_case_.motion.cycle_duration()};
  }
  const std::vector<double>& time = mechanics_of(start_case_)->history.time;
  return {time.front(), time.back()};
}

std::vector<double> FitModel::of_case(const std::vector<double>& point) const {
  std::vector<double> values;
  for (std::size_t i = 0; i < point.size(); ++i) {
    if (!is_data_key(parameters_[i].key)) {
      values.push_back(point[i]);
    }
  }
  return values;
}

DataAdjustment FitModel::adjustment_at(const std::vector<double>& point) const {
  DataAdjustment adjustment;
  for (std::size_t i = 0; i < point.size(); ++i) {
    if (is_data_key(parameters_[i].key)) {
      adjustment.of(parameters_[i].key) = point[i];
    }
  }
  return adjustment;
}

electrochemistry::IonSolution FitModel::solve(const std::vector<double>& point, int threads) {
  Case input = case_at(point);
  input.output.fields.clear();
  const Mechanics mechanics = mechanics_of(input);
  electrochemistry::check_fixed_charge(input, mechanics->history);
  electrochemistry::check_net_charge(input, mechanics->history);
  base::Timers timers;
  electrochemistry::IonOptions ion_options;
  ion_options.threads = threads;
  return electrochemistry::solve_ion_transport(input, mechanics->history, ion_options, timers);
}

std::vector<double> FitModel::errors(const FitData& data, const std::vector<double>& point) {
  Case input = case_at(point);
  input.output.fields.clear();
  MechanicsRecord mechanics = *mechanics_of(input);
  if (mechanics.has_contact()) {
    mechanics::ContactOptions contact_options;
    contact_options.threads = options_.threads;
    add_coarser_solutions(input, contact_options, mechanics);
  }
  const DataAdjustment adjustment = adjustment_at(point);
  auto errors = estimate_data_errors(input, mechanics, solve(point, options_.threads),
                                     without_shift(data, adjustment.time_shift), options_.threads);
  for (double& error : errors) {
    error *= std::abs(adjustment.gain);
  }
  return errors;
}

std::optional<FitAnswer> FitModel::known_answer(const std::vector<double>& of_case) const {
  if (log_ != nullptr) {
    return log_->find(of_case);
  }
  const auto found = answers_.find(of_case);
  return found == answers_.end() ? std::nullopt : std::optional(found->second);
}

void FitModel::find_answer(const std::vector<double>& point, int threads) {
  FitAnswer answer;
  try {
    answer = fit_answer(solve(point, threads), taxel_);
  } catch (const SolverError& error) {
    answer.failure = fmt::format("{}; {}", error.what(), error.remedy());
  } catch (const UserError& error) { // the start was valid, but these values do not fit together
    answer.failure = error.what();
  }
  if (log_ != nullptr) {
    log_->add(of_case(point), answer);
    return;
  }
  const std::lock_guard lock(answers_mutex_);
  answers_[of_case(point)] = std::move(answer);
}

std::vector<FitModel::Ions> FitModel::solutions(const std::vector<std::vector<double>>& points) {
  std::vector<std::vector<double>> missing, wanted;
  for (const auto& point : points) {
    const std::vector<double> values = of_case(point);
    if (!known_answer(values) && std::ranges::find(wanted, values) == wanted.end()) {
      missing.push_back(point);
      wanted.push_back(values);
    }
  }
  // The threads are divided among all points, known or not, so that a solution is computed in the
  // same way whichever points are known already.
  const int each = std::max(1, options_.threads / std::max(1, static_cast<int>(points.size())));
  parallel::run_tasks(missing.size(), options_.threads,
                      [&](std::size_t i) { find_answer(missing[i], each); });
  ion_solves_ += missing.size();
  std::vector<Ions> result;
  for (const auto& point : points) {
    const FitAnswer answer = known_answer(of_case(point)).value();
    if (!answer.ions) {
      last_failure_ = answer.failure;
    }
    result.push_back(answer.ions);
  }
  return result;
}

bool FitModel::frees(std::string_view key) const {
  return std::ranges::find(parameters_, key, &FitParameter::key) != parameters_.end();
}

} // namespace ionskin::study
