// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/sheet_impedance.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <numbers>

namespace ionskin::electrochemistry {
namespace {

using Complex = std::complex<double>;

/// Number of shapes of the current along a lead; number of waves that are summed one by one, and
/// number in the limit in which waves decay within the metal.
constexpr std::size_t shapes = 6, waves = 400, static_waves = 100'000;

Complex coth(Complex x) {
  return 1.0 / std::tanh(x);
}

/// Integral of the cosine of wave number k times T_2s(y/w)/sqrt(1 - (y/w)^2) over 0 < y < w, over
/// w.
/// @param shape s
/// @param phase k w
double share(std::size_t shape, double phase) {
  const double sign = shape % 2 == 0 ? 1.0 : -1.0;
  return 0.5 * std::numbers::pi * sign * std::cyl_bessel_j(2.0 * static_cast<double>(shape), phase);
}

} // namespace

SheetImpedance::SheetImpedance(const Case& input)
    : length_(input.skin.length), width_(input.skin.width), contact_(input.readout.contact) {
  if (!input.has_sheet_resistance()) {
    return;
  }
  const std::array<double, 2> resistances = input.skin.sheet_resistances();
  resistance_ = resistances[0] + resistances[1];
  if (contact_ != ElectrodeContact::corner) {
    return;
  }
  shares_.resize(shapes);
  static_.assign(shapes * shapes, 0.0);
  std::array<double, shapes> here{};
  for (std::size_t n = 0; n < static_waves; ++n) {
    const double phase = static_cast<double>(n) * std::numbers::pi;
    for (std::size_t s = 0; s < shapes; ++s) {
      here[s] = share(s, corner_share * phase);
    }
    if (n < waves) {
      waves_.push_back(phase / width_);
      for (std::size_t s = 0; s < shapes; ++s) {
        shares_[s].push_back(here[s]);
      }
    }
    for (std::size_t i = 0; n > 0 && i < shapes * shapes; ++i) {
      static_[i] += here[i / shapes] * here[i % shapes] * width_ / phase;
    }
  }
}

Complex SheetImpedance::area_impedance(Complex cell) const {
  if (resistance_ == 0) {
    return cell;
  }
  if (contact_ == ElectrodeContact::corner) {
    return of_corner(cell);
  }
  const double reach = contact_ == ElectrodeContact::both_ends ? 0.5 * length_ : length_;
  return reach * std::sqrt(resistance_ * cell) * coth(reach * std::sqrt(resistance_ / cell));
}

// Galerkin's method: the potential along the lead, weighted by every shape, is that of the lead.
Complex SheetImpedance::of_corner(Complex cell) const {
  constexpr auto count = static_cast<Eigen::Index>(shapes);
  Eigen::MatrixXcd potentials(count, count);
  for (std::size_t i = 0; i < shapes; ++i) {
    for (std::size_t j = 0; j < shapes; ++j) {
      Complex sum = 2.0 * static_[i * shapes + j];
      for (std::size_t n = 0; n < waves; ++n) {
        const Complex decay = std::sqrt(waves_[n] * waves_[n] + resistance_ / cell);
        const Complex answer = coth(decay * length_) / decay;
        sum += shares_[i][n] * shares_[j][n] * (n == 0 ? answer : 2.0 * (answer - 1.0 / waves_[n]));
      }
      potentials(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = sum;
    }
  }
  Eigen::VectorXcd lead = Eigen::VectorXcd::Zero(count);
  lead(0) = 0.5 * std::numbers::pi;
  const Complex current = lead.dot(potentials.partialPivLu().solve(lead)); // by potential
  return resistance_ * length_ / current;
}

} // namespace ionskin::electrochemistry
