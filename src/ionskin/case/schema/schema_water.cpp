// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/schema/schema_rows.hpp"

#include "ionskin/case/schema/schema_setters.hpp"

#include <string>
#include <utility>

namespace ionskin {

using units::Dimension;

namespace {

const Names<WaterWall> walls{
    {"sealed", WaterWall::sealed}, {"open", WaterWall::open}, {"permeable", WaterWall::permeable}};

constexpr const char* stiffness = "stiffness without water pressure";
constexpr const char* speed = "speed of the water";

SchemaRow quantity(const char* key, Dimension dimension, const Range& range, const char* purpose,
                   double Water::*member, const char* help) {
  return {.key = key,
          .type = ValueType::quantity,
          .dimension = dimension,
          .range = range,
          .need = Need::one_of_several,
          .purpose = purpose,
          .applies = moves_water,
          .help = help,
          .set = into(&Case::water, member)};
}

SchemaRow wall(const char* key, WaterWall Water::*member, const char* help) {
  return {.key = key,
          .type = ValueType::choice,
          .applies = moves_water,
          .default_value = "\"sealed\"",
          .choices = {{"sealed"}, {"open"}, {"permeable"}},
          .help = help,
          .source = "a metal electrode without cracks lets no water through",
          .set = into<Water, WaterWall>(&Case::water, member, walls)};
}

void add_outside(SchemaRows& rows, const std::string& side, double Water::*conductance,
                 double Water::*pressure) {
  rows.push_back({.key = "water." + side + "_conductance",
                  .type = ValueType::quantity,
                  .dimension = Dimension::hydraulic_conductance,
                  .range = {1e-25, 1e3, true, true},
                  .need = Need::where_known,
                  .applies = moves_water,
                  .help = "Water that a wall \"permeable\" lets through, volume per area, time and "
                          "pressure.",
                  .set = into(&Case::water, conductance)});
  rows.push_back({.key = "water." + side + "_pressure",
                  .type = ValueType::quantity,
                  .dimension = Dimension::stress,
                  .range = {-1e9, 1e9, true, true},
                  .applies = moves_water,
                  .default_value = "\"0 Pa\"",
                  .help =
                      "Pressure of the water outside an open or permeable wall, above that at "
                      "rest, from the first instant on; with strain.source = \"prescribed\" it "
                      "goes over time as the load. Of moist air, R T/V_w times the logarithm of "
                      "its humidity over that at rest.",
                  .source = "the skin rests in equilibrium with what is around it",
                  .set = into(&Case::water, pressure)});
}

} // namespace

void add_water(SchemaRows& rows) {
  rows.push_back({.key = "water.drag_number",
                  .type = ValueType::number,
                  .range = {0.0, 100.0, true, true},
                  .range_reason = "no membrane drags a hundred molecules",
                  .need = Need::always,
                  .applies = moves_water,
                  .of_material = true,
                  .help = "Water molecules that a cation drags along, the electro-osmotic drag "
                          "number; where it is not given, the one of the material of the core.",
                  .set = into(&Case::water, &Water::drag_number)});
  rows.push_back({.key = "water.drained_poissons_ratio",
                  .type = ValueType::number,
                  .range = {0.0, 0.5, false, false},
                  .need = Need::one_of_several,
                  .purpose = stiffness,
                  .applies = moves_water,
                  .help =
                      "Poisson's ratio of the core at constant water potential, after its water "
                      "has moved; that of the material is the undrained one. Or give "
                      "water.drained_modulus.",
                  .set = into(&Case::water, &Water::drained_poissons_ratio)});
  rows.push_back(
      quantity("water.drained_modulus", Dimension::stress, {1e3, 1e12, true, true}, stiffness,
               &Water::drained_modulus,
               "Oedometric modulus M of the core at constant water potential, instead of "
               "water.drained_poissons_ratio."));
  rows.push_back(quantity("water.permeability", Dimension::area, {1e-30, 1e-9, true, true}, speed,
                          &Water::permeability,
                          "Hydraulic permeability of the core at zero current, with "
                          "water.viscosity; or give water.mobility or "
                          "water.consolidation_coefficient."));
  rows.push_back({.key = "water.viscosity",
                  .type = ValueType::quantity,
                  .dimension = Dimension::viscosity,
                  .range = {1e-6, 1e3, true, true},
                  .applies = moves_water,
                  .default_value = "\"0.89 mPa s\"",
                  .help = "Viscosity of the water, for water.permeability.",
                  .source = "water at 25 degC (Kestin et al. 1978, doi 10.1063/1.555581)",
                  .set = into(&Case::water, &Water::viscosity)});
  rows.push_back(quantity("water.mobility", Dimension::hydraulic_mobility,
                          {1e-27, 1e-6, true, true}, speed, &Water::mobility,
                          "Hydraulic mobility of the core at zero current, permeability over "
                          "viscosity; where no key tells the speed of the water, the one of the "
                          "material of the core."));
  rows.back().of_material = true;
  rows.push_back(quantity("water.consolidation_coefficient", Dimension::diffusivity,
                          {1e-20, 1e-2, true, true}, speed, &Water::consolidation_coefficient,
                          "Diffusivity of water pressure in the core, instead of "
                          "water.permeability or water.mobility."));
  rows.push_back({.key = "water.dilution",
                  .type = ValueType::choice,
                  .applies = moves_water,
                  .default_value = "\"mixture\"",
                  .choices = {{"mixture"}, {"pore-water"}},
                  .help =
                      "Whether swelling dilutes the cations in the volume of the whole core, or "
                      "in that of its pore water, 1/water.volume_fraction times as much.",
                  .source = "the smaller of the two: the range is a choice of the model",
                  .set = into<Water, WaterDilution>(&Case::water, &Water::dilution,
                                                    {{"mixture", WaterDilution::mixture},
                                                     {"pore-water", WaterDilution::pore_water}})});
  rows.push_back({.key = "water.volume_fraction",
                  .type = ValueType::number,
                  .range = {0.0, 1.0, false, false},
                  .need = Need::where_known,
                  .applies = moves_water,
                  .of_material = true,
                  .help = "Share of water in the volume of the core, of water.dilution = "
                          "\"pore-water\"; where it is not given, the one of the material of the "
                          "core.",
                  .set = into(&Case::water, &Water::volume_fraction)});
  rows.push_back(
      wall("water.bottom_wall", &Water::bottom_wall, "Whether water passes the lower electrode."));
  rows.push_back(
      wall("water.top_wall", &Water::top_wall, "Whether water passes the upper electrode."));
  add_outside(rows, "bottom", &Water::bottom_conductance, &Water::bottom_pressure);
  add_outside(rows, "top", &Water::top_conductance, &Water::top_pressure);
}

} // namespace ionskin
