// SPDX-License-Identifier: Apache-2.0
#include "ionskin/handover/sliders/fixed_grid.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/mechanics/path/contact_box.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace ionskin::handover {
namespace {

/// Uniform cells per thickness of the skin. Below a slider the strain is taken on the finer mesh
/// that moves with the slider. These cells only need to resolve positions, and the columns of the
/// ion transport, which are as wide as the core is thick, resolve no more.
constexpr double cells_per_thickness = 3;
constexpr double growth = 1.4;
/// Largest number of uniform cells over the positions of one slider. Along longer paths the cells
/// are wider.
constexpr double most_cells = 160;

double preset_factor(Preset preset) {
  switch (preset) {
  case Preset::coarse:
    return 1.7;
  case Preset::standard:
    return 1.0;
  case Preset::fine:
    return 0.75;
  }
  throw InternalError("unknown preset");
}

/// Part of a direction in which a slider may touch.
struct Span {
  double low = 0, high = 0; ///< [m]
  double cell = 0;          ///< width of its cells [m]
};

std::vector<Span> touched_spans(const std::vector<Case>& sliders,
                                const std::vector<const mesh::SkinMesh*>& meshes,
                                std::size_t direction) {
  std::vector<Span> spans;
  for (std::size_t i = 0; i < sliders.size(); ++i) {
    const auto box = mechanics::contact_box(sliders[i]);
    if (!box) {
      continue;
    }
    const double half_size = meshes[i]->footprint().half_size[direction];
    const double low = box->low[direction] - half_size, high = box->high[direction] + half_size;
    spans.push_back({low, high, std::max(fixed_cell_width(sliders[i]), (high - low) / most_cells)});
  }
  return spans;
}

/// Width that a cell should have at a position [m].
double cell_width(double at, const std::vector<Span>& spans, double limit) {
  double width = limit;
  for (const Span& span : spans) {
    const double beside = std::max({0.0, span.low - at, at - span.high});
    width = std::min(width, span.cell + std::log(growth) * beside);
  }
  return width;
}

/// Divides a direction so that every cell holds an equal part of the integral of the inverse width.
std::vector<double> graded_edges(double extent, const std::vector<Span>& spans, double limit) {
  constexpr std::size_t steps = 20000; // of the midpoint rule
  const double step = extent / static_cast<double>(steps);
  std::vector<double> sum(steps + 1, 0.0);
  for (std::size_t i = 0; i < steps; ++i) {
    sum[i + 1] = sum[i] + step / cell_width((static_cast<double>(i) + 0.5) * step, spans, limit);
  }
  const double cells = std::max(1.0, std::ceil(sum.back() - 1e-6));
  std::vector<double> edges{0.0};
  std::size_t i = 0;
  for (double cell = 1; cell < cells; ++cell) {
    const double reached = sum.back() * cell / cells;
    while (sum[i + 1] < reached) {
      ++i;
    }
    const double part = (reached - sum[i]) / (sum[i + 1] - sum[i]);
    edges.push_back((static_cast<double>(i) + part) * step);
  }
  edges.push_back(extent);
  return edges;
}

} // namespace

double fixed_cell_width(const Case& input) {
  return preset_factor(input.numerics.preset) * input.skin.thickness() /
         (cells_per_thickness * input.numerics.mesh_refinement);
}

CoreGrid fixed_core_grid(const std::vector<Case>& sliders,
                         const std::vector<const mesh::SkinMesh*>& meshes) {
  const Skin& skin = sliders.front().skin;
  const bool same_across = std::ranges::all_of(sliders, covers_width);
  const mesh::SkinMesh& first = *meshes.front();
  const double width = first.half_model() ? 0.5 * skin.width : skin.width;
  return {graded_edges(skin.length, touched_spans(sliders, meshes, 0), outer_cell_limit(skin)),
          same_across
              ? std::vector{0.0, width}
              : graded_edges(width, touched_spans(sliders, meshes, 1), outer_cell_limit(skin)),
          core_lines(first, first.lines({0.5 * skin.length, 0.5 * skin.width}))};
}

} // namespace ionskin::handover
