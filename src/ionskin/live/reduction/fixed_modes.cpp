// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/reduction/fixed_modes.hpp"

#include "ionskin/history/line_operators.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ionskin::live {
namespace {

using Matrix = Eigen::MatrixXd;
using Eigen::Index;

/// Largest width of an end zone, over the skin's thickness: the effect of a free end fades within
/// it [1].
constexpr double zone_thicknesses = 3;
constexpr double first_cell = 0.5;        ///< length of the end cells over the skin's thickness [1]
constexpr double cell_growth = 1.5;       ///< ratio of the lengths of successive cells [1]
constexpr double longest_cell = 1.0 / 16; ///< longest cell over the extent of the skin [1]
/// Norm of a mode that is left out, over the norm of the complete fields [1].
constexpr double negligible_left = 1e-4;
/// Largest number of modes, and about the largest number of samples from which they are made.
constexpr Index most_fixed_modes = 24, most_columns = 1000;
/// Ridge of the least-squares fits, over the mean of the diagonal of their normal equations [1].
constexpr double fit_ridge = 1e-6;

/// Edges of cells between the two ends of the skin, which grow from both ends to the middle [m].
/// @param extent length or width of the skin [m]
/// @param thickness of the skin [m]
std::vector<double> cells_from_ends(double extent, double thickness) {
  std::vector<double> edges{0};
  // The cell in the middle is wider than its neighbours.
  for (double size = first_cell * thickness; edges.back() + 1.5 * size < extent / 2;
       size = std::min(size * cell_growth, longest_cell * extent)) {
    edges.push_back(edges.back() + size);
  }
  for (std::size_t i = edges.size(); i-- > 0;) {
    edges.push_back(extent - edges[i]);
  }
  return edges;
}

/// Edges shifted by a distance [m].
std::vector<double> moved(std::vector<double> edges, double by) {
  for (double& edge : edges) {
    edge += by;
  }
  return edges;
}

} // namespace

std::array<double, 2> end_zones(const SkinData& data, const PlaceNodes& places, double thickness) {
  const auto zone = [&](const std::vector<double>& lines, double extent,
                        const std::vector<double>& cells) {
    const double beside =
        std::min(lines.front() + cells.front(), extent - lines.back() - cells.back());
    return lines.size() == 1 ? 0.0 : std::clamp(beside / 2, 0.0, zone_thicknesses * thickness);
  };
  return {zone(places.x, data.length, data.cell_lines_x),
          zone(places.y, data.width, data.cell_lines_y)};
}

std::array<std::vector<double>, 2> fixed_edges(const SkinData& data, const PlaceNodes& places,
                                               const history::StrainGrid& grid, double thickness) {
  return {places.x.size() > 1 ? cells_from_ends(data.length, thickness)
                              : moved(grid.x_edges, places.x.front()),
          places.y.size() > 1 ? cells_from_ends(data.width, thickness)
                              : moved(grid.y_edges, places.y.front())};
}

Eigen::MatrixXf on_fixed_cells(const Eigen::MatrixXf& fields, const history::StrainGrid& grid,
                               const std::array<double, 2>& place,
                               const std::array<std::vector<double>, 2>& edges) {
  const history::LineOperator along_x = history::overlap_averages(moved(grid.x_edges, place[0]),
                                                                  edges[0]),
                              along_y = history::overlap_averages(moved(grid.y_edges, place[1]),
                                                                  edges[1]);
  const std::size_t levels = grid.z_nodes.size(), rows = grid.columns_y();
  Eigen::MatrixXf result(static_cast<Index>(levels * along_x.rows() * along_y.rows()),
                         fields.cols());
  std::vector<double> field, between;
  for (Index i = 0; i < fields.cols(); ++i) {
    const Eigen::VectorXd column = fields.col(i).cast<double>();
    field.assign(column.begin(), column.end());
    history::apply_along(along_x, levels * rows, 1, field, between);
    history::apply_along(along_y, levels, along_x.rows(), between, field);
    result.col(i) = Eigen::Map<const Eigen::VectorXd>(field.data(), result.rows()).cast<float>();
  }
  return result;
}

FixedModes fixed_modes(const std::vector<LeftAtPlace>& left, const ChannelMeasure& measure,
                       const std::array<std::size_t, 3>& size, const Reflections& reflections,
                       double whole) {
  const Index rows = left.front().fields.rows();
  const Index each =
      std::min(left.front().fields.cols(), most_columns / static_cast<Index>(left.size()) + 1);
  Eigen::MatrixXf all(rows, each * static_cast<Index>(left.size()));
  for (std::size_t i = 0; i < left.size(); ++i) {
    all.middleCols(each * static_cast<Index>(i), each) = left[i].fields.leftCols(each);
  }
  FixedModes modes;
  std::vector<std::pair<double, std::pair<std::size_t, Eigen::VectorXd>>> found;
  for (std::size_t p = 0; p < reflections.count(); ++p) {
    const Eigen::MatrixXf own = of_parity(all, size, reflections, p),
                          in_measure = measured(own, measure);
    const Matrix gram = (in_measure.transpose() * in_measure).cast<double>();
    const Eigen::SelfAdjointEigenSolver<Matrix> eigen(gram);
    for (Index k = 0; k < gram.cols() && k < most_fixed_modes; ++k) {
      const Index at = gram.cols() - 1 - k;
      const double energy = eigen.eigenvalues()[at];
      if (energy <= std::pow(negligible_left * whole, 2)) {
        break;
      }
      found.push_back(
          {energy, {p, own.cast<double>() * eigen.eigenvectors().col(at) / std::sqrt(energy)}});
    }
  }
  std::ranges::stable_sort(found, std::ranges::greater{},
                           [](const auto& mode) { return mode.first; });
  found.resize(std::min(found.size(), static_cast<std::size_t>(most_fixed_modes)));
  modes.field = Matrix::Zero(rows, static_cast<Index>(found.size()));
  for (std::size_t k = 0; k < found.size(); ++k) {
    modes.parity.push_back(found[k].second.first);
    modes.field.col(static_cast<Index>(k)) = found[k].second.second;
  }
  const Matrix in_measure = measured(modes.field.cast<float>(), measure).cast<double>();
  Matrix gram = in_measure.transpose() * in_measure;
  if (!found.empty()) {
    gram.diagonal().array() += fit_ridge * gram.diagonal().mean();
  }
  for (const LeftAtPlace& place : left) {
    if (found.empty()) {
      modes.fit.emplace_back(Matrix::Zero(0, place.values.rows()));
      continue;
    }
    const Matrix amplitude =
        gram.ldlt().solve(in_measure.transpose() * measured(place.fields, measure).cast<double>());
    const Eigen::VectorXd scale = place.values.rowwise().norm().cwiseMax(1e-30).cwiseInverse();
    const Matrix values = scale.asDiagonal() * place.values;
    Matrix square = values * values.transpose();
    square.diagonal().array() += fit_ridge;
    modes.fit.emplace_back(square.ldlt().solve(values * amplitude.transpose()).transpose() *
                           scale.asDiagonal());
  }
  return modes;
}

} // namespace ionskin::live
