// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/base/error.hpp"
#include "ionskin/case/schema/schema.hpp"

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace ionskin {

// Setters of the schema's rows: each stores a value that was read in one member of the draft.

/// Function that stores a value in the draft of a case, as `SchemaRow::set`.
using Setter = std::function<void(CaseDraft&, const KeyIndex&, const Value&)>;

/// Stores a scalar number [SI].
inline void store(const Value& value, double& target) {
  target = value.numbers[0];
}
/// Stores a whole number.
inline void store(const Value& value, int& target) {
  target = static_cast<int>(value.numbers[0]);
}
/// Stores a text or the name of a choice.
inline void store(const Value& value, std::string& target) {
  target = value.text;
}
/// Stores a list of numbers [SI].
inline void store(const Value& value, std::vector<double>& target) {
  target = value.numbers;
}
/// Stores a pair of numbers [SI].
inline void store(const Value& value, std::array<double, 2>& target) {
  target = {value.numbers[0], value.numbers[1]};
}

/// Makes a setter of a member of one section of the case.
template <typename Section, typename Member>
Setter into(Section Case::*section, Member Section::*member) {
  return [=](CaseDraft& draft, const KeyIndex&, const Value& value) {
    store(value, (draft.input.*section).*member);
  };
}

/// Makes a setter of a member of one layer, by `KeyIndex::entry`.
template <typename Member> Setter into_layer(Member Layer::*member) {
  return [=](CaseDraft& draft, const KeyIndex& index, const Value& value) {
    store(value, draft.input.skin.layers[index.entry].*member);
  };
}

/// Makes a setter of a member of one taxel, by `KeyIndex::entry`.
template <typename Member> Setter into_taxel(Member Taxel::*member) {
  return [=](CaseDraft& draft, const KeyIndex& index, const Value& value) {
    store(value, draft.input.readout.taxels[index.entry].*member);
  };
}

/// Makes a setter of a member of one material, by `KeyIndex::material`.
template <typename Member> Setter into_material(Member Material::*member) {
  return [=](CaseDraft& draft, const KeyIndex& index, const Value& value) {
    store(value, draft.materials[index.material].*member);
  };
}

/// Pairs of a name in the case file and the enumeration's constant that it stands for.
template <typename Enum> using Names = std::vector<std::pair<std::string, Enum>>;

/// Looks up the constant of a name, which `read_value` has checked. Throws InternalError for an
/// unknown name.
template <typename Enum> Enum constant_of(const Names<Enum>& names, const std::string& name) {
  for (const auto& [known, constant] : names)
    if (known == name)
      return constant;
  throw InternalError("a choice without a constant: " + name);
}

/// Makes a setter of an enumeration member of one section of the case.
template <typename Section, typename Enum>
Setter into(Section Case::*section, Enum Section::*member, const Names<Enum>& names) {
  return [=](CaseDraft& draft, const KeyIndex&, const Value& value) {
    (draft.input.*section).*member = constant_of(names, value.text);
  };
}

/// Makes a setter of an enumeration member of one layer, by `KeyIndex::entry`.
template <typename Enum> Setter into_layer(Enum Layer::*member, const Names<Enum>& names) {
  return [=](CaseDraft& draft, const KeyIndex& index, const Value& value) {
    draft.input.skin.layers[index.entry].*member = constant_of(names, value.text);
  };
}

} // namespace ionskin
