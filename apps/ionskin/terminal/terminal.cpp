// SPDX-License-Identifier: Apache-2.0
#include "terminal/terminal.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <sys/ioctl.h>
#include <unistd.h>

namespace ionskin::apps {

std::size_t terminal_width(int descriptor) {
  constexpr long least = 20, usual = 80, most = 10000;
  winsize size{};
  long columns = ioctl(descriptor, TIOCGWINSZ, &size) == 0 ? size.ws_col : 0;
  if (const char* given = std::getenv("COLUMNS"); columns <= 0 && given != nullptr) {
    columns = std::strtol(given, nullptr, 10);
  }
  return static_cast<std::size_t>(std::clamp(columns <= 0 ? usual : columns, least, most));
}

std::string wrapped(std::string_view text, std::size_t width, std::size_t indent) {
  std::istringstream words{std::string(text)};
  std::string result;
  std::size_t column = 0;
  for (std::string word; words >> word;) {
    if (column > 0 && column + 1 + word.size() > width) {
      result += '\n' + std::string(indent, ' ') + word;
      column = indent + word.size();
    } else {
      result += (column > 0 ? " " : "") + word;
      column += (column > 0 ? 1 : 0) + word.size();
    }
  }
  return result;
}

std::string paragraph(std::string_view text, std::size_t indent, int descriptor) {
  const bool terminal = isatty(descriptor) != 0;
  return (terminal ? wrapped(text, terminal_width(descriptor), indent) : std::string(text)) + "\n";
}

std::string shell_text(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) {
    const bool plain = !word.empty() && std::all_of(word.begin(), word.end(), [](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
             std::string_view("_-./=,:+").find(c) != std::string_view::npos;
    });
    std::string quoted = word;
    if (!plain) {
      quoted = "'";
      for (const char c : word) {
        quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
      }
      quoted += "'";
    }
    line += (line.empty() ? "" : " ") + quoted;
  }
  return line;
}

std::string command_as_typed(int argc, char** argv) {
  std::vector<std::string> words(argv, argv + argc);
  words.front() = "ionskin";
  return shell_text(words);
}

std::string duration_text(double seconds) {
  const auto whole = static_cast<long>(std::lround(std::clamp(seconds, 0.0, 1e9)));
  if (whole < 60) {
    return fmt::format("{} s", whole);
  }
  if (whole < 3600) {
    return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  }
  return fmt::format("{} h {:02} min", whole / 3600, whole % 3600 / 60);
}

} // namespace ionskin::apps
