// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/equations/space_charge.hpp"
#include "ionskin/electrochemistry/grid/derived_scales.hpp"
#include "ionskin/electrochemistry/grid/transport_grid.hpp"
#include "model_cases.hpp"

namespace ionskin::electrochemistry::test {

/// Core of two columns without shear, and the parts of a run that stand on it.
struct RestingCore {
  TransportGrid two_columns() const {
    TransportGrid whole = make_transport_grid(input, history);
    whole.x_edges = {0.0, 0.5 * history.length, history.length};
    return whole;
  }
  /// Ions at rest in a field that falls from `top` to 0 through the thickness, in both columns.
  IonState polarised(double top) const { return polarised(top, top); }
  /// Ions at rest below top potentials that differ between the columns.
  IonState polarised(double first, double second) const {
    IonState ions(grid.nodes());
    for (std::size_t i = 0; i < grid.nodes(); ++i) {
      ions.concentration()[i] = 1.0;
      ions.potential()[i] = grid.position[i / 2] * (i % 2 == 0 ? first : second);
    }
    return ions;
  }

  Case input = verification::model_case();
  history::CoreHistory history = verification::linear_step_history(0.0, 0.0, {0.0, 10.0});
  TransportGrid transport_grid = two_columns();
  DerivedScales scales = derive_scales(input.electrochemistry, history.core_thickness());
  ScaledGrid grid = scale_grid(transport_grid, scales.debye_length);
  FixedCharge fixed_charge{input, history, transport_grid, grid};
};

} // namespace ionskin::electrochemistry::test
