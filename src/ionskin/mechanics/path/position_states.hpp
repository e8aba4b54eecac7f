// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/mechanics/output/contact_solution.hpp"
#include "ionskin/mechanics/path/slider_track.hpp"
#include "ionskin/mechanics/position/condensed_position.hpp"
#include "ionskin/mechanics/surface/contact_solver.hpp"

#include <vector>

namespace ionskin::mechanics {

/// Everything of a state but its strain and what goes with that: forces of the full skin, tractions
/// and diagnostics, reflected back from the canonical position.
/// @param reference_force, reference_indentation scales of the diagnostics [N], [m]
void describe(const SkinModel& model, const SurfaceState& state, const ContactProblem& problem,
              const CanonicalPosition& position, double reference_force,
              double reference_indentation, ContactState& destination);

/// Collects equilibria at one condensed position and completes them together: forces of the full
/// skin, tractions, strains and diagnostics, all reflected back from the canonical position.
class PositionStates {
public:
  explicit PositionStates(const SkinModel& model) : model_(&model) {}

  /// @param destination outlives `complete`
  /// @param reference_force, reference_indentation scales of the diagnostics [N], [m]
  void add(ContactState& destination, SurfaceState state, const ContactProblem& problem,
           const CanonicalPosition& position, double reference_force, double reference_indentation);

  /// Takes over what another collection of the same position waits for.
  void append(PositionStates other);

  std::size_t count() const { return pending_.size(); }
  /// Recovers the strains of the added states [begin, end) together. Several threads may complete
  /// parts that do not overlap.
  void complete(const CondensedPosition& position, std::size_t begin, std::size_t end) const;
  void complete(const CondensedPosition& position) const { complete(position, 0, count()); }

private:
  struct Pending {
    ContactState* destination = nullptr;
    CellVector force;
    std::array<bool, 2> reflect{};
  };
  const SkinModel* model_;
  std::vector<Pending> pending_;
};

/// Largest normal force of a cell [N].
double largest_normal_force(const CellVector& force);

/// A cell vector of the canonical position seen in the skin's own frame, and back.
CellVector reflected(const ContactCells& cells, const CellVector& vector,
                     const std::array<bool, 2>& reflect);

} // namespace ionskin::mechanics
