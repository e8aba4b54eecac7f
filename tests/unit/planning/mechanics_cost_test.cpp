// SPDX-License-Identifier: Apache-2.0
#include "ionskin/planning/mechanics_cost.hpp"

#include "ionskin/case/reading/read_case.hpp"
#include "ionskin/mechanics/path/find_footprint.hpp"
#include "ionskin/mechanics/surface/contact_cells.hpp"
#include "ionskin/mesh/skin_mesh.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace ionskin::planning {
namespace {

MechanicsCost cost(const std::vector<std::string>& edits, int threads = 1) {
  return estimate_mechanics_cost(read_case(IONSKIN_CASES "/paper/coarse.toml", edits), threads, {});
}

TEST(MechanicsCost, CountsTheCellsBelowTheSlider) {
  const Case input = read_case(IONSKIN_CASES "/paper/coarse.toml", {"numerics.error_estimate=off"});
  const MechanicsCost told = estimate_mechanics_cost(input, 1, {});
  const mesh::SkinMesh mesh(input, mesh::expected_footprint(input));
  EXPECT_EQ(told.contact_cells, mechanics::contact_cells(mesh).count());
}

TEST(MechanicsCost, OfErrorsIsThatOfTheCoarserSolutions) {
  const MechanicsCost with = cost({}), without = cost({"numerics.error_estimate=off"});
  EXPECT_GT(with.seconds, 1.2 * without.seconds);
  EXPECT_LT(with.seconds, 2.5 * without.seconds);
  EXPECT_GE(with.memory, without.memory);
  EXPECT_EQ(with.contact_cells, without.contact_cells);
}

TEST(MechanicsCost, OfAnotherFrictionIsThatOfThePathAlone) {
  // One thread takes 4 s for the first coefficient and 2.4 s for each of nine more.
  const MechanicsCost one = cost({});
  EXPECT_GT(one.further_seconds, 0.4 * one.seconds);
  EXPECT_LT(one.further_seconds, 0.8 * one.seconds);
  EXPECT_NEAR(cost({}, 2).further_seconds, one.further_seconds / 2, 1e-9);
}

TEST(MechanicsCost, OfTwoThreadsIsLessAsCoarserSolutionsAreSolvedBeside) {
  const double one = cost({}).seconds, two = cost({}, 2).seconds;
  EXPECT_GE(two, one / 2);
  EXPECT_LT(two, 0.8 * one);
}

TEST(MechanicsCost, HoldsTheModesOfWideSkinsAndOfNearSides) {
  const auto memory = [](const std::vector<std::string>& edits) {
    std::vector<std::string> all{"numerics.preset=coarse", "numerics.error_estimate=off"};
    all.insert(all.end(), edits.begin(), edits.end());
    return estimate_mechanics_cost(read_case(IONSKIN_CASES "/finger.toml", all), 1, {}).memory;
  };
  const double plain = memory({});
  EXPECT_GT(memory({"skin.length=45 mm"}), 1.3 * plain);
  // The sides are far from the slider then, and move in few waves. A run takes as much as before.
  EXPECT_LT(memory({"skin.width=18 mm", "slider.start=[\"4.5 mm\", \"9 mm\"]"}), 1.5 * plain);
  // Electrodes as thick as the core have as many nodes.
  EXPECT_GT(memory({"skin.layers[0].thickness=80 um", "skin.layers[1].thickness=80 um",
                    "skin.layers[2].thickness=80 um"}),
            1.5 * memory({"skin.layers[1].thickness=220 um"}));
  // A run takes 0.51 GB with its centre 0.4 mm from a side (getrusage), and 0.10 GB in the middle.
  EXPECT_GT(memory({"slider.start=[\"4.5 mm\", \"0.4 mm\"]"}), 0.5e9);
  EXPECT_GT(plain, 0.1e9);
}

// A swing that need not come must not fill the memory: a soft spring on a thin skin promised 5.4
// GB, as a swing to both ends asked for waves a quarter as long.
TEST(MechanicsCost, SwingsOfADriveTakeABoundedMemory) {
  const auto memory = [](const char* stiffness) {
    return cost({"skin.length=9 mm", "skin.width=3.3 mm", "skin.layers[1].thickness=80 um",
                 "slider.start=[\"3 mm\", \"1.6 mm\"]", "motion.stroke=2 mm", stiffness,
                 "motion.drive.damping=1 N s/m", "motion.drive.mass=10 g"})
        .memory;
  };
  EXPECT_GT(memory("motion.drive.stiffness=200 N/m"), memory("motion.drive.stiffness=1e7 N/m"));
  EXPECT_LT(memory("motion.drive.stiffness=200 N/m"), 1.2e9);
}

// Matrices would be sixteen times as large.
TEST(MechanicsCost, OfManyEvenCellsIsThatOfProducts) {
  const auto of_sphere = [](const char* refinement) {
    return estimate_mechanics_cost(
        read_case(IONSKIN_CASES "/finger.toml",
                  {refinement, "numerics.preset=coarse", "numerics.error_estimate=off"}),
        1, {});
  };
  const MechanicsCost many = of_sphere("numerics.mesh_refinement=5"),
                      more = of_sphere("numerics.mesh_refinement=10");
  EXPECT_GT(many.contact_cells, 1500U);
  EXPECT_LT(more.memory, 8 * many.memory);
}

TEST(MechanicsCost, CountsStepsAcrossTheSkin) {
  const auto towards = [](const char* direction) {
    return cost({"skin.width=6 mm", "slider.start=[\"4.5 mm\", \"2.8 mm\"]", "motion.stroke=1 mm",
                 std::string("motion.direction=") + direction});
  };
  const MechanicsCost along = towards("[1, 0]"), across = towards("[1, 0.2]");
  EXPECT_EQ(along.contact_cells, across.contact_cells);
  // Study 1 took 7.9 and 11.9 s of a processor when both were measured.
  EXPECT_GT(across.seconds, 1.3 * along.seconds);
  EXPECT_LT(across.seconds, 3 * along.seconds);
}

TEST(MechanicsCost, CountsTheWavesAlongANearEnd) {
  const auto from = [](const char* x) {
    return cost({std::string("slider.start=[\"") + x + " mm\", \"1 mm\"]", "motion.stroke=3 mm",
                 "numerics.error_estimate=off"})
        .seconds;
  };
  const double middle = from("4.5"), end = from("1.6"); // 0.1 mm of skin are left
  // Study 1 takes 2.0 and 6.2 s of a processor.
  EXPECT_GT(end, 2 * middle);
  EXPECT_LT(end, 4.5 * middle);
  EXPECT_GT(from("10.4"), 1.2 * middle); // which comes there at its end alone
  EXPECT_LT(from("10.4"), end);
}

TEST(MechanicsCost, GrowsWithEveryStroke) {
  const auto strokes = [](int count) {
    return cost({"motion.kind=reciprocating", "motion.strokes=" + std::to_string(count)}).steps;
  };
  EXPECT_NEAR(static_cast<double>(strokes(4) - strokes(2)), 2 * 85, 2 * 10);
  EXPECT_EQ(strokes(6) - strokes(4), strokes(4) - strokes(2));
}

TEST(MechanicsCost, HoldsTheStrainOfALongPath) {
  const auto strokes = [](int count) {
    return cost({"motion.kind=reciprocating", "motion.strokes=" + std::to_string(count)});
  };
  EXPECT_NEAR(strokes(1000).histories / strokes(4).histories, 1000 / 4, 30); // and an approach
  EXPECT_GT(strokes(1000).memory, strokes(1000).histories);
  EXPECT_NEAR(strokes(1000).histories, 6.7e9, 0.7e9);
}

TEST(MechanicsCost, CountsStickSlipOfADrive) {
  const std::vector<std::string> drive{
      "motion.preload=1 N",    "motion.drive.stiffness=5 kN/m", "motion.drive.damping=3 N s/m",
      "motion.drive.mass=3 g", "contact.law=stribeck",          "contact.friction=0.4"};
  const auto with_kinetic = [&](const char* friction) {
    std::vector<std::string> edits = drive;
    edits.push_back("contact.stribeck_speed=3 mm/s");
    edits.push_back(std::string("contact.kinetic_friction=") + friction);
    return cost(edits).steps;
  };
  EXPECT_GT(with_kinetic("0.1"), 2 * with_kinetic("0.4")); // which does not fall with the speed
  EXPECT_GT(with_kinetic("0.2"), with_kinetic("0.1"));     // it lets go more often
  EXPECT_EQ(with_kinetic("0.35"), with_kinetic("0.4"));    // damping and spring hold it
}

TEST(MechanicsCost, ExpectsTheContactThatIsFoundUnderAForce) {
  for (const std::vector<std::string>& slider : std::vector<std::vector<std::string>>{
           {"slider.shape=sphere", "slider.radius=4 mm", "motion.preload=0.1 N"},
           {"slider.shape=cylinder", "slider.radius=8 mm", "motion.preload=0.1 N"},
           {"slider.shape=cylinder", "slider.radius=8 mm", "motion.preload=1 N"}}) {
    std::vector<std::string> edits{"numerics.mesh_refinement=0.5", "numerics.error_estimate=off"};
    edits.insert(edits.end(), slider.begin(), slider.end());
    const Case input = read_case(IONSKIN_CASES "/paper/coarse.toml", edits);
    const MechanicsCost expected = estimate_mechanics_cost(input, 1, {});
    const MechanicsCost found =
        estimate_mechanics_cost(input, 1, mechanics::find_footprint(input, 0.3, 1).footprint);
    const double ratio = expected.memory / found.memory;
    EXPECT_GT(ratio, 0.6) << slider.front() << " " << slider.back();
    EXPECT_LT(ratio, 1.6) << slider.front() << " " << slider.back();
  }
}

} // namespace
} // namespace ionskin::planning
