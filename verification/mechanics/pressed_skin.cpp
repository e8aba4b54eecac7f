// SPDX-License-Identifier: Apache-2.0
#include "mechanics/pressed_skin.hpp"

#include "ionskin/mechanics/engine/contact_state.hpp"
#include "ionskin/mechanics/path/find_footprint.hpp"
#include "ionskin/mechanics/slider/turning_underside.hpp"
#include "ionskin/mechanics/surface/contact_diagnostics.hpp"
#include "ionskin/mechanics/surface/covered_area.hpp"

#include <cmath>

namespace ionskin::verification {

PressedSkin::PressedSkin(const Case& input)
    : slider_(input.slider),
      model_(input, mechanics::find_footprint(input, input.contact.friction, 2).footprint,
             {input.slider.start, input.slider.start}),
      problem_{{},
               model_.cells.area,
               model_.gap,
               laws::friction(input.contact.law, input.contact.friction, input.contact.parameters)},
      indentation_(input.motion.preload) {
  mechanics::ContactCompliance(model_).at(input.slider.start, problem_.compliance);
  state_.force.assign(3 * model_.cells.count(), 0.0);
  state_.surface = state_.force;
}

void PressedSkin::advance(const std::array<double, 2>& travel, double turn) {
  const mechanics::SliderLoad load{mechanics::LoadKind::indentation, indentation_};
  mechanics::SliderStep step{load, travel, 0, state_.surface};
  if (turn != 0) {
    step.turn = mechanics::TurningUnderside(slider_, model_.cells).turn(turn);
  }
  state_ = mechanics::solve_contact_step(problem_, step, state_.force);
}

double PressedSkin::force(std::size_t component) const {
  double sum = 0;
  for (std::size_t at = component; at < state_.force.size(); at += 3) {
    sum += state_.force[at];
  }
  return parts() * sum;
}

std::array<double, 3> PressedSkin::moment() const {
  mechanics::ContactState described;
  mechanics::describe(model_, state_, problem_, 1, 1, described);
  return described.moment;
}

double PressedSkin::contact_area() const {
  return parts() * mechanics::contact_area(model_.cells.grid(), state_.force);
}

double PressedSkin::stick_area() const {
  return parts() * mechanics::covered_area(model_.cells.grid(),
                                           mechanics::stick_reserve(problem_, state_.force));
}

double PressedSkin::central_pressure(double contact_radius) const {
  const mechanics::ContactCells& cells = model_.cells;
  double count = 0, sum_r = 0, sum_rr = 0, sum_p = 0, sum_rp = 0; // over r^2 and p^2
  for (std::size_t cell = 0; cell < cells.count(); ++cell) {
    const std::size_t i = cell % cells.columns(), j = cell / cells.columns();
    const double x = (cells.lines_x[i] + cells.lines_x[i + 1]) / 2;
    const double y = cells.rows() > 2 ? (cells.lines_y[j] + cells.lines_y[j + 1]) / 2 : 0.0;
    const double r2 = x * x + y * y;
    if (r2 < 0.36 * contact_radius * contact_radius) {
      const double p2 = std::pow(state_.force[3 * cell] / cells.area[cell], 2);
      ++count;
      sum_r += r2;
      sum_rr += r2 * r2;
      sum_p += p2;
      sum_rp += r2 * p2;
    }
  }
  const double slope = (count * sum_rp - sum_r * sum_p) / (count * sum_rr - sum_r * sum_r);
  return std::sqrt((sum_p - slope * sum_r) / count);
}

} // namespace ionskin::verification
