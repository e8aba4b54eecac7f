// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/fields/face_fields.hpp"

#include "ionskin/finite_layers/fields/field_faces.hpp"
#include "ionskin/finite_layers/fields/mode_means.hpp"

#include <numbers>

namespace ionskin::finite_layers {
namespace {

using AllPlaces = std::vector<const std::vector<Interval>*>;

/// Places of all states along one direction.
AllPlaces along(std::vector<Interval> FieldPlaces::*direction,
                const std::vector<FieldPlaces>& places) {
  AllPlaces result;
  for (const FieldPlaces& of_state : places) {
    result.push_back(&(of_state.*direction));
  }
  return result;
}

} // namespace

FaceFields::FaceFields(const FieldSkin& skin, const std::vector<DepthLevel>& levels,
                       const ComponentChoice& components, std::size_t most)
    : components_(components), levels_(static_cast<Eigen::Index>(levels.size())),
      length_(skin.length), width_(skin.width) {
  for (const FaceModes& modes : skin.faces->sides) {
    sides_.emplace_back(*skin.column, modes, levels, components, most);
  }
  for (const FaceModes& modes : skin.faces->ends) {
    ends_.emplace_back(*skin.column, modes, levels, components, most);
  }
}

void FaceFields::add(const std::vector<FaceMotion>& motions, const std::vector<FieldPlaces>& places,
                     std::vector<ByKind>& sums) const {
  for (std::size_t side = 0; side < sides_.size(); ++side) {
    add_side(side, motions, places, sums);
  }
  for (std::size_t end = 0; end < ends_.size(); ++end) {
    add_end(end, motions, places, sums);
  }
}

void FaceFields::add_side(std::size_t side, const std::vector<FaceMotion>& motions,
                          const std::vector<FieldPlaces>& places, std::vector<ByKind>& sums) const {
  std::vector<const Eigen::MatrixXd*> nodes;
  for (const FaceMotion& motion : motions) {
    nodes.push_back(&motion.sides[side]);
  }
  const Eigen::Index modes = sides_[side].modes();
  const std::vector<Strains> strains = sides_[side].at(nodes, along(&FieldPlaces::y, places));
  for (std::size_t state = 0; state < motions.size(); ++state) {
    const ModeTransform along_x = mode_means(places[state].x, std::numbers::pi / length_, modes);
    const auto of_y = static_cast<Eigen::Index>(places[state].y.size());
    for (const std::size_t kind : {0, 1}) {
      // [mode, place along y + count of these * (component + count of these * level)]
      Eigen::MatrixXd of_modes(modes, of_y * components_.count(kind) * levels_);
      Eigen::Index first = 0;
      for (Eigen::Index level = 0; level < levels_; ++level) {
        for (const std::size_t c : components_.of_kind(kind)) {
          for (Eigen::Index mode = 0; mode < modes; ++mode) {
            of_modes.row(mode).segment(first, of_y) =
                strains[state][c].col(level + levels_ * mode).transpose();
          }
          first += of_y;
        }
      }
      sums[state][kind].noalias() +=
          (kind == 1 ? along_x.sine : along_x.cosine).matrix() * of_modes;
    }
  }
}

void FaceFields::add_end(std::size_t end, const std::vector<FaceMotion>& motions,
                         const std::vector<FieldPlaces>& places, std::vector<ByKind>& sums) const {
  std::vector<const Eigen::MatrixXd*> nodes;
  for (const FaceMotion& motion : motions) {
    nodes.push_back(&motion.ends[end].nodes);
  }
  const Eigen::Index modes = ends_[end].modes();
  const std::vector<Strains> strains = ends_[end].at(nodes, along(&FieldPlaces::x, places));
  for (std::size_t state = 0; state < motions.size(); ++state) {
    const std::vector<Eigen::Index> modes_y(motions[state].ends[end].modes_y.begin(),
                                            motions[state].ends[end].modes_y.begin() +
                                                static_cast<std::ptrdiff_t>(modes));
    const ModeTransform all =
        mode_means(places[state].y, std::numbers::pi / width_, modes_y.back() + 1);
    const Eigen::MatrixXd cosine = all.cosine(Eigen::all, modes_y),
                          sine = all.sine(Eigen::all, modes_y);
    for (const std::size_t kind : {0, 1}) {
      Eigen::Index first = 0;
      for (Eigen::Index level = 0; level < levels_; ++level) {
        for (const std::size_t c : components_.of_kind(kind)) {
          const Eigen::MatrixXd of_level =
              strains[state][c](Eigen::all, Eigen::seqN(level, modes, levels_));
          sums[state][kind].middleCols(first, cosine.rows()).noalias() +=
              of_level * (sine_along_y[c] ? sine : cosine).transpose();
          first += cosine.rows();
        }
      }
    }
  }
}

} // namespace ionskin::finite_layers
