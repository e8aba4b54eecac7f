// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/channel_field.hpp"

#include "ionskin/live/data/place_amplitudes.hpp"
#include "ionskin/live/edge_interpolation.hpp"
#include "ionskin/live/products/low_rank.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ionskin::live {
namespace {

/// Error of the strains that the place changes, over the largest strain; stated errors begin at
/// 1e-4.
constexpr double smoothness = 1e-6;
/// Motions along x and y, which move the place.
constexpr std::size_t ways = 2;

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

ChannelField::Tables ChannelField::tables(const ChannelMap& channel, std::size_t cells,
                                          std::size_t modes) {
  Tables result;
  const std::size_t size = 3 * cells, rows = channel.strain.size() / size,
                    strain_modes = channel.strain.modes(), points = channel.fit.size() / modes,
                    fit_modes = channel.fit.modes();
  const float* values = channel.strain.values.data();
  double largest = 0;
  for (std::size_t i = 0; i < size * rows; ++i) {
    largest = std::max(largest, std::abs(static_cast<double>(values[i])));
  }
  // Each mode as large as it becomes at a node.
  std::vector<double> scale(strain_modes), changes(strain_modes * size * rows);
  for (std::size_t i = 0; i < channel.strain.amplitude.size(); ++i) {
    double& own = scale[i % strain_modes];
    own = std::max(own, std::abs(channel.strain.amplitude[i]));
  }
  for (std::size_t i = 0; i < changes.size(); ++i) {
    changes[i] = scale[i / (size * rows)] * static_cast<double>(values[size * rows + i]);
  }
  const LowRank smooth = low_rank(std::move(changes), rows, smoothness * largest);
  result.directions = smooth.rank;
  result.strain = LaneProduct(rows, size + smooth.rank);
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t row = 0; row < rows; ++row) {
      result.strain.at(row, i) = values[i * rows + row];
    }
  }
  result.reach = LaneProduct(strain_modes * smooth.rank, size);
  for (std::size_t q = 0; q < smooth.rank; ++q) {
    for (std::size_t row = 0; row < rows; ++row) {
      result.strain.at(row, size + q) = smooth.columns[q * rows + row];
    }
    for (std::size_t k = 0; k < strain_modes; ++k) {
      for (std::size_t i = 0; i < size && scale[k] > 0; ++i) {
        result.reach.at(k * smooth.rank + q, i) = static_cast<float>(
            static_cast<double>(smooth.rows[(q * strain_modes + k) * size + i]) / scale[k]);
      }
    }
  }
  result.fit = LaneProduct(modes, (1 + fit_modes) * points);
  for (std::size_t k = 0; k <= fit_modes; ++k) {
    for (std::size_t mode = 0; mode < modes; ++mode) {
      for (std::size_t point = 0; point < points; ++point) {
        result.fit.at(mode, k * points + point) =
            channel.fit.values[(k * modes + mode) * points + point];
      }
    }
  }
  const std::size_t levels = channel.mean.size();
  result.riding =
      channel.field.size() / (levels * (channel.x_edges.size() - 1) * (channel.y_edges.size() - 1));
  result.integral = integrals(channel.field, channel.x_edges, channel.y_edges, levels);
  result.fixed_integral =
      integrals(channel.fixed_field, channel.fixed_x_edges, channel.fixed_y_edges, levels);
  return result;
}

ChannelField::ChannelField(const ChannelMap& channel, std::size_t cells) : channel_(channel) {
  const std::size_t rows = channel.strain.size() / (3 * cells),
                    points = rows / channel.rows_per_point;
  modes_ = channel.fit.size() / points;
  tables_ = std::make_shared<const Tables>(tables(channel, cells, modes_));
  columns_.resize(tables_->strain.columns());
  all_points_.resize(tables_->fit.columns());
  std::iota(all_points_.begin(), all_points_.end(), 0u);
  factors_.resize(most_lanes * std::max(tables_->strain.columns(), tables_->fit.columns()));
  reached_.resize(most_lanes * tables_->reach.stride());
  strain_.resize(most_lanes * tables_->strain.stride());
  fitted_.resize(most_lanes * tables_->fit.stride());
  place_amplitude_.resize(std::max(channel.strain.modes(), channel.fit.modes()));
  point_.resize(points);
  amplitude_.resize(most_lanes * modes_);
  own_strain_.resize(tables_->strain.stride());
  own_reached_.resize(tables_->reach.stride());
  own_point_.resize(points);
  place_slope_.resize(place_amplitude_.size());
  amplitude_slope_.resize(motions * modes_);
}

