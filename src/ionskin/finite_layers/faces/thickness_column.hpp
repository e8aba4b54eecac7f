// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/thickness/depth_strain.hpp"
#include "ionskin/finite_layers/thickness/lobatto_element.hpp"

#include <Eigen/Core>

#include <vector>

namespace ionskin::finite_layers {

/// Sizes of the elements through one layer, from its bottom. Only their ratios matter.
using ElementSizes = std::vector<double>;

/// Finite elements through the thickness of all layers on a rigid base. They give the stiffness
/// matrix for waves of any number, docs/model.md (50). Unknowns are the displacements of the nodes
/// above the base, numbered upwards, so that the last node lies on the top face.
class ThicknessColumn {
public:
  /// Assembles the elements.
  /// @param layers bottom to top
  /// @param elements through each layer, bottom to top
  /// @param degree of the polynomials of the elements
  ThicknessColumn(const std::vector<ElasticLayer>& layers,
                  const std::vector<ElementSizes>& elements, int degree);

  /// Number of nodes above the base.
  Eigen::Index nodes() const { return heights_.size(); }
  /// Heights of the nodes above the base [m].
  const Eigen::VectorXd& heights() const { return heights_; }
  /// Row vectors that interpolate at a level: `value` [1] and its derivative upwards `slope` [1/m],
  /// per value at the nodes.
  struct AtLevel {
    Eigen::RowVectorXd value, slope;
  };
  /// Interpolates at a level; a level without height stands for the mean through its layer.
  AtLevel at(const DepthLevel& level) const;

  /// Calculates the plane-strain stiffness matrix; unknowns are U_r along the wave at all nodes,
  /// then w upwards at all nodes [Pa/m].
  /// @param wave_number [1/m]
  Eigen::MatrixXd plane_strain(double wave_number) const;
  /// Calculates the antiplane stiffness matrix; unknowns are U_t across the wave at all nodes
  /// [Pa/m].
  /// @param wave_number [1/m]
  Eigen::MatrixXd antiplane(double wave_number) const;

  /// Integrals of (lambda + 2 mu) N_i N_j over the thickness, with the shape functions N_i [N/m].
  const Eigen::MatrixXd& oedometric_mass() const { return oedometric_mass_; }
  /// Integrals of lambda N_i N_j over the thickness [N/m].
  const Eigen::MatrixXd& lame_mass() const { return lame_mass_; }
  /// Integrals of mu N_i N_j over the thickness [N/m].
  const Eigen::MatrixXd& shear_mass() const { return shear_mass_; }
  /// Integrals of lambda N_i' N_j over the thickness, with i for the row [Pa].
  const Eigen::MatrixXd& lame_slope() const { return lame_slope_; }

private:
  struct Part {
    LobattoElement element;
    std::size_t layer = 0;
    double bottom = 0, size = 0; ///< height above the bottom of its layer [m], size [m]
    Eigen::Index first = 0;      ///< index of its lowest node, where the base counts as node 0
  };
  std::vector<Part> parts_; ///< ordered upwards
  std::vector<double> thickness_;
  Eigen::VectorXd heights_;
  Eigen::MatrixXd oedometric_mass_, lame_mass_, shear_mass_, lame_slope_;
  Eigen::MatrixXd oedometric_stiffness_, shear_stiffness_, coupling_;
};

} // namespace ionskin::finite_layers
