// SPDX-License-Identifier: Apache-2.0
#include "ionskin/laws/coupling/coupling_law.hpp"
#include "ionskin/laws/friction/friction_law.hpp"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>

namespace ionskin::laws {
namespace {

struct TwoParameters {
  double coefficient = 0, strength = 0, slip_length = 0;

  static constexpr auto parameters() {
    return std::array{
        OwnParameter<TwoParameters>{{.name = "strength", .dimension = units::Dimension::stress},
                                    &TwoParameters::strength},
        OwnParameter<TwoParameters>{{.name = "slip_length", .dimension = units::Dimension::length},
                                    &TwoParameters::slip_length}};
  }
};

TEST(LawParameters, AreDeclaredInOrderAndReachTheirMembers) {
  const auto declared = declared_parameters<TwoParameters>();
  ASSERT_EQ(declared.size(), 2);
  EXPECT_EQ(declared[0].name, "strength");
  EXPECT_EQ(declared[1].dimension, units::Dimension::length);
  const auto law = law_with<TwoParameters>(0.3, {{"slip_length", 1e-6}, {"strength", 4e6}});
  EXPECT_EQ(law.coefficient, 0.3);
  EXPECT_EQ(law.strength, 4e6);
  EXPECT_EQ(law.slip_length, 1e-6);
  EXPECT_THROW(law_with<TwoParameters>(0.3, {{"strength", 4e6}}), std::out_of_range);
}

TEST(LawParameters, BelongToTheirLaw) {
  EXPECT_FALSE(has_parameter(friction_laws(), "coulomb", "strength"));
  EXPECT_FALSE(has_parameter(coupling_laws(), "nothing", "strength"));
}

/// A parameter of one law must not take the key of something else, or have another help and range
/// than the same one of another law.
template <class Law> void expect_sane(std::span<const Law> table) {
  for (const Law& law : table) {
    for (const LawParameter& parameter : law.parameters) {
      EXPECT_NE(parameter.name, "law");
      EXPECT_NE(parameter.name, "friction");
      EXPECT_NE(parameter.name, "coefficient");
      EXPECT_NE(parameter.name, "measure");
      EXPECT_LT(parameter.lowest, parameter.highest) << parameter.name;
      EXPECT_FALSE(parameter.help.empty()) << parameter.name;
      for (const Law& other : table) {
        for (const LawParameter& same : other.parameters) {
          if (same.name == parameter.name) {
            EXPECT_EQ(same.help, parameter.help) << same.name;
            EXPECT_EQ(same.dimension, parameter.dimension) << same.name;
            EXPECT_EQ(same.lowest, parameter.lowest) << same.name;
            EXPECT_EQ(same.highest, parameter.highest) << same.name;
            EXPECT_EQ(same.default_value, parameter.default_value) << same.name;
          }
        }
      }
    }
  }
}

TEST(LawParameters, AreSaneInAllTables) {
  expect_sane(friction_laws());
  expect_sane(coupling_laws());
}

} // namespace
} // namespace ionskin::laws
