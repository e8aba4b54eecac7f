// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/stepped_strains.hpp"

#include "ionskin/base/largest.hpp"

#include <algorithm>
#include <utility>

namespace ionskin::mechanics {
namespace {

/// Of a block: the more states, the more of them one load pattern tells. It takes little beside
/// what the nodes take; more states where every block factorises all positions again.
constexpr std::size_t least_states = 48, most_states = 400, states_per_factor = 144;
constexpr std::size_t bytes_of_block = 100'000'000;

std::size_t states_per_block(const PositionNodes& nodes) {
  const auto [nx, ny, nz] = nodes.model().mesh.elements();
  const auto [bottom, top] = nodes.model().mesh.core_z();
  const std::size_t bytes = sizeof(double) * 6 * 8 * nx * ny * (top - bottom); // of one state
  return std::max(std::clamp(bytes_of_block / bytes, least_states, most_states),
                  nodes.holds_factors() ? states_per_factor : 0);
}

} // namespace

std::size_t SteppedStrains::add(const std::array<double, 2>& centre, CellVector force) {
  centres_.push_back(centre);
  forces_.push_back(std::move(force));
  return centres_.size() - 1;
}

const CoreStrain& SteppedStrains::at(std::size_t place) {
  if (place < first_ || place >= first_ + block_.size()) {
    const std::size_t size = states_per_block(*nodes_);
    first_ = place / size * size;
    const auto begin = static_cast<std::ptrdiff_t>(first_),
               end = static_cast<std::ptrdiff_t>(std::min(centres_.size(), first_ + size));
    block_ = nodes_->respond({centres_.begin() + begin, centres_.begin() + end},
                             {forces_.begin() + begin, forces_.begin() + end});
    for (const CondensedPosition::Response& response : block_) {
      residual_ = base::larger(residual_, response.equilibrium_residual);
      stress_.resize(std::max(stress_.size(), response.electrode_stress.size()));
      for (std::size_t layer = 0; layer < response.electrode_stress.size(); ++layer) {
        stress_[layer] = base::larger(stress_[layer], response.electrode_stress[layer]);
      }
    }
  }
  return block_[place - first_].strain;
}

} // namespace ionskin::mechanics
