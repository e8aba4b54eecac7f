// SPDX-License-Identifier: Apache-2.0
#include "allocation_counter.hpp"
#include "ionskin/live/interface/ionskin_live.hpp"
#include "small_skin.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace ionskin::live {
namespace {

using ionskin_live::Force;
using ionskin_live::Height;

/// The class for controllers, over the C interface of the shared library.
class LiveController : public testing::Test {
protected:
  LiveController() { write_skin(path, small_skin()); }
  ~LiveController() override { std::filesystem::remove(path); }
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / "ionskin_controller_test.live";
};

TEST_F(LiveController, TakesNoMemoryInTheLoop) {
  ionskin_live::Skin skin(path);
  const std::size_t force = skin.index("normal_force");
  std::vector<double> state(skin.state_size());
  const std::size_t first = allocations();
  ionskin_live_close(ionskin_live_copy(skin.handle()));
  EXPECT_GT(allocations(), first) << "what the library takes is not counted";
  const std::size_t before = allocations();
  for (int i = 0; i < 1000; ++i) {
    const double time = 1e-3 * i, x = 2e-3 + 1e-6 * i;
    skin.save(state.data());
    const double pressed = skin.step(time, {x, 1e-3}, Height{i % 10 == 0 ? 1e-4 : -4e-7})[force];
    EXPECT_EQ(pressed > 0, i % 10 != 0);
    EXPECT_TRUE(skin.restore(state.data(), state.size()));
    EXPECT_NEAR(skin.step(time, {x, 1e-3}, Force{3})[force], 3, 1e-4);
    const ionskin_live::Signals& held = skin.step_held(time, {x, 1e-3}, 0, Force{2}, {0, 1});
    EXPECT_EQ(held.flags, IONSKIN_LIVE_OUTSIDE_POSE) << "it was trained upright";
    EXPECT_NEAR(held[force], 2, 1e-4);
    EXPECT_EQ(skin.angles(), (std::array<double, 3>{}));
    EXPECT_EQ(skin.step(time, {NAN, 1e-3}, Force{3}).flags, IONSKIN_LIVE_REFUSED);
  }
  skin.reset();
  EXPECT_EQ(allocations() - before, 0u);
}

TEST_F(LiveController, RefusesNoFileAndNoEnvironments) {
  char message[80] = "";
  EXPECT_EQ(ionskin_live_open(nullptr, message, sizeof message), nullptr);
  EXPECT_EQ(std::string(message).find("path: it is NULL"), 0u) << message;
  EXPECT_EQ(ionskin_live_open(nullptr, nullptr, 0), nullptr);
  const ionskin_live::Skin skin(path);
  EXPECT_EQ(ionskin_live_skins_open(skin.handle(), 0, 1), nullptr);
  EXPECT_EQ(ionskin_live_skins_open(skin.handle(), 3, 0), nullptr);
  ionskin_live_skins* skins = ionskin_live_skins_open(skin.handle(), 3, 1);
  EXPECT_NE(skins, nullptr);
  ionskin_live_skins_close(skins);
}

TEST_F(LiveController, DrawsTouchesWithinTheTrainedRange) {
  ionskin_live::Skin skin(path);
  double rows[IONSKIN_LIVE_TOUCH_ROWS][7], again[IONSKIN_LIVE_TOUCH_ROWS][7], range[7];
  ionskin_live_range(skin.handle(), range);
  int kind = -1;
  const std::size_t count = ionskin_live_random_touch(skin.handle(), 3, rows[0], &kind);
  EXPECT_EQ(kind, IONSKIN_LIVE_FORCE);
  ASSERT_GE(count, 7u);
  double heaviest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_EQ(rows[i][3] == 0, i < 2 || i + 2 >= count) << i;
    EXPECT_GE(rows[i][1], range[0]);
    EXPECT_LE(rows[i][1], range[2]);
    heaviest = std::max(heaviest, rows[i][3]);
  }
  EXPECT_LE(heaviest, range[4]);
  EXPECT_GE(heaviest, 0.15 * range[4]);
  ASSERT_EQ(ionskin_live_random_touch(skin.handle(), 3, again[0], &kind), count);
  EXPECT_TRUE(std::equal(rows[0], rows[count], again[0]));
  ionskin_live_random_touch(skin.handle(), 4, again[0], &kind);
  EXPECT_FALSE(std::equal(rows[0], rows[7], again[0]));

  SkinData held = small_skin();
  held.errors = {{"slider_z", "", 0, 0, 1e-4}};
  write_skin(path, held);
  ionskin_live::Skin by_height(path);
  ASSERT_GE(ionskin_live_random_touch(by_height.handle(), 3, rows[0], &kind), 7u);
  EXPECT_EQ(kind, IONSKIN_LIVE_HEIGHT);
  EXPECT_GT(rows[0][3], 0);
  EXPECT_LT(rows[2][3], 0);
  EXPECT_GE(rows[2][3], -range[5]);
}

TEST_F(LiveController, CopiesGoOnByThemselves) {
  ionskin_live::Skin skin(path);
  skin.step(0, {2e-3, 1e-3}, Height{-5e-7});
  ionskin_live::Skin other = skin;
  const std::vector<double> expected = skin.step(1e-3, {2.1e-3, 1e-3}, Height{-5e-7}).values;
  skin.reset();
  EXPECT_EQ(other.step(1e-3, {2.1e-3, 1e-3}, Height{-5e-7}).values, expected);
  skin = std::move(other);
  EXPECT_EQ(skin.step(1e-3, {2.1e-3, 1e-3}, Height{-5e-7})[0], expected[0]);
  EXPECT_TRUE(skin.step(1, {9e-3, 1e-3}, Height{-5e-7}).outside());
  EXPECT_FALSE(skin.restore(expected.data(), 1));
  std::vector<double> state(skin.state_size());
  skin.save(state.data());
  EXPECT_TRUE(skin.restore(state.data(), state.size()));
  state.back() = NAN;
  EXPECT_FALSE(skin.restore(state.data(), state.size()));
  EXPECT_EQ(skin.range()[4], small_skin().heaviest_force);
}

TEST_F(LiveController, SaysWhatIsMissing) {
  EXPECT_THROW(ionskin_live::Skin(path).index("current_of_nothing"), std::out_of_range);
  try {
    ionskin_live::Skin(path.string() + ".none");
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("no such file"), std::string::npos);
  }
}

} // namespace
} // namespace ionskin::live
