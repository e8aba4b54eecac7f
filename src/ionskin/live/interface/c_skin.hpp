// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/interface/ionskin_live.h"

#include "ionskin/live/errors/shortfall.hpp"
#include "ionskin/live/skin.hpp"

#include <memory>
#include <string>
#include <utility>

/// Skin behind a handle of the C interface: shared data of the file, the text of `shortfall`, and
/// the skin with its state.
struct ionskin_live_skin {
  explicit ionskin_live_skin(std::shared_ptr<const ionskin::live::SkinData> shared)
      : data(std::move(shared)), shortfall(ionskin::live::shortfall(*data)), skin(*data) {}
  std::shared_ptr<const ionskin::live::SkinData> data;
  std::string shortfall;
  ionskin::live::Skin skin;
};
