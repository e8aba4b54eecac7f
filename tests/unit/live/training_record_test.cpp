// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/training/training_record.hpp"

#include "ionskin/base/error.hpp"
#include "small_skin.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace ionskin::live {
namespace {

class TrainingRecordTest : public ::testing::Test {
protected:
  void SetUp() override {
    record.data = small_skin();
    record.footprint = {{1e-3, 2e-3}, {0, 1e-4}};
    record.compared = {6,
                       {{"normal_force", "", 3.5, {0.1, 0.2}, {0.3, 0.4}},
                        {"charge_top", "landing", 1e-8, {1e-10}, {2e-10}}}};
    write_record(path, "a case", record);
  }
  void TearDown() override { std::filesystem::remove(path); }

  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / "ionskin_training_record_test.unfinished";
  TrainingRecord record;
};

TEST_F(TrainingRecordTest, IsReadAsItWasWritten) {
  const TrainingRecord read = read_record(path, "a case");
  EXPECT_EQ(skin_bytes(read.data), skin_bytes(record.data));
  EXPECT_EQ(read.footprint.half_size, record.footprint.half_size);
  EXPECT_EQ(read.footprint.rim, record.footprint.rim);
  EXPECT_EQ(read.compared.count, 6);
  ASSERT_EQ(read.compared.errors.size(), 2);
  for (std::size_t i = 0; i < 2; ++i) {
    const TouchErrors &one = read.compared.errors[i], &other = record.compared.errors[i];
    EXPECT_EQ(one.name, other.name);
    EXPECT_EQ(one.event, other.event);
    EXPECT_EQ(one.largest, other.largest);
    EXPECT_EQ(one.rms, other.rms);
    EXPECT_EQ(one.worst, other.worst);
  }
}

TEST_F(TrainingRecordTest, IsRefusedForAnotherCaseAndWhereItIsDamaged) {
  EXPECT_THROW(read_record(path, "another case"), UserError);
  std::filesystem::resize_file(path, std::filesystem::file_size(path) - 1);
  EXPECT_THROW(read_record(path, "a case"), UserError);
  std::filesystem::resize_file(path, 0);
  EXPECT_THROW(read_record(path, "a case"), UserError);
  std::filesystem::remove(path);
  EXPECT_THROW(read_record(path, "a case"), UserError);
}

} // namespace
} // namespace ionskin::live
