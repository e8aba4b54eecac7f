// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/fit/fit.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/circuits/circuit.hpp"
#include "ionskin/study/fit/data_checks.hpp"
#include "ionskin/study/fit/misfit.hpp"
#include "ionskin/study/fit/misfit_explanation.hpp"
#include "ionskin/study/fit/shift_search.hpp"

#include <Eigen/QR>
#include <ceres/iteration_callback.h>
#include <ceres/manifold.h>
#include <ceres/problem.h>
#include <ceres/solver.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace ionskin::study {
namespace {

constexpr double gain_tolerance = 1e-7, step_tolerance = 1e-5; // relative
constexpr int most_iterations = 50;
constexpr int most_shortened = 12;   // failed trials of one step: too far away, or without solution
constexpr double search_ends = 5e-5; // distance from the optimum, in coordinates, at which it ends

constexpr double least_shift = 1.0 / 65536; // least width of a profile, in rows
constexpr double smooth_shift = 0.05; // width, in rows, below which a signal is smooth in the shift
constexpr int most_shifts = 8; // searches of the shift, each between two fits of the other keys

/// Reports the progress after each iteration, and ends the fit on an interrupt.
class Watch : public ceres::IterationCallback {
public:
  /// Callback for Ceres.
  /// @param at the coordinates, which Ceres updates in each iteration
  Watch(Misfit& misfit, const std::vector<double>& at, const base::ProgressCallback& progress)
      : misfit_(misfit), at_(at), progress_(progress) {}

