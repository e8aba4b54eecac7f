// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/error.hpp"
#include "ionskin/case/case.hpp"

#include <gtest/gtest.h>

namespace ionskin {
namespace {

TEST(Skin, MeasuresItsCore) {
  Skin skin;
  skin.length = 3;
  skin.width = 2;
  skin.layers = {{"bottom", LayerRole::electrode, {}, 0.25},
                 {"extra", LayerRole::electrode, {}, 0.5},
                 {"core", LayerRole::core, {}, 4},
                 {"top", LayerRole::electrode, {}, 0.125}};
  EXPECT_EQ(skin.thickness(), 4.875);
  EXPECT_EQ(skin.core_index(), 2U);
  EXPECT_EQ(skin.core_bottom(), 0.75);
  EXPECT_EQ(skin.core_thickness(), 4);
  EXPECT_EQ(skin.core_volume(), 24);
}

TEST(Skin, WithoutACoreIsAnInternalError) {
  const Skin skin;
  EXPECT_THROW(skin.core_index(), InternalError);
}

} // namespace
} // namespace ionskin
