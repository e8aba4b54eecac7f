// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/faces/mode_sum.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace ionskin::finite_layers {
namespace {

/// Limits of the integration panels, as the logarithm of the mode number over its value where the
/// integral begins.
constexpr std::array<double, 5> panels{0, 1.2, 3.0, 5.5, 8.5};

} // namespace

std::vector<Parity> parities(bool mirrored) {
  return mirrored ? std::vector{Parity::even} : std::vector{Parity::even, Parity::odd};
}

double fading_share(double wave_number, double full) {
  const double t = std::clamp((fading_end - wave_number / full) / (fading_end - 1), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

std::vector<ModeTerm> mode_sum(Parity parity, int one_by_one) {
  using Rule = boost::math::quadrature::gauss<double, 8>;
  std::vector<ModeTerm> terms;
  int n = parity == Parity::even ? 0 : 1;
  for (; n <= one_by_one; n += 2) {
    terms.push_back({static_cast<double>(n), n == 0 ? 1.0 : 2.0});
  }
  const double first = n - 1; // the interval of the first term in the integral begins here
  for (std::size_t panel = 0; panel + 1 < panels.size(); ++panel) {
    const double middle = 0.5 * (panels[panel] + panels[panel + 1]);
    const double half = 0.5 * (panels[panel + 1] - panels[panel]);
    for (std::size_t i = 0; i < Rule::abscissa().size(); ++i) {
      for (const double sign : {1.0, -1.0}) {
        const double number = first * std::exp(middle + sign * half * Rule::abscissa()[i]);
        // Only every second number occurs, with weight 2.
        terms.push_back({number, half * Rule::weights()[i] * number});
      }
    }
  }
  const double last = first * std::exp(panels.back());
  terms.push_back({last, last}); // the integral of last^2/n^2 from there on
  return terms;
}

} // namespace ionskin::finite_layers
