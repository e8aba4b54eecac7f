// SPDX-License-Identifier: Apache-2.0
#include "model_cases.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>

namespace ionskin::verification {
namespace {

constexpr double skin_length = 15e-3, skin_width = 2e-3, core_thickness = 180e-6;
constexpr double contact_begin = 0.5 / 1.001, slide_begin = 0.5, full_slip = 0.5 + 0.05 / 3.0;
constexpr double slide_end = 2.5, contact_end = 3.0 - contact_begin, period = 4.0;
constexpr double edge_width = 75e-6; // over which the shear falls off beside the footprint

std::vector<double> edges(double from, double to, std::size_t cells) {
  std::vector<double> lines;
  for (std::size_t i = 0; i <= cells; ++i) {
    lines.push_back(from + (to - from) * static_cast<double>(i) / static_cast<double>(cells));
  }
  return lines;
}

/// Shape of the footprint: 1 inside the half width `half` about 0, with soft edges.
double footprint(double x, double half) {
  return 0.5 * (std::tanh((x + half) / edge_width) - std::tanh((x - half) / edge_width));
}

/// Shape of the footprint's edges: 1 at both edges, 0 elsewhere.
double rim(double x, double half) {
  const double left = 1.0 / std::cosh((x + half) / edge_width);
  const double right = 1.0 / std::cosh((x - half) / edge_width);
  return 0.5 * (left * left + right * right);
}

std::shared_ptr<history::StrainField> contact_shear(const history::StrainGrid& grid,
                                                    double amplitude) {
  auto field = std::make_shared<history::StrainField>();
  for (const double z : grid.z_nodes) {
    const double zeta = z / core_thickness;
    for (std::size_t j = 0; j < grid.columns_y(); ++j) {
      const double y = 0.5 * (grid.y_edges[j] + grid.y_edges[j + 1]);
      for (std::size_t i = 0; i < grid.columns_x(); ++i) {
        const double x = 0.5 * (grid.x_edges[i] + grid.x_edges[i + 1]);
        const double inside = footprint(x, 1.5e-3) * footprint(y, 0.75e-3);
        const double at_edges =
            rim(x, 1.5e-3) * footprint(y, 0.75e-3) + footprint(x, 1.5e-3) * rim(y, 0.75e-3);
        field->push_back(0.05 * amplitude *
                         ((0.4 + 0.6 * zeta) * inside + std::pow(zeta, 4) * at_edges));
      }
    }
  }
  return field;
}

} // namespace

Case model_case() {
  Case input;
  input.title = "baseline";
  input.skin.length = skin_length;
  input.skin.width = skin_width;
  const Material platinum{"platinum", 168e9, 0.38}, nafion{"nafion", 249e6, 0.49};
  input.skin.layers = {{"bottom", LayerRole::electrode, platinum, 10e-6},
                       {"core", LayerRole::core, nafion, core_thickness},
                       {"top", LayerRole::electrode, platinum, 10e-6}};
  input.slider.size = {3e-3, 1.5e-3};
  input.slider.start = {4.5e-3, 1e-3};
  input.motion = {.gap = 1e-3,
                  .preload = 1e-6,
                  .stroke = 6e-3,
                  .touchdown = 0.5,
                  .slide = 2.0,
                  .lift = 0.5,
                  .return_ = 1.0,
                  .cycles = 3};
  input.contact.friction = 0.3;
  input.electrochemistry = {293.15, 7e-11, 2e-3, 1200.0, 1};
  input.coupling.coefficient = 0.1;
  input.readout.sample_interval = 0.01;
  return input;
}

history::CoreHistory linear_step_history(double bottom, double top, std::vector<double> time) {
  history::CoreHistory history;
  history.grid = {{0.0, skin_length}, {0.0, skin_width}, {0.0, core_thickness}};
  history.measure = "prescribed";
  history.length = skin_length;
  history.width = skin_width;
  history.time = std::move(time);
  const auto field =
      std::make_shared<const history::StrainField>(history::StrainField{bottom, top});
  history.shear().assign(history.time.size(), field);
  history.event_time = {history.time.front()};
  return history;
}

history::CoreHistory sliding_contact_history(int cycles) {
  history::CoreHistory history;
  history.frame = history::Frame::slider;
  history.measure = "prescribed";
  history.length = skin_length;
  history.width = skin_width;
  // The grid covers the core at both ends of the track: 10.5 mm on either side of the slider.
  history.grid = {edges(-10.5e-3, 10.5e-3, 210), edges(-0.5 * skin_width, 0.5 * skin_width, 20),
                  edges(0.0, core_thickness, 12)};
  const std::shared_ptr<const history::StrainField> none = contact_shear(history.grid, 0.0);
  const std::shared_ptr<const history::StrainField> touching = contact_shear(history.grid, 1.0);
  const std::shared_ptr<const history::StrainField> sliding = contact_shear(history.grid, 1.5);
  struct Sample {
    double time, slider_x;
    std::shared_ptr<const history::StrainField> field;
  };
  const double start = 4.5e-3, end = 10.5e-3, slip_x = start + (full_slip - slide_begin) * 3e-3;
  const std::array<Sample, 6> samples{{{contact_begin, start, none},
                                       {slide_begin, start, touching},
                                       {full_slip, slip_x, sliding},
                                       {slide_end, end, sliding},
                                       {contact_end, end, none},
                                       {period, start, none}}};
  const auto add = [&history](double time, double x, const auto& field) {
    history.time.push_back(time);
    history.slider_x.push_back(x);
    history.shear().push_back(field);
  };
  add(0.0, start, none);
  for (int cycle = 0; cycle < cycles; ++cycle) {
    for (const Sample& sample : samples) {
      add(cycle * period + sample.time, sample.slider_x, sample.field);
    }
  }
  history.event_time = history.time;
  return history;
}

history::CoreHistory slide_onset_history() {
  history::CoreHistory history = sliding_contact_history(1);
  history.time[4] = 0.6;
  history.slider_x[4] = 4.8e-3;
  for (auto* series : {&history.time, &history.slider_x}) {
    series->resize(5);
  }
  history.shear().resize(5);
  history.event_time = {history.time.begin() + 1, history.time.end() - 1};
  return history;
}

} // namespace ionskin::verification
