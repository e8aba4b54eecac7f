// SPDX-License-Identifier: Apache-2.0
#include "ionskin/finite_layers/plane/box_modes.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>

namespace ionskin::finite_layers {
ModeLine ModeLine::up_to(double extent, double last) {
  const auto count = static_cast<Eigen::Index>(last * extent / std::numbers::pi) + 1;
  ModeLine line;
  line.extent = extent;
  line.wave_numbers = Eigen::ArrayXd::LinSpaced(
      count, 0, static_cast<double>(count - 1) * std::numbers::pi / extent);
  line.weights = Eigen::ArrayXd::Constant(count, 2 / extent);
  line.weights(0) = 1 / extent;
  return line;
}

ModeTransform ModeLine::transform(const std::vector<double>& lines, double centre) const {
  const auto cells = static_cast<Eigen::Index>(lines.size()) - 1;
  ModeTransform result{Eigen::ArrayXXd(cells, wave_numbers.size()),
                       Eigen::ArrayXXd(cells, wave_numbers.size())};
  for (Eigen::Index i = 0; i < cells; ++i) {
    const double from = lines[static_cast<std::size_t>(i)],
                 to = lines[static_cast<std::size_t>(i) + 1];
    const Eigen::ArrayXd phase = wave_numbers * (centre + 0.5 * (from + to));
    const Eigen::ArrayXd half = wave_numbers * (0.5 * (to - from));
    const Eigen::ArrayXd mean = (half > 0).select(half.sin() / half, 1.0);
    result.cosine.row(i) = (mean * phase.cos()).transpose();
    result.sine.row(i) = (mean * phase.sin()).transpose();
  }
  return result;
}

BoxModes::BoxModes(const SurfaceCompliance& surface, double length, double width,
                   const WaveSplit& split)
    : x_(ModeLine::up_to(length, split.last_long())), y_(ModeLine::up_to(width, split.last_long())),
      between_{{{0, 0, {}}, {0, 1, {}}, {0, 2, {}}, {1, 1, {}}, {1, 2, {}}, {2, 2, {}}}} {
  for (Between& one : between_) {
    one.waves.resize(x_.wave_numbers.size(), y_.wave_numbers.size());
  }
  for (Eigen::Index n = 0; n < y_.wave_numbers.size(); ++n) {
    for (Eigen::Index m = 0; m < x_.wave_numbers.size(); ++m) {
      const double kx = x_.wave_numbers(m), ky = y_.wave_numbers(n), k = std::hypot(kx, ky);
      const WaveCompliance at = surface.at(k);
      const double c = k > 0 ? kx / k : 1.0, s = k > 0 ? ky / k : 0.0;
      const double weight = y_.weights(n) * split.long_share(k);
      const std::array<double, 6> waves{at.normal,
                                        -c * at.mixed,
                                        -s * at.mixed,
                                        c * c * at.along + s * s * at.across,
                                        c * s * (at.along - at.across),
                                        s * s * at.along + c * c * at.across};
      for (std::size_t i = 0; i < waves.size(); ++i) {
        between_[i].waves(m, n) = weight * waves[i];
      }
    }
  }
}

std::vector<Eigen::MatrixXd> BoxModes::rows(const ContactGrid& grid, double centre_y) const {
  return summed(grid, centre_y, std::nullopt,
                Eigen::ArrayXXd::Ones(x_.wave_numbers.size(), y_.wave_numbers.size()));
}

std::vector<Eigen::MatrixXd> BoxModes::rows(const ContactGrid& grid, double centre_y, ModePart part,
                                            const Eigen::ArrayXXd& share) const {
  return summed(grid, centre_y, part, share);
}

/// Sums the modes along y: all of a product of two waves, or the part that is half the wave of the
/// difference of their arguments or half the wave of the sum.
std::vector<Eigen::MatrixXd> BoxModes::summed(const ContactGrid& grid, double centre_y,
                                              std::optional<ModePart> part,
                                              const Eigen::ArrayXXd& share) const {
  const Eigen::Index count = grid.rows();
  const ModeTransform transform =
      ModeLine{y_.extent, y_.wave_numbers.head(share.cols()), {}}.transform(grid.y, centre_y);
  // A symmetric load has no odd modes.
  const auto occur = Eigen::seq(0, share.cols() - 1, grid.half ? 2 : 1);
  const double images = grid.half ? 2 : 1;
  const auto along = [&](bool sine) -> Eigen::MatrixXd { // [row, mode]
    return (sine ? transform.sine : transform.cosine)(Eigen::all, occur);
  };
  std::vector<Eigen::MatrixXd> result(static_cast<std::size_t>(share.rows()),
                                      Eigen::MatrixXd(3 * count, 3 * count));
  for (const Between& one : between_) {
    const bool at_sine = one.at == 2, from_sine = one.from == 2;
    const double sign = (at_sine == from_sine) == (part == ModePart::alike) ? 1 : -1;
    const Eigen::MatrixXd at = along(at_sine), from = along(from_sine), beside_at = along(!at_sine),
                          beside_from = along(!from_sine);
    Eigen::MatrixXd pairs(at.cols(), count * count); // [mode, row at and from]
    for (Eigen::Index j = 0; j < count; ++j) {
      const auto of_row = [j](const Eigen::MatrixXd& all,
                              const Eigen::MatrixXd& row) -> Eigen::MatrixXd {
        return (all.array().rowwise() * row.row(j).array()).matrix().transpose();
      };
      auto of_pairs = pairs.middleCols(count * j, count);
      of_pairs = images * of_row(at, from);
      if (part) {
        of_pairs = 0.5 * (of_pairs + sign * of_row(beside_at, beside_from));
      }
    }
    const Eigen::MatrixXd waves =
        one.waves.topLeftCorner(share.rows(), share.cols()).cwiseProduct(share.matrix());
    const Eigen::MatrixXd occurring = waves(Eigen::all, occur), of_modes = occurring * pairs;
    for (std::size_t m = 0; m < result.size(); ++m) {
      const auto block = of_modes.row(static_cast<Eigen::Index>(m)).reshaped(count, count);
      result[m](Eigen::seqN(one.at, count, 3), Eigen::seqN(one.from, count, 3)) = block;
      if (one.at != one.from) {
        result[m](Eigen::seqN(one.from, count, 3), Eigen::seqN(one.at, count, 3)) =
            block.transpose();
      }
    }
  }
  return result;
}

void add_modes(const std::vector<Eigen::MatrixXd>& rows, const ModeLine& along_x, ModePart part,
               const Eigen::ArrayXd& share, const ContactGrid& grid, double centre_x,
               Eigen::MatrixXd& compliance) {
  const Eigen::Index nx = grid.columns(), ny = grid.rows(), modes = share.size();
  const ModeLine summed{along_x.extent, along_x.wave_numbers.head(modes), {}};
  const ModeTransform transform = summed.transform(grid.x, centre_x);
  Eigen::MatrixXd pairs(nx * nx, modes), of_rows(modes, ny * ny);
  for (Eigen::Index a = 0; a < 3; ++a) {
    for (Eigen::Index b = a; b < 3; ++b) {
      // A product of two waves is half the wave of the difference of their arguments and half the
      // wave of the sum.
      const double sign = ((a == 1) == (b == 1)) == (part == ModePart::alike) ? 1 : -1;
      const auto own = [&](Eigen::Index c) -> const Eigen::ArrayXXd& {
        return c == 1 ? transform.sine : transform.cosine;
      };
      const auto other = [&](Eigen::Index c) -> const Eigen::ArrayXXd& {
        return c == 1 ? transform.cosine : transform.sine;
      };
      for (Eigen::Index m = 0; m < modes; ++m) {
        const double weight = 0.5 * along_x.weights(m) * share(m);
        for (Eigen::Index from = 0; from < nx; ++from) {
          pairs.col(m).segment(nx * from, nx) =
              weight *
              (own(b)(from, m) * own(a).col(m) + sign * other(b)(from, m) * other(a).col(m));
        }
        of_rows.row(m) =
            rows[static_cast<std::size_t>(m)](Eigen::seqN(a, ny, 3), Eigen::seqN(b, ny, 3))
                .reshaped()
                .transpose();
      }
      const Eigen::MatrixXd product = pairs * of_rows; // [column at, from; row at, from]
      for (Eigen::Index jf = 0; jf < ny; ++jf) {
        for (Eigen::Index ja = 0; ja < ny; ++ja) {
          const auto block = product.col(ja + ny * jf).reshaped(nx, nx);
          const auto at = Eigen::seqN(3 * nx * ja + a, nx, 3),
                     from = Eigen::seqN(3 * nx * jf + b, nx, 3);
          compliance(at, from) += block;
          if (a != b) {
            compliance(from, at) += block.transpose();
          }
        }
      }
    }
  }
}

} // namespace ionskin::finite_layers
