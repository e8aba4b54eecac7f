// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/schema/schema_rows.hpp"

#include "ionskin/case/schema/schema_setters.hpp"

namespace ionskin {

using units::Dimension;

namespace {

bool is_prescribed(const Case& input) {
  return input.strain.kind == StrainSourceKind::prescribed;
}

constexpr const char* load = "load";

SchemaRow of_load(const char* key, Dimension dimension, const Range& range,
                  double StrainSource::*member, const char* help) {
  return {.key = key,
          .type = ValueType::quantity,
          .dimension = dimension,
          .range = range,
          .need = Need::one_of_several,
          .applies = is_prescribed,
          .help = help,
          .set = into(&Case::strain, member)};
}

void add_prescribed_load(SchemaRows& rows) {
  rows.push_back(of_load("strain.pressure", Dimension::stress, {-1e9, 1e9, true, true},
                         &StrainSource::pressure,
                         "Pressure on the faces of the skin, uniform, of strain.source = "
                         "\"prescribed\"; or give strain.compression or strain.curvature."));
  rows.back().purpose = load;
  rows.push_back(of_load("strain.compression", Dimension::length, {-1.0, 1.0, true, true},
                         &StrainSource::compression,
                         "By how much the core is held thinner than at rest, of strain.source = "
                         "\"prescribed\"; or give strain.pressure or strain.curvature."));
  rows.back().purpose = load;
  rows.push_back(of_load("strain.curvature", Dimension::curvature, {-1e5, 1e5, true, true},
                         &StrainSource::curvature,
                         "Curvature along x of the bent skin, uniform, positive with the top face "
                         "stretched, of strain.source = \"prescribed\"; or give strain.pressure or "
                         "strain.compression."));
  rows.back().purpose = load;
  rows.push_back(
      {.key = "strain.waveform",
       .type = ValueType::choice,
       .applies = is_prescribed,
       .default_value = "\"step\"",
       .choices = {{"step"}, {"ramp"}, {"sine"}},
       .help = "How the prescribed load goes over time: held from the first instant, growing "
               "evenly over strain.rise and then held, or swinging with strain.frequency.",
       .set = into<StrainSource, LoadWaveform>(&Case::strain, &StrainSource::waveform,
                                               {{"step", LoadWaveform::step},
                                                {"ramp", LoadWaveform::ramp},
                                                {"sine", LoadWaveform::sine}})});
  rows.push_back(of_load("strain.rise", Dimension::time, duration_range, &StrainSource::rise,
                         "Time in which the prescribed load of strain.waveform = \"ramp\" grows."));
  rows.back().need = Need::where_known;
  rows.push_back(of_load("strain.frequency", Dimension::frequency, {1e-7, 1e6, true, true},
                         &StrainSource::frequency,
                         "Frequency of the prescribed load of strain.waveform = \"sine\"."));
  rows.back().need = Need::where_known;
  rows.push_back(of_load("strain.duration", Dimension::time, duration_range,
                         &StrainSource::duration, "Duration of a run under a prescribed load."));
  rows.back().need = Need::always;
}

} // namespace

void add_strain(SchemaRows& rows) {
  rows.push_back({.key = "strain.source",
                  .type = ValueType::choice,
                  .default_value = "\"contact\"",
                  .choices = {{"contact"}, {"file"}, {"prescribed"}},
                  .help = "Where the strain comes from: the contact problem, a strain file, or a "
                          "load that is prescribed, of laws that move water.",
                  .set = into<StrainSource, StrainSourceKind>(
                      &Case::strain, &StrainSource::kind,
                      {{"contact", StrainSourceKind::contact},
                       {"file", StrainSourceKind::file},
                       {"prescribed", StrainSourceKind::prescribed}})});
  rows.push_back({.key = "strain.file",
                  .type = ValueType::text,
                  .need = Need::with_strain_file,
                  .help = "Strain file (HDF5), relative to the folder of the case file.",
                  .set = into(&Case::strain, &StrainSource::file)});
  add_prescribed_load(rows);
}

} // namespace ionskin
