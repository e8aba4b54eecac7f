// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/study/store/mechanics_record.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ionskin::study {

/// Index of finished solutions of Study 1 in the results.h5 files that runs left, found by
/// `mechanics_hash`. A file counts only while its seal shows that this build of the program wrote
/// it and that it is unchanged.
class MechanicsStore {
public:
  /// Adds a file that may hold the mechanics of a hash; the file need not exist. Files of one hash
  /// are tried in the order in which they were added.
  void add(const std::string& hash, const std::filesystem::path& file);
  /// True if a file is intact and holds the mechanics of this hash. Does not read its arrays.
  static bool holds(const std::filesystem::path& file, const std::string& hash);
  /// Reads the mechanics of this hash; empty where no file holds it. A file that fails is not tried
  /// again.
  /// @param skin whose core the strain history must cover
  std::optional<MechanicsRecord> read(const std::string& hash, const Skin& skin);
  /// Sentences for the user on damaged files that were skipped.
  const std::vector<std::string>& notes() const { return notes_; }

private:
  std::optional<MechanicsRecord> read_file(const std::filesystem::path& file,
                                           const std::string& hash, const Skin& skin);

  std::map<std::string, std::vector<std::filesystem::path>> files_; ///< by hash
  std::vector<std::string> notes_;
};

} // namespace ionskin::study
