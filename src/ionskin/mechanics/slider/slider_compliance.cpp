// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/slider/slider_compliance.hpp"

#include "ionskin/finite_layers/plane/radial_compliance.hpp"
#include "ionskin/finite_layers/thickness/surface_compliance.hpp"

#include <algorithm>

namespace ionskin::mechanics {
namespace {

namespace fl = finite_layers;

/// Distance from a force beyond which a pad does not move, over its thickness [1].
constexpr double reach_of_pad = 12;
/// Largest Poisson's ratio that is used [1], because the stiffness against a change of volume has
/// no bound at 0.5. With this value it is a million times the stiffness against shear, and
/// displacements are those of 0.5 to about 1e-6.
constexpr double nearly_incompressible = 0.5 - 2.5e-7;

} // namespace

SliderFace slider_face(const Slider& slider) {
  const Material material{"", slider.youngs_modulus,
                          std::min(slider.poissons_ratio, nearly_incompressible)};
  const fl::ElasticLayer layer = fl::elastic_layer(material, slider.pad_thickness);
  if (slider.pad_thickness == 0) {
    const fl::WaveCompliance all = fl::half_space_compliance(layer);
    return {
        fl::PlaneCompliance(layer), [all](double k) {
          return fl::WaveCompliance{all.normal / k, all.along / k, all.across / k, all.mixed / k};
        }};
  }
  const fl::SurfaceCompliance pad({layer});
  return {fl::PlaneCompliance(pad, fl::WaveSplit::all_short(reach_of_pad * slider.pad_thickness)),
          [pad](double k) { return pad.at(k); }};
}

Eigen::MatrixXd slider_compliance(const Slider& slider, const fl::ContactGrid& grid) {
  if (slider.rigid()) {
    return {};
  }
  Eigen::MatrixXd face =
      fl::plane_compliance(slider_face(slider).compliance, grid, fl::own_images(grid));
  face(Eigen::seq(0, Eigen::last, 3), Eigen::all) *= mixed_of_slider;
  face(Eigen::all, Eigen::seq(0, Eigen::last, 3)) *= mixed_of_slider;
  return face;
}

} // namespace ionskin::mechanics
