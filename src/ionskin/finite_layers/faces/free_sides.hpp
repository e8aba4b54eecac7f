// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/faces/face_modes.hpp"
#include "ionskin/finite_layers/faces/mode_sum.hpp"
#include "ionskin/finite_layers/plane/box_modes.hpp"
#include "ionskin/finite_layers/plane/wave_split.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <array>
#include <vector>

namespace ionskin::finite_layers {

/// Resolution of a free face.
struct FaceResolution {
  Eigen::Index modes = 0; ///< number of modes along the face; the last third fades out
  int one_by_one = 60;    ///< number up to which modes normal to the face are summed singly
};

/// Compliance that the two sides add to a skin because they are free of stress instead of held by
/// rollers: they move outwards until the stress is gone, docs/model.md (56). This is the
/// capacitance matrix method (Buzbee, Dorr, George and Golub 1971, DOI 10.1137/0708066). Modes
/// along the skin do not couple, and the expensive part depends only on the skin.
class FreeSides {
public:
  /// Makes the stiffness of the sides for each mode along the skin.
  /// @param length,width of the skin [m]
  /// @param split whose long waves the sides feel
  /// @param mirrored true if all loads are symmetric about the middle of the width, so that only
  /// modes of even n are made
  /// @param threads number of threads to use
  FreeSides(const ThicknessColumn& column, double length, double width, const WaveSplit& split,
            const FaceResolution& resolution, bool mirrored = false, int threads = 1);

  /// Number of modes along the skin.
  Eigen::Index modes() const { return static_cast<Eigen::Index>(of_mode_.size()); }
  /// Adds the effect of the free sides to the compliance of rows of cells, one matrix for each mode
  /// along x from `BoxModes::rows` [m2/N]. Matrices beyond `modes()` stay as they are.
  /// @param centre_y position of the slider's centre along y, from the skin's corner [m]
  void add(const ContactGrid& grid, double centre_y, std::vector<Eigen::MatrixXd>& rows) const;

  /// Factorised stiffness of the sides for one mode along the skin, against motions of the nodes
  /// that are identical (even parity) or opposite (odd) on the two sides [N/m2].
  const Eigen::LLT<Eigen::MatrixXd>& stiffness(Eigen::Index mode, Parity parity) const {
    return of(mode, parity).stiffness;
  }
  /// Calculates the stress that sides on rollers feel at the nodes per force on the rows of cells,
  /// [node, 3 row + component] [1].
  /// @param of_rows means of the modes `along_y` over the rows
  Eigen::MatrixXd stress(Eigen::Index mode, Parity parity, const ModeTransform& of_rows) const;
  /// Calculates the stress that sides on rollers feel at the nodes, [node] [N], under forces given
  /// by modes across the skin. The weight of the mode along the skin, (1 or 2)/length, is not
  /// included.
  /// @param forces sums over the cells of the force times the mean of the mode, [mode across,
  /// component] [N]
  Eigen::VectorXd stress(Eigen::Index mode, Parity parity, const Eigen::MatrixX3d& forces) const;
  /// Adds the displacement of the modes across the skin that a motion of the sides causes: the
  /// transpose of `stress`.
  /// @param motion of the nodes, [node] [m2]: stress [N] solved by `stiffness`
  /// @param displacement to which the result is added, [mode across, component] [m2]
  void add_felt(Eigen::Index mode, Parity parity, const Eigen::VectorXd& motion,
                Eigen::MatrixX3d& displacement) const;
  /// Modes across the skin.
  const ModeLine& along_y() const { return along_y_; }

private:
  struct OfParity {
    Eigen::LLT<Eigen::MatrixXd> stiffness;
    /// Stress at the nodes per traction of each mode n of this parity, with the weight and the
    /// long-wave share of the mode, [node, n] [1], for tractions normal, along x and along y.
    std::array<Eigen::MatrixXd, 3> stress;
  };
  OfParity solved(const ThicknessColumn& column, double kx, Parity parity, double width,
                  const WaveSplit& split, const FaceResolution& resolution, double full) const;
  const OfParity& of(Eigen::Index mode, Parity parity) const {
    return of_mode_[static_cast<std::size_t>(mode)][parity == Parity::even ? 0 : 1];
  }

  ModeLine along_y_;
  std::vector<std::array<OfParity, 2>> of_mode_; ///< [mode along the skin][even or odd n]
};

} // namespace ionskin::finite_layers
