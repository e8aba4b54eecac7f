// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/reading/read_case.hpp"
#include "temporary_case.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ostream>
#include <string>

namespace ionskin {
namespace {

using testing::HasSubstr;

const std::string series = "relaxation_times = [\"1 s\", \"2 min\"]\n"
                           "relaxation_shares = [0.3, 0.2]\n";
const std::string bend = "[strain]\nsource = \"prescribed\"\nduration = \"3 s\"\n"
                         "curvature = \"20 1/m\"\n";

/// The valid case under the poroelastic law, with a load and lines on a material.
std::string relaxing(const std::string& load, const std::string& lines,
                     const std::string& material = "nafion", const std::string& water = "") {
  return valid_case("coefficient = 0.1", "law = \"poroelastic\"\n[water]\ndrag_number = 2.5\n"
                                         "drained_poissons_ratio = 0.4\n"
                                         "mobility = \"2e-19 m2/(Pa s)\"\n" +
                                             water + load) +
         "[materials." + material + "]\n" + lines;
}

TEST(RelaxingCase, IsRead) {
  const TemporaryCase file(relaxing(bend, series));
  const Material core = read_case(file.path()).skin.layers[1].material;
  EXPECT_EQ(core.relaxation_times, (std::vector{1.0, 120.0}));
  EXPECT_EQ(core.relaxation_shares, (std::vector{0.3, 0.2}));
}

struct RelaxationRefusal {
  std::string name, text, what, remedy;
};

std::ostream& operator<<(std::ostream& stream, const RelaxationRefusal& refusal) {
  return stream << refusal.name;
}

class RelaxationRefused : public testing::TestWithParam<RelaxationRefusal> {};

TEST_P(RelaxationRefused, SaysWhatAndRemedy) {
  const std::string message = error_of(GetParam().text);
  EXPECT_THAT(message, HasSubstr(GetParam().what));
  EXPECT_THAT(message, HasSubstr(GetParam().remedy));
}

std::string times_and_shares(const std::string& times, const std::string& shares) {
  return relaxing(bend, "relaxation_times = " + times + "\nrelaxation_shares = " + shares + "\n");
}

INSTANTIATE_TEST_SUITE_P(
    Keys, RelaxationRefused,
    testing::Values(
        RelaxationRefusal{"OnlyTimes", relaxing(bend, "relaxation_times = [\"1 s\"]\n"),
                          "relaxation_times without materials.nafion.relaxation_shares",
                          "give both"},
        RelaxationRefusal{"OnlyShares", relaxing(bend, "relaxation_shares = [0.1]\n"),
                          "relaxation_shares without materials.nafion.relaxation_times",
                          "give both"},
        RelaxationRefusal{"UnequalLists", times_and_shares("[\"1 s\"]", "[0.1, 0.1]"),
                          "has 1 entries, and materials.nafion.relaxation_shares has 2",
                          "give as many"},
        RelaxationRefusal{"NoEntries", times_and_shares("[]", "[]"), "has 0 entries",
                          "from 1 to 20"},
        RelaxationRefusal{"EqualTimes", times_and_shares("[\"1 s\", \"1000 ms\"]", "[0.1, 0.1]"),
                          "relaxation_times does not ascend", "ascending times"},
        RelaxationRefusal{"NothingLeft", times_and_shares("[\"1 s\", \"2 s\"]", "[0.6, 0.4]"),
                          "relaxation_shares add up to 1", "below 1"},
        RelaxationRefusal{"ShareOfNothing", times_and_shares("[\"1 s\"]", "[0]"),
                          "relaxation_shares = 0 is out of range", "above 0"},
        RelaxationRefusal{"TimeWithoutUnit", times_and_shares("[1]", "[0.1]"),
                          "relaxation_times has no unit", "1 s"},
        RelaxationRefusal{"AnElectrode", relaxing(bend, series, "platinum"),
                          "it is that of an electrode", "remove materials.platinum"},
        RelaxationRefusal{"AContact", relaxing("", series), "the strain is not prescribed",
                          "strain.source = \"prescribed\""},
        RelaxationRefusal{"AHeldCompression",
                          relaxing("[strain]\nsource = \"prescribed\"\nduration = \"3 s\"\n"
                                   "compression = \"1 um\"\n",
                                   series),
                          "its compression is held", "strain.pressure"},
        RelaxationRefusal{
            "WaterOutside",
            relaxing(bend, series, "nafion", "top_wall = \"open\"\ntop_pressure = \"1 kPa\"\n"),
            "water outside is under pressure", "water.top_pressure"}),
    [](const auto& test) { return test.param.name; });

} // namespace
} // namespace ionskin
