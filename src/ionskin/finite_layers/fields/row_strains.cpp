// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/fields/row_strains.hpp"

#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/parallel/task_pool.hpp"

#include <algorithm>
#include <array>

namespace ionskin::finite_layers {
namespace {

/// Calculates the strains of a block of modes along x per unit force along each direction, [n, m]
/// [1/N].
std::array<Strains, 3> strains_of_forces(const PlaneWaves& waves, const DepthTable& table,
                                         std::size_t level, Eigen::Index first_m,
                                         Eigen::Index modes_y) {
  std::array<Strains, 3> result;
  for (Strains& of_force : result) {
    of_force.fill(Eigen::MatrixXd(modes_y, block_x));
  }
  const BlockColumn zero = BlockColumn::Zero(), one = BlockColumn::Ones();
  Strains column;
  column.fill(Eigen::MatrixXd(block_x, 1));
  WaveBlock block;
  for (Eigen::Index n = 0; n < modes_y; ++n) {
    waves.look_up(table, level, first_m, n, block);
    for (std::size_t force = 0; force < 3; ++force) {
      block.set_strains(force == 0 ? one : zero, force == 1 ? one : zero, force == 2 ? one : zero,
                        column, 0);
      for (std::size_t c = 0; c < 6; ++c) {
        result[force][c].row(n) = column[c].transpose();
      }
    }
  }
  return result;
}

} // namespace

RowStrains::RowStrains(const PlaneWaves& waves, const DepthTable& table,
                       const FieldComponents& components, const ModeTransform& rows,
                       const ModeTransform& along_y, int threads)
    : rows_(rows.cosine.rows()), values_{along_y.cosine.rows() * components.count(0),
                                         along_y.cosine.rows() * components.count(1)} {
  struct Block {
    std::size_t level;
    Eigen::Index first_m;
  };
  std::vector<Block> blocks;
  for (std::size_t level = 0; level < table.levels(); ++level) {
    const Eigen::Index modes = waves.modes_below(table.cutoff(level), 0);
    of_level_.emplace_back(values_[0] + values_[1], 3 * rows_ * modes);
    for (Eigen::Index first_m = 0; first_m < modes; first_m += block_x) {
      blocks.push_back({level, first_m});
    }
  }
  parallel::run_tasks(blocks.size(), threads, [&](std::size_t i) {
    base::check_interrupt();
    const auto [level, first_m] = blocks[i];
    const double last = table.cutoff(level);
    Eigen::Index felt = 0;
    while (felt < waves.modes_y() && waves.modes_below(last, felt) > first_m) {
      ++felt;
    }
    const auto strains = strains_of_forces(waves, table, level, first_m, felt);
    Eigen::MatrixXd loads(felt, 3 * rows_);
    const Eigen::Index count = std::min(block_x, waves.modes_below(last, 0) - first_m);
    for (Eigen::Index m = 0; m < count; ++m) {
      Eigen::Index first = 0;
      for (const std::size_t kind : {0, 1}) {
        for (const std::size_t c : components.of_kind(kind)) {
          for (std::size_t force = 0; force < 3; ++force) {
            loads.middleCols(static_cast<Eigen::Index>(force) * rows_, rows_).array() =
                (force == 2 ? rows.sine : rows.cosine).leftCols(felt).transpose().colwise() *
                strains[force][c].col(m).array();
          }
          const Eigen::ArrayXXd& waves_y = sine_along_y[c] ? along_y.sine : along_y.cosine;
          of_level_[level]
              .block(first, (first_m + m) * 3 * rows_, waves_y.rows(), 3 * rows_)
              .noalias() = waves_y.leftCols(felt).matrix() * loads;
          first += waves_y.rows();
        }
      }
    }
  });
}

void RowStrains::at(std::size_t level, Eigen::Index first_m, const std::vector<WaveLoads>& loads,
                    std::vector<ByKind>& rows) const {
  const Eigen::MatrixXd& known = of_level_[level];
  const Eigen::Index count = std::min(block_x, known.cols() / (3 * rows_) - first_m);
  StatesTogether forces(3 * rows_, states_at_once), strains(known.rows(), states_at_once);
  for (ByKind& of_state : rows) {
    for (const std::size_t kind : {0, 1}) {
      of_state[kind].setZero(block_x, values_[kind]);
    }
  }
  for (std::size_t first = 0; first < loads.size(); first += states_at_once) {
    const std::size_t last = std::min<std::size_t>(first + states_at_once, loads.size());
    forces.setZero();
    for (Eigen::Index m = 0; m < count; ++m) {
      for (std::size_t state = first; state < last; ++state) {
        const auto own = static_cast<Eigen::Index>(state - first);
        for (std::size_t c = 0; c < 3; ++c) {
          forces.col(own).segment(static_cast<Eigen::Index>(c) * rows_, rows_) =
              loads[state].of_columns[c].row(first_m + m).transpose();
        }
      }
      strains.noalias() = known.middleCols((first_m + m) * 3 * rows_, 3 * rows_) * forces;
      for (std::size_t state = first; state < last; ++state) {
        const auto own = strains.col(static_cast<Eigen::Index>(state - first));
        rows[state][0].row(m) = own.head(values_[0]).transpose();
        rows[state][1].row(m) = own.tail(values_[1]).transpose();
      }
    }
  }
}

} // namespace ionskin::finite_layers
