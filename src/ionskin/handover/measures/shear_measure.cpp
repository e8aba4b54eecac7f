// SPDX-License-Identifier: Apache-2.0
#include "ionskin/handover/measures/shear_measure.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/handover/measures/deviatoric_shear.hpp"
#include "ionskin/handover/measures/off_diagonal_shear.hpp"
#include "ionskin/handover/measures/signed_xz_shear.hpp"

namespace ionskin::handover {
namespace {

using PointMeasure = double (*)(const std::array<double, 6>&);

PointMeasure at_point(ShearMeasure measure) {
  switch (measure) {
  case ShearMeasure::off_diagonal:
    return off_diagonal_shear;
  case ShearMeasure::deviatoric:
    return deviatoric_shear;
  case ShearMeasure::signed_xz:
    return signed_xz_shear;
  }
  throw InternalError("unknown shear measure");
}

} // namespace

std::string_view name(ShearMeasure measure) {
  switch (measure) {
  case ShearMeasure::off_diagonal:
    return "off-diagonal";
  case ShearMeasure::deviatoric:
    return "deviatoric";
  case ShearMeasure::signed_xz:
    return "signed-xz";
  }
  throw InternalError("unknown shear measure");
}

void evaluate_shear(ShearMeasure measure, const std::array<std::vector<double>, 6>& component,
                    std::vector<double>& shear) {
  const PointMeasure evaluate = at_point(measure);
  shear.resize(component[0].size());
  for (std::size_t i = 0; i < shear.size(); ++i) {
    shear[i] = evaluate({component[0][i], component[1][i], component[2][i], component[3][i],
                         component[4][i], component[5][i]});
  }
}

} // namespace ionskin::handover
