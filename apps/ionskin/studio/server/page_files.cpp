// SPDX-License-Identifier: Apache-2.0
#include "studio/server/page_files.hpp"

// The assembler takes in the files that esbuild made.
#define IONSKIN_PAGE_FILE(symbol, file)                                                            \
  __asm__(".section .rodata\n"                                                                     \
          ".global " #symbol "_begin\n.global " #symbol "_end\n" #symbol "_begin:\n"               \
          ".incbin \"" IONSKIN_STUDIO_PAGE "/" file "\"\n" #symbol "_end:\n"                       \
          ".byte 0\n.previous\n");                                                                 \
  extern "C" const char symbol##_begin[], symbol##_end[]

IONSKIN_PAGE_FILE(ionskin_page_html, "index.html");
IONSKIN_PAGE_FILE(ionskin_page_js, "app.js");
IONSKIN_PAGE_FILE(ionskin_page_css, "app.css");

namespace ionskin::apps::studio {
namespace {

std::string_view between(const char* begin, const char* end) {
  return {begin, static_cast<std::size_t>(end - begin)};
}

} // namespace

PageFile page_file(const std::string& path) {
  if (path == "/") {
    return {between(ionskin_page_html_begin, ionskin_page_html_end), "text/html; charset=utf-8"};
  }
  if (path == "/app.js") {
    return {between(ionskin_page_js_begin, ionskin_page_js_end), "text/javascript; charset=utf-8"};
  }
  if (path == "/app.css") {
    return {between(ionskin_page_css_begin, ionskin_page_css_end), "text/css; charset=utf-8"};
  }
  return {};
}

} // namespace ionskin::apps::studio
