// SPDX-License-Identifier: Apache-2.0
#include "ionskin/poroelasticity/pore_pressure.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ionskin::poroelasticity {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

Eigen::Map<const RowMajor> view(const double* values, std::size_t rows, std::size_t columns) {
  return {values, static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns)};
}
Eigen::Map<RowMajor> view(double* values, std::size_t rows, std::size_t columns) {
  return {values, static_cast<Eigen::Index>(rows), static_cast<Eigen::Index>(columns)};
}

/// Multiplies a square matrix [size][size] with a field [outer][size][inner] along its middle
/// index.
void apply(const std::vector<double>& matrix, std::size_t size, std::size_t outer,
           std::size_t inner, const double* field, double* result) {
  const auto operation = view(matrix.data(), size, size);
  if (inner == 1) {
    view(result, outer, size).noalias() = view(field, outer, size) * operation.transpose();
    return;
  }
  for (std::size_t o = 0; o < outer; ++o) {
    view(result + o * size * inner, size, inner).noalias() =
        operation * view(field + o * size * inner, size, inner);
  }
}

/// Mean of exp(-a s) over s from 0 to 1: (1 - exp(-a))/a, and 1 at a = 0.
double mean_decay(double a) {
  return a < 1e-8 ? 1.0 - 0.5 * a : -std::expm1(-a) / a;
}

} // namespace

PorePressure::PorePressure(const std::array<std::size_t, 2>& columns,
                           const std::array<double, 2>& widths, std::vector<double> nodes,
                           const WaterWalls& walls, double consolidation_coefficient,
                           double held_share, const Relaxation& relaxation)
    : x_(cosine_modes(columns[0], widths[0])), y_(cosine_modes(columns[1], widths[1])),
      z_(wall_modes(nodes, walls, held_share)), nodes_(std::move(nodes)) {
  const std::size_t terms = relaxation.terms();
  for (std::vector<double>* const of_terms : {&rate_, &pressure_weight_, &undrained_weight_}) {
    of_terms->resize(terms * values());
  }
  std::size_t mode = 0;
  for (const double z : z_.curvature) {
    for (const double y : y_.curvature) {
      for (const double x : x_.curvature) {
        const StepResponse response =
            step_response(relaxation, consolidation_coefficient * (x + y + z));
        for (std::size_t j = 0; j < terms; ++j) {
          rate_[j * values() + mode] = response.rate[j];
          pressure_weight_[j * values() + mode] = response.pressure[j];
          undrained_weight_[j * values() + mode] = response.undrained[j];
        }
        undrained_directly_ = response.undrained_directly;
        ++mode;
      }
    }
  }
  first_.resize(values());
  second_.resize(values());
}

void PorePressure::to_modes(std::span<const double> field, std::vector<double>& modes) {
  modes.resize(values());
  apply(x_.to_modes, x_.size, z_.size * y_.size, 1, field.data(), first_.data());
  apply(y_.to_modes, y_.size, z_.size, x_.size, first_.data(), second_.data());
  apply(z_.to_modes, z_.size, 1, x_.size * y_.size, second_.data(), modes.data());
}

void PorePressure::from_modes(const std::vector<double>& modes, std::vector<double>& field) {
  field.resize(values());
  apply(z_.from_modes, z_.size, 1, x_.size * y_.size, modes.data(), second_.data());
  apply(y_.from_modes, y_.size, z_.size, x_.size, second_.data(), first_.data());
  apply(x_.from_modes, x_.size, z_.size * y_.size, 1, first_.data(), field.data());
}

void PorePressure::sum_terms(const PressureState& state, const std::vector<double>& weights,
                             std::vector<double>& modes) const {
  modes.assign(values(), 0.0);
  for (std::size_t begin = 0; begin < weights.size(); begin += values()) {
    for (std::size_t m = 0; m < values(); ++m) {
      modes[m] += weights[begin + m] * state.pressure[begin + m];
    }
  }
}

void PorePressure::start(std::span<const double> undrained, PressureState& state) {
  to_modes(undrained, state.undrained);
  state.pressure.clear();
  while (state.pressure.size() < rate_.size()) {
    state.pressure.insert(state.pressure.end(), state.undrained.begin(), state.undrained.end());
  }
}

void PorePressure::step(const PressureState& begin, double duration,
                        std::span<const double> undrained, PressureState& end) {
  to_modes(undrained, end.undrained);
  end.pressure.resize(rate_.size());
  for (std::size_t first = 0; first < rate_.size(); first += values()) {
    for (std::size_t m = 0; m < values(); ++m) {
      const double a = rate_[first + m] * duration;
      end.pressure[first + m] = std::exp(-a) * begin.pressure[first + m] +
                                mean_decay(a) * (end.undrained[m] - begin.undrained[m]);
    }
  }
}

void PorePressure::pressure(const PressureState& state, std::vector<double>& out) {
  sum_terms(state, pressure_weight_, sum_);
  from_modes(sum_, out);
}

void PorePressure::undrained(const PressureState& state, std::vector<double>& out) {
  sum_terms(state, undrained_weight_, sum_);
  for (std::size_t m = 0; m < values(); ++m) {
    sum_[m] += undrained_directly_ * state.undrained[m];
  }
  from_modes(sum_, out);
}

} // namespace ionskin::poroelasticity
