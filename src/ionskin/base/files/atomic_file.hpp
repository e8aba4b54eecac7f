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

/// Last part of the names of files that are being written; what bears it is ionskin's, and a killed
/// program may leave it behind.
inline constexpr const char* pending_suffix = ".ionskin-pending";

/// A file could not be written; the message names it and the remedy.
class UnwritableFile : public UserError {
public:
  UnwritableFile(const std::filesystem::path& path, std::string reason);
  const std::string& reason() const { return reason_; } ///< of the system, without the file's name

private:
  std::string reason_;
};

/// A file under a name of its own beside the final one: written there, flushed to the disk, then
/// renamed, so that readers and a power cut see either the old file or the complete new one. A link
/// under the final name is replaced, never followed. A file that is not committed is removed.
/// Errors: UnwritableFile.
class PendingFile {
public:
  /// Makes the file, still empty.
  explicit PendingFile(std::filesystem::path final_path);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  /// Where to write, for libraries that open the file themselves.
  const std::filesystem::path& path() const { return pending_; }
  /// Writes bytes behind those already written.
  void write(std::span<const std::byte> bytes);
  /// Flushes the file, gives it its final name and flushes the folder.
  void commit();

private:
  std::filesystem::path final_, pending_;
  int descriptor_;
  bool committed_ = false;
};

/// A text file that appears under its name only when `commit` is called.
class AtomicFile {
public:
  /// Throws UnwritableFile when the file cannot be created.
  explicit AtomicFile(std::filesystem::path path);
  ~AtomicFile();

  /// Never fails: `commit` reports the errors.
  std::ostream& stream() { return stream_; }
  /// Throws UnwritableFile when anything could not be written.
  void commit();

private:
  class Buffer;
  PendingFile pending_;
  std::unique_ptr<Buffer> buffer_;
  std::ostream stream_;
};

/// Writes a whole text file at once, atomically. Throws UnwritableFile.
void write_text_file(const std::filesystem::path& path, std::string_view text);

/// Removes the temporary files that killed writers left in a folder. Links are not followed.
void remove_pending_files(const std::filesystem::path& folder);

} // namespace ionskin::base
