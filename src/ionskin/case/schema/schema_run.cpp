// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/schema/schema_rows.hpp"

#include "ionskin/case/schema/schema_setters.hpp"

namespace ionskin {

using units::Dimension;

void add_run_control(SchemaRows& rows) {
  rows.push_back(
      {.key = "numerics.preset",
       .type = ValueType::choice,
       .default_value = "\"standard\"",
       .choices = {{"coarse"}, {"standard"}, {"fine"}},
       .help = "Accuracy: coarse for a first look, standard for 1 %, fine for 0.25 %.",
       .set = into<Numerics, Preset>(
           &Case::numerics, &Numerics::preset,
           {{"coarse", Preset::coarse}, {"standard", Preset::standard}, {"fine", Preset::fine}})});
  rows.push_back({.key = "numerics.mesh_refinement",
                  .type = ValueType::number,
                  .range = {0.1, 10, true, true},
                  .default_value = "1",
                  .help = "Divides every mesh size of the preset; for convergence studies.",
                  .set = into(&Case::numerics, &Numerics::mesh_refinement)});
  rows.push_back({.key = "numerics.time_refinement",
                  .type = ValueType::number,
                  .range = {0.1, 100, true, true},
                  .default_value = "1",
                  .help = "Divides every time step of the preset; for convergence studies.",
                  .set = into(&Case::numerics, &Numerics::time_refinement)});
  rows.push_back({.key = "numerics.time_tolerance",
                  .type = ValueType::number,
                  .range = {0, 0.1, true, true},
                  .default_value = "0",
                  .help = "Error of the charge that one time step may add, against the largest "
                          "charge so far; 0 takes the preset's, 3e-4, 5e-5 or 1.5e-6.",
                  .source = "measured: docs/electrochemistry.md",
                  .set = into(&Case::numerics, &Numerics::time_tolerance)});
  rows.push_back({.key = "output.fields",
                  .type = ValueType::quantity_list,
                  .dimension = Dimension::time,
                  .range = {0.0, 1e11, true, true},
                  .default_value = "[]",
                  .help = "Instants at which fields are written.",
                  .set = into(&Case::output, &Output::fields)});
}

} // namespace ionskin
