// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/check_readout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace ionskin {

namespace {

/// Name of what no taxel covers.
constexpr const char* rest_name = "rest";

std::string taxel_key(std::size_t taxel, const std::string& property) {
  return fmt::format("readout.taxels[{}].{}", taxel, property);
}

std::vector<Pointer> places(const CaseDocument& document, std::size_t first,
                            const std::string& property, std::size_t second) {
  std::vector<Pointer> all = document.point_at(taxel_key(first, property), "first");
  for (const Pointer& pointer : document.point_at(taxel_key(second, property), "second"))
    all.push_back(pointer);
  return all;
}

bool is_column_name(const std::string& name) {
  return !name.empty() && name != rest_name && std::ranges::all_of(name, [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-';
  });
}

void check_rectangle(const CaseDocument& document, std::size_t index, Problems& problems) {
  const Taxel& taxel = document.input.readout.taxels[index];
  const std::array<double, 2> size{document.input.skin.length, document.input.skin.width};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double low = taxel.lower[axis] * 1e3, high = taxel.upper[axis] * 1e3;
    const char* direction = axis == 0 ? "x" : "y";
    if (low >= high)
      problems.add(fmt::format("the taxel \"{}\" has no extent along {}: it reaches from {:.6g} mm "
                               "to {:.6g} mm",
                               taxel.name, direction, low, high),
                   document.point_at(taxel_key(index, "upper")),
                   "upper must be greater than lower along x and along y");
    else if (taxel.upper[axis] > size[axis] * (1 + 1e-12))
      problems.add(
          fmt::format("the taxel \"{}\" leaves the top face: it reaches to {:.6g} mm along "
                      "{}, the skin to {:.6g} mm",
                      taxel.name, high, direction, size[axis] * 1e3),
          document.point_at(taxel_key(index, "upper")),
          fmt::format("it must be at most {:.6g} mm along {}", size[axis] * 1e3, direction));
  }
}

bool overlap(const Taxel& first, const Taxel& second) {
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double rounding = 1e-9 * (first.upper[axis] - first.lower[axis]);
    if (first.upper[axis] <= second.lower[axis] + rounding ||
        second.upper[axis] <= first.lower[axis] + rounding)
      return false;
  }
  return true;
}

void check_pair(const CaseDocument& document, std::size_t first, std::size_t second,
                Problems& problems) {
  const Taxel& one = document.input.readout.taxels[first];
  const Taxel& other = document.input.readout.taxels[second];
  if (one.name == other.name)
    problems.add(fmt::format("two taxels have the name \"{}\"", one.name),
                 places(document, first, "name", second), "give every taxel a name of its own");
  if (overlap(one, other))
    problems.add(fmt::format("the taxels \"{}\" and \"{}\" overlap", one.name, other.name),
                 places(document, first, "lower", second),
                 "move their corners apart: charge belongs to one taxel only");
}

/// A key that the circuit does not use is a circuit that the user forgot to name.
void check_circuit(const CaseDocument& document, Problems& problems) {
  struct Use {
    const char* key;
    ReadoutCircuit circuit;
    const char* name;
  };
  static constexpr std::array<Use, 5> uses{
      {{"readout.load_resistance", ReadoutCircuit::load, "load"},
       {"readout.amplifier_bandwidth", ReadoutCircuit::amplifier, "amplifier"},
       {"readout.amplifier_noise_density", ReadoutCircuit::amplifier, "amplifier"},
       {"readout.amplifier_range", ReadoutCircuit::amplifier, "amplifier"},
       {"readout.noise_seed", ReadoutCircuit::amplifier, "amplifier"}}};
  for (const Use& use : uses) {
    const std::vector<Pointer> given = document.point_at(use.key);
    if (!given.empty() && document.input.readout.circuit != use.circuit)
      problems.add(fmt::format("{} is given, but the circuit has none", use.key), given,
                   fmt::format("set readout.circuit = \"{}\", or remove the key", use.name));
  }
}

} // namespace

void check_readout(const CaseDocument& document, Problems& problems) {
  check_circuit(document, problems);
  const std::vector<Taxel>& taxels = document.input.readout.taxels;
  for (std::size_t i = 0; i < taxels.size(); ++i) {
    if (!is_column_name(taxels[i].name))
      problems.add(fmt::format("\"{}\" cannot name a taxel", taxels[i].name),
                   document.point_at(taxel_key(i, "name")),
                   "use letters, digits, _ and -; \"rest\" is what no taxel covers");
    check_rectangle(document, i, problems);
    for (std::size_t j = 0; j < i; ++j)
      check_pair(document, j, i, problems);
  }
}

} // namespace ionskin
