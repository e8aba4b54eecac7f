// SPDX-License-Identifier: Apache-2.0

// Functions of FMI 2.0 that get and set variables.

#include "ionskin/live/fmu/component.hpp"

using namespace ionskin::live::fmu;

namespace {

/// True in the modes in which FMI 2.0 lets outputs be read.
bool outputs_known(const Instance& instance) {
  return instance.mode() != Instance::Mode::instantiated;
}

/// True in the modes in which inputs can be set.
bool may_set(const Instance& instance) {
  return instance.mode() != Instance::Mode::terminated;
}

constexpr const char* too_early = "outputs are known from the initialization mode on";
constexpr const char* too_late = "nothing can be set after fmi2Terminate";

} // namespace

extern "C" {

fmi2Status fmi2GetReal(fmi2Component component, const fmi2ValueReference references[], size_t count,
                       fmi2Real values[]) {
  return with(component, [&](Component& known, Instance& instance) {
    for (size_t i = 0; i < count; ++i) {
      if (instance.is_output(references[i]) && !outputs_known(instance)) {
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
    fmi2Status status = fmi2OK;
    for (size_t i = 0; i < count; ++i) {
      double* input = instance.input(references[i]);
      if (input == nullptr) {
        return fail(known, "fmi2SetReal: this value reference is of no input");
      }
      if (!may_set(instance)) {
        return fail(known, too_late);
      }
      *input = values[i];
      if (references[i] == reference::friction && instance.limit_friction()) {
        status = warn(known, "friction is outside the trained range, which its description states: "
                             "the nearest trained one is taken");
      }
    }
    return status;
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

} // extern "C"
