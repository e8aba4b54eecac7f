// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/store/mechanics_store.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/files/sealed_file.hpp"
#include "ionskin/results/hdf5/foreign_hdf5_file.hpp"
#include "ionskin/study/store/mechanics_file.hpp"

#include <fmt/format.h>

namespace ionskin::study {

void MechanicsStore::add(const std::string& hash, const std::filesystem::path& file) {
  files_[hash].push_back(file);
}

bool MechanicsStore::holds(const std::filesystem::path& file, const std::string& hash) {
  if (base::check_seal(file) != base::SealState::whole) {
    return false;
  }
  try { // whoever damages a file can seal it again
    const results::ForeignHdf5File content(file);
    return content.has("/path") && content.text_attribute("/path", "mechanics_hash") == hash;
  } catch (const UserError&) {
    return false;
  }
}

std::optional<MechanicsRecord> MechanicsStore::read(const std::string& hash, const Skin& skin) {
  std::vector<std::filesystem::path>& files = files_[hash];
  while (!files.empty()) {
    if (auto record = read_file(files.front(), hash, skin)) {
      return record;
    }
    files.erase(files.begin());
  }
  return std::nullopt;
}

std::optional<MechanicsRecord> MechanicsStore::read_file(const std::filesystem::path& file,
                                                         const std::string& hash,
                                                         const Skin& skin) {
  const base::SealState state = base::check_seal(file);
  if (state == base::SealState::damaged) {
    notes_.push_back(
        fmt::format("{} was damaged: what it held is done again.", file.filename().string()));
  }
  if (state != base::SealState::whole) {
    return std::nullopt;
  }
  try { // the seal does not show a write that failed unnoticed
    return read_mechanics(file, hash, skin);
  } catch (const UserError& error) {
    notes_.push_back(std::string("The mechanics is solved again: ") + error.what());
    return std::nullopt;
  }
}

} // namespace ionskin::study
