// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/error.hpp"
#include "ionskin/base/files/disk_cache.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <thread>

namespace ionskin::base {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::byte>;

Bytes filled(std::size_t size, int value) {
  return Bytes(size, static_cast<std::byte>(value));
}

Digest key_of(int number) {
  return DigestBuilder().add(number).finish();
}

class DiskCacheTest : public testing::Test {
protected:
  DiskCacheTest() {
    std::string name = (fs::temp_directory_path() / "ionskin-cache-XXXXXX").string();
    folder = mkdtemp(name.data());
  }
  ~DiskCacheTest() override { fs::remove_all(folder); }

  void put(DiskCache& cache, int number, const Bytes& content) {
    cache.write(key_of(number), {content});
  }
  fs::path file_of(int number) const { return folder / (key_of(number).hex() + ".ionskin-cache"); }
  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
  }
  /// Overwrites one byte of an entry; negative places count from its end.
  void spoil(int number, std::ptrdiff_t place) const {
    std::fstream file(file_of(number), std::ios::in | std::ios::out | std::ios::binary);
    file.seekg(place, place < 0 ? std::ios::end : std::ios::beg);
    const char byte = static_cast<char>(file.get() ^ 0x10);
    file.seekp(place, place < 0 ? std::ios::end : std::ios::beg);
    file.put(byte);
  }
  void expect_ignored_and_replaced(DiskCache& cache, int number) {
    EXPECT_FALSE(cache.read(key_of(number)));
    EXPECT_EQ(cache.take_notes().size(), 1u);
    EXPECT_FALSE(fs::exists(file_of(number)));
    put(cache, number, filled(1000, 2));
    EXPECT_EQ(cache.read(key_of(number)), filled(1000, 2));
    EXPECT_TRUE(cache.take_notes().empty());
  }
  fs::path folder;
};

TEST(Digest, depends_on_every_value_and_on_where_texts_end) {
  const auto of = [](const auto&... values) {
    DigestBuilder builder;
    (builder.add(values), ...);
    return builder.finish();
  };
  EXPECT_EQ(of(1.0, 2.0), of(1.0, 2.0));
  EXPECT_NE(of(1.0, 2.0), of(2.0, 1.0));
  EXPECT_NE(of(0.0), of(-0.0));
  EXPECT_NE(of(std::string_view("ab"), std::string_view("c")),
            of(std::string_view("a"), std::string_view("bc")));
  EXPECT_NE(of(std::vector<double>{1.0}), of(std::vector<double>{1.0, 0.0}));
  EXPECT_EQ(of(1.0).hex().size(), 32u);
}

TEST_F(DiskCacheTest, gives_back_what_was_kept) {
  DiskCache cache(folder / "new" / "folder", 1'000'000);
  EXPECT_FALSE(cache.read(key_of(1)));
  const Bytes content = filled(30, 1);
  const std::span<const std::byte> all(content);
  cache.write(key_of(1), {all.first(10), all.subspan(10)});
  EXPECT_EQ(cache.read(key_of(1)), content);
  EXPECT_FALSE(cache.read(key_of(2)));
  EXPECT_TRUE(cache.take_notes().empty());
}

TEST_F(DiskCacheTest, truncated_entry_is_ignored_and_replaced) {
  DiskCache cache(folder, 1'000'000);
  for (const std::uintmax_t size : {std::uintmax_t{900}, std::uintmax_t{30}, std::uintmax_t{0}}) {
    put(cache, 1, filled(1000, 1));
    fs::resize_file(file_of(1), size);
    expect_ignored_and_replaced(cache, 1);
  }
}

TEST_F(DiskCacheTest, changed_byte_anywhere_is_noticed) {
  DiskCache cache(folder, 1'000'000);
  for (const std::ptrdiff_t place : {0, 8, 12, 16, 32, 40, 500, -1}) {
    put(cache, 1, filled(1000, 1));
    spoil(1, place);
    expect_ignored_and_replaced(cache, 1);
  }
}

TEST_F(DiskCacheTest, entry_under_a_wrong_name_is_ignored) {
  DiskCache cache(folder, 1'000'000);
  put(cache, 1, filled(1000, 1));
  fs::rename(file_of(1), file_of(2));
  expect_ignored_and_replaced(cache, 2);
}

