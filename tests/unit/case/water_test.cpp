// SPDX-License-Identifier: Apache-2.0
#include "temporary_case.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ostream>

namespace ionskin {
namespace {

using testing::HasSubstr;

const std::string water = "[water]\ndrag_number = 2.5\ndrained_poissons_ratio = 0.4\n"
                          "mobility = \"2e-19 m2/(Pa s)\"\n";

/// The valid case under the poroelastic law, with these lines instead of [coupling].
std::string wet(const std::string& lines) {
  return valid_case("coefficient = 0.1", "law = \"poroelastic\"\n" + lines);
}

TEST(Water, IsReadWithEveryWayToGiveIt) {
  EXPECT_EQ(error_of(wet(water)), "");
  EXPECT_EQ(error_of(wet("[water]\ndrag_number = 2.5\ndrained_modulus = \"390 MPa\"\n"
                         "permeability = \"1e-19 m2\"\n")),
            "");
  EXPECT_EQ(error_of(wet("[water]\ndrag_number = 2.5\ndrained_modulus = \"390 MPa\"\n"
                         "consolidation_coefficient = \"1e-10 m2/s\"\ndilution = \"pore-water\"\n"
                         "volume_fraction = 0.4\ntop_wall = \"open\"\n")),
            "");
  EXPECT_EQ(error_of(wet(water + "top_wall = \"permeable\"\ntop_conductance = \"1e-14 m/(Pa s)\"\n"
                                 "top_pressure = \"-2 kPa\"\n")),
            "");
}

/// Lines of a case that is refused, what the message says and what it advises.
struct Refusal {
  std::string name, lines, what, remedy;
};

std::ostream& operator<<(std::ostream& stream, const Refusal& refusal) {
  return stream << refusal.name;
}

class WaterRefused : public testing::TestWithParam<Refusal> {};

TEST_P(WaterRefused, SaysWhatAndRemedy) {
  const std::string message = error_of(wet(GetParam().lines));
  EXPECT_THAT(message, HasSubstr(GetParam().what));
  EXPECT_THAT(message, HasSubstr(GetParam().remedy));
}

INSTANTIATE_TEST_SUITE_P(
    Keys, WaterRefused,
    testing::Values(
        Refusal{"ACoefficient", "coefficient = 0.1\n" + water, "coupling.coefficient is given",
                "remove the key"},
        Refusal{"AMeasure", "measure = \"deviatoric\"\n" + water, "coupling.measure is given",
                "remove the key"},
        Refusal{"NoWater", "", "missing section [water]", "drag_number"},
        Refusal{"NoDrainedStiffness",
                "[water]\ndrag_number = 2.5\nmobility = \"1e-19 m2/(Pa s)\"\n",
                "how stiff the core is once its water has moved is not given",
                "water.drained_poissons_ratio"},
        Refusal{"TwoDrainedStiffnesses", water + "drained_modulus = \"390 MPa\"\n",
                "are both given", "give one of them"},
        Refusal{"StifferWithoutWater",
                "[water]\ndrag_number = 2.5\ndrained_poissons_ratio = 0.495\n"
                "mobility = \"1e-19 m2/(Pa s)\"\n",
                "is not below 0.49", "choose a smaller ratio"},
        Refusal{"ModulusOutsideItsBounds",
                "[water]\ndrag_number = 2.5\ndrained_modulus = \"90 MPa\"\n"
                "mobility = \"1e-19 m2/(Pa s)\"\n",
                "water.drained_modulus = 90 MPa cannot belong to the core", "it must be above"},
        Refusal{"NoMobility", "[water]\ndrag_number = 2.5\ndrained_poissons_ratio = 0.4\n",
                "how fast water moves through the core is not given", "water.permeability"},
        Refusal{"MobilitiesThatDisagree", water + "consolidation_coefficient = \"1e-9 m2/s\"\n",
                "the keys of the water's mobility disagree", "give one of them"},
        Refusal{"PoreWaterWithoutItsShare", water + "dilution = \"pore-water\"\n",
                "without water.volume_fraction", "0.38"},
        Refusal{"MoreDragThanWater",
                "[water]\ndrag_number = 30\ndrained_poissons_ratio = 0.4\n"
                "mobility = \"1e-19 m2/(Pa s)\"\nvolume_fraction = 0.1\n",
                "molecules of water for each cation", "it must be at most"},
        Refusal{"APermeableWallWithoutConductance", water + "top_wall = \"permeable\"\n",
                "water.top_wall = \"permeable\" without water.top_conductance",
                "give water.top_conductance"},
        Refusal{"AConductanceOfAnOpenWall",
                water + "top_wall = \"open\"\ntop_conductance = \"1e-14 m/(Pa s)\"\n",
                "water.top_conductance is given", "set water.top_wall = \"permeable\""},
        Refusal{"WaterOutsideASealedWall", water + "bottom_pressure = \"1 kPa\"\n",
                "water.bottom_pressure is given, but water.bottom_wall is \"sealed\"",
                "set water.bottom_wall = \"open\""},
        Refusal{"AWallThatIsNoWall", water + "top_wall = \"ajar\"\n", "water.top_wall = \"ajar\"",
                "sealed"}),
    [](const auto& refusal) { return refusal.param.name; });

TEST(Water, NamesAllThatIsMissingAtOnce) {
  const std::string bare =
      error_of(valid_case("coefficient = 0.1", "law = \"poroelastic\"\ncoefficient = 0.1"));
  for (const char* words :
       {"missing section [water]", "drag_number", "drained_poissons_ratio or drained_modulus",
        "permeability or mobility or consolidation_coefficient", "coupling.coefficient is given"})
    EXPECT_THAT(bare, HasSubstr(words));
  const std::string begun = error_of(wet("[water]\ndilution = \"mixture\"\n"));
  for (const char* words : {"missing key water.drag_number", "how stiff the core is", "how fast"})
    EXPECT_THAT(begun, HasSubstr(words));
}

TEST(Water, IsRefusedBesideALawThatMovesNone) {
  const std::string message =
      error_of(valid_case("coefficient = 0.1", "coefficient = 0.1\n" + water));
  EXPECT_THAT(message, HasSubstr("water.drag_number is given, but coupling.law"));
  EXPECT_THAT(message, HasSubstr("set coupling.law = \"poroelastic\""));
}

} // namespace
} // namespace ionskin
