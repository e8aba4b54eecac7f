// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/fmu/fmi2.h"
#include "ionskin/live/fmu/instance.hpp"

#include <exception>
#include <string>
#include <string_view>
#include <utility>

namespace ionskin::live::fmu {

/// Object behind an importer's handle: an instance of the FMU, and the callbacks that receive its
/// messages.
struct Component {
  Component(std::string name, const fmi2CallbackFunctions& functions, SkinData data)
      : instance_name(std::move(name)), callbacks(functions), instance(std::move(data)) {}
  std::string instance_name;
  fmi2CallbackFunctions callbacks;
  Instance instance;
};

/// Sends a message to the importer's logger; does nothing without one.
/// @param callbacks may be null
/// @param instance name of the instance
/// @param category "logStatusError", "logStatusDiscard" or "logStatusWarning"
void log(const fmi2CallbackFunctions* callbacks, const char* instance, fmi2Status status,
         const char* category, std::string_view message);
inline constexpr const char* error_category = "logStatusError";
inline constexpr const char* discard_category = "logStatusDiscard";
inline constexpr const char* warning_category = "logStatusWarning";

/// Sends an error message to the importer.
/// @returns fmi2Error
fmi2Status fail(const Component& component, const char* message);

/// Sends a warning to the importer.
/// @returns fmi2Warning
fmi2Status warn(const Component& component, const char* message);

/// Calls `body` with the component behind a handle and its instance, and returns its status.
/// Returns fmi2Error for a null handle; an exception becomes an error message.
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

} // namespace ionskin::live::fmu
