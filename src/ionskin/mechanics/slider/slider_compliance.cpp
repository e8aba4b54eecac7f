// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/slider/slider_compliance.hpp"

#include "ionskin/finite_layers/plane/radial_compliance.hpp"
#include "ionskin/finite_layers/thickness/surface_compliance.hpp"

#include <algorithm>

namespace ionskin::mechanics {
namespace {

namespace fl = finite_layers;

constexpr double reach_of_pad = 12; // over its thickness: beyond it rests
/// Stiffness against a change of volume has no bound at Poisson's ratio 0.5. With this one it is a
/// million times that against shear, and displacements are those of 0.5 to some 1e-6.
constexpr double nearly_incompressible = 0.5 - 2.5e-7;

Eigen::MatrixXd face_compliance(const Slider& slider, const fl::ContactGrid& grid) {
  const Material material{"", slider.youngs_modulus,
                          std::min(slider.poissons_ratio, nearly_incompressible)};
  const fl::ElasticLayer layer = fl::elastic_layer(material, slider.pad_thickness);
  if (slider.pad_thickness == 0) {
    return fl::plane_compliance(fl::PlaneCompliance(layer), grid, fl::own_images(grid));
  }
  const fl::SurfaceCompliance pad({layer});
  const fl::PlaneCompliance all_waves(
      pad, fl::WaveSplit::all_short(reach_of_pad * slider.pad_thickness));
  return fl::plane_compliance(all_waves, grid, fl::own_images(grid));
}

} // namespace

Eigen::MatrixXd slider_compliance(const Slider& slider, const fl::ContactGrid& grid) {
  if (slider.rigid()) {
    return {};
  }
  Eigen::MatrixXd face = face_compliance(slider, grid);
  // The slider is above: what moves its face towards the load moves it away from the skin, so that
  // normal and tangential parts are mixed with the opposite sign of those of a skin below.
  face(Eigen::seq(0, Eigen::last, 3), Eigen::all) *= -1;
  face(Eigen::all, Eigen::seq(0, Eigen::last, 3)) *= -1;
  return face;
}

} // namespace ionskin::mechanics
