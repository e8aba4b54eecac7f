// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/channel_field.hpp"

#include "ionskin/live/edge_interpolation.hpp"
#include "ionskin/live/place_amplitudes.hpp"

#include <algorithm>
#include <cmath>

namespace ionskin::live {
namespace {

std::vector<float> integrals(const std::vector<float>& fields, const std::vector<double>& x_edges,
                             const std::vector<double>& y_edges, std::size_t levels) {
  const std::size_t columns = x_edges.size() - 1, rows = y_edges.size() - 1,
                    modes = fields.size() / (levels * rows * columns);
  std::vector<float> result((columns + 1) * (rows + 1) * levels * modes);
  std::vector<double> below(columns + 1); // to the edges of x, up to one of y
  for (std::size_t mode = 0; mode < modes; ++mode) {
    for (std::size_t level = 0; level < levels; ++level) {
      const float* field = fields.data() + (mode * levels + level) * rows * columns;
      std::ranges::fill(below, 0.0);
      for (std::size_t j = 0; j < rows; ++j) {
        const double height = y_edges[j + 1] - y_edges[j];
        double row = 0;
        for (std::size_t i = 0; i < columns; ++i) {
          row +=
              height * (x_edges[i + 1] - x_edges[i]) * static_cast<double>(field[j * columns + i]);
          below[i + 1] += row;
          result[(((i + 1) * (rows + 1) + j + 1) * levels + level) * modes + mode] =
              static_cast<float>(below[i + 1]);
        }
      }
    }
  }
  return result;
}

} // namespace

ChannelField::ChannelField(const ChannelMap& channel, std::size_t cells) : channel_(channel) {
  const std::size_t rows = channel.strain.size() / (3 * cells),
                    points = rows / channel.rows_per_point, modes = channel.fit.size() / points;
  riding_ = channel.field.size() /
            (levels() * (channel.x_edges.size() - 1) * (channel.y_edges.size() - 1));
  integral_ = std::make_shared<const std::vector<float>>(
      integrals(channel.field, channel.x_edges, channel.y_edges, levels()));
  fixed_integral_ = std::make_shared<const std::vector<float>>(
      integrals(channel.fixed_field, channel.fixed_x_edges, channel.fixed_y_edges, levels()));
  strain_.resize(rows);
  place_amplitude_.resize(channel.strain.modes());
  fit_amplitude_.resize(channel.fit.modes());
  point_.resize(points);
  amplitude_.resize(modes);
  sum_.resize(levels() * modes);
}

void ChannelField::set(const std::array<double, 2>& place, std::span<const double> force) noexcept {
  const std::size_t rows = strain_.size(), per = channel_.rows_per_point;
  place_amplitudes(channel_.strain, place, place_amplitude_);
  std::ranges::fill(strain_, 0.0f);
  for (std::size_t mode = 0; mode <= place_amplitude_.size(); ++mode) {
    const double scale = mode == 0 ? 1 : place_amplitude_[mode - 1];
    // [3 cells][row]: sums along the rows vectorise, those of a cell together
    const float* column = channel_.strain.values.data() + mode * rows * force.size();
    for (std::size_t at = 0; at < force.size(); at += 3, column += 3 * rows) {
      if (force[at] == 0 && force[at + 1] == 0 && force[at + 2] == 0) {
        continue;
      }
      const auto x = static_cast<float>(scale * force[at]),
                 y = static_cast<float>(scale * force[at + 1]),
                 z = static_cast<float>(scale * force[at + 2]);
      float* strain = strain_.data();
      for (std::size_t row = 0; row < rows; ++row) {
        strain[row] += x * column[row] + y * column[rows + row] + z * column[2 * rows + row];
      }
    }
  }
  for (std::size_t point = 0; point < point_.size(); ++point) {
    const float* strain = strain_.data() + per * point;
    double square = 0;
    for (std::size_t row = 0; row < per; ++row) {
      square += static_cast<double>(strain[row]) * static_cast<double>(strain[row]);
    }
    point_[point] = per == 1 ? static_cast<double>(strain[0]) : std::sqrt(square);
  }
  place_amplitudes(channel_.fit, place, fit_amplitude_);
  std::ranges::fill(amplitude_, 0.0);
  const float* fit = channel_.fit.values.data();
  for (std::size_t mode = 0; mode <= fit_amplitude_.size(); ++mode) {
    const double scale = mode == 0 ? 1 : fit_amplitude_[mode - 1];
    for (double& amplitude : amplitude_) {
      std::array<double, 4> part{}; // sums that do not wait for each other
      std::size_t point = 0;
      for (; point + part.size() <= point_.size(); point += part.size()) {
        for (std::size_t i = 0; i < part.size(); ++i) {
          part[i] += static_cast<double>(fit[point + i]) * point_[point + i];
        }
      }
      for (; point < point_.size(); ++point) {
        part[0] += static_cast<double>(fit[point]) * point_[point];
      }
      amplitude += scale * ((part[0] + part[1]) + (part[2] + part[3]));
      fit += point_.size();
    }
  }
}

void ChannelField::add_integrals(const std::vector<float>& integral,
                                 const std::vector<double>& x_edges,
                                 const std::vector<double>& y_edges,
                                 const std::array<double, 2>& corner,
                                 std::span<const double> amplitude,
                                 std::span<double> levels) noexcept {
  const std::size_t modes = amplitude.size(), size = levels.size() * modes;
  std::fill_n(sum_.begin(), size, 0.0);
  const Between x = between(x_edges, corner[0]), y = between(y_edges, corner[1]);
  for (std::size_t node = 0; node < 4; ++node) {
    const std::size_t i = x.edge[node % 2], j = y.edge[node / 2];
    const double weight = x.weight[node % 2] * y.weight[node / 2];
    if (weight == 0 || i == 0 || j == 0) {
      continue;
    }
    const float* at = integral.data() + (i * y_edges.size() + j) * size;
    for (std::size_t k = 0; k < size; ++k) {
      sum_[k] += weight * static_cast<double>(at[k]);
    }
  }
  for (std::size_t level = 0; level < levels.size(); ++level) {
    double sum = 0;
    for (std::size_t mode = 0; mode < modes; ++mode) {
      sum += amplitude[mode] * sum_[level * modes + mode];
    }
    levels[level] += sum;
  }
}

void ChannelField::integrate_to(const std::array<double, 2>& place,
                                const std::array<double, 2>& corner,
                                std::span<double> levels) noexcept {
  std::ranges::fill(levels, 0.0);
  const auto amplitude = std::span<const double>(amplitude_);
  add_integrals(*integral_, channel_.x_edges, channel_.y_edges,
                {corner[0] - place[0], corner[1] - place[1]}, amplitude.first(riding_), levels);
  add_integrals(*fixed_integral_, channel_.fixed_x_edges, channel_.fixed_y_edges, corner,
                amplitude.subspan(riding_), levels);
}

} // namespace ionskin::live
