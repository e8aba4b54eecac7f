// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/error.hpp"
#include "ionskin/case/reading/read_case.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "temporary_case.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

namespace ionskin {
namespace {

using testing::HasSubstr;

/// The valid case with another section on the motion.
std::string with_motion(const std::string& motion) {
  std::string text = valid_case("start = [\"4.5 mm\", \"1 mm\"]\n", "");
  const std::size_t begin = text.find("[motion]"), end = text.find("[contact]");
  return text.replace(begin, end - begin, motion + "\n");
}

const std::string path = R"([motion]
kind = "waypoints"
[[motion.waypoints]]
time = "0 s"
position = ["4 mm", "1 mm"]
height = "1 mm"
[[motion.waypoints]]
time = "0.5 s"
position = ["4 mm", "1 mm"]
force = "1 N"
[[motion.waypoints]]
time = "2 s"
position = ["6 mm", "1 mm"]
force = "2 N"
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

TEST(Waypoints, AreReadFromTheCase) {
  const TemporaryCase file(with_motion(path));
  const Case input = read_case(file.path());
  ASSERT_EQ(input.motion.waypoints.size(), 3u);
  EXPECT_EQ(input.motion.waypoints[0].height, 1e-3);
  EXPECT_EQ(input.motion.waypoints[1].force, 1);
  EXPECT_DOUBLE_EQ(input.motion.waypoints[2].position[0], 6e-3);
  EXPECT_DOUBLE_EQ(input.slider.start[0], 4e-3);
  EXPECT_EQ(input.motion.cycle_duration(), 2);
}

TEST(Waypoints, MayTurnAForceIntoAHeightOnTheWay) {
  const TemporaryCase file(with_motion(replaced(path, "force = \"2 N\"", "height = \"-1 um\"")));
  const Case input = read_case(file.path());
  EXPECT_EQ(input.motion.waypoints[2].height, -1e-6);
}

TEST(Waypoints, TooManyAreToBeLeftOut) {
  const TemporaryCase file(with_motion("[motion]\nkind = \"waypoints\"\nfile = \"long.csv\"\n"));
  std::ofstream rows(std::filesystem::path(file.path()).parent_path() / "long.csv");
  rows << "time [ms],x [mm],y [mm],height [um]\n0,4,1,10\n";
  for (int row = 1; row <= 200'001; ++row)
    rows << row << ",4,1,-0.1\n";
  rows.close();
  try {
    read_case(file.path());
    FAIL() << "accepted";
  } catch (const UserError& error) {
    EXPECT_THAT(error.what(), HasSubstr("legs of motion"));
    EXPECT_THAT(error.what(), HasSubstr("leave out waypoints"));
  }
}

struct WrongPath {
  std::string from, to, message;
};

TEST(Waypoints, MistakesAreSaid) {
  const WrongPath mistakes[] = {
      {"height = \"1 mm\"", "height = \"-1 um\"", "touches the skin from the start"},
      {"height = \"1 mm\"", "", "waypoint 1 has neither height nor force"},
      {"force = \"2 N\"", "force = \"2 N\"\nheight = \"0 mm\"", "both a height and a force"},
      {"time = \"2 s\"", "time = \"0.4 s\"", "does not come after waypoint 2"},
      {"time = \"0 s\"", "time = \"0.1 s\"", "the first waypoint must be at 0 s"},
      {"time = \"0 s\"\n", "", "missing key motion.waypoints[0].time"},
      {"[\"6 mm\"", "[\"14 mm\"", "not inside the skin at waypoint 3"},
      {"kind = \"waypoints\"", "kind = \"waypoints\"\ncycles = 2", "does not end where it begins"},
      {"kind = \"waypoints\"", "kind = \"waypoints\"\nstroke = \"1 mm\"", "stroke has no effect"},
      {"height = \"1 mm\"", "heigth = \"1 mm\"", "did you mean motion.waypoints[0].height"}};
  for (const WrongPath& mistake : mistakes)
    EXPECT_THAT(error_of(with_motion(replaced(path, mistake.from, mistake.to))),
                HasSubstr(mistake.message));
  EXPECT_THAT(error_of(with_motion("[motion]\nkind = \"waypoints\"\n")),
              HasSubstr("at least two waypoints"));
  EXPECT_THAT(error_of(valid_case("stroke = \"6 mm\"", "stroke = \"6 mm\"\nstrokes = 3")),
              HasSubstr("motion.strokes has no effect"));
}

TEST(Waypoints, MayHaveAnglesAndTakeThoseOfTheSliderElse) {
  std::string text = replaced(path, "force = \"1 N\"", "force = \"1 N\"\nyaw = \"90 deg\"");
  text = replaced(with_motion(text), "[slider]\n", "[slider]\npitch = \"10 mrad\"\n");
  const TemporaryCase file(text);
  const Case input = read_case(file.path());
  const auto legs = motion_legs(input.motion, input.slider);
  EXPECT_EQ(legs[0].from_pose, (shapes::Pose{0, 0.01, 0}));
  EXPECT_DOUBLE_EQ(legs[0].to_pose.yaw, std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(legs[0].pose(0.25).yaw, std::numbers::pi / 4);
  EXPECT_EQ(legs[1].to_pose, (shapes::Pose{0, 0.01, 0}));
  EXPECT_TRUE(legs[1].turns());
  EXPECT_TRUE(input.slider.changing.yaw);
  EXPECT_FALSE(input.slider.changing.roll || input.slider.changing.pitch);
}

TEST(Waypoints, AnglesThatAreNotCarriedAreRefused) {
  const auto with_angle = [](const std::string& angle, const std::string& motion) {
    std::string text = replaced(path, "force = \"1 N\"", "force = \"1 N\"\n" + angle);
    return with_motion(text + motion);
  };
  EXPECT_EQ(error_of(with_angle("yaw = \"1 rad\"", "")), "");
  EXPECT_THAT(error_of(with_angle("yaw = \"1 mm\"", "")), HasSubstr("expected an angle"));
  EXPECT_THAT(error_of(with_angle("pitch = \"6 deg\"", "")),
              HasSubstr("motion.waypoints[1].pitch"));
  EXPECT_THAT(error_of(with_angle("pitch = \"4 deg\"\nroll = \"4 deg\"", "")),
              HasSubstr("waypoint 2: roll and pitch together tilt the slider by 5.65"));
  EXPECT_THAT(
      error_of(with_angle("yaw = \"1 rad\"",
                          "[motion.drive]\nstiffness = \"1 kN/m\"\ndamping = \"1 N s/m\"\n")),
      HasSubstr("a slider on a drive keeps its angles"));
}

TEST(Waypoints, ASliderThatIsTiltedTooFarIsRefusedInAnyMotion) {
  const auto with = [](const std::string& angles) {
    return error_of(valid_case("[slider]\n", "[slider]\n" + angles));
  };
  EXPECT_EQ(with("roll = \"3 deg\"\npitch = \"-4 deg\"\nyaw = \"0.1 deg\"\n"), "");
  EXPECT_THAT(with("roll = \"-5.1 deg\"\n"), HasSubstr("slider.roll"));
  EXPECT_THAT(with("roll = \"4 deg\"\npitch = \"-4 deg\"\n"),
              HasSubstr("a tilt is carried as a slope, up to 5 deg"));
}

std::string error_of_file(const std::string& rows) {
  const TemporaryCase file(with_motion("[motion]\nkind = \"waypoints\"\nfile = \"path.csv\""));
  std::ofstream(file.folder() + "/path.csv") << rows;
  try {
    read_case(file.path());
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

TEST(Waypoints, AreReadFromAFileWithUnitsInItsHeader) {
  const TemporaryCase file(with_motion("[motion]\nkind = \"waypoints\"\nfile = \"path.csv\""));
  std::ofstream(file.folder() + "/path.csv")
      << "# a recorded path\ntime [ms], x [mm], y [mm], height [um], force [N]\n"
         "0, 4, 1, 1000,\n500, 4, 1, , 1.5\n\n";
  const Case input = read_case(file.path());
  ASSERT_EQ(input.motion.waypoints.size(), 2u);
  EXPECT_DOUBLE_EQ(input.motion.waypoints[1].time, 0.5);
  EXPECT_DOUBLE_EQ(*input.motion.waypoints[0].height, 1e-3);
  EXPECT_EQ(input.motion.waypoints[1].force, 1.5);
  EXPECT_THAT(input.text, HasSubstr(file.folder() + "/path.csv"));
}

TEST(Waypoints, AFileMayHaveColumnsOfAngles) {
  const TemporaryCase file(with_motion("[motion]\nkind = \"waypoints\"\nfile = \"path.csv\""));
  std::ofstream(file.folder() + "/path.csv")
      << "time [s], x [mm], y [mm], height [um], yaw [deg], roll [mrad]\n"
         "0, 4, 1, 1000, 0,\n1, 4, 1, -1, 180, 2\n";
  const Case input = read_case(file.path());
  EXPECT_DOUBLE_EQ(*input.motion.waypoints[1].yaw, std::numbers::pi);
  EXPECT_DOUBLE_EQ(*input.motion.waypoints[1].roll, 2e-3);
  EXPECT_EQ(input.slider.pose, shapes::Pose{});
  EXPECT_THAT(error_of_file("time [s], x [mm], y [mm], height [um], pitch [deg]\n"
                            "0, 4, 1, 1000, 0\n1, 4, 1, -1, 7\n"),
              HasSubstr("waypoint 2: pitch = 0.1221730476 rad is out of range"));
}

TEST(Waypoints, MistakesInAFileAreSaidWithTheirLine) {
  const std::string header = "time [s], x [mm], y [mm], height [um]\n";
  EXPECT_THAT(error_of_file("time, x [mm]\n"), HasSubstr("\"time\" has no unit"));
  EXPECT_THAT(error_of_file("time [s], x [mm], y [mm]\n"), HasSubstr("neither a column"));
  EXPECT_THAT(error_of_file("time [s], x [kg], y [mm], height [um]\n"), HasSubstr("x: "));
  EXPECT_THAT(error_of_file("time [s], x [mm], y [mm], hight [um]\n"),
              HasSubstr("did you mean \"height\"?; ionskin motion FILE"));
  EXPECT_THAT(error_of_file(header + "0, 4, 1\n"), HasSubstr("path.csv:2"));
  for (const char* recording : {"time [s], x [mm], y [mm], force [N]\n0, 4, 1, 0\n1, 4, 1, 2\n",
                                "time [s], x [mm], y [mm], height [mm]\n1403636580.8, 4, 1, 1\n"
                                "1403636581.8, 4, 1, 1\n"})
    EXPECT_THAT(error_of_file(recording), HasSubstr("ionskin motion FILE -o path.csv"));
  EXPECT_THAT(error_of_file(header + "0, 4, 1, 5\n1, four, 1, 5\n"), HasSubstr("path.csv:3"));
  EXPECT_THAT(error_of_file(header + "0, 4, 1, 5\n1, 4, 1, 5\n1, 4, 1, 6\n"),
              AllOf(HasSubstr("path.csv:4"), HasSubstr("average them")));
  EXPECT_THAT(error_of_file("\xEF\xBB\xBF"
                            "Time (s)\tx (mm)\ty (mm)\theight (mm)\r0\t4,5\t1\t1\r"
                            "1\t4,5\t1\tlow\r"),
              AllOf(HasSubstr("path.csv:3"), HasSubstr("low")));
  EXPECT_THAT(error_of_file(""), HasSubstr("no header"));
}

TEST(Waypoints, OneMistakeOfManyRowsIsSaidOnce) {
  std::string zeros = "time [s],x [mm],y [mm],force [N]\n",
              epoch = "time [s],x [mm],y [mm],height [mm]\n";
  for (int row = 0; row < 200; ++row) {
    zeros += fmt::format("{},4,1,-0.0\n", row);
    epoch += fmt::format("{},4,1,1\n", 1403636580 + row);
  }
  const std::string of_zeros = error_of_file(zeros), of_epoch = error_of_file(epoch);
  EXPECT_THAT(of_zeros,
              AllOf(HasSubstr("waypoint 1 has a force of 0 N (and 199 more of this kind)"),
                    HasSubstr("path.csv:2"), HasSubstr("path.csv:4"), Not(HasSubstr("path.csv:5")),
                    Not(HasSubstr("problems in"))));
  EXPECT_THAT(of_epoch, AllOf(HasSubstr("(and 199 more of this kind)"),
                              HasSubstr("subtract the time of the first waypoint from all")));
}

TEST(Waypoints, AreReadAsProgramsLeaveThem) {
  const std::string bom = "\xEF\xBB\xBF";
  for (const std::string& text :
       {std::string("time [s],x [mm],y [mm],height "
                    "[mm]\n0,4.5,1,1\n1,4.5,1,-1e-3\n1,4.5,1,-1e-3\n2,4.5,1,1\n"),
        bom + "Time [s];x [mm];y [mm];height [mm]\r\n0;4,5;1;1\r\n1;4,5;1;-1e-3\r\n2;4,5;1;1\r\n",
        std::string(
            ",time [s],x [mm],y [mm],height [mm]\r0,0,4.5,1,1\r1,1,4.5,1,-1e-3\r2,2,4.5,1,1\r"),
        std::string(
            "time [s],x [mm],y [mm],height [mm],\n0,4.5,1,1,\n1,4.5,1,-1e-3,\n2,4.5,1,1,\n")})
    EXPECT_EQ(error_of_file(text), "") << text;
}

} // namespace
} // namespace ionskin
