// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/output/contact_solution.hpp"
#include "ionskin/mechanics/skin/strain_recovery.hpp"
#include "ionskin/mechanics/surface/contact_problem.hpp"
#include "ionskin/parallel/spare_threads.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace ionskin::mechanics {

/// Strains of the states of a path, each recovered from the forces of its own state. Some states
/// that follow each other are recovered at once.
class SteppedStrains : public StrainSource {
public:
  /// @param spare source of further threads that help the calling one; null: none, `threads`
  ///   threads work
  SteppedStrains(std::shared_ptr<const StrainRecovery> recovery, int threads,
                 std::shared_ptr<parallel::SpareThreads> spare = nullptr)
      : recovery_(std::move(recovery)), threads_(threads), spare_(std::move(spare)) {}

  /// Adds a state.
  /// @param centre of the slider [m]
  /// @param force on the cells, [3 cells] [N]
  /// @returns index of the state
  std::size_t add(const std::array<double, 2>& centre, CellVector force);
  std::size_t count() const { return centres_.size(); }

  const CoreStrain& at(std::size_t place) override;
  LayerStrainAt all_layers() const override;
  const std::vector<double>& largest_electrode_stress() const override { return stress_; }
  double worst_equilibrium_residual() const override { return residual_; }

private:
  void recover(std::size_t first);

  std::shared_ptr<const StrainRecovery> recovery_;
  int threads_;
  std::shared_ptr<parallel::SpareThreads> spare_;
  std::vector<std::array<double, 2>> centres_;
  std::vector<CellVector> forces_;
  std::size_t first_ = 0; ///< index of the first state in `held_`
  std::vector<CoreStrain> held_;
  std::vector<double> stress_;
  double residual_ = 0;
};

} // namespace ionskin::mechanics
