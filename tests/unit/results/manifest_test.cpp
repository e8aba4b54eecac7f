// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/manifest.hpp"

#include "ionskin/base/error.hpp"
#include "scratch_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <sys/stat.h>

namespace ionskin::results {
namespace {

Manifest example() {
  Manifest manifest = new_manifest("ionskin run case.toml -o out", 2, content_hash("case"));
  manifest.stages["mechanics"] = {"finished", 7.5, 2.5e9};
  manifest.stages["electrochemistry"] = {"interrupted", 0.25, 2.5e9};
  manifest.counters["residual_evaluations"] = 1234;
  manifest.state = "interrupted";
  return manifest;
}

TEST(Manifest, ReadsBackWhatWasWritten) {
  const ScratchFolder folder;
  const Manifest written = example();
  write_manifest(folder / "manifest.json", written);
  const Manifest read = read_manifest(folder / "manifest.json");
  EXPECT_EQ(read.command, written.command);
  EXPECT_EQ(read.threads, 2);
  EXPECT_EQ(read.input_hash, written.input_hash);
  EXPECT_EQ(read.state, "interrupted");
  EXPECT_EQ(read.started, written.started);
  EXPECT_EQ(read.stages.at("mechanics").state, "finished");
  EXPECT_EQ(read.stages.at("mechanics").wall_time, 7.5);
  EXPECT_EQ(read.stages.at("mechanics").peak_memory, 2.5e9);
  EXPECT_EQ(read.counters.at("residual_evaluations"), 1234);
}

TEST(Manifest, SaysWhatMadeTheResult) {
  const auto json = nlohmann::json::parse(manifest_text(example()));
  EXPECT_EQ(json["program"]["name"], "ionskin");
  EXPECT_FALSE(json["program"]["version"].get<std::string>().empty());
  EXPECT_FALSE(json["program"]["compiler"].get<std::string>().empty());
  EXPECT_EQ(json["started"].get<std::string>().size(), std::string("2000-01-01T00:00:00Z").size());
}

TEST(Manifest, DistinguishesItsOwnFromOthers) {
  const ScratchFolder folder;
  EXPECT_FALSE(is_ionskin_manifest(folder / "manifest.json"));
  for (const char* foreign :
       {"", "{}", "[1]", "not json", "{\"program\": 3}", "{\"program\": {\"name\": \"other\"}}"}) {
    write_all(folder / "manifest.json", foreign);
    EXPECT_FALSE(is_ionskin_manifest(folder / "manifest.json")) << foreign;
    EXPECT_THROW(read_manifest(folder / "manifest.json"), UserError) << foreign;
  }
  write_manifest(folder / "manifest.json", example());
  EXPECT_TRUE(is_ionskin_manifest(folder / "manifest.json"));
}

TEST(Manifest, ADamagedOneIsAUserError) {
  const ScratchFolder folder;
  write_all(folder / "manifest.json", "{\"program\": {\"name\": \"ionskin\"}, \"state\": 7}");
  const std::string message =
      message_of<UserError>([&] { read_manifest(folder / "manifest.json"); });
  EXPECT_NE(message.find("manifest.json"), std::string::npos);
}

TEST(Manifest, OfAnyTypesAndDepthIsAUserError) {
  const ScratchFolder folder;
  const std::string deep = std::string(1'000'000, '[') + std::string(1'000'000, ']');
  const std::string own =
      "{\"program\": {\"name\": \"ionskin\"}, \"digest\": \"\", \"state\": " + deep + "}";
  for (const std::string& text :
       {deep, own, own.substr(0, 1000), std::string("{\"program\": {\"name\": 3}}"),
        std::string("{\"program\": {\"name\": [\"ionskin\"]}}"), std::string("null")}) {
    write_all(folder / "manifest.json", text);
    EXPECT_FALSE(is_ionskin_manifest(folder / "manifest.json"));
    EXPECT_THROW(read_manifest(folder / "manifest.json"), UserError);
  }
}

TEST(Manifest, AFolderAPipeOrADeviceIsNone) {
  const ScratchFolder folder;
  std::filesystem::create_directory(folder / "folder");
  std::filesystem::create_symlink("/dev/zero", folder / "device");
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  for (const char* name : {"folder", "device", "pipe"}) {
    EXPECT_FALSE(is_ionskin_manifest(folder / name));
    EXPECT_THROW(read_manifest(folder / name), UserError);
  }
}

TEST(Manifest, ContentHashDistinguishesTexts) {
  EXPECT_EQ(content_hash("foobar").size(), 32U);
  EXPECT_EQ(content_hash("foobar"), content_hash("foobar"));
  EXPECT_NE(content_hash("foobar"), content_hash("foobas"));
  EXPECT_NE(content_hash(""), content_hash("a"));
}

} // namespace
} // namespace ionskin::results
