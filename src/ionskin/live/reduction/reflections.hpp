// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::live {

/// Group of the reflections along x and y that leave skin and slider unchanged, so that a mirrored
/// path has a mirrored response. Element 0 is the identity.
class Reflections {
public:
  /// Group with the reflections along x and along y as far as given.
  Reflections(bool along_x, bool along_y);

  /// Number of elements: 1, 2 or 4; also the number of parities.
  std::size_t count() const { return elements_.size(); }
  /// True for the directions, x and y, along which element g reflects.
  std::array<bool, 2> element(std::size_t g) const { return elements_[g]; }
  /// Sign of a parity under element g: 1 where a quantity of this parity stays unchanged, -1 where
  /// it changes its sign.
  /// @param parity index below `count()`; parity p is odd along the directions of element p
  double sign(std::size_t parity, std::size_t g) const;
  /// Index to which element g maps a value of a field [z][y][x].
  /// @param size numbers of values along x, y, z
  std::size_t image(std::size_t g, std::size_t index, const std::array<std::size_t, 3>& size) const;

private:
  std::vector<std::array<bool, 2>> elements_;
};

} // namespace ionskin::live
