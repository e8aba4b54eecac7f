// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/errors/convergence.hpp"

#include <gtest/gtest.h>

namespace ionskin::study {
namespace {

Signals with_current(const std::vector<double>& current) {
  Signals signals;
  for (const char* name :
       {"current_top", "current_bottom", "current_difference", "current_common"}) {
    signals.resolved.columns.push_back({name, "A", current});
    signals.metrics.push_back({std::string("peak_") + name, 1, "A"});
  }
  signals.metrics.push_back({"element_max_shear_slide", 0.1, "1"});
  return signals;
}

TEST(Convergence, LargestValuesUnderSharpEdgesHaveNoLimit) {
  const Signals signals = with_current({0, 1, 1, 1});
  MechanicsRecord mechanics;
  EXPECT_FALSE(not_converging(mechanics, signals, {}).contains("element_max_shear_slide"));
  mechanics.sharp_edge = true;
  EXPECT_TRUE(not_converging(mechanics, signals, {}).contains("element_max_shear_slide"));
}

TEST(Convergence, AnExtremeThatAMeshDoesNotResolveHasNoError) {
  const Signals signals = with_current({0, 1, 1, 1});
  const std::string name = "element_max_shear_slide";
  EXPECT_TRUE(not_converging({}, signals, {{name, 0.4}}).contains(name));
  EXPECT_FALSE(not_converging({}, signals, {{name, 0.3}}).contains(name));
  EXPECT_FALSE(not_converging({}, signals, {{"stick_fraction_touchdown", 3}})
                   .contains("stick_fraction_touchdown"));
}

TEST(Convergence, AnOnsetThatAMeshDoesNotResolveIsMarked) {
  Signals signals = with_current({0, 1, 1, 1});
  for (const char* name : {"micro_slip_time", "precursor_current_common"}) {
    signals.metrics.push_back({name, 1e-3, "1"});
    EXPECT_TRUE(not_converging({}, signals, {{name, 0.4}}).contains(name));
    EXPECT_FALSE(not_converging({}, signals, {{name, 0.3}}).contains(name));
  }
}

TEST(Convergence, ASpikeOfOneStepHasNoPeak) {
  EXPECT_EQ(not_converging({}, with_current({0, 0, -5, 1, 0}), {}).size(), 4u);
  EXPECT_TRUE(not_converging({}, with_current({0, 3, -5, 1, 0}), {}).empty());
}

TEST(Convergence, APeakWhoseErrorIsLargerThanItselfIsMarked) {
  const Signals signals = with_current({0, 3, -5, 3, 0});
  const std::string name = "peak_current_top";
  EXPECT_TRUE(not_converging({}, signals, {{name, 1.1}}).contains(name));
  EXPECT_FALSE(not_converging({}, signals, {{name, 0.9}}).contains(name));
  EXPECT_FALSE(not_converging({}, signals, {{"rms_current_top", 1.1}}).contains("rms_current_top"));
}

} // namespace
} // namespace ionskin::study
