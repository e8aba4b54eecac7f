// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/electrochemistry/circuit/cut_electrode.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"
#include "ionskin/electrochemistry/grid/transport_grid.hpp"

namespace ionskin::electrochemistry {

/// Makes the electrodes of a crossbar, lines that cross: the columns of the top face, then the rows
/// of the bottom face, each a conductor with a circuit to the ground. The segments are the
/// crossings.
/// @param grid transport grid of the whole skin
CutElectrode crossbar(const Case& input, const DerivedScales& scales, const TransportGrid& grid);

} // namespace ionskin::electrochemistry
