// SPDX-License-Identifier: Apache-2.0
#include "verbs/cite.hpp"

#include "version.hpp"

#include <fmt/core.h>

namespace ionskin::apps {

int cite() {
  const std::string version = version_text().substr(version_text().rfind(' ') + 1);
  fmt::print(
      "The ionskin contributors: ionskin, a simulator of ionic artificial skins, version {0}."
      "\n\n"
      "@software{{ionskin,\n"
      "  author  = {{{{The ionskin contributors}}}},\n"
      "  title   = {{{{ionskin}}: a simulator of ionic artificial skins}},\n"
      "  version = {{{0}}}\n"
      "}}\n\n"
      "The case cases/paper.toml, the figures 1 to 16 and the claims that reports judge are those "
      "of the\n"
      "article on a layered ionic polymer-metal composite skin under touch, slide and lift\n\n"
      "@article{{ionic_skin_2026,\n"
      "  journal = {{Sensors}},\n"
      "  year    = {{2026}},\n"
      "  volume  = {{26}},\n"
      "  number  = {{10}},\n"
      "  pages   = {{2930}},\n"
      "  doi     = {{10.3390/s26102930}}\n"
      "}}\n\n"
      "Its title and authors stand at https://doi.org/10.3390/s26102930.\n"
      "State the commit and the input hash too: both stand in manifest.json of every run.\n",
      version);
  return 0;
}

} // namespace ionskin::apps
