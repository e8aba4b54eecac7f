// SPDX-License-Identifier: Apache-2.0
#include "allocation_counter.hpp"
#include "ionskin/live/batch/skins.hpp"
#include "ionskin/live/data/slope_table.hpp"
#include "ionskin/live/skin.hpp"
#include "ionskin/mechanics/engine/sliding_contact.hpp"
#include "ionskin/mechanics/slider/turning_underside.hpp"
#include "small_skin.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <numbers>
#include <vector>

namespace ionskin::live {
namespace {

constexpr double ball_radius = 8e-3, ball_tilt = 0.02;

/// A ball or a cylinder of the engine, whose angles change.
ionskin::Slider round_slider(const char* shape = "sphere") {
  ionskin::Slider slider;
  slider.shape = shape;
  slider.parameters["radius"] = ball_radius;
  slider.size = {2 * ball_radius, 2 * ball_radius};
  slider.changing = {true, true, true};
  return slider;
}

/// The ball on many cells, trained for tilts and turns.
SkinData ball_data(const mechanics::TurningUnderside& underside) {
  SkinData data = sphere_on_many_cells(11);
  data.gap = underside.gap({});
  data.lowest_place = {1e-3, 4e-4};
  data.highest_place = {5e-3, 1.6e-3};
  data.deepest_indentation = 2e-4; // a step to its depths is one part, as in the engine
  data.steepest = ball_tilt;
  data.fastest_turn = 100;
  data.turns_into_itself = 1;
  data.slopes = slope_lines(std::tan(ball_tilt));
  for (const double y : data.slopes) {
    for (const double x : data.slopes) {
      data.lowest.push_back(ball_radius * (1 - std::sqrt(1 + x * x + y * y)));
    }
  }
  return data;
}

/// Path of a finger that tilts, spins and slides.
/// @param roll largest roll [rad]
struct Posed {
  std::array<double, 2> place{};
  Skin::Angles angles{};
  double depth = 0;
};
Posed posed_at(int step, double roll = 0.012) {
  const double t = step;
  return {{3e-3 + 4e-7 * t, 1e-3 + 1e-5 * std::sin(0.1 * t)},
          {roll * std::sin(0.03 * t), 0.01 * std::cos(0.05 * t), 0.2 * std::sin(0.04 * t)},
          5e-6 + 1e-6 * std::sin(0.07 * t)};
}

class LivePose : public testing::Test {
protected:
  LivePose() { data = ball_data(underside); }
  std::uint32_t step(Skin& skin, double time, const Posed& at) {
    return skin.step(time, at.place, at.angles, false, -at.depth, signals);
  }
  std::array<double, 6> wrench() const {
    const std::size_t moment = signals.size() - 3;
    return {signals[5],      signals[6],          -signals[3],
            signals[moment], signals[moment + 1], signals[moment + 2]};
  }
  static mechanics::ContactCells ball_cells() {
    const SkinData plain = sphere_on_many_cells(11);
    return {plain.cell_lines_x, plain.cell_lines_y, plain.area};
  }
  /// Steps the finger and the engine side by side, and compares their wrenches.
  /// @param missed largest difference, over the largest force and, for moments, half a millimetre
  /// @param roll largest roll [rad]
  void compare_with_the_engine(double missed, double roll);
  /// Compares the derivatives by a turn about z with steps.
  /// @param step_at step of the path
  void compare_stiffness_with_steps(int step_at, double roll);
  /// Puts a cylinder in place of the ball.
  void turn_a_cylinder();

