// SPDX-License-Identifier: Apache-2.0
#include "study_verbs/impedance.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/case/reading/read_case.hpp"
#include "ionskin/study/impedance/impedance_spectrum.hpp"
#include "ionskin/units/quantity.hpp"

#include <fmt/core.h>

namespace ionskin::apps {
namespace {

double frequency(const std::string& option, const std::string& text) {
  try {
    return units::parse_quantity(text, units::Dimension::frequency);
  } catch (const UserError& error) {
    throw UserError(option + ": " + error.what());
  }
}

void print_ends(const readout::SignalTable& spectrum) {
  const auto& points = spectrum.columns;
  for (const std::size_t row : {std::size_t{0}, points.front().values.size() - 1}) {
    fmt::print("{:>10.6g} Hz: {:.6g} ohm, {:.4g} degree\n", points.front().values[row],
               spectrum.column("magnitude").values[row],
               spectrum.column("phase_angle").values[row]);
  }
}

} // namespace

int impedance(const ImpedanceOptions& options, const std::string& command) {
  study::ImpedanceOptions settings;
  settings.range = {frequency("--from", options.from), frequency("--to", options.to),
                    options.points};
  settings.folder = options.output;
  settings.overwrite = options.overwrite;
  settings.command = command;
  const auto outcome =
      study::run_impedance(read_case(options.case_path, options.set_edits), settings);
  print_ends(outcome.spectrum);
  for (const std::string& warning : outcome.warnings) {
    fmt::print("{}\n", warning);
  }
  fmt::print("results: {}\n", outcome.folder.string());
  return static_cast<int>(ExitCode::success);
}

} // namespace ionskin::apps
