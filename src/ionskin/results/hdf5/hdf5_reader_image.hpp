// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace ionskin::results {

/// The executable that reads for ForeignHdf5File. It is carried along, so that no other file has to
/// be found beside the program, the Python module or a test.
std::string_view hdf5_reader_image();

} // namespace ionskin::results
