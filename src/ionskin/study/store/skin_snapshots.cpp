// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/store/skin_snapshots.hpp"

#include "ionskin/handover/contact_timeline.hpp"
#include "ionskin/handover/surface_instant.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>

namespace ionskin::study {
namespace {

using Vector = handover::SurfaceInstant::Vector; // normal downwards, along x, along y

/// Components of cell vectors along x, y and upwards; a half model is completed by its mirror image
/// in y.
/// @param columns number of contact cells along x
/// @param half true if the cells are those of a half model
std::array<std::vector<double>, 3> components(const std::vector<Vector>& cells, std::size_t columns,
                                              bool half) {
  constexpr std::array<std::size_t, 3> from{1, 2, 0};
  constexpr std::array<double, 3> sign{1, 1, -1}, mirror{1, -1, 1};
  const std::size_t rows = cells.size() / columns;
  std::array<std::vector<double>, 3> result;
  for (std::size_t c = 0; c < 3; ++c) {
    for (const Vector& cell : cells) {
      result[c].push_back(sign[c] * cell[from[c]]);
    }
    for (std::size_t row = rows; half && row > 0; --row) {
      for (std::size_t column = 0; column < columns; ++column) {
        result[c].push_back(mirror[c] * result[c][(row - 1) * columns + column]);
      }
    }
  }
  return result;
}

std::vector<double> shifted(std::vector<double> lines, double centre) {
  for (double& line : lines) {
    line += centre;
  }
  return lines;
}

/// Cell lines of a half model, which end at 0, followed by their mirror images [m].
std::vector<double> with_mirror_image(std::vector<double> lines) {
  for (std::size_t i = lines.size() - 1; i > 0; --i) {
    lines.push_back(-lines[i - 1]);
  }
  return lines;
}

} // namespace

std::vector<double> field_instants(const Case& input) {
  const std::set<double> instants(input.output.fields.begin(), input.output.fields.end());
  return {instants.begin(), instants.end()};
}

mechanics::LayerStrainAt layer_strains(const mechanics::ContactSolution& contact) {
  const auto touching = std::ranges::find_if(
      contact.stepped, [](const auto& instant) { return instant.state != nullptr; });
  return touching == contact.stepped.end() ? nullptr : touching->state->source->all_layers();
}

results::SkinSnapshot skin_snapshot(const Case& input, const mechanics::ContactSolution& contact,
                                    const mechanics::LayerStrainAt& strain, double time) {
  const handover::ContactTimeline timeline(input, contact);
  const std::vector<double> areas = handover::cell_areas(contact);
  const std::size_t columns = contact.cell_lines_x.size() - 1;
  const bool half = contact.mesh.half_model();
  const auto state = timeline.at(std::fmod(time, input.motion.cycle_duration()));
  handover::SurfaceInstant surface = handover::surface_instant(state, areas);
  for (std::size_t cell = 0; cell < areas.size(); ++cell) {
    for (double& force : surface.force[cell]) {
      force /= areas[cell];
    }
  }
  return {time,
          handover::skin_deformation(input.skin, contact.mesh, state, strain),
          state.centre,
          state.height,
          shifted(contact.cell_lines_x, state.centre[0]),
          shifted(half ? with_mirror_image(contact.cell_lines_y) : contact.cell_lines_y,
                  state.centre[1]),
          components(surface.force, columns, half),
          components(surface.surface, columns, half)};
}

} // namespace ionskin::study
