// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/output_folder.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/results/file_list.hpp"
#include "ionskin/results/manifest.hpp"
#include "scratch_folder.hpp"
#include "without_privileges.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sys/stat.h>
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
  return message_of<UserError>([&] { OutputFolder(folder, existing); });
}

TEST(OutputFolder, IsMadeWithItsParents) {
  const ScratchFolder scratch;
  OutputFolder folder(scratch / "a/b", ExistingFolder::refuse);
  EXPECT_TRUE(fs::is_directory(scratch / "a/b"));
  EXPECT_FALSE(fs::exists(scratch / "a/b/manifest.json"));
}

TEST(OutputFolder, AnEmptyOneIsTaken) {
  const ScratchFolder scratch;
  EXPECT_NO_THROW(OutputFolder(scratch.path(), ExistingFolder::refuse));
}

TEST(OutputFolder, OneWhoseListAKilledProgramLeftUnfinishedIsTaken) {
  const ScratchFolder scratch;
  write_all(scratch / ".ionskin-files.1234-0.tmp", "# What");
  EXPECT_NO_THROW(OutputFolder(scratch.path(), ExistingFolder::resume));
  EXPECT_TRUE(fs::exists(scratch / ".ionskin-files"));
  fs::remove(scratch / ".ionskin-files");
  write_all(scratch / "notes.txt", "the user's own");
  EXPECT_NE(refusal(scratch.path(), ExistingFolder::resume).find("manifest.json"),
            std::string::npos);
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

/// A folder in which the program wrote a table, a figure and a field.
void fill_with_listed_results(const fs::path& path) {
  OutputFolder folder(path, ExistingFolder::refuse);
  write_manifest(folder.own("manifest.json"), new_manifest("ionskin run", 1, "0"));
  for (const char* name : {"signals.csv", "fields/fields_0000.vtu", "figures/motion.png"}) {
    write_all(folder.own(name), "old");
  }
  write_all(path / "fields/fields.pvd.9-1.ionskin-pending", "of a killed writer");
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    names.push_back(fs::relative(entry.path(), folder).string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

TEST(OutputFolder, OverwriteRemovesOnlyWhatIonskinWrote) {
  const ScratchFolder scratch;
  const fs::path out = scratch / "out";
  fill_with_listed_results(out);
  for (const char* name : {"notes.txt", "fields/view.pvd", "figures/own.png", "sweep.pdf"}) {
    write_all(out / name, "mine");
  }
  OutputFolder(out, ExistingFolder::overwrite);
  EXPECT_EQ(names_in(out),
            (std::vector<std::string>{".ionskin-files", "fields", "fields/view.pvd", "figures",
                                      "figures/own.png", "notes.txt", "sweep.pdf"}));
  EXPECT_NO_THROW(OutputFolder(out, ExistingFolder::overwrite)) << "it still is a folder of ours";
}

TEST(OutputFolder, OverwriteOfOneWithoutAListLeavesFigures) {
  const ScratchFolder scratch;
  fill_with_results(scratch.path());
  OutputFolder(scratch.path(), ExistingFolder::overwrite);
  EXPECT_EQ(
      names_in(scratch.path()),
      (std::vector<std::string>{".ionskin-files", "figures", "figures/motion.pdf",
                                "figures/motion.png", "figures/motion.svg", "results.h5.tmp"}));
}

TEST(OutputFolder, LinksAreNeverFollowed) {
  const ScratchFolder scratch;
  const fs::path out = scratch / "out", pictures = scratch / "pictures";
  fs::create_directory(pictures);
  write_all(pictures / "motion.png", "mine");
  write_all(scratch / "thesis.csv", "mine");
  fill_with_listed_results(out);
  fs::remove_all(out / "figures");
  fs::create_directory_symlink(pictures, out / "figures");
  for (ExistingFolder existing : {ExistingFolder::overwrite, ExistingFolder::resume}) {
    EXPECT_NE(refusal(out, existing).find("is a link"), std::string::npos);
  }
  EXPECT_EQ(read_all(pictures / "motion.png"), "mine");
  EXPECT_EQ(read_all(out / "signals.csv"), "old") << "nothing was removed before";
  fs::remove(out / "figures");
  fs::remove(out / "signals.csv");
  fs::create_symlink(scratch / "thesis.csv", out / "signals.csv");
  OutputFolder(out, ExistingFolder::overwrite);
  EXPECT_FALSE(fs::exists(out / "signals.csv"));
  EXPECT_EQ(read_all(scratch / "thesis.csv"), "mine");
}

TEST(OutputFolder, AListThatLeadsElsewhereIsNotFollowed) {
  const ScratchFolder scratch;
  const fs::path out = scratch / "out";
  write_all(scratch / "thesis.csv", "mine");
  fill_with_listed_results(out);
  fs::create_directories(out / "own/deep");
  write_all(out / "own/deep/a.txt", "mine");
  std::ofstream(out / ".ionskin-files", std::ios::app)
      << "../thesis.csv\n"
      << (scratch / "thesis.csv").string() << "\nfigures/../../thesis.csv\n"
      << "own/deep/a.txt\nown\n.\n..\n\n";
  OutputFolder(out, ExistingFolder::overwrite);
  EXPECT_EQ(read_all(scratch / "thesis.csv"), "mine");
  EXPECT_EQ(read_all(out / "own/deep/a.txt"), "mine");
}

TEST(OutputFolder, AFileOfTheUserIsNotReplaced) {
  const ScratchFolder scratch;
  const fs::path out = scratch / "out";
  fill_with_listed_results(out);
  write_all(out / "summary.json", "mine");
  for (ExistingFolder existing : {ExistingFolder::overwrite, ExistingFolder::resume}) {
    EXPECT_NE(refusal(out, existing).find("not written by ionskin"), std::string::npos);
  }
  fs::remove(out / "summary.json");
  OutputFolder folder(out, ExistingFolder::resume);
  write_all(out / "summary.json", "mine");
  EXPECT_THROW(folder.own("summary.json"), UserError);
  EXPECT_EQ(read_all(out / "summary.json"), "mine");
}

TEST(OutputFolder, OnlyOneMayWrite) {
  const ScratchFolder scratch;
  const fs::path out = scratch / "out";
  {
    const OutputFolder folder(out, ExistingFolder::refuse);
    for (ExistingFolder existing :
         {ExistingFolder::refuse, ExistingFolder::overwrite, ExistingFolder::resume}) {
      EXPECT_NE(refusal(out, existing).find("another ionskin"), std::string::npos);
    }
  }
  EXPECT_NO_THROW(OutputFolder(out, ExistingFolder::resume));
}

TEST(OutputFolder, PointsOfAnEarlierSweepGo) {
  const ScratchFolder scratch;
  const fs::path out = scratch / "out";
  fill_with_listed_results(out);
  fs::create_directory(out / "points");
  fill_with_listed_results(out / "points/0001");
  fill_with_listed_results(out / "points/0002");
  write_all(out / "points/0002/notes.txt", "mine");
  fs::create_directory(out / "points/own");
  write_all(out / "points/own/manifest.json", "mine");
  fill_with_listed_results(scratch / "elsewhere");
  fs::create_directory_symlink(scratch / "elsewhere", out / "points/0003");
  OutputFolder(out, ExistingFolder::overwrite);
  EXPECT_FALSE(fs::exists(out / "points/0001"));
  EXPECT_FALSE(fs::exists(out / "points/0002/signals.csv"));
  EXPECT_EQ(read_all(out / "points/0002/notes.txt"), "mine");
  EXPECT_EQ(read_all(out / "points/own/manifest.json"), "mine");
  EXPECT_EQ(read_all(scratch / "elsewhere/signals.csv"), "old");
}

TEST(OutputFolder, ResumeKeepsEverything) {
  const ScratchFolder scratch;
  fill_with_results(scratch.path());
  OutputFolder folder(scratch.path(), ExistingFolder::resume);
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

TEST(OutputFolder, APipeInTheWayIsNotWaitedFor) {
  const ScratchFolder scratch;
  ASSERT_EQ(mkfifo((scratch / "plan.json").c_str(), 0600), 0);
  EXPECT_TRUE(lock_path(scratch / "plan.json", LockKind::exclusive));
  ASSERT_EQ(mkfifo((scratch / file_list_name).c_str(), 0600), 0);
  EXPECT_FALSE(read_file_list(scratch.path()));
  fs::remove(scratch / file_list_name);
  write_all(scratch / file_list_name, std::string(80'000'000, 'x')); // one line
  EXPECT_FALSE(read_file_list(scratch.path()));
}

TEST(OutputFolder, AnUnwritableOneIsRefused) {
  const ScratchFolder scratch;
  const WithoutPrivileges as_anybody;
  fs::permissions(scratch.path(), fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_NE(refusal(scratch.path(), ExistingFolder::refuse).find("Permission denied"),
            std::string::npos)
      << refusal(scratch.path(), ExistingFolder::refuse);
  fs::permissions(scratch.path(), fs::perms::owner_all);
}

} // namespace
} // namespace ionskin::results
