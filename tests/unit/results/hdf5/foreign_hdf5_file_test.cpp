// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/hdf5/foreign_hdf5_file.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/results/hdf5/hdf5_handle.hpp"
#include "scratch_folder.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <numeric>
#include <sys/stat.h>

namespace ionskin::results {
namespace {

using Access = Hdf5File::Access;

constexpr hsize_t row = 16; ///< numbers in the datasets of these tests

TEST(ForeignHdf5File, AnswersAsTheLibraryDoes) {
  const ScratchFolder folder;
  const std::vector<double> frame{1, 2, 3, 4, 5, 6};
  {
    Hdf5File file(folder / "a.h5", Access::create);
    file.write_with_unit("/group/matrix", frame, "m", {2, 3});
    file.write("/group/whole", std::vector<int>{1, -2});
    file.write_texts("/names", {"one", "", "three"});
    file.write_text("/text", "a text");
    file.create_frames("/frames", {2, 3, 2});
    file.write_frame("/frames", 0, frame);
    file.repeat_frame("/frames", 0, 1);
    file.set_attribute("/", "number", 2.5);
  }
  const ForeignHdf5File file(folder / "a.h5");
  EXPECT_EQ(file.members("/"), (std::vector<std::string>{"frames", "group", "names", "text"}));
  EXPECT_TRUE(file.has("/group/matrix"));
  EXPECT_FALSE(file.has("/group/other"));
  EXPECT_FALSE(file.has("/no/group"));
  EXPECT_TRUE(file.has_numbers("/group/whole"));
  EXPECT_FALSE(file.has_numbers("/names"));
  EXPECT_EQ(file.shape("/group/matrix"), (Hdf5File::Shape{2, 3}));
  EXPECT_EQ(file.read("/group/matrix"), frame);
  EXPECT_EQ(file.read("/group/whole"), (std::vector<double>{1, -2}));
  EXPECT_EQ(file.read_texts("/names"), (std::vector<std::string>{"one", "", "three"}));
  EXPECT_EQ(file.read_text("/text"), "a text");
  std::vector<double> values;
  file.read_frame("/frames", 1, values);
  EXPECT_EQ(values, frame);
  EXPECT_EQ(file.text_attribute("/group/matrix", "unit"), "m");
  EXPECT_EQ(file.text_attribute("/", "other"), std::nullopt);
  EXPECT_EQ(file.number_attribute("/", "number"), 2.5);
  EXPECT_NO_THROW(file.require_plain());
  EXPECT_NE(message_of<UserError>([&] { file.read("/missing"); }).find("a.h5 has no /missing"),
            std::string::npos);
}

TEST(ForeignHdf5File, SeveralAreOpenAtOnce) {
  const ScratchFolder folder;
  Hdf5File(folder / "a.h5", Access::create).write("/v", std::vector<double>{1});
  Hdf5File(folder / "b.h5", Access::create).write("/v", std::vector<double>{2});
  const ForeignHdf5File a(folder / "a.h5"), b(folder / "b.h5");
  EXPECT_EQ(a.read("/v")[0] + 10 * b.read("/v")[0], 21);
  EXPECT_FALSE(a.digest() == b.digest());
}

TEST(ForeignHdf5File, TheFileMayChangeOnceItIsOpen) {
  const ScratchFolder folder;
  Hdf5File(folder / "a.h5", Access::create).write("/v", std::vector<double>{1});
  const ForeignHdf5File file(folder / "a.h5");
  write_all(folder / "a.h5", "something else");
  EXPECT_EQ(file.read("/v"), std::vector<double>{1});
}

TEST(ForeignHdf5File, OnlyRegularFilesAreOpened) {
  const ScratchFolder folder;
  const auto message = [](const std::filesystem::path& path) {
    return message_of<UserError>([&] { ForeignHdf5File file(path); });
  };
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_NE(message(folder / "pipe").find("is a pipe"), std::string::npos);
  EXPECT_NE(message(folder.path()).find("is a folder"), std::string::npos);
  EXPECT_NE(message("/dev/zero").find("is a device"), std::string::npos);
  EXPECT_NE(message(folder / "missing").find("cannot be read"), std::string::npos);
  write_all(folder / "empty", "");
  EXPECT_NE(message(folder / "empty").find("is not an HDF5 file"), std::string::npos);
}

struct Trap {
  const char* name;
  std::function<void(hid_t file, const ScratchFolder&)> set;
  std::vector<std::string> words; ///< of the message
};

hid_t make_dataset(hid_t file, hid_t type, std::vector<hsize_t> extents,
                   const std::function<void(hid_t)>& prepare) {
  const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
  prepare(properties);
  const hid_t space = H5Screate_simple(static_cast<int>(extents.size()), extents.data(), nullptr);
  return H5Dcreate2(file, "/data", type, space, H5P_DEFAULT, properties, H5P_DEFAULT);
}

const std::vector<Trap> traps{
    {"external link",
     [](hid_t file, const ScratchFolder& folder) {
       Hdf5File(folder / "secret.h5", Access::create).write("/data", std::vector<double>(row, 1));
       H5Lcreate_external("secret.h5", "/data", file, "/data", H5P_DEFAULT, H5P_DEFAULT);
     },
     {"/data is an external link"}},
    {"soft link",
     [](hid_t file, const ScratchFolder&) {
       H5Lcreate_soft("/elsewhere", file, "/data", H5P_DEFAULT, H5P_DEFAULT);
     },
     {"/data is a soft link"}},
    {"external storage",
     [](hid_t file, const ScratchFolder& folder) {
       write_all(folder / "secret", std::string(row * sizeof(double), 's'));
       make_dataset(file, H5T_IEEE_F64LE, {row}, [&](hid_t properties) {
         H5Pset_external(properties, (folder / "secret").c_str(), 0, row * sizeof(double));
       });
     },
     {"keeps its values in another file"}},
    {"virtual dataset",
     [](hid_t file, const ScratchFolder&) {
       make_dataset(file, H5T_IEEE_F64LE, {row}, [](hid_t properties) {
         const hid_t space = H5Screate_simple(1, &row, nullptr);
         H5Pset_virtual(properties, space, "missing.h5", "/data", space);
       });
     },
     {"is a virtual dataset"}},
    {"never written",
     [](hid_t file, const ScratchFolder&) {
       make_dataset(file, H5T_IEEE_F64LE, {row}, [](hid_t) {});
     },
     {"was never written"}},
    {"never written pieces",
     [](hid_t file, const ScratchFolder&) {
       make_dataset(file, H5T_IEEE_F64LE, {row}, [](hid_t properties) {
         const hsize_t piece = 4;
         H5Pset_chunk(properties, 1, &piece);
       });
     },
     {"0 of its 4 chunks are there"}},
    {"unknown filter",
     [](hid_t file, const ScratchFolder&) {
       make_dataset(file, H5T_IEEE_F64LE, {row}, [](hid_t properties) {
         constexpr H5Z_filter_t of_plugin = 32001;
         H5Pset_chunk(properties, 1, &row);
         H5Pset_filter(properties, of_plugin, H5Z_FLAG_OPTIONAL, 0, nullptr);
       });
     },
     {"HDF5 filter 32001"}},
    {"huge piece",
     [](hid_t file, const ScratchFolder&) {
       static constexpr hsize_t many = 400'000'000;
       make_dataset(file, H5T_IEEE_F64LE, {many},
                    [](hid_t properties) { H5Pset_chunk(properties, 1, &many); });
     },
     {"chunks of 3.2e+09 bytes"}},
    {"compound type",
     [](hid_t file, const ScratchFolder&) {
       const hid_t type = H5Tcreate(H5T_COMPOUND, sizeof(double));
       H5Tinsert(type, "x", 0, H5T_IEEE_F64LE);
       make_dataset(file, type, {row}, [](hid_t) {});
     },
     {"neither numbers nor texts"}},
    {"more values than memory",
     [](hid_t file, const ScratchFolder&) {
       make_dataset(file, H5T_IEEE_F64LE, {1'000'000'000'000'000'000},
                    [](hid_t properties) { H5Pset_chunk(properties, 1, &row); });
     },
     {"GB of memory", "are free"}}};

TEST(ForeignHdf5File, WhatIsNotInTheFileItselfOrTooLargeIsRefused) {
  const ScratchFolder folder;
  for (const Trap& trap : traps) {
    SCOPED_TRACE(trap.name);
    const std::filesystem::path path = folder / "trap.h5";
    const hid_t id = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    trap.set(id, folder);
    ASSERT_GE(H5close(), 0);
    const std::string message = message_of<UserError>([&] { ForeignHdf5File(path).read("/data"); });
    for (const std::string& word : trap.words) {
      EXPECT_NE(message.find(word), std::string::npos) << "'" << word << "' not in: " << message;
    }
    EXPECT_NE(message.find("trap.h5"), std::string::npos) << message;
    EXPECT_NE(message.find("\n  = "), std::string::npos) << "no remedy: " << message;
  }
}

TEST(ForeignHdf5File, AGroupThatHoldsItselfEnds) {
  const ScratchFolder folder;
  {
    Hdf5File file(folder / "a.h5", Access::create);
    file.write("/group/v", std::vector<double>{1});
  }
  const hid_t id = H5Fopen((folder / "a.h5").c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  H5Lcreate_hard(id, "/group", id, "/group/again", H5P_DEFAULT, H5P_DEFAULT);
  H5Fclose(id);
  EXPECT_THROW(ForeignHdf5File(folder / "a.h5").require_plain(), UserError);
}

} // namespace
} // namespace ionskin::results
