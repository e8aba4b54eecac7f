// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/hdf5/hdf5_file.hpp"

#include "ionskin/base/error.hpp"
#include "scratch_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sys/resource.h>

namespace ionskin::results {
namespace {

using Access = Hdf5File::Access;

TEST(Hdf5File, ReadsBackNumbersTextsAndAttributes) {
  const ScratchFolder folder;
  {
    Hdf5File file(folder / "a.h5", Access::create);
    file.write("/group/deep/matrix", {1, 2, 3, 4, 5, 6}, {2, 3});
    file.write("/integers", std::vector<int>{3, -4});
    file.write("/nothing", std::vector<double>{});
    file.write_text("/case", "title = \"µ\"\n");
    file.write_text("/empty", "");
    file.write_texts("/phases", {"slide", "", "touchdown"});
    file.set_attribute("/group/deep/matrix", "unit", std::string("mol/m3"));
    file.set_attribute("/", "empty", std::string());
    file.set_attribute("/", "version", 1);
    file.set_attribute("/new/group", "time", 0.25);
    file.close();
  }
  const Hdf5File file(folder / "a.h5", Access::read);
  EXPECT_EQ(file.read("/group/deep/matrix"), (std::vector<double>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(file.shape("/group/deep/matrix"), (Hdf5File::Shape{2, 3}));
  EXPECT_EQ(file.read("/integers"), (std::vector<double>{3, -4}));
  EXPECT_TRUE(file.read("/nothing").empty());
  EXPECT_EQ(file.read_text("/case"), "title = \"µ\"\n");
  EXPECT_EQ(file.read_text("/empty"), "");
  EXPECT_EQ(file.read_texts("/phases"), (std::vector<std::string>{"slide", "", "touchdown"}));
  EXPECT_EQ(file.text_attribute("/group/deep/matrix", "unit"), "mol/m3");
  EXPECT_EQ(file.text_attribute("/", "empty"), "");
  EXPECT_EQ(file.number_attribute("/", "version"), 1);
  EXPECT_EQ(file.number_attribute("/new/group", "time"), 0.25);
  EXPECT_EQ(file.members("/group"), (std::vector<std::string>{"deep"}));
}

/// No file grows beyond so many bytes.
class FileSizeLimit {
public:
  explicit FileSizeLimit(rlim_t bytes) : ignored_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, ignored_);
  }

private:
  rlimit before_{};
  void (*ignored_)(int);
};

/// Values that do not compress.
std::vector<double> noise() {
  std::vector<double> values(4096);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = std::sin(1e3 * static_cast<double>(i * i));
  }
  return values;
}

TEST(Hdf5File, TellsAFrameThatWasLostWhileItsDatasetWasClosed) {
  const ScratchFolder folder;
  Hdf5File file(folder / "a.h5", Access::create);
  file.create_frames("/frames", {2, 4096});
  {
    const FileSizeLimit limit(4096); // a disk that is full for a moment
    file.write_frame("/frames", 0, noise());
  }
  file.write_frame("/frames", 1, noise());
  EXPECT_THROW(file.close(), UserError);
}

void write_one_value(const std::filesystem::path& path) {
  Hdf5File file(path, Access::create);
  file.write("/values", std::vector<double>{1});
  file.close();
}

void fill_disks_and_write_other_files(const ScratchFolder& folder) {
  {
    Hdf5File file(folder / "a.h5", Access::create);
    file.create_frames("/frames", {1, 4096});
    const FileSizeLimit limit(0); // closing it fails, too
    file.write_frame("/frames", 0, noise());
    EXPECT_THROW(file.close(), UserError);
  }
  EXPECT_NO_THROW(write_one_value(folder / "b.h5"));
  {
    Hdf5File given_up(folder / "c.h5", Access::create);
    given_up.create_frames("/frames", {1, 4096});
    const FileSizeLimit limit(1024);
    given_up.write_frame("/frames", 0, noise());
  }
  EXPECT_NO_THROW(write_one_value(folder / "d.h5"));
}

TEST(Hdf5File, AFullDiskIsReportedForNoOtherFile) {
  const ScratchFolder folder;
  // The library keeps, and leaks, the rest of a file that it could not close: a process of its own.
  const auto in_a_child = [&folder] {
    fill_disks_and_write_other_files(folder);
    std::fflush(nullptr);
    std::_Exit(testing::Test::HasFailure() ? 1 : 0);
  };
  EXPECT_EXIT(in_a_child(), testing::ExitedWithCode(0), "");
}

TEST(Hdf5File, TellsWhatIsThere) {
  const ScratchFolder folder;
  Hdf5File file(folder / "a.h5", Access::create);
  file.write("/group/values", std::vector<double>{1});
  file.write_text("/text", "x");
  EXPECT_TRUE(file.has("/"));
  EXPECT_TRUE(file.has("/group"));
  EXPECT_TRUE(file.has("/group/values"));
  EXPECT_FALSE(file.has("/group/other"));
  EXPECT_FALSE(file.has("/missing/values"));
  EXPECT_TRUE(file.has_numbers("/group/values"));
  EXPECT_FALSE(file.has_numbers("/group"));
  EXPECT_FALSE(file.has_numbers("/text"));
  EXPECT_FALSE(file.text_attribute("/group", "unit").has_value());
  EXPECT_FALSE(file.number_attribute("/text", "version").has_value());
  file.remove("/group");
  EXPECT_FALSE(file.has("/group"));
  EXPECT_NO_THROW(file.remove("/group"));
}

TEST(Hdf5File, FramesAreWrittenRepeatedAndReadOneByOne) {
  const ScratchFolder folder;
  const std::vector<double> first(600, 0.25), second(600, -1.5);
  {
    Hdf5File file(folder / "a.h5", Access::create);
    file.create_frames("/strain/gamma", {4, 2, 30, 10});
    file.write_frame("/strain/gamma", 0, first);
    file.write_frame("/strain/gamma", 1, second);
    file.repeat_frame("/strain/gamma", 0, 2);
    file.repeat_frame("/strain/gamma", 1, 3);
    EXPECT_THROW(file.write_frame("/strain/gamma", 0, {1.0}), InternalError);
    file.close();
  }
  const Hdf5File file(folder / "a.h5", Access::read);
  std::vector<double> frame;
  for (std::size_t i = 0; i < 4; ++i) {
    file.read_frame("/strain/gamma", i, frame);
    EXPECT_EQ(frame, i % 2 == 0 ? first : second) << i;
  }
}

TEST(Hdf5File, AttributesAreReplaced) {
  const ScratchFolder folder;
  Hdf5File file(folder / "a.h5", Access::create);
  file.set_attribute("/", "frame", std::string("skin"));
  file.set_attribute("/", "frame", std::string("slider"));
  EXPECT_EQ(file.text_attribute("/", "frame"), "slider");
}

TEST(Hdf5File, ErrorsNameTheFileAndTheObject) {
  const ScratchFolder folder;
  const auto open = [&](const std::string& name) {
    return message_of<UserError>([&] { Hdf5File(folder / name, Access::read); });
  };
  EXPECT_NE(open("missing.h5").find("missing.h5"), std::string::npos);
  write_all(folder / "text.h5", "no data");
  EXPECT_NE(open("text.h5").find("not an HDF5 file"), std::string::npos);
  std::filesystem::create_directory(folder / "folder.h5");
  EXPECT_NE(open("folder.h5").find("is a folder"), std::string::npos);
  EXPECT_THROW(Hdf5File(folder / "missing/a.h5", Access::create), UserError);

  Hdf5File file(folder / "a.h5", Access::create);
  const std::string message = message_of<UserError>([&] { file.read("/gamma"); });
  EXPECT_NE(message.find("a.h5 has no /gamma"), std::string::npos) << message;
}

TEST(Hdf5File, ATruncatedFileIsAUserError) {
  const ScratchFolder folder;
  {
    Hdf5File file(folder / "a.h5", Access::create);
    file.write("/values", std::vector<double>(10000, 1.0));
  }
  std::filesystem::resize_file(folder / "a.h5", 5000);
  EXPECT_THROW(Hdf5File(folder / "a.h5", Access::read).read("/values"), UserError);
}

} // namespace
} // namespace ionskin::results
