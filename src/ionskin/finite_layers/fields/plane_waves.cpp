// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/fields/plane_waves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ionskin::finite_layers {
namespace {

constexpr Eigen::Index modes_at_once = 32; // along y: their strains stay in the second cache

} // namespace

std::array<Eigen::MatrixXd, 3> mode_forces(const CellForces& forces, const ModeTransform& columns,
                                           const ModeTransform& rows) {
  std::array<Eigen::MatrixXd, 3> result;
  for (std::size_t c = 0; c < 3; ++c) {
    const Eigen::ArrayXXd &x = c == 1 ? columns.sine : columns.cosine,
                          &y = c == 2 ? rows.sine : rows.cosine;
    const Eigen::MatrixXd of_rows = x.matrix().transpose() * forces[c];
    result[c].noalias() = of_rows * y.matrix();
  }
  return result;
}

PlaneWaves::PlaneWaves(double length, double width, bool mirrored,
                       const std::function<double(double)>& share, double last)
    : step_x_(std::numbers::pi / length), step_y_((mirrored ? 2 : 1) * std::numbers::pi / width) {
  const auto count_x = static_cast<Eigen::Index>(last / step_x_) + 1,
             count_y = static_cast<Eigen::Index>(last / step_y_) + 1;
  for (Eigen::ArrayXXd* array : {&cosine_, &sine_, &logarithm_, &weight_}) {
    array->resize(count_x, count_y);
  }
  for (Eigen::Index n = 0; n < count_y; ++n) {
    for (Eigen::Index m = 0; m < count_x; ++m) {
      const double kx = static_cast<double>(m) * step_x_, ky = static_cast<double>(n) * step_y_;
      const double k = std::hypot(kx, ky);
      cosine_(m, n) = k > 0 ? kx / k : 1;
      sine_(m, n) = k > 0 ? ky / k : 0;
      logarithm_(m, n) = k > 0 ? std::log(k) : -1e3; // the first of every table
      weight_(m, n) =
          k > last ? 0.0 : (m > 0 ? 2 : 1) * (n > 0 ? 2 : 1) / (length * width) * share(k);
    }
  }
}

PlaneWaves::Tractions PlaneWaves::tractions(const std::array<Eigen::MatrixXd, 3>& forces) const {
  const auto x = forces[1].array(), y = forces[2].array();
  return {weight_ * (cosine_ * x + sine_ * y), -weight_ * forces[0].array(),
          weight_ * (cosine_ * y - sine_ * x)};
}

Eigen::Index PlaneWaves::modes_below(double last, Eigen::Index n) const {
  const double ky = static_cast<double>(n) * step_y_;
  return ky > last
             ? 0
             : std::min(modes_x(),
                        static_cast<Eigen::Index>(std::sqrt(last * last - ky * ky) / step_x_) + 1);
}

Strains PlaneWaves::rows(const DepthTable& table, std::size_t level, const Tractions& tractions,
                         const ModeTransform& along_y) const {
  const double last = table.cutoff(level);
  const Eigen::Index most = modes_below(last, 0), places = along_y.cosine.rows();
  Strains sum, part;
  for (std::size_t c = 0; c < 6; ++c) {
    sum[c] = Eigen::MatrixXd::Zero(most, places);
    part[c].resize(most, modes_at_once);
  }
  for (Eigen::Index first = 0; first < modes_y(); first += modes_at_once) {
    const Eigen::Index count = std::min(modes_at_once, modes_y() - first),
                       felt = modes_below(last, first);
    if (felt == 0) {
      break;
    }
    for (Eigen::Index i = 0; i < count; ++i) {
      const Eigen::Index n = first + i, own = modes_below(last, n);
      for (Eigen::Index m = 0; m < own; ++m) {
        const DepthTable::Values v = table.at(level, logarithm_(m, n));
        const double t = tractions.along(m, n), q = tractions.upwards(m, n),
                     across = tractions.across(m, n), c = cosine_(m, n), s = sine_(m, n);
        const double stretch = v(0) * t + v(1) * q, twist = v(6) * across;
        const double shear = v(4) * t + v(5) * q, shear_across = v(7) * across;
        const double x = c * stretch - s * twist, y = s * stretch + c * twist;
        part[0](m, i) = c * x;
        part[1](m, i) = s * y;
        part[2](m, i) = v(2) * t + v(3) * q;
        part[3](m, i) = 0.5 * (s * shear + c * shear_across);
        part[4](m, i) = 0.5 * (c * shear - s * shear_across);
        part[5](m, i) = -0.5 * (s * x + c * y);
      }
      for (Eigen::MatrixXd& of_component : part) {
        of_component.col(i).segment(own, felt - own).setZero();
      }
    }
    for (std::size_t c = 0; c < 6; ++c) {
      const Eigen::ArrayXXd& wave = sine_along_y[c] ? along_y.sine : along_y.cosine;
      sum[c].topRows(felt).noalias() +=
          part[c].topLeftCorner(felt, count) * wave.middleCols(first, count).matrix().transpose();
    }
  }
  return sum;
}

} // namespace ionskin::finite_layers