  ionskin::Slider slider = round_slider();
  mechanics::ContactCells cells = ball_cells();
  mechanics::TurningUnderside underside{slider, cells};
  SkinData data;
  std::vector<double> signals = std::vector<double>(Skin(small_skin()).names().size());
};

void LivePose::turn_a_cylinder() {
  slider = round_slider("cylinder");
  data = ball_data(underside);
  data.turns_into_itself = 0;
  constexpr int yaws = 360;
  for (int at = 0; at < yaws; ++at) {
    const std::vector<double> gap = underside.gap({0, 0, 2 * std::numbers::pi * at / yaws});
    data.turned_gap.insert(data.turned_gap.end(), gap.begin(), gap.end());
  }
  data.lowest.clear();
  for (const double y : data.slopes) {
    for (const double x : data.slopes) {
      data.lowest.push_back(slider.underside()->lowest_on_slope(slider.plan(), {x, y}) -
                            slider.underside()->lowest(slider.plan()));
    }
  }
}

void LivePose::compare_with_the_engine(double missed, double roll) {
  const auto size = static_cast<Eigen::Index>(3 * data.area.size());
  const Eigen::MatrixXd compliance =
      Eigen::Map<const Eigen::MatrixXf>(data.compliance.values.data(), size, size).cast<double>();
  mechanics::SlidingContact engine(
      [&](const auto&, auto& problem) { problem.compliance = compliance; }, data.area, data.gap,
      friction_of(data, data.friction),
      std::make_shared<const mechanics::TurningUnderside>(slider, cells));
  Skin skin(data);
  double largest = 0, largest_torque = 0;
  for (int i = 0; i < 200; ++i) {
    const Posed at = posed_at(i, roll);
    ASSERT_EQ(step(skin, 1e-3 * i, at), 0u) << i;
    ASSERT_GT(signals[3], 0) << i;
    const auto& force =
        engine
            .step(i == 0 ? 1e-9 : 1e-3, at.place, {mechanics::LoadKind::indentation, at.depth},
                  {at.angles[0], at.angles[1], at.angles[2]})
            .force;
    std::array<double, 6> expected{};
    for (std::size_t cell = 0; cell < cells.count(); ++cell) {
      const auto [x, y] = cells.middle(cell);
      const double* of = force.data() + 3 * cell;
      const std::array<double, 6> own{of[1],      of[2],     -of[0],
                                      -y * of[0], x * of[0], x * of[2] - y * of[1]};
      for (std::size_t c = 0; c < own.size(); ++c) {
        expected[c] += own[c];
      }
    }
    largest = std::max(largest, std::abs(expected[2]));
    largest_torque = std::max(largest_torque, std::abs(expected[5]));
    const auto found = wrench();
    for (std::size_t c = 0; c < found.size(); ++c) {
      ASSERT_NEAR(found[c], expected[c], missed * largest * (c < 3 ? 1 : 5e-4))
          << "step " << i << " component " << c;
    }
  }
  EXPECT_GT(largest_torque, 1e-5 * largest);
}

TEST_F(LivePose, IsThatOfTheEngine) {
  compare_with_the_engine(2e-5, 0.012);
}

TEST_F(LivePose, OfATurningCylinderIsThatOfTheEngine) {
  turn_a_cylinder();
  compare_with_the_engine(1e-3, 0); // it would touch at its end alone
  // A cylinder that was trained without turns takes no yaw.
  data.fastest_turn = 0;
  data.turned_gap = {};
  Skin upright(data), turned(data);
  EXPECT_EQ(step(upright, 0, {{3e-3, 1e-3}, {0, 0, 0.5}, 5e-6}), flag::outside_pose);
}

TEST_F(LivePose, OfAStiffnessIsTheDifferenceOfSteps) {
  compare_stiffness_with_steps(30, 0.012);
  turn_a_cylinder();
  compare_stiffness_with_steps(10, 0); // where it touches beside its centre
}

void LivePose::compare_stiffness_with_steps(int step_at, double roll) {
  Skin skin(data);
  const double time = 1e-3 * step_at;
  for (int i = 0; i < step_at; ++i) {
    step(skin, 1e-3 * i, posed_at(i, roll));
  }
  const std::vector<double> state(skin.state().begin(), skin.state().end());
  const Posed now = posed_at(step_at, roll);
  step(skin, time, now);
  std::array<double, 36> stiffness{};
  ASSERT_TRUE(skin.stiffness(stiffness));
  constexpr double turn = 2e-5;
  std::array<std::array<double, 6>, 2> at{};
  for (const std::size_t end : {0u, 1u}) {
    ASSERT_TRUE(skin.restore(state));
    Posed there = now;
    there.angles[2] += end == 0 ? -turn / 2 : turn / 2;
    // The tilt stays where it is, while the yaw changes.
    const double c = std::cos(now.angles[2] - there.angles[2]),
                 s = std::sin(now.angles[2] - there.angles[2]);
    const double along_x = -std::tan(now.angles[1]), along_y = std::tan(now.angles[0]);
    there.angles[1] = -std::atan(c * along_x - s * along_y);
    there.angles[0] = std::atan(s * along_x + c * along_y);
    step(skin, time, there);
    at[end] = wrench();
  }
  for (std::size_t row = 0; row < 6; ++row) {
    const double scale = std::abs(stiffness[6 * 5 + 5]) / (row < 3 ? 5e-4 : 1);
    EXPECT_NEAR(stiffness[6 * row + 5], (at[1][row] - at[0][row]) / turn, 0.02 * scale) << row;
  }
}

TEST_F(LivePose, IsFlaggedBeyondWhatWasTrained) {
  Skin skin(data);
  const std::array<double, 2> place{3e-3, 1e-3};
  EXPECT_EQ(step(skin, 0, {place, {0, 0, 0}, 5e-6}), 0u);
  EXPECT_EQ(step(skin, 1, {place, {0, 2 * ball_tilt, 0}, 5e-6}), flag::outside_pose);
  const auto limited = signals;
  EXPECT_EQ(step(skin, 1, {place, {0, ball_tilt, 0}, 5e-6}), 0u);
  EXPECT_NEAR(signals[3], limited[3], 1e-5 * limited[3]);
  EXPECT_EQ(step(skin, 1.001, {place, {0, 0, 0.5}, 5e-6}), flag::outside_speed);
  EXPECT_EQ(step(skin, 2, {place, {0, 2 * ball_tilt, 0}, -1e-3}), 0u) << "in the air";
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Skin::Angles& wrong :
       {Skin::Angles{nan, 0, 0}, Skin::Angles{0, nan, 0}, Skin::Angles{0, 0, 1e7}}) {
    EXPECT_EQ(step(skin, 3, {place, wrong, 5e-6}), flag::refused);
  }
  data.turns_into_itself = 0;
  data.fastest_turn = 0;
  Skin block(data);
  EXPECT_EQ(step(block, 0, {place, {0, 0, 0.1}, 5e-6}), flag::outside_pose);
  data.steepest = 0;
  data.slopes = data.lowest = {};
  Skin upright(data);
  EXPECT_EQ(step(upright, 0, {place, {0, 1e-3, 0}, 5e-6}), flag::outside_pose);
  const double force = signals[3];
  EXPECT_EQ(step(upright, 0, {place, {0, 0, 0}, 5e-6}), 0u);
  EXPECT_NEAR(signals[3], force, 1e-5 * force);
}

TEST_F(LivePose, ComesBackFromItsFile) {
  const auto path = std::filesystem::temp_directory_path() / "ionskin_live_pose.live";
  write_skin(path, data);
  const SkinData read = read_skin(path);
  std::filesystem::remove(path);
  Skin first(data), second(read);
  step(first, 0, posed_at(7));
  const auto expected = signals;
  EXPECT_EQ(step(second, 0, posed_at(7)), 0u);
  EXPECT_EQ(signals, expected);
}

TEST_F(LivePose, OfManyIsThatOfOneAndTakesNoMemory) {
  constexpr std::size_t count = 5;
  Skin like(data);
  Skins skins(data, like, count, 1);
  std::vector<Skin> alone(count, like);
  std::vector<std::uint32_t> columns(like.names().size()), flags(count);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    columns[i] = static_cast<std::uint32_t>(i);
  }
  std::vector<double> times(count), positions(2 * count), loads(count), angles(3 * count),
      told(count * columns.size()), stiffness(36 * count);
  std::array<double, 36> expected{};
  std::size_t taken = 0;
  for (int at = 0; at < 60; ++at) {
    for (std::size_t i = 0; i < count; ++i) {
      Posed posed = posed_at(at + 7 * static_cast<int>(i));
      posed.angles = i == 2 ? Skin::Angles{} : posed.angles; // one of them is upright
      times[i] = 1e-3 * at;
      std::ranges::copy(posed.place, positions.begin() + static_cast<std::ptrdiff_t>(2 * i));
      std::ranges::copy(posed.angles, angles.begin() + static_cast<std::ptrdiff_t>(3 * i));
      loads[i] = -posed.depth;
    }
    const std::size_t before = allocations();
    skins.step<double>(0, 0, count,
                       {times.data(), positions.data(), false, loads.data(), columns, told.data(),
                        flags.data(), angles.data(), stiffness.data()});
    taken += allocations() - before;
    for (std::size_t i = 0; i < count; ++i) {
      alone[i].step(times[i], {positions[2 * i], positions[2 * i + 1]},
                    {angles[3 * i], angles[3 * i + 1], angles[3 * i + 2]}, false, loads[i],
                    signals);
      ASSERT_TRUE(alone[i].stiffness(expected));
      for (std::size_t k = 0; k < columns.size(); ++k) {
        ASSERT_EQ(told[i * columns.size() + k], signals[k]) << at << " " << i << " " << k;
      }
      ASSERT_TRUE(std::ranges::equal(std::span(stiffness).subspan(36 * i, 36), expected));
    }
  }
  EXPECT_EQ(taken, 0u);
}

