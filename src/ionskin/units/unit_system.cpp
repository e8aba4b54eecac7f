// SPDX-License-Identifier: Apache-2.0
#include "ionskin/units/unit_system.hpp"

#include "ionskin/base/error.hpp"

#include <udunits2.h>

#include <array>
#include <memory>
#include <mutex>
#include <regex>

namespace ionskin::units {

namespace {

using Unit = std::unique_ptr<ut_unit, decltype(&ut_free)>;
using Converter = std::unique_ptr<cv_converter, decltype(&cv_free)>;

// udunits2 keeps its parser and its status in globals.
std::mutex& library_mutex() {
  static std::mutex mutex;
  return mutex;
}

// udunits2 knows whole powers only, so the unit of noise densities is one of its own.
constexpr const char* root_hertz = "roothertz";

void add_root_hertz(ut_system* system) {
  const Unit unit(ut_new_base_unit(system), &ut_free);
  ut_map_name_to_unit(root_hertz, UT_ASCII, unit.get());
  ut_map_unit_to_name(unit.get(), root_hertz, UT_ASCII);
}

std::string with_root_hertz(const std::string& unit) {
  static const std::regex spelling(R"(sqrt\(Hz\)|√Hz)");
  return std::regex_replace(unit, spelling, root_hertz);
}

ut_system* unit_system() {
  static const std::unique_ptr<ut_system, decltype(&ut_free_system)> system = [] {
    ut_set_error_message_handler(ut_ignore);
    std::unique_ptr<ut_system, decltype(&ut_free_system)> read(ut_read_xml(nullptr),
                                                               &ut_free_system);
    if (read)
      add_root_hertz(read.get());
    return read;
  }();
  if (!system)
    throw UserError(
        "the unit database of udunits2 cannot be read\n"
        "  = install the package libudunits2-data, or let UDUNITS2_XML_PATH name its file "
        "udunits2.xml");
  return system.get();
}

std::string with_molar_aliases(const std::string& unit) {
  static const std::regex molar("(^|[^A-Za-z_])([munp]?)M(?![A-Za-z_])");
  return std::regex_replace(unit, molar, "$1($2mol/L)");
}

// Words of udunits2 that shift the origin or take logarithms make no sense in a case file.
bool is_plain_unit(const std::string& unit) {
  static const std::regex forbidden(
      "@|\\b(since|after|from|ref|lg|ln|lb)\\b|^\\s*$|^\\s*[0-9]+(?!/)");
  return unit == "1" || !std::regex_search(unit, forbidden);
}

Unit parse(const std::string& unit) {
  if (!is_plain_unit(unit))
    return {nullptr, &ut_free};
  return {ut_parse(unit_system(), with_root_hertz(with_molar_aliases(unit)).c_str(), UT_UTF8),
          &ut_free};
}

} // namespace

bool unit_is_known(const std::string& unit) {
  const std::scoped_lock lock(library_mutex());
  return parse(unit) != nullptr;
}

std::optional<double> convert_unit(double value, const std::string& unit,
                                   const std::string& si_unit) {
  const std::scoped_lock lock(library_mutex());
  const Unit from = parse(unit), to = parse(si_unit);
  if (!from || !to)
    return {};
  // udunits2 also converts between reciprocals (seconds to hertz), so compare the dimensions
  // themselves.
  const Unit quotient(ut_divide(from.get(), to.get()), &ut_free);
  if (!quotient || !ut_is_dimensionless(quotient.get()))
    return {};
  const Converter converter(ut_get_converter(from.get(), to.get()), &cv_free);
  if (!converter)
    return {};
  return cv_convert_double(converter.get(), value);
}

std::string in_base_units(const std::string& unit) {
  const std::scoped_lock lock(library_mutex());
  const Unit parsed = parse(unit);
  if (!parsed)
    return {};
  std::array<char, 128> text{};
  const int length = ut_format(parsed.get(), text.data(), text.size(), UT_ASCII | UT_DEFINITION);
  return length > 0 ? std::string(text.data()) : std::string();
}

} // namespace ionskin::units
