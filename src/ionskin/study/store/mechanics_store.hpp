// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/study/store/mechanics_record.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ionskin::study {

/// Finished Study 1 of several cases, found by its hash (`mechanics_hash`) in the results.h5 that
/// runs left. A file counts while its seal says that this build wrote it and nothing changed since.
class MechanicsStore {
public:
  /// Adds a file that may hold the mechanics of this hash. Files added first are read first.
  void add(const std::string& hash, const std::filesystem::path& file);
  /// True if a file holds the mechanics of this hash; its arrays are not read.
  static bool holds(const std::filesystem::path& file, const std::string& hash);
  /// Mechanics of this hash; empty where no file holds it. A file that fails is not asked again.
  std::optional<MechanicsRecord> read(const std::string& hash, const Skin& skin);
  /// Reasons why damaged files were passed over, for the user.
  const std::vector<std::string>& notes() const { return notes_; }

private:
  std::optional<MechanicsRecord> read_file(const std::filesystem::path& file,
                                           const std::string& hash, const Skin& skin);

  std::map<std::string, std::vector<std::filesystem::path>> files_; ///< by hash
  std::vector<std::string> notes_;
};

} // namespace ionskin::study
