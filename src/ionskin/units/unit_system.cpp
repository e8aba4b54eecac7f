// SPDX-License-Identifier: Apache-2.0
#include "ionskin/units/unit_system.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/base/text.hpp"

#include <fmt/format.h>
#include <udunits2.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <string_view>

#include <locale.h>

namespace ionskin::units {

namespace {

using Unit = std::unique_ptr<ut_unit, decltype(&ut_free)>;
using Converter = std::unique_ptr<cv_converter, decltype(&cv_free)>;

/// Guard around calls of udunits2: locks a mutex and sets the "C" locale for the thread. udunits2
/// keeps its parser and its status in globals, and would misread its database in a locale with
/// decimal commas.
class LibraryUse {
public:
  LibraryUse() : lock_(mutex()), before_(uselocale(c_locale())) {}
  ~LibraryUse() { uselocale(before_); }
  LibraryUse(const LibraryUse&) = delete;
  LibraryUse& operator=(const LibraryUse&) = delete;

private:
  static std::mutex& mutex() {
    static std::mutex mutex;
    return mutex;
  }
  static locale_t c_locale() {
    static locale_t const locale = newlocale(LC_ALL_MASK, "C", nullptr);
    return locale;
  }

  std::scoped_lock<std::mutex> lock_;
  locale_t before_;
};

// Name of a base unit for the root of hertz, in noise densities: udunits2 knows only whole powers.
constexpr const char* root_hertz = "roothertz";

void add_root_hertz(ut_system* system) {
  const Unit unit(ut_new_base_unit(system), &ut_free);
  ut_map_name_to_unit(root_hertz, UT_ASCII, unit.get());
  ut_map_unit_to_name(unit.get(), root_hertz, UT_ASCII);
}

/// Adds the square of sheet resistances, "ohm/sq", which has no dimension.
void add_square(ut_system* system) {
  const Unit one(ut_get_dimensionless_unit_one(system), &ut_free);
  ut_map_name_to_unit("sq", UT_ASCII, one.get());
  ut_map_name_to_unit("square", UT_ASCII, one.get());
}

std::string with_root_hertz(const std::string& unit) {
  std::string result = unit;
  for (const std::string_view spelling : {"sqrt(Hz)", "√Hz"})
    for (std::size_t at = 0; (at = result.find(spelling, at)) != std::string::npos;)
      result.replace(at, spelling.size(), root_hertz);
  return result;
}

ut_system* unit_system() {
  static std::unique_ptr<ut_system, decltype(&ut_free_system)> system(nullptr, &ut_free_system);
  if (!system) { // retried after a failure: the host may have set the path since
    ut_set_error_message_handler(ut_ignore);
    system.reset(ut_read_xml(nullptr));
    if (system) {
      add_root_hertz(system.get());
      add_square(system.get());
    }
  }
  if (!system)
    throw UserError(
        "the unit database of udunits2 cannot be read\n"
        "  = install the package libudunits2-data, or let UDUNITS2_XML_PATH name its file "
        "udunits2.xml");
  return system.get();
}

constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_";
constexpr std::string_view digits = "0123456789", blanks = " \t\n\v\f\r";
// Limit on the length of a unit [bytes], more than any unit needs and little for the parser of
// udunits2.
constexpr std::size_t longest_unit = 64;

bool is_word_letter(char letter) {
  return letters.find(letter) != std::string_view::npos;
}

std::string with_aliases(const std::string& unit) {
  std::string result;
  for (std::size_t begin = 0; begin < unit.size();) {
    if (!is_word_letter(unit[begin])) {
      result += unit[begin++];
      continue;
    }
    const std::size_t end = std::min(unit.find_first_not_of(letters, begin), unit.size());
    const std::string_view word = std::string_view(unit).substr(begin, end - begin);
    const bool molar = word == "M" || word == "mM" || word == "uM" || word == "nM" || word == "pM";
    if (molar) {
      result += fmt::format("({}mol/L)", word.substr(0, word.size() - 1));
    } else {
      result += word == "deg" ? "arc_degree" : word;
    }
    begin = end;
  }
  return result;
}

bool has_forbidden_word(const std::string& unit) {
  const auto belongs = [](char letter) {
    return is_word_letter(letter) || digits.find(letter) != std::string_view::npos;
  };
  for (std::size_t begin = 0; begin < unit.size();) {
    std::size_t end = begin;
    while (end < unit.size() && belongs(unit[end]))
      ++end;
    const std::string_view word = std::string_view(unit).substr(begin, end - begin);
    for (const char* forbidden : {"since", "after", "from", "ref", "lg", "ln", "lb"})
      if (word == forbidden)
        return true;
    begin = end + 1;
  }
  return false;
}

/// True if a unit contains a number that is not an exponent, except for the 1 of "1/s". udunits2
/// would multiply by the number: "1 3 mm" and "1 mm 3" would be 3 mm.
bool has_factor(const std::string& unit) {
  const auto is_digit = [](char letter) { return digits.find(letter) != std::string_view::npos; };
  const auto takes_exponent = [](char letter) {
    return is_word_letter(letter) || letter == ')' || letter == '^' ||
           static_cast<unsigned char>(letter) > 0x7F;
  };
  const std::size_t first = unit.find_first_not_of(blanks);
  for (std::size_t begin = 0; begin < unit.size(); ++begin) {
    if (!is_digit(unit[begin]) || (begin > 0 && is_digit(unit[begin - 1])))
      continue;
    const std::string_view before = std::string_view(unit).substr(0, begin);
    const bool sign = before.ends_with('-') || before.ends_with('+');
    const std::string_view base = before.substr(0, before.size() - (sign ? 1 : 0));
    const bool exponent = !base.empty() && (takes_exponent(base.back()) || base.ends_with("**"));
    const bool one = begin == first && unit.substr(begin, 2) == "1/";
    if (!exponent && !one)
      return true;
  }
  return false;
}

/// True if a percent sign is combined with anything else, as in "5 % %" or "5 % m/m", which is a
/// mistake.
bool has_mixed_percent(const std::string& unit) {
  const std::string clean = base::trimmed(unit);
  return clean != "%" && clean != "percent" &&
         (clean.find('%') != clean.npos || clean.find("percent") != clean.npos);
}

// True if a text can be passed to udunits2 as a unit. Refused are numbers other than exponents, and
// words of udunits2 that shift the origin or take logarithms.
bool is_plain_unit(const std::string& unit) {
  if (unit == "1")
    return true;
  if (unit.size() > longest_unit || unit.find_first_of(std::string_view("@\0", 2)) != unit.npos ||
      unit.find_first_not_of(blanks) == unit.npos)
    return false;
  return !has_factor(unit) && !has_mixed_percent(unit) && !has_forbidden_word(unit);
}

Unit parse(const std::string& unit) {
  if (!is_plain_unit(unit))
    return {nullptr, &ut_free};
  return {ut_parse(unit_system(), with_root_hertz(with_aliases(unit)).c_str(), UT_UTF8), &ut_free};
}

Converter make_converter(const std::string& unit, const std::string& si_unit) {
  const Unit from = parse(unit), to = parse(si_unit);
  if (!from || !to)
    return {nullptr, &cv_free};
  // udunits2 also converts between reciprocals (seconds to hertz), so compare the dimensions
  // themselves.
  const Unit quotient(ut_divide(from.get(), to.get()), &ut_free);
  if (!quotient || !ut_is_dimensionless(quotient.get()))
    return {nullptr, &cv_free};
  return {ut_get_converter(from.get(), to.get()), &cv_free};
}

// Largest number of cached converters. Files use few units; the cache is cleared when it is full.
constexpr std::size_t most_converters = 256;

} // namespace

bool unit_is_known(const std::string& unit) {
  const LibraryUse use;
  return parse(unit) != nullptr;
}

std::optional<double> convert_unit(double value, const std::string& unit,
                                   const std::string& si_unit) {
  static std::map<std::pair<std::string, std::string>, Converter> converters;
  const LibraryUse use;
  auto known = converters.find({unit, si_unit});
  if (known == converters.end()) {
    if (converters.size() == most_converters)
      converters.clear();
    known = converters.emplace(std::pair(unit, si_unit), make_converter(unit, si_unit)).first;
  }
  if (!known->second)
    return {};
  return cv_convert_double(known->second.get(), value);
}

std::string in_base_units(const std::string& unit) {
  const LibraryUse use;
  const Unit parsed = parse(unit);
  if (!parsed)
    return {};
  std::array<char, 128> text{};
  const int length = ut_format(parsed.get(), text.data(), text.size(), UT_ASCII | UT_DEFINITION);
  return length > 0 ? std::string(text.data()) : std::string();
}

} // namespace ionskin::units
