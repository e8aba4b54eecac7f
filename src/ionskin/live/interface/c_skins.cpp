// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/batch/skins.hpp"
#include "ionskin/live/interface/c_skin.hpp"

#include <algorithm>
#include <exception>

/// Skins behind a handle of the C interface, with the shared data of the file.
struct ionskin_live_skins {
  std::shared_ptr<const ionskin::live::SkinData> data;
  ionskin::live::Skins skins;
};

namespace {

/// Steps as `ionskin_live_skins_step_posed` does, for floats or doubles.
template <class Value>
void step(ionskin_live_skins* skins, size_t worker, size_t first, size_t last,
          const ionskin_live_batch& batch, const void* angles, double* stiffness) {
  skins->skins.step<Value>(worker, first, last,
                           {batch.times,
                            static_cast<const Value*>(batch.positions),
                            batch.kind == IONSKIN_LIVE_FORCE,
                            static_cast<const Value*>(batch.values),
                            {batch.columns, batch.column_count},
                            static_cast<Value*>(batch.signals),
                            batch.flags,
                            static_cast<const Value*>(angles),
                            stiffness});
}

} // namespace

extern "C" {

ionskin_live_skins* ionskin_live_skins_open(const ionskin_live_skin* like, size_t environments,
                                            size_t workers) {
  if (environments == 0 || workers == 0) {
    return nullptr;
  }
  try {
    return new ionskin_live_skins{like->data, {*like->data, like->skin, environments, workers}};
  } catch (const std::exception&) { // no memory
    return nullptr;
  }
}

void ionskin_live_skins_close(ionskin_live_skins* skins) {
  delete skins;
}

void ionskin_live_skins_step(ionskin_live_skins* skins, size_t worker, size_t first, size_t last,
                             const ionskin_live_batch* batch) {
  ionskin_live_skins_step_posed(skins, worker, first, last, batch, nullptr, nullptr);
}

void ionskin_live_skins_step_posed(ionskin_live_skins* skins, size_t worker, size_t first,
                                   size_t last, const ionskin_live_batch* batch, const void* angles,
                                   double* stiffness) {
  if (batch->single != 0) {
    step<float>(skins, worker, first, last, *batch, angles, stiffness);
  } else {
    step<double>(skins, worker, first, last, *batch, angles, stiffness);
  }
}

void ionskin_live_skins_reset(ionskin_live_skins* skins, size_t environment) {
  skins->skins.reset(environment);
}

void ionskin_live_skins_save(const ionskin_live_skins* skins, size_t environment, double* state) {
  std::ranges::copy(skins->skins.state(environment), state);
}

int ionskin_live_skins_restore(ionskin_live_skins* skins, size_t environment, const double* state,
                               size_t size) {
  return skins->skins.restore(environment, {state, size}) ? 1 : 0;
}

int ionskin_live_skins_set_friction(ionskin_live_skins* skins, size_t environment,
                                    double coefficient) {
  try {
    return skins->skins.set_friction(environment, coefficient) ? 1 : 0;
  } catch (const std::exception&) { // no memory
    return 0;
  }
}

double ionskin_live_skins_friction(const ionskin_live_skins* skins, size_t environment) {
  return skins->skins.friction(environment);
}

void ionskin_live_skins_set_noise(ionskin_live_skins* skins, size_t environment, double deviation,
                                  uint64_t seed, uint64_t steps) {
  skins->skins.noise(environment) = {deviation, seed, steps};
}

uint64_t ionskin_live_skins_noise_steps(ionskin_live_skins* skins, size_t environment) {
  return skins->skins.noise(environment).steps;
}

} // extern "C"
