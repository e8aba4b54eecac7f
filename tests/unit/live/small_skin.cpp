// SPDX-License-Identifier: Apache-2.0
#include "small_skin.hpp"

#include <cmath>

namespace ionskin::live {

SkinData small_skin() {
  constexpr std::size_t cells = 4, size = 3 * cells, points = 2, levels = 2;
  SkinData data;
  data.case_text = "title = \"small\"\n";
  data.version = "test";
  data.friction_law = "coulomb";
  data.friction = data.lowest_friction = data.highest_friction = 0.3;
  data.cell_lines_x = {-2e-3, -1e-3, 0, 1e-3, 2e-3};
  data.cell_lines_y = {-5e-4, 5e-4};
  data.area.assign(cells, 1e-6);
  data.gap = {1e-7, 0, 0, 1e-7};
  data.compliance.lines_x = {1e-3, 5e-3};
  data.compliance.lines_y = {1e-3};
  data.compliance.amplitude = {-0.01, 0.01};
  for (int mode = 0; mode < 2; ++mode) {
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t j = 0; j < size; ++j) {
        const double distance = std::abs(static_cast<double>(i / 3) - static_cast<double>(j / 3));
        data.compliance.values.push_back(
            static_cast<float>(i % 3 == j % 3 ? 1e-7 / (1 + 3 * distance) : 0));
      }
    }
  }
  data.stiffness = 1e7;
  data.direction = {1, 0};
  data.length = 6e-3;
  data.width = 2e-3;
  data.thickness = 1e-4;
  ChannelMap& channel = data.channels.emplace_back();
  channel.rows_per_point = 2;
  channel.strain = {{1e-3, 5e-3}, {1e-3}, {}, {}};
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t row = 0; row < 2 * points; ++row) {
      channel.strain.values.push_back(i % 3 == 1 + row % 2 && i / 6 == row / 2 ? 1e-3f : 0.0f);
    }
  }
  channel.fit = {1, 0, 0, 1};
  channel.field = {1, 0, 0.5, 0, 0, 1, 0, 0.5}; // [mode][level][column]
  channel.x_edges = {-1e-3, 0, 1e-3};
  channel.y_edges = {-1e-3, 1e-3};
  channel.mean = {5e-5, 5e-5};
  channel.moment = {-1e-5, 1e-5};
  data.rates = {5, 100};
  data.whole = {levels, {2, 1, 1, 2}, {-1, 0, 0, -0.5, 0, -1, -0.5, 0}};
  data.part = data.whole;
  data.spread = {6, 2, {1, 2, 3, 0, 5}, {0, 0, 1, 1, 0}, {2, 7, 20, 11, 30}, {0.5, -0.2}};
  data.taxels = {"left", "right"};
  data.taxel_corners = {0, 0, 3e-3, 2e-3, 3e-3, 0, 6e-3, 2e-3};
  data.lowest_place = {1e-3, 1e-3};
  data.highest_place = {5e-3, 1e-3};
  data.heaviest_force = 20;
  data.deepest_indentation = 1e-6;
  data.fastest = 0.1;
  data.errors = {{"charge_top", 1e-9, 2e-9, 1e-7}};
  return data;
}

} // namespace ionskin::live
