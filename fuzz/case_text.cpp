// SPDX-License-Identifier: Apache-2.0

// Any text is a case or is refused with a UserError.

#include "ionskin/base/error.hpp"
#include "ionskin/case/reading/read_case.hpp"

#include <cstdint>
#include <string>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    ionskin::read_case_text(text, "case.toml");
  } catch (const ionskin::UserError&) {
  }
  return 0;
}
