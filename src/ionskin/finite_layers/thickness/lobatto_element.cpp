// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/thickness/lobatto_element.hpp"

#include <boost/math/special_functions/legendre.hpp>

#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ionskin::finite_layers {
namespace {

/// Lists the zeros of a Legendre polynomial in [-1, 1], ascending.
Eigen::VectorXd legendre_zeros(int degree) {
  const std::vector<double> upper = boost::math::legendre_p_zeros<double>(degree); // 0 and above
  Eigen::VectorXd zeros(degree);
  for (std::size_t i = 0; i < upper.size(); ++i) {
    const auto from_end = static_cast<Eigen::Index>(upper.size() - 1 - i);
    zeros(from_end) = -upper[i];
    zeros(degree - 1 - from_end) = upper[i];
  }
  return zeros;
}

/// Lists the Gauss-Lobatto nodes in [-1, 1]: both ends, and the zeros of the derivative of the
/// Legendre polynomial P, which Newton's method finds between the zeros of P.
Eigen::VectorXd lobatto_nodes(int degree) {
  Eigen::VectorXd nodes(degree + 1);
  nodes(0) = -1;
  nodes(degree) = 1;
  const Eigen::VectorXd zeros = legendre_zeros(degree);
  for (int i = 1; i < degree; ++i) {
    double x = 0.5 * (zeros(i - 1) + zeros(i));
    for (int iteration = 0; iteration < 50; ++iteration) {
      // (1 - x^2) P'' = 2 x P' - n (n + 1) P
      const double value = boost::math::legendre_p(degree, x);
      const double slope = boost::math::legendre_p_prime(degree, x);
      const double curvature =
          (2 * x * slope - degree * (degree + 1) * value) / ((1 - x) * (1 + x));
      const double change = slope / curvature;
      x -= change;
      if (std::abs(change) < 1e-15) {
        break;
      }
    }
    nodes(i) = x;
  }
  return nodes;
}

} // namespace

LobattoElement::LobattoElement(int degree, double size) : size_(size) {
  const int count = degree + 1;
  const Eigen::VectorXd on_unit = lobatto_nodes(degree), gauss = legendre_zeros(count);
  Eigen::MatrixXd at_nodes(count, count), at_points(count, count), slope_at_points(count, count);
  weights.resize(count);
  for (int i = 0; i < count; ++i) {
    const double slope = boost::math::legendre_p_prime(count, gauss(i));
    weights(i) = size / ((1 - gauss(i) * gauss(i)) * slope * slope);
    for (int j = 0; j < count; ++j) {
      at_nodes(i, j) = boost::math::legendre_p(j, on_unit(i));
      at_points(i, j) = boost::math::legendre_p(j, gauss(i));
      slope_at_points(i, j) = boost::math::legendre_p_prime(j, gauss(i));
    }
  }
  to_legendre_ = at_nodes.inverse();
  nodes = (on_unit.array() + 1) * size / 2;
  points = (gauss.array() + 1) * size / 2;
  values = at_points * to_legendre_;
  slopes = slope_at_points * to_legendre_ * 2 / size;
}

LobattoElement LobattoElement::scaled_to(double size) const {
  LobattoElement result = *this;
  const double factor = size / size_;
  result.size_ = size;
  result.nodes *= factor;
  result.points *= factor;
  result.weights *= factor;
  result.slopes /= factor;
  return result;
}

Eigen::MatrixXd LobattoElement::mass() const {
  return values.transpose() * weights.asDiagonal() * values;
}

Eigen::MatrixXd LobattoElement::stiffness() const {
  return slopes.transpose() * weights.asDiagonal() * slopes;
}

Eigen::MatrixXd LobattoElement::convection() const {
  return values.transpose() * weights.asDiagonal() * slopes;
}

Eigen::RowVectorXd LobattoElement::values_at(double place) const {
  Eigen::RowVectorXd of_legendre(to_legendre_.rows());
  for (int i = 0; i < of_legendre.size(); ++i) {
    of_legendre(i) = boost::math::legendre_p(i, std::clamp(2 * place / size_ - 1, -1.0, 1.0));
  }
  return of_legendre * to_legendre_;
}

Eigen::RowVectorXd LobattoElement::slopes_at(double place) const {
  Eigen::RowVectorXd of_legendre(to_legendre_.rows());
  for (int i = 0; i < of_legendre.size(); ++i) {
    of_legendre(i) = boost::math::legendre_p_prime(i, std::clamp(2 * place / size_ - 1, -1.0, 1.0));
  }
  return of_legendre * to_legendre_ * 2 / size_;
}

Eigen::RowVectorXd LobattoElement::means() const {
  return weights.transpose() * values / size_;
}

Eigen::RowVectorXd LobattoElement::mean_slopes() const {
  return weights.transpose() * slopes / size_;
}

Eigen::MatrixXd plane_strain_matrix(const LobattoElement& element, const ElasticLayer& layer,
                                    double wave_number) {
  const Eigen::Index n = element.nodes.size();
  const double k = wave_number, mu = layer.shear_modulus, oedometric = layer.oedometric_modulus();
  const Eigen::MatrixXd mass = element.mass(), stiffness = element.stiffness(),
                        convection = element.convection();
  Eigen::MatrixXd result(2 * n, 2 * n);
  result.topLeftCorner(n, n) = k * k * oedometric * mass + mu * stiffness;
  result.bottomRightCorner(n, n) = k * k * mu * mass + oedometric * stiffness;
  result.topRightCorner(n, n) = k * (layer.lame_lambda * convection - mu * convection.transpose());
  result.bottomLeftCorner(n, n) = result.topRightCorner(n, n).transpose();
  return result;
}

} // namespace ionskin::finite_layers
