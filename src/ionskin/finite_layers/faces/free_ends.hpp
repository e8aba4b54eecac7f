// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/faces/free_sides.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <array>
#include <vector>

namespace ionskin::finite_layers {

/// Compliance that the two ends add to a skin on rollers where they are free of stress instead,
/// docs/model.md (57): as `FreeSides`, but that modes across the ends meet in the sides, which are
/// eliminated first.
class FreeEnds {
public:
  /// @param sides free sides; null where rollers hold them. Outlives this
  /// @param resolution its modes are those along an end, across the skin
  /// @param mirrored whether modes of even n alone are loaded, and made
  FreeEnds(const ThicknessColumn& column, double length, double width, const WaveSplit& split,
           const FaceResolution& resolution, const FreeSides* sides, bool mirrored = false,
           int threads = 1);

  /// Forces on rows of cells, as far as the ends feel them.
  class Rows {
  public:
    /// Adds to the compliance of cells, [3 cell + component].
    /// @param centre_x of the slider [m]
    /// @param share of each of the first modes along x that the ends feel
    /// @param last wave number along the ends up to which modes count in full [1/m]
    void add(const ContactGrid& grid, double centre_x, const Eigen::ArrayXd& share, double last,
             Eigen::MatrixXd& compliance) const;

  private:
    friend class FreeEnds;
    const FreeEnds* ends_ = nullptr;
    /// Stress of the ends over unit forces of the rows, of each class and mode along the skin,
    /// [unknown, 3 row + component].
    std::array<std::vector<Eigen::MatrixXd>, 4> stress_;
  };
  /// Forces on the rows of a grid, with the slider's centre at a place across the skin.
  /// @param centre_y of the slider [m]
  Rows rows(const ContactGrid& grid, double centre_y) const;

  /// Adds to the displacement of modes the part of the free ends under forces given by their modes,
  /// as `Rows::add` does for cells.
  /// @param forces sums over cells of force and means of the modes: normal, x, y, [m, n] [N]
  /// @param share,last as of `Rows::add`
  void add(const std::array<Eigen::MatrixXd, 3>& forces, const Eigen::ArrayXd& share, double last,
           std::array<Eigen::MatrixXd, 3>& displacement) const;

  /// Outwards motion of the ends where they are free of stress, for modes m and n of one parity
  /// each: the two ends move alike under even m.
  struct Motion {
    Parity along_x, along_y;
    std::vector<Eigen::Index> modes_y;
    Eigen::MatrixXd nodes; ///< [node, mode n], coefficients of cosines along the end [m]
  };
  /// Motions of the ends under forces, one for each pair of parities that occur.
  /// @param forces sums over cells of force and means of the modes: normal, x, y, [m, n] [N]
  /// @param mirrored whether even n alone occur
  /// @param on_sides stress on the sides by these forces, [even or odd n][node, m]; that by the
  /// motion
  ///        of the ends is added to it; unused where rollers hold the sides
  std::vector<Motion> motion(const std::array<Eigen::MatrixXd, 3>& forces, bool mirrored,
                             std::array<Eigen::MatrixXd, 2>& on_sides) const;
  /// Modes along the ends, and parity of those across the skin, in the order of `motion`.
  struct ModesOfClass {
    Parity parity;
    std::vector<Eigen::Index> along_y;
  };
  std::vector<ModesOfClass> modes(bool mirrored) const;

private:
  /// Modes m of one parity and n of one parity, which meet no others.
  struct Class {
    Parity along_x, along_y;
    std::vector<Eigen::Index> modes_y;     ///< along the ends
    Eigen::LLT<Eigen::MatrixXd> stiffness; ///< of the ends, with the sides eliminated
    /// Rows of each mode m of this parity: stress over tractions on the top, of each mode n,
    /// [3][unknown at n], and on the sides over the motion of the ends, [node, unknown].
    std::vector<std::vector<Eigen::MatrixX3d>> stress;
    std::vector<Eigen::MatrixXd> on_sides;

    Eigen::Index nodes() const {
      const auto blocks = static_cast<Eigen::Index>(modes_y.size());
      return blocks == 0 ? 0 : stiffness.rows() / blocks;
    }
  };
  /// The first of the unknowns of a class, whose modes along the ends count.
  Eigen::Index unknowns(const Class& own, double last) const;
  Class solved(const ThicknessColumn& column, double length, double width, const WaveSplit& split,
               const FaceResolution& resolution, Parity along_x, Parity along_y, int threads) const;

  ModeLine along_x_, along_y_;
  const FreeSides* sides_;
  std::vector<Class> classes_;
};

} // namespace ionskin::finite_layers
