// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/plane/radial_compliance.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

namespace ionskin::finite_layers {
namespace {

/// Offset over the finest length, for a table that is uniform in ln(r + offset) [1].
constexpr double offset_share = 0.5;
constexpr double intervals_of_distance = 100; ///< intervals of the table per unit of ln(r + offset)
/// Wave number times distance above which waves cancel, as the compliance varies slowly there.
constexpr double cancelling = 120;

/// Compliance of short waves minus the half-space's, times the wave number [1/Pa].
WaveCompliance remainder(const SurfaceCompliance& surface, const WaveSplit& split, double k) {
  const WaveCompliance at = surface.at(k), &half_space = surface.half_space();
  const double share = split.short_share(k) * k;
  return {share * at.normal - half_space.normal, share * at.along - half_space.along,
          share * at.across - half_space.across, share * at.mixed - half_space.mixed};
}

/// Weight of a wave: 1 below `cancelling`, falling smoothly to 0 at twice that value.
/// @param argument wave number times distance [1]
double taper(double argument) {
  const double t = std::clamp(argument / cancelling - 1, 0.0, 1.0);
  return 1 - t * t * t * (10 - t * (15 - 6 * t));
}

/// Calculates the inverse Hankel transforms at a distance: integrals over k of the remainder with
/// the Bessel functions J_0, J_1, J_2 [m/N].
RadialCompliance transform(const SurfaceCompliance& surface, const WaveSplit& split,
                           double distance) {
  using Rule = boost::math::quadrature::gauss<double, 10>;
  constexpr double growth = 1.6;
  const double longest = 1 / std::max(split.reach(), surface.thickness());
  const double last = std::max(surface.half_space_from(), split.last_long());
  const double end = distance > 0 ? std::min(last, 2 * cancelling / distance) : last;
  const double half_wave =
      distance > 0 ? 2 * std::numbers::pi / distance : std::numeric_limits<double>::infinity();
  RadialCompliance sum;
  const auto add = [&](double k, double weight) {
    const double argument = k * distance;
    const WaveCompliance at = remainder(surface, split, k);
    const double j0 = ::j0(argument), j1 = ::j1(argument);
    const double j2 = argument < 1e-4 ? argument * argument / 8 : 2 * j1 / argument - j0;
    const double factor = weight * taper(argument) / (2 * std::numbers::pi);
    sum.normal += factor * at.normal * j0;
    sum.mixed += factor * at.mixed * j1;
    sum.isotropic += factor * 0.5 * (at.along + at.across) * j0;
    sum.deviatoric -= factor * 0.5 * (at.along - at.across) * j2;
  };
  double from = 0;
  while (from < end) {
    const double size = from == 0 ? longest : (growth - 1) * from;
    const double to = std::min({from + size, from + half_wave, end});
    const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
      for (const double sign : {1.0, -1.0}) {
        add(middle + sign * half * Rule::abscissa()[i], half * Rule::weights()[i]);
      }
    }
    from = to;
  }
  return sum;
}

/// Half-space compliance times the distance [m2/N], from the compliance times the wave number
/// [1/Pa].
RadialCompliance over_distance(const WaveCompliance& half_space) {
  const double factor = 1 / (2 * std::numbers::pi);
  return {factor * half_space.normal, factor * half_space.mixed,
          factor * 0.5 * (half_space.along + half_space.across),
          factor * 0.5 * (half_space.across - half_space.along)};
}

} // namespace

PlaneCompliance::PlaneCompliance(const ElasticLayer& material)
    : half_space_(over_distance(half_space_compliance(material))),
      reach_(std::numeric_limits<double>::infinity()), finest_(reach_) {}

PlaneCompliance::PlaneCompliance(const SurfaceCompliance& surface, const WaveSplit& split)
    : half_space_(over_distance(surface.half_space())), reach_(split.reach()),
      finest_(std::min(surface.top_thickness(), 1 / split.last_long())) {
  offset_ = offset_share * finest_;
  const double range = std::log(reach_ / offset_ + 1);
  const auto intervals = static_cast<std::size_t>(std::ceil(intervals_of_distance * range));
  const double step = range / static_cast<double>(intervals);
  Eigen::Array4Xd values(4, static_cast<Eigen::Index>(intervals) + 1);
  for (std::size_t i = 0; i <= intervals; ++i) {
    const double distance = offset_ * std::expm1(step * static_cast<double>(i));
    const RadialCompliance at = transform(surface, split, distance);
    values.col(static_cast<Eigen::Index>(i)) << at.normal, at.mixed, at.isotropic, at.deviatoric;
  }
  table_ = CubicTable(0, step, std::move(values));
}

RadialCompliance PlaneCompliance::difference(double distance) const {
  if (table_.empty()) {
    return {};
  }
  if (distance >= reach_) {
    const double inverse = -1 / distance;
    return {inverse * half_space_.normal, inverse * half_space_.mixed,
            inverse * half_space_.isotropic, inverse * half_space_.deviatoric};
  }
  const CubicTable::Values at = table_.at(std::log1p(distance / offset_));
  return {at(0), at(1), at(2), at(3)};
}

} // namespace ionskin::finite_layers
