// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace ionskin::results {

/// Bytes of the executable that `ForeignHdf5File` runs as its reading process. The executable is
/// embedded in the program, so that no file has to be found beside the program, the Python module
/// or a test. The bytes live as long as the process.
std::string_view hdf5_reader_image();

} // namespace ionskin::results
