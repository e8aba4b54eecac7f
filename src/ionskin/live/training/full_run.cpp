// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/training/full_run.hpp"

#include "ionskin/case/slider_motion.hpp"
#include "ionskin/electrochemistry/coupling/driving_channel.hpp"
#include "ionskin/electrochemistry/equations/space_charge.hpp"
#include "ionskin/electrochemistry/equations/wall_potential.hpp"
#include "ionskin/electrochemistry/ion_transport.hpp"
#include "ionskin/handover/handover.hpp"
#include "ionskin/history/strain_projection.hpp"
#include "ionskin/mechanics/solve_contact.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace ionskin::live {
namespace {

/// Coordinates along one axis at which a taxel or the core begins or ends, ascending, each once
/// [m].
/// @param axis 0: x, 1: y
/// @param extent length or width of the core [m]
std::vector<double> region_lines(const std::vector<Taxel>& taxels, std::size_t axis,
                                 double extent) {
  std::vector<double> lines{0, extent};
  for (const Taxel& taxel : taxels) {
    lines.push_back(taxel.lower[axis]);
    lines.push_back(taxel.upper[axis]);
  }
  std::ranges::sort(lines);
  std::vector<double> apart{0};
  for (const double line : lines) {
    if (line > apart.back() + 1e-9 * extent) {
      apart.push_back(line);
    }
  }
  apart.back() = extent;
  return apart;
}

/// True if the coupling law depends on the mean over the core.
bool knows_the_mean(const Case& input) {
  return input.coupling.law == "volume-neutral";
}

} // namespace

FullRun full_run(const Case& input, const Motion& motion,
                 const std::optional<mesh::Footprint>& footprint, const TrainingOptions& options) {
  FullRun run{input, {mesh::SkinMesh(input)}, {}, {}};
  run.input.motion = motion;
  if (motion.waypoints.front().yaw) {
    settle_pose(run.input);
  }
  run.input.output.fields.clear();
  base::Timers timers;
  mechanics::ContactOptions contact_options;
  contact_options.threads = options.threads;
  contact_options.progress = options.progress;
  contact_options.footprint = footprint;
  run.contact = mechanics::solve_contact(run.input, contact_options, timers);
  run.history = handover::build_strain_history(run.input, run.contact, options.progress);
  electrochemistry::check_fixed_charge(run.input, run.history);
  electrochemistry::check_net_charge(run.input, run.history);
  electrochemistry::IonOptions ion_options;
  ion_options.threads = options.threads;
  ion_options.progress = options.progress;
  run.ions = electrochemistry::solve_ion_transport(run.input, run.history, ion_options, timers);
  return run;
}

std::size_t drive_inputs(const FullRun& run, bool of_taxels) {
  return run.history.grid.z_nodes.size() * (of_taxels && knows_the_mean(run.input) ? 2 : 1);
}

std::vector<ChargeRecord> charge_records(const FullRun& run, bool of_taxels) {
  const Case& input = run.input;
  const auto& taxels = input.readout.taxels;
  const auto x = region_lines(taxels, 0, input.skin.length),
             y = region_lines(taxels, 1, input.skin.width);
  const auto& z = run.history.grid.z_nodes;
  const history::StrainProjection projection(
      run.history, electrochemistry::driving_channel(input.coupling.law, run.history), x, y,
      history::linear_interpolation(z, z));
  std::vector<ChargeRecord> records(of_taxels ? taxels.size() : 1);
  const std::size_t levels = z.size(), inputs = drive_inputs(run, of_taxels);
  for (std::size_t i = 0; i < records.size(); ++i) {
    records[i].time = run.ions.time;
    records[i].charge = {run.ions.charge_top, run.ions.charge_bottom};
    if (of_taxels) {
      const auto segment = std::ranges::find(run.ions.top_segments, taxels[i].name,
                                             &electrochemistry::SegmentCharge::name);
      records[i].charge = {segment->charge, segment->bottom_charge};
    }
  }
  std::vector<double> field, whole(levels);
  for (const double time : run.ions.time) {
    projection.evaluate(time, field);
    const auto add = [&](double x_low, double y_low, double x_high, double y_high,
                         std::vector<double>& drive) {
      for (std::size_t level = 0; level < levels; ++level) {
        double sum = 0;
        for (std::size_t j = 0; j + 1 < y.size(); ++j) {
          for (std::size_t i = 0; i + 1 < x.size(); ++i) {
            const double mid_x = (x[i] + x[i + 1]) / 2, mid_y = (y[j] + y[j + 1]) / 2;
            if (mid_x > x_low && mid_x < x_high && mid_y > y_low && mid_y < y_high) {
              sum += (x[i + 1] - x[i]) * (y[j + 1] - y[j]) *
                     field[(level * (y.size() - 1) + j) * (x.size() - 1) + i];
            }
          }
        }
        drive.push_back(sum);
      }
    };
    whole.clear();
    add(0, 0, input.skin.length, input.skin.width, whole);
    for (std::size_t i = 0; i < records.size(); ++i) {
      std::vector<double>& drive = records[i].drive;
      if (!of_taxels) {
        drive.insert(drive.end(), whole.begin(), whole.end());
        continue;
      }
      const Taxel& taxel = taxels[i];
      add(taxel.lower[0], taxel.lower[1], taxel.upper[0], taxel.upper[1], drive);
      if (inputs > levels) {
        const double share = (taxel.upper[0] - taxel.lower[0]) * (taxel.upper[1] - taxel.lower[1]) /
                             (input.skin.length * input.skin.width);
        for (const double value : whole) {
          drive.push_back(share * value);
        }
      }
    }
  }
  return records;
}

} // namespace ionskin::live
