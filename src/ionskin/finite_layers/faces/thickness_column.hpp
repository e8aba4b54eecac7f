// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/finite_layers/thickness/depth_strain.hpp"
#include "ionskin/finite_layers/thickness/lobatto_element.hpp"

#include <Eigen/Core>

#include <vector>

namespace ionskin::finite_layers {

/// Elements through one layer: their sizes, of which only the ratios count, from below.
using ElementSizes = std::vector<double>;

/// Finite elements through the thickness of all layers on a rigid base: the matrices that make the
/// stiffness of waves of any number, docs/model.md (50). Unknowns are those at the nodes above the
/// base, upwards, so that the last is that of the face.
class ThicknessColumn {
public:
  /// @param elements of each layer, bottom to top
  ThicknessColumn(const std::vector<ElasticLayer>& layers,
                  const std::vector<ElementSizes>& elements, int degree);

  Eigen::Index nodes() const { return heights_.size(); }
  const Eigen::VectorXd& heights() const { return heights_; } ///< of the nodes [m]
  /// Value at a level over the values at the nodes, and slope upwards [1/m].
  struct AtLevel {
    Eigen::RowVectorXd value, slope;
  };
  AtLevel at(const DepthLevel& level) const;

  /// In the unknowns along the wave, at all nodes, and upwards, at all nodes.
  /// @param wave_number [1/m]
  Eigen::MatrixXd plane_strain(double wave_number) const;
  /// Matrix in the unknowns across the wave.
  Eigen::MatrixXd antiplane(double wave_number) const;

  /// Integrals of (lambda + 2 mu) N_i N_j, of lambda N_i N_j and of mu N_i N_j [N/m], and of
  /// lambda N_i' N_j, i by rows [Pa].
  const Eigen::MatrixXd& oedometric_mass() const { return oedometric_mass_; }
  const Eigen::MatrixXd& lame_mass() const { return lame_mass_; }
  const Eigen::MatrixXd& shear_mass() const { return shear_mass_; }
  const Eigen::MatrixXd& lame_slope() const { return lame_slope_; }

private:
  struct Part {
    LobattoElement element;
    std::size_t layer = 0;
    double bottom = 0, size = 0; ///< above the bottom of its layer [m]
    Eigen::Index first = 0;      ///< node, the base counted as well
  };
  std::vector<Part> parts_; ///< upwards
  std::vector<double> thickness_;
  Eigen::VectorXd heights_;
  Eigen::MatrixXd oedometric_mass_, lame_mass_, shear_mass_, lame_slope_;
  Eigen::MatrixXd oedometric_stiffness_, shear_stiffness_, coupling_;
};

} // namespace ionskin::finite_layers
