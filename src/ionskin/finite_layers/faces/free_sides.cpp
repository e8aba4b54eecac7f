// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/faces/free_sides.hpp"

#include "ionskin/parallel/task_pool.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace ionskin::finite_layers {

FreeSides::FreeSides(const ThicknessColumn& column, double length, double width,
                     const WaveSplit& split, const FaceResolution& resolution, bool mirrored,
                     int threads)
    : along_y_(ModeLine::up_to(width, split.last_long())),
      of_mode_(static_cast<std::size_t>(resolution.modes)) {
  const double step = std::numbers::pi / length;
  const double full = static_cast<double>(resolution.modes) * step / fading_end;
  parallel::run_tasks(of_mode_.size(), threads, [&](std::size_t m) {
    const double kx = static_cast<double>(m) * step;
    for (const Parity parity : parities(mirrored)) {
      of_mode_[m][parity == Parity::even ? 0 : 1] =
          solved(column, kx, parity, width, split, resolution, full);
    }
  });
}

FreeSides::OfParity FreeSides::solved(const ThicknessColumn& column, double kx, Parity parity,
                                      double width, const WaveSplit& split,
                                      const FaceResolution& resolution, double full) const {
  const Eigen::Index nodes = column.nodes(), modes = along_y_.wave_numbers.size();
  const Eigen::Index first = parity == Parity::even ? 0 : 1;
  const Eigen::Index loaded = (modes - first + 1) / 2;
  OfParity result;
  result.stress.fill(Eigen::MatrixXd(nodes, loaded));
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(nodes, nodes);
  const int summed = std::max(resolution.one_by_one, static_cast<int>(modes));
  for (const ModeTerm& term : mode_sum(parity, summed)) {
    const PlaneMode mode{kx, term.number * std::numbers::pi / width};
    const auto place = static_cast<Eigen::Index>(term.number);
    const double share = split.long_share(std::hypot(mode.x, mode.y));
    if (term.number <= summed && place < modes) {
      const FaceTerms terms = face_terms(column, mode, Face::side);
      stiffness += 4 / width * term.weight * terms.stiffness;
      for (Eigen::Index c = 0; c < 3; ++c) {
        result.stress[static_cast<std::size_t>(c)].col((place - first) / 2) =
            2 / width * term.weight * share * terms.stress.col(c);
      }
    } else {
      stiffness += 4 / width * term.weight * face_stiffness(column, mode, Face::side);
    }
  }
  result.stiffness.compute(stiffness / fading_share(kx, full));
  return result;
}

Eigen::MatrixXd FreeSides::stress(Eigen::Index mode, Parity parity,
                                  const ModeTransform& of_rows) const {
  const OfParity& sides = of(mode, parity);
  const Eigen::Index rows = of_rows.cosine.rows(), first = parity == Parity::even ? 0 : 1;
  const auto own = Eigen::seqN(first, sides.stress[0].cols(), 2);
  Eigen::MatrixXd result(sides.stiffness.rows(), 3 * rows);
  for (Eigen::Index c = 0; c < 3; ++c) {
    const Eigen::MatrixXd loads = (c == 2 ? of_rows.sine : of_rows.cosine)(Eigen::all, own);
    result(Eigen::all, Eigen::seqN(c, rows, 3)) =
        sides.stress[static_cast<std::size_t>(c)] * loads.transpose();
  }
  return result;
}

Eigen::VectorXd FreeSides::stress(Eigen::Index mode, Parity parity,
                                  const Eigen::MatrixX3d& forces) const {
  const OfParity& sides = of(mode, parity);
  const auto own = Eigen::seqN(parity == Parity::even ? 0 : 1, sides.stress[0].cols(), 2);
  Eigen::VectorXd result = Eigen::VectorXd::Zero(sides.stiffness.rows());
  for (Eigen::Index c = 0; c < 3; ++c) {
    const Eigen::VectorXd of_parity = forces(own, c);
    result += sides.stress[static_cast<std::size_t>(c)] * of_parity;
  }
  return result;
}

void FreeSides::add_felt(Eigen::Index mode, Parity parity, const Eigen::VectorXd& motion,
                         Eigen::MatrixX3d& displacement) const {
  const OfParity& sides = of(mode, parity);
  const auto own = Eigen::seqN(parity == Parity::even ? 0 : 1, sides.stress[0].cols(), 2);
  for (Eigen::Index c = 0; c < 3; ++c) {
    displacement(own, c) += sides.stress[static_cast<std::size_t>(c)].transpose() * motion;
  }
}

void FreeSides::add(const ContactGrid& grid, double centre_y,
                    std::vector<Eigen::MatrixXd>& rows) const {
  const ModeTransform of_rows = along_y_.transform(grid.y, centre_y);
  const double images = grid.half ? 2 : 1;
  for (Eigen::Index m = 0; m < std::min(modes(), static_cast<Eigen::Index>(rows.size())); ++m) {
    for (const Parity parity : parities(grid.half)) {
      const Eigen::MatrixXd half = stiffness(m, parity).matrixL().solve(stress(m, parity, of_rows));
      rows[static_cast<std::size_t>(m)].noalias() += images * half.transpose() * half;
    }
  }
}

} // namespace ionskin::finite_layers
