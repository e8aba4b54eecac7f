// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/sweep/sweep_table.hpp"

#include <gtest/gtest.h>

namespace ionskin::study {
namespace {

TEST(SweepTable, OneRowPerPointWithUnitsAndReasons) {
  std::vector<SweepPoint> points(3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i].name = "000" + std::to_string(i + 1);
    points[i].values = {{"motion.preload", "1 um", "1e-06", "m"},
                        {"coupling.law", "fixed-charge", "fixed-charge", ""}};
  }
  const std::vector<PointState> states{{PointStatus::failed, "a \"bad\", sad end", {}},
                                       {PointStatus::finished, "", {{"force", 0.1, "N"}}},
                                       {}};
  EXPECT_EQ(sweep_table_text(points, states),
            "point,folder,motion.preload [m],coupling.law,status,reason,force [N]\n"
            "1,points/0001,1e-06,fixed-charge,failed,\"a \"\"bad\"\", sad end\",\n"
            "2,points/0002,1e-06,fixed-charge,finished,,0.1\n"
            "3,points/0003,1e-06,fixed-charge,pending,,\n");
}

} // namespace
} // namespace ionskin::study
