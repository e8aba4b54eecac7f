// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace ionskin::apps::studio {

/// File of the Studio's page, compiled into the program.
struct PageFile {
  std::string_view content;
  const char* type = ""; ///< content type
};

/// Finds the file at the path "/", "/app.js" or "/app.css"; empty content for other paths.
PageFile page_file(const std::string& path);

} // namespace ionskin::apps::studio
