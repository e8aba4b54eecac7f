// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/store/mechanics_cache.hpp"

#include "ionskin/study/store/mechanics_file.hpp"
#include "scratch_folder.hpp"
#include "synthetic_contact.hpp"

#include <gtest/gtest.h>

#include <fstream>

namespace ionskin::study {
namespace {

constexpr std::uintmax_t plenty = 100'000'000; // bytes

class MechanicsCache : public ::testing::Test {
protected:
  MechanicsCache() {
    record.maps = {{-1e-3, 1e-3}, {-1e-3, 1e-3}, {}}; // the synthetic states have no surfaces
    write_mechanics(written(), "hash", record);
  }
  std::filesystem::path written() const { return scratch.path() / "results.h5"; }
  std::filesystem::path copy() const { return scratch.path() / "copy.h5"; }
  std::filesystem::path entries() const { return scratch.path() / "cache"; }

  results::ScratchFolder scratch;
  Case input = handover::small_case();
  MechanicsRecord record = make_mechanics_record(input, handover::synthetic_contact(input));
  base::DiskCache cache{entries(), plenty};
};

TEST_F(MechanicsCache, GivesBackWhatWasKept) {
  EXPECT_FALSE(recall_mechanics(cache, "hash", input.skin, copy()));
  EXPECT_FALSE(std::filesystem::exists(copy()));
  EXPECT_FALSE(keeps_mechanics(cache, "hash"));
  keep_mechanics(cache, "hash", written());
  EXPECT_TRUE(keeps_mechanics(cache, "hash"));
  const auto recalled = recall_mechanics(cache, "hash", input.skin, copy());
  ASSERT_TRUE(recalled);
  EXPECT_EQ(recalled->normal_force, record.normal_force);
  EXPECT_EQ(recalled->history.time, record.history.time);
  EXPECT_TRUE(read_mechanics(copy(), "hash", input.skin)) << "the run goes on with the file";
}

TEST_F(MechanicsCache, GivesNothingForAnotherCase) {
  keep_mechanics(cache, "hash", written());
  EXPECT_FALSE(recall_mechanics(cache, "other", input.skin, copy()));
  EXPECT_FALSE(std::filesystem::exists(copy()));
}

TEST_F(MechanicsCache, GivesNothingFromATruncatedEntry) {
  keep_mechanics(cache, "hash", written());
  for (const auto& entry : std::filesystem::directory_iterator(entries())) {
    std::filesystem::resize_file(entry.path(), entry.file_size() / 2);
  }
  EXPECT_FALSE(recall_mechanics(cache, "hash", input.skin, copy()));
  EXPECT_FALSE(std::filesystem::exists(copy()));
  EXPECT_FALSE(cache.take_notes().empty());
}

TEST_F(MechanicsCache, TellsBuildsApart) {
  const auto program = scratch.path() / "program";
  EXPECT_FALSE(base::build_digest(program));
  std::ofstream(program) << "one build";
  const auto one = base::build_digest(program);
  std::ofstream(program) << "another build";
  const auto other = base::build_digest(program);
  ASSERT_TRUE(one && other && own_build());
  keep_mechanics(cache, "hash", written(), one);
  EXPECT_TRUE(recall_mechanics(cache, "hash", input.skin, copy(), one));
  EXPECT_FALSE(recall_mechanics(cache, "hash", input.skin, copy(), other));
}

TEST_F(MechanicsCache, AnUnknownBuildKeepsAndFindsNothing) {
  keep_mechanics(cache, "hash", written(), std::nullopt);
  EXPECT_TRUE(!std::filesystem::exists(entries()) || std::filesystem::is_empty(entries()));
  keep_mechanics(cache, "hash", written());
  EXPECT_FALSE(recall_mechanics(cache, "hash", input.skin, copy(), std::nullopt));
}

} // namespace
} // namespace ionskin::study
