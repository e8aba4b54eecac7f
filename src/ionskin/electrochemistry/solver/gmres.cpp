// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/solver/gmres.hpp"

#include <array>
#include <cmath>

namespace ionskin::electrochemistry {
namespace {

/// Givens rotation that annihilates the second entry of (a, b).
struct GivensRotation {
  double cosine = 1, sine = 0;

  static GivensRotation annihilating(double a, double b) {
    const double radius = std::hypot(a, b);
    return radius == 0.0 ? GivensRotation{} : GivensRotation{a / radius, b / radius};
  }
  void apply(double& a, double& b) const {
    const double rotated = cosine * a + sine * b;
    b = cosine * b - sine * a;
    a = rotated;
  }
};

} // namespace

Gmres::Gmres(std::size_t unknowns, parallel::WorkerTeam& team)
    : vectors_(team), unknowns_(unknowns) {}

std::span<double> Gmres::basis_vector(int index) {
  while (basis_.size() <= static_cast<std::size_t>(index)) {
    basis_.emplace_back(unknowns_);
  }
  return basis_[static_cast<std::size_t>(index)];
}

Gmres::Result Gmres::solve(const Operator& apply, std::span<const double> b, std::span<double> x,
                           double tolerance, int iteration_limit) {
  vectors_.scale(0.0, b, x);
  const double start = vectors_.norm(b);
  Result result;
  if (start == 0.0) {
    result.relative_residual = 0.0;
    return result;
  }
  vectors_.scale(1.0 / start, b, basis_vector(0));
  double norm = start;
  while (true) {
    norm = cycle(apply, norm, tolerance * start, iteration_limit, x, result.iterations);
    result.relative_residual = norm / start;
    if (norm <= tolerance * start || result.iterations >= iteration_limit) {
      return result;
    }
    apply(x, basis_vector(1));
    vectors_.combine(b, -1.0, basis_vector(1), basis_vector(0));
    norm = vectors_.norm(basis_vector(0));
    vectors_.scale(1.0 / norm, basis_vector(0), basis_vector(0));
  }
}

/// Runs one cycle from the normalised residual in basis vector 0; returns the norm of the new
/// residual.
double Gmres::cycle(const Operator& apply, double residual_norm, double goal, int iteration_limit,
                    std::span<double> x, int& iterations) {
  std::array<std::array<double, basis_limit>, basis_limit + 1> hessenberg{};
  std::array<GivensRotation, basis_limit> rotations;
  std::array<double, basis_limit + 1> rhs{};
  rhs[0] = residual_norm;
  std::size_t used = 0;
  while (used < basis_limit && iterations < iteration_limit && std::abs(rhs[used]) > goal) {
    const auto column = static_cast<int>(used);
    const auto next = basis_vector(column + 1);
    apply(basis_vector(column), next);
    ++iterations;
    std::array<double, basis_limit + 1> products{};
    double norm = vectors_.orthogonalise(basis_, used + 1, next, products);
    for (std::size_t i = 0; i <= used; ++i) {
      hessenberg[i][used] = products[i];
    }
    if (norm > 0.0) {
      vectors_.scale(1.0 / norm, next, next);
    }
    for (std::size_t i = 0; i < used; ++i) {
      rotations[i].apply(hessenberg[i][used], hessenberg[i + 1][used]);
    }
    rotations[used] = GivensRotation::annihilating(hessenberg[used][used], norm);
    rotations[used].apply(hessenberg[used][used], norm);
    rotations[used].apply(rhs[used], rhs[used + 1]);
    ++used;
  }
  for (std::size_t i = used; i-- > 0;) {
    for (std::size_t j = i + 1; j < used; ++j) {
      rhs[i] -= hessenberg[i][j] * rhs[j];
    }
    rhs[i] /= hessenberg[i][i];
    vectors_.add(rhs[i], basis_[i], x);
  }
  return std::abs(rhs[used]);
}

} // namespace ionskin::electrochemistry
