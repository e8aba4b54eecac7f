// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/fields/wave_block.hpp"

namespace ionskin::finite_layers {

void WaveBlock::set_strains(const BlockColumn& normal, const BlockColumn& x, const BlockColumn& y,
                            Strains& strains, Eigen::Index column) const {
  // Tractions along the wave, upwards and across it [Pa].
  const BlockColumn along = weight * (cosine * x + sine * y), upwards = -weight * normal,
                    across = weight * (cosine * y - sine * x);
  const BlockColumn stretch = depth.col(0) * along + depth.col(1) * upwards,
                    twist = depth.col(6) * across;
  const BlockColumn shear = depth.col(4) * along + depth.col(5) * upwards,
                    shear_across = depth.col(7) * across;
  const BlockColumn by_x = cosine * stretch - sine * twist, by_y = sine * stretch + cosine * twist;
  strains[0].col(column) = cosine * by_x;
  strains[1].col(column) = sine * by_y;
  strains[2].col(column) = depth.col(2) * along + depth.col(3) * upwards;
  strains[3].col(column) = 0.5 * (sine * shear + cosine * shear_across);
  strains[4].col(column) = 0.5 * (cosine * shear - sine * shear_across);
  strains[5].col(column) = -0.5 * (sine * by_x + cosine * by_y);
}

} // namespace ionskin::finite_layers
