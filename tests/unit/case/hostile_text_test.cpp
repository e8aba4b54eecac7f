// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/error.hpp"
#include "ionskin/base/files/read_text_file.hpp"
#include "ionskin/case/checks/check_sizes.hpp"
#include "ionskin/case/reading/read_case.hpp"
#include "ionskin/case/schema/schema.hpp"
#include "temporary_case.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <random>
#include <string>
#include <sys/stat.h>

namespace ionskin {
namespace {

using testing::HasSubstr;

std::string repeated(const std::string& part, std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < count; ++i)
    text += part;
  return text;
}

/// The message with which the text is refused; fails where it is long or a terminal acts on it.
std::string refusal(const std::string& text, const std::vector<std::string>& edits = {}) {
  const std::clock_t begin = std::clock();
  std::string message;
  try {
    read_case_text(text, "case.toml", edits);
  } catch (const UserError& error) {
    message = error.what();
  }
  EXPECT_NE(message, "") << "accepted";
  EXPECT_LT(message.size(), 12'000u);
  EXPECT_TRUE(std::ranges::none_of(message, [](unsigned char letter) {
    return (letter < 0x20 && letter != '\n' && letter != '\t') || letter == 0x7f;
  })) << message;
  // Processor time: what else the machine does is not a fault of the text.
  EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 60);
  return message;
}

TEST(HostileText, DeepNesting) {
  EXPECT_THAT(refusal("x = " + std::string(20'000, '[') + std::string(20'000, ']')),
              HasSubstr("brackets"));
  EXPECT_THAT(refusal("x = " + repeated("{a=", 20'000) + "1" + std::string(20'000, '}')),
              HasSubstr("brackets"));
  EXPECT_THAT(refusal("a" + repeated(".a", 20'000) + " = 1"), HasSubstr("parts"));
  EXPECT_THAT(refusal("a" + repeated(" . a", 20'000) + " = 1"), HasSubstr("parts"));
  EXPECT_THAT(refusal("a" + repeated(".\"b\"", 20'000) + " = 1"), HasSubstr("parts"));
  EXPECT_THAT(refusal("[a" + repeated(" . a", 20'000) + "]"), HasSubstr("parts"));
}

TEST(HostileText, LongUnitsKeysAndTexts) {
  const std::string length = "length = \"15 mm\"";
  for (const std::string& unit :
       {std::string(50'000, ' ') + "x", std::string(25'000, 'm'), repeated("m.", 12'000),
        std::string(25'000, '('), "m" + std::string(100, '9'), repeated("mM", 60)})
    EXPECT_THAT(refusal(valid_case(length, fmt::format("length = \"15 {}\"", unit))),
                testing::AnyOf(HasSubstr("skin.length"), HasSubstr("bytes")));
  EXPECT_THAT(refusal(valid_case(length, length + "\n" + std::string(50'000, 'k') + " = 1")),
              HasSubstr("bytes"));
  EXPECT_THAT(refusal(valid_case(length, length + "\n\"" + std::string(2'000, 'k') + "\" = 1")),
              HasSubstr("bytes"));
  EXPECT_THAT(refusal(valid_case() + "\n#" + std::string(2'000'000, 'x')), HasSubstr("bytes"));
  EXPECT_THAT(refusal("x = [" + repeated("1,", 60'000) + "]"), HasSubstr("values"));
}

TEST(HostileText, NumbersThatNoMachineHolds) {
  const std::string given = "coefficient = 0.1";
  for (const char* number : {"100000000000000000000", "-9223372036854775809", "0xFFFFFFFFFFFFFFFFF",
                             "9_223_372_036_854_775_808"})
    EXPECT_THAT(refusal(valid_case(given, fmt::format("coefficient = {}", number))),
                HasSubstr("64 bits"));
  EXPECT_THAT(refusal(valid_case(given, "coefficient = 1e999")), HasSubstr("represented"));
  EXPECT_THAT(refusal(valid_case(), {"coupling.coefficient=100000000000000000000"}),
              HasSubstr("coupling.coefficient"));
}

TEST(HostileText, BytesThatAreNoText) {
  EXPECT_THAT(refusal(valid_case() + "\n# \xff\xfe"), HasSubstr("UTF-8"));
  EXPECT_THAT(refusal(valid_case() + std::string("\n# a\0b", 6)), HasSubstr("control"));
  EXPECT_THAT(refusal(valid_case() + "\n# \x1b[31m"), HasSubstr("control"));
  EXPECT_THAT(refusal(valid_case("A touch", "\\u001b[31mred")), HasSubstr("control"));
  EXPECT_THAT(refusal("\"\\u001b[31m\" = 1\n" + valid_case()), HasSubstr("name"));
  EXPECT_THAT(refusal(valid_case(), {"coupling.law=\x1b[31mred"}), HasSubstr("coupling.law"));
  EXPECT_THAT(refusal(valid_case(), {"coupling.law=\xff"}), HasSubstr("UTF-8"));
  EXPECT_THAT(refusal(valid_case(), {"coupling.law=" + std::string(5'000, '[')}),
              HasSubstr("brackets"));
  EXPECT_THAT(refusal(valid_case(), {std::string(40'000, 'k') + "=1"}), HasSubstr("bytes"));
  EXPECT_THAT(refusal(valid_case(), {std::string(20'000, 'k') + "=1"}), HasSubstr("k"));
}

TEST(HostileText, ThousandTaxelsAreAnsweredInTenLines) {
  std::string taxels;
  for (int i = 0; i < 1000; ++i)
    taxels += fmt::format("[[readout.taxels]]\nname = \"t{}\"\nlower = [\"1 mm\", \"0 mm\"]\nupper "
                          "= [\"2 mm\", \"1 mm\"]\n",
                          i);
  const std::string message = refusal(valid_case() + "\n" + taxels);
  EXPECT_THAT(message, HasSubstr("499499 more pairs"));
  EXPECT_LE(std::ranges::count(message, '\n'), 10);
}

TEST(HostileText, ManyMistakesAreCounted) {
  std::string keys;
  for (int i = 0; i < 5000; ++i)
    keys += fmt::format("unknown_{} = 1\n", i);
  const std::string message = refusal(keys + valid_case());
  EXPECT_THAT(message, HasSubstr("5000 problems"));
  EXPECT_THAT(message, HasSubstr("4990 more"));
}

TEST(HostileText, ReadingsThatFillTheDisk) {
  const std::string text =
      valid_case("[coupling]", "[readout]\nsample_interval = \"1 ns\"\n[coupling]");
  EXPECT_THAT(refusal(text), HasSubstr("readout.sample_interval"));
  EXPECT_THAT(
      refusal(valid_case("[coupling]", "[readout]\nsample_interval = \"1e-19 s\"\n[coupling]")),
      HasSubstr("readout.sample_interval"));
  EXPECT_THROW(require_sampling({.sample_interval = 1e-9}, 5), UserError);
  EXPECT_NO_THROW(require_sampling({.sample_interval = 1e-2}, 5));
}

TEST(HostileText, EveryNumberOfTheSchemaHasBounds) {
  for (const SchemaRow& row : schema()) {
    const bool number = row.type != ValueType::text && row.type != ValueType::choice;
    EXPECT_TRUE(!number || (std::isfinite(row.range.lower) && std::isfinite(row.range.upper)))
        << row.key;
  }
}

TEST(HostileFile, NoOrdinaryFile) {
  const TemporaryCase folder("");
  const std::string fifo = folder.folder() + "/fifo";
  ASSERT_EQ(mkfifo(fifo.c_str(), 0600), 0);
  for (const std::string& path : {fifo, std::string("/dev/zero"), folder.folder(),
                                  folder.folder() + "/nothing", std::string("a\0b", 3)})
    EXPECT_THROW(base::read_text_file(path, "case"), UserError) << path;
  const std::string large = folder.folder() + "/large";
  std::ofstream(large).write(std::string(5'000, 'x').data(), 5'000);
  EXPECT_THROW(base::read_text_file(large, "case", 4'999), UserError);
  EXPECT_EQ(base::read_text_file(large, "case", 5'000).size(), 5'000u);
}

/// One of the ways in which a text gets broken.
std::string mutated(std::string text, std::mt19937& random) {
  const auto below = [&](std::size_t bound) { return static_cast<std::size_t>(random()) % bound; };
  static const std::vector<std::string> pieces = {"[",
                                                  "]",
                                                  "[[",
                                                  "{",
                                                  "}",
                                                  "\"",
                                                  "'",
                                                  "\"\"\"",
                                                  "=",
                                                  ".",
                                                  ",",
                                                  "\n",
                                                  "#",
                                                  "\\u0000",
                                                  "\\",
                                                  "1e999",
                                                  "nan",
                                                  "-inf",
                                                  "0x",
                                                  "1979-05-27T07:32:00Z",
                                                  "99999999999999999999",
                                                  "\xff",
                                                  "\x1b[2J",
                                                  "mm",
                                                  "m^999",
                                                  "@",
                                                  "%",
                                                  "sqrt(Hz)",
                                                  "a.b.c.d"};
  for (std::size_t i = 1 + below(4); i > 0; --i) {
    const std::size_t at = below(text.size());
    switch (below(4)) {
    case 0:
      text.erase(at, 1 + below(20));
      break;
    case 1:
      text.insert(at, pieces[below(pieces.size())]);
      break;
    case 2:
      text.insert(at, text.substr(below(text.size()), below(200)));
      break;
    default:
      text[at] = static_cast<char>(below(256));
    }
  }
  return text;
}

TEST(HostileText, MutatedCasesAreReadOrRefused) {
  std::mt19937 random(20261);
  const std::string valid = valid_case();
  int refused = 0;
  for (int i = 0; i < 300; ++i) {
    try {
      read_case_text(mutated(valid, random), "case.toml");
    } catch (const UserError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 150);
}

} // namespace
} // namespace ionskin
