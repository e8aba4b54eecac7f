// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <fstream>
#include <string_view>

namespace ionskin::results {

/// A place beside the final name of a file: written there, then renamed, so that readers see either
/// the old file or the complete new one. What is not committed is removed.
class PendingFile {
public:
  explicit PendingFile(std::filesystem::path final_path);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  /// Where to write.
  const std::filesystem::path& path() const { return pending_; }
  /// Gives the file its final name. Throws UserError when that fails.
  void commit();

private:
  std::filesystem::path final_, pending_;
  bool committed_ = false;
};

/// A text file that appears under its name only when `commit` is called.
class AtomicFile {
public:
  /// Throws UserError when the file cannot be created.
  explicit AtomicFile(std::filesystem::path path);

  std::ostream& stream() { return stream_; }
  /// Throws UserError when anything could not be written.
  void commit();

private:
  PendingFile pending_;
  std::ofstream stream_;
};

/// Writes a whole text file at once, atomically. Throws UserError when it cannot.
void write_text_file(const std::filesystem::path& path, std::string_view text);

} // namespace ionskin::results
