// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/schema/schema.hpp"

#include "ionskin/base/error.hpp"

#include <gtest/gtest.h>

#include <set>

namespace ionskin {
namespace {

TEST(Schema, KeysAreUniqueAndExplained) {
  std::set<std::string> keys;
  for (const SchemaRow& row : schema()) {
    EXPECT_TRUE(keys.insert(row.key).second) << row.key;
    EXPECT_FALSE(row.help.empty()) << row.key;
    EXPECT_TRUE(row.set) << row.key;
    EXPECT_EQ(find_row(row.key), &row);
  }
}

TEST(Schema, OptionalKeysHaveDefaultsAndOthersHaveNone) {
  for (const SchemaRow& row : schema())
    EXPECT_EQ(row.need == Need::optional, !row.default_value.empty()) << row.key;
}

TEST(Schema, ChoicesHaveNamesAndOtherTypesHaveNone) {
  for (const SchemaRow& row : schema())
    EXPECT_EQ(row.type == ValueType::choice, !row.choices.empty()) << row.key;
}

TEST(Schema, EveryChoiceOfThisVersionCanBeSet) {
  for (const SchemaRow& row : schema())
    for (const Choice& choice : row.choices) {
      CaseDraft draft;
      draft.input.skin.layers.resize(1);
      draft.input.readout.taxels.resize(1);
      if (choice.in_this_version)
        EXPECT_NO_THROW(row.set(draft, {}, {choice.name, {}})) << row.key << " " << choice.name;
      else
        EXPECT_THROW(row.set(draft, {}, {choice.name, {}}), InternalError) << row.key;
    }
}

TEST(Schema, KeysFollowPatterns) {
  EXPECT_EQ(key_pattern("contact.friction"), "contact.friction");
  EXPECT_EQ(key_pattern("skin.layers[12].thickness"), "skin.layers[].thickness");
  EXPECT_EQ(key_pattern("materials.nafion.youngs_modulus"), "materials.NAME.youngs_modulus");
}

TEST(Range, EndsBelongOrNot) {
  const Range range{0.0, 0.5, true, false};
  EXPECT_TRUE(range.contains(0.0));
  EXPECT_FALSE(range.contains(0.5));
  EXPECT_FALSE(range.contains(-1e-300));
  EXPECT_EQ(describe(range, units::Dimension::number), "at least 0 and below 0.5");
  EXPECT_EQ(describe({0.0, Range{}.upper, false, false}, units::Dimension::length), "above 0 m");
  EXPECT_EQ(describe(Range{}, units::Dimension::length), "any finite value");
}

} // namespace
} // namespace ionskin
