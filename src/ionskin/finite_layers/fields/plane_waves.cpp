// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/fields/plane_waves.hpp"

#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/finite_layers/fields/row_strains.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ionskin::finite_layers {
WaveLoads::WaveLoads(const CellForces& forces, const ModeTransform& columns, ModeTransform of_rows)
    : rows(std::move(of_rows)) {
  for (std::size_t c = 0; c < 3; ++c) {
    of_columns[c] = (c == 1 ? columns.sine : columns.cosine).matrix().transpose() * forces[c];
  }
}

Eigen::MatrixXd WaveLoads::by_mode(std::size_t component, Eigen::Index first_m,
                                   Eigen::Index count_m, Eigen::Index first_n,
                                   Eigen::Index count_n) const {
  return of_columns[component].middleRows(first_m, count_m) *
         (component == 2 ? rows.sine : rows.cosine).middleCols(first_n, count_n).matrix();
}

PlaneWaves::PlaneWaves(double length, double width, bool mirrored,
                       const std::function<double(double)>& share, double last)
    : step_x_(std::numbers::pi / length), step_y_((mirrored ? 2 : 1) * std::numbers::pi / width) {
  const auto felt_x = static_cast<Eigen::Index>(last / step_x_) + 1,
             count_x = (felt_x + block_x - 1) / block_x * block_x,
             count_y = static_cast<Eigen::Index>(last / step_y_) + 1;
  for (Eigen::ArrayXXd* array : {&cosine_, &sine_, &logarithm_, &weight_}) {
    array->resize(count_x, count_y);
  }
  for (Eigen::Index n = 0; n < count_y; ++n) {
    base::check_interrupt();
    for (Eigen::Index m = 0; m < count_x; ++m) {
      const double kx = static_cast<double>(m) * step_x_, ky = static_cast<double>(n) * step_y_;
      const double k = std::hypot(kx, ky);
      cosine_(m, n) = k > 0 ? kx / k : 1;
      sine_(m, n) = k > 0 ? ky / k : 0;
      logarithm_(m, n) = k > 0 ? std::log(k) : -1e3; // clamped to the begin of every table
      weight_(m, n) =
          k > last ? 0.0 : (m > 0 ? 2 : 1) * (n > 0 ? 2 : 1) / (length * width) * share(k);
    }
  }
}

Eigen::Index PlaneWaves::modes_below(double last, Eigen::Index n) const {
  const double ky = static_cast<double>(n) * step_y_;
  return ky > last
             ? 0
             : std::min(modes_x(),
                        static_cast<Eigen::Index>(std::sqrt(last * last - ky * ky) / step_x_) + 1);
}

void PlaneWaves::look_up(const DepthTable& table, std::size_t level, Eigen::Index first_m,
                         Eigen::Index n, WaveBlock& block) const {
  block.cosine = cosine_.col(n).segment<block_x>(first_m);
  block.sine = sine_.col(n).segment<block_x>(first_m);
  block.weight = weight_.col(n).segment<block_x>(first_m);
  const Eigen::Index felt =
      std::clamp(modes_below(table.cutoff(level), n) - first_m, Eigen::Index{0}, block_x);
  for (Eigen::Index m = 0; m < felt; ++m) {
    block.depth.row(m) = table.at(level, logarithm_(first_m + m, n)).transpose();
  }
  block.depth.bottomRows(block_x - felt).setZero();
}

