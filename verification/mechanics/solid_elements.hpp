// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::verification {

/// Linear elastic solution of a layered box by triquadratic solid elements, an independent
/// reference for the skin's free sides and ends. The box is fixed at z = 0, has a mirror plane at
/// its largest y, and is free on all other faces; uniform tractions on rectangles of its top face
/// load it.
class SolidElements {
public:
  /// Mesh lines of a tensor grid, ascending from 0 [m].
  struct Lines {
    std::array<std::vector<double>, 3> of; ///< lines along x, y, z
  };
  /// Lame constants of one row of elements along z [Pa].
  struct Lame {
    double lambda = 0, mu = 0;
  };
  /// Uniform traction on a rectangle of the top face whose sides are mesh lines; `force` is its
  /// resultant along x, y, z [N].
  struct Patch {
    std::array<double, 2> x{}, y{}; ///< lower and upper end [m]
    std::array<double, 3> force{};
  };
  /// Solves for the displacement.
  /// @param rows Lame constants of each row of elements along z, from the bottom
  /// @param patches loads
  SolidElements(Lines lines, const std::vector<Lame>& rows, const std::vector<Patch>& patches);

  /// Number of displacement unknowns.
  std::size_t unknowns() const { return static_cast<std::size_t>(displacement_.size()); }
  /// Mean displacement of a rectangle of the top face whose sides are mesh lines, along x, y, z
  /// [m].
  std::array<double, 3> mean_of_top(const std::array<double, 2>& x,
                                    const std::array<double, 2>& y) const;
  /// Strain components xx, yy, zz, yz, xz, xy [1]; the shear components are those of the tensor.
  using Strain = std::array<double, 6>;
  /// Strain at a point (x, y, z) [m].
  Strain strain(const std::array<double, 3>& place) const;
  /// Mean strain of a box whose faces are mesh lines, given by its lower and upper end along x, y,
  /// z [m].
  Strain mean_strain(const std::array<std::array<double, 2>, 3>& box) const;

private:
  using Element = std::array<std::size_t, 3>;

  std::size_t node(const Element& element, std::size_t local) const;
  double size(const Element& element, std::size_t direction) const;
  Strain strain_in(const Element& element, const std::array<double, 3>& local) const;

  Lines lines_;
  Eigen::VectorXd displacement_; ///< displacement [3 node + component] [m]
};

} // namespace ionskin::verification
