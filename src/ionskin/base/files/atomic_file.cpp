// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/files/atomic_file.hpp"

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <optional>
#include <streambuf>
#include <system_error>
#include <unistd.h>

namespace ionskin::base {
namespace {

namespace fs = std::filesystem;

fs::path pending_name(const fs::path& path) {
  static std::atomic<unsigned> counter{0};
  fs::path pending = path;
  pending += fmt::format(".{}-{}{}", ::getpid(), counter++, pending_suffix);
  return pending;
}

/// Flushes the folder of a file to disk, so that a power cut does not undo the renaming. Returns
/// false, with errno set, on failure; a file system that cannot flush folders does not count.
bool flush_folder(const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) {
    return true;
  }
  const bool flushed = ::fsync(descriptor) == 0 || errno == EINVAL || errno == ENOTSUP;
  const int reason = errno;
  ::close(descriptor);
  errno = reason;
  return flushed;
}

} // namespace

UnwritableFile::UnwritableFile(const fs::path& path, std::string reason)
    : UserError(fmt::format("the file {} cannot be written: {}\n  = check the free space and the "
                            "permissions of its folder, or choose another with -o",
                            path.string(), reason)),
      reason_(std::move(reason)) {}

PendingFile::PendingFile(fs::path final_path)
    : final_(std::move(final_path)), pending_(pending_name(final_)),
      descriptor_(
          ::open(pending_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0) {
    throw UnwritableFile(final_, std::strerror(errno));
  }
}

PendingFile::~PendingFile() {
  ::close(descriptor_);
  if (!committed_) {
    ::unlink(pending_.c_str());
  }
}

void PendingFile::write(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
    if (count < 0 && errno != EINTR) {
      throw UnwritableFile(final_, std::strerror(errno));
    }
    bytes = bytes.subspan(count > 0 ? static_cast<std::size_t>(count) : 0);
  }
}

void PendingFile::commit() {
  if (::fsync(descriptor_) != 0 || ::rename(pending_.c_str(), final_.c_str()) != 0) {
    throw UnwritableFile(final_, std::strerror(errno));
  }
  committed_ = true;
  if (!flush_folder(final_)) {
    throw UnwritableFile(final_, std::strerror(errno));
  }
}

/// Stream buffer that writes to a `PendingFile`. It stores the first failure and silently discards
/// all later output, so that libraries which write to the stream do not end the program with errors
/// of their own; `finish` throws the failure.
class AtomicFile::Buffer : public std::streambuf {
public:
  explicit Buffer(PendingFile& file) : file_(file) {
    setp(buffer_.data(), buffer_.data() + buffer_.size());
  }
  void finish() {
    flush();
    if (failure_) {
      throw *failure_;
    }
  }

protected:
  int_type overflow(int_type letter) override {
    flush();
    if (!traits_type::eq_int_type(letter, traits_type::eof())) {
      *pptr() = traits_type::to_char_type(letter);
      pbump(1);
    }
    return traits_type::not_eof(letter);
  }
  int sync() override {
    flush();
    return 0;
  }

private:
  void flush() {
    try {
      if (!failure_) {
        file_.write(std::as_bytes(std::span(pbase(), pptr())));
      }
    } catch (const UnwritableFile& failure) {
      failure_ = failure;
    }
    setp(buffer_.data(), buffer_.data() + buffer_.size());
  }

  PendingFile& file_;
  std::array<char, 65536> buffer_;
  std::optional<UnwritableFile> failure_;
};

AtomicFile::AtomicFile(fs::path path)
    : pending_(std::move(path)), buffer_(std::make_unique<Buffer>(pending_)),
      stream_(buffer_.get()) {}

AtomicFile::~AtomicFile() = default;

void AtomicFile::commit() {
  buffer_->finish();
  pending_.commit();
}

void write_text_file(const fs::path& path, std::string_view text) {
  PendingFile file(path);
  file.write(std::as_bytes(std::span(text.data(), text.size())));
  file.commit();
}

void remove_pending_files(const fs::path& folder) {
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    std::error_code ignored;
    if (at->path().extension() == pending_suffix &&
        fs::is_regular_file(at->symlink_status(ignored))) {
      fs::remove(at->path(), ignored);
    }
  }
}

} // namespace ionskin::base
