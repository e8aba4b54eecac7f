// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/faces/free_ends.hpp"

#include "ionskin/parallel/task_pool.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace ionskin::finite_layers {
namespace {

/// Lists the modes 0, 2, 4, ... or 1, 3, 5, ... below a count.
std::vector<Eigen::Index> modes_of(Parity parity, Eigen::Index count) {
  std::vector<Eigen::Index> modes;
  for (Eigen::Index i = parity == Parity::even ? 0 : 1; i < count; i += 2) {
    modes.push_back(i);
  }
  return modes;
}

/// Factor of a mode in the sum over cosine modes: 1 for the uniform mode 0, 2 for all others.
double multiplicity(Eigen::Index mode) {
  return mode == 0 ? 1 : 2;
}

} // namespace

FreeEnds::FreeEnds(const ThicknessColumn& column, double length, double width,
                   const WaveSplit& split, const FaceResolution& resolution, const FreeSides* sides,
                   bool mirrored, int threads)
    : along_x_(ModeLine::up_to(
          length, std::max(split.last_long(),
                           sides == nullptr
                               ? 0.0
                               : static_cast<double>(sides->modes()) * std::numbers::pi / length))),
      along_y_(ModeLine::up_to(width, split.last_long())), sides_(sides) {
  for (const Parity along_y : parities(mirrored)) {
    for (const Parity along_x : {Parity::even, Parity::odd}) {
      classes_.push_back(
          solved(column, length, width, split, resolution, along_x, along_y, threads));
    }
  }
}

FreeEnds::Class FreeEnds::solved(const ThicknessColumn& column, double length, double width,
                                 const WaveSplit& split, const FaceResolution& resolution,
                                 Parity along_x, Parity along_y, int threads) const {
  const Eigen::Index nodes = column.nodes();
  Class result{along_x, along_y, modes_of(along_y, resolution.modes), {}, {}, {}};
  const auto modes_x = modes_of(along_x, along_x_.wave_numbers.size());
  const auto blocks = static_cast<Eigen::Index>(result.modes_y.size());
  const Eigen::Index size = nodes * blocks, coupled = sides_ == nullptr ? 0 : sides_->modes();
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(size, size);
  result.stress.assign(modes_x.size(), std::vector<Eigen::MatrixX3d>(result.modes_y.size()));
  result.on_sides.assign(modes_x.size(), Eigen::MatrixXd());
  for (std::size_t at = 0; at < modes_x.size() && modes_x[at] < coupled; ++at) {
    result.on_sides[at].resize(nodes, size);
  }
  parallel::run_tasks(result.modes_y.size(), threads, [&](std::size_t of_block) {
    const auto block = static_cast<Eigen::Index>(of_block);
    const Eigen::Index n = result.modes_y[of_block];
    const double ky = static_cast<double>(n) * std::numbers::pi / width;
    const double factor = 4 * width / (multiplicity(n) * length);
    const auto own = Eigen::seqN(block * nodes, nodes);
    const int summed = std::max<int>(resolution.one_by_one, static_cast<int>(modes_x.back()));
    std::size_t at = 0;
    for (const ModeTerm& term : mode_sum(along_x, summed)) {
      const PlaneMode mode{term.number * std::numbers::pi / length, ky};
      if (at < modes_x.size()) { // the terms begin with the modes of `modes_x`
        const Eigen::Index m = modes_x[at];
        const FaceTerms terms = face_terms(column, mode, Face::end);
        stiffness(own, own) += factor * term.weight * terms.stiffness;
        result.stress[at][of_block] =
            2 * split.long_share(std::hypot(mode.x, mode.y)) * terms.stress;
        if (m < coupled) {
          result.on_sides[at](Eigen::all, own) = 4 * terms.on_sides;
        }
      } else {
        stiffness(own, own) += factor * term.weight * face_stiffness(column, mode, Face::end);
      }
      ++at;
    }
  });
  for (std::size_t at = 0; at < modes_x.size() && modes_x[at] < coupled; ++at) {
    const Eigen::MatrixXd half =
        sides_->stiffness(modes_x[at], along_y).matrixL().solve(result.on_sides[at]);
    stiffness.noalias() -= multiplicity(modes_x[at]) / length * half.transpose() * half;
  }
  result.stiffness.compute(stiffness);
  return result;
}

