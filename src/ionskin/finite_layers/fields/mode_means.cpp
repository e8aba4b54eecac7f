// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/fields/mode_means.hpp"

#include <cstddef>

namespace ionskin::finite_layers {
namespace {

/// Cosine and sine of consecutive multiples of angles by recurrence: each pair is the pair before
/// turned by one step, so that no trigonometric function is called.
struct Turning {
  Eigen::ArrayXd cosine, sine, step_cosine, step_sine;

  Turning(const Eigen::ArrayXd& angle, double first)
      : cosine((first * angle).cos()), sine((first * angle).sin()), step_cosine(angle.cos()),
        step_sine(angle.sin()) {}

  void turn() {
    for (Eigen::Index i = 0; i < cosine.size(); ++i) {
      const double next = cosine(i) * step_cosine(i) - sine(i) * step_sine(i);
      sine(i) = sine(i) * step_cosine(i) + cosine(i) * step_sine(i);
      cosine(i) = next;
    }
  }
};

} // namespace

ModeTransform mode_means(const std::vector<Interval>& places, double step, Eigen::Index modes,
                         double first) {
  const auto count = static_cast<Eigen::Index>(places.size());
  Eigen::ArrayXd middle(count), half(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Interval& place = places[static_cast<std::size_t>(i)];
    middle(i) = step * place.middle();
    half(i) = 0.5 * step * place.size();
  }
  ModeTransform result{Eigen::ArrayXXd(count, modes), Eigen::ArrayXXd(count, modes)};
  Turning at(middle, first);
  for (Eigen::Index mode = 0; mode < modes; ++mode) {
    result.cosine.col(mode) = at.cosine;
    result.sine.col(mode) = at.sine;
    at.turn();
  }
  if ((half > 0).any()) { // mean over an interval: value at its middle times sin(k half)/(k half)
    Turning at_half(half, first);
    for (Eigen::Index mode = 0; mode < modes; ++mode) {
      const double number = first + static_cast<double>(mode);
      const Eigen::ArrayXd mean = (number * half > 0).select(at_half.sine / (number * half), 1.0);
      result.cosine.col(mode) *= mean;
      result.sine.col(mode) *= mean;
      at_half.turn();
    }
  }
  return result;
}

} // namespace ionskin::finite_layers
