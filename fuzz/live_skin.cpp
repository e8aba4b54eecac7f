// SPDX-License-Identifier: Apache-2.0

// Any bytes with the digest that fits them are a reduced skin, which can be stepped, or are refused
// with a UserError.

#include "ionskin/base/digest.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/live/skin.hpp"
#include "scratch_file.hpp"

#include <array>
#include <span>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string bytes(reinterpret_cast<const char*>(data), size);
  bytes += ionskin::base::DigestBuilder().add_bytes(std::as_bytes(std::span(bytes))).finish().hex();
  const ionskin::fuzz::ScratchFile file(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                                        bytes.size());
  try {
    const ionskin::live::SkinData read = ionskin::live::read_skin(file.path());
    ionskin::live::Skin skin(read);
    std::vector<double> signals(skin.names().size());
    skin.step(0, read.lowest_place, false, -1e-7, signals);
    skin.step(1, read.highest_place, true, 1, signals);
    skin.step(2, read.highest_place, {1e-3, -1e-2, 0.1}, true, 1, signals);
    std::array<double, 36> stiffness{};
    skin.stiffness(stiffness);
  } catch (const ionskin::UserError&) {
  }
  return 0;
}
