// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/error.hpp"
#include "ionskin/case/reading/read_case.hpp"
#include "temporary_case.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace ionskin {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string pinch = IONSKIN_CASES "/pinch.toml";

Case read(const std::vector<std::string>& edits) {
  return read_case(pinch, edits);
}

std::string message(const std::vector<std::string>& edits) {
  try {
    read(edits);
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

std::string text_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

TEST(SliderList, TakesSharedKeysWhereAnEntryHasNone) {
  const Case input = read({});
  ASSERT_EQ(input.further_sliders.size(), 1u);
  const FurtherSlider& thumb = input.further_sliders.front();
  EXPECT_EQ(input.slider.start[0], 5e-3);
  EXPECT_EQ(thumb.slider.start[0], 10e-3);
  EXPECT_EQ(input.motion.preload_force, 1);
  EXPECT_EQ(thumb.motion.preload_force, 1.5);
  EXPECT_EQ(input.motion.stroke, thumb.motion.stroke);
  EXPECT_EQ(input.motion.direction[0], -thumb.motion.direction[0]);
  EXPECT_EQ(thumb.contact.friction, 0.3);
  const std::vector<Case> alone = cases_of_sliders(input);
  ASSERT_EQ(alone.size(), 2u);
  EXPECT_TRUE(alone[1].further_sliders.empty());
  EXPECT_EQ(alone[1].slider.start, thumb.slider.start);
}

TEST(SliderList, NamesKeysByTheirEntry) {
  const CaseDocument document = read_case_document(pinch, {});
  EXPECT_NE(document.find("slider[1].radius"), nullptr);
  EXPECT_NE(document.find("slider[1].motion.preload"), nullptr);
  EXPECT_EQ(document.find("slider[1].motion.stroke"), nullptr) << "which both share";
  EXPECT_NE(document.find("motion.stroke"), nullptr);
  EXPECT_EQ(document.find("slider.radius"), nullptr);
  ASSERT_TRUE(document.number("slider[1].start[0]"));
  EXPECT_EQ(document.number("slider[1].start[0]")->value, 10e-3);
}

TEST(SliderList, IsEditedByEntryAndForAll) {
  EXPECT_DOUBLE_EQ(
      read({"slider[1].radius=9 mm"}).further_sliders[0].slider.parameters.at("radius"), 9e-3);
  const Case rough = read({"slider[1].contact.friction=0.5"});
  EXPECT_EQ(rough.contact.friction, 0.3);
  EXPECT_EQ(rough.further_sliders[0].contact.friction, 0.5);
  const Case both = read({"contact.friction=0.4"});
  EXPECT_EQ(both.contact.friction, 0.4);
  EXPECT_EQ(both.further_sliders[0].contact.friction, 0.4);
}

TEST(SliderList, IsReadAgainAsARunWritesItDown) {
  const Case input = read({"slider[1].radius=9 mm"});
  const TemporaryCase written(input.text);
  EXPECT_EQ(read_case(written.path()).values, input.values);
}

TEST(SliderList, TakesOnePathOfItsOwnBesideStrokes) {
  std::string text = text_of(pinch);
  const std::size_t thumb = text.rfind("[[slider]]"), end = text.find("[motion]\n");
  ASSERT_LT(thumb, end);
  text.replace(thumb, end - thumb,
               "[[slider]]\nshape = \"sphere\"\nradius = \"8 mm\"\nmotion.kind = \"waypoints\"\n"
               "[[slider.motion.waypoints]]\ntime = \"0 s\"\nposition = [\"10 mm\", \"3 mm\"]\n"
               "height = \"1 mm\"\n[[slider.motion.waypoints]]\ntime = \"2.7 s\"\n"
               "position = [\"10 mm\", \"3 mm\"]\nforce = \"1 N\"\n\n");
  const TemporaryCase file(text);
  const Case input = read_case(file.path());
  EXPECT_EQ(input.motion.kind, MotionKind::touch_slide_lift);
  ASSERT_EQ(input.further_sliders[0].motion.waypoints.size(), 2u);
  EXPECT_DOUBLE_EQ(input.further_sliders[0].slider.start[0], 10e-3);
}

TEST(SliderList, OfOneIsAsTheOnlySlider) {
  std::string list = valid_case(), single = list;
  const std::size_t header = list.find("[slider]");
  ASSERT_NE(header, std::string::npos);
  list.replace(header, 8, "[[slider]]");
  const TemporaryCase one(list), other(single);
  const Case input = read_case(one.path()), expected = read_case(other.path());
  EXPECT_TRUE(input.further_sliders.empty());
  EXPECT_EQ(input.slider.size, expected.slider.size);
  EXPECT_EQ(input.motion.stroke, expected.motion.stroke);
}

TEST(SliderList, NamesTheKeyThatIsWrong) {
  EXPECT_THAT(message({"slider[1].radius=-1 mm"}), StartsWith("slider[1].radius = "));
  EXPECT_THAT(message({"slider[1].radios=1 mm"}), HasSubstr("unknown key slider[1].radios"));
  EXPECT_THAT(message({"slider[1].radios=1 mm"}), HasSubstr("did you mean slider[1].radius?"));
  EXPECT_THAT(message({"slider[1].contact.frictoin=0.1"}),
              HasSubstr("did you mean slider[1].contact.friction?"));
  EXPECT_THAT(message({"slider[1].motion.stroke=1 s"}), StartsWith("slider[1].motion.stroke: "));
  EXPECT_THAT(message({"skin.layers[1].thickness=-1 um"}), StartsWith("skin.layers[1].thickness"));
  EXPECT_THAT(message({"slider.radius=1 mm"}), HasSubstr("slider[0].radius"));
  EXPECT_THAT(message({"slider[2].radius=1 mm"}), HasSubstr("slider has no entry 2"));
}

TEST(SliderList, RefusesWhatDoesNotGoTogether) {
  EXPECT_THAT(message({"slider[1].motion.slide=2 s"}),
              HasSubstr("the cycle of slider[1] lasts 3.7 s, that of slider[0] 2.7 s"));
  EXPECT_THAT(message({"slider[1].motion.cycles=2"}), HasSubstr("slider[1] goes through 2 cycles"));
  EXPECT_THAT(message({"slider[0].motion.drive.stiffness=10 N/m"}),
              HasSubstr("slider[0] hangs on a drive"));
  EXPECT_THAT(
      message({"slider[1].contact.law=adhesive", "slider[1].contact.work_of_adhesion=0.1 J/m2",
               "slider[1].contact.cohesive_strength=1 MPa"}),
      HasSubstr("slider[1] adheres"));
}

TEST(SliderList, RefusesTooManyAndNone) {
  std::string text = text_of(pinch);
  const std::size_t at = text.find("[motion]\n");
  ASSERT_NE(at, std::string::npos);
  for (int i = 0; i < 3; ++i) {
    text.insert(at, "[[slider]]\nshape = \"sphere\"\nradius = \"1 mm\"\nstart = [\"1 mm\", "
                    "\"3 mm\"]\n\n");
  }
  EXPECT_THAT(error_of(text), HasSubstr("a list of 5 sliders"));
  EXPECT_THAT(error_of("slider = []\n"), HasSubstr("a list of 0 sliders"));
  EXPECT_THAT(error_of("slider = [1, 2]\n"), HasSubstr("slider must be a table"));
}

} // namespace
} // namespace ionskin
