// SPDX-License-Identifier: Apache-2.0
#include "allocation_counter.hpp"
#include "ionskin/base/digest.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/live/data/skin_archive.hpp"
#include "ionskin/live/interface/ionskin_live.h"
#include "ionskin/live/skin.hpp"
#include "small_skin.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <span>
#include <string>

namespace ionskin::live {
namespace {

class LiveSkin : public testing::Test {
protected:
  std::uint32_t step(Skin& skin, double time, double x, double value, bool is_force = false) {
    return skin.step(time, {x, 1e-3}, is_force, value, signals);
  }
  double of(const Skin& skin, const std::string& name) const {
    const auto& names = skin.names();
    return signals[static_cast<std::size_t>(std::find(names.begin(), names.end(), name) -
                                            names.begin())];
  }
  SkinData data = small_skin();
  std::vector<double> signals = std::vector<double>(Skin(data).names().size());
};

TEST_F(LiveSkin, SlidesUnderItsFrictionAndTaxelsAddUp) {
  Skin skin(data);
  EXPECT_EQ(step(skin, 0, 2e-3, -5e-7), 0u); // begins in contact
  EXPECT_EQ(of(skin, "current_top"), 0);
  const double standing = of(skin, "normal_force");
  EXPECT_GT(standing, 0);
  for (int i = 1; i <= 100; ++i) {
    EXPECT_EQ(step(skin, 1e-3 * i, 2e-3 + 1e-5 * i, -5e-7), 0u);
  }
  EXPECT_NEAR(of(skin, "tangential_force"), 0.3 * of(skin, "normal_force"), 1e-9);
  EXPECT_EQ(of(skin, "stick_share"), 0);
  EXPECT_NEAR(of(skin, "charge_top"), of(skin, "charge_top_left") + of(skin, "charge_top_right"),
              1e-6 * std::abs(of(skin, "charge_top")));
  EXPECT_EQ(step(skin, 1, 3e-3, 1e-4), 0u);
  EXPECT_EQ(of(skin, "normal_force"), 0);
  EXPECT_EQ(of(skin, "slider_z"), 1e-4);
}

TEST_F(LiveSkin, CurrentHasTheChargeThatMovesAtARepeatedTime) {
  Skin skin(data);
  step(skin, 0, 2e-3, -5e-7);
  const double before = of(skin, "charge_top");
  step(skin, 0, 2.1e-3, -5e-7);
  EXPECT_EQ(of(skin, "current_top"), 0);
  EXPECT_NE(of(skin, "charge_top"), before);
  step(skin, 1e-3, 2.1e-3, -5e-7);
  const double moved = of(skin, "charge_top") - before;
  EXPECT_NEAR(of(skin, "current_top"), moved / 1e-3, 1e-9 * std::abs(moved) / 1e-3);
}

TEST_F(LiveSkin, ChargeSpreadsToTheOtherTaxelWhileASliderRests) {
  SkinData alone = data;
  alone.spread = {};
  const auto charges = [&](const SkinData& of_skin) {
    Skin skin(of_skin);
    step(skin, 0, 1.5e-3, -5e-7);
    step(skin, 0.01, 1.8e-3, -5e-7); // dragged, then at rest
    step(skin, 1, 1.8e-3, -5e-7);
    return std::array{of(skin, "charge_top_left"), of(skin, "charge_top_right")};
  };
  const auto [left, right] = charges(data);
  const auto [left_alone, right_alone] = charges(alone);
  const double total = left + right;
  EXPECT_GT(std::abs(total), 0);
  EXPECT_NEAR(total, left_alone + right_alone, 1e-6 * std::abs(total));
  EXPECT_GT(std::abs(left - left_alone), 1e-2 * std::abs(total));
}

TEST_F(LiveSkin, SlidesUnderTheFrictionOfItsDirection) {
  data.friction_law = "anisotropic";
  data.friction_parameters = {"transverse_friction"};
  data.friction_values = {0.1};
  data.highest_place[1] = 2e-3;
  Skin skin(data);
  for (int i = 0; i <= 100; ++i) {
    EXPECT_EQ(skin.step(1e-3 * i, {2e-3, 1e-3 + 1e-5 * i}, false, -5e-7, signals), 0u);
  }
  EXPECT_NEAR(of(skin, "tangential_force_y"), 0.1 * of(skin, "normal_force"), 1e-9);
}

TEST_F(LiveSkin, CarriesAForceAndSticksUntilItIsDragged) {
  Skin skin(data);
  EXPECT_EQ(step(skin, 7, 2e-3, 5, true), 0u);
  EXPECT_NEAR(of(skin, "normal_force"), 5, 1e-5);
  EXPECT_EQ(of(skin, "stick_share"), 1);
  const double depth = -of(skin, "slider_z");
  step(skin, 8, 2e-3, 2.5, true);
  EXPECT_NEAR(of(skin, "normal_force"), 2.5, 1e-5);
  EXPECT_LT(-of(skin, "slider_z"), depth);
}

TEST_F(LiveSkin, GoesOnAfterARestoreToTheBit) {
  Skin skin(data), other(data);
  for (int i = 0; i < 50; ++i) {
    step(skin, 1e-3 * i, 2e-3 + 1e-6 * i, -4e-7);
  }
  ASSERT_TRUE(other.restore(std::vector<double>(skin.state().begin(), skin.state().end())));
  for (int i = 50; i < 100; ++i) {
    step(skin, 1e-3 * i, 2e-3 + 1e-6 * i, -4e-7);
    const std::vector<double> expected = signals;
    step(other, 1e-3 * i, 2e-3 + 1e-6 * i, -4e-7);
    ASSERT_EQ(signals, expected) << i;
  }
  EXPECT_FALSE(other.restore(std::vector<double>(3)));
}

TEST_F(LiveSkin, RefusesAStateThatNoStepLeaves) {
  Skin skin(data);
  const std::vector<double> fresh(skin.state().begin(), skin.state().end());
  for (int i = 0; i < 20; ++i) {
    step(skin, 1e-3 * i, 2e-3 + 1e-5 * i, -4e-7);
  }
  const std::vector<double> whole(skin.state().begin(), skin.state().end());
  step(skin, 0.02, 2.2e-3, -4e-7);
  const std::vector<double> expected = signals;
  const auto refuses = [&](std::vector<double> state, std::size_t at, double value) {
    ASSERT_TRUE(skin.restore(whole));
    state[at] = value;
    EXPECT_FALSE(skin.restore(state)) << value << " at " << at;
    EXPECT_EQ(step(skin, 0.02, 2.2e-3, -4e-7), 0u);
    EXPECT_EQ(signals, expected) << "nothing has changed";
  };
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  enum : std::size_t {
    started,
    last_time,
    last_x,
    last_y,
    assembled_x,
    assembled_y,
    indentation,
    last_yaw,
    last_roll,
    last_pitch
  };
  const std::size_t first_signal = whole.size() - signals.size();
  for (std::size_t at = 0; at < whole.size(); ++at) {
    for (const double value : {nan, infinity, -infinity}) {
      refuses(whole, at, value);
    }
    if (at != last_time && at < first_signal) {
      refuses(whole, at, 1e300);
    }
    if (at != assembled_x && at != assembled_y) {
      refuses(fresh, at, nan);
    }
    if (at != started) {
      refuses(fresh, at, 1e-3);
    }
  }
  refuses(whole, started, 0);
  refuses(whole, started, 0.5);
  refuses(whole, last_x, 0);
  refuses(whole, assembled_y, 2e-3);
  refuses(whole, last_pitch + 1, -1e-9); // a cell that pulls
  EXPECT_TRUE(skin.restore(fresh));
}

TEST_F(LiveSkin, TakesUpTheStatesOfAbsurdSteps) {
  Skin skin(data);
  for (const double absurd : {-1e300, 1e300, 1e-300}) {
    for (const bool is_force : {false, true}) {
      step(skin, 0, absurd, absurd, is_force);
      const std::vector<double> state(skin.state().begin(), skin.state().end());
      EXPECT_TRUE(skin.restore(state)) << absurd << (is_force ? " N" : " m");
    }
  }
}

TEST_F(LiveSkin, AllocatesNothing) {
  const std::size_t first = allocations();
  Skin skin(data);
  EXPECT_GT(allocations(), first) << "what a skin takes is not counted";
  const std::vector<double> state(skin.state().begin(), skin.state().end());
  const std::size_t before = allocations();
  for (int i = 0; i < 1000; ++i) {
    step(skin, 1e-3 * i, 2e-3 + 1e-6 * i, i % 10 == 0 ? 1e-4 : -4e-7);
    step(skin, 1e-3 * i, 2e-3 + 1e-6 * i, 3, true);
  }
  skin.restore(state);
  skin.reset();
  EXPECT_EQ(allocations() - before, 0u);
}

TEST_F(LiveSkin, FlagsWhatItWasNotTrainedFor) {
  Skin skin(data);
  EXPECT_EQ(step(skin, 0, 6e-3, 1e-4), 0u); // far, but detached
  EXPECT_EQ(step(skin, 1, 6e-3, -1e-7), flag::outside_place);
  EXPECT_EQ(of(skin, "slider_x"), 5e-3);
  EXPECT_EQ(step(skin, 2, 5e-3, -1e-5) & flag::outside_load, flag::outside_load);
  EXPECT_EQ(step(skin, 2.001, 3e-3, -5e-7) & flag::outside_speed, flag::outside_speed);
  step(skin, 2.5, 3e-3, -5e-7);
  const std::vector<double> last = signals;
  const std::vector<double> state(skin.state().begin(), skin.state().end());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const auto& [time, x, height] :
       {std::array{nan, 2e-3, 0.0}, std::array{3.0, nan, 0.0}, std::array{3.0, 2e-3, nan},
        std::array{3.0, 2e-3, std::numeric_limits<double>::infinity()},
        std::array{1.0, 2e-3, 0.0}}) {
    EXPECT_EQ(step(skin, time, x, height), flag::refused);
    EXPECT_EQ(signals, last);
  }
  EXPECT_EQ(std::vector<double>(skin.state().begin(), skin.state().end()), state);
  for (const double absurd : {-1e300, 1e300}) {
    EXPECT_EQ(step(skin, 3, absurd, absurd),
              absurd < 0 ? flag::outside_place | flag::outside_load : 0u);
    EXPECT_EQ(step(skin, 3, 3e-3, 1e300, true) & flag::outside_load, flag::outside_load);
    for (const double signal : signals) {
      EXPECT_TRUE(std::isfinite(signal));
    }
  }
  step(skin, 4, 3e-3, 1e-4);
  EXPECT_EQ(step(skin, 5, 3e-3, -5e-7), 0u);
  EXPECT_TRUE(std::isfinite(of(skin, "charge_top")));
}

TEST_F(LiveSkin, ComesBackFromItsFile) {
  const auto path = std::filesystem::temp_directory_path() / "ionskin_live_test.live";
  write_skin(path, data);
  const SkinData read = read_skin(path);
  Skin first(data), second(read);
  step(first, 0, 2e-3, -5e-7);
  const std::vector<double> expected = signals;
  step(second, 0, 2e-3, -5e-7);
  EXPECT_EQ(signals, expected);
  EXPECT_EQ(read.taxels, data.taxels);
  EXPECT_EQ(read.case_text, data.case_text);
  EXPECT_EQ(read.errors.front().worst, data.errors.front().worst);
  EXPECT_EQ(read.errors.back().event, "hold");

  char message[200];
  ionskin_live_skin* skin = ionskin_live_open(path.c_str(), message, sizeof message);
  ASSERT_NE(skin, nullptr) << message;
  EXPECT_EQ(ionskin_live_signal_count(skin), signals.size());
  std::vector<double> by_c(signals.size());
  EXPECT_EQ(ionskin_live_step(skin, 0, 2e-3, 1e-3, IONSKIN_LIVE_HEIGHT, -5e-7, by_c.data()), 0u);
  EXPECT_EQ(by_c, expected);
  ionskin_live_skin* copy = ionskin_live_copy(skin);
  ionskin_live_close(skin);
  EXPECT_EQ(ionskin_live_step(copy, 0, 2e-3, 1e-3, IONSKIN_LIVE_HEIGHT, NAN, by_c.data()),
            IONSKIN_LIVE_REFUSED);
  EXPECT_EQ(by_c, expected);
  EXPECT_EQ(ionskin_live_text(copy, "nothing"), nullptr);
  ionskin_live_close(copy);

  std::ifstream file(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  const auto refused = [&](const std::string& content) {
    std::ofstream(path, std::ios::binary) << content;
    EXPECT_EQ(ionskin_live_open(path.c_str(), message, sizeof message), nullptr);
    EXPECT_NE(std::string(message).find("ionskin live CASE.toml"), std::string::npos) << message;
  };
  std::string older = bytes;
  older[bytes.find('\n') - 1] = '6';
  refused(older);
  EXPECT_NE(std::string(message).find("another format"), std::string::npos) << message;
  for (const std::size_t length :
       {std::size_t{0}, std::size_t{10}, bytes.size() / 2, bytes.size() - 1}) {
    refused(bytes.substr(0, length));
  }
  for (std::size_t at = 0; at < bytes.size(); at += 97) {
    std::string changed = bytes;
    changed[at] = static_cast<char>(changed[at] ^ 0x10);
    refused(changed);
  }
  std::filesystem::remove(path);
  EXPECT_THROW(read_skin(path), UserError);
}

// A seed in an older format would be refused at its first line, and the fuzzer would search
// nothing.
TEST_F(LiveSkin, SeedOfTheFuzzerIsReadable) {
  std::ifstream file(IONSKIN_CORPUS "/live_skin/hold", std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), {}};
  const auto path = std::filesystem::temp_directory_path() / "ionskin_live_seed.live";
  std::ofstream(path, std::ios::binary) << sealed(bytes);
  EXPECT_NO_THROW(read_skin(path));
  if (HasFailure()) {
    write_skin(path, data);
    std::filesystem::resize_file(path, std::filesystem::file_size(path) - digest_digits);
    FAIL() << "copy " << path << " to fuzz/corpus/live_skin/hold";
  }
  std::filesystem::remove(path);
}

TEST_F(LiveSkin, RefusesAFileWhoseSizesDoNotFit) {
  const auto path = std::filesystem::temp_directory_path() / "ionskin_live_sizes.live";
  const auto refused = [&](auto&& damage) {
    SkinData wrong = small_skin();
    damage(wrong);
    write_skin(path, wrong);
    EXPECT_THROW(read_skin(path), UserError);
  };
  refused([](SkinData& wrong) { wrong.gap.pop_back(); });
  refused([](SkinData& wrong) { wrong.compliance.values.pop_back(); });
  refused([](SkinData& wrong) { wrong.compliance.lines_x.assign(40, 0); });
  refused([](SkinData& wrong) { std::ranges::reverse(wrong.cell_lines_x); });
  refused([](SkinData& wrong) { wrong.cell_lines_y.assign(wrong.cell_lines_y.size(), 0); });
  refused([](SkinData& wrong) { wrong.area.front() = 0; });
  refused([](SkinData& wrong) { std::ranges::reverse(wrong.channels[0].x_edges); });
  refused([](SkinData& wrong) { wrong.channels[0].field.pop_back(); });
  refused([](SkinData& wrong) { wrong.channels[0].fixed_x_edges.clear(); });
  refused([](SkinData& wrong) { wrong.channels[0].fixed_field.push_back(1); });
  refused([](SkinData& wrong) { wrong.channels[0].rows_per_point = 0; });
  refused([](SkinData& wrong) { wrong.whole.inputs = 1000; });
  refused([](SkinData& wrong) { wrong.taxel_corners.pop_back(); });
  refused([](SkinData& wrong) { wrong.spread.wave_x.pop_back(); });
  refused([](SkinData& wrong) { wrong.spread.weights.pop_back(); });
  refused([](SkinData& wrong) { wrong.spread.columns_y = 0; });
  refused([](SkinData& wrong) { wrong.spread.columns_x = std::uint64_t{1} << 60u; });
  refused([](SkinData& wrong) { wrong.spread.rates[1] = -1; });
  refused([](SkinData& wrong) { wrong.errors.push_back(wrong.errors.front()); }); // behind events
  refused([](SkinData& wrong) { wrong.stiffness = -1; });
  refused([](SkinData& wrong) { wrong.friction_law = "unheard-of"; });
  refused([](SkinData& wrong) { wrong.highest_friction = 0.2; }); // the case has more
  refused([](SkinData& wrong) { wrong.cell_lines_x.pop_back(); });
  refused([](SkinData& wrong) { wrong.steepest = 0.01; }); // without a table
  refused([](SkinData& wrong) { wrong.lowest = {0}; });
  refused([](SkinData& wrong) { wrong.fastest_turn = 1; }); // a block
  std::filesystem::remove(path);
}

} // namespace
} // namespace ionskin::live
