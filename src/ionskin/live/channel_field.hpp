// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/products/lane_product.hpp"
#include "ionskin/live/skin_data.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace ionskin::live {

/// A channel of the core while sliders press, each on a skin of its own: modes of its field from
/// the forces of the cells, and integrals up to a corner. Copies share their tables; nothing is
/// allocated after construction.
class ChannelField {
public:
  /// Where a slider is, and the forces on the cells [3 cells] [N].
  struct Touch {
    std::array<double, 2> place;
    std::span<const double> force;
  };

  /// @param channel of so many cells; outlives this
  ChannelField(const ChannelMap& channel, std::size_t cells);

  const ChannelMap& map() const { return channel_; }
  std::size_t levels() const { return channel_.mean.size(); }

  /// Sets the touches whose fields are asked for next, one lane each.
  /// @param touches one for each lane, at most `most_lanes`
  void set(std::span<const Touch> touches) noexcept;
  /// Integrals over all that lies before a corner along x and y, one for each level.
  void integrate_to(std::size_t lane, const std::array<double, 2>& place,
                    const std::array<double, 2>& corner, std::span<double> levels) const noexcept;
  /// Amplitudes of the modes of a lane: those that ride with the slider, then those that stay with
  /// the skin.
  std::span<const double> amplitude(std::size_t lane) const {
    return std::span(amplitude_).subspan(lane * modes_, modes_);
  }

private:
  struct Tables {
    /// Strains: first by the force on each cell, then by what `reach` gives.
    LaneProduct strain;
    /// The change of the strains with the place is smooth and needs few directions: for each mode
    /// of the place and each of them the force in it.
    LaneProduct reach;
    std::size_t directions = 0;
    LaneProduct fit; ///< amplitudes by the channel at each point, times that of each place mode
    std::size_t riding = 0; ///< modes that ride with the slider; the others stay with the skin
    /// Integral of each mode from the lowest corner of its frame to the crossings of the edges,
    /// between which it is bilinear: [x edge][y edge][level][mode].
    std::vector<float> integral, fixed_integral;
  };
  static Tables tables(const ChannelMap& channel, std::size_t cells, std::size_t modes);
  void set_strain(std::size_t lanes, std::span<const Touch> touches) noexcept;
  void set_amplitude(std::size_t lanes, std::span<const Touch> touches) noexcept;

  const ChannelMap& channel_;
  std::size_t modes_;
  std::shared_ptr<const Tables> tables_;
  std::vector<std::uint32_t> columns_, all_points_;
  std::vector<float> factors_, reached_, strain_, fitted_;
  std::vector<double> place_amplitude_, point_, amplitude_;
};

} // namespace ionskin::live
