// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/skin_data.hpp"

#include <string>

namespace ionskin::live::fmu {

/// Name of the library inside an FMU, without its ending.
inline constexpr const char* model_identifier = "ionskin_live";

/// Identifier by which a library knows that the description beside it is that of its skin: the
/// digest of the skin's file in braces.
std::string guid(const SkinData& data);

/// The text of modelDescription.xml. @param name of the model, as importers show it
std::string model_description(const SkinData& data, const std::string& name);

} // namespace ionskin::live::fmu
