// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/circuit/wall_electrodes.hpp"
#include "ionskin/electrochemistry/solver/cosine_transform.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// The potentials of the conductors of the walls in the preconditioner, docs/model.md (64). In
/// lateral modes the charges of the walls are a matrix Y_m of 2 x 2, or a number where the top face
/// alone is cut, times their potentials, so that all conductors together are a small dense system:
///   (B^T Y B + conductance) u = charge.
class ElectrodeCoupling {
public:
  ElectrodeCoupling(const WallElectrodes& electrodes, const CosineTransform& transform);

  /// Takes the admittances of the modes, which `potentials` then uses.
  /// @param admittance Y of every mode: the charge of wall a by the potential of wall b,
  ///   admittance[a][b]; empty of a wall without conductors
  void set_admittance(const std::array<std::array<std::vector<double>, 2>, 2>& admittance);

  /// Potentials of the conductors, 0 for those that are held.
  /// @param charge of either wall that the potentials must bring, by mode
  std::vector<double> potentials(const ElectrodeStage& stage,
                                 const std::array<std::vector<float>, 2>& charge);

  /// Modes of the potentials of both walls.
  std::array<std::vector<float>, 2> spread(std::span<const double> potentials) const;

  /// B^T Y B, row by row: the charge of one conductor by the potential of another.
  const std::vector<double>& admittance() const { return matrix_; }

private:
  void invert(const ElectrodeStage& stage);

  std::size_t count_;
  std::vector<std::size_t> wall_;         ///< of each conductor
  std::vector<std::vector<float>> modes_; ///< of the shares of each conductor
  std::vector<double> matrix_, inverse_;
  std::vector<double> conductance_; ///< for which `inverse_` stands; empty for none
};

} // namespace ionskin::electrochemistry
