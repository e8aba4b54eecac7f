// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/data/skin_data.hpp"
#include "ionskin/live/edge_interpolation.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace ionskin::live {

/// Value in one column of an orthonormal cosine wave over uniform columns, an eigenvector of the
/// second differences between them [1].
/// @param columns number of columns
/// @param wave number of half waves, from 0
/// @param column from 0
double column_wave(std::size_t columns, std::uint64_t wave, std::size_t column);

/// Share of each of some uniform columns that lies between two coordinates [column] [1].
/// @param length of all columns together [m]
/// @param low, high coordinates from the first column's outer edge [m]
std::vector<double> column_shares(std::size_t columns, double length, double low, double high);

/// Charge that spreads along the skin between taxels, in the reduced-order model: the double layers
/// of a column hold charge, and the core conducts it to the next column. The model decomposes half
/// the sum of the charges of top and bottom into cosine waves over the columns, each of which
/// relaxes at its own rate, docs/model.md (34). Nothing is allocated after construction; copies
/// share no tables.
class ChargeSpread {
public:
  /// Prepares the tables.
  /// @param data the trained model; must outlive this
  explicit ChargeSpread(const SkinData& data);

  /// Number of waves; 0 if no charge spreads.
  std::size_t waves() const { return data_.spread.rates.size(); }
  /// Quantity that `drive` computes: the derivative by the slider's position along x or y at
  /// constant mode amplitudes, or, for `none`, the drive itself.
  enum class Along { x, y, none };
  /// Computes the drive of each wave: the charge towards which the wave relaxes [C], or its
  /// derivative [C/m].
  /// @param place position of the slider's centre [m]
  /// @param amplitude mode amplitudes of the driving channel, as `ChannelField::amplitude` returns
  /// them
  /// @param waves receives the drives [waves()]
  void drive(const std::array<double, 2>& place, std::span<const double> amplitude,
             std::span<double> waves, Along derivative = Along::none) noexcept;
  /// Charge that the waves add to a taxel, equal on top and bottom [C].
  /// @param relaxed present states of the waves [waves()] [C]
  double charge(std::size_t taxel, std::span<const double> relaxed) const noexcept;

private:
  void set_fixed_drive(const ChannelMap& channel);
  void row_at(const Between& at, std::vector<float>& row) const noexcept;

  const SkinData& data_;
  /// Weighted sum over the z levels of the integral of each mode, from the lowest corner of the
  /// slider's grid to the crossings of its edges [mode][y edge][x edge].
  std::vector<float> integral_;
  std::vector<double> fixed_drive_; ///< drive by the modes that stay with the skin [mode][wave]
  std::vector<std::size_t> row_of_; ///< row of each wave in `along_y_`
  std::vector<float> along_x_;      ///< cosines along x [wave][column of x]
  std::vector<float> along_y_;      ///< distinct cosines along y [row][column of y]
  std::vector<double> share_;       ///< sum of each wave over a taxel's columns [taxel][wave]
  std::vector<Between> edge_;       ///< positions of the column edges along x in the slider's grid
  std::vector<float> node_, lower_, upper_, column_, sum_;
};

} // namespace ionskin::live
