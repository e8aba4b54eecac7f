// SPDX-License-Identifier: Apache-2.0
#include "ionskin/circuits/noise_of_mean.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ionskin::circuits {
namespace {

/// Number of lobes of the squared sine that are integrated one by one; beyond them its mean, 1/2,
/// replaces it.
constexpr int lobes = 16;
/// Upper end of the integral in x = f T, over the larger of `lobes` and of B T, the number of
/// periods of the low pass within an interval: faster noise adds less than a part in 1e4.
constexpr double fast = 1e4;

template <class Function> double integrate(const Function& function, double from, double to) {
  return boost::math::quadrature::gauss<double, 7>::integrate(function, from, to);
}

/// Integrates over equal parts of the logarithm, two to a decade; 0 where `to` is not above `from`.
template <class Function>
double integrate_decades(const Function& function, double from, double to) {
  if (!(to > from)) {
    return 0.0;
  }
  const auto parts = static_cast<int>(std::ceil(2 * std::log10(to / from)));
  const auto by_logarithm = [&](double logarithm) {
    const double at = std::exp(logarithm);
    return at * function(at);
  };
  const double low = std::log(from), step = (std::log(to) - low) / parts;
  double sum = 0;
  for (int i = 0; i < parts; ++i) {
    sum += integrate(by_logarithm, low + i * step, low + (i + 1) * step);
  }
  return sum;
}

} // namespace

double noise_of_mean(const std::function<double(double frequency)>& density,
                     const Averaging& averaging) {
  const double interval = averaging.interval;
  // All integrands are functions of x = f T, the number of periods within an interval.
  const auto passed = [&](double x) {
    const double slowness = x / (interval * averaging.bandwidth);
    return density(x / interval) / (1 + slowness * slowness);
  };
  const auto seen = [&](double x) {
    const double angle = std::numbers::pi * x, sinc = std::sin(angle) / angle;
    return passed(x) * sinc * sinc;
  };
  const auto seen_on_average = [&](double x) {
    const double angle = std::numbers::pi * x;
    return passed(x) / (2 * angle * angle);
  };
  double sum = integrate_decades(seen, std::min(1.0, interval / averaging.record), 1.0);
  for (int lobe = 1; lobe < lobes; ++lobe) {
    sum += integrate(seen, lobe, lobe + 1);
  }
  sum += integrate_decades(seen_on_average, lobes,
                           fast * std::max<double>(lobes, interval * averaging.bandwidth));
  return std::sqrt(sum / interval);
}

} // namespace ionskin::circuits
