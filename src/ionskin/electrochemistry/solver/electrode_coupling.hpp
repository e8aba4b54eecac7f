// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/circuit/wall_electrodes.hpp"
#include "ionskin/electrochemistry/solver/cosine_transform.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// Equations for the potentials of the conductors on the walls, as a part of the preconditioner,
/// docs/model.md (64). In each lateral mode m the charges of the walls are Y_m times their
/// potentials, with a 2 x 2 matrix Y_m, or a number where only the top face is cut. All conductors
/// together are then a small dense system:
///   (B^T Y B + conductance) u = charge.
class ElectrodeCoupling {
public:
  ElectrodeCoupling(const WallElectrodes& electrodes, const CosineTransform& transform);

  /// Sets the admittances of the modes, from which `potentials` solves.
  /// @param admittance Y of every mode, the charge of wall a by the potential of wall b:
  ///   admittance[a][b][mode]; empty for a wall without conductors
  void set_admittance(const std::array<std::array<std::vector<double>, 2>, 2>& admittance);

  /// Computes the potentials of the conductors; 0 for those that the ground holds.
  /// @param charge of either wall that the potentials must bring, [bottom, top][mode]
  std::vector<double> potentials(const ElectrodeStage& stage,
                                 const std::array<std::vector<float>, 2>& charge);

  /// Computes the modes of the potentials of both walls from the conductors' potentials, [bottom,
  /// top][mode]; empty for a wall without conductors.
  std::array<std::vector<float>, 2> spread(std::span<const double> potentials) const;

  /// Matrix B^T Y B, row by row: the charge of one conductor by the potential of another.
  const std::vector<double>& admittance() const { return matrix_; }

private:
  void invert(const ElectrodeStage& stage);

  std::size_t count_;
  std::vector<std::size_t> wall_; ///< of each conductor
  /// Modes of the shares of each conductor.
  std::vector<std::vector<float>> modes_;
  std::vector<double> matrix_, inverse_;
  std::vector<double> conductance_; ///< for which `inverse_` holds; empty for none
};

} // namespace ionskin::electrochemistry
