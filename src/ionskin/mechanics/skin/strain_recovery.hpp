// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"
#include "ionskin/mechanics/output/contact_solution.hpp"
#include "ionskin/mechanics/skin/skin_model.hpp"
#include "ionskin/mechanics/surface/contact_problem.hpp"

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace ionskin::mechanics {

/// Strain of the skin under the forces of a state.
struct RecoveredStrain {
  CoreStrain core; ///< of the components that were chosen
  /// Largest von Mises stress of each electrode layer as a membrane, averaged through its thickness
  /// and over each column between the lines of the mesh, bottom to top [Pa].
  std::vector<double> electrode_stress;
  /// Largest difference of the forces through a level of the core from those on the cells, over the
  /// largest sum of those.
  double equilibrium_residual = 0;
};

/// Components of the core's strain that the coupling of a case reads.
finite_layers::ComponentChoice strain_components(const Case& input);

/// Recovers the strain of states from the forces of their cells. Thread-safe; each state is the
/// same bits in any company.
class StrainRecovery {
public:
  /// @param components of the core
  /// @param threads that make what all states share
  StrainRecovery(std::shared_ptr<const SkinModel> model,
                 const finite_layers::ComponentChoice& components, int threads = 1);

  /// Strains of states; some at once cost less than one by one.
  /// @param centres of the slider [m]
  /// @param forces of the cells [N]
  std::vector<RecoveredStrain> at(std::span<const std::array<double, 2>> centres,
                                  std::span<const CellVector> forces) const;

  /// Strain of a state in all layers, with all components of the core.
  using LayersOfState =
      std::function<LayerStrain(const std::array<double, 2>& centre, const CellVector& forces)>;
  /// Makes what all states share of it, which nothing here needs; lives by itself.
  LayersOfState all_layers() const;

private:
  std::shared_ptr<const SkinModel> model_;
  finite_layers::SkinFields fields_;
};

} // namespace ionskin::mechanics
