// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/run/run_folder.hpp"

#include "scratch_folder.hpp"
#include "synthetic_contact.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace ionskin::study {
namespace {

Case with_text(const std::string& text) {
  Case input = handover::small_case();
  input.text = text;
  return input;
}

RunOptions in(const results::ScratchFolder& folder) {
  RunOptions options;
  options.folder = folder.path() / "out";
  return options;
}

TEST(RunFolder, RemembersWhatIsFinishedForResume) {
  const results::ScratchFolder scratch;
  auto options = in(scratch);
  {
    RunFolder folder(with_text("a"), options);
    EXPECT_EQ(folder.stage("mechanics", [] { return 3; }), 3);
    EXPECT_THROW(folder.stage("strain", []() -> int { throw Interrupted(); }), Interrupted);
  }
  options.resume = true;
  const RunFolder resumed(with_text("a"), options);
  EXPECT_TRUE(resumed.was_finished("mechanics"));
  EXPECT_FALSE(resumed.was_finished("strain"));
  EXPECT_EQ(resumed.manifest().stages.at("strain").state, "interrupted");
}

TEST(RunFolder, RefusesToResumeAnotherCase) {
  const results::ScratchFolder scratch;
  auto options = in(scratch);
  { const RunFolder folder(with_text("a"), options); }
  options.resume = true;
  EXPECT_THROW(RunFolder(with_text("b"), options), UserError);
}

TEST(RunFolder, RefusesATakenFolderUnlessAsked) {
  const results::ScratchFolder scratch;
  auto options = in(scratch);
  { const RunFolder folder(with_text("a"), options); }
  EXPECT_THROW(RunFolder(with_text("a"), options), UserError);
  options.overwrite = true;
  EXPECT_NO_THROW(RunFolder(with_text("b"), options));
}

TEST(RunFolder, InputHashKnowsWhatStandsInTheFilesOfACase) {
  const results::ScratchFolder scratch;
  Case input = with_text("profile = 'bumps.csv'");
  input.slider.profile = "bumps.csv";
  input.slider.profile_heights = {{0, 1}, {0, 1}, {0, 0, 0, 1e-6}};
  Case other = input;
  EXPECT_EQ(input_hash(input), input_hash(other));
  other.slider.profile_heights.height[3] = 2e-6;
  EXPECT_NE(input_hash(input), input_hash(other));

  input.strain.kind = StrainSourceKind::file;
  input.strain.file = (scratch.path() / "strain.h5").string();
  std::ofstream(input.strain.file) << "one history";
  const std::string first = input_hash(input);
  EXPECT_EQ(input_hash(input), first);
  std::ofstream(input.strain.file) << "another one";
  EXPECT_NE(input_hash(input), first);
}

} // namespace
} // namespace ionskin::study
