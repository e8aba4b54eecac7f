// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/reading/read_case.hpp"

#include "temporary_case.hpp"

#include <gtest/gtest.h>

#include <locale>

namespace ionskin {
namespace {

/// Locale of a German or Indian host: decimal commas, and dots that group thousands.
struct Commas : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

class HostWithCommas {
public:
  HostWithCommas() : before_(std::locale::global(std::locale(std::locale(), new Commas))) {}
  ~HostWithCommas() { std::locale::global(before_); }
  HostWithCommas(const HostWithCommas&) = delete;
  HostWithCommas& operator=(const HostWithCommas&) = delete;

private:
  std::locale before_;
};

TEST(Locale, OfTheHostDoesNotChangeNumbers) {
  const TemporaryCase file(valid_case());
  const std::vector<std::string> edits = {"coupling.coefficient=1_234.5e-4",
                                          "motion.preload=1.5 um", "motion.direction=[0.6, -0.8]",
                                          "motion.stroke=0.3 mm", "slider.edge_radius=0.1 mm"};
  const Case here = read_case(file.path(), edits);
  const HostWithCommas host;
  const Case there = read_case(file.path(), edits);
  EXPECT_EQ(there.coupling.coefficient, here.coupling.coefficient);
  EXPECT_EQ(there.contact.friction, here.contact.friction);
  EXPECT_EQ(there.motion.preload, here.motion.preload);
  EXPECT_EQ(there.motion.direction, here.motion.direction);
  EXPECT_EQ(there.values, here.values);
}

} // namespace
} // namespace ionskin
