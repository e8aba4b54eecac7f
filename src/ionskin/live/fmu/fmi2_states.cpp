// SPDX-License-Identifier: Apache-2.0

// Functions of FMI 2.0 that save, restore and serialise states.

#include "ionskin/live/fmu/component.hpp"

#include <algorithm>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

using namespace ionskin::live::fmu;

namespace {

using State = std::vector<double>;

} // namespace

extern "C" {

fmi2Status fmi2GetFMUstate(fmi2Component component, fmi2FMUstate* state) {
  return with(component, [&](Component&, Instance& instance) {
    if (*state == nullptr) {
      *state = new State;
    }
    auto& kept = *static_cast<State*>(*state);
    kept.resize(instance.state_size());
    instance.save(kept);
    return fmi2OK;
  });
}

fmi2Status fmi2SetFMUstate(fmi2Component component, fmi2FMUstate state) {
  return with(component, [&](Component& known, Instance& instance) {
    return state != nullptr && instance.restore(*static_cast<State*>(state))
               ? fmi2OK
               : fail(known, "the state is none of this FMU");
  });
}

fmi2Status fmi2FreeFMUstate(fmi2Component component, fmi2FMUstate* state) {
  return with(component, [&](Component&, Instance&) {
    if (state != nullptr) { // the standard allows null
      delete static_cast<State*>(*state);
      *state = nullptr;
    }
    return fmi2OK;
  });
}

// A serialised state is the GUID, followed by the numbers of the state as doubles.

fmi2Status fmi2SerializedFMUstateSize(fmi2Component component, fmi2FMUstate state, size_t* size) {
  return with(component, [&](Component& known, Instance& instance) {
    if (state == nullptr) {
      return fail(known, "there is no state");
    }
    *size = instance.guid().size() + static_cast<State*>(state)->size() * sizeof(double);
    return fmi2OK;
  });
}

fmi2Status fmi2SerializeFMUstate(fmi2Component component, fmi2FMUstate state, fmi2Byte bytes[],
                                 size_t size) {
  return with(component, [&](Component& known, Instance& instance) {
    size_t needed = 0;
    if (fmi2SerializedFMUstateSize(component, state, &needed) != fmi2OK) {
      return fmi2Error;
    }
    if (size < needed) {
      return fail(known, "the memory for the serialised state is too small");
    }
    const State& kept = *static_cast<State*>(state);
    bytes = std::copy(instance.guid().begin(), instance.guid().end(), bytes);
    std::memcpy(bytes, kept.data(), kept.size() * sizeof(double));
    return fmi2OK;
  });
}

fmi2Status fmi2DeSerializeFMUstate(fmi2Component component, const fmi2Byte bytes[], size_t size,
                                   fmi2FMUstate* state) {
  return with(component, [&](Component& known, Instance& instance) {
    const std::string& guid = instance.guid();
    State kept(instance.state_size());
    const size_t length = kept.size() * sizeof(double);
    if (size != guid.size() + length || std::string_view(bytes, guid.size()) != guid) {
      return fail(known, "the serialised state is none of this FMU");
    }
    std::memcpy(kept.data(), bytes + guid.size(), length);
    if (*state == nullptr) {
      *state = new State;
    }
    static_cast<State*>(*state)->swap(kept);
    return fmi2OK;
  });
}

} // extern "C"
