// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/shear/shear_measure.hpp"

#include "ionskin/laws/named_row.hpp"
#include "ionskin/laws/shear/deviatoric_shear.hpp"
#include "ionskin/laws/shear/off_diagonal_shear.hpp"
#include "ionskin/laws/shear/signed_xz_shear.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>

namespace ionskin::laws {
namespace {

template <class Measure> ShearMeasure shear_row(std::string_view name) {
  return {name, Measure::formula, Measure::reads, Measure::at};
}

} // namespace

std::span<const ShearMeasure> shear_measures() {
  static const std::array measures{
      shear_row<OffDiagonalShear>("off-diagonal"),
      shear_row<DeviatoricShear>("deviatoric"),
      shear_row<SignedXzShear>("signed-xz"),
  };
  return measures;
}

const ShearMeasure& shear_measure(std::string_view name) {
  return named_row(shear_measures(), name, "shear measure");
}

std::vector<double> evaluate_shear(const ShearMeasure& measure,
                                   const std::array<std::vector<double>, 6>& component) {
  std::size_t points = 0;
  for (const std::vector<double>& own : component) {
    points = std::max(points, own.size());
  }
  std::vector<double> shear(points);
  for (std::size_t i = 0; i < points; ++i) {
    std::array<double, 6> strain{};
    for (std::size_t c = 0; c < strain.size(); ++c) {
      // A measure that reads a component which was not computed gives NaN.
      strain[c] = component[c].empty() ? std::numeric_limits<double>::quiet_NaN() : component[c][i];
    }
    shear[i] = measure.at(strain);
  }
  return shear;
}

} // namespace ionskin::laws
