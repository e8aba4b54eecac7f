// SPDX-License-Identifier: Apache-2.0
#include "chain/rows.hpp"
#include "ionskin/case/slider_motion.hpp"
#include "ionskin/electrochemistry/grid/transport_grid.hpp"
#include "ionskin/handover/contact_timeline.hpp"
#include "ionskin/handover/handover.hpp"
#include "ionskin/history/strain_projection.hpp"
#include "ionskin/mechanics/solve_contact.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace ionskin::verification {
namespace {

constexpr int fresh_positions = 20;
/// Degree of the polynomial trend. It follows the shear's magnitude, which bends where the shear
/// passes near zero, but not the passing of the slider from column to column, 18 times in the
/// interval.
constexpr int trend_degree = 16;
/// Refinement of the stored instants: at least 80 in a slide, four between two columns.
constexpr double sampling_refinement = 4.0;

/// Arc lengths that are spread over the stroke; none of them is a node of the interpolation.
std::vector<double> fresh_arc_lengths(const Case& input) {
  std::vector<double> arcs;
  for (int i = 0; i < fresh_positions; ++i) {
    arcs.push_back(input.motion.stroke * (0.02 + 0.96 * std::fmod(0.618034 * (i + 1), 1.0)));
  }
  return arcs;
}

/// Integral of gamma over control volumes of the transport grid [m3].
double integral_on(const electrochemistry::TransportGrid& grid, const std::vector<double>& shear) {
  double integral = 0;
  std::size_t index = 0;
  for (std::size_t k = 0; k < grid.z_nodes.size(); ++k) {
    const double below = k == 0 ? 0 : grid.z_nodes[k] - grid.z_nodes[k - 1];
    const double above = k + 1 == grid.z_nodes.size() ? 0 : grid.z_nodes[k + 1] - grid.z_nodes[k];
    for (std::size_t j = 0; j + 1 < grid.y_edges.size(); ++j) {
      for (std::size_t i = 0; i + 1 < grid.x_edges.size(); ++i, ++index) {
        integral += 0.5 * (below + above) * (grid.y_edges[j + 1] - grid.y_edges[j]) *
                    (grid.x_edges[i + 1] - grid.x_edges[i]) * shear[index];
      }
    }
  }
  return integral;
}

/// Peak-to-peak deviation from the best polynomial trend, relative to the mean.
double relative_ripple(const std::vector<double>& times, const std::vector<double>& values) {
  const auto count = static_cast<Eigen::Index>(values.size());
  Eigen::MatrixXd basis(count, trend_degree + 1);
  Eigen::VectorXd data(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double x =
        2 * (times[static_cast<std::size_t>(i)] - times.front()) / (times.back() - times.front()) -
        1;
    for (int degree = 0; degree <= trend_degree; ++degree) {
      basis(i, degree) = std::cos(degree * std::acos(std::clamp(x, -1.0, 1.0)));
    }
    data(i) = values[static_cast<std::size_t>(i)];
  }
  const Eigen::VectorXd residual = data - basis * basis.colPivHouseholderQr().solve(data);
  return (residual.maxCoeff() - residual.minCoeff()) / data.mean();
}

double time_at(const Case& input, double arc_length) {
  return input.motion.touchdown + input.motion.slide * arc_length / input.motion.stroke;
}

/// Adds rows that compare interpolated states of the path with steady sliding solved anew at other
/// positions.
void add_fresh_rows(const Case& input, const mechanics::ContactSolution& contact,
                    const Options& options, std::vector<Row>& rows) {
  const auto arcs = fresh_arc_lengths(input);
  const MotionLeg slide = first_slide(motion_legs(input.motion, input.slider));
  mechanics::ContactOptions contact_options;
  contact_options.threads = options.threads;
  contact_options.progress = options.progress;
  base::Timers timers;
  const auto states = mechanics::solve_steady_sliding(input, arcs, contact_options, timers);
  const handover::ContactTimeline timeline(input, contact);
  double force_error = 0;
  double shear_error = 0;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const double time = time_at(input, arcs[i]);
    const double force = states[i].normal_force;
    force_error = std::max(force_error, std::abs(timeline.at(time).normal_force() / force - 1));
    handover::StateCombination fresh;
    fresh.terms = {{&states[i], 1.0}};
    fresh.centre = slide.centre(time - slide.begin);
    const double shear = handover::mechanics_shear_integral(input, contact.mesh, fresh);
    const double interpolated =
        handover::mechanics_shear_integral(input, contact.mesh, timeline.at(time));
    shear_error = std::max(shear_error, std::abs(interpolated / shear - 1));
  }
  rows.push_back(at_most("C3", "interpolated normal force against 20 new positions, relative",
                         force_error, 1e-4));
  rows.push_back(at_most("C3", "interpolated integral(gamma) against 20 new positions, relative",
                         shear_error, 1e-4));
}

/// Adds rows on the shear's integral: on the transport grid against the mechanics, and its ripple
/// while sliding.
void add_transport_rows(const Case& input, const mechanics::ContactSolution& contact,
                        std::vector<Row>& rows) {
  const history::CoreHistory history = handover::build_strain_history(input, contact);
  const auto grid = electrochemistry::make_transport_grid(input, history);
  const history::StrainProjection projection(
      history, history.channel(history::channel_name::shear), grid.x_edges, grid.y_edges,
      history::hat_averages(history.grid.z_nodes, grid.z_nodes));
  const handover::ContactTimeline timeline(input, contact);
  const double begin = input.motion.touchdown + 0.1 * input.motion.slide;
  const double end = input.motion.touchdown + input.motion.slide;
  std::vector<double> times;
  std::vector<double> integrals;
  std::vector<double> shear;
  double difference = 0;
  for (const double time : history.time) {
    if (time < begin || time > end) {
      continue;
    }
    times.push_back(time);
    projection.evaluate(time, shear);
    integrals.push_back(integral_on(grid, shear));
    const double mechanics =
        handover::mechanics_shear_integral(input, contact.mesh, timeline.at(time));
    difference = std::max(difference, std::abs(integrals.back() / mechanics - 1));
  }
  rows.push_back(at_most("C3", "integral(gamma) on the transport grid against mechanics, relative",
                         difference, 1e-6));
  rows.push_back(at_most("C3",
                         "ripple of integral(gamma) on the transport grid while sliding, relative",
                         relative_ripple(times, integrals), 1e-6));
}

} // namespace

std::vector<Row> smooth_sliding_rows(const Chain& chain, const Options& options) {
  Case input = chain.input;
  input.numerics.time_refinement = sampling_refinement;
  input.output.fields.clear(); // which the path passes
  for (const double arc_length : fresh_arc_lengths(input)) {
    input.output.fields.push_back(time_at(input, arc_length));
  }
  mechanics::ContactOptions contact_options;
  contact_options.threads = options.threads;
  contact_options.progress = options.progress;
  base::Timers timers;
  const auto contact = mechanics::solve_contact(input, contact_options, timers);
  std::vector<Row> rows;
  add_fresh_rows(input, contact, options, rows);
  add_transport_rows(input, contact, rows);
  return rows;
}

} // namespace ionskin::verification
