// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/contact_problem.hpp"
#include "ionskin/mechanics/contact_solution.hpp"
#include "ionskin/mechanics/elastic_system.hpp"
#include "ionskin/mechanics/skin_model.hpp"

#include <array>
#include <vector>

namespace ionskin::mechanics {

/// The skin under one slider position, factorised once: the compliance of the contact cells, and
/// the strain and base reactions under any cell forces.
class CondensedPosition {
public:
  /// @param centre of the slider [m]
  CondensedPosition(const SkinModel& model, const std::array<double, 2>& centre);

  /// Compliance of the contact components [m/N].
  const linear_algebra::DenseMatrix& compliance() const { return compliance_; }

  /// What the skin does under cell forces.
  struct Response {
    CoreStrain strain;
    double equilibrium_residual = 0; ///< loads against base reactions over the largest load sum
  };
  /// Responses to many states at once. @param forces each [3 cells] [N]
  std::vector<Response> respond(const std::vector<CellVector>& forces) const;

private:
  double equilibrium_residual(const double* displacement, const CellVector& force) const;

  const SkinModel& model_;
  mesh::MeshLines lines_;
  std::array<std::vector<double>, 3> base_reaction_;
  std::unique_ptr<linear_algebra::Cholesky> factor_;
  linear_algebra::DenseMatrix
      forward_; ///< L22^-1 B of the unit loads, [footprint unknowns, 3 cells]
  linear_algebra::DenseMatrix compliance_;
};

} // namespace ionskin::mechanics
