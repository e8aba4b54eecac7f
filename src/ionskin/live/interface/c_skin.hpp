// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/interface/ionskin_live.h"

#include "ionskin/live/skin.hpp"

#include <memory>

struct ionskin_live_skin {
  explicit ionskin_live_skin(std::shared_ptr<const ionskin::live::SkinData> shared)
      : data(std::move(shared)), skin(*data) {}
  std::shared_ptr<const ionskin::live::SkinData> data;
  ionskin::live::Skin skin;
};
