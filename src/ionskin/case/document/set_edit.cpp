// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/document/set_edit.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/case/document/placed_edit.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

namespace ionskin {
namespace {

/// Largest number of rounds, in each of which edits depend on those of the round before. A user's
/// edits need only a few.
constexpr int most_rounds = 20;

/// Keys that edits set, and the tables that contain them.
class Claims {
public:
  /// True if an edit conflicts with a claim: it sets the same key, lies in it, or contains it.
  bool touch(const SetEdit& edit) const {
    const std::vector<std::string> names = edit.tables_and_key();
    return holding_.contains(names.back()) ||
           std::ranges::any_of(names, [&](const auto& name) { return claimed_.contains(name); });
  }
  /// Adds the claim of an edit.
  /// @param claim one of the names of `SetEdit::tables_and_key`
  void add(const SetEdit& edit, const std::string& claim) {
    claimed_.insert(claim);
    for (const std::string& name : edit.tables_and_key()) {
      if (name == claim)
        return;
      holding_.insert(name);
    }
  }

private:
  std::set<std::string> claimed_, holding_;
};

std::vector<TextEdit> in_order_of_text(const std::vector<PlacedEdit>& placed) {
  // At one position, edits with `on_top` come first, the latest of them before all others.
  std::vector<std::tuple<std::size_t, bool, std::ptrdiff_t>> order;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const auto turn = static_cast<std::ptrdiff_t>(i);
    order.emplace_back(placed[i].text.begin, !placed[i].on_top, placed[i].on_top ? -turn : turn);
  }
  std::ranges::sort(order);
  std::vector<TextEdit> edits;
  for (const auto& [begin, after, turn] : order)
    edits.push_back(placed[static_cast<std::size_t>(turn < 0 ? -turn : turn)].text);
  return edits;
}

class Editor {
public:
  explicit Editor(CaseText& text) : text_(text), values_(text.text(), text.file()) {}

  void apply(std::vector<SetEdit> edits) {
    for (int round = 0; !edits.empty(); ++round) {
      if (round == most_rounds)
        refuse_set_edit(edits.front().argument,
                        "edits of this key undo one another again and again", false,
                        "write each key once, or write them in the file");
      edits = apply_independent(edits);
    }
  }

  TomlText take_values() { return std::move(values_); }

private:
  /// Applies the edits that are independent of one another.
  /// @return the edits that depend on others of this round
  std::vector<SetEdit> apply_independent(const std::vector<SetEdit>& edits) {
    std::vector<SetEdit> chosen, left;
    std::vector<PlacedEdit> placed;
    std::map<std::string, std::size_t> of_key; // index into `chosen` of the edit that sets the key
    Claims claims, waiting;
    for (const SetEdit& edit : edits) {
      const std::string key = edit.tables_and_key().back();
      const auto same = of_key.find(key);
      const bool waits = waiting.touch(edit);
      if (!waits && same != of_key.end()) { // the last edit of a key counts
        chosen[same->second] = edit;
        placed[same->second] = place_set_edit(edit, values_);
      } else if (waits || claims.touch(edit)) {
        waiting.add(edit, key);
        left.push_back(edit);
      } else {
        PlacedEdit here = place_set_edit(edit, values_);
        claims.add(edit, here.claim);
        if (here.claim == key)
          of_key.emplace(key, chosen.size());
        chosen.push_back(edit);
        placed.push_back(std::move(here));
      }
    }
    write(chosen, placed);
    return left;
  }

  /// Writes edits that are independent of one another. If the result is not TOML, writes each half
  /// by itself, to find the edit that fails.
  void write(const std::vector<SetEdit>& edits, const std::vector<PlacedEdit>& placed) {
    CaseText trial = text_;
    trial.edit(in_order_of_text(placed));
    std::optional<TomlText> values;
    try {
      values.emplace(trial.text(), trial.file());
    } catch (const UserError&) {
      if (edits.size() == 1)
        refuse_set_edit(edits.front().argument,
                        "this key cannot be added to the case as it is written", false,
                        "write it in the file");
    }
    if (values) {
      text_ = std::move(trial);
      values_ = std::move(*values);
      return;
    }
    const auto middle = edits.begin() + static_cast<std::ptrdiff_t>(edits.size() / 2);
    write_anew({edits.begin(), middle});
    write_anew({middle, edits.end()});
  }

  void write_anew(const std::vector<SetEdit>& edits) {
    std::vector<PlacedEdit> placed;
    for (const SetEdit& edit : edits)
      placed.push_back(place_set_edit(edit, values_));
    write(edits, placed);
  }

  CaseText& text_;
  TomlText values_;
};

} // namespace

TomlText apply_set_edits(CaseText& text, const std::vector<std::string>& arguments) {
  Editor editor(text);
  std::vector<SetEdit> edits;
  for (const std::string& argument : arguments)
    edits.push_back(parse_set_edit(argument));
  editor.apply(std::move(edits));
  return editor.take_values();
}

void apply_set_edit(CaseText& text, const std::string& argument) {
  apply_set_edits(text, {argument});
}

} // namespace ionskin
