// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/disk_cache.hpp"
#include "ionskin/mechanics/contact_problem.hpp"
#include "ionskin/mechanics/contact_solution.hpp"
#include "ionskin/mechanics/core_lattice.hpp"
#include "ionskin/mechanics/electrode_membrane.hpp"
#include "ionskin/mechanics/skin_model.hpp"
#include "ionskin/mechanics/unit_response.hpp"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace ionskin::mechanics {

/// Where condensed positions are looked up and kept.
struct PositionStore {
  base::DiskCache* cache = nullptr; ///< none when null
  /// The response to every unit force takes as long as the factorisation and saves it ever after.
  /// It is made at once when true, as many states ask for it, and otherwise when a position comes
  /// for the second time; never where the cache could not keep those of a slide.
  bool many_states = false;
};

/// The skin under one slider position: the compliance of the contact cells, and the strain and base
/// reactions under any cell forces. From the cache, or from a factorisation that lasts as long as
/// this object.
class CondensedPosition {
public:
  /// @param model outlives the position
  /// @param centre of the slider [m]
  /// @param threads that a factor takes which the memory holds only one of at a time
  CondensedPosition(const SkinModel& model, const std::array<double, 2>& centre,
                    const PositionStore& store = {}, int threads = 1);
  ~CondensedPosition();

  /// Compliance of the contact components [m/N].
  const linear_algebra::DenseMatrix& compliance() const { return compliance_; }

  /// True when it keeps a factor in memory, false when it needs none.
  bool holds_factor() const { return factorised_ != nullptr; }

  /// What the skin does under cell forces.
  struct Response {
    CoreStrain strain;
    /// Largest membrane stress of each electrode layer, bottom to top [Pa].
    std::vector<double> electrode_stress;
    double equilibrium_residual = 0; ///< loads against base reactions over the largest load sum
  };
  /// Responses to many states at once. @param forces each [3 cells] [N]
  std::vector<Response> respond(const std::vector<CellVector>& forces) const;

private:
  class Factorised;
  UnitResponse unit_response() const;
  Response response(const double* lattice, const double* membrane,
                    const std::array<double, 3>& reaction, const CellVector& force) const;

  const SkinModel& model_;
  mesh::MeshLines lines_;
  CoreLattice lattice_;
  ElectrodeMembrane membrane_;
  linear_algebra::DenseMatrix compliance_;
  std::unique_ptr<Factorised> factorised_;
  std::optional<UnitResponse> response_;
};

} // namespace ionskin::mechanics
