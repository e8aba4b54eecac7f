// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/reference_element.hpp"

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_tools.h>

namespace ionskin::mechanics {
namespace {

ReferenceElement build() {
  const dealii::FE_Q<3> shape(2);
  const std::vector<unsigned int> hierarchic =
      dealii::FETools::lexicographic_to_hierarchic_numbering<3>(2);
  ReferenceElement result;
  const dealii::QGauss<3> exact(3);
  for (unsigned int q = 0; q < exact.size(); ++q) {
    for (int i = 0; i < element_nodes; ++i) {
      const auto gradient_i = shape.shape_grad(hierarchic[i], exact.point(q));
      for (int j = 0; j < element_nodes; ++j) {
        const auto gradient_j = shape.shape_grad(hierarchic[j], exact.point(q));
        for (int r = 0; r < 3; ++r) {
          for (int s = 0; s < 3; ++s) {
            result.gradient_product[r][s][i][j] += exact.weight(q) * gradient_i[r] * gradient_j[s];
          }
        }
      }
    }
  }
  return result;
}

} // namespace

const ReferenceElement& reference_element() {
  static const ReferenceElement element = build();
  return element;
}

} // namespace ionskin::mechanics
