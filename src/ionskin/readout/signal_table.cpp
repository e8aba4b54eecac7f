// SPDX-License-Identifier: Apache-2.0
#include "ionskin/readout/signal_table.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/readout/electrode_current.hpp"
#include "ionskin/readout/phases.hpp"
#include "ionskin/readout/slider_suffix.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <limits>

namespace ionskin::readout {
namespace {

void require_rows(const std::string& name, std::size_t actual, std::size_t rows) {
  if (actual != rows) {
    throw InternalError(fmt::format("signal '{}' has {} rows, time has {}", name, actual, rows));
  }
}

Signal required(const std::string& name, const std::string& unit, const std::vector<double>& values,
                std::size_t rows) {
  require_rows(name, values.size(), rows);
  return {name, unit, values};
}

Signal optional(const std::string& name, const std::string& unit, const std::vector<double>& values,
                std::size_t rows) {
  if (values.empty()) {
    return {name, unit, std::vector<double>(rows, std::numeric_limits<double>::quiet_NaN())};
  }
  return required(name, unit, values, rows);
}

void add_currents(SignalTable& table, const SignalInputs& inputs) {
  ElectrodeCurrents currents =
      electrode_currents(inputs.time, inputs.charge_top, inputs.charge_bottom);
  table.columns.push_back({"current_top", "A", std::move(currents.top)});
  table.columns.push_back({"current_bottom", "A", std::move(currents.bottom)});
  table.columns.push_back({"current_difference", "A", std::move(currents.difference)});
  table.columns.push_back({"current_common", "A", std::move(currents.common)});
}

void add_further_slider(const SliderInputs& slider, const std::string& suffix, std::size_t rows,
                        SignalTable& table) {
  const auto add = [&](const char* name, const char* unit, const std::vector<double>& values) {
    table.columns.push_back(required(name + suffix, unit, values, rows));
  };
  add("slider_x", "m", slider.slider_x);
  add("slider_y", "m", slider.slider_y);
  add("slider_z", "m", slider.slider_z);
  add("normal_force", "N", slider.normal_force);
  add("tangential_force", "N", slider.tangential_force);
  add("tangential_force_x", "N", slider.tangential_force_x);
  add("tangential_force_y", "N", slider.tangential_force_y);
  add("moment_x", "N m", slider.moment_x);
  add("moment_y", "N m", slider.moment_y);
  add("moment_z", "N m", slider.moment_z);
  add("contact_area", "m2", slider.contact_area);
  add("stick_share", "1", slider.stick_share);
  add("slip", "m", slider.slip);
  add("slip_state", "1", slider.slip_state);
}

} // namespace

void add_motion(SignalInputs& inputs, const Motion& motion, const Slider& slider) {
  const MotionPhases phases(motion, slider);
  for (double time : inputs.time) {
    const MotionInstant at = phases.at(time);
    inputs.cycle.push_back(at.cycle);
    inputs.phase.push_back(at.phase);
    inputs.slider_x.push_back(at.centre[0]);
    inputs.slider_y.push_back(at.centre[1]);
  }
}

SignalTable build_signal_table(const SignalInputs& inputs) {
  const std::size_t rows = inputs.time.size();
  SignalTable table;
  table.cycle = inputs.cycle.empty() ? std::vector<int>(rows, 0) : inputs.cycle;
  table.phase = inputs.phase.empty() ? std::vector<std::string>(rows) : inputs.phase;
  require_rows("cycle", table.cycle.size(), rows);
  require_rows("phase", table.phase.size(), rows);
  table.columns = {
      required("time", "s", inputs.time, rows),
      optional("slider_x", "m", inputs.slider_x, rows),
      optional("slider_z", "m", inputs.slider_z, rows),
      optional("normal_force", "N", inputs.normal_force, rows),
      optional("tangential_force", "N", inputs.tangential_force, rows),
      required("mean_shear", "1", inputs.mean_shear, rows),
      required("rms_shear", "1", inputs.rms_shear, rows),
      required("p99_shear", "1", inputs.p99_shear, rows),
      required("shear_first_moment", "1", inputs.shear_first_moment, rows),
      {"mean_shear_rate", "1/s", step_rates(inputs.time, inputs.mean_shear)},
      required("charge_top", "C", inputs.charge_top, rows),
      required("charge_bottom", "C", inputs.charge_bottom, rows),
  };
  add_currents(table, inputs);
  // Appended after the older columns, so that scripts which count columns still work.
  table.columns.push_back(optional("slider_y", "m", inputs.slider_y, rows));
  table.columns.push_back(optional("contact_area", "m2", inputs.contact_area, rows));
  table.columns.push_back(optional("stick_share", "1", inputs.stick_share, rows));
  table.columns.push_back(optional("slip", "m", inputs.slip, rows));
  table.columns.push_back(optional("slip_state", "1", inputs.slip_state, rows));
  table.columns.push_back(optional("tangential_force_x", "N", inputs.tangential_force_x, rows));
  table.columns.push_back(optional("tangential_force_y", "N", inputs.tangential_force_y, rows));
  table.columns.push_back(optional("moment_x", "N m", inputs.moment_x, rows));
  table.columns.push_back(optional("moment_y", "N m", inputs.moment_y, rows));
  table.columns.push_back(optional("moment_z", "N m", inputs.moment_z, rows));
  if (!inputs.drive_x.empty()) {
    table.columns.push_back(required("drive_x", "m", inputs.drive_x, rows));
    table.columns.push_back(required("drive_y", "m", inputs.drive_y, rows));
    table.columns.push_back(required("drive_force_x", "N", inputs.drive_force_x, rows));
    table.columns.push_back(required("drive_force_y", "N", inputs.drive_force_y, rows));
  }
  for (std::size_t i = 0; i < inputs.further_sliders.size(); ++i) {
    add_further_slider(inputs.further_sliders[i], slider_suffix(i + 1), rows, table);
  }
  return table;
}

} // namespace ionskin::readout
