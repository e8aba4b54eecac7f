// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/files/read_json.hpp"

#include "ionskin/base/error.hpp"
#include "scratch_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <sys/stat.h>

namespace {

using namespace ionskin;

std::string nested(int depth, const std::string& open, const std::string& close) {
  std::string text;
  for (int i = 0; i < depth; ++i) {
    text += open;
  }
  text += "1";
  for (int i = 0; i < depth; ++i) {
    text += close;
  }
  return text;
}

TEST(ReadJson, GivesValuesAndNothingForWhatIsNotJson) {
  const auto value = base::parse_json(R"({"b": [1, {"c": "["}], "a": null})");
  ASSERT_TRUE(value);
  EXPECT_EQ(value->dump(), R"({"b":[1,{"c":"["}],"a":null})");
  for (const char* text : {"", "{", "[1,]", "{\"a\":}", "[1] 2", "\xff"}) {
    EXPECT_FALSE(base::parse_json(text)) << text;
  }
}

TEST(ReadJson, RefusesWhatIsNestedTooDeeplyWhateverTheDepth) {
  EXPECT_TRUE(base::parse_json(nested(base::deepest_json, "[", "]")));
  EXPECT_TRUE(base::parse_json(nested(base::deepest_json, "{\"a\":", "}")));
  for (const int depth : {base::deepest_json + 1, 1'000'000}) {
    EXPECT_FALSE(base::parse_json(nested(depth, "[", "]"))) << depth;
    EXPECT_FALSE(base::parse_json(nested(depth, "{\"a\":", "}"))) << depth;
    EXPECT_FALSE(base::parse_json(nested(depth, "[{\"a\":", ""))) << depth;
  }
}

TEST(ReadJson, ReadsOrdinaryFilesAloneAndNoMoreThanAllowed) {
  const results::ScratchFolder folder;
  const auto file = folder.path() / "a.json";
  std::ofstream(file) << "[1, 2]";
  EXPECT_EQ(base::read_json(file, "list")->size(), 2U);
  EXPECT_THROW(base::read_json(file, "list", 5), UserError);
  EXPECT_THROW(base::read_json(folder.path(), "list"), UserError);
  EXPECT_THROW(base::read_json(folder.path() / "missing", "list"), UserError);
  const auto pipe = folder.path() / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THROW(base::read_json(pipe, "list"), UserError); // without waiting for a writer
}

} // namespace
