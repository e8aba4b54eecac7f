// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/skin/layer_box.hpp"

#include "ionskin/finite_layers/fields/field_faces.hpp"

#include <algorithm>
#include <future>
#include <mutex>
#include <utility>

namespace ionskin::finite_layers {
namespace {

std::size_t core_index(const Skin& skin) {
  const auto core = std::ranges::find(skin.layers, LayerRole::core, &Layer::role);
  return static_cast<std::size_t>(core - skin.layers.begin());
}

using Box = std::shared_ptr<const LayerBox>;

/// Stored box, which one thread makes while others may wait for it.
struct KeptBox {
  std::optional<LayerBoxKey> key;
  std::shared_future<Box> box;
};

} // namespace

LayerBoxKey::LayerBoxKey(const Skin& skin, const SkinResolution& resolved, bool mirrored_loads)
    : layers(elastic_layers(skin)), core(core_index(skin)), length(skin.length), width(skin.width),
      free_sides(skin.sides == SideCondition::free), mirrored(mirrored_loads),
      resolution(resolved) {}

LayerBox::LayerBox(LayerBoxKey made_of, int threads)
    : key(std::move(made_of)), surface(key.layers), short_waves(surface, key.resolution.split()),
      modes(surface, key.length, key.width, key.resolution.split()),
      column(key.layers, key.resolution.elements, key.resolution.degree) {
  const SkinResolution& resolution = key.resolution;
  const auto split = [&](double reach) { return WaveSplit(reach, resolution.split_tolerance); };
  if (key.free_sides) {
    const double reach = resolution.sides_reach;
    sides.emplace(column, key.length, key.width, split(reach), resolution.face(reach, key.length),
                  key.mirrored, threads);
  }
  const double reach = resolution.ends_reach;
  ends.emplace(column, key.length, key.width, split(reach), resolution.face(reach, key.width),
               sides ? &*sides : nullptr, key.mirrored, threads);
  fields = {key.layers, key.core, key.length, key.width, &column, sides ? &*sides : nullptr,
            &*ends,     nullptr};
  fields.faces = std::make_shared<const FieldFaces>(fields, key.mirrored, threads);
}

std::shared_ptr<const LayerBox> layer_box(const LayerBoxKey& key, int threads) {
  static std::mutex mutex;
  static KeptBox last;
  std::promise<Box> made;
  std::shared_future<Box> found;
  {
    const std::lock_guard lock(mutex);
    if (last.key == key) {
      found = last.box;
    } else {
      last = {key, made.get_future().share()};
    }
  }
  if (found.valid()) {
    return found.get();
  }
  try {
    auto box = std::make_shared<const LayerBox>(key, threads);
    made.set_value(box);
    return box;
  } catch (...) {
    made.set_exception(std::current_exception());
    const std::lock_guard lock(mutex);
    if (last.key == key) {
      last.key.reset();
    }
    throw;
  }
}

} // namespace ionskin::finite_layers
