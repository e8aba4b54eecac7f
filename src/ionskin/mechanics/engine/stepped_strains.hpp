// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/engine/position_nodes.hpp"
#include "ionskin/mechanics/output/contact_solution.hpp"

#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace ionskin::mechanics {

class SteppedStrains;

/// Recovers the strains of paths over the same nodes, stretch by stretch. Where the nodes hold
/// factors, each time all positions are factorised again: the first stretches of all paths are
/// recovered together, as far as the memory goes. Thread-safe.
class SharedRecovery {
public:
  explicit SharedRecovery(std::shared_ptr<const PositionNodes> nodes) : nodes_(std::move(nodes)) {}

  const PositionNodes& nodes() const { return *nodes_; }
  void join(const std::shared_ptr<const SteppedStrains>& path);
  /// First stretches of the paths that joined, before they are asked for. Nothing where the nodes
  /// hold no factors.
  /// @param finished called after each position
  void begin(const std::function<void()>& finished);
  /// The stretch of a path that begins at a state.
  std::shared_ptr<const PathResponse> stretch(const SteppedStrains& path, std::size_t first);

private:
  struct Member {
    std::weak_ptr<const SteppedStrains> path;
    bool begun = false;
    std::shared_ptr<const PathResponse> first; ///< that nobody asked for yet
  };
  std::shared_ptr<const PathResponse> recover(const SteppedStrains& path, std::size_t first,
                                              const std::function<void()>& finished);

  std::shared_ptr<const PositionNodes> nodes_;
  std::mutex mutex_;
  std::vector<Member> members_;
};

/// The strains of a stepped path, recovered from the nodes stretch by stretch, and of a stretch
/// block by block.
class SteppedStrains : public StrainSource {
public:
  explicit SteppedStrains(std::shared_ptr<SharedRecovery> recovery)
      : recovery_(std::move(recovery)) {}

  /// @returns the place of the state
  std::size_t add(const std::array<double, 2>& centre, CellVector force);
  std::size_t count() const { return centres_.size(); }
  /// Load patterns of the stretch that begins at a state, not yet solved. It depends on the path
  /// alone.
  PathResponse patterns(std::size_t first) const;

  const CoreStrain& at(std::size_t place) override;
  const std::vector<double>& largest_electrode_stress() const override { return stress_; }
  double worst_equilibrium_residual() const override { return residual_; }

private:
  std::size_t states_per_block() const;
  std::size_t begin_of_stretch(std::size_t place) const;
  void recover(std::size_t place);

  std::shared_ptr<SharedRecovery> recovery_;
  std::vector<std::array<double, 2>> centres_;
  std::vector<CellVector> forces_;
  std::shared_ptr<const PathResponse> stretch_;
  std::size_t first_of_stretch_ = 0, first_ = 0; ///< of stretch and block
  std::vector<StateResponse> block_;
  std::vector<double> stress_;
  double residual_ = 0;
};

} // namespace ionskin::mechanics
