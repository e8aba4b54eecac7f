// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/fit/fit_log.hpp"

#include "ionskin/base/digest.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/base/files/sealed_file.hpp"
#include "ionskin/results/hdf5/foreign_hdf5_file.hpp"

#include <array>
#include <utility>

namespace ionskin::study {
namespace {

constexpr const char* extension = ".h5";
constexpr const char* failure_name = "failure";
const std::string place = std::string(results::file_names::evaluations) + "/";

bool is_evaluation(const std::string& name) {
  return name.starts_with(place) && name.ends_with(extension);
}

using Ions = electrochemistry::IonSolution;

struct Column {
  const char* name;
  std::vector<double> Ions::*values;
};

constexpr std::array<Column, 6> columns = {{{"/time", &Ions::time},
                                            {"/charge_top", &Ions::charge_top},
                                            {"/charge_bottom", &Ions::charge_bottom},
                                            {"/relaxation_charge", &Ions::relaxation_charge},
                                            {"/relaxation_current", &Ions::relaxation_current},
                                            {"/voltage", &Ions::voltage}}};

using Segment = electrochemistry::SegmentCharge;

constexpr const char* taxel_name = "taxel";

struct TaxelSeries {
  const char* name;
  std::vector<double> Segment::*values;
};

constexpr std::array<TaxelSeries, 4> taxel_series = {{{"/taxel_charge", &Segment::charge},
                                                      {"/taxel_bottom", &Segment::bottom_charge},
                                                      {"/taxel_voltage", &Segment::voltage},
                                                      {"/taxel_passed", &Segment::passed}}};

FitAnswer read_answer(const results::ForeignHdf5File& file) {
  if (const auto failure = file.text_attribute("/", failure_name)) {
    return {nullptr, *failure};
  }
  Ions ions;
  for (const Column& column : columns) {
    if (file.has(column.name)) { // a column without rows is not written
      ions.*column.values = file.read(column.name);
    }
  }
  const std::string taxel = file.text_attribute("/", taxel_name).value_or("");
  if (!taxel.empty()) {
    Segment& segment = ions.top_segments.emplace_back();
    segment.name = taxel;
    for (const TaxelSeries& one : taxel_series) {
      if (file.has(one.name)) {
        segment.*one.values = file.read(one.name);
      }
    }
  }
  return fit_answer(ions, taxel);
}

} // namespace

FitAnswer fit_answer(const electrochemistry::IonSolution& ions, const std::string& taxel) {
  Ions part;
  for (const Column& column : columns) {
    part.*column.values = ions.*column.values;
  }
  for (const auto* segments : {&ions.top_segments, &ions.lines}) {
    for (const Segment& segment : *segments) {
      if (!taxel.empty() && segment.name == taxel) {
        part.top_segments.push_back(segment);
        part.top_segments.back().bypassed.clear();
      }
    }
  }
  return {std::make_shared<const Ions>(std::move(part)), ""};
}

FitLog::FitLog(results::OutputFolder& folder) : folder_(folder) {
  for (const std::string& name : folder_.owned()) {
    if (is_evaluation(name)) {
      take_up(folder_.file(name));
    }
  }
  taken_up_ = answers_.size();
}

void FitLog::take_up(const std::filesystem::path& path) {
  if (base::check_seal(path) != base::SealState::whole) {
    return; // Damaged, as by a power cut, or of another build: the point is solved again.
  }
  try {
    const results::ForeignHdf5File file(path);
    answers_[file.has("/point") ? file.read("/point") : std::vector<double>()] = read_answer(file);
  } catch (const UserError&) {
    // The file is not what its name says: the point is solved again.
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
  const std::string name = place + base::DigestBuilder().add(point).finish().hex() + extension;
  base::PendingFile pending(folder_.own(name));
  results::Hdf5File file(pending.path(), results::Hdf5File::Access::create);
  if (!point.empty()) { // empty where only keys of the data are free
    file.write("/point", point);
  }
  if (answer.ions) {
    for (const Column& column : columns) {
      if (const auto& values = (*answer.ions).*column.values; !values.empty()) {
        file.write(column.name, values);
      }
    }
    for (const Segment& taxel : answer.ions->top_segments) {
      file.set_attribute("/", taxel_name, taxel.name);
      for (const TaxelSeries& one : taxel_series) {
        if (!(taxel.*one.values).empty()) {
          file.write(one.name, taxel.*one.values);
        }
      }
    }
  } else {
    file.set_attribute("/", failure_name, answer.failure);
  }
  file.close();
  base::seal(pending.path());
  pending.commit();
}

void FitLog::remove() {
  for (const std::string& name : folder_.owned()) {
    if (is_evaluation(name)) {
      folder_.remove(name);
    }
  }
  std::error_code ignored; // only an empty folder is removed
  std::filesystem::remove(folder_.file(results::file_names::evaluations), ignored);
}

} // namespace ionskin::study