void ChannelField::set(std::span<const Touch> touches) noexcept {
  const std::size_t lanes = touches.size() == 1 ? 1 : most_lanes;
  set_strain(lanes, touches);
  set_amplitude(lanes, touches);
}

/// Takes the forces on the cells that some lane loads as factors of the strain.
/// @returns columns that count
std::size_t ChannelField::load_cells(std::size_t lanes,
                                     std::span<const std::span<const double>> forces) noexcept {
  const std::size_t size = tables_->strain.columns() - tables_->directions;
  std::ranges::fill(factors_, 0.0f);
  std::size_t count = 0;
  for (std::size_t at = 0; at < size; at += 3) {
    bool loaded = false;
    for (std::size_t lane = 0; lane < forces.size(); ++lane) {
      for (std::size_t c = 0; c < 3; ++c) {
        const double force = forces[lane][at + c];
        loaded = loaded || force != 0;
        factors_[(count + c) * lanes + lane] = static_cast<float>(force);
      }
    }
    if (loaded) {
      for (std::size_t c = 0; c < 3; ++c) {
        columns_[count++] = static_cast<std::uint32_t>(at + c);
      }
    }
  }
  return count;
}

/// @param amplitude of the modes of the place, or their derivative
double ChannelField::along_direction(std::span<const double> amplitude, const float* reached,
                                     std::size_t direction) const noexcept {
  double sum = 0;
  for (std::size_t k = 0; k < amplitude.size(); ++k) {
    sum += amplitude[k] * static_cast<double>(reached[k * tables_->directions + direction]);
  }
  return sum;
}

void ChannelField::set_strain(std::size_t lanes, std::span<const Touch> touches) noexcept {
  const std::size_t size = tables_->strain.columns() - tables_->directions;
  std::array<std::span<const double>, most_lanes> forces;
  std::ranges::transform(touches, forces.begin(), &Touch::force);
  std::size_t count = load_cells(lanes, std::span(forces).first(touches.size()));
  if (tables_->directions > 0) {
    tables_->reach.times(lanes, std::span(columns_).first(count), factors_.data(), reached_.data());
    const auto amplitude = std::span(place_amplitude_).first(channel_.strain.modes());
    for (std::size_t lane = 0; lane < touches.size(); ++lane) {
      place_amplitudes(channel_.strain, touches[lane].place, amplitude);
      const float* reached = reached_.data() + lane * tables_->reach.stride();
      for (std::size_t q = 0; q < tables_->directions; ++q) {
        factors_[(count + q) * lanes + lane] =
            static_cast<float>(along_direction(amplitude, reached, q));
      }
    }
    for (std::size_t q = 0; q < tables_->directions; ++q) {
      columns_[count++] = static_cast<std::uint32_t>(size + q);
    }
  }
  tables_->strain.times(lanes, std::span(columns_).first(count), factors_.data(), strain_.data());
}

