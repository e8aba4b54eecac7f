// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/slider/elastic_pad.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <cmath>
#include <cstddef>

namespace ionskin::mechanics {
namespace {

/// Waves shorter than the thickness over this do not feel the rigid body: exp(-2 depth) is left.
constexpr double deepest = 20;
/// Beyond this many thicknesses nothing of a force is felt but what rounding leaves.
constexpr double farthest = 40;
constexpr std::size_t table_intervals = 1600;
constexpr int panels = 160; ///< each holds at most 5 units of the argument of a Bessel function

} // namespace

WaveCompliance wave_compliance(double depth, double poissons_ratio) {
  const double nu = poissons_ratio;
  if (depth > deepest) {
    return {1 - nu, 1 - nu, 1, (1 - 2 * nu) / 2};
  }
  const double s = std::sinh(depth), c = std::cosh(depth);
  const double denominator = (3 - 4 * nu) * c * c + depth * depth + (1 - 2 * nu) * (1 - 2 * nu);
  return {(1 - nu) * ((3 - 4 * nu) * s * c - depth) / denominator,
          (1 - nu) * ((3 - 4 * nu) * s * c + depth) / denominator, s / c,
          ((1 - 2 * nu) * (3 - 4 * nu) * s * s - depth * depth) / (2 * denominator)};
}

PadStiffening::PadStiffening(double poissons_ratio) : poissons_ratio_(poissons_ratio) {
  using Rule = boost::math::quadrature::gauss<double, 10>;
  const WaveCompliance deep = wave_compliance(2 * deepest, poissons_ratio);
  table_.resize(table_intervals + 1);
  const auto add = [&](double depth, double weight) {
    const WaveCompliance wave = wave_compliance(depth, poissons_ratio);
    const double normal = weight * (deep.normal - wave.normal);
    const double along = deep.along - wave.along, across = deep.across - wave.across;
    const double isotropic = weight * (along + across) / 2;
    const double deviatoric = -weight * (along - across) / 2;
    const double mixed = weight * (deep.mixed - wave.mixed);
    for (std::size_t i = 0; i <= table_intervals; ++i) {
      const double argument = depth * farthest * static_cast<double>(i) / table_intervals;
      const double j0 = ::j0(argument), j1 = ::j1(argument);
      // 2 J1(x)/x - J0(x)
      const double j2 = argument < 1e-4 ? argument * argument / 8 : 2 * j1 / argument - j0;
      table_[i].normal += normal * j0;
      table_[i].isotropic += isotropic * j0;
      table_[i].deviatoric += deviatoric * j2;
      table_[i].radial += mixed * j1;
    }
  };
  constexpr double half_panel = deepest / panels / 2;
  for (int panel = 0; panel < panels; ++panel) {
    const double middle = (2 * panel + 1) * half_panel;
    for (std::size_t k = 0; k < Rule::abscissa().size(); ++k) {
      for (const double sign : {1.0, -1.0}) {
        add(middle + sign * half_panel * Rule::abscissa()[k], half_panel * Rule::weights()[k]);
      }
    }
  }
}

PadStiffening::Values PadStiffening::half_space(double distance) const {
  return {(1 - poissons_ratio_) / distance, (2 - poissons_ratio_) / 2 / distance,
          poissons_ratio_ / 2 / distance, (1 - 2 * poissons_ratio_) / 2 / distance};
}

PadStiffening::Values PadStiffening::at(double distance) const {
  constexpr double spacing = farthest / table_intervals;
  if (distance >= farthest) {
    return half_space(distance); // the layer is at rest there
  }
  const auto i = static_cast<std::size_t>(distance / spacing);
  const double t = distance / spacing - static_cast<double>(i);
  const Values &a = table_[i], &b = table_[i + 1];
  return {a.normal + t * (b.normal - a.normal), a.isotropic + t * (b.isotropic - a.isotropic),
          a.deviatoric + t * (b.deviatoric - a.deviatoric), a.radial + t * (b.radial - a.radial)};
}

} // namespace ionskin::mechanics
