// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/skin_data.hpp"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace ionskin::live {

/// A channel of the core while a slider presses: modes of its field from the forces of the cells,
/// and integrals up to a corner. Copies share their tables; nothing is allocated after
/// construction.
class ChannelField {
public:
  /// @param channel of so many cells; outlives this
  ChannelField(const ChannelMap& channel, std::size_t cells);

  const ChannelMap& map() const { return channel_; }
  std::size_t levels() const { return channel_.mean.size(); }

  /// @param force of the cells [3 cells] [N]
  void set(const std::array<double, 2>& place, std::span<const double> force) noexcept;
  /// Integrals over all that lies before a corner along x and y, one for each level.
  void integrate_to(const std::array<double, 2>& place, const std::array<double, 2>& corner,
                    std::span<double> levels) noexcept;
  /// Of the modes, those that stay with the skin behind those that ride with the slider.
  std::span<const double> amplitude() const { return amplitude_; }

private:
  void add_integrals(const std::vector<float>& integral, const std::vector<double>& x_edges,
                     const std::vector<double>& y_edges, const std::array<double, 2>& corner,
                     std::span<const double> amplitude, std::span<double> levels) noexcept;

  const ChannelMap& channel_;
  std::size_t riding_ = 0; ///< modes that ride with the slider
  /// Integral of each mode from the lowest corner of its frame to the crossings of the edges,
  /// between which it is bilinear: [x edge][y edge][level][mode].
  std::shared_ptr<const std::vector<float>> integral_, fixed_integral_;
  std::vector<float> strain_;
  std::vector<double> place_amplitude_, fit_amplitude_, point_, amplitude_, sum_;
};

} // namespace ionskin::live
