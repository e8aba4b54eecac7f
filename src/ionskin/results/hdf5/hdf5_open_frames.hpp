// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/results/hdf5/hdf5_file.hpp"
#include "ionskin/results/hdf5/hdf5_handle.hpp"

namespace ionskin::results {

/// Dataset that stays open while its frames are read one after another, so that its cache holds the
/// chunks that consecutive frames share.
struct Hdf5File::OpenFrames {
  OpenFrames(std::string its_name, Hdf5Handle its_dataset)
      : name(std::move(its_name)), dataset(std::move(its_dataset)) {}
  std::string name;
  Hdf5Handle dataset;
};

} // namespace ionskin::results
