// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/elasticity/core_lattice.hpp"

#include <cmath>

namespace ionskin::mechanics {
namespace {

/// Weights of the three nodes of an interval at its two Gauss points.
using PointWeights = std::array<std::array<double, 3>, 2>;

/// Values and slopes of the quadratic shape functions of each interval of a line.
struct LineWeights {
  std::vector<PointWeights> value, slope;

  LineWeights(const std::vector<double>& line, std::size_t first, std::size_t count) {
    for (std::size_t e = first; e < first + count; ++e) {
      PointWeights& v = value.emplace_back();
      PointWeights& s = slope.emplace_back();
      const double length = line[e + 1] - line[e];
      for (std::size_t q = 0; q < 2; ++q) {
        const double t = 0.5 + (q == 0 ? -0.5 : 0.5) / std::sqrt(3.0);
        v[q] = {2 * t * t - 3 * t + 1, 4 * t - 4 * t * t, 2 * t * t - t};
        s[q] = {(4 * t - 3) / length, (4 - 8 * t) / length, (4 * t - 1) / length};
      }
    }
  }
};

/// From nodes to Gauss points along the middle index of a field [outer][2 intervals + 1][inner].
void to_points(const std::vector<PointWeights>& weights, std::size_t outer, std::size_t inner,
               const double* field, std::vector<double>& result) {
  result.resize(outer * 2 * weights.size() * inner);
  double* out = result.data();
  for (std::size_t o = 0; o < outer; ++o, field += (2 * weights.size() + 1) * inner) {
    const double* node = field;
    for (const PointWeights& interval : weights) {
      for (const std::array<double, 3>& w : interval) {
        for (std::size_t i = 0; i < inner; ++i) {
          out[i] = w[0] * node[i] + w[1] * node[i + inner] + w[2] * node[i + 2 * inner];
        }
        out += inner;
      }
      node += 2 * inner;
    }
  }
}

} // namespace

CoreLattice::CoreLattice(const ElasticSpace& space, const std::array<std::size_t, 2>& core_z) {
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t k = 2 * core_z[0]; k <= 2 * core_z[1]; ++k) {
      for (std::size_t j = 0; j <= 2 * space.elements()[1]; ++j) {
        for (std::size_t i = 0; i <= 2 * space.elements()[0]; ++i) {
          unknown_.push_back(space.unknown(space.node_at(i, j, k))[c]);
        }
      }
    }
  }
}

void CoreLattice::gather(const double* displacement, double* lattice) const {
  for (std::size_t i = 0; i < unknown_.size(); ++i) {
    lattice[i] = unknown_[i] < 0 ? 0.0 : displacement[unknown_[i]];
  }
}

std::size_t lattice_rows(const mesh::MeshLines& lines, const std::array<std::size_t, 2>& core_z) {
  return 3 * (2 * lines.x.size() - 1) * (2 * lines.y.size() - 1) *
         (2 * (core_z[1] - core_z[0]) + 1);
}

CoreStrain lattice_strain(const mesh::MeshLines& lines, const std::array<std::size_t, 2>& core_z,
                          const double* lattice) {
  const std::size_t nx = lines.x.size() - 1, ny = lines.y.size() - 1, nz = core_z[1] - core_z[0];
  const LineWeights x(lines.x, 0, nx), y(lines.y, 0, ny), z(lines.z, core_z[0], nz);
  const std::size_t columns = 2 * nx + 1, layer = columns * (2 * ny + 1);
  // gradient[c][r]: derivative of component c along axis r, at the Gauss points.
  std::array<std::array<std::vector<double>, 3>, 3> gradient;
  std::vector<double> along_z, along_yz;
  for (std::size_t c = 0; c < 3; ++c, lattice += layer * (2 * nz + 1)) {
    to_points(z.value, 1, layer, lattice, along_z);
    to_points(y.value, 2 * nz, columns, along_z.data(), along_yz);
    to_points(x.slope, 4 * nz * ny, 1, along_yz.data(), gradient[c][0]);
    to_points(y.slope, 2 * nz, columns, along_z.data(), along_yz);
    to_points(x.value, 4 * nz * ny, 1, along_yz.data(), gradient[c][1]);
    to_points(z.slope, 1, layer, lattice, along_z);
    to_points(y.value, 2 * nz, columns, along_z.data(), along_yz);
    to_points(x.value, 4 * nz * ny, 1, along_yz.data(), gradient[c][2]);
  }
  CoreStrain result;
  result.points = {2 * nx, 2 * ny, 2 * nz};
  for (std::size_t c = 0; c < 3; ++c) {
    result.component[c] = std::move(gradient[c][c]);
    // yz, xz, xy follow the three normal strains.
    const std::size_t a = (c + 1) % 3, b = (c + 2) % 3;
    std::vector<double>& shear = result.component[3 + c] = std::move(gradient[a][b]);
    for (std::size_t i = 0; i < shear.size(); ++i) {
      shear[i] = 0.5 * (shear[i] + gradient[b][a][i]);
    }
  }
  return result;
}

} // namespace ionskin::mechanics
