// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace ionskin::results::build_info {

extern const char* const version;
/// Git commit of the sources when the build was configured; may be empty.
extern const char* const commit;
extern const char* const compiler;
extern const char* const build_type;

} // namespace ionskin::results::build_info
