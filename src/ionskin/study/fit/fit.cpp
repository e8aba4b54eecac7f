// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/fit/fit.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/circuits/circuit.hpp"

#include <ceres/cost_function.h>
#include <ceres/iteration_callback.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>

namespace ionskin::study {
namespace {

// Of log parameters. Time steps change with the parameters, so differences must be well above that.
constexpr double difference = 0.05;
constexpr double gain_tolerance = 1e-7, step_tolerance = 1e-5; // relative
constexpr int most_iterations = 50;

/// Residuals and derivatives as Ceres asks for them: scaled, in log parameters.
class Misfit : public ceres::CostFunction {
public:
  Misfit(FitModel& model, const FitData& data) : model_(model), data_(data) {
    set_num_residuals(static_cast<int>(data.values.size()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(model.parameters().size()));
    double power = 0;
    for (const double value : data.values) {
      power += value * value;
    }
    scale_ = power > 0 ? std::sqrt(static_cast<double>(data.values.size()) / power) : 1.0;
  }

  bool Evaluate(const double* const* parameters, double* residuals,
                double** jacobians) const override {
    const std::size_t count = model_.parameters().size();
    const std::vector<double> logs(parameters[0], parameters[0] + count);
    try {
      if (!evaluate(logs, residuals)) {
        return false;
      }
      if (jacobians == nullptr || jacobians[0] == nullptr) {
        return true;
      }
      const auto columns = derivatives(logs);
      if (!columns) {
        return false;
      }
      for (std::size_t row = 0; row < data_.values.size(); ++row) {
        for (std::size_t i = 0; i < count; ++i) {
          jacobians[0][row * count + i] = -scale_ * (*columns)[i][row];
        }
      }
      return true;
    } catch (...) { // must not pass through Ceres
      failure_ = std::current_exception();
      return false;
    }
  }

  /// Throws again what an evaluation met.
  void rethrow() const {
    if (failure_) {
      std::rethrow_exception(failure_);
    }
  }
  bool failed() const { return failure_ != nullptr; }

  std::vector<double> values(const std::vector<double>& logs) const {
    std::vector<double> result;
    for (std::size_t i = 0; i < logs.size(); ++i) {
      result.push_back(std::copysign(std::exp(logs[i]), model_.parameters()[i].start));
    }
    return result;
  }

  /// Derivatives of the model by the log parameters; nothing where there is no solution.
  std::optional<Jacobian> derivatives(const std::vector<double>& logs) const {
    std::vector<std::vector<double>> points;
    std::vector<double> widths;
    for (std::size_t i = 0; i < logs.size(); ++i) {
      const FitParameter& parameter = model_.parameters()[i];
      std::vector<double> up = logs, down = logs;
      up[i] = std::min(logs[i] + difference, std::log(parameter.highest));
      down[i] = std::max(logs[i] - difference, std::log(parameter.lowest));
      widths.push_back(up[i] - down[i]);
      points.push_back(values(up));
      points.push_back(values(down));
    }
    const auto answers = model_.answers(data_, points);
    Jacobian result;
    for (std::size_t i = 0; i < logs.size(); ++i) {
      if (!answers[2 * i] || !answers[2 * i + 1]) {
        return std::nullopt;
      }
      std::vector<double>& column = result.emplace_back(*answers[2 * i]);
      for (std::size_t row = 0; row < column.size(); ++row) {
        column[row] = (column[row] - (*answers[2 * i + 1])[row]) / widths[i];
      }
    }
    return result;
  }

private:
  bool evaluate(const std::vector<double>& logs, double* residuals) const {
    const auto answer = model_.answers(data_, {values(logs)}).front();
    if (!answer) {
      return false;
    }
    for (std::size_t row = 0; row < answer->size(); ++row) {
      residuals[row] = scale_ * (data_.values[row] - (*answer)[row]);
    }
    return true;
  }

  FitModel& model_;
  const FitData& data_;
  double scale_ = 1;
  mutable std::exception_ptr failure_;
};

/// Tells the progress and ends the fit on an interrupt.
class Watch : public ceres::IterationCallback {
public:
  Watch(const Misfit& misfit, const base::ProgressCallback& progress)
      : misfit_(misfit), progress_(progress) {}

  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    const int done = std::max(0, summary.iteration);
    progress_("least squares", 1.0 - std::pow(0.7, done));
    return misfit_.failed() || base::interrupt_requested() ? ceres::SOLVER_ABORT
                                                           : ceres::SOLVER_CONTINUE;
  }

private:
  const Misfit& misfit_;
  const base::ProgressCallback& progress_;
};

ceres::Solver::Options solver_options(Watch& watch) {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = most_iterations;
  options.function_tolerance = gain_tolerance;
  options.parameter_tolerance = step_tolerance;
  options.callbacks.push_back(&watch);
  return options;
}

void set_bounds(ceres::Problem& problem, double* logs, const FitModel& model) {
  for (std::size_t i = 0; i < model.parameters().size(); ++i) {
    const FitParameter& parameter = model.parameters()[i];
    if (parameter.lowest > 0) {
      problem.SetParameterLowerBound(logs, static_cast<int>(i), std::log(parameter.lowest));
    }
    if (std::isfinite(parameter.highest)) {
      problem.SetParameterUpperBound(logs, static_cast<int>(i), std::log(parameter.highest));
    }
  }
}

std::vector<double> start_logs(const FitModel& model) {
  std::vector<double> logs;
  for (const FitParameter& parameter : model.parameters()) {
    logs.push_back(std::log(std::abs(parameter.start)));
  }
  return logs;
}

void require_start(FitModel& model, const FitData& data) {
  std::vector<double> start;
  for (const FitParameter& parameter : model.parameters()) {
    start.push_back(parameter.start);
  }
  if (!model.answers(data, {start}).front()) {
    throw SolverError("the case that the fit starts from has no solution: " + model.last_failure(),
                      "start from other values of the free keys");
  }
}

void require_voltage(const FitModel& model, const FitData& data) {
  if (data.column != "voltage" ||
      !circuits::circuit_row(model.start_case().readout.circuit).holds_potential) {
    return;
  }
  std::string with_voltage;
  for (const circuits::CircuitRow& row : circuits::circuits()) {
    if (!row.holds_potential) {
      with_voltage += fmt::format("{}\"{}\"", with_voltage.empty() ? "" : " or ", row.name);
    }
  }
  throw UserError("the data hold a voltage, but this circuit keeps the electrodes at one "
                  "potential\n  = set readout.circuit = " +
                  with_voltage);
}

void require_one_electrode(const FitModel& model) {
  if (model.start_case().readout.is_cut()) {
    throw UserError("readout.taxel_circuit: a fit compares the signals of the whole top electrode, "
                    "and here taxels have circuits of their own\n"
                    "  = set readout.taxel_circuit = \"shared\", and remove the circuits of single "
                    "taxels");
  }
}

void require_rows(const FitModel& model, const FitData& data) {
  if (data.values.size() <= model.parameters().size()) {
    throw UserError(fmt::format("{} rows of data cannot fix {} free keys\n  = give more rows than "
                                "keys",
                                data.values.size(), model.parameters().size()));
  }
}

FittedParameter fitted(const FitParameter& parameter, double value, double half_width) {
  const double near = value * std::exp(-half_width), far = value * std::exp(half_width);
  const double size = std::abs(value);
  const bool held = size <= parameter.lowest * (1 + 1e-6) || size >= parameter.highest * (1 - 1e-6);
  return {parameter, value, std::min(near, far), std::max(near, far), held};
}

FitResult summarise(FitModel& model, const FitData& data, const Misfit& misfit,
                    const std::vector<double>& logs) {
  FitResult result;
  const std::vector<double> values = misfit.values(logs);
  result.fitted = *model.answers(data, {values}).front();
  const auto jacobian = misfit.derivatives(logs);
  if (!jacobian) {
    throw SolverError("there is no solution close to the fitted values: " + model.last_failure(),
                      "start from other values of the free keys");
  }
  std::vector<double> residuals;
  for (std::size_t row = 0; row < data.values.size(); ++row) {
    residuals.push_back(data.values[row] - result.fitted[row]);
  }
  result.statistics = fit_statistics(data.values, residuals, *jacobian);
  std::vector<std::string> keys;
  for (std::size_t i = 0; i < logs.size(); ++i) {
    const FitParameter& parameter = model.parameters()[i];
    keys.push_back(parameter.key);
    result.parameters.push_back(
        fitted(parameter, values[i], result.statistics.quantile * result.statistics.log_error[i]));
    if (result.parameters.back().at_bound) {
      result.warnings.push_back(
          fmt::format("{} = {:.6g} is at the end of its range: its interval says nothing.", keys[i],
                      values[i]));
    }
  }
  const auto more = fit_warnings(result.statistics, keys);
  result.warnings.insert(result.warnings.end(), more.begin(), more.end());
  return result;
}

} // namespace

void prepare(FitData& data, FitModel& model) {
  require_one_electrode(model);
  require_voltage(model, data);
  const auto [begin, end] = model.span();
  restrict_to_run(data, begin, end);
  require_rows(model, data);
}

FitResult fit(FitModel& model, const FitData& data, const base::ProgressCallback& progress) {
  require_start(model, data);
  std::vector<double> logs = start_logs(model);
  Misfit misfit(model, data);
  Watch watch(misfit, progress);
  ceres::Problem::Options borrowed;
  borrowed.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(borrowed);
  problem.AddResidualBlock(&misfit, nullptr, logs.data());
  set_bounds(problem, logs.data(), model);
  ceres::Solver::Summary summary;
  ceres::Solve(solver_options(watch), &problem, &summary);
  misfit.rethrow();
  base::check_interrupt();
  if (!summary.IsSolutionUsable()) {
    throw SolverError("the least squares found no way from the start: " + summary.message +
                          (model.last_failure().empty() ? "" : "; " + model.last_failure()),
                      "start from other values of the free keys");
  }
  FitResult result = summarise(model, data, misfit, logs);
  progress("least squares", 1.0);
  result.converged = summary.termination_type == ceres::CONVERGENCE;
  result.iterations = static_cast<int>(summary.iterations.size()) - 1;
  if (!result.converged) {
    result.warnings.push_back(fmt::format("The least squares have not converged after {} "
                                          "iterations: start again from fitted.toml.",
                                          result.iterations));
  }
  return result;
}

} // namespace ionskin::study
