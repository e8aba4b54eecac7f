// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/error.hpp"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <ostream>
#include <span>
#include <string>
#include <string_view>

namespace ionskin::base {

/// Suffix of temporary files that are being written. Only ionskin uses it; a program that is killed
/// may leave such a file behind.
inline constexpr const char* pending_suffix = ".ionskin-pending";

/// Exception for a file that cannot be written; the message names the file, the reason and the
/// remedy.
class UnwritableFile : public UserError {
public:
  /// @param reason of the failure, from the system
  UnwritableFile(const std::filesystem::path& path, std::string reason);
  /// Reason of the failure, without the name of the file.
  const std::string& reason() const { return reason_; }

private:
  std::string reason_;
};

/// File that is written atomically: under a temporary name in the same folder, then flushed to disk
/// and renamed by `commit`. Readers, even after a power cut, see either the old file or the
/// complete new one. A symbolic link under the final name is replaced, never followed. The
/// destructor removes a file that was not committed. Throws UnwritableFile when writing fails.
class PendingFile {
public:
  /// Creates the empty temporary file.
  explicit PendingFile(std::filesystem::path final_path);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  /// Path of the temporary file, for libraries that open and write it themselves.
  const std::filesystem::path& path() const { return pending_; }
  /// Appends bytes to the file.
  void write(std::span<const std::byte> bytes);
  /// Flushes the file to disk, renames it to its final name and flushes the folder.
  void commit();

private:
  std::filesystem::path final_, pending_;
  int descriptor_;
  bool committed_ = false;
};

/// Output stream to a file that appears under its name, complete, only when `commit` is called.
class AtomicFile {
public:
  /// Creates the temporary file. Throws UnwritableFile when it cannot be created.
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();

  /// Stream to write to. It never reports failure: `commit` does.
  std::ostream& stream() { return stream_; }
  /// Flushes the stream and gives the file its final name. Throws UnwritableFile when anything
  /// could not be written.
  void commit();

private:
  class Buffer;
  PendingFile pending_;
  std::unique_ptr<Buffer> buffer_;
  std::ostream stream_;
};

/// Writes a whole text file atomically. Throws UnwritableFile when it cannot be written.
void write_text_file(const std::filesystem::path& path, std::string_view text);

/// Removes the temporary files (`pending_suffix`) that killed programs left in a folder; does
/// nothing if the folder does not exist. Links are neither followed nor removed.
void remove_pending_files(const std::filesystem::path& folder);

} // namespace ionskin::base
