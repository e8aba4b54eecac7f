// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/http/request.hpp"

#include <cstddef>

namespace ionskin::apps::studio {

/// Number of bytes that the body of a request has. Throws HttpError for bodies that are too large,
/// of unknown length or type, or packed.
std::size_t body_bytes(const Request& head);

} // namespace ionskin::apps::studio