void ChannelField::set_amplitude(std::size_t lanes, std::span<const Touch> touches) noexcept {
  const std::size_t per = channel_.rows_per_point, points = point_.size(),
                    fit_modes = channel_.fit.modes();
  std::ranges::fill(factors_, 0.0f);
  for (std::size_t lane = 0; lane < touches.size(); ++lane) {
    const float* strain = strain_.data() + lane * tables_->strain.stride();
    for (double& point : point_) {
      double square = 0;
      for (std::size_t row = 0; row < per; ++row) {
        square += static_cast<double>(strain[row]) * static_cast<double>(strain[row]);
      }
      point = per == 1 ? static_cast<double>(*strain) : std::sqrt(square);
      strain += per;
    }
    place_amplitudes(channel_.fit, touches[lane].place,
                     std::span(place_amplitude_).first(fit_modes));
    for (std::size_t k = 0; k <= fit_modes; ++k) {
      const double scale = k == 0 ? 1 : place_amplitude_[k - 1];
      for (std::size_t point = 0; point < points; ++point) {
        factors_[(k * points + point) * lanes + lane] = static_cast<float>(scale * point_[point]);
      }
    }
  }
  tables_->fit.times(lanes, all_points_, factors_.data(), fitted_.data());
  for (std::size_t lane = 0; lane < touches.size(); ++lane) {
    std::copy_n(fitted_.data() + lane * tables_->fit.stride(), modes_,
                amplitude_.data() + lane * modes_);
  }
}

void ChannelField::add_integrals(const std::vector<float>& integral, std::size_t rows,
                                 const Between& x, const Between& y,
                                 std::span<const double> amplitude,
                                 std::span<double> levels) noexcept {
  const std::size_t modes = amplitude.size();
  for (std::size_t node = 0; node < 4; ++node) {
    const std::size_t i = x.edge[node % 2], j = y.edge[node / 2];
    const double weight = x.weight[node % 2] * y.weight[node / 2];
    if (weight == 0 || i == 0 || j == 0) {
      continue;
    }
    const float* at = integral.data() + (i * rows + j) * levels.size() * modes;
    for (double& level : levels) {
      std::array<double, 16> part{}; // sums that do not wait for each other
      std::size_t mode = 0;
      for (; mode + part.size() <= modes; mode += part.size()) {
        for (std::size_t k = 0; k < part.size(); ++k) {
          part[k] += amplitude[mode + k] * static_cast<double>(at[mode + k]);
        }
      }
      for (; mode < modes; ++mode) {
        part[0] += amplitude[mode] * static_cast<double>(at[mode]);
      }
      level += weight * std::accumulate(part.begin(), part.end(), 0.0);
      at += modes;
    }
  }
}

void ChannelField::add_all_integrals(const std::array<double, 2>& place,
                                     const std::array<double, 2>& corner,
                                     std::span<const double> amplitude,
                                     std::span<double> levels) const noexcept {
  add_integrals(
      tables_->integral, channel_.y_edges.size(), between(channel_.x_edges, corner[0] - place[0]),
      between(channel_.y_edges, corner[1] - place[1]), amplitude.first(tables_->riding), levels);
  add_integrals(tables_->fixed_integral, channel_.fixed_y_edges.size(),
                between(channel_.fixed_x_edges, corner[0]),
                between(channel_.fixed_y_edges, corner[1]), amplitude.subspan(tables_->riding),
                levels);
}

void ChannelField::integrate_to(std::size_t lane, const std::array<double, 2>& place,
                                const std::array<double, 2>& corner,
                                std::span<double> levels) const noexcept {
  std::ranges::fill(levels, 0.0);
  add_all_integrals(place, corner, amplitude(lane), levels);
}

void ChannelField::differentiate(const Touch& touch,
                                 std::span<const double> force_by_motion) noexcept {
  set({&touch, 1});
  std::copy_n(strain_.begin(), own_strain_.size(), own_strain_.begin());
  std::copy_n(reached_.begin(), own_reached_.size(), own_reached_.begin());
  std::ranges::copy(point_, own_point_.begin());
  for (std::size_t first = 0; first < motions; first += most_lanes) {
    const std::size_t count = std::min(most_lanes, motions - first);
    set_strain_slopes(touch, first, count, force_by_motion);
    set_amplitude_slopes(touch, first, count);
  }
}

