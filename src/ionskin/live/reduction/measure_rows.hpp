// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mechanics/output/core_strain.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace ionskin::live {

/// Linear combinations of the strain components xx, yy, zz, yz, xz, xy that define a channel of the
/// core: the channel is the norm of their values, or, if there is only one, its value itself.
using MeasureRows = std::vector<std::array<double, 6>>;

/// Value of the channel at a strain with the components xx, yy, zz, yz, xz, xy [1].
double value_of(const MeasureRows& rows, const std::array<double, 6>& strain);

/// Components xx, yy, zz, yz, xz, xy of the strain at a point; 0 for components that no channel
/// reads and `strain` therefore lacks.
std::array<double, 6> strain_at(const mechanics::CoreStrain& strain, std::size_t point);

/// Combinations that define a channel, by its name: dilation, or the shear measure of the case.
/// Throws UserError for a measure that is neither linear in the strain nor the square root of a
/// quadratic form of it.
MeasureRows measure_rows(const Case& input, const std::string& channel);

} // namespace ionskin::live
