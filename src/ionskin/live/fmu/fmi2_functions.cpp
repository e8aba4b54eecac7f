// SPDX-License-Identifier: Apache-2.0

// What an FMU's library exports. Nothing but instances, and states that an importer keeps, takes
// memory; the loop takes none.

#include "ionskin/live/fmu/fmi2.h"
#include "ionskin/live/fmu/instance.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <memory>
#include <new>
#include <string>
#include <string_view>

namespace {

using ionskin::live::fmu::Instance;
namespace reference = ionskin::live::fmu::reference;

constexpr const char* error_category = "logStatusError";
constexpr const char* discard_category = "logStatusDiscard";

struct Component {
  Component(std::string name, const fmi2CallbackFunctions& functions, ionskin::live::SkinData data)
      : instance_name(std::move(name)), callbacks(functions), instance(std::move(data)) {}
  std::string instance_name;
  fmi2CallbackFunctions callbacks;
  Instance instance;
};

using State = std::vector<double>;

void log(const fmi2CallbackFunctions* callbacks, const char* instance, fmi2Status status,
         const char* category, std::string_view message) {
  if (callbacks == nullptr || callbacks->logger == nullptr) {
    return;
  }
  std::string format; // some importers print it as it is, the others by printf
  for (const char letter : message) {
    format.append(letter == '%' ? 2 : 1, letter);
  }
  callbacks->logger(callbacks->componentEnvironment, instance, status, category, format.c_str());
}

fmi2Status fail(const Component& component, const char* message) {
  log(&component.callbacks, component.instance_name.c_str(), fmi2Error, error_category, message);
  return fmi2Error;
}

/// Calls `body` with the component, when there is one.
template <class Body> fmi2Status with(fmi2Component component, Body&& body) {
  if (component == nullptr) {
    return fmi2Error;
  }
  auto& known = *static_cast<Component*>(component);
  try {
    return body(known, known.instance);
  } catch (const std::exception& error) {
    return fail(known, error.what());
  }
}

/// The folder behind a URI of a local file.
std::string folder_of(std::string_view uri) {
  constexpr std::string_view scheme = "file:", host = "//localhost/", no_host = "///";
  if (!uri.starts_with(scheme)) {
    return std::string(uri); // some importers give a bare path
  }
  uri.remove_prefix(scheme.size());
  if (uri.starts_with(host)) {
    uri.remove_prefix(host.size() - 1);
  } else if (uri.starts_with(no_host)) {
    uri.remove_prefix(no_host.size() - 1);
  }
  std::string path;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const std::string code(uri.substr(i + 1, 2));
    char* end = nullptr;
    const long letter = std::strtol(code.c_str(), &end, 16);
    if (uri[i] == '%' && code.size() == 2 && end == code.c_str() + 2) {
      path += static_cast<char>(letter);
      i += 2;
    } else {
      path += uri[i];
    }
  }
  return path;
}

/// What this library was compiled for and the processor lacks; null when nothing.
const char* lacking_instructions() {
#if defined(__x86_64__) && defined(IONSKIN_VECTOR_LEVEL_V3)
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) {
    return "AVX2 and FMA (x86-64-v3)";
  }
#endif
#if defined(__x86_64__) && defined(IONSKIN_VECTOR_LEVEL_V4)
  if (!__builtin_cpu_supports("avx512f") || !__builtin_cpu_supports("avx512vl")) {
    return "AVX-512 (x86-64-v4)";
  }
#endif
  return nullptr;
}

bool outputs_known(const Instance& instance) {
  return instance.mode() != Instance::Mode::instantiated;
}

bool may_set(const Instance& instance) {
  return instance.mode() != Instance::Mode::terminated;
}

constexpr const char* too_early = "outputs are known from the initialization mode on";
constexpr const char* too_late = "nothing can be set after fmi2Terminate";

} // namespace

extern "C" {

const char* fmi2GetTypesPlatform(void) {
  return "default";
}

const char* fmi2GetVersion(void) {
  return "2.0";
}

fmi2Status fmi2SetDebugLogging(fmi2Component component, fmi2Boolean, size_t, const fmi2String[]) {
  // Only mistakes are logged, and these always.
  return component == nullptr ? fmi2Error : fmi2OK;
}

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                              const fmi2CallbackFunctions* callbacks, fmi2Boolean, fmi2Boolean) {
  const char* shown = name == nullptr ? "" : name;
  const auto refuse = [&](const std::string& message) {
    log(callbacks, shown, fmi2Error, error_category, message);
    return nullptr;
  };
  try {
    if (const char* lacking = lacking_instructions()) {
      return refuse(std::string("this FMU was built for processors with ") + lacking +
                    ", which this machine lacks");
    }
    if (type != fmi2CoSimulation) {
      return refuse("this FMU is for co-simulation alone");
    }
    if (callbacks == nullptr || guid == nullptr || resources == nullptr) {
      return refuse("callbacks, GUID and resource location are needed");
    }
    auto component = std::make_unique<Component>(
        shown, *callbacks, ionskin::live::read_skin(folder_of(resources) + "/skin.live"));
    if (component->instance.guid() != guid) {
      return refuse(std::string("the GUID ") + guid + " is not that of the skin in resources, " +
                    component->instance.guid());
    }
    return component.release();
  } catch (const std::exception& error) {
    return refuse(error.what());
  }
}