/// Derivatives of the strains by so many motions from `first` on, one in each lane.
void ChannelField::set_strain_slopes(const Touch& touch, std::size_t first, std::size_t lanes,
                                     std::span<const double> force_by_motion) noexcept {
  const std::size_t directions = tables_->directions, modes = channel_.strain.modes(),
                    size = tables_->strain.columns() - directions;
  std::array<std::span<const double>, most_lanes> forces;
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    forces[lane] = force_by_motion.subspan((first + lane) * size, size);
  }
  std::size_t count = load_cells(most_lanes, std::span(forces).first(lanes));
  if (directions > 0) {
    tables_->reach.times(most_lanes, std::span(columns_).first(count), factors_.data(),
                         reached_.data());
    const auto amplitude = std::span(place_amplitude_).first(modes),
               slope = std::span(place_slope_).first(modes);
    place_amplitudes(channel_.strain, touch.place, amplitude);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const std::size_t motion = first + lane;
      if (motion < ways) {
        place_slopes(channel_.strain, touch.place, motion, slope);
      }
      const float* reached = reached_.data() + lane * tables_->reach.stride();
      for (std::size_t q = 0; q < directions; ++q) {
        factors_[(count + q) * most_lanes + lane] = static_cast<float>(
            along_direction(amplitude, reached, q) +
            (motion < ways ? along_direction(slope, own_reached_.data(), q) : 0.0));
      }
    }
    for (std::size_t q = 0; q < directions; ++q) {
      columns_[count++] = static_cast<std::uint32_t>(size + q);
    }
  }
  tables_->strain.times(most_lanes, std::span(columns_).first(count), factors_.data(),
                        strain_.data());
}

/// Derivatives of the channel at its points, the norm of the strains of each, and of the
/// amplitudes.
void ChannelField::set_amplitude_slopes(const Touch& touch, std::size_t first,
                                        std::size_t lanes) noexcept {
  const std::size_t per = channel_.rows_per_point, points = own_point_.size(),
                    modes = channel_.fit.modes();
  const auto amplitude = std::span(place_amplitude_).first(modes),
             slope = std::span(place_slope_).first(modes);
  place_amplitudes(channel_.fit, touch.place, amplitude);
  std::ranges::fill(factors_, 0.0f);
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    const std::size_t motion = first + lane;
    std::ranges::fill(slope, 0.0);
    if (motion < ways) {
      place_slopes(channel_.fit, touch.place, motion, slope);
    }
    const float *own = own_strain_.data(),
                *strain = strain_.data() + lane * tables_->strain.stride();
    for (std::size_t point = 0; point < points; ++point, own += per, strain += per) {
      double change = static_cast<double>(*strain);
      if (per > 1) {
        change = 0;
        for (std::size_t row = 0; row < per && own_point_[point] > 0; ++row) {
          change +=
              static_cast<double>(own[row]) * static_cast<double>(strain[row]) / own_point_[point];
        }
      }
      factors_[point * most_lanes + lane] = static_cast<float>(change);
      for (std::size_t k = 0; k < modes; ++k) {
        factors_[((k + 1) * points + point) * most_lanes + lane] =
            static_cast<float>(amplitude[k] * change + slope[k] * own_point_[point]);
      }
    }
  }
  tables_->fit.times(most_lanes, all_points_, factors_.data(), fitted_.data());
  for (std::size_t lane = 0; lane < lanes; ++lane) {
    std::copy_n(fitted_.data() + lane * tables_->fit.stride(), modes_,
                amplitude_slope_.data() + (first + lane) * modes_);
  }
}

void ChannelField::integrate_slope_to(std::size_t motion, const std::array<double, 2>& place,
                                      const std::array<double, 2>& corner,
                                      std::span<double> levels) const noexcept {
  std::ranges::fill(levels, 0.0);
  add_all_integrals(place, corner, amplitude_slope(motion), levels);
  if (motion >= ways) {
    return;
  }
  // A field that rides with the slider falls behind a corner as the slider goes on.
  const double x = corner[0] - place[0], y = corner[1] - place[1];
  Between at_x = motion == 0 ? slope_between(channel_.x_edges, x) : between(channel_.x_edges, x);
  const Between at_y =
      motion == 1 ? slope_between(channel_.y_edges, y) : between(channel_.y_edges, y);
  for (double& weight : at_x.weight) {
    weight = -weight;
  }
  add_integrals(tables_->integral, channel_.y_edges.size(), at_x, at_y,
                amplitude(0).first(tables_->riding), levels);
}

} // namespace ionskin::live
