// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::live {

/// Reflections along x and y under which skin and slider are what they were, so that a mirrored
/// path has a mirrored answer; that of nothing is the first.
class Reflections {
public:
  Reflections(bool along_x, bool along_y);

  std::size_t count() const { return elements_.size(); }
  std::array<bool, 2> element(std::size_t g) const { return elements_[g]; }
  /// Signs of as many parities as there are reflections: 1 where what has the parity stays under
  /// one, -1 where it changes its sign.
  double sign(std::size_t parity, std::size_t g) const;
  /// Place to which a value of [z][y][x] goes.
  std::size_t image(std::size_t g, std::size_t index, const std::array<std::size_t, 3>& size) const;

private:
  std::vector<std::array<bool, 2>> elements_;
};

} // namespace ionskin::live
