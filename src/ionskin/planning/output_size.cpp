// SPDX-License-Identifier: Apache-2.0
#include "ionskin/planning/output_size.hpp"

#include "ionskin/base/byte_count.hpp"
#include "ionskin/case/run_duration.hpp"
#include "ionskin/electrochemistry/time/problem_size.hpp"

#include <fmt/format.h>

namespace ionskin::planning {
namespace {

// Sizes in bytes, measured on cases/paper.toml, finger.toml and paper/coarse.toml.
constexpr double field_bytes = 17.5;   // fields per unknown and instant, compressed
constexpr double history_bytes = 0.45; // strain of the run per unknown and time step
constexpr double coarser_bytes = 0.55; // strains of the coarser solutions, likewise
constexpr double signal_row = 700;     // row of signals.csv and similar tables, errors included
constexpr double reading_row = 200;    // row of sampled.csv
constexpr double taxel_row = 80;       // addition to either row per taxel

constexpr double worth_telling = 1e9;

/// Size of the tables of signals and readings, those of taxels included [bytes].
double tables_size(const Case& input, std::size_t ion_steps) {
  const double readings = run_duration(input).value_or(0) / input.readout.sample_interval,
               columns = input.readout.is_cut() ? 2.5 : 1.0, // circuits of taxels add columns
      taxels = taxel_row * columns * static_cast<double>(input.readout.taxels.size());
  return (signal_row + taxels) * static_cast<double>(ion_steps) + (reading_row + taxels) * readings;
}

} // namespace

double output_size(const Case& input, std::size_t ion_unknowns, std::size_t ion_steps) {
  const auto unknowns = static_cast<double>(ion_unknowns), steps = static_cast<double>(ion_steps);
  const double history = input.strain.kind != StrainSourceKind::contact ? 0.0
                         : input.numerics.error_estimate ? history_bytes + coarser_bytes
                                                         : history_bytes;
  return field_bytes * unknowns * static_cast<double>(input.output.fields.size()) +
         history * unknowns * steps + tables_size(input, ion_steps);
}

double expected_output(const Case& input, bool studies_ions) {
  const auto ions = electrochemistry::estimate_problem_size(input);
  if (studies_ions) {
    return output_size(input, ions.unknowns, ions.steps);
  }
  Case mechanics = input;
  mechanics.output.fields.clear();
  return output_size(mechanics, ions.unknowns, ions.steps);
}

double expected_tables(const Case& input) {
  return tables_size(input, electrochemistry::estimate_problem_size(input).steps);
}

std::string announced_output(const Case& input, double bytes) {
  if (!(bytes > worth_telling)) {
    return "";
  }
  return fmt::format("the files of the results will take about {}: the run lasts {:.3g} s, "
                     "readout.sample_interval is {:.3g} s, instants in output.fields: {}",
                     base::byte_text(bytes), run_duration(input).value_or(0),
                     input.readout.sample_interval, input.output.fields.size());
}

} // namespace ionskin::planning
