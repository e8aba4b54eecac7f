// SPDX-License-Identifier: Apache-2.0
#include "ionskin/electrochemistry/circuit/cut_electrode.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/case/checks/check_sizes.hpp"
#include "ionskin/electrochemistry/circuit/crossbar.hpp"
#include "ionskin/electrochemistry/circuit/electrode_segments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

namespace ionskin::electrochemistry {
namespace {

/// Rounding, over the width of the skin, within which positions mirror each other.
constexpr double mirror_rounding = 1e-9;

/// Least share of a column that a gap between taxels must cover in some column to be a conductor.
constexpr double least_share = 0.01;

constexpr const char* electrode = "";

/// Name of the conductor of each segment: the name of its taxel, or `electrode` for the common
/// electrode.
std::vector<std::string> names_of_conductors(const Readout& readout,
                                             const ElectrodeSegments& segments) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < segments.names.size(); ++i) {
    const bool own = i < readout.taxels.size() && readout.has_own_circuit(i);
    names.push_back(own ? readout.taxels[i].name : electrode);
  }
  return names;
}

/// Finds the taxel at the mirror image of a taxel about mid-width; nothing where there is none.
std::optional<std::size_t> image_of(const Readout& readout, std::size_t taxel, double width) {
  const Taxel& one = readout.taxels[taxel];
  const auto same = [width](double a, double b) {
    return std::abs(a - b) <= mirror_rounding * width;
  };
  for (std::size_t i = 0; i < readout.taxels.size(); ++i) {
    const Taxel& other = readout.taxels[i];
    if (same(one.lower[0], other.lower[0]) && same(one.upper[0], other.upper[0]) &&
        same(one.lower[1], width - other.upper[1]) && same(one.upper[1], width - other.lower[1])) {
      return i;
    }
  }
  return std::nullopt;
}

/// Gives the area that no taxel covers to the taxels beside it where it is too narrow for the grid.
void drop_narrow_rest(std::size_t taxels, ElectrodeSegments& segments) {
  if (segments.names.size() == taxels || std::ranges::max(segments.share.back()) >= least_share) {
    return;
  }
  for (std::size_t i = 0; i < segments.share.back().size(); ++i) {
    const double covered = 1.0 - segments.share.back()[i];
    for (std::vector<double>& share : segments.share) {
      share[i] /= covered;
    }
  }
  std::ranges::fill(segments.share.back(), 0.0);
}

} // namespace

std::vector<std::optional<ScaledAdmittance>> CutElectrode::circuits(const Scan& scan,
                                                                    std::size_t row) const {
  std::vector<std::optional<ScaledAdmittance>> circuits;
  for (std::size_t e = 0; e < conductors.size(); ++e) {
    if (!row_of_conductor[e] || *row_of_conductor[e] == row) {
      circuits.push_back(conductors.conductors()[e].admittance);
    } else {
      circuits.push_back(scan.grounds_others ? std::nullopt : std::optional(ScaledAdmittance{}));
    }
  }
  return circuits;
}

std::vector<double> scan_switches(const Readout& readout, double begin, double end) {
  std::vector<double> switches;
  if (readout.scan.dwell == 0) {
    return switches;
  }
  const double count = (end - begin) / readout.scan.dwell;
  if (!(count <= most_scan_switches)) {
    throw UserError(fmt::format("readout.scan.dwell = {:.6g} s makes {:.3g} switches over the run, "
                                "more than {:.0f}\n  = choose at least {:.3g} s",
                                readout.scan.dwell, count, most_scan_switches,
                                (end - begin) / most_scan_switches));
  }
  for (double k = 1; k < count * (1 - 1e-9); ++k) {
    switches.push_back(begin + k * readout.scan.dwell);
  }
  return switches;
}

bool taxels_are_mirrored(const Readout& readout, double width) {
  if (readout.is_crossbar()) {
    return readout.lines_are_held();
  }
  for (std::size_t i = 0; i < readout.taxels.size(); ++i) {
    const auto image = image_of(readout, i, width);
    if (!image || readout.has_own_circuit(i) != readout.has_own_circuit(*image) ||
        readout.circuit_of(i) != readout.circuit_of(*image) ||
        (readout.scan.dwell > 0 && readout.scan_row(i) != readout.scan_row(*image)) ||
        readout.parameters_of(i) != readout.parameters_of(*image)) {
      return false;
    }
  }
  return true;
}

std::optional<CutElectrode> cut_electrode(const Case& input, const DerivedScales& scales,
                                          const TransportGrid& grid, const MidWidthMirror& mirror) {
  const Readout& readout = input.readout;
  if (!readout.is_cut()) {
    return std::nullopt;
  }
  if (readout.is_crossbar()) {
    return crossbar(input, scales, grid);
  }
  const std::vector<std::string> names =
      names_of_conductors(readout, make_electrode_segments(readout.taxels, grid));
  ElectrodeSegments segments = make_electrode_segments(readout.taxels, mirror.solved_grid());
  segments.share.resize(names.size(), std::vector<double>(segments.share.front().size(), 0.0));
  segments.names.resize(names.size());
  drop_narrow_rest(readout.taxels.size(), segments);

  const bool halved = mirror.copies() > 1.0;
  const double column_area = input.skin.length * input.skin.width / mirror.copies() /
                             static_cast<double>(segments.share.front().size());
  std::vector<WallConductor> conductors;
  std::vector<double> copies;
  std::vector<std::optional<std::size_t>> rows;
  std::vector<std::size_t> conductor_of(names.size(), names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (conductor_of[i] < names.size()) {
      continue;
    }
    const bool own = names[i] != electrode;
    const std::size_t image =
        own && halved ? image_of(readout, i, input.skin.width).value_or(i) : i;
    WallConductor conductor{std::vector<double>(segments.share[i].size(), 0.0), std::nullopt};
    for (std::size_t j = i; j < names.size(); ++j) {
      if (j == i || (!own && names[j] == electrode) || j == image) {
        conductor_of[j] = conductors.size();
        std::ranges::transform(conductor.share, segments.share[j], conductor.share.begin(),
                               std::plus<>());
      }
    }
    if (std::ranges::max(conductor.share) < least_share) {
      continue; // strips that were given away: they follow the first taxel
    }
    const circuits::Circuit circuit =
        own ? circuits::circuit(readout.circuit_of(i), readout.parameters_of(i))
            : circuits::circuit(readout.circuit, readout.parameters);
    // Two taxels that mirror each other are one conductor with one circuit; of a taxel that is
    // symmetric about mid-width only half is solved.
    copies.push_back(image != i ? 1.0 : mirror.copies());
    if (circuit.admittance) {
      conductor.admittance = scaled_admittance(*circuit.admittance, scales, column_area);
      conductor.admittance->conductance /= copies.back();
      conductor.admittance->capacitance /= copies.back();
    }
    rows.push_back(own && readout.scan.dwell > 0 ? std::optional(readout.scan_row(i))
                                                 : std::nullopt);
    conductors.push_back(std::move(conductor));
  }
  for (std::size_t& conductor : conductor_of) {
    conductor = conductor < conductors.size() ? conductor : 0;
  }
  return CutElectrode{WallElectrodes(std::move(conductors)), std::move(conductor_of),
                      std::move(rows), std::move(copies)};
}

} // namespace ionskin::electrochemistry