TEST_F(DiskCacheTest, least_recently_used_entries_make_room) {
  DiskCache cache(folder, 2'500);
  put(cache, 1, filled(1000, 1));
  put(cache, 2, filled(1000, 2));
  const auto now = fs::file_time_type::clock::now();
  fs::last_write_time(file_of(1), now - std::chrono::hours(2));
  fs::last_write_time(file_of(2), now - std::chrono::hours(1));
  EXPECT_TRUE(cache.read(key_of(1))); // now the most recent one
  put(cache, 3, filled(1000, 3));
  EXPECT_TRUE(cache.read(key_of(1)));
  EXPECT_FALSE(cache.read(key_of(2)));
  EXPECT_TRUE(cache.read(key_of(3)));
  put(cache, 4, filled(3000, 4));
  EXPECT_FALSE(cache.read(key_of(4)));
  EXPECT_EQ(cache.take_notes().size(), 1u);
}

TEST_F(DiskCacheTest, only_its_own_files_are_removed) {
  std::ofstream(folder / "thesis.txt") << std::string(5000, 'x');
  DiskCache cache(folder, 1'500);
  put(cache, 1, filled(1000, 1));
  put(cache, 2, filled(1000, 2));
  EXPECT_TRUE(fs::exists(folder / "thesis.txt"));
  EXPECT_FALSE(fs::exists(file_of(1)));
}

TEST_F(DiskCacheTest, what_a_killed_writer_left_is_no_entry_and_goes_in_time) {
  DiskCache cache(folder, 1'000'000);
  const fs::path left = folder / (key_of(1).hex() + "-77-0.ionskin-pending");
  std::ofstream(left) << "half";
  EXPECT_FALSE(cache.read(key_of(1)));
  put(cache, 2, filled(10, 2));
  EXPECT_TRUE(fs::exists(left)); // its writer may still be at work
  fs::last_write_time(left, fs::file_time_type::clock::now() - std::chrono::hours(2));
  put(cache, 3, filled(10, 3));
  EXPECT_FALSE(fs::exists(left));
  EXPECT_TRUE(cache.take_notes().empty());
}

TEST_F(DiskCacheTest, readers_see_whole_entries_only_while_others_write) {
  std::vector<int> broken(4);
  {
    std::vector<std::jthread> threads;
    for (int t = 0; t < 4; ++t) {
      threads.emplace_back([this, t, &broken] {
        DiskCache cache(folder, 1'000'000); // of its own, as another process would have
        for (int i = 0; i < 10; ++i) {
          put(cache, 1, filled(20'000, t));
          const auto content = cache.read(key_of(1));
          broken[t] += !content || content->size() != 20'000 ||
                       std::count(content->begin(), content->end(), content->front()) != 20'000;
        }
        broken[t] += static_cast<int>(cache.take_notes().size());
      });
    }
  }
  EXPECT_EQ(broken, std::vector<int>(4));
  EXPECT_EQ(files(), 1u);
}

TEST_F(DiskCacheTest, full_disk_costs_the_entry_only) {
  DiskCache cache(folder, 1'000'000);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit small = before;
  small.rlim_cur = 600;
  const auto former = std::signal(SIGXFSZ, SIG_IGN); // as the program and Python do
  setrlimit(RLIMIT_FSIZE, &small);
  put(cache, 1, filled(1000, 1));
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, former);
  EXPECT_EQ(files(), 0u);
  EXPECT_FALSE(cache.read(key_of(1)));
  const auto notes = cache.take_notes();
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes.front().find("File too large"), std::string::npos) << notes.front();
}

TEST_F(DiskCacheTest, what_users_keep_beside_the_entries_stays) {
  const std::string key = key_of(9).hex();
  const std::vector<std::string> own{"notes.ionskin-cache", "draft.ionskin-pending", key + ".txt",
                                     key + "-old.ionskin-cache"};
  for (const std::string& name : own) {
    std::ofstream(folder / name) << std::string(5000, 'x');
    fs::last_write_time(folder / name, fs::file_time_type::clock::now() - std::chrono::hours(9));
  }
  std::ofstream(folder / "thesis.txt") << "mine";
  fs::create_symlink(folder / "thesis.txt", file_of(7));
  DiskCache cache(folder, 1'500);
  put(cache, 1, filled(1000, 1));
  put(cache, 2, filled(1000, 2));
  EXPECT_EQ(cache.content().entries, 1u);
  EXPECT_FALSE(cache.contains(key_of(7)));
  EXPECT_FALSE(cache.read(key_of(7)));
  put(cache, 7, filled(100, 7));
  EXPECT_TRUE(cache.read(key_of(7)));
  EXPECT_EQ(cache.clear().entries, 2u);
  for (const std::string& name : own) {
    EXPECT_EQ(fs::file_size(folder / name), 5000u) << name;
  }
  EXPECT_EQ(fs::file_size(folder / "thesis.txt"), 4u);
  EXPECT_EQ(files(), own.size() + 1);
}

TEST_F(DiskCacheTest, folder_that_cannot_be_made_costs_the_entry_only) {
  std::ofstream(folder / "file") << "x";
  DiskCache cache(folder / "file" / "cache", 1'000'000);
  put(cache, 1, filled(1000, 1));
  put(cache, 2, filled(1000, 2));
  EXPECT_EQ(cache.take_notes().size(), 1u); // once
  EXPECT_FALSE(cache.read(key_of(1)));
}

TEST_F(DiskCacheTest, a_pipe_in_place_of_an_entry_is_not_waited_for) {
  DiskCache cache(folder, 1'000'000);
  ASSERT_EQ(mkfifo(file_of(1).c_str(), 0600), 0);
  EXPECT_FALSE(cache.read(key_of(1)));
  EXPECT_EQ(files(), 0u);
}

TEST(CacheSettings, come_from_the_environment) {
  setenv("HOME", "/home/someone", 1);
  unsetenv("XDG_CACHE_HOME");
  unsetenv("IONSKIN_CACHE");
  EXPECT_EQ(cache_folder(), fs::path("/home/someone/.cache/ionskin"));
  setenv("XDG_CACHE_HOME", "/scratch", 1);
  EXPECT_EQ(cache_folder(), fs::path("/scratch/ionskin"));
  setenv("IONSKIN_CACHE", "/fast", 1);
  EXPECT_EQ(cache_folder(), fs::path("/fast"));
  unsetenv("IONSKIN_CACHE_LIMIT");
  EXPECT_EQ(cache_limit(), 5'000'000'000u);
  setenv("IONSKIN_CACHE_LIMIT", "1.5 GB", 1);
  EXPECT_EQ(cache_limit(), 1'500'000'000u);
  for (const char* wrong : {"5", "much", "-1 GB", "5 GiB", "5 GB more", "nan GB"}) {
    setenv("IONSKIN_CACHE_LIMIT", wrong, 1);
    EXPECT_THROW(cache_limit(), UserError) << wrong;
  }
  unsetenv("IONSKIN_CACHE_LIMIT");
}

} // namespace
} // namespace ionskin::base
