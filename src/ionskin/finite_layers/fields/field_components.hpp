// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/fields/states_at_once.hpp"

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace ionskin::finite_layers {

/// One matrix for each tensor component of the strain: xx, yy, zz, yz, xz, xy.
using Strains = std::array<Eigen::MatrixXd, 6>;
/// True where a component varies like the sine of the modes along x, or along y; false where it
/// varies like the cosine. Order of components: xx, yy, zz, yz, xz, xy.
inline constexpr std::array<bool, 6> sine_along_x{false, false, false, false, true, true},
    sine_along_y{false, false, false, true, false, true};

/// Choice of strain components, in the order xx, yy, zz, yz, xz, xy.
using ComponentChoice = std::array<bool, 6>;
inline constexpr ComponentChoice all_components{true, true, true, true, true, true};

/// Chosen components, sorted into those that vary like cosines along x (kind 0) and those that vary
/// like sines (kind 1). Each kind is summed as one matrix.
class FieldComponents {
public:
  explicit FieldComponents(const ComponentChoice& choice) {
    for (std::size_t c = 0; c < choice.size(); ++c) {
      if (choice[c]) {
        of_kind_[sine_along_x[c] ? 1 : 0].push_back(c);
      }
    }
  }

  /// Chosen components of one kind, as indices into xx, yy, zz, yz, xz, xy.
  /// @param kind 0: cosines along x, 1: sines
  const std::vector<std::size_t>& of_kind(std::size_t kind) const { return of_kind_[kind]; }
  /// Number of chosen components of one kind.
  Eigen::Index count(std::size_t kind) const {
    return static_cast<Eigen::Index>(of_kind_[kind].size());
  }
  /// Number of chosen components.
  Eigen::Index count() const { return count(0) + count(1); }

private:
  std::array<std::vector<std::size_t>, 2> of_kind_;
};

/// One vector per state in each column, for a fixed number of states.
using StatesTogether = Eigen::Matrix<double, Eigen::Dynamic, states_at_once>;

/// Strains as one matrix for each kind of components. A matrix holds its components one after
/// another in its columns.
using ByKind = std::array<Eigen::MatrixXd, 2>;

} // namespace ionskin::finite_layers
