// SPDX-License-Identifier: Apache-2.0
#include "ionskin/base/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace ionskin::base {
namespace {

constexpr std::size_t longest_line = 400, most_lines = 150;
constexpr std::string_view left_out = " ... ";

/// Length of the UTF-8 sequence at the start of a text that is not empty [bytes]; 0 if there is no
/// valid one.
std::size_t sequence_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t length = byte(0) < 0x80   ? 1
                             : byte(0) < 0xC2 ? 0
                             : byte(0) < 0xE0 ? 2
                             : byte(0) < 0xF0 ? 3
                             : byte(0) < 0xF5 ? 4
                                              : 0;
  if (length == 0 || length > text.size())
    return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0U) != 0x80U)
      return 0;
  const bool overlong = (byte(0) == 0xE0 && byte(1) < 0xA0) || (byte(0) == 0xF0 && byte(1) < 0x90);
  const bool surrogate = byte(0) == 0xED && byte(1) >= 0xA0;
  const bool beyond = byte(0) == 0xF4 && byte(1) >= 0x90;
  return overlong || surrogate || beyond ? 0 : length;
}

/// True for a UTF-8 sequence that a terminal interprets: control characters of ASCII and Latin-1,
/// line and paragraph separators, and characters that change the direction of writing.
bool acts_on_terminal(std::string_view sequence) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(sequence[i]); };
  if (sequence.size() == 1)
    return byte(0) < 0x20 || byte(0) == 0x7F;
  if (sequence.size() == 2)
    return byte(0) == 0xC2 && byte(1) < 0xA0;
  return sequence.size() == 3 && byte(0) == 0xE2 &&
         ((byte(1) == 0x80 && byte(2) >= 0xA8 && byte(2) <= 0xAE) ||
          (byte(1) == 0x81 && byte(2) >= 0xA6 && byte(2) <= 0xA9));
}

std::string escaped(std::string_view text, std::string_view kept) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = sequence_length(text.substr(i));
    const std::string_view sequence = text.substr(i, std::max<std::size_t>(length, 1));
    if (length > 0 && (!acts_on_terminal(sequence) || kept.find(text[i]) != kept.npos))
      result += sequence;
    else if (text[i] == '\n')
      result += "\\n";
    else
      for (const char letter : sequence)
        result += fmt::format("\\x{:02x}", static_cast<unsigned char>(letter));
    i += sequence.size();
  }
  return result;
}

/// Shortens a text longer than `most` bytes to its start and end, cut between UTF-8 sequences.
std::string shortened(const std::string& text, std::size_t most) {
  if (text.size() <= most)
    return text;
  const auto starts = [&](std::size_t i) {
    return (static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U;
  };
  std::size_t head = most * 2 / 3, tail = text.size() - most / 3;
  while (head > 0 && !starts(head))
    --head;
  while (tail < text.size() && !starts(tail))
    ++tail;
  return text.substr(0, head).append(left_out) + text.substr(tail);
}

bool is_number(std::string_view text) {
  double ignored = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), ignored);
  return status == std::errc() && end == text.data() + text.size();
}

} // namespace

std::string trimmed(std::string_view text, std::string_view blanks) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos)
    return {};
  return std::string(text.substr(first, text.find_last_not_of(blanks) - first + 1));
}

std::vector<std::string> split(std::string_view text, char separator, std::string_view blanks) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(trimmed(text.substr(begin, end - begin), blanks));
    begin = end + 1;
  }
  return parts;
}

std::string shown(std::string_view text, std::size_t most) {
  // Only the ends are escaped, however long the text is.
  if (text.size() > 4 * most)
    return shortened(escaped(text.substr(0, 2 * most), "") +
                         escaped(text.substr(text.size() - 2 * most), ""),
                     most) +
           fmt::format(" ({} bytes)", text.size());
  return shortened(escaped(text, ""), most);
}

std::string printable(std::string_view message) {
  std::string result;
  std::size_t lines = 0;
  for (std::size_t begin = 0; begin <= message.size(); ++lines) {
    const std::size_t end = std::min(message.find('\n', begin), message.size());
    if (lines == most_lines)
      return result + "\n...";
    result += (lines == 0 ? "" : "\n");
    result += shortened(escaped(message.substr(begin, end - begin), "\t"), longest_line);
    begin = end + 1;
  }
  return result;
}

std::string csv_cell(std::string_view text) {
  std::string cell(text);
  if (!cell.empty() && std::string_view("=+-@\t\r").find(cell.front()) != std::string_view::npos &&
      !is_number(cell.front() == '+' ? text.substr(1) : text))
    cell.insert(0, "'");
  if (cell.find_first_of(",\"\n\r'") == std::string::npos)
    return cell;
  std::string result = "\"";
  for (const char letter : cell)
    result += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return result + "\"";
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = sequence_length(text);
    if (length == 0)
      return false;
    text.remove_prefix(length);
  }
  return true;
}

} // namespace ionskin::base
