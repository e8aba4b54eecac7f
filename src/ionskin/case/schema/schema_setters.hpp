// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/error.hpp"
#include "ionskin/case/schema/schema.hpp"

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace ionskin {

// Setters of the schema's rows: each stores a read value in one member of the draft.

using Setter = std::function<void(CaseDraft&, const KeyIndex&, const Value&)>;

inline void store(const Value& value, double& target) {
  target = value.numbers[0];
}
inline void store(const Value& value, int& target) {
  target = static_cast<int>(value.numbers[0]);
}
inline void store(const Value& value, std::string& target) {
  target = value.text;
}
inline void store(const Value& value, std::vector<double>& target) {
  target = value.numbers;
}
inline void store(const Value& value, std::array<double, 2>& target) {
  target = {value.numbers[0], value.numbers[1]};
}

/// Into a member of one section of the case.
template <typename Section, typename Member>
Setter into(Section Case::*section, Member Section::*member) {
  return [=](CaseDraft& draft, const KeyIndex&, const Value& value) {
    store(value, (draft.input.*section).*member);
  };
}

template <typename Member> Setter into_layer(Member Layer::*member) {
  return [=](CaseDraft& draft, const KeyIndex& index, const Value& value) {
    store(value, draft.input.skin.layers[index.entry].*member);
  };
}

template <typename Member> Setter into_taxel(Member Taxel::*member) {
  return [=](CaseDraft& draft, const KeyIndex& index, const Value& value) {
    store(value, draft.input.readout.taxels[index.entry].*member);
  };
}

template <typename Member> Setter into_material(Member Material::*member) {
  return [=](CaseDraft& draft, const KeyIndex& index, const Value& value) {
    store(value, draft.materials[index.material].*member);
  };
}

/// The names of an enumeration's constants.
template <typename Enum> using Names = std::vector<std::pair<std::string, Enum>>;

/// The constant of a name that `read_value` has checked.
template <typename Enum> Enum constant_of(const Names<Enum>& names, const std::string& name) {
  for (const auto& [known, constant] : names)
    if (known == name)
      return constant;
  throw InternalError("a choice without a constant: " + name);
}

template <typename Section, typename Enum>
Setter into(Section Case::*section, Enum Section::*member, const Names<Enum>& names) {
  return [=](CaseDraft& draft, const KeyIndex&, const Value& value) {
    (draft.input.*section).*member = constant_of(names, value.text);
  };
}

template <typename Enum> Setter into_layer(Enum Layer::*member, const Names<Enum>& names) {
  return [=](CaseDraft& draft, const KeyIndex& index, const Value& value) {
    draft.input.skin.layers[index.entry].*member = constant_of(names, value.text);
  };
}

} // namespace ionskin
