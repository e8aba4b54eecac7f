// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/text/csv_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace ionskin {
namespace {

class CsvFileTest : public testing::Test {
protected:
  void write(const std::string& text) { std::ofstream(path) << text; }
  void TearDown() override { std::filesystem::remove(path); }

  std::string path = testing::TempDir() + "ionskin_csv_file_test.csv";
};

TEST_F(CsvFileTest, GivesCellsAndTheirLine) {
  write("# a remark\n\ntime [ms], \"x\" [mm] \r\n 1,2\n,,\n3,");
  CsvFile file(path, "data");
  const auto header = file.next();
  ASSERT_TRUE(header);
  EXPECT_EQ(file.line(), 3U);
  EXPECT_EQ(header->text, "time [ms], \"x\" [mm] \r");
  EXPECT_EQ(header->cells.front(), "time [ms]");
  EXPECT_EQ(file.next()->cells, (std::vector<std::string>{"1", "2"}));
  EXPECT_EQ(file.next()->cells, (std::vector<std::string>{"", "", ""}));
  EXPECT_EQ(file.next()->cells, (std::vector<std::string>{"3", ""}));
  EXPECT_FALSE(file.next());
  EXPECT_EQ(file.line(), 6U);
}

TEST_F(CsvFileTest, OfNothingHasNoRow) {
  write("");
  CsvFile file(path, "data");
  EXPECT_FALSE(file.next());
  EXPECT_EQ(file.line(), 1U);
}

TEST(CsvTitle, DividesNameAndUnit) {
  EXPECT_EQ(csv_title("time [ ms ]").name, "time");
  EXPECT_EQ(csv_title("time [ ms ]").unit, "ms");
  EXPECT_EQ(csv_title("time").name, "time");
  EXPECT_FALSE(csv_title("time").unit);
  EXPECT_FALSE(csv_title("time ]s[").unit);
}

} // namespace
} // namespace ionskin
