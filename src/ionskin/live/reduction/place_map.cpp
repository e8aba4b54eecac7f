// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/reduction/place_map.hpp"

#include "ionskin/live/reduction/row_major.hpp"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <cmath>

namespace ionskin::live {
namespace {

using Matrix = Eigen::MatrixXd;

} // namespace

PlaceMap place_map(const PlaceNodes& places, const std::vector<std::vector<float>>& nodes,
                   double negligible) {
  const auto count = static_cast<Eigen::Index>(nodes.size()),
             size = static_cast<Eigen::Index>(nodes.front().size());
  Matrix values(size, count);
  for (Eigen::Index i = 0; i < count; ++i) {
    values.col(i) = Eigen::Map<const Eigen::VectorXf>(nodes[i].data(), size).cast<double>();
  }
  const Eigen::VectorXd mean = values.rowwise().mean();
  values.colwise() -= mean;
  const Eigen::SelfAdjointEigenSolver<Matrix> eigen(values.transpose() * values);
  std::vector<Eigen::Index> large;
  for (Eigen::Index i = count; i-- > 0;) {
    if (eigen.eigenvalues()[i] > std::pow(negligible * mean.norm(), 2)) {
      large.push_back(i);
    }
  }
  const Matrix amplitude = eigen.eigenvectors()(Eigen::indexing::all, large);
  PlaceMap map{places.x, places.y, {}, {}};
  append(map.values, mean.transpose());
  append(map.values, (values * amplitude).transpose());
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index k = 0; k < amplitude.cols(); ++k) {
      map.amplitude.push_back(amplitude(i, k));
    }
  }
  return map;
}

PlaceMap reduce_compliance(const mechanics::SkinModel& model, const PlaceNodes& places) {
  mechanics::ContactCompliance compliance(model);
  std::vector<std::vector<float>> values;
  for (const double y : places.y) {
    for (const double x : places.x) {
      Matrix matrix;
      compliance.at({x, y}, matrix);
      values.emplace_back(matrix.data(), matrix.data() + matrix.size());
    }
  }
  return place_map(places, values, negligible_place_mode);
}

} // namespace ionskin::live