FreeEnds::Rows FreeEnds::rows(const ContactGrid& grid, double centre_y) const {
  Rows result;
  result.ends_ = this;
  const ModeTransform of_rows = along_y_.transform(grid.y, centre_y);
  const ModeTransform beside_sides =
      sides_ == nullptr ? ModeTransform() : sides_->along_y().transform(grid.y, centre_y);
  const Eigen::Index count = grid.rows();
  for (std::size_t c = 0; c < classes_.size(); ++c) {
    const Class& own = classes_[c];
    if (grid.half && own.along_y == Parity::odd) {
      continue;
    }
    const Eigen::Index first = own.along_x == Parity::even ? 0 : 1;
    for (std::size_t at = 0; at < own.stress.size(); ++at) {
      const Eigen::Index m = first + 2 * static_cast<Eigen::Index>(at);
      Eigen::MatrixXd stress(own.stiffness.rows(), 3 * count);
      for (std::size_t block = 0; block < own.modes_y.size(); ++block) {
        const Eigen::MatrixX3d& terms = own.stress[at][block];
        const auto nodes =
            Eigen::seqN(static_cast<Eigen::Index>(block) * terms.rows(), terms.rows());
        for (Eigen::Index component = 0; component < 3; ++component) {
          const auto& wave = component == 2 ? of_rows.sine : of_rows.cosine;
          stress(nodes, Eigen::seqN(component, count, 3)) =
              terms.col(component) * wave.col(own.modes_y[block]).matrix().transpose();
        }
      }
      if (own.on_sides[at].size() > 0) {
        stress.noalias() -=
            own.on_sides[at].transpose() *
            sides_->stiffness(m, own.along_y).solve(sides_->stress(m, own.along_y, beside_sides));
      }
      result.stress_[c].push_back(multiplicity(m) / along_x_.extent * stress);
    }
  }
  return result;
}

std::vector<FreeEnds::ModesOfClass> FreeEnds::modes(bool mirrored) const {
  std::vector<ModesOfClass> result;
  for (const Class& own : classes_) {
    if (!mirrored || own.along_y == Parity::even) {
      result.push_back({own.along_x, own.modes_y});
    }
  }
  return result;
}

std::vector<FreeEnds::Motion> FreeEnds::motion(const std::array<Eigen::MatrixXd, 3>& forces,
                                               bool mirrored,
                                               std::array<Eigen::MatrixXd, 2>& on_sides) const {
  std::vector<Motion> result;
  for (const Class& own : classes_) {
    if (mirrored && own.along_y == Parity::odd) {
      continue;
    }
    const Eigen::Index first = own.along_x == Parity::even ? 0 : 1;
    const auto blocks = static_cast<Eigen::Index>(own.modes_y.size());
    const Eigen::Index nodes = own.stiffness.rows() / blocks;
    Eigen::MatrixXd& sides = on_sides[own.along_y == Parity::even ? 0 : 1];
    Eigen::VectorXd stress = Eigen::VectorXd::Zero(own.stiffness.rows());
    for (std::size_t at = 0; at < own.stress.size(); ++at) {
      const Eigen::Index m = first + 2 * static_cast<Eigen::Index>(at);
      const double weight = multiplicity(m) / along_x_.extent;
      for (Eigen::Index block = 0; block < blocks; ++block) {
        const auto b = static_cast<std::size_t>(block);
        const Eigen::Vector3d of_mode(forces[0](m, own.modes_y[b]), forces[1](m, own.modes_y[b]),
                                      forces[2](m, own.modes_y[b]));
        stress.segment(block * nodes, nodes) += weight * own.stress[at][b] * of_mode;
      }
      if (own.on_sides[at].size() > 0) {
        stress -= weight * own.on_sides[at].transpose() *
                  sides_->stiffness(m, own.along_y).solve(sides.col(m));
      }
    }
    const Eigen::VectorXd moved = -own.stiffness.solve(stress);
    for (std::size_t at = 0; at < own.stress.size(); ++at) {
      if (own.on_sides[at].size() > 0) {
        sides.col(first + 2 * static_cast<Eigen::Index>(at)) += own.on_sides[at] * moved;
      }
    }
    result.push_back({own.along_x, own.along_y, own.modes_y, moved.reshaped(nodes, blocks)});
  }
  return result;
}

Eigen::Index FreeEnds::unknowns(const Class& own, double last) const {
  return own.nodes() * std::ranges::count_if(own.modes_y, [&](Eigen::Index n) {
           return fading_share(along_y_.wave_numbers(n), last) > 0;
         });
}

