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

/// A square matrix along the middle index of a field [outer][size][inner].
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

/// (1 - exp(-a))/a, 1 at 0.
double mean_decay(double a) {
  return a < 1e-8 ? 1.0 - 0.5 * a : -std::expm1(-a) / a;
}

} // namespace

PorePressure::PorePressure(const std::array<std::size_t, 2>& columns,
                           const std::array<double, 2>& widths, std::vector<double> nodes,
                           const WaterWalls& walls, double consolidation_coefficient,
                           double held_share)
    : x_(cosine_modes(columns[0], widths[0])), y_(cosine_modes(columns[1], widths[1])),
      z_(wall_modes(nodes, walls, held_share)), nodes_(std::move(nodes)) {
  rate_.reserve(values());
  for (const double z : z_.curvature) {
    for (const double y : y_.curvature) {
      for (const double x : x_.curvature) {
        rate_.push_back(consolidation_coefficient * (x + y + z));
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

void PorePressure::start(std::span<const double> undrained, PressureState& state) {
  to_modes(undrained, state.undrained);
  state.pressure = state.undrained;
}

void PorePressure::step(const PressureState& begin, double duration,
                        std::span<const double> undrained, PressureState& end) {
  to_modes(undrained, end.undrained);
  end.pressure.resize(values());
  for (std::size_t m = 0; m < rate_.size(); ++m) {
    const double a = rate_[m] * duration;
    end.pressure[m] =
        std::exp(-a) * begin.pressure[m] + mean_decay(a) * (end.undrained[m] - begin.undrained[m]);
  }
}

void PorePressure::pressure(const PressureState& state, std::vector<double>& out) {
  out.resize(values());
  apply(z_.from_modes, z_.size, 1, x_.size * y_.size, state.pressure.data(), second_.data());
  apply(y_.from_modes, y_.size, z_.size, x_.size, second_.data(), first_.data());
  apply(x_.from_modes, x_.size, z_.size * y_.size, 1, first_.data(), out.data());
}

} // namespace ionskin::poroelasticity