  ceres::CallbackReturnType operator()(const ceres::IterationSummary& summary) override {
    const int done = std::max(0, summary.iteration);
    misfit_.accept(at_);
    progress_("least squares", 1.0 - std::pow(0.7, done));
    return misfit_.failed() || base::interrupt_requested() ? ceres::SOLVER_ABORT
                                                           : ceres::SOLVER_CONTINUE;
  }

private:
  Misfit& misfit_;
  const std::vector<double>& at_;
  const base::ProgressCallback& progress_;
};

ceres::Solver::Options solver_options(Watch& watch) {
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.logging_type = ceres::SILENT;
  options.max_num_iterations = most_iterations;
  options.function_tolerance = gain_tolerance;
  options.parameter_tolerance = step_tolerance;
  options.max_num_consecutive_invalid_steps = most_shortened;
  options.update_state_every_iteration = true;
  options.callbacks.push_back(&watch);
  return options;
}

void set_bounds(ceres::Problem& problem, double* coordinates, const FitModel& model) {
  for (std::size_t i = 0; i < model.parameters().size(); ++i) {
    const FitParameter& parameter = model.parameters()[i];
    if (is_data_key(parameter.key)) {
      continue;
    }
    if (parameter.lowest > 0) {
      problem.SetParameterLowerBound(coordinates, static_cast<int>(i), std::log(parameter.lowest));
    }
    if (std::isfinite(parameter.highest)) {
      problem.SetParameterUpperBound(coordinates, static_cast<int>(i), std::log(parameter.highest));
    }
  }
}

std::vector<double> start_values(const FitModel& model, DataAdjustment adjustment) {
  std::vector<double> values;
  for (const FitParameter& parameter : model.parameters()) {
    values.push_back(is_data_key(parameter.key) ? adjustment.of(parameter.key) : parameter.start);
  }
  return values;
}

FitModel::Ions solve_start(FitModel& model) {
  FitModel::Ions ions = model.solutions({start_values(model, {})}).front();
  if (!ions) {
    throw SolverError("the case that the fit starts from has no solution: " + model.last_failure(),
                      "start from other values of the free keys");
  }
  return ions;
}

/// Removes rows that lie more than one interval after the end of the run, and warns.
/// @param end of the run on the clock of the data [s]
void drop_late_rows(FitData& data, double end, std::vector<std::string>& warnings) {
  const std::size_t rows = data.time.size();
  const double interval = rows > 1 ? (data.time.back() - data.time.front()) / (rows - 1.0) : 0;
  const auto kept = static_cast<std::size_t>(std::ranges::upper_bound(data.time, end + interval) -
                                             data.time.begin());
  if (kept < rows) {
    warnings.push_back(fmt::format(
        "{} of {} rows are later than the end of the run and are left out.", rows - kept, rows));
    data.time.resize(kept);
    data.values.resize(kept);
  }
}

void require_voltage(const FitModel& model, const FitData& data) {
  if (data.column != "voltage") {
    return;
  }
  const Readout& readout = model.start_case().readout;
  for (std::size_t i = 0; i < readout.taxels.size(); ++i) {
    if (readout.has_own_circuit(i)) {
      throw UserError(
          "the data hold a voltage of the electrode, but taxels have circuits and "
          "voltages of their own\n  = name the column after its taxel, such as voltage_" +
          readout.taxels[i].name);
    }
  }
  if (!circuits::circuit_row(readout.circuit).holds_potential) {
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

void require_rows(const FitModel& model, const FitData& data) {
  if (data.values.size() <= model.parameters().size()) {
    throw UserError(fmt::format("{} rows of data cannot fix {} free keys\n  = give more rows than "
                                "keys",
                                data.values.size(), model.parameters().size()));
  }
}

/// Fitted parameter with its interval.
/// @param scale of the coordinate; 0 for a logarithm
/// @param half_width of the interval in the coordinate
FittedParameter fitted(const FitParameter& parameter, double value, double scale,
                       double half_width) {
  if (scale > 0) {
    const double half = scale * half_width;
    return {parameter, value, value - half, value + half, false};
  }
  const double size = std::abs(value);
  const bool held = size <= parameter.lowest * (1 + 1e-6) || size >= parameter.highest * (1 - 1e-6);
  if (!(half_width < std::log(undetermined_factor))) {
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    return {parameter, value, unknown, unknown, held};
  }
  const double near = value * std::exp(-half_width), far = value * std::exp(half_width);
  return {parameter, value, std::min(near, far), std::max(near, far), held};
}

/// Sum of the squares of the residuals at a point, with the best values of all parameters but one
/// by linear theory; infinite where there is no solution.
double squares_but_for(const Misfit& misfit, const FitData& data, const std::vector<double>& at,
                       std::size_t fixed) {
  const auto values = misfit.fitted(at);
  const auto jacobian = misfit.derivatives(at);
  if (!values || !jacobian) {
    return std::numeric_limits<double>::infinity();
  }
  const auto rows = static_cast<Eigen::Index>(data.values.size());
  const auto column = [rows](const std::vector<double>& one) {
    return Eigen::Map<const Eigen::VectorXd>(one.data(), rows);
  };
  Eigen::VectorXd residuals = column(data.values) - column(*values);
  Eigen::MatrixXd others(rows, static_cast<Eigen::Index>(jacobian->size()) - 1);
  for (std::size_t i = 0, next = 0; i < jacobian->size(); ++i) {
    if (i != fixed) {
      others.col(static_cast<Eigen::Index>(next++)) = column((*jacobian)[i]);
    }
  }
  if (others.cols() > 0) {
    residuals -= others * others.completeOrthogonalDecomposition().solve(residuals);
  }
  return residuals.squaredNorm();
}

/// Distances below and above the optimum, in the coordinate of a time shift, within which lie all
/// shifts whose residuals are larger by no more than noise explains. Linear theory fails where a
/// signal is shorter than the interval of a row: all shifts in a part of the row then fit equally
/// well, or only those in small parts of it, which need not be connected.
/// @param compared shifts that are looked at beside those next to the optimum [s]
/// @param residual_deviation root mean square of the residuals per degree of freedom [unit of data]
/// @param quantile of Student's t
std::array<double, 2> profile(const Misfit& misfit, const FitData& data,
                              const std::vector<double>& optimum, std::size_t shift,
                              const std::vector<double>& compared, double residual_deviation,
                              double quantile) {
  constexpr double ratio = 1.4, step = 1.0 / 64, farthest = 2; // rows
  const double most =
      squares_but_for(misfit, data, optimum, shift) + std::pow(quantile * residual_deviation, 2);
  std::vector<double> at = optimum;
  const auto fits = [&](double coordinate) {
    at[shift] = coordinate;
    return squares_but_for(misfit, data, at, shift) <= most;
  };
  std::array<double, 2> distances{};
  for (std::size_t side = 0; side < 2; ++side) {
    for (double distance = least_shift; distance <= farthest;
         distance = std::min(distance * ratio, distance + step)) {
      if (!fits(optimum[shift] + (side == 0 ? -distance : distance))) {
        break;
      }
      distances[side] = distance;
    }
  }
  const double value = misfit.values(optimum)[shift];
  for (const double other : compared) {
    const double distance = (other - value) / misfit.scale(shift);
    double& own = distances[distance < 0 ? 0 : 1];
    if (std::abs(distance) > own && fits(optimum[shift] + distance)) {
      own = std::abs(distance);
    }
  }
  return distances;
}

/// Index of the time shift among the parameters, if it is free.
std::optional<std::size_t> shift_of(const FitModel& model) {
  for (std::size_t i = 0; i < model.parameters().size(); ++i) {
    if (model.parameters()[i].key == "data.time_shift") {
      return i;
    }
  }
  return std::nullopt;
}

/// Moves the time shift of an optimum to the best one within a row, with the other parameters by
/// linear theory.
/// @returns true if the residuals fall
bool improve_shift(FitModel& model, const Misfit& misfit, const FitData& data, std::size_t shift,
                   std::vector<double>& at) {
  constexpr double least_gain = 1e-6; // of the sum of squares
  const std::vector<double> values = misfit.values(at);
  const FitModel::Ions ions = model.solutions({values}).front();
  if (!ions) {
    return false;
  }
  const auto squares = [&](double time_shift) {
    std::vector<double> moved = values;
    moved[shift] = time_shift;
    return squares_but_for(misfit, data, misfit.coordinates(moved), shift);
  };
  const LeastOfShifts best =
      least_of_shifts(shifts_to_compare(data, *ions, values[shift], misfit.scale(shift)), squares);
  if (!(best.value < (1 - least_gain) * squares(values[shift]))) {
    return false;
  }
  std::vector<double> moved = values;
  moved[shift] = best.time_shift;
  std::ranges::copy(misfit.coordinates(moved), at.begin()); // the solver keeps its address
  return true;
}

FitResult summarise(FitModel& model, const FitData& data, Misfit& misfit,
                    const std::vector<double>& start, const std::vector<double>& optimum) {
  FitResult result;
  const std::vector<double> values = misfit.values(optimum);
  result.fitted = *misfit.fitted(optimum);
  auto jacobian = misfit.derivatives(optimum);
  if (!jacobian) {
    throw SolverError("there is no solution close to the fitted values: " + model.last_failure(),
                      "start from other values of the free keys");
  }
  std::vector<double> residuals;
  for (std::size_t row = 0; row < data.values.size(); ++row) {
    residuals.push_back(data.values[row] - result.fitted[row]);
  }
  result.statistics = fit_statistics(data.values, residuals, *jacobian);
  std::array<double, 2> shifts{}; // distances to the ends of the profile of the time shift
  if (const auto shift = shift_of(model)) {
    const auto compared = shifts_to_compare(data, *model.solutions({values}).front(),
                                            values[*shift], misfit.scale(*shift));
    shifts = profile(misfit, data, optimum, *shift, compared, result.statistics.residual_deviation,
                     result.statistics.quantile);
    misfit.take_shift_difference(
        std::clamp(std::max(shifts[0], shifts[1]), least_shift, smooth_shift));
    jacobian = misfit.derivatives(optimum);
    result.statistics = fit_statistics(data.values, residuals, *jacobian);
  }
  std::vector<std::string> keys;
  for (std::size_t i = 0; i < optimum.size(); ++i) {
    FitParameter parameter = model.parameters()[i];
    parameter.start = start[i];
    if (is_data_key(parameter.key)) {
      parameter.unit = data_key_unit(parameter.key, data.unit);
    }
    keys.push_back(parameter.key);
    result.parameters.push_back(
        fitted(parameter, values[i], misfit.scale(i),
               result.statistics.quantile * result.statistics.log_error[i] + search_ends));
    if (parameter.key == "data.time_shift") {
      FittedParameter& shift = result.parameters.back();
      shift.lower_95 = std::min(shift.lower_95, values[i] - shifts[0] * misfit.scale(i));
      shift.upper_95 = std::max(shift.upper_95, values[i] + shifts[1] * misfit.scale(i));
    }
    if (result.parameters.back().at_bound) {
      result.warnings.push_back(
          fmt::format("{} = {:.6g} is at the end of its range: its interval has no meaning.",
                      keys[i], values[i]));
    }
  }
  const auto more = fit_warnings(result.statistics, keys);
  result.warnings.insert(result.warnings.end(), more.begin(), more.end());
  return result;
}

} // namespace

void prepare(FitData& data, FitModel& model) {
  require_voltage(model, data);
  const auto [begin, end] = model.span();
  if (!model.frees("data.time_shift")) {
    restrict_to_run(data, begin, end);
  }
  require_rows(model, data);
  require_signal(data);
  model.keep_taxel(taxel_of(data.column));
}

FitResult fit(FitModel& model, FitData& data, const base::ProgressCallback& progress,
              const FitNote& note) {
  const FitModel::Ions start_ions = solve_start(model);
  const DataAdjustment adjustment = start_adjustment(model, data, *start_ions);
  std::vector<std::string> warnings;
  if (model.frees("data.time_shift")) {
    drop_late_rows(data, model.span().second + adjustment.time_shift, warnings);
    require_rows(model, data);
    require_signal(data);
  }
  const auto likeness = compare_with_start(model, data, *start_ions, adjustment);
  warnings.insert(warnings.end(), likeness.begin(), likeness.end());
  std::ranges::for_each(warnings, note);

  const std::vector<double> start = start_values(model, adjustment);
  Misfit misfit(model, data, start);
  std::vector<double> at = misfit.coordinates(start);
  misfit.accept(at);
  Watch watch(misfit, at, progress);
  ceres::Problem::Options borrowed;
  borrowed.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(borrowed);
  problem.AddResidualBlock(&misfit, nullptr, at.data());
  set_bounds(problem, at.data(), model);
  // Derivatives do not lead to the best shift of a signal with spikes. It is searched directly,
  // with the other keys by linear theory, between two fits of the other keys.
  const auto shift = shift_of(model);
  const bool others = model.parameters().size() > (shift ? 1U : 0U);
  if (shift && others) {
    problem.SetManifold(at.data(), new ceres::SubsetManifold(static_cast<int>(at.size()),
                                                             {static_cast<int>(*shift)}));
  }
  bool converged = true;
  int iterations = 0;
  for (int searches = 0;; ++searches) {
    if (others) {
      ceres::Solver::Summary summary;
      ceres::Solve(solver_options(watch), &problem, &summary);
      misfit.rethrow();
      base::check_interrupt();
      if (!summary.IsSolutionUsable()) {
        throw SolverError(
            "the least-squares solver cannot improve on the starting values: " + summary.message +
                (model.last_failure().empty() ? "" : "; " + model.last_failure()),
            "start from other values of the free keys");
      }
      converged = summary.termination_type == ceres::CONVERGENCE;
      iterations += static_cast<int>(summary.iterations.size()) - 1;
    }
    if (!shift || searches == most_shifts || !improve_shift(model, misfit, data, *shift, at)) {
      break;
    }
    misfit.accept(at);
  }
  FitResult result = summarise(model, data, misfit, start, at);
  progress("least squares", 1.0);
  const std::vector<double> optimum = misfit.values(at);
  const auto reasons =
      explain_misfit(model, data, *start_ions, *model.solutions({optimum}).front(), optimum);
  result.warnings.insert(result.warnings.begin(), reasons.begin(), reasons.end());
  result.warnings.insert(result.warnings.begin(), warnings.begin(), warnings.end());
  result.converged = converged;
  result.iterations = iterations;
  if (!result.converged) {
    result.warnings.push_back(fmt::format("The least squares have not converged after {} "
                                          "iterations: start again from fitted.toml.",
                                          result.iterations));
  }
  return result;
}

} // namespace ionskin::study
