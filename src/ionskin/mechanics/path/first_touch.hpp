// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/case/case.hpp"

namespace ionskin::mechanics {

/// A cell of the contact touches once the slider indents more than the mean height of the underside
/// over it. Refuses a slider that touches none even where it indents most: the mesh cannot see such
/// a contact, as that of a lowest point far from the centre under a small indentation. Its cells
/// are those that the search for the contact begins with. Throws UserError with the indentation
/// that is needed.
void require_touch(const Case& input);

} // namespace ionskin::mechanics
