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

/// Resolution of free faces.
struct FaceResolution {
  Eigen::Index modes = 0; ///< along the face, fading from two thirds of them on
  int one_by_one = 60;    ///< modes across the skin that are summed by themselves
};

/// Compliance that the two sides add to a skin on rollers where they are free of stress instead:
/// they move outwards until the stress is gone, docs/model.md (56). It is the capacitance matrix
/// method (Buzbee, Dorr, George and Golub 1971, DOI 10.1137/0708066). The modes along the skin do
/// not couple, and all that is costly depends on the skin alone.
class FreeSides {
public:
  /// @param length,width of the skin [m]
  /// @param split whose long waves the sides feel
  /// @param mirrored whether modes of even n alone are loaded, and made
  FreeSides(const ThicknessColumn& column, double length, double width, const WaveSplit& split,
            const FaceResolution& resolution, bool mirrored = false, int threads = 1);

  Eigen::Index modes() const { return static_cast<Eigen::Index>(of_mode_.size()); }
  /// Adds to the compliance of rows of cells, as `BoxModes::rows` gives them; later modes stay.
  void add(const ContactGrid& grid, double centre_y, std::vector<Eigen::MatrixXd>& rows) const;

  /// Stiffness of a mode along the skin, against motions of both sides at the nodes that are alike
  /// or opposite [N/m2].
  const Eigen::LLT<Eigen::MatrixXd>& stiffness(Eigen::Index mode, Parity parity) const {
    return of(mode, parity).stiffness;
  }
  /// Stress that the sides on rollers feel at the nodes over forces on the rows of cells,
  /// [node, 3 row + component].
  /// @param of_rows transform of the rows by `along_y`
  Eigen::MatrixXd stress(Eigen::Index mode, Parity parity, const ModeTransform& of_rows) const;
  /// Stress that the sides on rollers feel at the nodes, [node] [N/m], under forces that are given
  /// by their modes across the skin.
  /// @param forces sums over cells of force and mean of the mode, [mode, component] [N]
  Eigen::VectorXd stress(Eigen::Index mode, Parity parity, const Eigen::MatrixX3d& forces) const;
  /// Adds the displacement of the modes across the skin by the motion that stress at the nodes
  /// gives the sides: the transpose of `stress`.
  /// @param motion of the nodes [node] @param displacement of the modes, [mode, component]
  void add_felt(Eigen::Index mode, Parity parity, const Eigen::VectorXd& motion,
                Eigen::MatrixX3d& displacement) const;
  const ModeLine& along_y() const { return along_y_; }

private:
  struct OfParity {
    Eigen::LLT<Eigen::MatrixXd> stiffness;
    /// Stress at the nodes over the tractions of the modes n of this parity, weighted, [node, n],
    /// for tractions normal, along x, along y.
    std::array<Eigen::MatrixXd, 3> stress;
  };
  OfParity solved(const ThicknessColumn& column, double kx, Parity parity, double width,
                  const WaveSplit& split, const FaceResolution& resolution, double full) const;
  const OfParity& of(Eigen::Index mode, Parity parity) const {
    return of_mode_[static_cast<std::size_t>(mode)][parity == Parity::even ? 0 : 1];
  }

  ModeLine along_y_;
  std::vector<std::array<OfParity, 2>> of_mode_; ///< even and odd n
};

} // namespace ionskin::finite_layers
