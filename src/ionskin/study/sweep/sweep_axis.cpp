// SPDX-License-Identifier: Apache-2.0
#include "ionskin/study/sweep/sweep_axis.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace ionskin::study {
namespace {

constexpr std::size_t most_values = 100000;

[[noreturn]] void refuse(const std::string& argument, const std::string& problem) {
  throw UserError(fmt::format(
      "--over {}: {}\n  = write --over KEY=first:step:last, --over KEY=value,value,... or, with "
      "--samples, --over KEY=lowest:highest; for example --over contact.friction=0.05:0.05:0.5",
      base::shown(argument), problem));
}

/// Parts of a text between separators outside of quotes and brackets.
std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts{""};
  int depth = 0;
  bool quoted = false;
  for (const char letter : text) {
    quoted = letter == '"' ? !quoted : quoted;
    depth += quoted ? 0 : (letter == '[' || letter == '{') - (letter == ']' || letter == '}');
    if (letter == separator && !quoted && depth == 0) {
      parts.emplace_back();
    } else {
      parts.back() += letter;
    }
  }
  for (std::string& part : parts) {
    part = base::trimmed(part);
  }
  return parts;
}

struct Number {
  double value = 0;
  std::string unit;
};

Number parse_number(const std::string& argument, std::string text) {
  if (text.size() > 1 && text.front() == '"' && text.back() == '"') {
    text = text.substr(1, text.size() - 2);
  }
  text = base::trimmed(text);
  const char* const begin = text.data() + (text.starts_with('+') ? 1 : 0);
  double value = 0;
  const auto [end, status] = std::from_chars(begin, text.data() + text.size(), value);
  if (status != std::errc() || !std::isfinite(value)) {
    refuse(argument, fmt::format("\"{}\" is not a number", base::shown(text)));
  }
  return {value, base::trimmed(std::string_view(end, text.data() + text.size()))};
}

/// Numbers of a range, all with the one unit that they share.
std::vector<Number> parse_numbers(const std::string& argument,
                                  const std::vector<std::string>& parts) {
  std::vector<Number> numbers;
  std::string unit;
  for (const std::string& part : parts) {
    numbers.push_back(parse_number(argument, part));
    const std::string& own = numbers.back().unit;
    if (!own.empty() && !unit.empty() && own != unit) {
      refuse(argument, fmt::format("the range mixes the units {} and {}", base::shown(unit),
                                   base::shown(own)));
    }
    unit = own.empty() ? unit : own;
  }
  for (Number& number : numbers) {
    number.unit = unit;
  }
  return numbers;
}

/// True if a text is a range as other programs write it: "0.1..0.5", "0.1-0.5", "0.1 to 0.5".
bool is_foreign_range(const std::string& value) {
  double first = 0;
  const auto [end, status] = std::from_chars(value.data(), value.data() + value.size(), first);
  if (status != std::errc()) {
    return false;
  }
  const std::string rest = base::trimmed(std::string_view(end, value.data() + value.size()));
  const auto begins_number = [&rest](std::size_t place) {
    const std::string behind =
        base::trimmed(std::string_view(rest).substr(std::min(place, rest.size())));
    return !behind.empty() &&
           (std::isdigit(static_cast<unsigned char>(behind[0])) != 0 || behind[0] == '-');
  };
  const std::size_t dots = rest.find("..");
  return (dots != std::string::npos && begins_number(dots + 2)) ||
         (rest.starts_with('-') && begins_number(1)) ||
         (rest.starts_with("to ") && begins_number(3));
}

std::vector<std::string> steps(const std::string& argument, const std::vector<Number>& range) {
  const double first = range[0].value, step = range[1].value, last = range[2].value;
  const double count = step == 0 ? -1 : (last - first) / step;
  if (count < 0) {
    refuse(argument, "the step does not lead from the first value to the last");
  }
  if (count >= static_cast<double>(most_values)) {
    refuse(argument, fmt::format("that are more than {} values", most_values));
  }
  std::vector<std::string> values;
  const auto whole = static_cast<std::size_t>(std::floor(count * (1 + 1e-12) + 1e-9));
  for (std::size_t i = 0; i <= whole; ++i) {
    // Twelve digits hide the rounding of the multiplication: 0.15, not 0.15000000000000002.
    values.push_back(fmt::format("{:.12g}{}{}", first + static_cast<double>(i) * step,
                                 range[0].unit.empty() ? "" : " ", range[0].unit));
  }
  return values;
}

} // namespace

SweepAxis parse_axis(const std::string& argument) {
  const std::size_t equals = argument.find('=');
  if (equals == std::string::npos || equals == 0) {
    refuse(argument, "the key or the sign = is missing");
  }
  SweepAxis axis{base::trimmed(argument.substr(0, equals)), {}, {}};
  const std::string typed = base::trimmed(argument.substr(equals + 1));
  const std::vector<std::string> parts = split(typed, ':');
  if (parts.size() > 3) {
    refuse(argument, "a range has two or three parts");
  }
  if (parts.size() > 1) {
    const std::vector<Number> numbers = parse_numbers(argument, parts);
    if (parts.size() == 3) {
      axis.values = steps(argument, numbers);
    } else if (numbers[0].value < numbers[1].value) {
      axis.interval = {numbers[0].value, numbers[1].value, numbers[0].unit};
    } else {
      refuse(argument, "the lower end of an interval must be below the upper one");
    }
    return axis;
  }
  axis.values = split(typed, ',');
  if (axis.values.size() > most_values) {
    refuse(argument, fmt::format("that are more than {} values", most_values));
  }
  for (const std::string& value : axis.values) {
    if (value.empty()) {
      refuse(argument, "a value is missing");
    }
    if (is_foreign_range(value)) {
      refuse(argument, fmt::format("\"{}\" is not a range", base::shown(value)));
    }
  }
  return axis;
}

} // namespace ionskin::study
