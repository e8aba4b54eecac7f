// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/fields/field_faces.hpp"

#include <cstddef>
#include <numeric>

namespace ionskin::finite_layers {
namespace {

/// Largest wave number that is summed of the waves excited by a moving face, times the thickness of
/// the skin.
constexpr double face_waves = 128;

} // namespace

FieldFaces::FieldFaces(const FieldSkin& skin, bool mirrored, int threads) {
  const double thickness =
      std::accumulate(skin.layers.begin(), skin.layers.end(), 0.0,
                      [](double sum, const ElasticLayer& layer) { return sum + layer.thickness; });
  const double last = face_waves / thickness;
  if (skin.sides != nullptr) {
    std::vector<Eigen::Index> along(static_cast<std::size_t>(skin.sides->modes()));
    std::iota(along.begin(), along.end(), Eigen::Index{0});
    for (const Parity parity : parities(mirrored)) {
      sides.emplace_back(*skin.column, Face::side, skin.length, skin.width, along, parity, last,
                         threads);
    }
  }
  if (skin.ends != nullptr) {
    for (const FreeEnds::ModesOfClass& own : skin.ends->modes(mirrored)) {
      ends.emplace_back(*skin.column, Face::end, skin.width, skin.length, own.along_y, own.parity,
                        last, threads);
    }
  }
}

} // namespace ionskin::finite_layers
