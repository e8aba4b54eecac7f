// SPDX-License-Identifier: Apache-2.0
#include "allocation_counter.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/live/data/slope_table.hpp"
#include "ionskin/live/fmu/archive.hpp"
#include "ionskin/live/fmu/fmi2.h"
#include "ionskin/live/fmu/model_description.hpp"
#include "ionskin/live/fmu/variables.hpp"
#include "ionskin/live/skin.hpp"
#include "small_skin.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace ionskin::live {
namespace {

void ignore(fmi2ComponentEnvironment, fmi2String, fmi2Status, fmi2String, fmi2String, ...) {}

/// The functions of the FMU's library, with the small skin as its resource.
class LiveFmu : public testing::Test {
protected:
  explicit LiveFmu(const SkinData& data = small_skin()) {
    std::filesystem::create_directories(folder);
    write_skin(folder / "skin.live", data);
    callbacks.logger = ignore;
    component =
        fmi2Instantiate("skin", fmi2CoSimulation, fmu::guid(data).c_str(),
                        ("file://" + folder.string()).c_str(), &callbacks, fmi2False, fmi2False);
  }
  ~LiveFmu() override {
    fmi2FreeInstance(component);
    std::filesystem::remove_all(folder);
  }
  fmi2Status set(double x, double height) {
    const std::array<fmi2ValueReference, 2> inputs{fmu::reference::x, fmu::reference::height};
    const std::array<double, 2> values{x, height};
    return fmi2SetReal(component, inputs.data(), inputs.size(), values.data());
  }
  std::vector<double> get() {
    std::vector<double> values(references.size());
    EXPECT_EQ(fmi2GetReal(component, references.data(), references.size(), values.data()), fmi2OK);
    return values;
  }

  std::filesystem::path folder = std::filesystem::temp_directory_path() / "ionskin_fmu_test";
  fmi2CallbackFunctions callbacks{};
  fmi2Component component = nullptr;
  std::vector<fmi2ValueReference> references{fmu::reference::signals + 3,
                                             fmu::reference::signals + 11};
};

TEST_F(LiveFmu, TakesNoMemoryInTheLoop) {
  ASSERT_NE(component, nullptr);
  ASSERT_EQ(fmi2EnterInitializationMode(component), fmi2OK);
  set(2e-3, -4e-7);
  ASSERT_EQ(fmi2ExitInitializationMode(component), fmi2OK);
  fmi2FMUstate state = nullptr;
  ASSERT_EQ(fmi2GetFMUstate(component, &state), fmi2OK);
  std::vector<double> values(references.size());
  const std::size_t before = allocations();
  for (int i = 0; i < 1000; ++i) {
    const double time = 1e-3 * i;
    EXPECT_EQ(set(2e-3 + 1e-6 * i, i % 10 == 0 ? 1e-4 : -4e-7), fmi2OK);
    EXPECT_EQ(fmi2GetFMUstate(component, &state), fmi2OK);
    EXPECT_EQ(fmi2DoStep(component, time, 1e-3, fmi2False), fmi2OK);
    EXPECT_EQ(fmi2SetFMUstate(component, state), fmi2OK);
    EXPECT_EQ(fmi2DoStep(component, time, 1e-3, fmi2True), fmi2OK);
    EXPECT_EQ(fmi2GetReal(component, references.data(), references.size(), values.data()), fmi2OK);
  }
  EXPECT_EQ(allocations() - before, 0u);
  EXPECT_EQ(fmi2FreeFMUstate(component, &state), fmi2OK);
  EXPECT_EQ(fmi2FreeFMUstate(component, &state), fmi2OK);
  EXPECT_EQ(fmi2FreeFMUstate(component, nullptr), fmi2OK);
}

SkinData skin_over_friction() {
  SkinData data = small_skin();
  data.lowest_friction = 0.1;
  data.highest_friction = 0.5;
  return data;
}

class LiveFmuOverFriction : public LiveFmu {
protected:
  LiveFmuOverFriction() : LiveFmu(skin_over_friction()) {}
  fmi2Status set_friction(double coefficient) {
    const fmi2ValueReference friction = fmu::reference::friction;
    return fmi2SetReal(component, &friction, 1, &coefficient);
  }
  double friction() {
    const fmi2ValueReference reference = fmu::reference::friction;
    double value = 0;
    EXPECT_EQ(fmi2GetReal(component, &reference, 1, &value), fmi2OK);
    return value;
  }
  /// Slides at the height of a touch: the ratio of the forces along and onto the skin.
  double ratio_of_forces(int steps) {
    for (int i = 0; i < steps; ++i, ++step_) {
      set(2e-3 + 1e-5 * step_, -4e-7);
      EXPECT_EQ(fmi2DoStep(component, 1e-3 * step_, 1e-3, fmi2True), fmi2OK);
    }
    const std::vector<double> forces = get();
    return forces[1] / forces[0];
  }

