// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/fields/states_at_once.hpp"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::finite_layers {

/// Tensor components xx, yy, zz, yz, xz, xy.
using Strains = std::array<Eigen::MatrixXd, 6>;
/// True where a component goes like the sine of the modes along x, or along y.
inline constexpr std::array<bool, 6> sine_along_x{false, false, false, false, true, true},
    sine_along_y{false, false, false, true, false, true};

/// Components that are asked for.
using ComponentChoice = std::array<bool, 6>;
inline constexpr ComponentChoice all_components{true, true, true, true, true, true};

/// Chosen components, those that go like cosines along x and those that go like sines: each kind is
/// summed as one matrix.
class FieldComponents {
public:
  explicit FieldComponents(const ComponentChoice& choice) {
    for (std::size_t c = 0; c < choice.size(); ++c) {
      if (choice[c]) {
        of_kind_[sine_along_x[c] ? 1 : 0].push_back(c);
      }
    }
  }

  /// Chosen components whose fields along x are of one kind.
  /// @param kind 0: cosines along x, 1: sines
  const std::vector<std::size_t>& of_kind(std::size_t kind) const { return of_kind_[kind]; }
  Eigen::Index count(std::size_t kind) const {
    return static_cast<Eigen::Index>(of_kind_[kind].size());
  }
  Eigen::Index count() const { return count(0) + count(1); }

private:
  std::array<std::vector<std::size_t>, 2> of_kind_;
};

/// A vector of each of the states.
using StatesTogether = Eigen::Matrix<double, Eigen::Dynamic, states_at_once>;

/// A matrix for the components of each kind; in its columns one component after the other.
using ByKind = std::array<Eigen::MatrixXd, 2>;

} // namespace ionskin::finite_layers
