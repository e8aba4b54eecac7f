// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/text/csv_file.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/case/text/csv_table.hpp"
#include "ionskin/case/text/number_table.hpp"
#include "scratch_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace ionskin {
namespace {

using testing::HasSubstr;
using Rows = std::vector<std::vector<std::string>>;

class CsvFileTest : public testing::Test {
protected:
  void write(const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

  template <class Reader> Rows rest(Reader& file) {
    Rows rows;
    while (auto row = file.next())
      rows.push_back(*row);
    return rows;
  }
  Rows rows(const std::string& text) {
    write(text);
    CsvFile file(path, "data");
    return rest(file);
  }
  Rows table(const std::string& text) {
    write(text);
    CsvTable file(path, "data");
    return rest(file);
  }
  template <class Read> std::string refusal(Read read) {
    try {
      read();
    } catch (const UserError& error) {
      return error.what();
    }
    return "accepted";
  }

  // Shards of these tests run side by side, so that each takes a folder of its own.
  results::ScratchFolder folder;
  std::string path = (folder / "test.csv").string();
};

TEST_F(CsvFileTest, GivesCellsAndTheirLine) {
  write("# a remark\n\ntime [ms], \"x\" [mm] \r\n 1,2\n,,\n3,");
  CsvFile file(path, "data");
  const auto header = file.next();
  ASSERT_TRUE(header);
  EXPECT_EQ(file.line(), 3U);
  EXPECT_EQ(*header, (std::vector<std::string>{"time [ms]", "x [mm]"}));
  EXPECT_EQ(rest(file), (Rows{{"1", "2"}, {"3", ""}}));
  EXPECT_EQ(file.line(), 6U);
}

TEST_F(CsvFileTest, RecordingsKeepNanosecondsOfAnEpoch) {
  // A header behind #, beside a remark; and columns of text, of nothing, and with holes.
  write("# of a robot\n#timestamp [ns],frame,x [m],empty,\n1403636580838555648,a,nan,,\n"
        "1403636580838555649,b,2,,\n");
  const std::vector<NumberColumn> columns = read_number_table(path, "recording");
  ASSERT_EQ(columns.size(), 5U);
  EXPECT_EQ(columns[0].title.name, "timestamp");
  EXPECT_EQ(columns[0].title.unit, "ns");
  EXPECT_EQ(columns[0].since_first, (std::vector<double>{0, 1}));
  EXPECT_FALSE(columns[1].numbers);
  EXPECT_TRUE(std::isnan(columns[2].since_first[0]));
  EXPECT_EQ(columns[2].first, 2);
  EXPECT_EQ(columns[2].since_first[1], 0);
  EXPECT_FALSE(columns[3].numbers);
  EXPECT_FALSE(columns[4].numbers);
}

TEST_F(CsvFileTest, RecordingsNeedAHeaderAndWholeRows) {
  const auto refused = [&](const std::string& text) {
    write(text);
    return refusal([&] { read_number_table(path, "recording"); });
  };
  EXPECT_THAT(refused("1,2\n3,4\n"), HasSubstr("has no header"));
  EXPECT_THAT(refused("t,x\n"), HasSubstr("no row stands below the header"));
  EXPECT_THAT(refused(""), HasSubstr("has no row"));
  EXPECT_THAT(refused("t,x\n1,2,3\n"), HasSubstr("csv:2"));
}

TEST_F(CsvFileTest, OfNothingHasNoRow) {
  for (const char* text : {"", "\xEF\xBB\xBF", "\n", "sep=;"}) {
    write(text);
    CsvFile file(path, "data");
    EXPECT_FALSE(file.next()) << text;
    EXPECT_EQ(file.line(), 1U);
  }
}

TEST_F(CsvFileTest, MarksAndLineEndsOfAnyProgram) {
  const Rows expected{{"a", "b"}, {"1", "2"}};
  for (const char* text : {"a,b\n1,2\n", "a,b\r1,2\r", "a,b\r\n1,2",
                           "\xEF\xBB\xBF"
                           "a,b\n1,2",
                           "\xEF\xBB\xBF# x\ra,b\r\r1,2", "\"a\",\"b\"\n\"1\",\"2\"\n",
                           "a;b\n1;2\n", "a\tb\r\n1\t2\r\n", "sep=;\r\na;b\r\n1;2\r\n",
                           "a , b\n 1 ,\t2 \n", "\"# x, y\"\na,b\n1,2\n,\n"})
    EXPECT_EQ(rows(text), expected) << text;
}

TEST_F(CsvFileTest, QuotesAsInRfc4180) {
  EXPECT_EQ(rows("\"a, \"\"b\"\"\",c\n"), (Rows{{"a, \"b\"", "c"}}));
  write("\"two\r\nlines\",b\n1,2\n");
  CsvFile file(path, "data");
  EXPECT_EQ(file.next()->front(), "two\r\nlines");
  file.next();
  EXPECT_EQ(file.line(), 3U);
  EXPECT_THAT(refusal([&] { rows("a,b\n1,\"2\n3,4\n"); }), HasSubstr("test.csv:2"));
}

TEST_F(CsvFileTest, DecimalCommasWhereTheyCanBeNothingElse) {
  EXPECT_EQ(rows("t;x\n0,5;-1,25e-3\n1,234;2\n"),
            (Rows{{"t", "x"}, {"0.5", "-1.25e-3"}, {"1.234", "2"}}));
  EXPECT_EQ(rows("t\tx\n0,5\t1\n"), (Rows{{"t", "x"}, {"0.5", "1"}}));
  EXPECT_EQ(rows("t,x\n\"0,5\",1\n"), (Rows{{"t", "x"}, {"0.5", "1"}}));
  EXPECT_EQ(rows("mm;-1,5;1,5\n0;0,1;0,2\n"), (Rows{{"mm", "-1.5", "1.5"}, {"0", "0.1", "0.2"}}));
  EXPECT_EQ(rows("t;day\n0,5;28.11.2026\n"), (Rows{{"t", "day"}, {"0.5", "28.11.2026"}}));
  EXPECT_THAT(refusal([&] { rows("t,x\n1,1\n\"1,234\",1\n"); }), HasSubstr("test.csv:3"));
  EXPECT_THAT(refusal([&] { rows("t\tx\n1,234\t1\n"); }), HasSubstr("thousands"));
  EXPECT_THAT(refusal([&] { rows("t;x\n0,5;1\n0.6;1\n"); }), HasSubstr("in lines 2 and 3"));
}

TEST_F(CsvFileTest, Utf16IsRefusedWithTheWayOut) {
  for (const std::string& text : {std::string("\xFF\xFE"
                                              "a\0,\0",
                                              6),
                                  std::string("a\0,\0b\0", 6)})
    EXPECT_THAT(refusal([&] { rows(text); }), HasSubstr("iconv -f UTF-16"));
}

TEST_F(CsvFileTest, OtherSeparatorsAreRefusedWithTheWayOut) {
  for (const auto& [text, remedy] : {std::pair{"time [s]|x [mm]\n0|1\n", "tr -s '|' ','"},
                                     std::pair{"time x\n0 1\n", "tr -s ' ' ','"}}) {
    try {
      rows(text);
      ADD_FAILURE() << "accepted: " << text;
    } catch (const UserError& error) {
      EXPECT_THAT(error.what(), HasSubstr("neither a comma nor a semicolon nor a tab"));
      EXPECT_THAT(error.what(), HasSubstr(remedy));
    }
  }
}

TEST_F(CsvFileTest, RecordingsTellTheFirstCellOfText) {
  write("time,x\n0,1\n,nan\n2,\n3,left\n4,right\n");
  const std::vector<NumberColumn> columns = read_number_table(path, "recording");
  EXPECT_TRUE(columns[0].numbers);
  EXPECT_EQ(columns[0].text_line, 0U);
  EXPECT_FALSE(columns[1].numbers);
  EXPECT_EQ(columns[1].text, "left");
  EXPECT_EQ(columns[1].text_line, 5U);
}

TEST_F(CsvFileTest, TablesLeaveOutNamelessColumnsThatTellNothing) {
  const Rows expected{{"0.1", "2"}, {"0.2", "3"}};
  for (const char* text :
       {"t,x\n0.1,2\n0.2,3\n", ",t,x\n0,0.1,2\n1,0.2,3\n", "Unnamed: 0,t,x\n5,0.1,2\n9,0.2,3\n",
        "t,x,\n0.1,2,\n0.2,3,\n", "t,x\n0.1,2,\n0.2,3,,\n", "t,x,\n0.1,2\n0.2,3\n"})
    EXPECT_EQ(table(text), expected) << text;
  EXPECT_THAT(refusal([&] { table(",t\n0.5,1\n"); }),
              HasSubstr("column 1 has no name, and holds \"0.5\""));
  EXPECT_THAT(refusal([&] { table("t,,x\n0,1,2\n"); }), HasSubstr("column 2 has no name"));
  EXPECT_THAT(refusal([&] { table(",t\n3,1\n3,2\n"); }), HasSubstr("test.csv:3"));
  EXPECT_THAT(refusal([&] { table("t,x\n1\n"); }), HasSubstr("1 entries under 2 columns"));
  EXPECT_THAT(refusal([&] { table("t,x\n1,2,3\n"); }), HasSubstr("3 entries under 2 columns"));
}

TEST(CsvTitle, DividesNameAndUnit) {
  EXPECT_EQ(csv_title("time [ ms ]").name, "time");
  EXPECT_EQ(csv_title("time [ ms ]").unit, "ms");
  EXPECT_EQ(csv_title("time").name, "time");
  EXPECT_FALSE(csv_title("time").unit);
  EXPECT_FALSE(csv_title("time ]s[").unit);
  EXPECT_EQ(csv_title("Time (s)").name, "time");
  EXPECT_EQ(csv_title("Time (s)").unit, "s");
  EXPECT_EQ(csv_title("force (filtered) [N]").unit, "N");
}

TEST(CsvLine, CountsEveryKindOfLineEnd) {
  for (const char* text : {"a\nb\nc",
                           "\xEF\xBB\xBF"
                           "a\rb\rc",
                           "a\r\nb\r\nc\r\n"}) {
    EXPECT_EQ(csv_line(text, 1), "a");
    EXPECT_EQ(csv_line(text, 3), "c");
    EXPECT_EQ(csv_line(text, 9), "");
  }
}

} // namespace
} // namespace ionskin
