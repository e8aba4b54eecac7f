// SPDX-License-Identifier: Apache-2.0
#include "allocation_counter.hpp"
#include "ionskin/live/contact/live_contact.hpp"
#include "ionskin/live/interface/ionskin_live.hpp"
#include "ionskin/live/skin.hpp"
#include "ionskin/mechanics/engine/sliding_contact.hpp"
#include "small_skin.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <span>
#include <string>

namespace ionskin::live {
namespace {

struct Law {
  std::string name;
  std::vector<std::string> parameters = {};
  std::vector<double> values = {};
};

/// All of the engine that a live skin knows, with parameters that matter to the small skin.
std::vector<Law> laws_to_compare() {
  return {{"coulomb"},
          {"saturating", {"strength", "sharpness"}, {5e5, 2}},
          {"regularised", {"slip_length"}, {2e-7}},
          {"viscous", {"reference_speed"}, {1e-2}},
          {"stribeck", {"kinetic_friction", "stribeck_speed", "lag_time"}, {0.1, 3e-3, 5e-3}},
          {"anisotropic", {"transverse_friction"}, {0.1}}};
}

SkinData skin_with(const Law& law) {
  SkinData data = small_skin();
  data.friction_law = law.name;
  data.friction_parameters = law.parameters;
  data.friction_values = law.values;
  data.highest_place[1] = 2e-3;
  data.deepest_indentation = 2e-5; // a step to its depths is one part, as in the engine
  return data;
}

/// The engine on the compliance of a live skin, which is the same everywhere in it.
class Engine {
public:
  explicit Engine(const SkinData& data)
      : contact_([matrix = compliance(data)](const auto&,
                                             auto& problem) { problem.compliance = matrix; },
                 data.area, data.gap, friction_of(data, data.friction)),
        lines_(data.cell_lines_x) {}

  /// Forces and moments; the cells stand in one row.
  std::array<double, 6> step(double time_step, const std::array<double, 2>& place, double depth) {
    const auto& force =
        contact_.step(time_step, place, {mechanics::LoadKind::indentation, depth}).force;
    std::array<double, 6> sum{};
    for (std::size_t i = 0; i < force.size(); ++i) {
      const double arm = (lines_[i / 3] + lines_[i / 3 + 1]) / 2;
      sum[i % 3] += force[i];
      sum[4] += i % 3 == 0 ? arm * force[i] : 0;
      sum[5] += i % 3 == 2 ? arm * force[i] : 0;
    }
    return sum;
  }

private:
  static Eigen::MatrixXd compliance(const SkinData& data) {
    const auto size = static_cast<Eigen::Index>(3 * data.area.size());
    return Eigen::Map<const Eigen::MatrixXf>(data.compliance.values.data(), size, size)
        .cast<double>();
  }

