// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/position/factorised_skin.hpp"

#include "ionskin/linear_algebra/cholesky.hpp"
#include "ionskin/mechanics/elasticity/elastic_system.hpp"
#include "ionskin/mechanics/path/find_footprint.hpp"
#include "ionskin/mechanics/position/skin_model.hpp"
#include "largest_difference.hpp"
#include "small_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <thread>
#include <vector>

namespace ionskin::mechanics {
namespace {

using linear_algebra::DenseMatrix;

/// The whole skin by one factorisation: displacement under unit forces on all cells, and the base
/// reactions to it.
struct Direct {
  DenseMatrix displacement, reaction;

  Direct(const SkinModel& model, const mesh::MeshLines& lines) {
    const ElasticSpace space(lines, model.fixed);
    const ElasticSystem system = assemble(space, lines, model.law_of_row);
    const linear_algebra::SymbolicCholesky symbolic(space.pattern(), space.elimination_order({}),
                                                    0);
    const std::vector<int> loaded = model.space.unknowns_of(model.cells.nodes);
    displacement = DenseMatrix(model.space.unknowns(), model.cells.unit_load.columns);
    for (int j = 0; j < displacement.columns; ++j) {
      for (std::size_t i = 0; i < loaded.size(); ++i) {
        displacement(loaded[i], j) = model.cells.unit_load(static_cast<int>(i), j);
      }
    }
    displacement = linear_algebra::Cholesky(symbolic, system.stiffness).solve(displacement);
    reaction = DenseMatrix(3, displacement.columns);
    for (int j = 0; j < displacement.columns; ++j) {
      for (std::size_t c = 0; c < 3; ++c) {
        const auto& force = system.base_reaction[c];
        reaction(static_cast<int>(c), j) =
            std::inner_product(force.begin(), force.end(), displacement.column(j), 0.0);
      }
    }
  }
  DenseMatrix compliance(const SkinModel& model) const {
    const std::vector<int> loaded = model.space.unknowns_of(model.cells.nodes);
    const DenseMatrix& load = model.cells.unit_load;
    DenseMatrix result(load.columns, load.columns);
    for (int j = 0; j < load.columns; ++j) {
      for (int k = 0; k < load.columns; ++k) {
        for (int i = 0; i < load.rows; ++i) {
          result(k, j) += load(i, k) * displacement(loaded[static_cast<std::size_t>(i)], j);
        }
      }
    }
    return result;
  }
};

struct Skin {
  std::string name;
  Case input;
};

Case coarser_case() {
  Case input = small_case();
  input.numerics.mesh_refinement = 0.3;
  return input;
}

/// Cut before and behind the footprint along x and along y, and not at all.
std::vector<Skin> skins() {
  std::vector<Skin> result{{"half", coarser_case()}};
  Skin whole{"whole", coarser_case()};
  whole.input.slider.start[1] = 0.8e-3;
  result.push_back(whole);
  Skin across{"across", coarser_case()};
  across.input.motion.direction = {0, 1};
  across.input.motion.stroke = 0.4e-3;
  across.input.slider.start[1] = 0.7e-3;
  across.input.skin.sides = SideCondition::symmetry;
  result.push_back(across);
  Skin covered{"covered", coarser_case()};
  covered.input.slider.size[0] = covered.input.skin.length;
  covered.input.slider.start = {covered.input.skin.length / 2, 1e-3};
  covered.input.motion.stroke = 0;
  result.push_back(covered);
  return result;
}

TEST(FactorisedSkin, agrees_with_one_factorisation_of_the_whole_skin) {
  for (const auto& [name, input] : skins()) {
    const SkinModel model(input, mesh::largest_footprint(input));
    for (const double way : {0.0, 1.0}) {
      std::array<double, 2> centre = input.slider.start;
      for (std::size_t d = 0; d < 2; ++d) {
        centre[d] += way * input.motion.stroke * input.motion.direction[d];
      }
      const mesh::MeshLines lines = model.mesh.lines(centre);
      const FactorisedSkin factorised(model, lines);
      const Direct direct(model, lines);
      EXPECT_LT(largest_difference(factorised.compliance().values, direct.compliance(model).values),
                1e-11)
          << name;
      const int cells = static_cast<int>(model.cells.count());
      DenseMatrix displacement(model.space.unknowns(), 3 * cells);
      SkinDisplacement states(model.analysis().parts);
      for (int d = 0; d < 3; ++d) {
        factorised.unit_displacement(d, 0, cells, states);
        ASSERT_EQ(states.states(), cells);
        for (int cell = 0; cell < cells; ++cell) {
          const DenseMatrix& state = states.of_skin(cell, 1);
          std::ranges::copy(state.values, displacement.column(3 * cell + d));
          const auto reaction = factorised.base_reaction(state.values.data());
          for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(reaction[static_cast<std::size_t>(c)], direct.reaction(c, 3 * cell + d),
                        1e-10)
                << name;
          }
        }
      }
      EXPECT_LT(largest_difference(displacement.values, direct.displacement.values), 1e-11) << name;

      DenseMatrix forces(3 * cells, 1);
      for (int i = 0; i < forces.rows; ++i) {
        forces(i, 0) = std::cos(i);
      }
      factorised.displacement(forces, states);
      EXPECT_LT(largest_difference(states.of_skin(0, 1).values,
                                   linear_algebra::multiply(direct.displacement, forces).values),
                1e-11)
          << name;
    }
  }
}

TEST(FactorisedSkin, has_the_same_bits_whatever_was_factorised_before_and_on_any_thread) {
  const Case input = coarser_case();
  const mesh::Footprint footprint = mesh::largest_footprint(input);
  const auto compliance = [&](const SkinModel& model, double x) {
    return FactorisedSkin(model, model.mesh.lines({x, input.slider.start[1]})).compliance().values;
  };
  const std::vector<double> places{1.5e-3, 1.7e-3, 2.1e-3, 2.3e-3};
  std::vector<std::vector<double>> alone, together(places.size());
  for (const double x : places) {
    alone.push_back(compliance(SkinModel(input, footprint), x));
  }
  const SkinModel shared(input, footprint);
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < places.size(); ++i) {
      threads.emplace_back([&, i] { together[i] = compliance(shared, places[i]); });
    }
  }
  EXPECT_EQ(together, alone);
}

} // namespace
} // namespace ionskin::mechanics
