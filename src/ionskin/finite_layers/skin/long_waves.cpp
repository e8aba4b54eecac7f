// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/skin/long_waves.hpp"

#include <algorithm>
#include <utility>

namespace ionskin::finite_layers {

// A product of two waves along x is half the wave of the difference of their positions, which does
// not depend on the slider's position, and half the wave of the sum, of which the ends leave a
// share.
LongWaves::LongWaves(std::shared_ptr<const LayerBox> box, const ContactGrid& grid,
                     const std::array<double, 2>& centre, NearEnds near)
    : box_(std::move(box)), near_(std::move(near)), images_(grid.half ? 2 : 1) {
  const ModeLine &along_x = box_->modes.along_x(), &along_y = box_->modes.along_y();
  const ModeTransform of_columns = along_x.transform(grid.x, centre[0]),
                      of_rows = along_y.transform(grid.y, centre[1]);
  rows_ = {of_rows.cosine, of_rows.cosine, of_rows.sine};
  for (Eigen::MatrixXd& waves : rows_) {
    for (Eigen::Index n = 1; n < waves.cols() && grid.half; n += 2) {
      waves.col(n).setZero(); // a symmetric load has no odd modes
    }
  }
  columns_ = {of_columns.cosine, of_columns.sine, of_columns.cosine};
  beside_ = {of_columns.sine, -of_columns.cosine, of_columns.sine};
  Eigen::ArrayXd mirrored = Eigen::ArrayXd::Zero(along_x.wave_numbers.size());
  mirrored.head(near_.share.size()) = near_.share;
  weight_ = 0.5 * along_x.weights * (1 + mirrored);
  weight_beside_ = 0.5 * along_x.weights * (1 - mirrored);
}

/// Calculates the displacements of the modes from their forces. Modes along the skin do not couple;
/// modes across it couple through the motion of the sides.
LongWaves::Modes LongWaves::displaced(const Modes& forces) const {
  Modes result;
  for (Eigen::MatrixXd& one : result) {
    one = Eigen::MatrixXd::Zero(forces[0].rows(), forces[0].cols());
  }
  for (const BoxModes::Between& between : box_->modes.between()) {
    const auto at = static_cast<std::size_t>(between.at),
               from = static_cast<std::size_t>(between.from);
    result[at].array() += images_ * between.waves.array() * forces[from].array();
    if (at != from) {
      result[from].array() += images_ * between.waves.array() * forces[at].array();
    }
  }
  if (!box_->sides) {
    return result;
  }
  const FreeSides& sides = *box_->sides;
  for (Eigen::Index m = 0; m < std::min(sides.modes(), forces[0].rows()); ++m) {
    Eigen::MatrixX3d across(forces[0].cols(), 3), felt = Eigen::MatrixX3d::Zero(across.rows(), 3);
    for (Eigen::Index c = 0; c < 3; ++c) {
      across.col(c) = forces[static_cast<std::size_t>(c)].row(m).transpose();
    }
    for (const Parity parity : parities(images_ == 2)) {
      const Eigen::VectorXd motion =
          sides.stiffness(m, parity).solve(sides.stress(m, parity, across));
      sides.add_felt(m, parity, motion, felt);
    }
    for (Eigen::Index c = 0; c < 3; ++c) {
      result[static_cast<std::size_t>(c)].row(m) += images_ * felt.col(c).transpose();
    }
  }
  return result;
}

void LongWaves::add(const CellFields& forces, CellFields& displacements) const {
  add_at(*this, forces, displacements);
}

void LongWaves::add_at(const LongWaves& other, const CellFields& forces,
                       CellFields& displacements) const {
  Modes of_forces, beside;
  for (std::size_t c = 0; c < 3; ++c) {
    const Eigen::MatrixXd across = forces[c] * rows_[c]; // [column, n]
    of_forces[c] = columns_[c].transpose() * across;
    beside[c] = beside_[c].transpose() * across;
  }
  Modes moved = displaced(of_forces), moved_beside = displaced(beside);
  Modes by_ends;
  for (std::size_t c = 0; c < 3; ++c) {
    moved[c] = weight_.matrix().asDiagonal() * moved[c];
    moved_beside[c] = weight_beside_.matrix().asDiagonal() * moved_beside[c];
    by_ends[c] = Eigen::MatrixXd::Zero(moved[c].rows(), moved[c].cols());
  }
  box_->ends->add(of_forces, near_.share, near_.last, by_ends);
  for (std::size_t c = 0; c < 3; ++c) {
    moved[c] += images_ * by_ends[c];
    const Eigen::MatrixXd across =
        other.columns_[c] * moved[c] + other.beside_[c] * moved_beside[c];
    displacements[c].noalias() += across * other.rows_[c].transpose();
  }
}

std::array<double, 3> LongWaves::own() const {
  std::array<double, 3> result{};
  const Eigen::ArrayXd weights = 0.5 * box_->modes.along_x().weights;
  for (const BoxModes::Between& between : box_->modes.between()) {
    if (between.at == between.from) {
      const auto c = static_cast<std::size_t>(between.at);
      const Eigen::ArrayXd square = rows_[c].row(rows_[c].rows() / 2).array().square();
      result[c] = images_ * (between.waves * square.matrix()).dot(weights.matrix());
    }
  }
  return result;
}

} // namespace ionskin::finite_layers
