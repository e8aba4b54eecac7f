// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/data/skin_data.hpp"

#include <string>

namespace ionskin::live::fmu {

/// Name of the library inside the FMU, without its file extension.
inline constexpr const char* model_identifier = "ionskin_live";

/// GUID of the FMU, by which the library recognises that the model description belongs to its skin:
/// digest of the `.live` file, in braces.
std::string guid(const SkinData& data);

/// Text of modelDescription.xml.
/// @param name of the model, as importers show it
std::string model_description(const SkinData& data, const std::string& name);

} // namespace ionskin::live::fmu
