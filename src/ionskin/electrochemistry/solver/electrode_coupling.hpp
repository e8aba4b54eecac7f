// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/electrochemistry/circuit/top_electrodes.hpp"
#include "ionskin/electrochemistry/solver/cosine_transform.hpp"

#include <span>
#include <vector>

namespace ionskin::electrochemistry {

/// The potentials of the conductors of the top face in the preconditioner. In lateral modes the
/// charge of the wall is Y_m times its potential, so that all conductors together are a small dense
/// system, docs/model.md (64):
///   (B^T Y B + conductance) u = charge.
class ElectrodeCoupling {
public:
  ElectrodeCoupling(const TopElectrodes& electrodes, const CosineTransform& transform);

  /// @param admittance Y of every mode
  void set_admittance(std::span<const double> admittance);

  /// Potentials of the conductors, 0 for those that are held.
  /// @param charge of the wall at potentials of 0, by mode
  std::vector<double> potentials(const ElectrodeStage& stage, std::span<const float> charge);

  /// Modes of the potential of the wall.
  void spread(std::span<const double> potentials, std::span<float> modes) const;

  /// B^T Y B, row by row: the charge of one conductor by the potential of another.
  const std::vector<double>& admittance() const { return matrix_; }

private:
  void invert(const ElectrodeStage& stage);

  std::size_t count_;
  std::vector<std::vector<float>> modes_; ///< of the shares of each conductor
  std::vector<double> matrix_, inverse_;
  std::vector<double> conductance_; ///< for which `inverse_` stands; empty for none
};

} // namespace ionskin::electrochemistry
