// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/history/core_history.hpp"

namespace ionskin::results {

/// A skin of 3 x 2 mm with a core of 0.2 mm between two electrodes.
inline Skin example_skin() {
  Skin skin;
  skin.length = 3e-3;
  skin.width = 2e-3;
  skin.layers = {{"bottom", LayerRole::electrode, {}, 1e-5},
                 {"core", LayerRole::core, {}, 2e-4},
                 {"top", LayerRole::electrode, {}, 1e-5}};
  return skin;
}

/// Four samples on 3 x 1 columns and 2 nodes; the first and the last share their field.
inline history::CoreHistory example_history(history::Frame frame) {
  history::CoreHistory history;
  history.frame = frame;
  history.measure = "off-diagonal";
  history.length = 3e-3;
  history.width = 2e-3;
  history.time = {0, 0.5, 0.75, 2};
  history.event_time = {0, 0.5};
  history.grid.z_nodes = {0, 2e-4};
  if (frame == history::Frame::skin) {
    history.grid.x_edges = {0, 1e-3, 2e-3, 3e-3};
    history.grid.y_edges = {0, 2e-3};
  } else {
    history.grid.x_edges = {-2e-3, -1e-3, 1e-3, 2e-3};
    history.grid.y_edges = {-1e-3, 1e-3};
    history.slider_x = {1e-3, 1e-3, 1.5e-3, 2e-3};
  }
  const auto rest = std::make_shared<history::StrainField>(6, 0.0);
  history.shear() = {
      rest, std::make_shared<history::StrainField>(history::StrainField{1, 2, 3, 4, 5, 6}),
      std::make_shared<history::StrainField>(history::StrainField{6, 5, 4, 3, 2, -1}), rest};
  return history;
}

} // namespace ionskin::results
