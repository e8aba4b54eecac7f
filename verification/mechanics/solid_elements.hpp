// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::verification {

/// One solution of a layered box by plain triquadratic elements: fixed at the bottom, its largest y
/// a mirror, all other faces free; loaded by even tractions on rectangles of its top.
class SolidElements {
public:
  /// Lines of a tensor mesh [m].
  struct Lines {
    std::array<std::vector<double>, 3> of; ///< x, y, z
  };
  /// Lame constants by element row along z [Pa].
  struct Lame {
    double lambda = 0, mu = 0;
  };
  /// An even traction between lines of the mesh; the sum of it along x, y, z [N].
  struct Patch {
    std::array<double, 2> x{}, y{}; ///< from, to [m]
    std::array<double, 3> force{};
  };
  SolidElements(Lines lines, const std::vector<Lame>& rows, const std::vector<Patch>& patches);

  std::size_t unknowns() const { return static_cast<std::size_t>(displacement_.size()); }
  /// Mean displacement of a rectangle of the top between lines.
  std::array<double, 3> mean_of_top(const std::array<double, 2>& x,
                                    const std::array<double, 2>& y) const;
  /// xx, yy, zz, yz, xz, xy.
  using Strain = std::array<double, 6>;
  Strain strain(const std::array<double, 3>& place) const;
  /// Mean strain between lines along each direction.
  Strain mean_strain(const std::array<std::array<double, 2>, 3>& box) const;

private:
  using Element = std::array<std::size_t, 3>;

  std::size_t node(const Element& element, std::size_t local) const;
  double size(const Element& element, std::size_t direction) const;
  Strain strain_in(const Element& element, const std::array<double, 3>& local) const;

  Lines lines_;
  Eigen::VectorXd displacement_; ///< [3 node + component] [m]
};

} // namespace ionskin::verification
