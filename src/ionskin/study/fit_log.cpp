// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/fit_log.hpp"

#include "ionskin/base/digest.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/results/atomic_file.hpp"
#include "ionskin/results/foreign_hdf5_file.hpp"

#include <utility>

namespace ionskin::study {
namespace {

constexpr const char* extension = ".h5";
constexpr const char* failure_name = "failure";

FitAnswer read_answer(const results::ForeignHdf5File& file) {
  if (const auto failure = file.text_attribute("/", failure_name)) {
    return {std::nullopt, *failure};
  }
  return {file.read("/answer"), ""};
}

} // namespace

FitLog::FitLog(std::filesystem::path folder) : folder_(std::move(folder)) {
  std::filesystem::create_directories(folder_);
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    if (entry.path().extension() == extension) {
      take_up(entry.path());
    }
  }
  taken_up_ = answers_.size();
}

void FitLog::take_up(const std::filesystem::path& path) {
  try {
    const results::ForeignHdf5File file(path);
    answers_[file.read("/point")] = read_answer(file);
  } catch (const UserError&) {
    // Damaged, as by a power cut: it is solved again.
  }
}

std::optional<FitAnswer> FitLog::find(const std::vector<double>& point) const {
  const std::lock_guard lock(mutex_);
  const auto found = answers_.find(point);
  return found == answers_.end() ? std::nullopt : std::optional(found->second);
}

void FitLog::add(const std::vector<double>& point, const FitAnswer& answer) {
  const std::lock_guard lock(mutex_);
  answers_[point] = answer;
  const std::string name = base::DigestBuilder().add(point).finish().hex() + extension;
  results::PendingFile pending(folder_ / name);
  results::Hdf5File file(pending.path(), results::Hdf5File::Access::create);
  file.write("/point", point);
  if (answer.values) {
    file.write("/answer", *answer.values);
  } else {
    file.set_attribute("/", failure_name, answer.failure);
  }
  file.close();
  pending.commit();
}

void FitLog::remove() {
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    if (entry.path().extension() == extension) {
      std::filesystem::remove(entry.path());
    }
  }
  std::error_code ignored; // only an empty folder goes
  std::filesystem::remove(folder_, ignored);
}

} // namespace ionskin::study
