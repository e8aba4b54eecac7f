// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/text/toml_limits.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/text.hpp"
#include "ionskin/case/text/case_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string_view>

namespace ionskin {

namespace {

bool ends_word(char letter) {
  return std::string_view(" \t\r\n,=[]{}#\"'").find(letter) != std::string_view::npos;
}

/// Scans a text once. It recognises only strings, comments, brackets and words of TOML.
class TextScan {
public:
  TextScan(const std::string& text, const std::string& file) : text_(text), file_(file) {}

  /// Checks the whole text.
  /// @return as of `check_toml_limits`
  std::vector<std::size_t> run() {
    check_bytes();
    while (at_ < text_.size())
      step();
    return std::move(breaks_);
  }

private:
  [[noreturn]] void refuse(std::size_t begin, std::size_t length, const std::string& message,
                           const std::string& remedy) const {
    Problems problems;
    problems.add(message, {{CaseText(file_, text_).place(begin, length), ""}}, remedy);
    problems.throw_if_any(file_);
    throw InternalError("a refused text was accepted");
  }

  void check_bytes() const {
    if (text_.size() > toml_limits::bytes)
      throw UserError(
          fmt::format("{} has {} bytes, more than the {} that a case may have\n  = keep "
                      "long paths and height maps in files of their own: motion.file, "
                      "slider.profile",
                      base::shown(file_), text_.size(), toml_limits::bytes));
    std::size_t begin = 0;
    while (begin < text_.size()) {
      const std::size_t end = std::min(text_.find('\n', begin), text_.size());
      const std::string_view line = std::string_view(text_).substr(begin, end - begin);
      if (!base::is_utf8(line))
        refuse(begin, 1, "this line is not UTF-8", "save the file as UTF-8 text");
      const auto control = std::ranges::find_if(line, [](unsigned char letter) {
        return (letter < 0x20 && letter != '\t' && letter != '\r') || letter == 0x7F;
      });
      if (control != line.end())
        refuse(begin + static_cast<std::size_t>(control - line.begin()), 1,
               "a control character stands in this line", "remove it; texts need none");
      begin = end + 1;
    }
  }

  void step() {
    const char letter = text_[at_];
    if (letter == '#') {
      at_ = std::min(text_.find('\n', at_), text_.size());
    } else if (letter == '"' || letter == '\'') {
      skip_text(letter);
    } else if (ends_word(letter)) {
      take_sign(letter);
      ++at_;
    } else {
      take_word();
    }
  }

  void take_sign(char letter) {
    if (letter == '[' || letter == '{')
      open(letter);
    if ((letter == ']' || letter == '}') && !open_.empty())
      open_.pop_back();
    if (letter == '=' || letter == ',')
      count_value();
    if (letter == ',' && open_.ends_with('[') && at_ + 1 - line_begin_ >= long_line)
      begin_line(breaks_.emplace_back(at_ + 1));
    if (letter == '\n')
      begin_line(at_ + 1);
    if (letter != ' ' && letter != '\t')
      dots_ = 0;
  }

  void begin_line(std::size_t begin) {
    line_begin_ = begin;
    braced_ = 0;
  }

  void open(char bracket) {
    open_ += bracket;
    if (open_.size() > toml_limits::depth)
      refuse(at_, 1, fmt::format("more than {} brackets stand in one another", toml_limits::depth),
             "no key of a case needs more than 3");
  }

  void count_value() {
    if (++values_ > toml_limits::values)
      refuse(at_, 1, fmt::format("the text holds more than {} values", toml_limits::values),
             "keep long paths and height maps in files of their own: motion.file, slider.profile");
    braced_ += open_.find('{') != std::string::npos ? 1 : 0;
    if (braced_ > toml_limits::braced)
      refuse(at_, 1,
             fmt::format("more than {} values stand in braces in one line", toml_limits::braced),
             "write a section [NAME] with a line for each key");
  }

