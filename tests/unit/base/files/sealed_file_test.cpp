// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/files/sealed_file.hpp"

#include "ionskin/base/system/own_build.hpp"
#include "scratch_folder.hpp"

#include <gtest/gtest.h>

namespace ionskin::base {
namespace {

using results::read_all;
using results::ScratchFolder;
using results::write_all;

TEST(SealedFile, NoticesEveryChangedByteAndEveryCut) {
  const ScratchFolder folder;
  const auto path = folder / "file";
  write_all(path, "content of some length");
  EXPECT_EQ(check_seal(path), SealState::damaged) << "not sealed";
  seal(path);
  const std::string whole = read_all(path);
  EXPECT_EQ(check_seal(path), SealState::whole);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    std::string changed = whole;
    changed[i] = static_cast<char>(changed[i] ^ 0x10);
    write_all(path, changed);
    EXPECT_EQ(check_seal(path), SealState::damaged) << i;
    write_all(path, whole.substr(0, i));
    EXPECT_EQ(check_seal(path), SealState::damaged) << i;
  }
  write_all(path, whole + "x");
  EXPECT_EQ(check_seal(path), SealState::damaged);
}

TEST(SealedFile, OfAnotherBuildIsDistinguished) {
  const ScratchFolder folder;
  const auto path = folder / "file";
  write_all(path, "content");
  seal(path);
  std::string text = read_all(path);
  const std::string other(32, 'a');
  text.replace(text.find(own_build()->hex()), other.size(), other);
  const Digest digest = DigestBuilder()
                            .add_bytes(std::as_bytes(std::span(text).first(7)))
                            .add(std::string_view(other))
                            .finish();
  text.replace(text.rfind(' ') + 1, 32, digest.hex());
  write_all(path, text);
  EXPECT_EQ(check_seal(path), SealState::other_build);
}

TEST(SealedFile, NeitherALinkNorAFolderIsOne) {
  const ScratchFolder folder;
  write_all(folder / "file", "content");
  seal(folder / "file");
  std::filesystem::create_symlink(folder / "file", folder / "link");
  EXPECT_EQ(check_seal(folder / "link"), SealState::damaged);
  EXPECT_EQ(check_seal(folder.path()), SealState::damaged);
  EXPECT_EQ(check_seal(folder / "none"), SealState::absent);
  EXPECT_FALSE(digest_if_readable(folder / "link"));
}

} // namespace
} // namespace ionskin::base
