// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/fields/mode_means.hpp"

#include <cstddef>

namespace ionskin::finite_layers {

ModeTransform mode_means(const std::vector<Interval>& places, double step, Eigen::Index modes,
                         double first) {
  const auto count = static_cast<Eigen::Index>(places.size());
  Eigen::ArrayXd middle(count), half(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Interval& place = places[static_cast<std::size_t>(i)];
    middle(i) = place.middle();
    half(i) = 0.5 * place.size();
  }
  // Each mode is the one before turned by one step: no function is called for it.
  const Eigen::ArrayXd cosine = (step * middle).cos(), sine = (step * middle).sin();
  const Eigen::ArrayXd cosine_half = (step * half).cos(), sine_half = (step * half).sin();
  Eigen::ArrayXd c = (first * step * middle).cos(), s = (first * step * middle).sin(),
                 c_half = (first * step * half).cos(), s_half = (first * step * half).sin();
  ModeTransform result{Eigen::ArrayXXd(count, modes), Eigen::ArrayXXd(count, modes)};
  const auto turn = [](Eigen::ArrayXd& cos, Eigen::ArrayXd& sin, const Eigen::ArrayXd& by_cos,
                       const Eigen::ArrayXd& by_sin) {
    const Eigen::ArrayXd next = cos * by_cos - sin * by_sin;
    sin = sin * by_cos + cos * by_sin;
    cos = next;
  };
  for (Eigen::Index mode = 0; mode < modes; ++mode) {
    const Eigen::ArrayXd phase = ((first + static_cast<double>(mode)) * step) * half;
    const Eigen::ArrayXd mean = (phase > 0).select(s_half / phase, 1.0);
    result.cosine.col(mode) = mean * c;
    result.sine.col(mode) = mean * s;
    turn(c, s, cosine, sine);
    turn(c_half, s_half, cosine_half, sine_half);
  }
  return result;
}

} // namespace ionskin::finite_layers