void FreeEnds::add(const std::array<Eigen::MatrixXd, 3>& forces, const Eigen::ArrayXd& share,
                   double last, std::array<Eigen::MatrixXd, 3>& displacement) const {
  const Eigen::Index waves = forces[0].cols();
  for (const Class& own : classes_) {
    const Eigen::Index first = own.along_x == Parity::even ? 0 : 1;
    const std::size_t modes =
        std::min(own.stress.size(),
                 static_cast<std::size_t>(std::max<Eigen::Index>(0, share.size() - first + 1) / 2));
    const Eigen::Index nodes = own.nodes(), size = unknowns(own, last);
    if (size == 0 || modes == 0) {
      continue;
    }
    const auto of_mode = [&](const std::array<Eigen::MatrixXd, 3>& fields, Eigen::Index m,
                             Eigen::Index n) {
      return Eigen::Vector3d(fields[0](m, n), fields[1](m, n), fields[2](m, n));
    };
    const auto weight = [&](Eigen::Index m) {
      return share(m) * multiplicity(m) / along_x_.extent;
    };
    Eigen::VectorXd stress = Eigen::VectorXd::Zero(size);
    for (std::size_t at = 0; at < modes; ++at) {
      const Eigen::Index m = first + 2 * static_cast<Eigen::Index>(at);
      for (Eigen::Index row = 0; row < size; row += nodes) {
        const auto block = static_cast<std::size_t>(row / nodes);
        stress.segment(row, nodes) +=
            weight(m) * own.stress[at][block] * of_mode(forces, m, own.modes_y[block]);
      }
      if (own.on_sides[at].size() > 0) {
        Eigen::MatrixX3d across(waves, 3);
        across << forces[0].row(m).transpose(), forces[1].row(m).transpose(),
            forces[2].row(m).transpose();
        const Eigen::VectorXd of_sides =
            sides_->stiffness(m, own.along_y).solve(sides_->stress(m, own.along_y, across));
        stress -= weight(m) * own.on_sides[at].leftCols(size).transpose() * of_sides;
      }
    }
    const auto factor = own.stiffness.matrixLLT().topLeftCorner(size, size);
    factor.triangularView<Eigen::Lower>().solveInPlace(stress);
    for (Eigen::Index row = 0; row < size; row += nodes) {
      const Eigen::Index n = own.modes_y[static_cast<std::size_t>(row / nodes)];
      stress.segment(row, nodes) *= fading_share(along_y_.wave_numbers(n), last);
    }
    factor.triangularView<Eigen::Lower>().transpose().solveInPlace(stress);
    for (std::size_t at = 0; at < modes; ++at) {
      const Eigen::Index m = first + 2 * static_cast<Eigen::Index>(at);
      for (Eigen::Index row = 0; row < size; row += nodes) {
        const auto block = static_cast<std::size_t>(row / nodes);
        const Eigen::Vector3d felt =
            weight(m) * own.stress[at][block].transpose() * stress.segment(row, nodes);
        for (std::size_t c = 0; c < 3; ++c) {
          displacement[c](m, own.modes_y[block]) += felt(static_cast<Eigen::Index>(c));
        }
      }
      if (own.on_sides[at].size() > 0) {
        const Eigen::VectorXd on_sides = own.on_sides[at].leftCols(size) * stress;
        Eigen::MatrixX3d felt = Eigen::MatrixX3d::Zero(waves, 3);
        sides_->add_felt(m, own.along_y, sides_->stiffness(m, own.along_y).solve(on_sides), felt);
        for (std::size_t c = 0; c < 3; ++c) {
          displacement[c].row(m) -= weight(m) * felt.col(static_cast<Eigen::Index>(c)).transpose();
        }
      }
    }
  }
}

// The Cholesky factor of the leading modes along the ends is the leading block of the whole factor.
// Each mode therefore only adds its own rows to the effect of the modes before it.
void FreeEnds::Rows::add(const ContactGrid& grid, double centre_x, const Eigen::ArrayXd& share,
                         double last, Eigen::MatrixXd& compliance) const {
  const ModeLine& along_x = ends_->along_x_;
  const Eigen::Index all = std::min(share.size(), along_x.wave_numbers.size());
  const ModeTransform of_columns =
      ModeLine{along_x.extent, along_x.wave_numbers.head(all), {}}.transform(grid.x, centre_x);
  const Eigen::Index columns = grid.columns(), rows = grid.rows();
  const double images = grid.half ? 2 : 1;
  for (std::size_t c = 0; c < stress_.size(); ++c) {
    if (stress_[c].empty()) {
      continue;
    }
    const Class& own = ends_->classes_[c];
    const Eigen::Index first = own.along_x == Parity::even ? 0 : 1;
    const Eigen::Index modes = (all - first + 1) / 2;
    const Eigen::Index nodes = own.nodes(), size = ends_->unknowns(own, last);
    if (size == 0 || modes <= 0) {
      continue;
    }
    Eigen::MatrixXd stress(size, 3 * columns * rows);
    for (Eigen::Index component = 0; component < 3; ++component) {
      const auto& wave = component == 1 ? of_columns.sine : of_columns.cosine;
      const Eigen::MatrixXd of_modes = wave(Eigen::all, Eigen::seqN(first, modes, 2)) // [column, m]
                                           .rowwise() *
                                       share(Eigen::seqN(first, modes, 2)).transpose();
      for (Eigen::Index j = 0; j < rows; ++j) {
        Eigen::MatrixXd by_mode(size, modes);
        for (Eigen::Index m = 0; m < modes; ++m) {
          by_mode.col(m) =
              stress_[c][static_cast<std::size_t>(m)].col(3 * j + component).head(size);
        }
        stress(Eigen::all, Eigen::seqN(3 * columns * j + component, columns, 3)) =
            by_mode * of_modes.transpose();
      }
    }
    Eigen::MatrixXd half = own.stiffness.matrixLLT()
                               .topLeftCorner(size, size)
                               .triangularView<Eigen::Lower>()
                               .solve(stress);
    for (Eigen::Index row = 0; row < size; row += nodes) {
      const Eigen::Index n = own.modes_y[static_cast<std::size_t>(row / nodes)];
      half.middleRows(row, nodes) *= std::sqrt(fading_share(ends_->along_y_.wave_numbers(n), last));
    }
    compliance.noalias() += images * half.transpose() * half;
  }
}

} // namespace ionskin::finite_layers
