// SPDX-License-Identifier: Apache-2.0

// Any bytes are a strain history or are refused with a UserError. The HDF5 library, which does
// crash, runs in the process apart.

#include "ionskin/results/strain_file/strain_file.hpp"
#include "ionskin/base/error.hpp"
#include "scratch_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const ionskin::fuzz::ScratchFile file(data, size);
  // The skin is that of cases/strain_file.toml.
  ionskin::Skin skin;
  skin.length = 15e-3;
  skin.width = 2e-3;
  skin.layers = {{"bottom", ionskin::LayerRole::electrode, {}, 10e-6},
                 {"core", ionskin::LayerRole::core, {}, 180e-6},
                 {"top", ionskin::LayerRole::electrode, {}, 10e-6}};
  try {
    ionskin::results::read_strain_file(file.path(), skin);
  } catch (const ionskin::UserError&) {
  }
  return 0;
}
