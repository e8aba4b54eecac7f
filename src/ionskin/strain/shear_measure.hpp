// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <array>
#include <string_view>
#include <vector>

namespace ionskin::strain {

/// Equivalent shear strain of the paper, its equation (10):
///   gamma = 2 sqrt(exy^2 + eyz^2 + exz^2)
/// from the off-diagonal tensor components of the small strain; never negative. It depends on the
/// choice of axes: a pure stretch at 45 degrees counts, the same stretch along an axis does not.
/// @param strain xx, yy, zz, yz, xz, xy [1]
double off_diagonal_shear(const std::array<double, 6>& strain);

/// The measure's name in case files and strain files.
std::string_view name(ShearMeasure measure);

/// The measure at each point of a strain field.
/// @param component six components as in `mechanics::CoreStrain`, each [points]
void evaluate_shear(ShearMeasure measure, const std::array<std::vector<double>, 6>& component,
                    std::vector<double>& shear);

} // namespace ionskin::strain