  void count_dots(std::size_t count) {
    dots_ += count;
    if (dots_ > toml_limits::depth)
      refuse(at_, 1, fmt::format("a key with more than {} parts", toml_limits::depth),
             "no key of a case has more than 3");
  }

  void skip_text(char quote) {
    const std::size_t begin = at_;
    const std::string three(3, quote);
    const bool several_lines = text_.compare(at_, 3, three) == 0;
    for (at_ += several_lines ? 3 : 1; at_ < text_.size(); ++at_) {
      if (text_[at_] == '\\' && quote == '"')
        ++at_;
      else if (several_lines ? text_.compare(at_, 3, three) == 0
                             : text_[at_] == quote || text_[at_] == '\n')
        break;
    }
    at_ = std::min(at_ + (several_lines ? 3 : 1), text_.size());
    if (at_ - begin > toml_limits::text_bytes)
      refuse(begin, 1,
             fmt::format("a text of {} bytes, more than the {} that one may have", at_ - begin,
                         toml_limits::text_bytes),
             "shorten it");
    if (at_ - begin > toml_limits::name_bytes && is_key(at_))
      refuse_name(begin);
  }

  [[noreturn]] void refuse_name(std::size_t begin) const {
    refuse(begin, 1,
           fmt::format("a name of {} bytes, more than the {} that one may have", at_ - begin,
                       toml_limits::name_bytes),
           "shorten it");
  }

  // True if the word or string that ends at `end` is a key or a part of one: = or a dot follows.
  bool is_key(std::size_t end) const {
    const std::size_t next = text_.find_first_not_of(" \t", end);
    return next != std::string::npos && (text_[next] == '=' || text_[next] == '.');
  }

  void take_word() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && !ends_word(text_[at_]))
      ++at_;
    const std::string_view word = std::string_view(text_).substr(begin, at_ - begin);
    count_dots(static_cast<std::size_t>(std::ranges::count(word, '.')));
    if (word.size() > toml_limits::name_bytes)
      refuse_name(begin);
    if (!is_key(at_))
      check_number(begin, word);
  }

  void check_number(std::size_t begin, std::string_view word) const {
    std::string digits;
    std::ranges::copy_if(word, std::back_inserter(digits), [](char c) { return c != '_'; });
    const bool hexadecimal = digits.starts_with("0x");
    const int base = hexadecimal                ? 16
                     : digits.starts_with("0o") ? 8
                     : digits.starts_with("0b") ? 2
                                                : 10;
    const char* first = digits.data() + (base != 10 || digits.starts_with('+') ? 1 : 0);
    first += base != 10 ? 1 : 0;
    const char* last = digits.data() + digits.size();
    std::int64_t whole = 0;
    const auto [end, status] = std::from_chars(first, last, whole, base);
    if (end == last && status == std::errc::result_out_of_range)
      refuse(begin, word.size(), "this integer does not fit into 64 bits",
             "write a number with a decimal point or an exponent, such as 1e20, where one is "
             "allowed");
    if (end == last || base != 10)
      return;
    double number = 0;
    const auto parsed = std::from_chars(first, last, number);
    if (parsed.ptr == last && parsed.ec == std::errc::result_out_of_range)
      refuse(begin, word.size(), "this number is too large or too small to be represented",
             "numbers reach from 1e-307 to 1e308");
  }

  const std::string& text_;
  const std::string& file_;
  static constexpr std::size_t long_line = 200;
  std::size_t at_ = 0, dots_ = 0, values_ = 0, line_begin_ = 0, braced_ = 0;
  std::string open_; ///< opening brackets that are not closed yet, outermost first
  std::vector<std::size_t>
      breaks_; ///< offsets at which lines longer than `long_line` may be broken
};

} // namespace

std::vector<std::size_t> check_toml_limits(const std::string& text, const std::string& file) {
  return TextScan(text, file).run();
}

} // namespace ionskin
