// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/edge_interpolation.hpp"
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
  /// Sets one touch, and the derivatives of its amplitudes by the motions of the slider,
  /// docs/model.md (82).
  /// @param force_by_motion [motion][3 cells] [N/m], [N/rad]
  void differentiate(const Touch& touch, std::span<const double> force_by_motion) noexcept;
  /// Derivatives of `integrate_to` by a motion of the touch that `differentiate` set.
  void integrate_slope_to(std::size_t motion, const std::array<double, 2>& place,
                          const std::array<double, 2>& corner,
                          std::span<double> levels) const noexcept;
  std::span<const double> amplitude_slope(std::size_t motion) const {
    return std::span(amplitude_slope_).subspan(motion * modes_, modes_);
  }
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
  std::size_t load_cells(std::size_t lanes,
                         std::span<const std::span<const double>> forces) noexcept;
  double along_direction(std::span<const double> amplitude, const float* reached,
                         std::size_t direction) const noexcept;
  /// Adds the integrals of modes with these amplitudes up to a corner between edges, one for each
  /// level.
  /// @param rows edges of y
  static void add_integrals(const std::vector<float>& integral, std::size_t rows, const Between& x,
                            const Between& y, std::span<const double> amplitude,
                            std::span<double> levels) noexcept;
  void add_all_integrals(const std::array<double, 2>& place, const std::array<double, 2>& corner,
                         std::span<const double> amplitude,
                         std::span<double> levels) const noexcept;
  void set_strain_slopes(const Touch& touch, std::size_t first, std::size_t lanes,
                         std::span<const double> force_by_motion) noexcept;
  void set_amplitude_slopes(const Touch& touch, std::size_t first, std::size_t lanes) noexcept;

  const ChannelMap& channel_;
  std::size_t modes_;
  std::shared_ptr<const Tables> tables_;
  std::vector<std::uint32_t> columns_, all_points_;
  std::vector<float> factors_, reached_, strain_, fitted_;
  std::vector<double> place_amplitude_, point_, amplitude_;
  // The touch whose derivatives are asked for.
  std::vector<float> own_strain_, own_reached_;
  std::vector<double> own_point_, place_slope_, amplitude_slope_;
};

} // namespace ionskin::live
