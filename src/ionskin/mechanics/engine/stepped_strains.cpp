// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/stepped_strains.hpp"

#include "ionskin/base/largest.hpp"
#include "ionskin/finite_layers/fields/states_at_once.hpp"
#include "ionskin/parallel/task_pool.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace ionskin::mechanics {

std::size_t SteppedStrains::add(const std::array<double, 2>& centre, CellVector force) {
  centres_.push_back(centre);
  forces_.push_back(std::move(force));
  return centres_.size() - 1;
}

void SteppedStrains::recover(std::size_t first) {
  constexpr std::size_t states_per_thread = finite_layers::states_at_once;
  const std::span centres = std::span(centres_).subspan(first);
  const std::span forces = std::span(forces_).subspan(first);
  const std::size_t most =
      std::min(states_per_thread * static_cast<std::size_t>(threads_), centres.size());
  std::vector<std::vector<RecoveredStrain>> recovered((most + states_per_thread - 1) /
                                                      states_per_thread);
  const auto task = [&](std::size_t i) {
    const std::size_t from = i * states_per_thread;
    const std::size_t count = std::min(states_per_thread, most - from);
    recovered[i] = recovery_->at(centres.subspan(from, count), forces.subspan(from, count));
  };
  if (spare_) {
    parallel::run_tasks_with_help(recovered.size(), *spare_, task);
  } else {
    parallel::run_tasks(recovered.size(), threads_, task);
  }
  held_.clear();
  for (std::vector<RecoveredStrain>& some : recovered) {
    for (RecoveredStrain& one : some) {
      residual_ = base::nan_max(residual_, one.equilibrium_residual);
      stress_.resize(std::max(stress_.size(), one.electrode_stress.size()));
      std::ranges::transform(one.electrode_stress, stress_, stress_.begin(), base::nan_max);
      held_.push_back(std::move(one.core));
    }
  }
  first_ = first;
}

const CoreStrain& SteppedStrains::at(std::size_t place) {
  if (place < first_ || place >= first_ + held_.size()) {
    recover(place);
  }
  return held_[place - first_];
}

LayerStrainAt SteppedStrains::all_layers() const {
  return [this, of_state = recovery_->all_layers()](std::size_t place) {
    return of_state(centres_.at(place), forces_.at(place));
  };
}

} // namespace ionskin::mechanics
