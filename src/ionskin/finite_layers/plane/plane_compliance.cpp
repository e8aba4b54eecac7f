// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/plane/plane_compliance.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace ionskin::finite_layers {
namespace {

/// Distance of two cells over their size beyond which a few points represent each cell, with an
/// error of 4e-6 of their compliance [1].
constexpr double far_apart = 6;

/// Distance between two points of two intervals [m], with its weight among all pairs [1].
struct Distance {
  double value = 0, weight = 0;
};

/// Lists the distances between two Gauss points in each of the intervals.
std::vector<Distance> few_distances(const Interval& at, const Interval& from) {
  const double offset = 0.5 / std::sqrt(3.0);
  std::vector<Distance> result;
  for (const double a : {-offset, offset}) {
    for (const double b : {-offset, offset}) {
      result.push_back({at.middle() + a * at.size() - from.middle() - b * from.size(), 0.25});
    }
  }
  return result;
}

/// Density of the distances between points of two intervals [1/m]; its graph is a trapezoid.
double density(const Interval& at, const Interval& from, double distance) {
  const double overlap =
      std::min(at.to, from.to + distance) - std::max(at.from, from.from + distance);
  return std::max(0.0, overlap) / (at.size() * from.size());
}

/// Lists Gauss points for an integral over the distances between two intervals. Panels end at the
/// corners of the trapezoid and become shorter towards 0, as the integrand varies over a length
/// equal to the distance, or over `finest` where that is longer.
std::vector<Distance> distances(const Interval& at, const Interval& from, double finest) {
  using Rule = boost::math::quadrature::gauss<double, 4>;
  std::vector<double> breaks{at.from - from.to, at.from - from.from, at.to - from.to,
                             at.to - from.from, 0.0};
  const double most = std::max(std::abs(breaks[0]), std::abs(breaks[3]));
  for (double ring = finest; ring < most; ring *= 2) {
    breaks.push_back(ring);
    breaks.push_back(-ring);
  }
  std::ranges::sort(breaks);
  std::vector<Distance> result;
  const double first = at.from - from.to, last = at.to - from.from;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    const double low = std::max(breaks[i], first), high = std::min(breaks[i + 1], last);
    if (high - low <= 1e-9 * (last - first)) {
      continue;
    }
    for (std::size_t k = 0; k < Rule::abscissa().size(); ++k) {
      for (const double sign : {1.0, -1.0}) {
        const double value = 0.5 * (low + high) + 0.5 * sign * (high - low) * Rule::abscissa()[k];
        result.push_back(
            {value, 0.5 * (high - low) * Rule::weights()[k] * density(at, from, value)});
      }
    }
  }
  return result;
}

/// Adds a compliance to a sum, given by its parts as in `RadialCompliance`, with the angle factors
/// applied.
void add(double normal, double isotropic, double cosine, double sine, double mixed_u,
         double mixed_v, CellCompliance& sum) {
  sum(0, 0) += normal;
  sum(1, 1) += isotropic + cosine;
  sum(2, 2) += isotropic - cosine;
  sum(1, 2) += sine;
  sum(2, 1) += sine;
  sum(0, 1) += mixed_u;
  sum(1, 0) -= mixed_u;
  sum(0, 2) += mixed_v;
  sum(2, 0) -= mixed_v;
}

/// Adds the compliance at the point (u, v) from the force [m] to a sum.
void add_radial(const RadialCompliance& at, double u, double v, double weight,
                CellCompliance& sum) {
  const double square = u * u + v * v, r = std::sqrt(square);
  const double cosine = r > 0 ? (u * u - v * v) / square : 0.0;
  const double sine = r > 0 ? 2 * u * v / square : 0.0;
  add(weight * at.normal, weight * at.isotropic, weight * at.deviatoric * cosine,
      weight * at.deviatoric * sine, r > 0 ? weight * at.mixed * u / r : 0.0,
      r > 0 ? weight * at.mixed * v / r : 0.0, sum);
}

} // namespace

Interval ContactGrid::column(Eigen::Index i) const {
  const auto at = static_cast<std::size_t>(i);
  return {x[at], x[at + 1]};
}

Interval ContactGrid::row(Eigen::Index j) const {
  const auto at = static_cast<std::size_t>(j);
  return {y[at], y[at + 1]};
}

