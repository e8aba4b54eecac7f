// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/units/dimension.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>

namespace ionskin::laws {

/// Declaration of a parameter that only one law has (a friction law, coupling law, circuit or
/// slider shape). From it the schema makes a key of the case file, `contact.NAME`, `coupling.NAME`,
/// `readout.NAME` or `slider.NAME`, with its checks, help and documentation.
struct LawParameter {
  std::string_view name;
  units::Dimension dimension = units::Dimension::number;
  bool whole = false;             ///< true if the value must be an integer
  double lowest = 0, highest = 0; ///< allowed range, ends included [SI unit of `dimension`]
  std::string_view help;          ///< one sentence for the user
  std::string_view default_value; ///< as TOML, such as "\"4 MPa\""; empty: a case must give a value
  std::string_view source;        ///< source of the default value
};

/// Values of the parameters of a law, by name [SI].
using LawValues = std::map<std::string, double, std::less<>>;

/// Declared parameter, with the member of the law's struct that stores its value.
template <class Law> struct OwnParameter {
  LawParameter declared;
  double Law::*member = nullptr;
};

/// Empty list of parameters, for a law that has none of its own.
template <class Law> inline constexpr std::array<OwnParameter<Law>, 0> no_parameters{};

/// Declarations of all parameters of a law, taken from `Law::parameters()`, which returns an array
/// of `OwnParameter`. The span stays valid for the life of the process.
template <class Law> std::span<const LawParameter> declared_parameters() {
  constexpr std::size_t count = Law::parameters().size();
  static const auto table = [] {
    std::array<LawParameter, count> result;
    for (std::size_t i = 0; i < count; ++i) {
      result[i] = Law::parameters()[i].declared;
    }
    return result;
  }();
  return table;
}

/// True if the table `laws` has a law named `law` with a parameter named `parameter`.
template <class Law>
bool has_parameter(std::span<const Law> laws, std::string_view law, std::string_view parameter) {
  return std::ranges::any_of(laws, [&](const Law& candidate) {
    return candidate.name == law &&
           std::ranges::find(candidate.parameters, parameter, &LawParameter::name) !=
               candidate.parameters.end();
  });
}

/// Creates a law and sets all its parameters.
/// @param values must hold every parameter of the law, else std::out_of_range is thrown
template <class Law> Law with_parameters(const LawValues& values) {
  Law law;
  for (const OwnParameter<Law>& own : Law::parameters()) {
    law.*own.member = values.at(std::string(own.declared.name));
  }
  return law;
}

/// Creates a friction or coupling law from its coefficient, which every such law has, and the
/// values of its own parameters.
template <class Law> Law law_with(double coefficient, const LawValues& values) {
  Law law = with_parameters<Law>(values);
  law.coefficient = coefficient;
  return law;
}

} // namespace ionskin::laws
