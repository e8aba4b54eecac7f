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

/// Strain of the skin under the forces of one state, made by `StrainRecovery`.
struct RecoveredStrain {
  CoreStrain core; ///< only the components that were chosen
  /// Largest von Mises stress in each electrode layer, bottom to top [Pa]. The stress is that of a
  /// membrane: averaged through the layer and over each column between the lines of the mesh.
  std::vector<double> electrode_stress;
  /// Largest difference between the sums of the forces through any level of the core and of the
  /// forces on the cells, relative to the largest sum of the forces on the cells [1].
  double equilibrium_residual = 0;
};

/// Components of the core's strain that the coupling law of a case reads.
finite_layers::ComponentChoice strain_components(const Case& input);

/// Recovers the strain of states from the forces on their cells. Thread-safe. The result for a
/// state does not depend on the states that are recovered with it, to the last bit.
class StrainRecovery {
public:
  /// @param components of the core's strain to recover
  /// @param threads number of threads that prepare what all states share
  StrainRecovery(std::shared_ptr<const SkinModel> model,
                 const finite_layers::ComponentChoice& components, int threads = 1);

  /// Recovers the strains of several states, which costs less than one by one.
  /// @param centres centre of the slider in each state [m]
  /// @param forces on the cells in each state, [3 cells] [N]
  std::vector<RecoveredStrain> at(std::span<const std::array<double, 2>> centres,
                                  std::span<const CellVector> forces) const;

  /// Recovers the strain of one state in all layers, with all components of the core.
  using LayersOfState =
      std::function<LayerStrain(const std::array<double, 2>& centre, const CellVector& forces)>;
  /// Prepares the recovery of strain in all layers, once for all states. The result does not depend
  /// on the lifetime of this object.
  LayersOfState all_layers() const;

private:
  std::shared_ptr<const SkinModel> model_;
  finite_layers::SkinFields fields_;
};

} // namespace ionskin::mechanics
