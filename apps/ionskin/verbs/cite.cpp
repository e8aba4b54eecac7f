// SPDX-License-Identifier: Apache-2.0
#include "verbs/cite.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/case/reading/read_case.hpp"
#include "verbs/references.hpp"
#include "version.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <optional>

namespace ionskin::apps {
namespace {

namespace fs = std::filesystem;

constexpr const char* release_year = "2026";

/// Reads the case of a run's folder, or a case file; nullopt for the folder of a sweep, which has
/// no case of its own.
std::optional<Case> case_at(const std::string& path) {
  if (path.empty()) {
    return std::nullopt;
  }
  fs::path file = path;
  if (fs::is_directory(file)) {
    file /= "case.toml";
    if (!fs::is_regular_file(file)) {
      throw UserError(fmt::format("{} holds no case.toml\n  = name the folder of a run, such as a "
                                  "point of a sweep, or a case file",
                                  path));
    }
  }
  return read_case(file.string(), {});
}

void print_program() {
  const std::string version = version_text().substr(version_text().rfind(' ') + 1);
  fmt::print("% The program. State the commit and the input hash too: both stand in manifest.json "
             "of every run, and\n% howpublished is where you have it from.\n"
             "@software{{ionskin,\n"
             "  author = {{{{The ionskin contributors}}}},\n"
             "  title = {{{{ionskin}}: a simulator of ionic artificial skins}},\n"
             "  version = {{{}}},\n"
             "  year = {{{}}},\n"
             "  license = {{Apache-2.0}}\n"
             "}}\n\n",
             version, release_year);
}

/// Prints the entry of the article. Its authors and title do not come with ionskin; they are found
/// by its DOI.
void print_article() {
  fmt::print(
      "% The article whose case is cases/paper.toml, with the figures 1 to 16 and the claims that "
      "reports judge.\n"
      "% Its authors and title, as BibTeX:\n"
      "%   curl -LH 'Accept: application/x-bibtex' https://doi.org/10.3390/s26102930\n"
      "@article{{ionic_skin_2026,\n"
      "  journal = {{Sensors}},\n"
      "  year = {{2026}},\n"
      "  volume = {{26}},\n"
      "  number = {{10}},\n"
      "  pages = {{2930}},\n"
      "  doi = {{10.3390/s26102930}},\n"
      "  url = {{https://doi.org/10.3390/s26102930}}\n"
      "}}\n");
}

} // namespace

int cite(const CiteOptions& options) {
  const std::optional<Case> input = case_at(options.path);
  print_program();
  print_article();
  for (const Reference& one : references()) {
    if (!input || one.used(*input)) {
      fmt::print("\n{}", bibtex(one));
    }
  }
  return 0;
}

} // namespace ionskin::apps
