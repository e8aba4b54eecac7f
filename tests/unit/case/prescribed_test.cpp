// SPDX-License-Identifier: Apache-2.0
#include "temporary_case.hpp"

#include "ionskin/case/reading/read_case.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <ostream>

namespace ionskin {
namespace {

using testing::HasSubstr;

/// The valid case under the poroelastic law with these lines in its section [strain].
std::string prescribed(const std::string& lines) {
  return valid_case("coefficient = 0.1", "law = \"poroelastic\"\n[water]\ndrag_number = 2.5\n"
                                         "drained_poissons_ratio = 0.4\n"
                                         "mobility = \"2e-19 m2/(Pa s)\"\n"
                                         "[strain]\nsource = \"prescribed\"\n" +
                                             lines);
}

TEST(Prescribed, NeedsNeitherSliderNorMotion) {
  std::string text = prescribed("curvature = \"20 1/m\"\nduration = \"3 s\"\n");
  const std::size_t slider = text.find("[slider]");
  text.erase(slider, text.find("[electrochemistry]") - slider);
  const TemporaryCase file(text);
  const Case input = read_case(file.path());
  EXPECT_EQ(input.strain.kind, StrainSourceKind::prescribed);
  EXPECT_EQ(input.strain.curvature, 20);
  EXPECT_EQ(input.strain.waveform, LoadWaveform::step);
}

struct LoadRefusal {
  std::string name, lines, what, remedy;
};

std::ostream& operator<<(std::ostream& stream, const LoadRefusal& refusal) {
  return stream << refusal.name;
}

class PrescribedRefused : public testing::TestWithParam<LoadRefusal> {};

TEST_P(PrescribedRefused, SaysWhatAndRemedy) {
  const std::string message = error_of(prescribed(GetParam().lines));
  EXPECT_THAT(message, HasSubstr(GetParam().what));
  EXPECT_THAT(message, HasSubstr(GetParam().remedy));
}

INSTANTIATE_TEST_SUITE_P(
    Keys, PrescribedRefused,
    testing::Values(
        LoadRefusal{"NoLoad", "duration = \"3 s\"\n", "no load is prescribed", "strain.curvature"},
        LoadRefusal{"TwoLoads", "duration = \"3 s\"\npressure = \"1 kPa\"\ncurvature = \"1 1/m\"\n",
                    "more than one load is prescribed", "give one of"},
        LoadRefusal{"NoDuration", "pressure = \"1 kPa\"\n", "missing key strain.duration",
                    "a time"},
        LoadRefusal{"BentTooFar", "duration = \"3 s\"\ncurvature = \"9000 1/m\"\n",
                    "to a radius of 0.111111 mm", "it must be at most"},
        LoadRefusal{"RampWithoutRise",
                    "duration = \"3 s\"\npressure = \"1 kPa\"\nwaveform = \"ramp\"\n",
                    "without strain.rise", "give strain.rise"},
        LoadRefusal{
            "RiseLongerThanTheRun",
            "duration = \"3 s\"\npressure = \"1 kPa\"\nwaveform = \"ramp\"\nrise = \"4 s\"\n",
            "is longer than the run of 3 s", "at most 3 s"},
        LoadRefusal{"FrequencyOfAStep",
                    "duration = \"3 s\"\npressure = \"1 kPa\"\nfrequency = \"4 Hz\"\n",
                    "strain.waveform is not \"sine\"", "remove the key"},
        LoadRefusal{"TooManyPeriods",
                    "duration = \"3 s\"\npressure = \"1 kPa\"\nwaveform = \"sine\"\n"
                    "frequency = \"1 kHz\"\n",
                    "swings 3000 times", "at most 1 s here"},
        LoadRefusal{"AForceAsPressure", "duration = \"3 s\"\npressure = \"1 N\"\n",
                    "strain.pressure", "stress"}),
    [](const auto& refusal) { return refusal.param.name; });

TEST(Prescribed, IsRefusedUnderALawThatReadsShear) {
  const std::string message =
      error_of(valid_case("[coupling]", "[strain]\nsource = \"prescribed\"\npressure = \"1 kPa\"\n"
                                        "duration = \"1 s\"\n[coupling]"));
  EXPECT_THAT(message, HasSubstr("it is driven by shear"));
  EXPECT_THAT(message, HasSubstr("set coupling.law = \"poroelastic\""));
}

TEST(Prescribed, KeysAreRefusedBesideAnotherSource) {
  EXPECT_THAT(error_of(valid_case("[coupling]", "[strain]\npressure = \"1 kPa\"\n[coupling]")),
              HasSubstr("strain.pressure is given, but strain.source is not \"prescribed\""));
}

} // namespace
} // namespace ionskin