void fmi2FreeInstance(fmi2Component component) {
  delete static_cast<Component*>(component);
}

fmi2Status fmi2SetupExperiment(fmi2Component component, fmi2Boolean, fmi2Real, fmi2Real start,
                               fmi2Boolean, fmi2Real) {
  return with(component, [&](Component& known, Instance& instance) {
    if (instance.mode() != Instance::Mode::instantiated) {
      return fail(known, "fmi2SetupExperiment comes before fmi2EnterInitializationMode");
    }
    if (!std::isfinite(start)) {
      return fail(known, "the start time is not finite");
    }
    instance.set_start(start);
    return fmi2OK;
  });
}

fmi2Status fmi2EnterInitializationMode(fmi2Component component) {
  return with(component, [](Component& known, Instance& instance) {
    if (instance.mode() != Instance::Mode::instantiated) {
      return fail(known, "the initialization mode was entered before; fmi2Reset starts anew");
    }
    instance.enter_initialization();
    return fmi2OK;
  });
}

fmi2Status fmi2ExitInitializationMode(fmi2Component component) {
  return with(component, [](Component& known, Instance& instance) {
    if (instance.mode() != Instance::Mode::initialization) {
      return fail(known, "fmi2EnterInitializationMode comes first");
    }
    for (std::size_t i = 0; i < reference::inputs; ++i) {
      if (!std::isfinite(*instance.real(i))) {
        return fail(known, "an input is not finite");
      }
    }
    instance.exit_initialization();
    return fmi2OK;
  });
}

fmi2Status fmi2Terminate(fmi2Component component) {
  return with(component, [](Component& known, Instance& instance) {
    if (instance.mode() != Instance::Mode::stepping) {
      return fail(known, "fmi2Terminate comes after fmi2ExitInitializationMode, once");
    }
    instance.terminate();
    return fmi2OK;
  });
}

fmi2Status fmi2Reset(fmi2Component component) {
  return with(component, [](Component&, Instance& instance) {
    instance.reset();
    return fmi2OK;
  });
}

fmi2Status fmi2GetReal(fmi2Component component, const fmi2ValueReference references[], size_t count,
                       fmi2Real values[]) {
  return with(component, [&](Component& known, Instance& instance) {
    for (size_t i = 0; i < count; ++i) {
      if (references[i] >= reference::inputs && !outputs_known(instance)) {
        return fail(known, too_early);
      }
      const double* value = instance.real(references[i]);
      if (value == nullptr) {
        return fail(known, "fmi2GetReal: there is no real variable of this value reference");
      }
      values[i] = *value;
    }
    return fmi2OK;
  });
}

fmi2Status fmi2GetInteger(fmi2Component component, const fmi2ValueReference references[],
                          size_t count, fmi2Integer values[]) {
  return with(component, [&](Component& known, Instance& instance) {
    for (size_t i = 0; i < count; ++i) {
      if (references[i] != reference::flags) {
        return fail(known, "fmi2GetInteger: the one integer variable is flags");
      }
      if (!outputs_known(instance)) {
        return fail(known, too_early);
      }
      values[i] = static_cast<fmi2Integer>(instance.flags());
    }
    return fmi2OK;
  });
}

fmi2Status fmi2GetBoolean(fmi2Component component, const fmi2ValueReference references[],
                          size_t count, fmi2Boolean values[]) {
  return with(component, [&](Component& known, Instance& instance) {
    for (size_t i = 0; i < count; ++i) {
      if (references[i] != reference::force_control) {
        return fail(known, "fmi2GetBoolean: the one Boolean variable is force_control");
      }
      values[i] = instance.force_control() ? fmi2True : fmi2False;
    }
    return fmi2OK;
  });
}

fmi2Status fmi2GetString(fmi2Component component, const fmi2ValueReference[], size_t count,
                         fmi2String[]) {
  return with(component, [&](Component& known, Instance&) {
    return count == 0 ? fmi2OK : fail(known, "there are no string variables");
  });
}

fmi2Status fmi2SetReal(fmi2Component component, const fmi2ValueReference references[], size_t count,
                       const fmi2Real values[]) {
  return with(component, [&](Component& known, Instance& instance) {
    for (size_t i = 0; i < count; ++i) {
      double* input = instance.input(references[i]);
      if (input == nullptr) {
        return fail(known, "fmi2SetReal: this value reference is of no input");
      }
      if (!may_set(instance)) {
        return fail(known, too_late);
      }
      *input = values[i];
    }
    return fmi2OK;
  });
}

