// SPDX-License-Identifier: Apache-2.0

// Functions of FMI 2.0 that make an instance, step it and report its status. Only new instances and
// states that an importer saves allocate memory; fmi2DoStep allocates none, unless friction
// changed.

#include "ionskin/live/fmu/component.hpp"

#include <cmath>
#include <cstdlib>
#include <exception>
#include <memory>
#include <string>
#include <string_view>

using namespace ionskin::live::fmu;

namespace {

/// Path of the folder that a URI of a local file names.
std::string folder_of(std::string_view uri) {
  constexpr std::string_view scheme = "file:", host = "//localhost/", no_host = "///";
  if (!uri.starts_with(scheme)) {
    return std::string(uri); // some importers pass a path instead of a URI
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

/// Name of instructions that this library was compiled for and the processor lacks; null if there
/// are none.
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

} // namespace

extern "C" {

const char* fmi2GetTypesPlatform(void) {
  return "default";
}

const char* fmi2GetVersion(void) {
  return "2.0";
}

fmi2Status fmi2SetDebugLogging(fmi2Component component, fmi2Boolean, size_t, const fmi2String[]) {
  // The setting has no effect: the FMU logs only errors and warnings, and logs them always.
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
    if (const std::string shortfall = component->instance.shortfall(); !shortfall.empty()) {
      warn(*component, shortfall.c_str());
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
    if (!instance.inputs_are_finite()) {
      return fail(known, "an input is not finite");
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

fmi2Status fmi2DoStep(fmi2Component component, fmi2Real communication_point, fmi2Real step_size,
                      fmi2Boolean) {
  return with(component, [&](Component& known, Instance& instance) {
    if (instance.mode() != Instance::Mode::stepping) {
      return fail(known, "fmi2DoStep comes between fmi2ExitInitializationMode and fmi2Terminate");
    }
    if (!(step_size > 0)) {
      return fail(known, "fmi2DoStep: the step size must be positive");
    }
    constexpr double same = 1e-3; // over a step: importers add up times with different rounding
    if (!(std::abs(communication_point - instance.time()) <= same * step_size)) {
      return fail(known, "fmi2DoStep: the communication point is not where the last step ended");
    }
    if (!instance.step(communication_point + step_size)) {
      log(&known.callbacks, known.instance_name.c_str(), fmi2Discard, discard_category,
          "an input is not finite or a yaw beyond 1e6 rad, or the time does not advance: nothing "
          "has moved");
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