  int step_ = 0;
};

TEST_F(LiveFmuOverFriction, FrictionIsAnInputWithinItsTrainedRange) {
  references = {fmu::reference::signals + 3, fmu::reference::signals + 5}; // normal and along x
  EXPECT_DOUBLE_EQ(friction(), 0.3);                                       // of the case
  ASSERT_EQ(fmi2EnterInitializationMode(component), fmi2OK);
  set(2e-3, -4e-7);
  ASSERT_EQ(fmi2ExitInitializationMode(component), fmi2OK);
  EXPECT_NEAR(ratio_of_forces(40), 0.3, 1e-3);
  EXPECT_EQ(set_friction(0.2), fmi2OK);
  EXPECT_NEAR(ratio_of_forces(40), 0.2, 1e-3);
  // A state holds it, and another is refused beyond the range.
  fmi2FMUstate state = nullptr;
  ASSERT_EQ(fmi2GetFMUstate(component, &state), fmi2OK);
  EXPECT_EQ(set_friction(0.7), fmi2Warning);
  EXPECT_DOUBLE_EQ(friction(), 0.5);
  EXPECT_NEAR(ratio_of_forces(40), 0.5, 1e-3);
  EXPECT_EQ(set_friction(-1), fmi2Warning);
  EXPECT_DOUBLE_EQ(friction(), 0.1);
  step_ -= 40;
  ASSERT_EQ(fmi2SetFMUstate(component, state), fmi2OK);
  EXPECT_DOUBLE_EQ(friction(), 0.2);
  EXPECT_NEAR(ratio_of_forces(5), 0.2, 1e-3);
  auto& numbers = *static_cast<std::vector<double>*>(state);
  const auto held = std::ranges::find(numbers, 0.2);
  ASSERT_NE(held, numbers.end());
  *held = 0.7;
  EXPECT_EQ(fmi2SetFMUstate(component, state), fmi2Error);
  fmi2FreeFMUstate(component, &state);
  EXPECT_EQ(set_friction(std::numeric_limits<double>::quiet_NaN()), fmi2OK);
  EXPECT_EQ(fmi2DoStep(component, 1e-3 * step_, 1e-3, fmi2True), fmi2Discard);
  EXPECT_EQ(set_friction(0.2), fmi2OK);
  EXPECT_EQ(fmi2DoStep(component, 1e-3 * step_, 1e-3, fmi2True), fmi2OK);
}

SkinData skin_with_angles() {
  SkinData data = small_skin();
  data.steepest = 0.02;
  data.fastest_turn = 100;
  data.turns_into_itself = 1;
  data.slopes = slope_lines(std::tan(data.steepest));
  data.lowest.assign(data.slopes.size() * data.slopes.size(), 0.0);
  return data;
}

class LiveFmuWithAngles : public LiveFmu {
protected:
  LiveFmuWithAngles() : LiveFmu(skin_with_angles()) {}
  static fmi2ValueReference reference_of(std::size_t angle) {
    return static_cast<fmi2ValueReference>(fmu::reference::signals + Skin(data()).names().size() +
                                           angle);
  }
  fmi2Status set_angles(const Skin::Angles& angles) {
    const std::array<fmi2ValueReference, 3> inputs{reference_of(0), reference_of(1),
                                                   reference_of(2)};
    return fmi2SetReal(component, inputs.data(), inputs.size(), angles.data());
  }
  static const SkinData& data() {
    static const SkinData made = skin_with_angles();
    return made;
  }
};

TEST_F(LiveFmuWithAngles, StepsATiltedAndTurningSliderAsTheSkinDoes) {
  Skin skin(data());
  std::vector<double> expected(skin.names().size());
  references.clear();
  for (std::size_t i = 0; i < expected.size(); ++i) {
    references.push_back(static_cast<fmi2ValueReference>(fmu::reference::signals + i));
  }
  const auto angles = [](int i) { return Skin::Angles{1e-5 * i, -2e-5 * i, 1e-3 * i}; };
  ASSERT_EQ(fmi2EnterInitializationMode(component), fmi2OK);
  set(2e-3, -4e-7);
  ASSERT_EQ(set_angles(angles(0)), fmi2OK);
  ASSERT_EQ(fmi2ExitInitializationMode(component), fmi2OK);
  fmi2FMUstate state = nullptr;
  std::vector<double> later;
  for (int round = 0; round < 2; ++round) {
    for (int i = round == 0 ? 0 : 10; i < 30; ++i) {
      if (i > 0) {
        set(2e-3 + 1e-6 * i, -4e-7);
        ASSERT_EQ(set_angles(angles(i)), fmi2OK);
        ASSERT_EQ(fmi2DoStep(component, 1e-3 * (i - 1), 1e-3, fmi2False), fmi2OK);
      }
      if (round == 0) {
        EXPECT_EQ(skin.step(i == 0 ? 0 : 1e-3 * (i - 1) + 1e-3, {2e-3 + 1e-6 * i, 1e-3}, angles(i),
                            false, -4e-7, expected),
                  0u);
        const std::vector<double> found = get();
        for (std::size_t k = 0; k < expected.size(); ++k) { // the instants may round otherwise
          EXPECT_NEAR(found[k], expected[k], 1e-9 * std::abs(expected[k])) << i << " " << k;
        }
      }
      if (round == 0 && i == 9) {
        ASSERT_EQ(fmi2GetFMUstate(component, &state), fmi2OK);
      }
    }
    if (round == 0) {
      later = get();
      const std::size_t moment = later.size() - 3;
      EXPECT_GT(std::abs(later[moment + 1]), 0);
      EXPECT_GT(std::abs(later[moment + 2]), 0); // it turns in contact
      ASSERT_EQ(fmi2SetFMUstate(component, state), fmi2OK);
      const fmi2ValueReference yaw = reference_of(2);
      double held = 0;
      ASSERT_EQ(fmi2GetReal(component, &yaw, 1, &held), fmi2OK);
      EXPECT_DOUBLE_EQ(held, angles(9)[2]); // a state holds the angles
    }
  }
  EXPECT_EQ(get(), later);
  fmi2FreeFMUstate(component, &state);
}

TEST_F(LiveFmuWithAngles, SaysWhatWasNotTrained) {
  ASSERT_EQ(fmi2EnterInitializationMode(component), fmi2OK);
  set(2e-3, -4e-7);
  ASSERT_EQ(fmi2ExitInitializationMode(component), fmi2OK);
  const fmi2ValueReference flags = fmu::reference::flags;
  fmi2Integer raised = 0;
  ASSERT_EQ(set_angles({0, 0.03, 0}), fmi2OK);
  ASSERT_EQ(fmi2DoStep(component, 0, 1e-3, fmi2False), fmi2OK);
  ASSERT_EQ(fmi2GetInteger(component, &flags, 1, &raised), fmi2OK);
  EXPECT_NE(static_cast<std::uint32_t>(raised) & flag::outside_pose, 0u);
  const std::vector<double> before = get();
  for (const double wrong : {std::numeric_limits<double>::quiet_NaN(), 1e7}) {
    ASSERT_EQ(set_angles({0, 0, wrong}), fmi2OK);
    EXPECT_EQ(fmi2DoStep(component, 1e-3, 1e-3, fmi2False), fmi2Discard);
    EXPECT_EQ(get(), before);
  }
  ASSERT_EQ(set_angles({0, 0, 0}), fmi2OK);
  EXPECT_EQ(fmi2DoStep(component, 1e-3, 1e-3, fmi2False), fmi2OK);
}

TEST_F(LiveFmu, OfAnUprightSkinHasNoAngles) {
  const auto behind =
      static_cast<fmi2ValueReference>(fmu::reference::signals + Skin(small_skin()).names().size());
  const double value = 0;
  EXPECT_EQ(fmi2SetReal(component, &behind, 1, &value), fmi2Error);
  EXPECT_TRUE(fmu::trained_angles(small_skin()).empty());
  SkinData tilted = skin_with_angles();
  tilted.fastest_turn = 0;
  const std::vector<fmu::Variable> list = fmu::variables(tilted);
  EXPECT_EQ(list.back().name, "pitch");
  EXPECT_EQ(list.back().unit, "rad");
}

TEST_F(LiveFmu, TakesUpStatesOfAnyBytes) {
  ASSERT_EQ(fmi2EnterInitializationMode(component), fmi2OK);
  set(2e-3, -4e-7);
  ASSERT_EQ(fmi2ExitInitializationMode(component), fmi2OK);
  const std::vector<double> expected = get();
  fmi2FMUstate state = nullptr;
  ASSERT_EQ(fmi2GetFMUstate(component, &state), fmi2OK);
  std::size_t size = 0;
  ASSERT_EQ(fmi2SerializedFMUstateSize(component, state, &size), fmi2OK);
  std::vector<fmi2Byte> bytes(size);
  EXPECT_EQ(fmi2SerializeFMUstate(component, state, bytes.data(), size - 1), fmi2Error);
  ASSERT_EQ(fmi2SerializeFMUstate(component, state, bytes.data(), size), fmi2OK);
  for (std::size_t at = fmu::guid(small_skin()).size(); at < size; ++at) {
    std::vector<fmi2Byte> damaged = bytes;
    damaged[at] = static_cast<fmi2Byte>(~damaged[at]);
    fmi2FMUstate other = nullptr;
    ASSERT_EQ(fmi2DeSerializeFMUstate(component, damaged.data(), size, &other), fmi2OK);
    if (fmi2SetFMUstate(component, other) == fmi2OK) {
      set(3e-3, -4e-7);
      fmi2DoStep(component, 0, 1e-3, fmi2True); // ends, whatever it says
    }
    fmi2FreeFMUstate(component, &other);
  }
  ASSERT_EQ(fmi2SetFMUstate(component, state), fmi2OK);
  EXPECT_EQ(get(), expected);
  fmi2FreeFMUstate(component, &state);
}

TEST_F(LiveFmu, RefusesStatesWithNumbersThatAreNotFinite) {
  ASSERT_EQ(fmi2EnterInitializationMode(component), fmi2OK);
  set(2e-3, -4e-7);
  ASSERT_EQ(fmi2ExitInitializationMode(component), fmi2OK);
  const std::vector<double> expected = get();
  fmi2FMUstate state = nullptr;
  ASSERT_EQ(fmi2GetFMUstate(component, &state), fmi2OK);
  std::size_t size = 0;
  ASSERT_EQ(fmi2SerializedFMUstateSize(component, state, &size), fmi2OK);
  std::vector<fmi2Byte> bytes(size);
  ASSERT_EQ(fmi2SerializeFMUstate(component, state, bytes.data(), size), fmi2OK);
  for (std::size_t at = fmu::guid(small_skin()).size(); at < size; at += sizeof(double)) {
    for (const double value :
         {std::numeric_limits<double>::quiet_NaN(), -std::numeric_limits<double>::infinity()}) {
      std::vector<fmi2Byte> damaged = bytes;
      std::memcpy(damaged.data() + at, &value, sizeof value);
      fmi2FMUstate other = nullptr;
      ASSERT_EQ(fmi2DeSerializeFMUstate(component, damaged.data(), size, &other), fmi2OK);
      EXPECT_EQ(fmi2SetFMUstate(component, other), fmi2Error) << value << " at byte " << at;
      EXPECT_EQ(get(), expected);
      fmi2FreeFMUstate(component, &other);
    }
  }
  EXPECT_EQ(fmi2DoStep(component, 0, 1e-3, fmi2True), fmi2OK);
  fmi2FreeFMUstate(component, &state);
}

TEST_F(LiveFmu, IsNotWrittenWithoutItsLibrary) {
  EXPECT_THROW(fmu::write_fmu(folder / "skin.fmu", small_skin(), folder / "none.so"), UserError);
  EXPECT_THROW(fmu::write_fmu(folder / "no" / "skin.fmu", small_skin(), folder / "skin.live"),
               UserError);
  EXPECT_FALSE(std::filesystem::exists(folder / "skin.fmu"));
}

} // namespace
} // namespace ionskin::live
