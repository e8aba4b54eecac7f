// SPDX-License-Identifier: Apache-2.0

// Any bytes are a measurement or are refused with a UserError.

#include "ionskin/study/store/fit_data.hpp"
#include "ionskin/base/error.hpp"
#include "scratch_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const ionskin::fuzz::ScratchFile file(data, size);
  try {
    ionskin::study::read_fit_data(file.path(), ionskin::study::fit_columns({}));
  } catch (const ionskin::UserError&) {
  }
  return 0;
}
