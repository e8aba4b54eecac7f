// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/position/condensed_position.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/largest.hpp"
#include "ionskin/mechanics/position/position_key.hpp"
#include "ionskin/mechanics/position/position_memory.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <utility>

namespace ionskin::mechanics {
namespace {

using linear_algebra::DenseMatrix;

/// States, or unit forces, recovered in one blocked solve. Products of more columns are faster; it
/// bounds the memory.
constexpr int block_size = 64;
/// States that are recovered from a factor at once: a path has some ten patterns at a position.
constexpr int states_of_factor = 32;

/// States that are copied at once: what stands side by side of them fills whole cache lines.
constexpr int copied_states = 32;

/// Forces from `first` on, at most so many.
DenseMatrix matrix_of(const std::vector<CellVector>& forces, std::size_t first, int most) {
  const int count = static_cast<int>(std::min<std::size_t>(most, forces.size() - first));
  DenseMatrix block(static_cast<int>(forces[first].size()), count);
  for (int j = 0; j < count; ++j) {
    const CellVector& force = forces[first + static_cast<std::size_t>(j)];
    std::copy(force.begin(), force.end(), block.column(j));
  }
  return block;
}

double equilibrium_residual(const ElasticSpace& space, const std::array<double, 3>& reaction,
                            const double* force, int components) {
  // Force components are normal (downwards), x, y; the base pushes back along x, y, z.
  constexpr std::array<std::size_t, 3> direction{2, 0, 1};
  double worst = 0, largest = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    double load = 0;
    for (int at = static_cast<int>(c); at < components; at += 3) {
      load += c == 0 ? -force[at] : force[at];
    }
    largest = base::larger(largest, std::abs(load));
    if (space.held_by_base_alone(static_cast<int>(direction[c]))) {
      worst = base::larger(worst, std::abs(load - reaction[direction[c]]));
    }
  }
  return largest == 0 && worst == 0 ? 0.0 : worst / largest;
}

/// That are filled one after the other, by as many threads as ask for one.
class Displacements {
public:
  explicit Displacements(const SkinParts& parts) : parts_(parts) {}
  std::unique_ptr<SkinDisplacement> take() {
    const std::scoped_lock lock(mutex_);
    if (free_.empty()) {
      return std::make_unique<SkinDisplacement>(parts_);
    }
    std::unique_ptr<SkinDisplacement> last = std::move(free_.back());
    free_.pop_back();
    return last;
  }
  void give(std::unique_ptr<SkinDisplacement> displacement) {
    const std::scoped_lock lock(mutex_);
    free_.push_back(std::move(displacement));
  }

private:
  const SkinParts& parts_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<SkinDisplacement>> free_;
};

bool holds(const StoredPosition& position, const ForceDirections& directions) {
  return std::ranges::all_of(std::array<std::size_t, 3>{0, 1, 2},
                             [&](std::size_t d) { return position.response[d] || !directions[d]; });
}

} // namespace

CondensedPosition::CondensedPosition(const SkinModel& model, const std::array<double, 2>& centre,
                                     const PositionUse& use)
    : CondensedPosition(model, model.mesh.lines(centre), use) {}

CondensedPosition::CondensedPosition(const ElasticSkin& skin, mesh::MeshLines lines,
                                     const PositionUse& use)
    : skin_(skin), lines_(std::move(lines)), lattice_(skin.space, skin.core_z),
      membrane_(skin.space, lines_, skin.law_of_row, skin.layer_of_row, skin.core_z) {
  const int cells = static_cast<int>(skin.cells.count());
  if (!responses_fit(lattice_.rows(), membrane_.rows(), 3 * cells, use.positions)) {
    factorise(use);
    stored_ = std::make_shared<const StoredPosition>(
        StoredPosition{factorised_->compliance(), UnitResponse{}});
    return;
  }
  ForceDirections directions = use.forces;
  PositionMemory& memory = PositionMemory::of_process();
  const base::Digest key = use.cache != nullptr ? position_key(skin, lines_) : base::Digest{};
  if (use.cache != nullptr) {
    if (stored_ = memory.find(key); stored_ && holds(*stored_, directions)) {
      return;
    }
    stored_ = read_position(*use.cache, key, lattice_.rows(), membrane_.rows(), cells);
    if (stored_ && holds(*stored_, directions)) {
      memory.keep(key, stored_);
      return;
    }
    for (std::size_t d = 0; stored_ && d < directions.size(); ++d) {
      directions[d] = directions[d] || stored_->response[d]; // of an entry that is replaced
    }
  }
  factorise(use);
  auto made = std::make_shared<StoredPosition>();
  made->compliance = factorised_->compliance();
  made->response = unit_responses(directions);
  factorised_.reset();
  stored_ = std::move(made);
  if (use.cache != nullptr) {
    write_position(*use.cache, key, *stored_, use.positions);
    memory.keep(key, stored_);
  }
}

CondensedPosition::~CondensedPosition() = default;

void CondensedPosition::factorise(const PositionUse& use) {
  factorised_ = std::make_unique<const FactorisedSkin>(skin_, lines_, use.threads, use.spare);
}