  mechanics::SlidingContact contact_;
  std::vector<double> lines_;
};

/// A slide that lands, turns, rests and leaves.
struct Moment {
  std::array<double, 2> place{};
  double depth = 0;
};
Moment moment_of(int step) {
  const double way = step < 80 ? step : step < 160 ? 160 - step : 0;
  return {{3e-3 + 1e-6 * way + (step < 40 ? 2e-6 * step : 8e-5), 1e-3 + 4e-7 * way},
          step < 3 || step > 230 ? -1e-6 : 5e-7 + 1e-7 * std::sin(0.05 * step)};
}

TEST(LiveFriction, IsThatOfTheEngineUnderEveryLaw) {
  for (const Law& law : laws_to_compare()) {
    SCOPED_TRACE(law.name);
    SkinData data = skin_with(law);
    data.compliance.amplitude.clear();
    data.compliance.lines_x = {3e-3};
    data.compliance.values.resize(data.compliance.values.size() / 2);
    Skin skin(data);
    Engine engine(data);
    std::vector<double> signals(skin.names().size());
    double largest = 0;
    for (int i = 0; i < 250; ++i) {
      const Moment at = moment_of(i);
      skin.step(1e-3 * i, at.place, false, -at.depth, signals);
      const auto expected = engine.step(i == 0 ? 1e-9 : 1e-3, at.place, at.depth);
      largest = std::max(largest, expected[0]);
      const auto moment = std::span(signals).last(3);
      const std::array<double, 6> found{signals[3], signals[5], signals[6],
                                        moment[0],  moment[1],  moment[2]};
      for (std::size_t c = 0; c < found.size(); ++c) {
        const double arm = c < 3 ? 1 : data.cell_lines_x.back();
        ASSERT_NEAR(found[c], expected[c], 1e-5 * largest * arm)
            << "step " << i << " component " << c;
      }
    }
  }
}

TEST(LiveFriction, IsRememberedByTheStateAndTakesNoMemory) {
  for (const Law& law : laws_to_compare()) {
    SCOPED_TRACE(law.name);
    const SkinData data = skin_with(law);
    Skin skin(data), other(data);
    std::vector<double> signals(skin.names().size()), expected = signals;
    for (int i = 0; i < 100; ++i) {
      skin.step(1e-3 * i, moment_of(i).place, false, -moment_of(i).depth, signals);
    }
    const std::vector<double> state(skin.state().begin(), skin.state().end());
    const std::size_t before = allocations();
    ASSERT_TRUE(other.restore(state));
    for (int i = 100; i < 250; ++i) {
      skin.step(1e-3 * i, moment_of(i).place, false, -moment_of(i).depth, expected);
      other.step(1e-3 * i, moment_of(i).place, false, -moment_of(i).depth, signals);
      ASSERT_EQ(signals, expected) << i;
      // A time that is asked for again is not sliding.
      other.step(1e-3 * i, moment_of(i).place, false, -moment_of(i).depth, signals);
      ASSERT_NEAR(signals[5], expected[5], 1e-4 * 5) << i;
      ASSERT_TRUE(other.restore(skin.state()));
    }
    EXPECT_EQ(allocations() - before, 0u);
  }
}

// Neither a new coefficient nor a new pressure winds up what a slider at rest holds.
TEST(LiveFriction, GivesNoEnergyToAnElasticSlip) {
  SkinData data = skin_with({"regularised", {"slip_length"}, {1e-5}});
  data.lowest_friction = 0;
  data.highest_friction = 0.5;
  Skin skin(data);
  std::vector<double> signals(skin.names().size());
  double time = 0;
  const auto step = [&](double way, double depth) {
    skin.step(time, {3e-3 + way, 1e-3}, false, -depth, signals);
    time += 1e-3;
    return signals[5];
  };
  ASSERT_TRUE(skin.set_friction(0.1));
  step(0, 3e-7);
  for (int i = 1; i <= 20; ++i) {
    step(1e-7 * i, 3e-7);
  }
  const double wound = step(2e-6, 3e-7);
  EXPECT_GT(wound, 0);
  ASSERT_TRUE(skin.set_friction(0.5));
  EXPECT_NEAR(step(2e-6, 3e-7), wound, 0.02 * wound);
  ASSERT_TRUE(skin.set_friction(0));
  EXPECT_EQ(step(2e-6, 3e-7), 0);
  ASSERT_TRUE(skin.set_friction(0.5));
  EXPECT_NEAR(step(2e-6, 3e-7), 0, 0.02 * wound);
}

TEST(LiveFriction, CanBeSetWithinTheTrainedRange) {
  SkinData data = small_skin();
  data.lowest_friction = 0;
  data.highest_friction = 0.5;
  const auto path = std::filesystem::temp_directory_path() / "ionskin_live_friction.live";
  write_skin(path, data);
  ionskin_live::Skin skin(path.string());
  std::filesystem::remove(path);
  EXPECT_EQ(skin.friction(), (std::array<double, 3>{0.3, 0, 0.5}));
  EXPECT_FALSE(skin.set_friction(0.6));
  EXPECT_FALSE(skin.set_friction(NAN));
  const std::size_t normal = skin.index("normal_force"),
                    tangential = skin.index("tangential_force");
  double time = 0;
  for (const double friction : {0.3, 0.5, 0.0, 0.2}) {
    ASSERT_TRUE(friction == 0.3 || skin.set_friction(friction));
    for (int i = 0; i < 100; ++i, time += 1e-3) {
      skin.step(time, {2e-3 + 5e-3 * time, 1e-3}, ionskin_live::Height{-5e-7});
    }
    const auto& signals = skin.step(time, {2e-3 + 5e-3 * time, 1e-3}, ionskin_live::Height{-5e-7});
    EXPECT_NEAR(signals[tangential], friction * signals[normal], 1e-9) << friction;
  }
}

} // namespace
} // namespace ionskin::live
