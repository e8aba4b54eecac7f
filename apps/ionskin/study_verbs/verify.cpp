// SPDX-License-Identifier: Apache-2.0
#include "study_verbs/verify.hpp"

#include "command_line/threads.hpp"
#include "ionskin/base/error.hpp"
#include "ionskin/base/system/interrupt.hpp"
#include "ionskin/base/timers.hpp"
#include "terminal/progress_display.hpp"
#include "verification_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>
#include <utility>
#include <vector>

namespace ionskin::apps {
namespace {

using Part = std::vector<verification::Row> (*)(const verification::Options&);
constexpr std::array<std::pair<std::string_view, Part>, 4> parts{
    {{"mechanics", verification::verify_mechanics},
     {"electrochemistry", verification::verify_electrochemistry},
     {"poroelasticity", verification::verify_poroelasticity},
     {"chain", verification::verify_chain}}};

void print_table(const std::vector<verification::Row>& rows) {
  std::size_t width = 0;
  for (const auto& row : rows) {
    width = std::max(width, row.quantity.size());
  }
  fmt::print("{:<5} {:<{}} {:>14} {:>14} {:>11}  verdict\n", "id", "quantity", width, "value",
             "reference", "tolerance");
  for (const auto& row : rows) {
    fmt::print("{:<5} {:<{}} {:>14.7g} {:>14.7g} {:>11.2g}  {}\n", row.id, row.quantity, width,
               row.value, row.reference, row.tolerance, row.passed ? "pass" : "FAIL");
  }
}

/// Writes the table as CSV; quantities are quoted, since some contain commas.
void write_csv(const std::vector<verification::Row>& rows, const std::string& path) {
  std::ofstream file(path);
  file << "id,quantity,value,reference,tolerance,verdict\n";
  for (const auto& row : rows) {
    file << fmt::format("{},\"{}\",{:.10g},{:.10g},{:.10g},{}\n", row.id, row.quantity, row.value,
                        row.reference, row.tolerance, row.passed ? "pass" : "FAIL");
  }
  if (!file.flush()) {
    throw UserError(
        fmt::format("{} cannot be written\n  = check its folder and its permissions", path));
  }
}

} // namespace

int verify(const VerifyOptions& options) {
  base::install_interrupt_handler();
  const double start = base::wall_time();
  ProgressDisplay display(LogFormat::automatic);
  verification::Options settings;
  settings.threads = thread_count(options.threads);
  settings.progress = display.callback();
  std::vector<verification::Row> rows;
  for (const auto& [name, part] : parts) {
    if (options.part.empty() || options.part == name) {
      const auto more = part(settings);
      rows.insert(rows.end(), more.begin(), more.end());
    }
  }
  print_table(rows);
  if (!options.csv.empty()) {
    write_csv(rows, options.csv);
  }
  const auto passed =
      std::count_if(rows.begin(), rows.end(), [](const auto& row) { return row.passed; });
  const auto failed = static_cast<std::ptrdiff_t>(rows.size()) - passed;
  fmt::print("{} passed, {} failed, {:.1f} s\n", passed, failed, base::wall_time() - start);
  return static_cast<int>(failed == 0 ? ExitCode::success : ExitCode::solver_gave_up);
}

} // namespace ionskin::apps
