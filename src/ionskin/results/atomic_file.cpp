// SPDX-License-Identifier: Apache-2.0
#include "ionskin/results/atomic_file.hpp"

#include "ionskin/base/error.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <system_error>

namespace ionskin::results {
namespace {

[[noreturn]] void throw_unwritable(const std::filesystem::path& path, const std::string& reason) {
  throw UserError(fmt::format("the file {} cannot be written: {}\n  = check the free space and the "
                              "permissions of its folder, or choose another with -o",
                              path.string(), reason));
}

std::filesystem::path pending_name(const std::filesystem::path& path) {
  std::filesystem::path pending = path;
  pending += ".tmp";
  return pending;
}

} // namespace

PendingFile::PendingFile(std::filesystem::path final_path)
    : final_(std::move(final_path)), pending_(pending_name(final_)) {}

PendingFile::~PendingFile() {
  if (!committed_) {
    std::error_code ignored;
    std::filesystem::remove(pending_, ignored);
  }
}

void PendingFile::commit() {
  std::error_code error;
  std::filesystem::rename(pending_, final_, error);
  if (error) {
    throw_unwritable(final_, error.message());
  }
  committed_ = true;
}

AtomicFile::AtomicFile(std::filesystem::path path) : pending_(std::move(path)) {
  errno = 0;
  stream_.open(pending_.path(), std::ios::binary | std::ios::trunc);
  if (!stream_) {
    throw_unwritable(pending_.path(), std::strerror(errno));
  }
}

void AtomicFile::commit() {
  errno = 0;
  stream_.close();
  if (!stream_) {
    throw_unwritable(pending_.path(), errno == 0 ? "unknown reason" : std::strerror(errno));
  }
  pending_.commit();
}

void write_text_file(const std::filesystem::path& path, std::string_view text) {
  AtomicFile file(path);
  file.stream() << text;
  file.commit();
}

} // namespace ionskin::results
