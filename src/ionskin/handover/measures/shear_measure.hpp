// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

#include <array>
#include <string_view>
#include <vector>

namespace ionskin::handover {

/// The measure's name in case files and strain files.
std::string_view name(ShearMeasure measure);

/// The measure at each point of a strain field. Every measure is even under a reflection in y, on
/// which the half model relies.
/// @param component six components as in `mechanics::CoreStrain`, each [points]
void evaluate_shear(ShearMeasure measure, const std::array<std::vector<double>, 6>& component,
                    std::vector<double>& shear);

} // namespace ionskin::handover
