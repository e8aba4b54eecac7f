// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "studio/http/request.hpp"

#include <cstddef>

namespace ionskin::apps::studio {

/// Size of the body of a request, by its head [bytes]. Throws HttpError when the body is too large,
/// is compressed, or has an unknown length or type.
std::size_t body_bytes(const Request& head);

} // namespace ionskin::apps::studio
