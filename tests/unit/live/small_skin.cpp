// SPDX-License-Identifier: Apache-2.0
#include "small_skin.hpp"

#include <algorithm>
#include <array>
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
  channel.fit = {{3e-3}, {1e-3}, {}, {1, 0, 0, 1}};
  channel.field = {1, 0, 0.5, 0, 0, 1, 0, 0.5}; // [mode][level][column]
  channel.x_edges = {-1e-3, 0, 1e-3};
  channel.y_edges = {-1e-3, 1e-3};
  channel.fixed_x_edges = {0, data.length};
  channel.fixed_y_edges = {0, data.width};
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
  data.errors = {{"charge_top", "", 1e-9, 2e-9, 1e-7}, {"charge_top", "hold", 2e-9, 3e-9, 4e-8}};
  return data;
}

SkinData sphere_on_many_cells(std::size_t across) {
  constexpr double width = 1e-4, radius = 8e-3, softness = 1e-10; // displacement [m2/N] by 1/r
  constexpr double heave = 0.3;
  const std::size_t cells = across * across;
  SkinData data = small_skin();
  data.area.assign(cells, width * width);
  data.gap.clear();
  data.cell_lines_x.clear();
  for (std::size_t i = 0; i <= across; ++i) {
    data.cell_lines_x.push_back(width * (static_cast<double>(i) - static_cast<double>(across) / 2));
  }
  data.cell_lines_y = data.cell_lines_x;
  data.stiffness = 1e6;
  data.compliance = {};
  data.compliance.lines_x = {3e-3};
  data.compliance.lines_y = {1e-3};
  data.compliance.values.assign(9 * cells * cells, 0.0f);
  const auto place = [&](std::size_t cell, std::size_t axis) {
    const std::size_t index = axis == 0 ? cell % across : cell / across;
    return width * (static_cast<double>(index) - static_cast<double>(across / 2));
  };
  for (std::size_t i = 0; i < cells; ++i) {
    const double x = place(i, 0), y = place(i, 1);
    data.gap.push_back((x * x + y * y) / (2 * radius));
    for (std::size_t j = 0; j < cells; ++j) {
      const double r = std::hypot(x - place(j, 0), y - place(j, 1));
      const auto at = [&](std::size_t row, std::size_t column) -> float& {
        return data.compliance.values[(3 * i + column) * 3 * cells + 3 * j + row];
      };
      for (std::size_t c = 0; c < 3; ++c) {
        at(c, c) = static_cast<float>(softness / std::max(r, 0.28 * width));
      }
      const std::array<double, 2> away{x - place(j, 0), y - place(j, 1)};
      // A push to the side heaves what lies before it.
      for (std::size_t c = 0; c < 2 && i != j; ++c) {
        at(0, c + 1) = static_cast<float>(heave * softness * away[c] / (r * r));
        at(c + 1, 0) = -at(0, c + 1);
      }
    }
  }
  ChannelMap& channel = data.channels.front();
  channel.strain = {{3e-3}, {1e-3}, {}, std::vector<float>(3 * cells * 4, 0.0f)};
  return data;
}

SkinData sphere_under(const std::string& law) {
  SkinData data = sphere_on_many_cells(9);
  data.lowest_place = {1e-3, 4e-4};
  data.highest_place = {5e-3, 1.6e-3};
  data.deepest_indentation = 2e-5;
  data.friction_law = law;
  if (law == "regularised") {
    data.friction_parameters = {"slip_length"};
    data.friction_values = {1e-6};
  } else if (law == "viscous") {
    data.friction_parameters = {"reference_speed"};
    data.friction_values = {1e-2};
  } else if (law == "stribeck") {
    data.friction_parameters = {"kinetic_friction", "stribeck_speed", "lag_time"};
    data.friction_values = {0.2, 1e-3, 5e-3};
  } else if (law == "anisotropic") {
    data.friction_parameters = {"transverse_friction"};
    data.friction_values = {0.1};
  }
  return data;
}

SkinData turned(SkinData data, std::size_t axis, double angle) {
  const std::size_t columns = data.cell_lines_x.size() - 1;
  for (std::size_t cell = 0; cell < data.gap.size(); ++cell) {
    const auto middle = [&](const std::vector<double>& lines, std::size_t at) {
      return (lines[at] + lines[at + 1]) / 2;
    };
    data.gap[cell] += axis == 0 ? angle * middle(data.cell_lines_y, cell / columns)
                                : -angle * middle(data.cell_lines_x, cell % columns);
  }
  return data;
}

} // namespace ionskin::live
