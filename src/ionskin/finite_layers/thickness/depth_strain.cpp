// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/thickness/depth_strain.hpp"

#include "ionskin/finite_layers/thickness/layer_stiffness.hpp"

#include <Eigen/LU>

namespace ionskin::finite_layers {
namespace {

/// Displacement of a face per traction on the top face: along the wave and upwards, [displacement
/// component, traction component], and across the wave [m/Pa].
struct FaceResponse {
  Eigen::Matrix2d plane = Eigen::Matrix2d::Zero();
  double across = 0;
};

/// Calculates the responses of all faces, from the base to the top.
std::vector<FaceResponse> face_responses(const std::vector<ElasticLayer>& layers, double k) {
  const std::size_t count = layers.size();
  // `follows` holds the displacement of each layer's bottom over that of its top [1].
  std::vector<FaceResponse> follows(count), faces(count + 1);
  Eigen::Matrix2d below = Eigen::Matrix2d::Zero();
  double below_across = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Matrix4d own = plane_strain_stiffness(layers[i], k);
    const AntiplaneStiffness across = antiplane_stiffness(layers[i], k);
    if (i > 0) { // the bottom of the first layer does not move
      const Eigen::Matrix2d joint = own.topLeftCorner<2, 2>() + below;
      follows[i].plane = -joint.inverse() * own.topRightCorner<2, 2>();
      follows[i].across = -across.other / (across.own + below_across);
    }
    below = own.bottomRightCorner<2, 2>() + own.bottomLeftCorner<2, 2>() * follows[i].plane;
    below_across = across.own + across.other * follows[i].across;
  }
  faces[count] = {below.inverse(), 1 / below_across};
  for (std::size_t i = count; i > 0; --i) {
    faces[i - 1] = {follows[i - 1].plane * faces[i].plane, follows[i - 1].across * faces[i].across};
  }
  return faces;
}

} // namespace

std::vector<DepthStrain> depth_strain(const std::vector<ElasticLayer>& layers, double wave_number,
                                      const std::vector<DepthLevel>& levels) {
  const std::vector<FaceResponse> faces = face_responses(layers, wave_number);
  std::vector<DepthStrain> result;
  for (const DepthLevel& level : levels) {
    const ElasticLayer& layer = layers[level.layer];
    const FaceResponse &bottom = faces[level.layer], &top = faces[level.layer + 1];
    Eigen::Matrix<double, 4, 2> at_faces;
    at_faces << bottom.plane, top.plane;
    const Eigen::Matrix<double, 4, 2> inside =
        plane_strain_field(layer, wave_number, level.height) * at_faces;
    const Eigen::Vector2d across = antiplane_field(layer, wave_number, level.height) *
                                   Eigen::Vector2d(bottom.across, top.across);
    const Eigen::RowVector2d shear = inside.row(1) - wave_number * inside.row(2);
    result.push_back({wave_number * inside(0, 0), wave_number * inside(0, 1), inside(3, 0),
                      inside(3, 1), shear(0), shear(1), wave_number * across(0), across(1)});
  }
  return result;
}

} // namespace ionskin::finite_layers