TEST_F(LivePose, FollowsFromTheMomentsThatAreHeld) {
  Skin skin(data), posed(data);
  const std::size_t moment = signals.size() - 3;
  const double force = 1, reach = 1e-3;
  std::vector<double> expected(signals.size());
  std::size_t taken = 0;
  for (int i = 0; i < 100; ++i) {
    const Posed at = posed_at(i);
    const std::array<double, 2> moments{0.06e-3 * std::sin(0.1 * i), 0.05e-3 * std::cos(0.07 * i)};
    const std::size_t before = allocations();
    ASSERT_EQ(skin.step_held(1e-3 * i, at.place, at.angles[2], force, moments, signals), 0u) << i;
    taken += allocations() - before;
    EXPECT_NEAR(signals[moment], moments[0], 1e-3 * force * reach) << i;
    EXPECT_NEAR(signals[moment + 1], moments[1], 1e-3 * force * reach) << i;
    EXPECT_NEAR(signals[3], force, 1e-5 * force);
    // The ball touches where its underside is level: at the radius times its tilt.
    const auto [roll, pitch, yaw] = skin.angles();
    const double c = std::cos(yaw), s = std::sin(yaw);
    EXPECT_NEAR(ball_radius * (c * pitch + s * roll), moments[1] / force, 0.02e-3) << i;
    EXPECT_NEAR(-ball_radius * (s * pitch - c * roll), moments[0] / force, 0.02e-3) << i;
    // A step in the pose that was found is the same step.
    ASSERT_EQ(posed.step(1e-3 * i, at.place, skin.angles(), true, force, expected), 0u);
    for (std::size_t k = 0; k < signals.size(); ++k) {
      EXPECT_NEAR(signals[k], expected[k], 1e-4 * std::abs(expected[k]) + 1e-12) << i << " " << k;
    }
  }
  EXPECT_EQ(taken, 0u);
  skin.step_held(0.1, {3e-3, 1e-3}, 0, 0, {0, 0}, signals);
  EXPECT_EQ(signals[3], 0) << "without a force nothing touches";
}

