// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/edge_interpolation.hpp"
#include "ionskin/live/skin_data.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace ionskin::live {

/// Orthonormal cosine over uniform columns, an eigenvector of the second differences between them.
double column_wave(std::size_t columns, std::uint64_t wave, std::size_t column);

/// Share of every one of uniform columns over a length that lies between two places [columns].
std::vector<double> column_shares(std::size_t columns, double length, double low, double high);

/// Charge that spreads along the skin, from taxel to taxel: the double layers of a column hold it,
/// and the core carries it to the next one. Half the sum of the charges of top and bottom, as
/// cosine waves over the columns, each of which relaxes at a rate of its own, docs/model.md (34).
/// Copies share nothing; nothing is allocated after construction.
class ChargeSpread {
public:
  /// @param data outlives this
  explicit ChargeSpread(const SkinData& data);

  std::size_t waves() const { return data_.spread.rates.size(); }
  /// Derivative by the place along x or y while the amplitudes stay, or none: the drive itself.
  enum class Along { x, y, none };
  /// Drive of the waves [waves()].
  /// @param amplitude of the modes of the driving channel
  void drive(const std::array<double, 2>& place, std::span<const double> amplitude,
             std::span<double> waves, Along derivative = Along::none) noexcept;
  /// Charge that the waves add to a taxel, alike on both sides [C].
  double charge(std::size_t taxel, std::span<const double> relaxed) const noexcept;

private:
  void set_fixed_drive(const ChannelMap& channel);
  void row_at(const Between& at, std::vector<float>& row) const noexcept;

  const SkinData& data_;
  /// Integral of every mode, over its levels with their weights: integral from the lowest corner of
  /// the slider's frame to the crossings of its edges [mode][y edge][x edge].
  std::vector<float> integral_;
  std::vector<double> fixed_drive_; ///< of the modes that stay with the skin [mode][wave]
  std::vector<std::size_t> row_of_; ///< of a wave in `along_y_`
  std::vector<float> along_x_;      ///< [wave][column of x]
  std::vector<float> along_y_;      ///< [different waves][column of y]
  std::vector<double> share_;       ///< [taxel][wave]
  std::vector<Between> edge_;       ///< of the columns of x
  std::vector<float> node_, lower_, upper_, column_, sum_;
};

} // namespace ionskin::live
