// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/files/disk_cache.hpp"
#include "ionskin/mechanics/elasticity/core_lattice.hpp"
#include "ionskin/mechanics/elasticity/electrode_membrane.hpp"
#include "ionskin/mechanics/output/contact_solution.hpp"
#include "ionskin/mechanics/position/factorised_skin.hpp"
#include "ionskin/mechanics/position/skin_model.hpp"
#include "ionskin/mechanics/position/unit_response.hpp"
#include "ionskin/mechanics/surface/contact_problem.hpp"
#include "ionskin/parallel/spare_threads.hpp"

#include <array>
#include <memory>
#include <vector>

namespace ionskin::mechanics {

/// What a condensed position is asked for, and where it is looked up and kept.
struct PositionUse {
  base::DiskCache* cache = nullptr;         ///< none when null
  ForceDirections forces{true, true, true}; ///< that `respond` gets
  std::size_t positions = least_positions;  ///< of the path, of which all have room or none
  int threads = 1;                          ///< for a factor that is alone in memory
  parallel::SpareThreads* spare = nullptr;  ///< for another one; none when null
};

/// The skin under one slider position: the compliance of the contact cells, and the strain and base
/// reactions under any cell forces. From the response to unit forces, made once and kept in the
/// cache, wherever `responses_fit`; where those of a path are larger from a factor that lasts as
/// long as this object. Which of both depends on mesh and path alone, so that the same forces make
/// the same bits whatever is in the cache and whatever else is solved.
class CondensedPosition {
public:
  /// @param skin outlives the position
  /// @param lines of its mesh with the slider at its place [m]
  CondensedPosition(const ElasticSkin& skin, mesh::MeshLines lines, const PositionUse& use = {});
  /// @param centre of the slider [m]
  CondensedPosition(const SkinModel& model, const std::array<double, 2>& centre,
                    const PositionUse& use = {});
  ~CondensedPosition();

  /// Compliance of the contact components of the skin, docs/model.md (8) [m/N].
  const linear_algebra::DenseMatrix& compliance() const { return stored_->compliance; }

  /// True when it keeps a factor in memory, false when it needs none.
  bool holds_factor() const { return factorised_ != nullptr; }

  /// What the skin does under cell forces.
  struct Response {
    LatticeDisplacement core;
    std::vector<double> electrode_strain; ///< as of ElectrodeMembrane [1]
    double equilibrium_residual = 0; ///< loads against base reactions over the largest load sum
  };
  /// Responses to many states at once. Without a factor each is the same bits in any company.
  /// @param forces each [3 cells] [N]
  std::vector<Response> respond(const std::vector<CellVector>& forces) const;
  CoreStrain strain(const Response& response) const {
    return lattice_strain(lines_, skin_.core_z, response.core.data());
  }
  /// Largest membrane stress of each electrode layer, bottom to top, of a combination of electrode
  /// strains [Pa].
  std::vector<double> electrode_stress(const std::vector<double>& electrode_strain) const {
    return membrane_.largest_stress(electrode_strain.data());
  }

private:
  void factorise(const PositionUse& use);
  /// What is kept of the displacement in one state.
  struct State {
    std::vector<double> lattice, membrane;
    std::array<double, 3> base_reaction{};
  };
  template <class Use> void for_states(SkinDisplacement& displacement, const Use& use) const;
  UnitResponse unit_responses(const ForceDirections& directions) const;
  /// Responses to the columns of a block [3 cells, any].
  void respond_by_products(const linear_algebra::DenseMatrix& forces,
                           std::vector<Response>& responses) const;
  std::vector<Response> respond_by_factor(const std::vector<CellVector>& forces) const;
  Response response(const double* lattice, const double* membrane,
                    const std::array<double, 3>& reaction, const double* force) const;

  const ElasticSkin& skin_;
  mesh::MeshLines lines_;
  CoreLattice lattice_;
  ElectrodeMembrane membrane_;
  std::unique_ptr<const FactorisedSkin> factorised_;
  std::shared_ptr<const StoredPosition> stored_; ///< without responses where it holds a factor
};

/// Compliance between skin and slider at a position, docs/model.md (36) [m/N].
linear_algebra::DenseMatrix contact_compliance(const SkinModel& model,
                                               const CondensedPosition& position);

} // namespace ionskin::mechanics