TEST_F(LivePose, UnderMomentsThatNeedMoreTiltIsTheSteepest) {
  Skin skin(data);
  const std::array<double, 2> place{3e-3, 1e-3};
  EXPECT_EQ(skin.step_held(0, place, 0, 1, {0, 1e-3}, signals), flag::outside_pose);
  const auto [roll, pitch, yaw] = skin.angles();
  EXPECT_NEAR(std::hypot(roll, pitch), ball_tilt, 1e-9);
  EXPECT_NEAR(pitch, ball_tilt, 1e-3 * ball_tilt);
  EXPECT_EQ(skin.step_held(0.1, place, 0, 1, {0, 0}, signals), 0u);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(skin.step_held(0.2, place, 0, 1, {0, nan}, signals), flag::refused);
  data.steepest = 0;
  data.slopes = data.lowest = {};
  Skin upright(data);
  EXPECT_EQ(upright.step_held(0, place, 0, 1, {0, 5e-5}, signals), flag::outside_pose);
}

TEST(SlopeTable, IsExactForABallAndForABlock) {
  const std::vector<double> lines = slope_lines(0.08);
  ASSERT_TRUE(is_table_of_slopes(lines));
  const auto ball = [](double x, double y) { return 1 - std::sqrt(1 + x * x + y * y); };
  const auto block = [](double x, double y) { return -std::abs(x) - 0.5 * std::abs(y); };
  std::vector<double> of_ball, of_block;
  for (const double y : lines) {
    for (const double x : lines) {
      of_ball.push_back(ball(x, y));
      of_block.push_back(block(x, y));
    }
  }
  for (const double x : {-0.08, -0.033, -0.001, 0.0, 0.02, 0.079}) {
    for (const double y : {-0.07, -0.0007, 0.011, 0.06}) {
      EXPECT_NEAR(at_slope(lines, of_ball, {x, y}), ball(x, y), 1e-11);
      EXPECT_NEAR(at_slope(lines, of_block, {x, y}), block(x, y), 1e-15);
    }
  }
}

} // namespace
} // namespace ionskin::live
