// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mechanics/output/core_strain.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace ionskin::live {

/// Rows over the components xx, yy, zz, yz, xz, xy of a strain, whose norm is a channel of the
/// core, or the one row that it is.
using MeasureRows = std::vector<std::array<double, 6>>;

/// The channel's value at a strain.
double value_of(const MeasureRows& rows, const std::array<double, 6>& strain);

/// Components of the strain at a point; 0 where no channel reads one.
std::array<double, 6> strain_at(const mechanics::CoreStrain& strain, std::size_t point);

/// Rows of a channel: dilation, or the shear measure of the case. Throws UserError for a measure
/// that is neither linear in the strain nor the root of a quadratic form of it.
MeasureRows measure_rows(const Case& input, const std::string& channel);

} // namespace ionskin::live
