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

/// Forces of cells, [column, row]: normal (downwards), x, y [N].
using CellForces = std::array<Eigen::MatrixXd, 3>;

/// Forces of a state on the cells, gathered by the modes of a box.
struct WaveLoads {
  std::array<Eigen::MatrixXd, 3> of_columns; ///< by the modes along x, [m, row]: normal, x, y [N]
  ModeTransform rows;                        ///< [row, n]

  /// @param columns [column, m]
  WaveLoads(const CellForces& forces, const ModeTransform& columns, ModeTransform of_rows);
  /// Sums over cells of force and means of the modes, [m, n], of some of the modes [N].
  Eigen::MatrixXd by_mode(std::size_t component, Eigen::Index first_m, Eigen::Index count_m,
                          Eigen::Index first_n, Eigen::Index count_n) const;
};

/// Places where the strain of a state is asked for, [place, mode].
struct WavePlaces {
  ModeTransform along_x, along_y;
};

class RowStrains;

/// Modes of a box whose faces are held by rollers: what forces on its top strain within,
/// docs/model.md (58), (59).
class PlaneWaves {
public:
  /// @param mirrored whether loads are mirrored in the middle of the width, where even modes do
  /// @param share of each wave number that is summed
  /// @param last wave number beyond which none is [1/m]
  PlaneWaves(double length, double width, bool mirrored, const std::function<double(double)>& share,
             double last);

  double step_x() const { return step_x_; } ///< of wave numbers [1/m]
  double step_y() const { return step_y_; }
  /// Some more than are felt: whole blocks of modes are summed at once.
  Eigen::Index modes_x() const { return cosine_.rows(); }
  Eigen::Index modes_y() const { return cosine_.cols(); }

  /// Modes along x of a wave number of at most `last`, for a mode along y.
  Eigen::Index modes_below(double last, Eigen::Index n) const;
  /// Reads a block of waves at a level from the table.
  /// @param first_m,n modes along x, of which a block is looked up, and along y
  void look_up(const DepthTable& table, std::size_t level, Eigen::Index first_m, Eigen::Index n,
               WaveBlock& block) const;

  /// Adds the strain of states at a level, at their places.
  /// @param sums of each state, [place along x, place along y + count of these * component]
  void add(const DepthTable& table, std::size_t level, const FieldComponents& components,
           const std::vector<WaveLoads>& loads, const std::vector<WavePlaces>& places,
           std::vector<ByKind>& sums) const;
  /// Adds the strain of states at a level, at their places, as above, where the sums along y are
  /// alike for all states and known.
  void add(const RowStrains& known, const DepthTable& table, std::size_t level,
           const std::vector<WaveLoads>& loads, const std::vector<WavePlaces>& places,
           std::vector<ByKind>& sums) const;

private:
  /// Adds sums over a block of modes along x, of a block of modes along y,
  /// [place along x, mode along y + count of these * component].
  void add_block(const DepthTable& table, std::size_t level, Eigen::Index first_m,
                 Eigen::Index first_n, const FieldComponents& components,
                 const std::vector<WaveLoads>& loads, const std::vector<WavePlaces>& places,
                 std::vector<ByKind>& sums) const;

  double step_x_, step_y_;
  Eigen::ArrayXXd cosine_, sine_; ///< direction of the wave, [m, n]
  Eigen::ArrayXXd logarithm_;     ///< of its number
  Eigen::ArrayXXd weight_;        ///< of a mode, with its share [1/m2]
};

} // namespace ionskin::finite_layers
