// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/impedance/impedance_spectrum.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/files/atomic_file.hpp"
#include "ionskin/electrochemistry/small_signal.hpp"
#include "ionskin/results/csv_writer.hpp"
#include "ionskin/results/manifest.hpp"
#include "ionskin/results/output_folder.hpp"
#include "ionskin/study/run/report.hpp"

#include <fmt/core.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace ionskin::study {
namespace {

namespace names = results::file_names;

constexpr std::size_t most_frequencies = 100000;

} // namespace

std::vector<double> frequencies(const FrequencyRange& range) {
  if (!(range.from > 0 && range.to > range.from)) {
    throw UserError(fmt::format("no frequencies from {:.6g} Hz to {:.6g} Hz\n  = --from must be "
                                "above 0 Hz and --to above --from",
                                range.from, range.to));
  }
  const double decades = std::log10(range.to) - std::log10(range.from);
  const auto intervals =
      static_cast<std::size_t>(std::ceil(decades * range.points_per_decade - 1e-9));
  if (intervals >= most_frequencies) {
    throw UserError(
        fmt::format("{} frequencies are too many\n  = choose fewer --points", intervals + 1));
  }
  std::vector<double> result;
  for (std::size_t i = 0; i <= intervals; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(intervals);
    result.push_back(range.from * std::pow(10.0, decades * part));
  }
  result.back() = range.to;
  return result;
}

readout::SignalTable impedance_spectrum(const Case& input, const std::vector<double>& frequencies) {
  const electrochemistry::SmallSignalCell cell(input);
  const double area = input.skin.length * input.skin.width;
  readout::SignalTable table;
  table.columns = {{"frequency", "Hz", frequencies},
                   {"impedance_real", "ohm", {}},
                   {"impedance_imaginary", "ohm", {}},
                   {"area_impedance_real", "ohm m2", {}},
                   {"area_impedance_imaginary", "ohm m2", {}},
                   {"magnitude", "ohm", {}},
                   {"phase_angle", "degree", {}}};
  for (const double frequency : frequencies) {
    const std::complex<double> specific = cell.area_impedance(frequency);
    if (!(specific.real() > 0)) { // a cell at rest gives no energy
      throw SolverError(fmt::format("at {:.6g} Hz the resistance came out as {:.6g} ohm m2, which "
                                    "no cell at rest has",
                                    frequency, specific.real()),
                        "leave this frequency out, and report the case");
    }
    const std::complex<double> impedance = specific / area;
    const double phase = std::arg(impedance) * 180.0 / std::numbers::pi;
    const auto values = {impedance.real(), impedance.imag(),    specific.real(),
                         specific.imag(),  std::abs(impedance), phase};
    auto column = table.columns.begin();
    for (const double value : values) {
      (++column)->values.push_back(value);
    }
  }
  return table;
}

ImpedanceOutcome run_impedance(const Case& input, const ImpedanceOptions& options) {
  const std::vector<double> wanted = frequencies(options.range);
  results::OutputFolder folder(options.folder, options.overwrite
                                                   ? results::ExistingFolder::overwrite
                                                   : results::ExistingFolder::refuse);
  auto manifest = results::new_manifest(options.command, 1, results::content_hash(input.text));
  base::write_text_file(folder.own(names::case_text), input.text);
  results::write_manifest(folder.own(names::manifest), manifest);
  ImpedanceOutcome outcome{options.folder, {}, impedance_spectrum(input, wanted)};
  results::write_csv(folder.own(names::impedance), outcome.spectrum);
  if (const auto problem = draw_impedance(options.folder)) {
    outcome.warnings.push_back(*problem);
  }
  manifest.state = "finished";
  results::write_manifest(folder.own(names::manifest), manifest);
  return outcome;
}

} // namespace ionskin::study
