// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/error.hpp"
#include "ionskin/case/reading/read_case.hpp"
#include "temporary_case.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace ionskin {
namespace {

using testing::HasSubstr;
using testing::Not;

/// The valid case with a core of a gel whose numbers follow the humidity.
std::string case_of_gel(const std::string& humidity, const std::string& gel) {
  std::string text = valid_case("\"nafion\"", "\"gel\"");
  text.insert(text.find("\n[[skin.layers]]"), humidity);
  return text + "[materials.gel]\n" + gel;
}

const char* const gel = "humidity = [0.2, 0.5, 0.9]\n"
                        "youngs_modulus = [\"4 MPa\", \"3 MPa\", \"1 MPa\"]\n"
                        "poissons_ratio = 0.4\n";

double modulus_at(const std::string& humidity) {
  const TemporaryCase file(case_of_gel("humidity = " + humidity + "\n", gel));
  return read_case(file.path()).skin.layers[1].material.youngs_modulus;
}

TEST(OverHumidity, IsLinearBetweenTheEntriesAndTheirsAtThem) {
  EXPECT_DOUBLE_EQ(modulus_at("0.2"), 4e6);
  EXPECT_DOUBLE_EQ(modulus_at("0.5"), 3e6);
  EXPECT_DOUBLE_EQ(modulus_at("0.8"), 1.5e6);
  EXPECT_DOUBLE_EQ(modulus_at("0.9"), 1e6);
}

TEST(OverHumidity, TheRecordHoldsTheChosenNumber) {
  const TemporaryCase file(case_of_gel("humidity = 0.8\n", gel));
  const CaseDocument document = read_case_document(file.path());
  EXPECT_EQ(document.find("materials.gel.youngs_modulus")->si, "1500000 Pa");
  EXPECT_DOUBLE_EQ(document.number("materials.gel.youngs_modulus")->value, 1.5e6);
  EXPECT_DOUBLE_EQ(document.number("skin.humidity")->value, 0.8);
}

TEST(OverHumidity, IonsFollowIt) {
  std::string text = valid_case("\"nafion\"", "\"nafion_air\"");
  text.insert(text.find("\n[[skin.layers]]"), "humidity = 0.95\n");
  for (const std::string line :
       {"diffusivity = \"7e-11 m2/s\"\n", "fixed_charge_concentration = \"1200 mol/m3\"\n"})
    text.erase(text.find(line), line.size());
  const TemporaryCase file(text);
  const Case input = read_case(file.path());
  EXPECT_DOUBLE_EQ(input.electrochemistry.fixed_charge_concentration, (1357 + 1237) / 2.0);
  EXPECT_DOUBLE_EQ(input.electrochemistry.diffusivity, (8.86e-10 + 1.38e-9) / 2);
  EXPECT_DOUBLE_EQ(input.skin.layers[1].material.youngs_modulus, (201e6 + 172e6) / 2);
}

TEST(OverHumidity, RefusesWhatIsBeyondItsRange) {
  for (const std::string humidity : {"0.1999", "0.95"})
    EXPECT_THAT(error_of(case_of_gel("humidity = " + humidity + "\n", gel)),
                testing::AllOf(HasSubstr("skin.humidity = " + humidity +
                                         " is beyond the range of the material \"gel\""),
                               HasSubstr("case.toml:6:12"), HasSubstr("from 0.2 to 0.9")));
  for (const std::string humidity : {"0", "-0.5", "1.5", "\"50 %\""})
    EXPECT_THAT(error_of(case_of_gel("humidity = " + humidity + "\n", gel)),
                testing::AllOf(HasSubstr("skin.humidity = "), Not(HasSubstr("missing key"))));
}

TEST(OverHumidity, AsksForTheHumidity) {
  EXPECT_THAT(error_of(case_of_gel("", gel)),
              testing::AllOf(HasSubstr("missing key skin.humidity: the material \"gel\""),
                             HasSubstr("from 0.2 to 0.9")));
  EXPECT_THAT(error_of(valid_case("\"nafion\"", "\"nafion_air\"")),
              testing::AllOf(HasSubstr("missing key skin.humidity"), HasSubstr("from 0.5 to 1")));
}

TEST(OverHumidity, RefusesAHumidityThatNothingFollows) {
  EXPECT_THAT(error_of(valid_case("width = \"2 mm\"", "width = \"2 mm\"\nhumidity = 0.5")),
              HasSubstr("skin.humidity is given, but no material of the skin follows it"));
}

TEST(OverHumidity, ASingleValueOfTheCaseComesBeforeAListOfThePreset) {
  std::string text = valid_case("\"nafion\"", "\"nafion_air\"");
  text += "[materials.nafion_air]\nyoungs_modulus = \"50 MPa\"\n";
  text.insert(text.find("\n[[skin.layers]]"), "humidity = 0.6\n");
  const TemporaryCase file(text);
  EXPECT_DOUBLE_EQ(read_case(file.path()).skin.layers[1].material.youngs_modulus, 50e6);
}

struct BadList {
  std::string gel, message;
};

TEST(OverHumidity, RefusesListsThatDoNotFit) {
  const std::string ratio = "poissons_ratio = 0.4\n";
  const std::string two = "youngs_modulus = [\"2 MPa\", \"1 MPa\"]\n" + ratio;
  for (const BadList& bad : std::vector<BadList>{
           {two, "materials.gel.youngs_modulus is a list, but materials.gel.humidity is not given"},
           {"humidity = [0.2, 0.5, 0.9]\n" + two,
            "materials.gel.youngs_modulus has 2 entries, and materials.gel.humidity has 3"},
           {"humidity = [0.5, 0.2]\n" + two, "materials.gel.humidity does not ascend"},
           {"humidity = [0.5, 0.5]\n" + two, "materials.gel.humidity does not ascend"},
           {"humidity = [0.2, 1.2]\n" + two, "materials.gel.humidity = 1.2 is out of range"},
           {"humidity = 0.5\n" + two, "materials.gel.humidity = 0.5 is not a list"},
           {"humidity = [0.2, 0.8]\nyoungs_modulus = [\"2 MPa\", 1]\n" + ratio,
            "materials.gel.youngs_modulus has no unit: 1 is a bare number"},
           {"humidity = [0.2, 0.8]\nyoungs_modulus = [\"2 MPa\"]\n" + ratio,
            "is a list of fewer than two entries"},
           {"humidity = [0.2, 0.8]\nyoungs_modulus = \"2 MPa\"\npoissons_ratio = [0.4, 0.6]\n",
            "materials.gel.poissons_ratio = 0.6 is out of range"}}) {
    EXPECT_THAT(error_of(case_of_gel("humidity = 0.5\n", bad.gel)), HasSubstr(bad.message));
  }
}

} // namespace
} // namespace ionskin
