// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/data/skin_data.hpp"
#include "ionskin/live/edge_interpolation.hpp"
#include "ionskin/live/products/lane_product.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace ionskin::live {

/// Evaluates the reduced model of one channel (scalar field over the core, such as the shear) for
/// up to `most_lanes` skins at once, each with a slider of its own: amplitudes of the modes from
/// the cell forces, and integrals of the field over rectangles from a corner of the core. Nothing
/// is allocated after construction; copies share their tables.
class ChannelField {
public:
  /// Position of a slider's centre [m], and the forces on its contact cells [3 cells] [N].
  struct Touch {
    std::array<double, 2> place;
    std::span<const double> force;
  };

  /// Prepares the tables.
  /// @param channel reduced model; must outlive the field
  /// @param cells number of contact cells
  ChannelField(const ChannelMap& channel, std::size_t cells);

  const ChannelMap& map() const { return channel_; }
  /// Number of z levels.
  std::size_t levels() const { return channel_.mean.size(); }

  /// Computes the mode amplitudes of some touches; the other functions then refer to these by lane.
  /// @param touches one for each lane: one, or up to `most_lanes`
  void set(std::span<const Touch> touches) noexcept;
  /// Computes the integrals of the field over all of the core below a corner in x and y, at each z
  /// level.
  /// @param place position of the slider's centre [m]
  /// @param corner in the skin's frame [m]
  /// @param levels receives the integrals [level] [m2 times unit of the channel]
  void integrate_to(std::size_t lane, const std::array<double, 2>& place,
                    const std::array<double, 2>& corner, std::span<double> levels) const noexcept;
  /// Computes the mode amplitudes of one touch, in lane 0, and their derivatives by the rigid
  /// motions of the slider, docs/model.md (82).
  /// @param force_by_motion derivatives of the cell forces [motion][3 cells] [N/m], [N/rad]
  void differentiate(const Touch& touch, std::span<const double> force_by_motion) noexcept;
  /// Computes the derivatives of the integrals of `integrate_to` by a motion, for the touch of the
  /// last call of `differentiate`. The parameters are those of `integrate_to`.
  /// @param motion index of the rigid motion, 0 to 5
  void integrate_slope_to(std::size_t motion, const std::array<double, 2>& place,
                          const std::array<double, 2>& corner,
                          std::span<double> levels) const noexcept;
  /// Derivatives of the mode amplitudes by a motion, from the last call of `differentiate`; order
  /// of the modes as in `amplitude`.
  std::span<const double> amplitude_slope(std::size_t motion) const {
    return std::span(amplitude_slope_).subspan(motion * modes_, modes_);
  }
  /// Mode amplitudes of a lane: modes that move with the slider, then modes that stay with the
  /// skin.
  std::span<const double> amplitude(std::size_t lane) const {
    return std::span(amplitude_).subspan(lane * modes_, modes_);
  }

private:
  struct Tables {
    /// Strains at the points by the force on each cell, then by each direction of `reach`.
    LaneProduct strain;
    /// Low-rank form of the change of the strains with the position, which is smooth: components of
    /// the cell forces along few directions, for each mode of the position [position
    /// mode][direction].
    LaneProduct reach;
    std::size_t directions = 0;
    /// Amplitudes by the channel at each point, then by it times the amplitude of each position
    /// mode.
    LaneProduct fit;
    std::size_t riding = 0; ///< modes that move with the slider; the rest stay with the skin
    /// Integral of each mode from the lowest corner of its grid to the crossings of the grid's
    /// edges, between which it is bilinear [x edge][y edge][level][mode].
    std::vector<float> integral, fixed_integral;
  };
  static Tables tables(const ChannelMap& channel, std::size_t cells, std::size_t modes);
  void set_strain(std::size_t lanes, std::span<const Touch> touches) noexcept;
  void set_amplitude(std::size_t lanes, std::span<const Touch> touches) noexcept;
  std::size_t load_cells(std::size_t lanes,
                         std::span<const std::span<const double>> forces) noexcept;
  double along_direction(std::span<const double> amplitude, const float* reached,
                         std::size_t direction) const noexcept;
  /// Adds, at each level, the integrals up to a corner of modes with given amplitudes.
  /// @param integral as in `Tables`
  /// @param rows number of y edges
  /// @param x, y position of the corner between the edges
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
  // Touch of the last call of `differentiate`.
  std::vector<float> own_strain_, own_reached_;
  std::vector<double> own_point_, place_slope_, amplitude_slope_;
};

} // namespace ionskin::live
