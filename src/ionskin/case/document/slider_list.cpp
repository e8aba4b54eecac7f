// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/document/slider_list.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/laws/friction/friction_law.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>

namespace ionskin {
namespace {

constexpr const char* list = "slider";
/// Tables of a case that an entry of the list may have itself.
constexpr std::array sections{"motion", "contact"};

const toml::value* entries_of(const TomlText& values) {
  const auto& tables = values.root().as_table();
  const auto found = tables.find(list);
  const bool is_list = found != tables.end() && found->second.is_array();
  return is_list ? &found->second : nullptr;
}

/// Finds a table by its name in an entry of the list or in the whole case; nullptr if there is
/// none.
const toml::value* section_of(const toml::value& table, const std::string& name) {
  const auto found = table.as_table().find(name);
  return found == table.as_table().end() ? nullptr : &found->second;
}

std::vector<Pointer> pointers_of(const CaseDocument& one, const std::string& note_of_one,
                                 const CaseDocument& other, const std::string& note_of_other,
                                 const std::vector<std::string>& keys) {
  std::vector<Pointer> pointers;
  for (const std::string& key : keys) {
    for (const auto& [document, note] : {std::pair{&one, note_of_one}, {&other, note_of_other}}) {
      for (Pointer& pointer : document->point_at(key, note)) {
        pointers.push_back(std::move(pointer));
      }
    }
  }
  return pointers;
}

/// Refuses several sliders if one is on a drive or adheres. Their paths are solved one after
/// another and repeated until they agree, and such a slider may jump from one repetition to the
/// next.
void check_rigid_paths(const std::vector<CaseDocument>& documents, Problems& problems) {
  for (std::size_t i = 0; i < documents.size(); ++i) {
    const Case& input = documents[i].input;
    if (input.motion.drive.given()) {
      problems.add(fmt::format("slider[{}] hangs on a drive", i),
                   documents[i].point_at("motion.drive.stiffness"),
                   "several sliders on one skin go along rigid paths: leave motion.drive out");
    }
    if (laws::friction_law(input.contact.law).adheres) {
      problems.add(fmt::format("slider[{}] adheres", i), documents[i].point_at("contact.law"),
                   "several sliders on one skin do not adhere: choose another contact.law");
    }
  }
}

void check_durations(const std::vector<CaseDocument>& documents, Problems& problems) {
  constexpr double rounding = 1e-9;
  const Motion& first = documents.front().input.motion;
  const double duration = first.cycle_duration();
  for (std::size_t i = 1; i < documents.size(); ++i) {
    const Motion& own = documents[i].input.motion;
    const std::string name = fmt::format("slider[{}]", i);
    if (std::abs(own.cycle_duration() - duration) > rounding * duration) {
      problems.add(
          fmt::format("the cycle of {} lasts {:.6g} s, that of slider[0] {:.6g} s", name,
                      own.cycle_duration(), duration),
          pointers_of(documents.front(), "slider[0]", documents[i], name,
                      {"motion.touchdown", "motion.slide", "motion.lift", "motion.return"}),
          "several sliders on one skin need cycles of one duration: let one wait");
    }
    if (own.cycles != first.cycles) {
      problems.add(
          fmt::format("{} goes through {} cycles, slider[0] through {}", name, own.cycles,
                      first.cycles),
          pointers_of(documents.front(), "slider[0]", documents[i], name, {"motion.cycles"}),
          "write motion.cycles once, for all sliders");
    }
  }
}

} // namespace

std::size_t listed_sliders(const TomlText& values) {
  const toml::value* entries = entries_of(values);
  if (entries == nullptr) {
    return 0;
  }
  const std::size_t count = entries->as_array().size();
  if (count == 0 || count > most_sliders) {
    throw UserError(fmt::format("the case has a list of {} sliders\n  = write one section "
                                "[[slider]] for each of them, at most {}",
                                count, most_sliders));
  }
  for (const toml::value& entry : entries->as_array()) {
    if (!entry.is_table()) {
      throw UserError("slider must be a table, or a list of tables\n  = write [slider], or one "
                      "section [[slider]] for each slider");
    }
  }
  return count;
}

TomlText with_slider(const TomlText& values, std::size_t slider) {
  toml::value root = values.root();
  toml::value entry = entries_of(values)->as_array()[slider];
  for (const std::string section : sections) {
    const toml::value* own = section_of(entry, section);
    if (own == nullptr) {
      continue;
    }
    const auto shared = root.as_table().find(section);
    if (shared != root.as_table().end() && shared->second.is_table() && own->is_table()) {
      auto& table = shared->second.as_table();
      // Keys of the case would have no effect on another kind of motion: only `cycles` is kept.
      if (own->as_table().contains("kind")) {
        std::erase_if(table, [](const auto& shared_key) { return shared_key.first != "cycles"; });
      }
      for (const auto& [name, value] : own->as_table()) {
        table[name] = value;
      }
    } else {
      root.as_table()[section] = *own;
    }
    entry.as_table().erase(section);
  }
  root.as_table()[list] = std::move(entry);
  return values.with_root(std::move(root));
}

std::string listed_key(const TomlText& values, std::size_t slider, const std::string& key) {
  const toml::value* entries = entries_of(values);
  if (entries == nullptr) {
    return key;
  }
  const auto in_entry = [&](const std::string& rest) {
    return fmt::format("{}[{}].{}", list, slider, rest);
  };
  if (key.starts_with("slider.")) {
    return in_entry(key.substr(std::string("slider.").size()));
  }
  for (const std::string section : sections) {
    if (!key.starts_with(section + ".")) {
      continue;
    }
    const toml::value* own = section_of(entries->as_array()[slider], section);
    const std::string name = key.substr(section.size() + 1);
    if (own != nullptr && own->is_table() &&
        own->as_table().contains(name.substr(0, name.find_first_of("[.")))) {
      return in_entry(key);
    }
  }
  return key;
}

CaseDocument joined_sliders(const TomlText& values, std::vector<CaseDocument> documents) {
  Problems problems;
  check_rigid_paths(documents, problems);
  check_durations(documents, problems);
  problems.throw_if_any(documents.front().file);
  Case input = documents.front().input;
  std::vector<ValueRecord> records;
  std::set<std::string> known;
  for (std::size_t i = 0; i < documents.size(); ++i) {
    for (ValueRecord& record : documents[i].records) {
      record.key = listed_key(values, i, record.key);
      if (known.insert(record.key).second) {
        records.push_back(std::move(record));
      }
    }
    Case& own = documents[i].input;
    if (i > 0) {
      input.further_sliders.push_back({own.slider, own.motion, own.contact});
    }
  }
  return {std::move(input), documents.front().file, std::move(records)};
}

} // namespace ionskin
