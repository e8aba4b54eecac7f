// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/fields/depth_table.hpp"
#include "ionskin/finite_layers/fields/field_components.hpp"
#include "ionskin/finite_layers/fields/wave_block.hpp"
#include "ionskin/finite_layers/plane/box_modes.hpp"

#include <Eigen/Core>

#include <array>
#include <functional>
#include <vector>

namespace ionskin::finite_layers {

/// Forces on the cells, [column, row], for each of normal (downwards), x, y [N].
using CellForces = std::array<Eigen::MatrixXd, 3>;

/// Forces of one state on the cells, expressed by the modes of a box.
struct WaveLoads {
  /// Forces summed with the means of the modes along x over the columns, [m, row], for each of
  /// normal, x, y [N].
  std::array<Eigen::MatrixXd, 3> of_columns;
  ModeTransform rows; ///< means of the modes along y over the rows, [row, n]

  /// Sums the forces over the columns.
  /// @param columns means of the modes along x over the columns, [column, m]
  /// @param of_rows means of the modes along y over the rows, [row, n]
  WaveLoads(const CellForces& forces, const ModeTransform& columns, ModeTransform of_rows);
  /// Calculates the sums over all cells of the force times the means of the mode, for a block of
  /// modes, [m, n] [N].
  /// @param component 0 normal, 1 x, 2 y
  Eigen::MatrixXd by_mode(std::size_t component, Eigen::Index first_m, Eigen::Index count_m,
                          Eigen::Index first_n, Eigen::Index count_n) const;
};

/// Means of the modes along x and y over the places at which the strain of a state is wanted, each
/// [place, mode].
struct WavePlaces {
  ModeTransform along_x, along_y;
};

class RowStrains;

/// Modes of a box whose side faces are held by rollers. They calculate the strain within the box
/// that forces on its top face cause, docs/model.md (58), (59).
class PlaneWaves {
public:
  /// Chooses the modes of a box.
  /// @param length,width of the box [m]
  /// @param mirrored true if loads are symmetric about the middle of the width, so that even modes
  /// along y suffice
  /// @param share factor on each wave, as a function of the wave number [1/m]
  /// @param last wave number beyond which there are no waves [1/m]
  PlaneWaves(double length, double width, bool mirrored, const std::function<double(double)>& share,
             double last);

  double step_x() const { return step_x_; } ///< between wave numbers along x [1/m]
  double step_y() const { return step_y_; } ///< between wave numbers along y [1/m]
  /// Number of modes along x, rounded up to whole blocks of modes that are summed at once.
  Eigen::Index modes_x() const { return cosine_.rows(); }
  /// Number of modes along y.
  Eigen::Index modes_y() const { return cosine_.cols(); }

  /// Number of modes along x whose wave number, together with mode n along y, is at most `last`
  /// [1/m].
  Eigen::Index modes_below(double last, Eigen::Index n) const;
  /// Fills a block with consecutive modes along x and one mode along y, at one level.
  /// @param table strain at the level over the wave number
  /// @param first_m first mode along x of the block
  /// @param n mode along y
  void look_up(const DepthTable& table, std::size_t level, Eigen::Index first_m, Eigen::Index n,
               WaveBlock& block) const;

  /// Adds the strain at one level, with one entry per state in `loads`, `places` and `sums`.
  /// @param sums for each kind of components, [place along x, place along y + number of these *
  /// component] [1]
  void add(const DepthTable& table, std::size_t level, const FieldComponents& components,
           const std::vector<WaveLoads>& loads, const std::vector<WavePlaces>& places,
           std::vector<ByKind>& sums) const;
  /// Adds the strain at one level as the other overload does, for states that share their places
  /// along y and the position of the slider across the skin, so that the sums along y are known.
  /// @param known sums along y
  void add(const RowStrains& known, const DepthTable& table, std::size_t level,
           const std::vector<WaveLoads>& loads, const std::vector<WavePlaces>& places,
           std::vector<ByKind>& sums) const;

private:
  /// Adds the sum over a block of modes along x for a block of modes along y, [place along x, mode
  /// along y + number of these * component].
  void add_block(const DepthTable& table, std::size_t level, Eigen::Index first_m,
                 Eigen::Index first_n, const FieldComponents& components,
                 const std::vector<WaveLoads>& loads, const std::vector<WavePlaces>& places,
                 std::vector<ByKind>& sums) const;

  double step_x_, step_y_;
  Eigen::ArrayXXd cosine_, sine_; ///< direction of the wave, [m, n] [1]
  Eigen::ArrayXXd logarithm_;     ///< of the wave number in 1/m, [m, n]
  Eigen::ArrayXXd weight_;        ///< weight of the mode times its share, [m, n] [1/m2]
};

} // namespace ionskin::finite_layers
