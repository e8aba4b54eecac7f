// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/shear/shear_measure.hpp"

#include "ionskin/laws/named_row.hpp"
#include "ionskin/laws/shear/deviatoric_shear.hpp"
#include "ionskin/laws/shear/off_diagonal_shear.hpp"
#include "ionskin/laws/shear/signed_xz_shear.hpp"

#include <cstddef>
#include <string>

namespace ionskin::laws {
namespace {

template <class Measure> ShearMeasure shear_row(std::string_view name) {
  return {name, Measure::formula, Measure::at};
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
  std::vector<double> shear(component[0].size());
  for (std::size_t i = 0; i < shear.size(); ++i) {
    shear[i] = measure.at({component[0][i], component[1][i], component[2][i], component[3][i],
                           component[4][i], component[5][i]});
  }
  return shear;
}

} // namespace ionskin::laws