CellCompliance plane_compliance(const PlaneCompliance& skin, const Interval& x_at,
                                const Interval& y_at, const Interval& x_from,
                                const Interval& y_from) {
  CellCompliance sum = CellCompliance::Zero();
  const double size = std::max({x_at.size(), y_at.size(), x_from.size(), y_from.size()});
  const double distance =
      std::hypot(x_at.middle() - x_from.middle(), y_at.middle() - y_from.middle());
  const bool far = distance > far_apart * size;
  if (far && distance > skin.reach() + 2 * size) {
    return sum;
  }
  const RadialCompliance& half_space = skin.half_space();
  if (!far) {
    const InverseDistance mean = mean_inverse_distance(x_at, y_at, x_from, y_from);
    add(half_space.normal * mean.inverse, half_space.isotropic * mean.inverse,
        half_space.deviatoric * mean.cosine, half_space.deviatoric * mean.sine,
        half_space.mixed * mean.u, half_space.mixed * mean.v, sum);
  }
  if (!far && std::isinf(skin.finest())) {
    return sum; // the body is a half-space
  }
  const std::vector<Distance> along_x =
      far ? few_distances(x_at, x_from) : distances(x_at, x_from, skin.finest());
  const std::vector<Distance> along_y =
      far ? few_distances(y_at, y_from) : distances(y_at, y_from, skin.finest());
  for (const Distance& v : along_y) {
    for (const Distance& u : along_x) {
      const double r = std::hypot(u.value, v.value), weight = u.weight * v.weight;
      RadialCompliance at = skin.difference(r);
      if (far) {
        at.normal += half_space.normal / r;
        at.mixed += half_space.mixed / r;
        at.isotropic += half_space.isotropic / r;
        at.deviatoric += half_space.deviatoric / r;
      }
      add_radial(at, u.value, v.value, weight, sum);
    }
  }
  return sum;
}

std::vector<RowImage> own_images(const ContactGrid& grid) {
  return grid.half ? std::vector<RowImage>{{false, 0}, {true, 0}}
                   : std::vector<RowImage>{{false, 0}};
}

std::vector<RowImage> images_between(const ContactGrid& grid, double low, double high,
                                     double reach) {
  const std::vector<RowImage> own = own_images(grid);
  const double period = 2 * (high - low), from = grid.y.front(),
               to = grid.half ? -from : grid.y.back();
  const auto near = [&](double shift, bool mirrored) {
    const double first = shift + (mirrored ? -to : from), last = shift + (mirrored ? -from : to);
    return first < to + reach && last > from - reach;
  };
  std::vector<RowImage> images;
  const auto most = static_cast<int>(std::ceil((reach + period) / period));
  for (int i = -most; i <= most; ++i) {
    for (const RowImage& one : own) {
      // Shifted images of the cells, and images reflected in the lower mirror.
      const RowImage moved{one.mirrored, i * period}, turned{!one.mirrored, 2 * low + i * period};
      for (const RowImage& image : {moved, turned}) {
        const bool itself = image.shift == 0 && image.mirrored == one.mirrored && i == 0;
        if (!itself && near(image.shift, image.mirrored)) {
          images.push_back(image);
        }
      }
    }
  }
  return images;
}

Eigen::MatrixXd plane_compliance(const PlaneCompliance& skin, const ContactGrid& grid,
                                 const std::vector<RowImage>& images) {
  const Eigen::Index columns = grid.columns(), count = grid.count();
  Eigen::MatrixXd result(3 * count, 3 * count);
  for (Eigen::Index from = 0; from < count; ++from) {
    for (Eigen::Index at = from; at < count; ++at) {
      const Interval x_at = grid.column(at % columns), y_at = grid.row(at / columns);
      const Interval x_from = grid.column(from % columns), y_from = grid.row(from / columns);
      CellCompliance pair = CellCompliance::Zero();
      for (const RowImage& image : images) {
        const Interval row = image.mirrored
                                 ? Interval{image.shift - y_from.to, image.shift - y_from.from}
                                 : Interval{image.shift + y_from.from, image.shift + y_from.to};
        CellCompliance of_image = plane_compliance(skin, x_at, y_at, x_from, row);
        if (image.mirrored) {
          of_image.col(2) *= -1;
        }
        pair += of_image;
      }
      if (at == from) {
        pair = 0.5 * (pair + pair.transpose()).eval();
      }
      result.block<3, 3>(3 * at, 3 * from) = pair;
      result.block<3, 3>(3 * from, 3 * at) = pair.transpose();
    }
  }
  return result;
}

} // namespace ionskin::finite_layers
