// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/document/materials.hpp"
#include "ionskin/case/reading/read_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace ionskin {
namespace {

const std::string cases = IONSKIN_CASES;

TEST(CaseFiles, PaperIsTheBaseline) {
  const Case input = read_case(cases + "/paper.toml");
  EXPECT_EQ(input.motion.cycles, 3);
  EXPECT_EQ(input.contact.friction, 0.3);
  EXPECT_EQ(input.numerics.preset, Preset::standard);
  EXPECT_DOUBLE_EQ(input.skin.thickness(), 200e-6);
  EXPECT_DOUBLE_EQ(input.skin.layers[0].material.youngs_modulus, 168e9);
  EXPECT_DOUBLE_EQ(input.electrochemistry.fixed_charge_concentration, 1200);
  EXPECT_EQ(input.coupling.coefficient, 0.1);
}

TEST(CaseFiles, QuickIsTheSameSkinAtThePresetCoarse) {
  const Case quick = read_case(cases + "/paper/coarse.toml");
  const Case paper = read_case(cases + "/paper.toml");
  EXPECT_EQ(quick.numerics.preset, Preset::coarse);
  EXPECT_EQ(quick.motion.cycles, 1);
  EXPECT_EQ(quick.skin.core_volume(), paper.skin.core_volume());
  EXPECT_EQ(quick.motion.stroke, paper.motion.stroke);
  EXPECT_DOUBLE_EQ(quick.electrochemistry.temperature, paper.electrochemistry.temperature);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(quick.skin.layers[i].material.youngs_modulus,
              paper.skin.layers[i].material.youngs_modulus);
}

TEST(CaseFiles, PresetsAreInstalled) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(cases + "/../materials")) {
    files.push_back(entry.path().stem());
  }
  std::ranges::sort(files);
  EXPECT_EQ(installed_materials(), files);
  EXPECT_TRUE(std::ranges::binary_search(files, "nafion_wet"));
}

} // namespace
} // namespace ionskin
