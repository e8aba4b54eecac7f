// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/faces/free_sides.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <array>
#include <vector>

namespace ionskin::finite_layers {

/// Compliance that the two ends add to a skin because they are free of stress instead of held by
/// rollers, docs/model.md (57). The method is the same as in `FreeSides`, but modes along the ends
/// couple through the motion of the sides, which is eliminated first.
class FreeEnds {
public:
  /// Makes the stiffness of the ends, which depends only on the skin.
  /// @param length,width of the skin [m]
  /// @param split whose long waves the ends feel
  /// @param resolution number of modes along an end, which runs across the skin
  /// @param sides free sides, which must outlive this object; null where rollers hold them
  /// @param mirrored true if all loads are symmetric about the middle of the width, so that only
  /// modes of even n are made
  /// @param threads number of threads to use
  FreeEnds(const ThicknessColumn& column, double length, double width, const WaveSplit& split,
           const FaceResolution& resolution, const FreeSides* sides, bool mirrored = false,
           int threads = 1);

  /// Forces on rows of cells, as the ends feel them, with the slider at one position across the
  /// skin.
  class Rows {
  public:
    /// Adds the effect of the free ends to the compliance of the cells, [3 cell + component, 3 cell
    /// + component] [m/N].
    /// @param centre_x position of the slider's centre along x, from the skin's corner [m]
    /// @param share factor on each of the first modes along x [1]; further modes are left out
    /// @param last wave number along the ends up to which modes count in full [1/m]
    void add(const ContactGrid& grid, double centre_x, const Eigen::ArrayXd& share, double last,
             Eigen::MatrixXd& compliance) const;

  private:
    friend class FreeEnds;
    const FreeEnds* ends_ = nullptr;
    /// Stress at the ends per unit force on the rows of cells, for each class and each mode along
    /// x, [unknown, 3 row + component].
    std::array<std::vector<Eigen::MatrixXd>, 4> stress_;
  };
  /// Calculates how the ends feel forces on the rows of a grid.
  /// @param centre_y position of the slider's centre along y, from the skin's corner [m]
  /// @returns an object that must not outlive this one
  Rows rows(const ContactGrid& grid, double centre_y) const;

  /// Adds the effect of the free ends to the displacement of modes, under forces given by modes.
  /// `Rows::add` does this for forces on cells.
  /// @param forces sums over the cells of the force times the means of the mode: normal, x, y, each
  /// [m, n] [N]
  /// @param share,last as `Rows::add` takes them
  /// @param displacement to which the result is added, in the layout of `forces`
  void add(const std::array<Eigen::MatrixXd, 3>& forces, const Eigen::ArrayXd& share, double last,
           std::array<Eigen::MatrixXd, 3>& displacement) const;

  /// Outward motion of the ends at which they are free of stress, for the modes m of one parity and
  /// n of one parity. The two ends move identically under even m and oppositely under odd m.
  struct Motion {
    Parity along_x, along_y;           ///< parities of m and n
    std::vector<Eigen::Index> modes_y; ///< n of each column of `nodes`
    /// Coefficients of the cosines along the end, [node, mode n] [m].
    Eigen::MatrixXd nodes;
  };
  /// Calculates the motions of the ends under forces, one for each pair of parities that occurs.
  /// @param forces sums over the cells of the force times the means of the mode: normal, x, y, each
  /// [m, n] [N]
  /// @param mirrored true if only even n occur
  /// @param on_sides stress on the sides by these forces, [even or odd n][node, m] [N]; stress by
  /// the motion of the ends is added to it. Unused where rollers hold the sides.
  std::vector<Motion> motion(const std::array<Eigen::MatrixXd, 3>& forces, bool mirrored,
                             std::array<Eigen::MatrixXd, 2>& on_sides) const;
  /// Modes n along the ends, with the parity of the modes m along x, for one entry of `motion`.
  struct ModesOfClass {
    Parity parity;
    std::vector<Eigen::Index> along_y;
  };
  /// Lists the modes in the order of the results of `motion`.
  /// @param mirrored true if only even n occur
  std::vector<ModesOfClass> modes(bool mirrored) const;

private:
  /// System of the modes m of one parity and n of one parity, which do not couple to modes of other
  /// parities.
  struct Class {
    Parity along_x, along_y;
    std::vector<Eigen::Index> modes_y;     ///< n of the modes along the ends
    Eigen::LLT<Eigen::MatrixXd> stiffness; ///< of the ends, with the sides eliminated [N/m]
    /// For each mode m of this parity, stress at the ends per traction on the top face for each
    /// mode n, [node, component] [m], and stress on the sides per motion of the ends, [node,
    /// unknown] [N/m].
    std::vector<std::vector<Eigen::MatrixX3d>> stress;
    std::vector<Eigen::MatrixXd> on_sides;

    Eigen::Index nodes() const {
      const auto blocks = static_cast<Eigen::Index>(modes_y.size());
      return blocks == 0 ? 0 : stiffness.rows() / blocks;
    }
  };
  /// Number of leading unknowns of a class whose modes along the ends have a share above 0.
  /// @param last wave number along the ends up to which modes count in full [1/m]
  Eigen::Index unknowns(const Class& own, double last) const;
  Class solved(const ThicknessColumn& column, double length, double width, const WaveSplit& split,
               const FaceResolution& resolution, Parity along_x, Parity along_y, int threads) const;

  ModeLine along_x_, along_y_;
  const FreeSides* sides_;
  std::vector<Class> classes_;
};

} // namespace ionskin::finite_layers
