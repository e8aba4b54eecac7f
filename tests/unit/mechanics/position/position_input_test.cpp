// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/position/position_input.hpp"

#include "ionskin/mechanics/position/condensed_position.hpp"
#include "ionskin/mechanics/position/skin_model.hpp"
#include "scratch_folder.hpp"
#include "small_case.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace ionskin::mechanics {
namespace {

class PositionInputTest : public testing::Test {
protected:
  PositionInput given_input() const {
    return position_input(model_, model_.mesh.lines(input_.slider.start));
  }

  Case input_ = small_case();
  SkinModel model_{input_, mesh::largest_footprint(input_)};
  results::ScratchFolder folder_;
};

TEST_F(PositionInputTest, is_solved_from_its_file_to_the_same_bits) {
  const PositionInput given = given_input();
  const auto path = folder_.path() / "position";
  write_position_input(path, given);
  const auto read = read_position_input(path);
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(position_input_bytes(*read), position_input_bytes(given));

  const ElasticSkin elsewhere(*read);
  EXPECT_EQ(position_key(elsewhere, read->lines), position_key(model_, given.lines));
  const CondensedPosition here(model_, input_.slider.start), there(elsewhere, read->lines);
  EXPECT_EQ(there.compliance().values, here.compliance().values);
  CellVector force(3 * model_.cells.count());
  for (std::size_t at = 0; at < force.size(); ++at) {
    force[at] = std::cos(0.3 + static_cast<double>(at));
  }
  const auto expected = here.respond({force}).front(), response = there.respond({force}).front();
  EXPECT_EQ(there.strain(response).component, here.strain(expected).component);
  EXPECT_EQ(there.electrode_stress(response.electrode_strain),
            here.electrode_stress(expected.electrode_strain));
  EXPECT_EQ(response.equilibrium_residual, expected.equilibrium_residual);
}

TEST_F(PositionInputTest, has_another_key_at_another_place_and_of_another_material) {
  const PositionInput given = given_input();
  PositionInput moved = given, softer = given, freed = given;
  moved.lines.x[1] = std::nextafter(moved.lines.x[1], 0.0);
  softer.law_of_row.back().shear_modulus *= 0.5;
  freed.fixed.front().component[0] = false;
  for (const PositionInput& other : {moved, softer, freed}) {
    EXPECT_NE(position_key(ElasticSkin(other), other.lines), position_key(model_, given.lines));
  }
}

TEST_F(PositionInputTest, is_not_read_from_a_damaged_file) {
  const auto path = folder_.path() / "position";
  EXPECT_FALSE(read_position_input(path));
  write_position_input(path, given_input());
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(1000).put('x');
  file.close();
  EXPECT_FALSE(read_position_input(path));
}

} // namespace
} // namespace ionskin::mechanics
