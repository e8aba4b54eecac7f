// SPDX-License-Identifier: Apache-2.0
#include "ionskin/units/quantity.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/nearest_name.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

namespace ionskin::units {
namespace {

using testing::HasSubstr;

struct Good {
  const char* text;
  Dimension dimension;
  double value;
};

class GoodQuantity : public testing::TestWithParam<Good> {};

TEST_P(GoodQuantity, ConvertsToSi) {
  const Good& good = GetParam();
  EXPECT_NEAR(parse_quantity(good.text, good.dimension), good.value, 1e-14 * std::abs(good.value))
      << good.text;
}

INSTANTIATE_TEST_SUITE_P(
    Table, GoodQuantity,
    testing::Values(
        Good{"15 mm", Dimension::length, 0.015}, Good{"15mm", Dimension::length, 0.015},
        Good{" +1.5e1  mm ", Dimension::length, 0.015}, Good{"-3 um", Dimension::length, -3e-6},
        Good{"3 µm", Dimension::length, 3e-6}, Good{"0 m", Dimension::length, 0},
        Good{"2 min", Dimension::time, 120}, Good{"10 ms", Dimension::time, 0.01},
        Good{"20 degC", Dimension::temperature, 293.15},
        Good{"20 °C", Dimension::temperature, 293.15},
        Good{"68 degF", Dimension::temperature, 293.15},
        Good{"293.15 K", Dimension::temperature, 293.15}, Good{"249 MPa", Dimension::stress, 249e6},
        Good{"1 N/mm2", Dimension::stress, 1e6}, Good{"7e-11 m2/s", Dimension::diffusivity, 7e-11},
        Good{"7e-7 cm^2/s", Dimension::diffusivity, 7e-11},
        Good{"2 mF/m", Dimension::permittivity, 2e-3},
        Good{"1200 mol/m3", Dimension::concentration, 1200},
        Good{"1.2 M", Dimension::concentration, 1200},
        Good{"1200 mM", Dimension::concentration, 1200},
        Good{"1.2 mol/L", Dimension::concentration, 1200},
        Good{"1 MOhm", Dimension::resistance, 1e6}, Good{"4.7 kΩ", Dimension::resistance, 4700},
        Good{"0.01Hz", Dimension::frequency, 0.01}, Good{"1kHz", Dimension::frequency, 1e3},
        Good{"2 1/s", Dimension::frequency, 2}, Good{"10 mA", Dimension::current, 0.01},
        Good{"0.5 ohm/sq", Dimension::resistance, 0.5},
        Good{"20 mOhm/square", Dimension::resistance, 0.02},
        Good{"8 nV/sqrt(Hz)", Dimension::voltage_noise_density, 8e-9},
        Good{"5 pA/sqrt(Hz)", Dimension::current_noise_density, 5e-12},
        Good{"5 fA/√Hz", Dimension::current_noise_density, 5e-15},
        Good{"3 m**2/s", Dimension::diffusivity, 3}, Good{"3 m2.s-1", Dimension::diffusivity, 3},
        Good{"3 m^+2 s^-1", Dimension::diffusivity, 3}, Good{"3 (m2)/s", Dimension::diffusivity, 3},
        Good{"3 (m)2/s", Dimension::diffusivity, 3}, Good{"4 Ω2/Ohm", Dimension::resistance, 4},
        Good{"0.3", Dimension::number, 0.3}, Good{"30 %", Dimension::number, 0.3},
        Good{"30 percent", Dimension::number, 0.3},
        Good{"180 deg", Dimension::angle, 3.14159265358979324},
        Good{"-2 mrad", Dimension::angle, -2e-3},
        Good{"90 degrees", Dimension::angle, 1.57079632679489662}));

struct Bad {
  const char* text;
  Dimension dimension;
  std::vector<const char*> fragments;
};

class BadQuantity : public testing::TestWithParam<Bad> {};

TEST_P(BadQuantity, SaysWhatIsWrong) {
  const Bad& bad = GetParam();
  try {
    const double value = parse_quantity(bad.text, bad.dimension);
    FAIL() << bad.text << " was read as " << value;
  } catch (const UserError& error) {
    for (const char* fragment : bad.fragments)
      EXPECT_THAT(error.what(), HasSubstr(fragment));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Table, BadQuantity,
    testing::Values(
        Bad{"15", Dimension::length, {"missing unit in \"15\"", "a length such as \"mm\""}},
        Bad{"2 s",
            Dimension::length,
            {"wrong dimension", "expected a length such as \"mm\"", "got a time"}},
        Bad{"2 m3", Dimension::length, {"wrong dimension", "got a volume"}},
        Bad{"2 1/s", Dimension::time, {"wrong dimension", "got a frequency"}},
        Bad{"2 kg m", Dimension::time, {"wrong dimension", "got a quantity in m.kg"}},
        Bad{"20 C", Dimension::temperature, {"got an electric charge", "did you mean \"degC\"?"}},
        Bad{"15 mn", Dimension::length, {"unknown unit \"mn\"", "did you mean \"mm\"?"}},
        Bad{"15 furlongsandmore", Dimension::length, {"unknown unit", "expected a length"}},
        Bad{"mm", Dimension::length, {"does not begin with a number"}},
        Bad{"", Dimension::length, {"does not begin with a number"}},
        Bad{"nan mm", Dimension::length, {"does not begin with a number"}},
        Bad{"inf mm", Dimension::length, {"does not begin with a number"}},
        Bad{"1e999 mm", Dimension::length, {"too large"}},
        Bad{"1e308 Mm", Dimension::length, {"too large"}},
        Bad{"1,5 mm", Dimension::length, {"\"1,5 mm\" has a comma", "write a decimal point"}},
        Bad{"4,500.0 um", Dimension::length, {"has a comma", "without marks"}},
        Bad{"10 3 mm", Dimension::length, {"unknown unit \"3 mm\""}},
        Bad{"10 mm 3", Dimension::length, {"unknown unit \"mm 3\""}},
        Bad{"10 mm*3", Dimension::length, {"unknown unit"}},
        Bad{"5 1/2 mm", Dimension::length, {"unknown unit"}},
        Bad{"5 2/s", Dimension::frequency, {"unknown unit"}},
        Bad{"5 1/2", Dimension::number, {"unknown unit"}},
        Bad{"5 (0.1)", Dimension::number, {"unknown unit"}},
        Bad{"5 % %", Dimension::number, {"unknown unit \"% %\""}},
        Bad{"5 %%", Dimension::number, {"unknown unit"}},
        Bad{"5 %2", Dimension::number, {"unknown unit"}},
        Bad{"5 % m/m", Dimension::number, {"unknown unit"}},
        Bad{"5 percent percent", Dimension::number, {"unknown unit"}},
        Bad{"5 %", Dimension::angle, {"wrong dimension", "expected an angle such as \"deg\""}},
        Bad{"5 mm", Dimension::angle, {"expected an angle", "got a length"}},
        Bad{"5", Dimension::angle, {"missing unit", "expected an angle"}},
        Bad{"5 deg", Dimension::length, {"expected a length", "got an angle"}},
        Bad{"5 m %", Dimension::length, {"unknown unit"}},
        Bad{"10 m @ 3", Dimension::length, {"unknown unit"}},
        Bad{"3 s since 1970", Dimension::time, {"unknown unit"}},
        Bad{"3 mm",
            Dimension::number,
            {"wrong dimension", "expected a pure number", "got a length"}}));

TEST(Quantity, ReadsTheSameInManyThreads) {
  std::atomic<int> wrong = 0;
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i)
    threads.emplace_back([&wrong] {
      for (int j = 0; j < 200; ++j)
        wrong += parse_quantity("20 degC", Dimension::temperature) != 293.15 ||
                 parse_quantity("4 mm", Dimension::length) != 0.004;
    });
  for (std::thread& thread : threads)
    thread.join();
  EXPECT_EQ(wrong, 0);
}

TEST(Quantity, FormatsWithItsUnit) {
  EXPECT_EQ(format_si(0.015, Dimension::length), "0.015 m");
  EXPECT_EQ(format_si(0.3, Dimension::number), "0.3");
}

TEST(Dimension, EveryExampleUnitIsAMultipleOfThatOfSI) {
  for (const Dimension dimension : all_dimensions()) {
    for (const std::string& unit : dimension_info(dimension).examples) {
      const double none = parse_quantity("0 " + unit, dimension);
      const double one = parse_quantity("1 " + unit, dimension) - none;
      EXPECT_NEAR(none,
                  unit == "degC"   ? 273.15
                  : unit == "degF" ? 459.67 * 5 / 9
                                   : 0,
                  1e-9)
          << unit;
      EXPECT_GT(one, 0) << unit;
      EXPECT_NEAR(parse_quantity("3 " + unit, dimension) - none, 3 * one,
                  1e-12 * one + 1e-13 * none);
      if (unit == dimension_info(dimension).si_unit) {
        EXPECT_EQ(one, 1) << unit;
      }
    }
  }
}

TEST(NearestName, FindsMisspellingsAndNothingElse) {
  EXPECT_EQ(base::nearest_name("frction", {"law", "friction"}), "friction");
  EXPECT_EQ(base::nearest_name("prelaod", {"stroke", "preload"}), "preload");
  EXPECT_EQ(base::nearest_name("colour", {"law", "friction"}), "");
  EXPECT_EQ(base::edit_distance("slide", "sldie"), 1U);
  EXPECT_EQ(base::edit_distance("", "abc"), 3U);
}

} // namespace
} // namespace ionskin::units