fmi2Status fmi2SetInteger(fmi2Component component, const fmi2ValueReference[], size_t count,
                          const fmi2Integer[]) {
  return with(component, [&](Component& known, Instance&) {
    return count == 0 ? fmi2OK : fail(known, "no integer variable can be set");
  });
}

fmi2Status fmi2SetBoolean(fmi2Component component, const fmi2ValueReference references[],
                          size_t count, const fmi2Boolean values[]) {
  return with(component, [&](Component& known, Instance& instance) {
    for (size_t i = 0; i < count; ++i) {
      if (references[i] != reference::force_control) {
        return fail(known, "fmi2SetBoolean: the one Boolean variable is force_control");
      }
      if (!may_set(instance)) {
        return fail(known, too_late);
      }
      instance.force_control() = values[i] != fmi2False;
    }
    return fmi2OK;
  });
}

fmi2Status fmi2SetString(fmi2Component component, const fmi2ValueReference[], size_t count,
                         const fmi2String[]) {
  return with(component, [&](Component& known, Instance&) {
    return count == 0 ? fmi2OK : fail(known, "there are no string variables");
  });
}

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
    if (state != nullptr) { // the standard lets null pass
      delete static_cast<State*>(*state);
      *state = nullptr;
    }
    return fmi2OK;
  });
}

// Serialised: the GUID, then the numbers.

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

fmi2Status fmi2GetDirectionalDerivative(fmi2Component component, const fmi2ValueReference[], size_t,
                                        const fmi2ValueReference[], size_t, const fmi2Real[],
                                        fmi2Real[]) {
  return with(component, [](Component& known, Instance&) {
    return fail(known, "directional derivatives are not provided");
  });
}

fmi2Status fmi2SetRealInputDerivatives(fmi2Component component, const fmi2ValueReference[],
                                       size_t count, const fmi2Integer[], const fmi2Real[]) {
  return with(component, [&](Component& known, Instance&) {
    return count == 0 ? fmi2OK : fail(known, "inputs are not interpolated");
  });
}

fmi2Status fmi2GetRealOutputDerivatives(fmi2Component component, const fmi2ValueReference[],
                                        size_t count, const fmi2Integer[], fmi2Real[]) {
  return with(component, [&](Component& known, Instance&) {
    return count == 0 ? fmi2OK : fail(known, "derivatives of outputs are not provided");
  });
}

fmi2Status fmi2DoStep(fmi2Component component, fmi2Real communication_point, fmi2Real step_size,
                      fmi2Boolean) {
  return with(component, [&](Component& known, Instance& instance) {
    if (instance.mode() != Instance::Mode::stepping) {
      return fail(known, "fmi2DoStep comes between fmi2ExitInitializationMode and fmi2Terminate");
    }
    if (!(step_size > 0)) {
      return fail(known, "fmi2DoStep: the step size must be positive");
    }
    constexpr double same = 1e-3; // of a step: importers add up their times in several ways
    if (!(std::abs(communication_point - instance.time()) <= same * step_size)) {
      return fail(known, "fmi2DoStep: the communication point is not where the last step ended");
    }
    if (!instance.step(communication_point + step_size)) {
      log(&known.callbacks, known.instance_name.c_str(), fmi2Discard, discard_category,
          "an input is not finite, or the time does not advance: nothing has moved");
      return fmi2Discard;
    }
    return fmi2OK;
  });
}

fmi2Status fmi2CancelStep(fmi2Component component) {
  return with(component,
              [](Component& known, Instance&) { return fail(known, "steps are never pending"); });
}

fmi2Status fmi2GetStatus(fmi2Component, fmi2StatusKind, fmi2Status*) {
  return fmi2Discard; // no step is ever pending
}

fmi2Status fmi2GetRealStatus(fmi2Component component, fmi2StatusKind kind, fmi2Real* value) {
  return with(component, [&](Component&, Instance& instance) {
    if (kind != fmi2LastSuccessfulTime) {
      return fmi2Discard;
    }
    *value = instance.time();
    return fmi2OK;
  });
}

fmi2Status fmi2GetIntegerStatus(fmi2Component, fmi2StatusKind, fmi2Integer*) {
  return fmi2Discard;
}

fmi2Status fmi2GetBooleanStatus(fmi2Component component, fmi2StatusKind kind, fmi2Boolean* value) {
  return with(component, [&](Component&, Instance&) {
    if (kind != fmi2Terminated) {
      return fmi2Discard;
    }
    *value = fmi2False;
    return fmi2OK;
  });
}

fmi2Status fmi2GetStringStatus(fmi2Component, fmi2StatusKind, fmi2String*) {
  return fmi2Discard;
}

} // extern "C"
