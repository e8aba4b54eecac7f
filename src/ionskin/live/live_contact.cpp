// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/live_contact.hpp"

#include "ionskin/laws/friction/return_mapping.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::live {
namespace {

constexpr double tolerance = 1e-6; // change of a force in a sweep, over the largest
constexpr int most_sweeps = 60, most_landing_sweeps = 2000;
/// The compliance changes by less than 1e-5 of itself meanwhile [m].
constexpr double assembly_distance = 5e-6;

void lagrange(const std::vector<double>& lines, double at, std::span<double> weights) noexcept {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    weights[i] = 1;
    for (std::size_t j = 0; j < lines.size(); ++j) {
      if (j != i) {
        weights[i] *= (at - lines[j]) / (lines[i] - lines[j]);
      }
    }
  }
}

} // namespace

laws::Friction friction_of(const SkinData& data) {
  laws::LawValues values;
  for (std::size_t i = 0; i < data.friction_values.size(); ++i) {
    values[data.friction_parameters[i]] = data.friction_values[i];
  }
  return laws::friction(data.friction_law, data.friction, values);
}

bool friction_remembers(const laws::Friction& friction) {
  return friction.elastic_slip > 0 || friction.lag > 0;
}

void place_amplitudes(const PlaceMap& map, const std::array<double, 2>& place,
                      std::span<double> amplitudes) noexcept {
  std::array<double, most_lines> x{}, y{};
  lagrange(map.lines_x, place[0], x);
  lagrange(map.lines_y, place[1], y);
  std::fill(amplitudes.begin(), amplitudes.end(), 0.0);
  const std::size_t modes = map.modes();
  for (std::size_t j = 0, node = 0; j < map.lines_y.size(); ++j) {
    for (std::size_t i = 0; i < map.lines_x.size(); ++i, ++node) {
      for (std::size_t k = 0; k < modes; ++k) {
        amplitudes[k] += x[i] * y[j] * map.amplitude[modes * node + k];
      }
    }
  }
}

LiveContact::LiveContact(const SkinData& data)
    : data_(data), friction_(friction_of(data)), size_(3 * data.area.size()),
      first_touch_(*std::min_element(data.gap.begin(), data.gap.end())), compliance_(size_ * size_),
      before_(size_), amplitude_(data.compliance.modes()), slips_(data.area.size()) {}

void LiveContact::assemble(const State& state) noexcept {
  if (std::isnan(state.assembled_x)) {
    return;
  }
  place_amplitudes(data_.compliance, {state.assembled_x, state.assembled_y}, amplitude_);
  const float* mode = data_.compliance.values.data();
  std::copy(mode, mode + compliance_.size(), compliance_.begin());
  for (const double amplitude : amplitude_) {
    mode += compliance_.size();
    for (std::size_t i = 0; i < compliance_.size(); ++i) {
      compliance_[i] += amplitude * static_cast<double>(mode[i]);
    }
  }
}

double LiveContact::sweep(double time_step, const std::array<double, 2>& travel,
                          State& state) noexcept {
  double change = 0;
  for (std::size_t cell = 0, at = 0; at < size_; ++cell, at += 3) {
    const double own = compliance_[at * (size_ + 1)];
    const double own_tangential =
        std::max(compliance_[(at + 1) * (size_ + 1)], compliance_[(at + 2) * (size_ + 1)]);
    const double normal = std::max(
        0.0, state.force[at] + (state.indentation - data_.gap[cell] - state.surface[at]) / own);
    const double slip_x = travel[0] - (state.surface[at + 1] - before_[at + 1]),
                 slip_y = travel[1] - (state.surface[at + 2] - before_[at + 2]);
    const double area = data_.area[cell];
    const laws::FrictionResponse response =
        laws::return_mapping(friction_, {normal / area,
                                         {(state.force[at + 1] + slip_x / own_tangential) / area,
                                          (state.force[at + 2] + slip_y / own_tangential) / area},
                                         own_tangential * area,
                                         time_step});
    slips_[cell] = !response.sticks;
    const std::array<double, 3> next{normal, area * response.traction[0],
                                     area * response.traction[1]};
    for (std::size_t c = 0; c < 3; ++c) {
      const double difference = next[c] - state.force[at + c];
      if (difference != 0) {
        const double* column = compliance_.data() + (at + c) * size_;
        for (std::size_t row = 0; row < size_; ++row) {
          state.surface[row] += difference * column[row];
        }
        state.force[at + c] = next[c];
        change = std::max(change, std::abs(difference));
      }
    }
  }
  return change;
}

double LiveContact::step(double time_step, const std::array<double, 2>& place,
                         const std::array<double, 2>& travel, const Load& load,
                         State state) noexcept {
  const bool moved = !(std::hypot(place[0] - state.assembled_x, place[1] - state.assembled_y) <=
                       assembly_distance);
  if (moved) {
    state.assembled_x = place[0];
    state.assembled_y = place[1];
    assemble(state);
  }
  if (load.value <= (load.is_force ? 0.0 : first_touch_)) {
    std::fill(state.force.begin(), state.force.end(), 0.0);
    std::fill(state.surface.begin(), state.surface.end(), 0.0);
    std::fill(slips_.begin(), slips_.end(), char{0});
    state.indentation = load.is_force ? first_touch_ : load.value;
    return 0;
  }
  std::copy(state.surface.begin(), state.surface.end(), before_.begin());
  std::fill(state.surface.begin(), state.surface.end(), 0.0);
  for (std::size_t at = 0; at < size_; ++at) {
    const double* column = compliance_.data() + at * size_;
    for (std::size_t row = 0; row < size_ && state.force[at] != 0; ++row) {
      state.surface[row] += state.force[at] * column[row];
    }
  }
  const auto largest = [&] {
    double result = 0;
    for (std::size_t at = 0; at < size_; at += 3) {
      result = std::max(result, state.force[at]);
    }
    return result;
  };
  const bool landing = largest() == 0;
  if (!load.is_force) {
    state.indentation = load.value;
  }
  double residual = 1, stiffness = data_.stiffness, last_indentation = state.indentation,
         last_total = -1;
  for (int i = 0; i < (landing ? most_landing_sweeps : most_sweeps); ++i) {
    const double change = sweep(time_step, travel, state), scale = largest();
    residual = scale > 0 ? change / scale : 0;
    double left = 0;
    if (load.is_force) {
      constexpr int sweeps_between = 3; // of two indentations that a secant joins
      double total = 0;
      for (std::size_t at = 0; at < size_; at += 3) {
        total += state.force[at];
      }
      left = std::abs(load.value - total) / load.value;
      if (left > tolerance && i % sweeps_between == 0) {
        const double way = state.indentation - last_indentation;
        if (last_total >= 0 && way != 0) {
          stiffness =
              std::clamp((total - last_total) / way, 0.1 * data_.stiffness, 4 * data_.stiffness);
        }
        last_indentation = state.indentation;
        last_total = total;
        state.indentation += (load.value - total) / stiffness;
      }
    }
    residual = std::max(residual, left);
    if (residual <= tolerance) {
      break;
    }
  }
  return residual;
}

} // namespace ionskin::live
