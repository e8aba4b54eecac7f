// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/engine/stepped_strains.hpp"

#include "ionskin/base/largest.hpp"
#include "ionskin/mechanics/position/memory_estimate.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace ionskin::mechanics {
namespace {

/// Of a block. It takes little beside what the nodes take.
constexpr std::size_t least_states = 48, most_states = 400;
constexpr std::size_t bytes_of_block = 100'000'000;
/// Of a stretch where each takes all factors again.
constexpr std::size_t states_of_stretch = 3000;

/// Memory of the strains that are then recovered together: what keeps them and a factor within 8
/// GB, with some room for the rest, or a part of what the factor takes anyway.
std::size_t most_recovered_bytes(const PositionNodes& nodes) {
  constexpr double most = 2.4e9, with_factor = 7.6e9, share = 0.2;
  const double factor = factorisation_memory(nodes.model().mesh.unknowns());
  return static_cast<std::size_t>(std::min(most, std::max(with_factor - factor, share * factor)));
}

} // namespace

void SharedRecovery::join(const std::shared_ptr<const SteppedStrains>& path) {
  const std::lock_guard lock(mutex_);
  members_.push_back({path, false, nullptr});
}

void SharedRecovery::begin(const std::function<void()>& finished) {
  const std::lock_guard lock(mutex_);
  for (Member& member : members_) {
    const auto path = member.path.lock();
    if (nodes_->holds_factors() && path && path->count() > 0) {
      member.first = recover(*path, 0, finished);
      return;
    }
  }
}

std::shared_ptr<const PathResponse> SharedRecovery::stretch(const SteppedStrains& path,
                                                            std::size_t first) {
  if (!nodes_->holds_factors()) {
    auto response = std::make_shared<PathResponse>(path.patterns(first));
    nodes_->solve({response.get()});
    return response;
  }
  const std::lock_guard lock(mutex_);
  for (Member& member : members_) {
    if (first == 0 && member.path.lock().get() == &path && member.first) {
      return std::exchange(member.first, nullptr);
    }
  }
  return recover(path, first, [] {});
}

std::shared_ptr<const PathResponse> SharedRecovery::recover(const SteppedStrains& path,
                                                            std::size_t first,
                                                            const std::function<void()>& finished) {
  const auto own = std::make_shared<PathResponse>(path.patterns(first));
  std::vector<PathResponse*> together{own.get()};
  std::vector<std::pair<Member*, std::shared_ptr<PathResponse>>> others;
  const std::size_t most = most_recovered_bytes(*nodes_);
  std::size_t bytes = own->bytes();
  for (Member& member : members_) {
    const auto other = member.path.lock();
    if (other.get() == &path) {
      member.begun = true;
    } else if (other && other->count() > 0 && !member.begun && bytes < most) {
      auto response = std::make_shared<PathResponse>(other->patterns(0));
      bytes += response->bytes();
      if (bytes <= most) {
        together.push_back(response.get());
        others.emplace_back(&member, std::move(response));
      }
    }
  }
  nodes_->solve(together, finished);
  for (auto& [member, response] : others) {
    member->begun = true;
    member->first = std::move(response);
  }
  return own;
}

std::size_t SteppedStrains::states_per_block() const {
  const auto [nx, ny, nz] = recovery_->nodes().model().mesh.elements();
  const auto [bottom, top] = recovery_->nodes().model().mesh.core_z();
  const std::size_t bytes = sizeof(double) * 6 * 8 * nx * ny * (top - bottom); // of one state
  return std::clamp(bytes_of_block / bytes, least_states, most_states);
}

std::size_t SteppedStrains::add(const std::array<double, 2>& centre, CellVector force) {
  centres_.push_back(centre);
  forces_.push_back(std::move(force));
  return centres_.size() - 1;
}

PathResponse SteppedStrains::patterns(std::size_t first) const {
  const PositionNodes& nodes = recovery_->nodes();
  const std::size_t least = states_per_block();
  std::size_t states = std::min(count() - first, nodes.holds_factors() ? states_of_stretch : least);
  while (true) {
    PathResponse response = nodes.patterns(std::span(centres_).subspan(first, states),
                                           std::span(forces_).subspan(first, states));
    if (response.bytes() <= most_recovered_bytes(nodes) || states <= least) {
      return response;
    }
    states = std::max(least, states / 2);
  }
}

std::size_t SteppedStrains::begin_of_stretch(std::size_t place) const {
  if (!recovery_->nodes().holds_factors()) {
    return place / states_per_block() * states_per_block();
  }
  std::size_t first = stretch_ && place >= first_of_stretch_ ? first_of_stretch_ : 0;
  while (true) {
    const bool known = stretch_ && first == first_of_stretch_;
    const std::size_t next = first + (known ? stretch_->count() : patterns(first).count());
    if (place < next) {
      return first;
    }
    first = next;
  }
}

void SteppedStrains::recover(std::size_t place) {
  const std::size_t stretch = begin_of_stretch(place);
  if (!stretch_ || stretch != first_of_stretch_) {
    stretch_ = nullptr;
    first_of_stretch_ = stretch;
    stretch_ = recovery_->stretch(*this, stretch);
  }
  const std::size_t size = states_per_block(), begin = (place - first_of_stretch_) / size * size;
  block_ = stretch_->states(begin, std::min(size, stretch_->count() - begin),
                            recovery_->nodes().threads());
  first_ = first_of_stretch_ + begin;
  for (const StateResponse& response : block_) {
    residual_ = base::larger(residual_, response.equilibrium_residual);
    stress_.resize(std::max(stress_.size(), response.electrode_stress.size()));
    for (std::size_t layer = 0; layer < response.electrode_stress.size(); ++layer) {
      stress_[layer] = base::larger(stress_[layer], response.electrode_stress[layer]);
    }
  }
}

const CoreStrain& SteppedStrains::at(std::size_t place) {
  if (place < first_ || place >= first_ + block_.size()) {
    recover(place);
  }
  return block_[place - first_].strain;
}

} // namespace ionskin::mechanics
