// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace ionskin::apps::studio {

/// A file of the page, compiled into the program.
struct PageFile {
  std::string_view content;
  const char* type = "";
};

/// The file at "/", "/app.js" or "/app.css"; no content for other paths.
PageFile page_file(const std::string& path);

} // namespace ionskin::apps::studio