template <class Use>
void CondensedPosition::for_states(SkinDisplacement& displacement, const Use& use) const {
  State state{std::vector<double>(static_cast<std::size_t>(lattice_.rows())),
              std::vector<double>(static_cast<std::size_t>(membrane_.rows())),
              {}};
  for (int first = 0; first < displacement.states(); first += copied_states) {
    const int count = std::min(copied_states, displacement.states() - first);
    const DenseMatrix& whole = displacement.of_skin(first, count);
    for (int j = 0; j < count; ++j) {
      lattice_.gather(whole.column(j), state.lattice.data());
      membrane_.average_strain(whole.column(j), state.membrane.data());
      state.base_reaction = factorised_->base_reaction(whole.column(j));
      use(first + j, state);
    }
  }
}

UnitResponse CondensedPosition::unit_responses(const ForceDirections& directions) const {
  const int cells = static_cast<int>(skin_.cells.count());
  UnitResponse result;
  std::vector<std::pair<std::size_t, int>> blocks; // direction and first cell
  for (std::size_t d = 0; d < directions.size(); ++d) {
    if (directions[d]) {
      result[d].emplace(DirectionResponse{
          {lattice_.rows(), cells}, {membrane_.rows(), cells}, DenseMatrix(3, cells)});
      for (int first = 0; first < cells; first += block_size) {
        blocks.emplace_back(d, first);
      }
    }
  }
  Displacements displacements(skin_.analysis().parts);
  factorised_->run_tasks(blocks.size(), [&](std::size_t block) {
    const auto [direction, first] = blocks[block];
    DirectionResponse& response = *result[direction];
    auto displacement = displacements.take();
    factorised_->unit_displacement(static_cast<int>(direction), first,
                                   std::min(block_size, cells - first), *displacement);
    for_states(*displacement, [&](int j, const State& state) {
      response.core.set_column(first + j, state.lattice.data());
      response.membrane.set_column(first + j, state.membrane.data());
      std::ranges::copy(state.base_reaction, response.base_reaction.column(first + j));
    });
    displacements.give(std::move(displacement));
  });
  return result;
}

CondensedPosition::Response CondensedPosition::response(const double* lattice,
                                                        const double* membrane,
                                                        const std::array<double, 3>& reaction,
                                                        const double* force) const {
  return {{lattice, lattice + lattice_.rows()},
          {membrane, membrane + membrane_.rows()},
          equilibrium_residual(skin_.space, reaction, force, compliance().columns)};
}

void CondensedPosition::respond_by_products(const DenseMatrix& forces,
                                            std::vector<Response>& responses) const {
  const int cells = compliance().columns / 3;
  DenseMatrix core(lattice_.rows(), forces.columns), strain(membrane_.rows(), forces.columns),
      direct(cells, forces.columns);
  std::vector<std::array<double, 3>> reaction(static_cast<std::size_t>(forces.columns));
  for (int d = 0; d < 3; ++d) {
    for (int k = 0; k < forces.columns; ++k) {
      for (int cell = 0; cell < cells; ++cell) {
        direct(cell, k) = forces(3 * cell + d, k);
      }
    }
    const auto& unit = stored_->response[static_cast<std::size_t>(d)];
    if (!unit) {
      if (std::ranges::any_of(direct.values, [](double force) { return force != 0; })) {
        throw InternalError("a slider position has no response in the direction of a force");
      }
      continue;
    }
    multiply_add(unit->core, direct, core);
    multiply_add(unit->membrane, direct, strain);
    for (int k = 0; k < forces.columns; ++k) {
      for (int cell = 0; cell < cells; ++cell) {
        for (int r = 0; r < 3; ++r) {
          reaction[k][r] += unit->base_reaction(r, cell) * direct(cell, k);
        }
      }
    }
  }
  for (int k = 0; k < forces.columns; ++k) {
    responses.push_back(response(core.column(k), strain.column(k), reaction[k], forces.column(k)));
  }
}

std::vector<CondensedPosition::Response>
CondensedPosition::respond_by_factor(const std::vector<CellVector>& forces) const {
  std::vector<Response> responses(forces.size());
  const std::size_t blocks = (forces.size() + states_of_factor - 1) / states_of_factor;
  factorised_->run_tasks(blocks, [&](std::size_t block) {
    const std::size_t first = block * states_of_factor;
    const DenseMatrix own = matrix_of(forces, first, states_of_factor);
    SkinDisplacement displacement(skin_.analysis().parts);
    factorised_->displacement(own, displacement);
    for_states(displacement, [&](int k, const State& state) {
      responses[first + static_cast<std::size_t>(k)] =
          response(state.lattice.data(), state.membrane.data(), state.base_reaction, own.column(k));
    });
  });
  return responses;
}

std::vector<CondensedPosition::Response>
CondensedPosition::respond(const std::vector<CellVector>& forces) const {
  if (factorised_) {
    return respond_by_factor(forces);
  }
  std::vector<Response> responses;
  for (std::size_t first = 0; first < forces.size(); first += block_size) {
    respond_by_products(matrix_of(forces, first, block_size), responses);
  }
  return responses;
}

DenseMatrix contact_compliance(const SkinModel& model, const CondensedPosition& position) {
  DenseMatrix compliance = position.compliance();
  for (std::size_t at = 0; at < model.slider_compliance.values.size(); ++at) {
    compliance.values[at] += model.slider_compliance.values[at];
  }
  return compliance;
}

} // namespace ionskin::mechanics