void PlaneWaves::add_block(const DepthTable& table, std::size_t level, Eigen::Index first_m,
                           Eigen::Index first_n, const FieldComponents& components,
                           const std::vector<WaveLoads>& loads,
                           const std::vector<WavePlaces>& places, std::vector<ByKind>& sums) const {
  const Eigen::Index count = std::min(block_y, modes_y() - first_n);
  const std::size_t states = loads.size();
  WaveBlock block;
  std::vector<std::array<Eigen::MatrixXd, 3>> forces(states);
  std::vector<Strains> strains(states);
  for (std::size_t state = 0; state < states; ++state) {
    strains[state].fill(Eigen::MatrixXd(block_x, count));
    for (std::size_t c = 0; c < 3; ++c) {
      forces[state][c] = loads[state].by_mode(c, first_m, block_x, first_n, count);
    }
  }
  for (Eigen::Index i = 0; i < count; ++i) {
    look_up(table, level, first_m, first_n + i, block);
    for (std::size_t state = 0; state < states; ++state) {
      block.set_strains(forces[state][0].col(i), forces[state][1].col(i), forces[state][2].col(i),
                        strains[state], i);
    }
  }
  for (std::size_t state = 0; state < states; ++state) {
    const ModeTransform& along_x = places[state].along_x;
    for (std::size_t kind = 0; kind < 2; ++kind) {
      Eigen::MatrixXd of_kind(block_x, count * components.count(kind));
      Eigen::Index first = 0;
      for (const std::size_t c : components.of_kind(kind)) {
        of_kind.middleCols(first, count) = strains[state][c];
        first += count;
      }
      sums[state][kind].noalias() +=
          (kind == 1 ? along_x.sine : along_x.cosine).middleCols(first_m, block_x).matrix() *
          of_kind;
    }
  }
}

// Sums along x come first, as there are many places along x and mostly few modes along y.
void PlaneWaves::add(const DepthTable& table, std::size_t level, const FieldComponents& components,
                     const std::vector<WaveLoads>& loads, const std::vector<WavePlaces>& places,
                     std::vector<ByKind>& sums) const {
  const double last = table.cutoff(level);
  std::vector<ByKind> along_x(loads.size());
  for (Eigen::Index first_n = 0; first_n < modes_y() && modes_below(last, first_n) > 0;
       first_n += block_y) {
    const Eigen::Index count = std::min(block_y, modes_y() - first_n);
    for (std::size_t state = 0; state < loads.size(); ++state) {
      for (const std::size_t kind : {0, 1}) {
        along_x[state][kind].setZero(places[state].along_x.cosine.rows(),
                                     count * components.count(kind));
      }
    }
    base::check_interrupt();
    for (Eigen::Index first_m = 0; modes_below(last, first_n) > first_m; first_m += block_x) {
      add_block(table, level, first_m, first_n, components, loads, places, along_x);
    }
    for (std::size_t state = 0; state < loads.size(); ++state) {
      const ModeTransform& along_y = places[state].along_y;
      const Eigen::Index of_y = along_y.cosine.rows();
      for (const std::size_t kind : {0, 1}) {
        const std::vector<std::size_t>& own = components.of_kind(kind);
        for (Eigen::Index i = 0; i < components.count(kind); ++i) {
          const bool sine = sine_along_y[own[static_cast<std::size_t>(i)]];
          sums[state][kind].middleCols(i * of_y, of_y).noalias() +=
              along_x[state][kind].middleCols(i * count, count) *
              (sine ? along_y.sine : along_y.cosine)
                  .middleCols(first_n, count)
                  .matrix()
                  .transpose();
        }
      }
    }
  }
}

void PlaneWaves::add(const RowStrains& known, const DepthTable& table, std::size_t level,
                     const std::vector<WaveLoads>& loads, const std::vector<WavePlaces>& places,
                     std::vector<ByKind>& sums) const {
  std::vector<ByKind> rows(loads.size());
  for (Eigen::Index first_m = 0; modes_below(table.cutoff(level), 0) > first_m;
       first_m += block_x) {
    base::check_interrupt();
    known.at(level, first_m, loads, rows);
    for (std::size_t state = 0; state < loads.size(); ++state) {
      const ModeTransform& along_x = places[state].along_x;
      for (const std::size_t kind : {0, 1}) {
        sums[state][kind].noalias() +=
            (kind == 1 ? along_x.sine : along_x.cosine).middleCols(first_m, block_x).matrix() *
            rows[state][kind];
      }
    }
  }
}

} // namespace ionskin::finite_layers
