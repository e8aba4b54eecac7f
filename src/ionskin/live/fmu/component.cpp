// SPDX-License-Identifier: Apache-2.0
#include "ionskin/live/fmu/component.hpp"

namespace ionskin::live::fmu {

void log(const fmi2CallbackFunctions* callbacks, const char* instance, fmi2Status status,
         const char* category, std::string_view message) {
  if (callbacks == nullptr || callbacks->logger == nullptr) {
    return;
  }
  std::string format; // with doubled percent signs, as some importers print it by printf
  for (const char letter : message) {
    format.append(letter == '%' ? 2 : 1, letter);
  }
  callbacks->logger(callbacks->componentEnvironment, instance, status, category, format.c_str());
}

fmi2Status fail(const Component& component, const char* message) {
  log(&component.callbacks, component.instance_name.c_str(), fmi2Error, error_category, message);
  return fmi2Error;
}

fmi2Status warn(const Component& component, const char* message) {
  log(&component.callbacks, component.instance_name.c_str(), fmi2Warning, warning_category,
      message);
  return fmi2Warning;
}

} // namespace ionskin::live::fmu
