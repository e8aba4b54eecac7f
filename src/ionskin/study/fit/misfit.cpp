// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/fit/misfit.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::study {
namespace {

// Step of the differences in the logarithm of a parameter. Time steps change with the parameters,
// and the step must be large enough that this does not show.
constexpr double difference = 0.05;
// Longest step of the search, in coordinates. Derivatives do not predict a change of a key of the
// case by more than a factor of ten, or of the clock by more than an interval between rows.
constexpr double longest_log_step = 2.303, longest_shift_step = 1;

} // namespace

Misfit::Misfit(FitModel& model, const FitData& data, const std::vector<double>& start)
    : model_(model), data_(data), start_(start) {
  set_num_residuals(static_cast<int>(data.values.size()));
  mutable_parameter_block_sizes()->push_back(static_cast<int>(model.parameters().size()));
  double power = 0;
  for (const double value : data.values) {
    power += value * value;
  }
  if (power > 0) {
    size_ = std::sqrt(power / static_cast<double>(data.values.size()));
  }
  const double length = data.time.back() - data.time.front();
  interval_ = length > 0 ? length / static_cast<double>(data.time.size() - 1) : 1.0;
  DataAdjustment scales{interval_, size_, length > 0 ? size_ / length : size_,
                        std::max(1e-30, std::abs(model.adjustment_at(start).gain))};
  for (const FitParameter& parameter : model.parameters()) {
    scales_.push_back(is_data_key(parameter.key) ? scales.of(parameter.key) : 0.0);
  }
}

std::vector<double> Misfit::coordinates(const std::vector<double>& values) const {
  std::vector<double> result;
  for (std::size_t i = 0; i < values.size(); ++i) {
    result.push_back(scales_[i] > 0 ? (values[i] - start_[i]) / scales_[i]
                                    : std::log(std::abs(values[i])));
  }
  return result;
}

std::vector<double> Misfit::values(const std::vector<double>& coordinates) const {
  std::vector<double> result;
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    result.push_back(scales_[i] > 0 ? start_[i] + scales_[i] * coordinates[i]
                                    : std::copysign(std::exp(coordinates[i]), start_[i]));
  }
  return result;
}

std::optional<std::vector<double>> Misfit::fitted(const std::vector<double>& coordinates) const {
  const std::vector<double> point = values(coordinates);
  const FitModel::Ions ions = model_.solutions({point}).front();
  return ions ? std::optional(predict(data_, *ions, model_.adjustment_at(point))) : std::nullopt;
}

/// Derivatives by a key of the data. The prediction is linear in all of them but the time shift.
std::vector<double> Misfit::by_data(const std::vector<double>& coordinates,
                                    std::size_t parameter) const {
  const bool shift = model_.parameters()[parameter].key == "data.time_shift";
  const double step = shift ? shift_difference_ : 1.0;
  std::vector<double> up = coordinates, down = coordinates;
  up[parameter] += step;
  down[parameter] -= step;
  std::vector<double> column = *fitted(up);
  const std::vector<double> other = *fitted(down);
  for (std::size_t row = 0; row < column.size(); ++row) {
    column[row] = (column[row] - other[row]) / (2 * step);
  }
  return column;
}

std::optional<Jacobian> Misfit::derivatives(const std::vector<double>& coordinates) const {
  std::vector<std::vector<double>> points;
  std::vector<double> widths;
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    if (scales_[i] > 0) {
      continue;
    }
    const FitParameter& parameter = model_.parameters()[i];
    std::vector<double> up = coordinates, down = coordinates;
    up[i] = std::min(coordinates[i] + difference, std::log(parameter.highest));
    down[i] = std::max(coordinates[i] - difference, std::log(parameter.lowest));
    widths.push_back(up[i] - down[i]);
    points.push_back(values(up));
    points.push_back(values(down));
  }
  const std::vector<FitModel::Ions> solutions = model_.solutions(points);
  if (std::ranges::any_of(solutions, [](const auto& one) { return one == nullptr; }) ||
      !fitted(coordinates)) {
    return std::nullopt;
  }
  const DataAdjustment adjustment = model_.adjustment_at(values(coordinates));
  Jacobian result;
  for (std::size_t i = 0, key = 0; i < coordinates.size(); ++i) {
    if (scales_[i] > 0) {
      result.push_back(by_data(coordinates, i));
      continue;
    }
    std::vector<double> column = predict(data_, *solutions[2 * key], adjustment);
    const std::vector<double> other = predict(data_, *solutions[2 * key + 1], adjustment);
    for (std::size_t row = 0; row < column.size(); ++row) {
      column[row] = (column[row] - other[row]) / widths[key];
    }
    result.push_back(std::move(column));
    ++key;
  }
  return result;
}

bool Misfit::too_far(const std::vector<double>& coordinates) const {
  for (std::size_t i = 0; i < accepted_.size(); ++i) {
    const double step = std::abs(coordinates[i] - accepted_[i]);
    const bool shift = model_.parameters()[i].key == "data.time_shift";
    if ((scales_[i] == 0 && step > longest_log_step) || (shift && step > longest_shift_step)) {
      return true;
    }
  }
  return false;
}

bool Misfit::Evaluate(const double* const* parameters, double* residuals,
                      double** jacobians) const {
  const std::size_t count = model_.parameters().size();
  const std::vector<double> coordinates(parameters[0], parameters[0] + count);
  try {
    const auto answer = too_far(coordinates) ? std::nullopt : fitted(coordinates);
    if (!answer) {
      return false;
    }
    for (std::size_t row = 0; row < answer->size(); ++row) {
      residuals[row] = (data_.values[row] - (*answer)[row]) / size_;
    }
    if (jacobians == nullptr || jacobians[0] == nullptr) {
      return true;
    }
    const auto columns = derivatives(coordinates);
    if (!columns) {
      return false;
    }
    for (std::size_t row = 0; row < data_.values.size(); ++row) {
      for (std::size_t i = 0; i < count; ++i) {
        jacobians[0][row * count + i] = -(*columns)[i][row] / size_;
      }
    }
    return true;
  } catch (...) { // exceptions must not pass through Ceres
    failure_ = std::current_exception();
    return false;
  }
}

void Misfit::rethrow() const {
  if (failure_) {
    std::rethrow_exception(failure_);
  }
}

} // namespace ionskin::study
