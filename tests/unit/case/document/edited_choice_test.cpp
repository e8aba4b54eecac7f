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

using Edits = std::vector<std::string>;

const Edits path_edits{
    "motion.kind=waypoints",
    R"(motion.waypoints=[{time="0 s", position=["4 mm", "1 mm"], height="1 mm"}, {time="1 s", position=["5 mm", "1 mm"], force="1 N"}])"};

std::string message_of(const std::string& text, const Edits& edits) {
  const TemporaryCase file(text);
  try {
    read_case(file.path(), edits);
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

/// The case that a run writes down is read again as the same case, by itself.
Case read_twice(const std::string& text, const Edits& edits) {
  const TemporaryCase file(text);
  Case input = read_case(file.path(), edits);
  const TemporaryCase written(input.text);
  const Case again = read_case(written.path());
  EXPECT_EQ(again.values, input.values);
  EXPECT_TRUE(again.notes.empty());
  return input;
}

TEST(EditedChoice, LeavesOutTheKeysOfTheMotionBefore) {
  const Case input = read_twice(valid_case(), path_edits);
  EXPECT_EQ(input.motion.waypoints.size(), 2u);
  ASSERT_EQ(input.notes.size(), 1u);
  EXPECT_THAT(
      input.notes.front(),
      HasSubstr("Without a meaning with motion.kind = \"waypoints\", and left out of the case: "
                "slider.start, motion.gap, motion.preload"));
  EXPECT_THAT(input.text, HasSubstr("\n# start = ["));
}

TEST(EditedChoice, LeavesOutAPathInSections) {
  const std::string path = R"([motion]
kind = "waypoints"
[[motion.waypoints]]
time = "0 s"
position = ["4 mm",
  "1 mm"] # a value of two lines
height = "1 mm"
[[motion.waypoints]] # the second
time = "1 s"
position = ["5 mm", "1 mm"]
force = "1 N"
)";
  std::string text = valid_case("start = [\"4.5 mm\", \"1 mm\"]\n", "");
  const std::size_t begin = text.find("[motion]"), end = text.find("[contact]");
  text.replace(begin, end - begin, path + "\n");
  const Case input =
      read_twice(text, {"motion.kind=reciprocating", "motion.gap=1 mm", "motion.preload=1 N",
                        "motion.stroke=1 mm", "motion.touchdown=1 s", "motion.slide=1 s",
                        "motion.lift=1 s", "motion.return=1 s", "slider.start=[4 mm, 1 mm]"});
  EXPECT_TRUE(input.motion.waypoints.empty());
  ASSERT_EQ(input.notes.size(), 1u);
  EXPECT_THAT(input.notes.front(), HasSubstr("left out of the case: motion.waypoints."));
}

TEST(EditedChoice, LeavesOutKeysOfInlineTables) {
  for (
      const std::string contact :
      {R"({law = "stribeck", friction = 0.3, kinetic_friction = 0.2, stribeck_speed = "1 mm/s"})",
       R"({kinetic_friction = 0.2, stribeck_speed = "1 mm/s", law = "stribeck", friction = 0.3})"}) {
    std::string text = valid_case();
    const std::size_t begin = text.find("[contact]");
    text.erase(begin, text.find("\n[", begin) + 1 - begin);
    const Case input = read_twice("contact = " + contact + "\n" + text, {"contact.law=coulomb"});
    EXPECT_EQ(input.contact.friction, 0.3);
    EXPECT_THAT(input.text, Not(HasSubstr("stribeck")));
  }
}

struct OtherChoice {
  std::string replace, with; ///< text that the file has
  Edits edits;
  std::string left_out;
};

class LeftOut : public testing::TestWithParam<OtherChoice> {};

TEST_P(LeftOut, IsWhatGoesWithTheChoiceBefore) {
  const OtherChoice& row = GetParam();
  const Case input = read_twice(valid_case(row.replace, row.with), row.edits);
  ASSERT_FALSE(input.notes.empty());
  EXPECT_THAT(input.notes.front(), HasSubstr("left out of the case: " + row.left_out + "."));
}

const std::string wet_lines = R"text([coupling]
law = "poroelastic"
[water]
drag_number = 2
drained_poissons_ratio = 0.4
mobility = "1e-18 m2/(Pa s)")text";

INSTANTIATE_TEST_SUITE_P(
    EditedChoice, LeftOut,
    testing::Values(
        OtherChoice{"friction = 0.3",
                    "friction = 0.3\nlaw = \"viscous\"\nreference_speed = \"1 mm/s\"",
                    {"contact.law=coulomb"},
                    "contact.reference_speed"},
        OtherChoice{"size = [",
                    "shape = \"cylinder\"\nradius = \"4 mm\"\nsize = [",
                    {"slider.shape=flat"},
                    "slider.radius"},
        OtherChoice{"size = [",
                    "edge_radius = \"0.1 mm\"\nsize = [",
                    {"slider.shape=sphere", "slider.radius=4 mm"},
                    "slider.edge_radius"},
        OtherChoice{"[coupling]\ncoefficient = 0.1",
                    wet_lines,
                    {"coupling.law=column-neutral", "coupling.coefficient=0.1"},
                    "water.drag_number, water.drained_poissons_ratio, water.mobility"},
        OtherChoice{"[coupling]\ncoefficient = 0.1",
                    "[coupling]\ncoefficient = 0.1\nmeasure = \"deviatoric\"",
                    {"coupling.law=poroelastic", "water.drag_number=2",
                     "water.drained_poissons_ratio=0.4", "water.mobility=1e-18 m2/(Pa s)"},
                    "coupling.coefficient, coupling.measure"},
        OtherChoice{
            "[electrochemistry]",
            "[electrochemistry]\nion_model = \"steric\"\nlargest_concentration = \"9 mol/l\"",
            {"electrochemistry.ion_model=dilute"},
            "electrochemistry.largest_concentration"}));

TEST(EditedChoice, KeepsWhatEditsSetThemselvesForTheChecks) {
  Edits edits = path_edits;
  edits.emplace_back("motion.stroke=2 mm");
  EXPECT_THAT(message_of(valid_case(), edits), HasSubstr("motion.stroke has no effect"));
}

TEST(EditedChoice, KeepsWhatHadNoEffectBefore) {
  EXPECT_THAT(
      message_of(valid_case("friction = 0.3", "friction = 0.3\nreference_speed = \"1 mm/s\""),
                 {"contact.law=coulomb"}),
      HasSubstr("contact.reference_speed is given, but the law \"coulomb\" has no such"));
}

TEST(EditedChoice, IsOneProblemWithAllThatItNeeds) {
  const std::string message = message_of(valid_case(), {"contact.law=stribeck"});
  EXPECT_THAT(message, HasSubstr("contact.law = \"stribeck\" needs keys that"));
  EXPECT_THAT(message, HasSubstr("= set them, too, by --set KEY=VALUE: contact.kinetic_friction, a "
                                 "number; contact.stribeck_speed, a speed such as"));
  EXPECT_THAT(message, Not(HasSubstr("problems")));
  const std::string path = message_of(valid_case(), {"motion.kind=waypoints"});
  EXPECT_THAT(path, HasSubstr("a path needs at least two waypoints"));
  EXPECT_THAT(path, Not(HasSubstr("problems")));
}

TEST(EditedChoice, IsNoneWithoutATextThatItCouldChange) {
  const std::string quoted = "\"motion.stroke\" = \"1 mm\"\n" + valid_case();
  EXPECT_THAT(message_of(quoted, path_edits), HasSubstr("motion.stroke has no effect"));
}

} // namespace
} // namespace ionskin
