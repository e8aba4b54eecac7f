// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/interface/c_skin.hpp"

#include "ionskin/live/touches/random_touches.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>
#include <new>
#include <span>
#include <stdexcept>
#include <string_view>

static_assert(IONSKIN_LIVE_OUTSIDE_PLACE == ionskin::live::flag::outside_place);
static_assert(IONSKIN_LIVE_OUTSIDE_LOAD == ionskin::live::flag::outside_load);
static_assert(IONSKIN_LIVE_OUTSIDE_SPEED == ionskin::live::flag::outside_speed);
static_assert(IONSKIN_LIVE_UNCONVERGED == ionskin::live::flag::unconverged);
static_assert(IONSKIN_LIVE_REFUSED == ionskin::live::flag::refused);
static_assert(IONSKIN_LIVE_PULLED == ionskin::live::flag::pulled);
static_assert(IONSKIN_LIVE_OUTSIDE_POSE == ionskin::live::flag::outside_pose);

extern "C" {

uint32_t ionskin_live_interface(void) {
  return IONSKIN_LIVE_INTERFACE;
}

ionskin_live_skin* ionskin_live_open(const char* path, char* message, size_t size) {
  try {
    if (path == nullptr) {
      throw std::invalid_argument("path: it is NULL\n  = name a file that ionskin live wrote");
    }
    return new ionskin_live_skin(
        std::make_shared<const ionskin::live::SkinData>(ionskin::live::read_skin(path)));
  } catch (const std::exception& error) {
    if (size > 0) {
      const std::size_t length = std::min(size - 1, std::strlen(error.what()));
      std::memcpy(message, error.what(), length);
      message[length] = '\0';
    }
    return nullptr;
  }
}

ionskin_live_skin* ionskin_live_copy(const ionskin_live_skin* skin) {
  try {
    return new ionskin_live_skin(*skin);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}

void ionskin_live_close(ionskin_live_skin* skin) {
  delete skin;
}

size_t ionskin_live_signal_count(const ionskin_live_skin* skin) {
  return skin->skin.names().size();
}

const char* ionskin_live_signal_name(const ionskin_live_skin* skin, size_t signal) {
  const auto& names = skin->skin.names();
  return signal < names.size() ? names[signal].c_str() : nullptr;
}

uint32_t ionskin_live_step(ionskin_live_skin* skin, double time, double x, double y, int kind,
                           double value, double* signals) {
  return skin->skin.step(time, {x, y}, kind == IONSKIN_LIVE_FORCE, value,
                         {signals, skin->skin.names().size()});
}

uint32_t ionskin_live_step_posed(ionskin_live_skin* skin, double time, double x, double y,
                                 const double angles[3], int kind, double value, double* signals) {
  return skin->skin.step(time, {x, y}, {angles[0], angles[1], angles[2]},
                         kind == IONSKIN_LIVE_FORCE, value, {signals, skin->skin.names().size()});
}

uint32_t ionskin_live_step_held(ionskin_live_skin* skin, double time, double x, double y,
                                double yaw, double force, const double moments[2],
                                double* signals) {
  return skin->skin.step_held(time, {x, y}, yaw, force, {moments[0], moments[1]},
                              {signals, skin->skin.names().size()});
}

void ionskin_live_angles(const ionskin_live_skin* skin, double angles[3]) {
  std::ranges::copy(skin->skin.angles(), angles);
}

void ionskin_live_run_posed(ionskin_live_skin* skin, size_t count, const double* times,
                            const double* positions, const double* angles, int kind,
                            const double* values, double* signals, uint32_t* flags) {
  for (size_t i = 0; i < count; ++i) {
    flags[i] = ionskin_live_step_posed(skin, times[i], positions[2 * i], positions[2 * i + 1],
                                       angles + 3 * i, kind, values[i],
                                       signals + i * skin->skin.names().size());
  }
}

void ionskin_live_run(ionskin_live_skin* skin, size_t count, const double* times,
                      const double* positions, int kind, const double* values, double* signals,
                      uint32_t* flags) {
  for (size_t i = 0; i < count; ++i) {
    flags[i] = ionskin_live_step(skin, times[i], positions[2 * i], positions[2 * i + 1], kind,
                                 values[i], signals + i * skin->skin.names().size());
  }
}

size_t ionskin_live_random_touch(const ionskin_live_skin* skin, uint64_t seed, double* waypoints,
                                 int* kind) {
  try {
    const ionskin::live::SkinData& data = *skin->data;
    const bool by_force = ionskin::live::validated_by_force(data);
    *kind = by_force ? IONSKIN_LIVE_FORCE : IONSKIN_LIVE_HEIGHT;
    const ionskin::live::TouchRange range{{data.lowest_place, data.highest_place},
                                          by_force,
                                          by_force ? data.heaviest_force : data.deepest_indentation,
                                          data.fastest,
                                          data.steepest,
                                          data.fastest_turn,
                                          turns_underside(data)};
    const ionskin::Motion motion = ionskin::live::random_touch(range, seed);
    const size_t rows = std::min<size_t>(motion.waypoints.size(), IONSKIN_LIVE_TOUCH_ROWS);
    for (size_t i = 0; i < rows; ++i) {
      const ionskin::Waypoint& at = motion.waypoints[i];
      const double values[7]{at.time,
                             at.position[0],
                             at.position[1],
                             by_force ? at.force.value_or(0) : *at.height,
                             at.roll.value_or(0),
                             at.pitch.value_or(0),
                             at.yaw.value_or(0)};
      std::ranges::copy(values, waypoints + 7 * i);
    }
    return rows;
  } catch (const std::bad_alloc&) {
    return 0;
  }
}

int ionskin_live_stiffness(ionskin_live_skin* skin, double stiffness[36]) {
  return skin->skin.stiffness(std::span<double, 36>(stiffness, 36)) ? 1 : 0;
}

size_t ionskin_live_charge_count(const ionskin_live_skin* skin) {
  return skin->skin.charges();
}

int ionskin_live_charge_derivatives(ionskin_live_skin* skin, double* derivatives) {
  return skin->skin.charge_derivatives({derivatives, skin->skin.charges() * ionskin::live::motions})
             ? 1
             : 0;
}

size_t ionskin_live_state_size(const ionskin_live_skin* skin) {
  return skin->skin.state().size();
}

void ionskin_live_save(const ionskin_live_skin* skin, double* state) {
  std::ranges::copy(skin->skin.state(), state);
}

int ionskin_live_restore(ionskin_live_skin* skin, const double* state, size_t size) {
  return skin->skin.restore({state, size}) ? 1 : 0;
}

void ionskin_live_reset(ionskin_live_skin* skin) {
  skin->skin.reset();
}

int ionskin_live_set_friction(ionskin_live_skin* skin, double coefficient) {
  try {
    return skin->skin.set_friction(coefficient) ? 1 : 0;
  } catch (const std::exception&) { // no memory
    return 0;
  }
}

void ionskin_live_friction(const ionskin_live_skin* skin, double friction[3]) {
  friction[0] = skin->skin.friction();
  friction[1] = skin->data->lowest_friction;
  friction[2] = skin->data->highest_friction;
}

const char* ionskin_live_text(const ionskin_live_skin* skin, const char* what) {
  const std::string_view word = what;
  const ionskin::live::SkinData& data = *skin->data;
  return word == "case"        ? data.case_text.c_str()
         : word == "version"   ? data.version.c_str()
         : word == "command"   ? data.command.c_str()
         : word == "shortfall" ? skin->shortfall.c_str()
                               : nullptr;
}

void ionskin_live_range(const ionskin_live_skin* skin, double range[7]) {
  const ionskin::live::SkinData& data = *skin->data;
  const double values[7]{data.lowest_place[0],  data.lowest_place[1], data.highest_place[0],
                         data.highest_place[1], data.heaviest_force,  data.deepest_indentation,
                         data.fastest};
  std::ranges::copy(values, range);
}

void ionskin_live_pose_range(const ionskin_live_skin* skin, double range[3]) {
  range[0] = skin->data->steepest;
  range[1] = skin->data->fastest_turn;
  range[2] = skin->data->turns_into_itself != 0 ? 1 : 0;
}

void ionskin_live_size(const ionskin_live_skin* skin, double size[2]) {
  size[0] = skin->data->length;
  size[1] = skin->data->width;
}

void ionskin_live_footprint(const ionskin_live_skin* skin, double box[4]) {
  const ionskin::live::SkinData& data = *skin->data;
  const bool half = data.meshed_share < 1; // cells on one side of the plane of symmetry
  const double lines_y[2]{data.cell_lines_y.front(), data.cell_lines_y.back()};
  const double far = std::max(std::abs(lines_y[0]), std::abs(lines_y[1]));
  const double values[4]{data.cell_lines_x.front(), half ? -far : lines_y[0],
                         data.cell_lines_x.back(), half ? far : lines_y[1]};
  std::ranges::copy(values, box);
}

double ionskin_live_core_thickness(const ionskin_live_skin* skin) {
  return skin->data->thickness;
}

int ionskin_live_taxel(const ionskin_live_skin* skin, size_t index, const char** name,
                       double corners[4]) {
  const ionskin::live::SkinData& data = *skin->data;
  if (index >= data.taxels.size()) {
    return 0;
  }
  *name = data.taxels[index].c_str();
  std::copy_n(data.taxel_corners.data() + 4 * index, 4, corners);
  return 1;
}

int ionskin_live_error(const ionskin_live_skin* skin, size_t index, const char** name, double* rms,
                       double* worst, double* largest) {
  const char* event = nullptr;
  return ionskin_live_event_error(skin, index, &event, name, rms, worst, largest) == 1 &&
                 *event == '\0'
             ? 1
             : 0;
}

int ionskin_live_event_error(const ionskin_live_skin* skin, size_t index, const char** event,
                             const char** name, double* rms, double* worst, double* largest) {
  if (index >= skin->data->errors.size()) {
    return 0;
  }
  const ionskin::live::SignalError& error = skin->data->errors[index];
  *event = error.event.c_str();
  *name = error.name.c_str();
  *rms = error.rms;
  *worst = error.worst;
  *largest = error.largest;
  return 1;
}

} // extern "C"
