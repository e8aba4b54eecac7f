// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/schema/schema_rows.hpp"

#include "ionskin/case/schema/schema_setters.hpp"

namespace ionskin {

using units::Dimension;

namespace {

/// Makes the row of a key of older versions, in which cases could share the solution at common
/// positions of the slider. The key is accepted, but has no effect.
SchemaRow of_shared_positions(const std::string& name, const Range& range) {
  return {.key = "numerics.shared_positions." + name,
          .type = ValueType::quantity_pair,
          .dimension = Dimension::length,
          .range = range,
          .need = Need::where_known,
          .has_effect = false,
          .help = "Has no effect any more: cases share no positions of the slider.",
          .set = [](CaseDraft&, const KeyIndex&, const Value&) {}};
}

} // namespace

void add_run_control(SchemaRows& rows) {
  rows.push_back(
      {.key = "numerics.preset",
       .type = ValueType::choice,
       .default_value = "\"standard\"",
       .choices = {{"coarse"}, {"standard"}, {"fine"}},
       .help = "Resolution: coarse for a first look, standard, fine. A run states what error it "
               "leaves.",
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
  rows.push_back({.key = "numerics.error_estimate",
                  .type = ValueType::choice,
                  .default_value = "\"on\"",
                  .choices = {{"on"}, {"off"}},
                  .help = "Whether coarser solutions estimate the errors of the results. Off, the "
                          "results are the same bits, without a stated error.",
                  .set = into<Numerics, bool>(&Case::numerics, &Numerics::error_estimate,
                                              {{"on", true}, {"off", false}})});
  rows.push_back(of_shared_positions("from", place_on_skin));
  rows.push_back(of_shared_positions("to", {1e-9, 10.0, true, true}));
  rows.push_back(of_shared_positions("footprint", {1e-9, 10.0, true, true}));
  rows.push_back({.key = "output.fields",
                  .type = ValueType::quantity_list,
                  .dimension = Dimension::time,
                  .range = {0.0, 1e11, true, true},
                  .default_value = "[]",
                  .help = "Instants at which fields are written.",
                  .set = into(&Case::output, &Output::fields)});
}

} // namespace ionskin
