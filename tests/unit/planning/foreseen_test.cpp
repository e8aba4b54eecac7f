// SPDX-License-Identifier: Apache-2.0
#include "ionskin/planning/foreseen.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/case/reading/read_case.hpp"
#include "ionskin/planning/contact_estimate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace ionskin::planning {
namespace {

using testing::Contains;
using testing::HasSubstr;

Case quick_case(const std::vector<std::string>& edits = {}) {
  return read_case(IONSKIN_CASES "/paper/coarse.toml", edits);
}

std::vector<std::string> of(const std::vector<std::string>& edits) {
  return foreseen(quick_case(edits));
}

/// The message of the refusal, or empty.
std::string refusal(const std::vector<std::string>& edits) {
  try {
    foreseen(quick_case(edits));
  } catch (const UserError& error) {
    return error.what();
  }
  return "";
}

// A run finds a mean pressure of 14.5 MPa while it slides, and a shear of 0.09 at its 99th
// percentile over the core.
TEST(ContactEstimate, BracketsWhatARunFinds) {
  const ContactEstimate estimate = estimate_contact(quick_case());
  EXPECT_GT(estimate.pressure, 14.5e6);
  EXPECT_LT(estimate.pressure, 30e6);
  EXPECT_GT(estimate.least_shear, 0.02);
  EXPECT_LT(estimate.least_shear, 0.05);
  EXPECT_GT(estimate.shear, 0.07);
}

TEST(ContactEstimate, IsSureOfNothingButARigidFlatSlider) {
  EXPECT_EQ(estimate_contact(quick_case({"slider.shape=sphere", "slider.radius=3 mm"})).least_shear,
            0);
  EXPECT_EQ(
      estimate_contact(quick_case({"slider.youngs_modulus=1 MPa", "slider.poissons_ratio=0.4"}))
          .least_shear,
      0);
  const double whole = estimate_contact(quick_case()).least_shear;
  EXPECT_LT(estimate_contact(quick_case({"motion.stroke=1 nm"})).least_shear, 0.01 * whole);
  EXPECT_EQ(estimate_contact(quick_case({"motion.stroke=0 mm"})).least_shear, 0);
}

TEST(Foreseen, IsNothingForSoundCases) {
  EXPECT_TRUE((of({})).empty());
  EXPECT_TRUE((of({"coupling.coefficient=-10"})).empty());
  EXPECT_TRUE((of({"coupling.coefficient=20"})).empty());
}

TEST(Foreseen, AFixedChargeBelowZeroIsWarnedOfAndFarBelowRefused) {
  for (const char* law : {"fixed-charge", "volume-neutral", "pair-generation"}) {
    const std::string chosen = std::string("coupling.law=") + law;
    EXPECT_THAT(of({chosen, "coupling.coefficient=-20"}), Contains(HasSubstr("becomes negative")))
        << law;
    EXPECT_THAT(refusal({chosen, "coupling.coefficient=-50"}), HasSubstr("now -50")) << law;
  }
  EXPECT_THAT(of({"coupling.law=column-neutral", "coupling.coefficient=50"}),
              Contains(HasSubstr("becomes negative")));
  EXPECT_THAT(of({"coupling.measure=signed-xz", "coupling.coefficient=-50"}),
              Contains(HasSubstr("becomes negative")))
      << "of either sign, so nothing is sure";
}

TEST(Foreseen, ANetChargeThatNothingScreensIsWarnedOfAndFarBeyondRefused) {
  EXPECT_THAT(of({"coupling.coefficient=50"}), Contains(HasSubstr("no sane solution")));
  EXPECT_THAT(refusal({"coupling.coefficient=200"}), HasSubstr("no sane solution"));
}

TEST(Foreseen, ReleasedIonsWithoutRoom) {
  const std::vector<std::string> steric = {"electrochemistry.ion_model=steric",
                                           "coupling.law=pair-generation"};
  auto full = steric, roomy = steric, tight = steric;
  full.emplace_back("electrochemistry.largest_concentration=1201 mol/m3");
  tight.emplace_back("electrochemistry.largest_concentration=1208 mol/m3");
  roomy.emplace_back("electrochemistry.largest_concentration=2000 mol/m3");
  EXPECT_THAT(refusal(full), HasSubstr("more cations than there is room for"));
  EXPECT_THAT(of(tight), Contains(HasSubstr("more cations than there is room for")));
  EXPECT_TRUE((of(roomy)).empty());
}

TEST(Foreseen, WhatShowsNothing) {
  EXPECT_THAT(of({"coupling.coefficient=0"}), Contains(HasSubstr("no current will flow")));
  EXPECT_THAT(of({"readout.sample_interval=3.9 s"}), Contains(HasSubstr("within one sample")));
  EXPECT_THAT(of({"electrochemistry.diffusivity=1e-18 m2/s"}),
              Contains(HasSubstr("the ions hardly move")));
  EXPECT_THAT(of({"motion.preload=100 um"}), Contains(HasSubstr("50 % of the skin's thickness")));
}

TEST(Foreseen, IsNothingForTheInstalledCases) {
  for (const auto& entry : std::filesystem::directory_iterator(IONSKIN_CASES)) {
    if (entry.path().extension() != ".toml" || entry.path().stem() == "strain_file")
      continue; // its strain is made by a script
    EXPECT_TRUE((foreseen(read_case(entry.path().string()))).empty()) << entry.path();
  }
}

} // namespace
} // namespace ionskin::planning
