// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/checks/check_water.hpp"

#include "ionskin/base/constants.hpp"
#include "ionskin/case/elastic_constants.hpp"
#include "ionskin/case/schema/schema_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>

namespace ionskin {

namespace {

/// Largest relative difference between two values that are given for the same quantity.
constexpr double agreement = 0.01;

/// Positions of those of the keys that the case gives.
std::vector<Pointer> given(const CaseDocument& document, std::initializer_list<const char*> keys) {
  std::vector<Pointer> places;
  for (const char* key : keys)
    for (const Pointer& pointer : document.point_at(key))
      places.push_back(pointer);
  return places;
}

/// Refuses keys that have no effect under the coupling law of the case.
void check_belonging(const CaseDocument& document, Problems& problems) {
  if (moves_water(document.input)) {
    for (const char* key : {"coupling.coefficient", "coupling.measure"})
      if (const auto places = given(document, {key}); !places.empty())
        problems.add(fmt::format("{} is given, but the law \"poroelastic\" has none: nothing of it "
                                 "is fitted",
                                 key),
                     places, "remove the key, or choose another coupling.law");
    return;
  }
  for (const ValueRecord& record : document.records)
    if (record.key.starts_with("water.") && record.place &&
        (record.origin == ValueOrigin::file || record.origin == ValueOrigin::set_edit))
      problems.add(fmt::format("{} is given, but coupling.law = \"{}\" moves no water", record.key,
                               document.input.coupling.law),
                   {{*record.place, ""}},
                   "set coupling.law = \"poroelastic\", or remove the section [water]");
}

/// Checks that exactly one key gives the drained stiffness.
void check_drained_keys(const CaseDocument& document, Problems& problems) {
  const Water& water = document.input.water;
  const bool ratio = water.drained_poissons_ratio > 0, modulus = water.drained_modulus > 0;
  if (ratio != modulus)
    return;
  problems.add(ratio ? "water.drained_poissons_ratio and water.drained_modulus are both given"
                     : "how stiff the core is once its water has moved is not given",
               given(document, {"water.drained_poissons_ratio", "water.drained_modulus"}),
               ratio ? "give one of them: with the shear modulus, each follows from the other"
                     : "give water.drained_poissons_ratio, such as 0.4, or "
                       "water.drained_modulus, an oedometric modulus");
}

/// Checks that at least one key gives the hydraulic mobility.
void check_mobility_keys(const CaseDocument& document, Problems& problems) {
  const Water& water = document.input.water;
  if (water.permeability == 0 && water.mobility == 0 && water.consolidation_coefficient == 0)
    problems.add("how fast water moves through the core is not given",
                 given(document, {"coupling.law"}),
                 "give water.permeability, water.mobility or water.consolidation_coefficient");
}

/// True if the case gives any key of [water]. If not, the missing section is reported with all its
/// keys.
bool has_water_section(const CaseDocument& document) {
  return std::ranges::any_of(document.records, [](const ValueRecord& record) {
    return record.key.starts_with("water.") && record.origin != ValueOrigin::default_value;
  });
}

void check_drained_stiffness(const CaseDocument& document, Problems& problems) {
  const Water& water = document.input.water;
  const auto places = given(document, {"water.drained_poissons_ratio", "water.drained_modulus"});
  const bool ratio = water.drained_poissons_ratio > 0, modulus = water.drained_modulus > 0;
  const Material& core = document.input.skin.layers[document.input.skin.core_index()].material;
  const double shear = shear_modulus(core), bulk = bulk_modulus(core);
  if (ratio && water.drained_poissons_ratio >= core.poissons_ratio)
    problems.add(fmt::format("water.drained_poissons_ratio = {:.6g} is not below {:.6g}, the "
                             "core's own, which is the undrained one",
                             water.drained_poissons_ratio, core.poissons_ratio),
                 places, "water that leaves makes the core softer: choose a smaller ratio");
  if (modulus && !(water.drained_modulus > 4.0 / 3.0 * shear &&
                   water.drained_modulus < bulk + 4.0 / 3.0 * shear))
    problems.add(
        fmt::format("water.drained_modulus = {:.6g} MPa cannot belong to the core, whose "
                    "shear modulus is {:.6g} MPa",
                    water.drained_modulus / 1e6, shear / 1e6),
        places,
        fmt::format("it must be above {:.6g} MPa, 4/3 of the shear modulus, and below {:.6g} MPa, "
                    "the undrained oedometric modulus",
                    4.0 / 3.0 * shear / 1e6, (bulk + 4.0 / 3.0 * shear) / 1e6));
}

/// Checks that all keys that determine the hydraulic mobility give the same value.
void check_mobility(const CaseDocument& document, Problems& problems) {
  const Water& water = document.input.water;
  const auto places =
      given(document, {"water.permeability", "water.mobility", "water.consolidation_coefficient"});
  const double storage = consolidation_modulus(document.input);
  std::vector<double> mobilities;
  if (water.permeability > 0)
    mobilities.push_back(water.permeability / water.viscosity);
  if (water.mobility > 0)
    mobilities.push_back(water.mobility);
  if (water.consolidation_coefficient > 0)
    mobilities.push_back(water.consolidation_coefficient / storage);
  for (const double other : mobilities)
    if (!(std::abs(other - mobilities.front()) <= agreement * mobilities.front())) {
      problems.add(fmt::format("the keys of the water's mobility disagree: {:.4g} and {:.4g} "
                               "m2/(Pa s)",
                               mobilities.front(), other),
                   places,
                   "give one of them; mobility = permeability / viscosity, and the consolidation "
                   "coefficient is mobility times the drained modulus");
      return;
    }
}

void check_dilution(const CaseDocument& document, Problems& problems) {
  const Case& input = document.input;
  const Water& water = input.water;
  if (water.dilution == WaterDilution::pore_water && water.volume_fraction == 0) {
    problems.add("water.dilution = \"pore-water\" without water.volume_fraction",
                 given(document, {"water.dilution"}),
                 "give water.volume_fraction, the share of water in the core, such as 0.38");
    return;
  }
  if (water.volume_fraction == 0)
    return;
  const double per_cation =
      water.volume_fraction /
      (constants::molar_volume_of_water * input.electrochemistry.resting_concentration());
  if (water.drag_number > per_cation)
    problems.add(
        fmt::format("water.drag_number = {:.6g}, but the core has only {:.4g} molecules of "
                    "water for each cation",
                    water.drag_number, per_cation),
        given(document, {"water.drag_number", "water.volume_fraction"}),
        fmt::format("it must be at most {:.4g}", per_cation));
}

/// Checks that a conductance is given only for a permeable wall, and a pressure outside only for an
/// open or permeable wall.
void check_wall(const CaseDocument& document, const std::string& side, WaterWall wall,
                double conductance, double pressure, Problems& problems) {
  const std::string wall_key = "water." + side + "_wall";
  const std::string conductance_key = "water." + side + "_conductance";
  const std::string pressure_key = "water." + side + "_pressure";
  const bool permeable = wall == WaterWall::permeable;
  if (permeable && conductance == 0)
    problems.add(fmt::format("{} = \"permeable\" without {}", wall_key, conductance_key),
                 given(document, {wall_key.c_str()}),
                 fmt::format("give {}, such as \"1e-14 m/(Pa s)\"", conductance_key));
  if (!permeable && conductance != 0)
    problems.add(fmt::format("{} is given, but {} is not \"permeable\"", conductance_key, wall_key),
                 given(document, {conductance_key.c_str(), wall_key.c_str()}),
                 fmt::format("set {} = \"permeable\", or remove the key", wall_key));
  if (wall == WaterWall::sealed && pressure != 0)
    problems.add(fmt::format("{} is given, but {} is \"sealed\"", pressure_key, wall_key),
                 given(document, {pressure_key.c_str(), wall_key.c_str()}),
                 fmt::format("set {} = \"open\" or \"permeable\", or remove the key", wall_key));
}

void check_walls(const CaseDocument& document, Problems& problems) {
  const Water& water = document.input.water;
  check_wall(document, "bottom", water.bottom_wall, water.bottom_conductance, water.bottom_pressure,
             problems);
  check_wall(document, "top", water.top_wall, water.top_conductance, water.top_pressure, problems);
}

} // namespace

void check_water_keys(const CaseDocument& document, Problems& problems) {
  check_belonging(document, problems);
  if (moves_water(document.input) && has_water_section(document)) {
    check_drained_keys(document, problems);
    check_mobility_keys(document, problems);
  }
}

void check_water(const CaseDocument& document, Problems& problems) {
  if (!moves_water(document.input) || !problems.empty())
    return;
  check_drained_stiffness(document, problems);
  if (problems.empty())
    check_mobility(document, problems);
  check_dilution(document, problems);
  check_walls(document, problems);
}

} // namespace ionskin
