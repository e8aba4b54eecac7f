// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/output_folder.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/results/manifest.hpp"
#include "scratch_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <unistd.h>
#include <vector>

namespace ionskin::results {
namespace {

namespace fs = std::filesystem;

void fill_with_results(const fs::path& folder) {
  fs::create_directories(folder / "fields");
  fs::create_directories(folder / "figures");
  write_manifest(folder / "manifest.json", new_manifest("ionskin run", 1, "0"));
  for (const char* name :
       {"case.toml", "summary.json", "signals.csv", "sampled.csv", "results.h5", "results.h5.tmp",
        "report.html", "fields/fields_0000.vtu", "fields/fields.pvd", "figures/motion.png",
        "figures/motion.svg", "figures/motion.pdf", "sweep.csv", "sweep.h5"}) {
    write_all(folder / name, "old");
  }
}

std::string refusal(const fs::path& folder, ExistingFolder existing) {
  return message_of<UserError>([&] { prepare_output_folder(folder, existing); });
}

TEST(OutputFolder, IsMadeWithItsParents) {
  const ScratchFolder scratch;
  prepare_output_folder(scratch / "a/b", ExistingFolder::refuse);
  EXPECT_TRUE(fs::is_directory(scratch / "a/b"));
  EXPECT_TRUE(fs::is_empty(scratch / "a/b"));
}

TEST(OutputFolder, AnEmptyOneIsTaken) {
  const ScratchFolder scratch;
  EXPECT_NO_THROW(prepare_output_folder(scratch.path(), ExistingFolder::refuse));
}

TEST(OutputFolder, AFilledOneIsRefusedWithTheRemedies) {
  const ScratchFolder scratch;
  fill_with_results(scratch.path());
  const std::string message = refusal(scratch.path(), ExistingFolder::refuse);
  EXPECT_NE(message.find(scratch.path().string()), std::string::npos);
  EXPECT_NE(message.find("--overwrite"), std::string::npos);
  EXPECT_NE(message.find("--resume"), std::string::npos);
  EXPECT_EQ(read_all(scratch / "signals.csv"), "old");
}

TEST(OutputFolder, OverwriteRemovesOnlyWhatIonskinWrites) {
  const ScratchFolder scratch;
  fill_with_results(scratch.path());
  write_all(scratch / "notes.txt", "mine");
  write_all(scratch / "fields/view.pvsm", "mine");
  prepare_output_folder(scratch.path(), ExistingFolder::overwrite);
  std::vector<std::string> left;
  for (const auto& entry : fs::recursive_directory_iterator(scratch.path())) {
    left.push_back(fs::relative(entry.path(), scratch.path()).string());
  }
  std::sort(left.begin(), left.end());
  EXPECT_EQ(left, (std::vector<std::string>{"fields", "fields/view.pvsm", "notes.txt"}));
}

TEST(OutputFolder, ResumeKeepsEverything) {
  const ScratchFolder scratch;
  fill_with_results(scratch.path());
  prepare_output_folder(scratch.path(), ExistingFolder::resume);
  EXPECT_EQ(read_all(scratch / "results.h5"), "old");
}

TEST(OutputFolder, ForeignFilesAreNeverTouched) {
  const ScratchFolder scratch;
  write_all(scratch / "case.toml", "the user's own");
  for (ExistingFolder existing : {ExistingFolder::overwrite, ExistingFolder::resume}) {
    EXPECT_NE(refusal(scratch.path(), existing).find("manifest.json"), std::string::npos);
  }
  EXPECT_EQ(read_all(scratch / "case.toml"), "the user's own");
}

TEST(OutputFolder, AFileInTheWayIsNamed) {
  const ScratchFolder scratch;
  write_all(scratch / "file", "");
  EXPECT_NE(refusal(scratch / "file", ExistingFolder::refuse).find("is a file"), std::string::npos);
  const std::string message = refusal(scratch / "file/out", ExistingFolder::refuse);
  EXPECT_NE(message.find("file/out"), std::string::npos) << message;
}

TEST(OutputFolder, AnUnwritableOneIsRefused) {
  if (geteuid() == 0) {
    GTEST_SKIP() << "root writes everywhere";
  }
  const ScratchFolder scratch;
  fs::permissions(scratch.path(), fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_FALSE(refusal(scratch.path(), ExistingFolder::refuse).empty());
  fs::permissions(scratch.path(), fs::perms::owner_all);
}

} // namespace
} // namespace ionskin::results
