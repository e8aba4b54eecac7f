// SPDX-License-Identifier: Apache-2.0
#include "ionskin/mechanics/slider/slider_compliance.hpp"

#include "ionskin/mechanics/slider/elastic_pad.hpp"
#include "ionskin/mechanics/slider/half_space_patch.hpp"
#include "ionskin/mechanics/surface/traction_profile.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace ionskin::mechanics {
namespace {

using linear_algebra::DenseMatrix;

/// Parts of equal traction that a cell under a sharp edge is cut into.
constexpr int parts_of_sharp_cell = 3;
/// Cells this many of their sizes apart act on one another like points of force.
constexpr double far_apart = 3;
/// A pad thinner than this many cells is summed around the place where it gives, a thicker one as
/// the difference to a half-space, which is smooth over the cells.
constexpr double thin_pad = 0.5;
/// Ends of the rings around a place of a thin pad, by its thickness; beyond the last it rests.
constexpr std::array<double, 7> rings{0, 0.25, 0.75, 1.5, 3, 6, 12};
constexpr int directions = 48;

struct Point {
  double place = 0, weight = 0; ///< [m], share of the traction
};
struct Part {
  double from = 0, to = 0; ///< [m]
};

/// The cells of one direction.
struct Strip {
  double from = 0, to = 0;   ///< [m]
  std::vector<Part> parts;   ///< of the same force each
  std::vector<Point> points; ///< at which means over the cell are taken
  std::vector<Point> few;    ///< the same for what is smooth
  double size() const { return to - from; }
};

/// Three Gauss points, with their weights, in each of some equal parts of the unit interval.
std::vector<Point> gauss_points(int intervals) {
  using Rule = boost::math::quadrature::gauss<double, 3>;
  std::vector<Point> points;
  for (int i = 0; i < intervals; ++i) {
    for (std::size_t k = 0; k < Rule::abscissa().size(); ++k) {
      for (const double sign : {1.0, -1.0}) {
        const double at = Rule::abscissa()[k];
        if (at == 0 && sign < 0) {
          continue;
        }
        points.push_back(
            {(i + (1 + sign * at) / 2) / intervals, Rule::weights()[k] / 2 / intervals});
      }
    }
  }
  return points;
}

/// Density of the distances from places of one strip to places of another, both weighted with their
/// traction [1/m].
double distance_density(const Strip& at, const Strip& from, double distance) {
  double sum = 0;
  for (const Part& a : at.parts) {
    for (const Part& b : from.parts) {
      const double overlap = std::min(a.to, b.to + distance) - std::max(a.from, b.from + distance);
      sum += std::max(0.0, overlap) / ((a.to - a.from) * (b.to - b.from));
    }
  }
  return sum / static_cast<double>(at.parts.size() * from.parts.size());
}

std::vector<Strip> strips(const std::vector<double>& lines, const TractionProfile& profile) {
  std::vector<Strip> result;
  for (std::size_t i = 0; i + 1 < lines.size(); ++i) {
    Strip strip{lines[i], lines[i + 1], {}, {}, {}};
    const auto place = [&](double share) {
      return profile.place_of_share(strip.from, strip.to, share);
    };
    const int parts = profile.even() ? 1 : parts_of_sharp_cell;
    for (int part = 0; part < parts; ++part) {
      strip.parts.push_back(
          {place(static_cast<double>(part) / parts), place(static_cast<double>(part + 1) / parts)});
    }
    for (const Point& point : gauss_points(profile.even() ? 1 : 2)) {
      strip.points.push_back({place(point.place), point.weight});
    }
    for (const Point& point : gauss_points(1)) {
      strip.few.push_back({place(point.place), point.weight});
    }
    result.push_back(std::move(strip));
  }
  return result;
}

/// What a unit force on one cell does to another, times 2 pi G; by components normal, x, y.
using Influence = std::array<std::array<double, 3>, 3>;

class SoftBody {
public:
  SoftBody(double poissons_ratio, double pad_thickness)
      : poissons_ratio_(poissons_ratio), thickness_(pad_thickness) {
    if (pad_thickness > 0) {
      pad_.emplace(poissons_ratio);
    }
  }

  /// Of the cell (x_from, y_from) on the cell (x_at, y_at).
  Influence influence(const Strip& x_at, const Strip& y_at, const Strip& x_from,
                      const Strip& y_from) const {
    Influence result{};
    const double size = std::max({x_at.size(), y_at.size(), x_from.size(), y_from.size()});
    const double distance = std::hypot((x_at.from + x_at.to - x_from.from - x_from.to) / 2,
                                       (y_at.from + y_at.to - y_from.from - y_from.to) / 2);
    if (pad_ && thickness_ < thin_pad * size) {
      add_thin_pad(x_at, y_at, x_from, y_from, result);
      return result;
    }
    if (distance > far_apart * size) {
      over_points(x_at, y_at, x_from, y_from, [&](double u, double v, double weight) {
        add_half_space(point_integrals(u, v), weight, result);
      });
    } else {
      add_near(x_at, y_at, x_from, y_from, result);
    }
    if (pad_) {
      over_points(x_at, y_at, x_from, y_from,
                  [&](double u, double v, double weight) { subtract_pad(u, v, weight, result); });
    }
    return result;
  }

private:
  template <class Add>
  static void over_points(const Strip& x_at, const Strip& y_at, const Strip& x_from,
                          const Strip& y_from, const Add& add) {
    for (const Point& ya : y_at.few) {
      for (const Point& xa : x_at.few) {
        for (const Point& yf : y_from.few) {
          for (const Point& xf : x_from.few) {
            add(xa.place - xf.place, ya.place - yf.place,
                xa.weight * ya.weight * xf.weight * yf.weight);
          }
        }
      }
    }
  }

  /// Of a point force: per area instead of over it.
  static PatchIntegrals point_integrals(double u, double v) {
    const double square = u * u + v * v, r = std::sqrt(square), cube = square * r;
    return {1 / r, u * u / cube, v * v / cube, u * v / cube, u / square, v / square};
  }

  void add_near(const Strip& x_at, const Strip& y_at, const Strip& x_from, const Strip& y_from,
                Influence& result) const {
    const double share = 1.0 / static_cast<double>(x_from.parts.size() * y_from.parts.size());
    for (const Point& ya : y_at.points) {
      for (const Point& xa : x_at.points) {
        for (const Part& yf : y_from.parts) {
          for (const Part& xf : x_from.parts) {
            const double area = (xf.to - xf.from) * (yf.to - yf.from);
            add_half_space(patch_integrals(xa.place - xf.to, xa.place - xf.from, ya.place - yf.to,
                                           ya.place - yf.from),
                           xa.weight * ya.weight * share / area, result);
          }
        }
      }
    }
  }

  /// Boussinesq's and Cerruti's solutions (Johnson, Contact Mechanics, 1985, sections 3.2 and 3.6).
  /// The slider is above: what moves its face towards the load moves it away from the skin, so that
  /// normal and tangential parts are mixed with the opposite sign of those of a skin below.
  void add_half_space(const PatchIntegrals& integral, double weight, Influence& sum) const {
    const double nu = poissons_ratio_;
    sum[0][0] += weight * (1 - nu) * integral.inverse;
    sum[1][1] += weight * ((1 - nu) * integral.inverse + nu * integral.xx);
    sum[2][2] += weight * ((1 - nu) * integral.inverse + nu * integral.yy);
    sum[1][2] += weight * nu * integral.xy;
    sum[2][1] += weight * nu * integral.xy;
    mix((1 - 2 * nu) / 2 * integral.x, (1 - 2 * nu) / 2 * integral.y, weight, sum);
  }

  /// Sum over rings around the place where the force acts: its 1/r is lost in their circumference.
  void add_thin_pad(const Strip& x_at, const Strip& y_at, const Strip& x_from, const Strip& y_from,
                    Influence& sum) const {
    for (std::size_t ring = 0; ring + 1 < rings.size(); ++ring) {
      for (const Point& point : gauss_points(1)) {
        const double width = (rings[ring + 1] - rings[ring]) * thickness_;
        const double r = rings[ring] * thickness_ + point.place * width;
        const double arc = 2 * std::numbers::pi * r / directions;
        for (int direction = 0; direction < directions; ++direction) {
          const double angle = 2 * std::numbers::pi * (direction + 0.5) / directions;
          const double u = r * std::cos(angle), v = r * std::sin(angle);
          const double weight = point.weight * width * arc * distance_density(x_at, x_from, u) *
                                distance_density(y_at, y_from, v);
          if (weight > 0) {
            add_half_space(point_integrals(u, v), weight, sum);
            subtract_pad(u, v, weight, sum);
          }
        }
      }
    }
  }

  void subtract_pad(double u, double v, double weight, Influence& sum) const {
    const double square = u * u + v * v, r = std::sqrt(square);
    const PadStiffening::Values stiffer = pad_->at(r / thickness_);
    const double factor = -weight / thickness_;
    const double cos_twice = r > 0 ? (u * u - v * v) / square : 0,
                 sin_twice = r > 0 ? 2 * u * v / square : 0;
    sum[0][0] += factor * stiffer.normal;
    sum[1][1] += factor * (stiffer.isotropic + stiffer.deviatoric * cos_twice);
    sum[2][2] += factor * (stiffer.isotropic - stiffer.deviatoric * cos_twice);
    sum[1][2] += factor * stiffer.deviatoric * sin_twice;
    sum[2][1] += factor * stiffer.deviatoric * sin_twice;
    if (r > 0) {
      mix(stiffer.radial * u / r, stiffer.radial * v / r, factor, sum);
    }
  }

  static void mix(double x, double y, double weight, Influence& sum) {
    sum[1][0] += weight * x;
    sum[0][1] -= weight * x;
    sum[2][0] += weight * y;
    sum[0][2] -= weight * y;
  }

  double poissons_ratio_, thickness_;
  std::optional<PadStiffening> pad_;
};

Strip mirrored(const Strip& strip) {
  Strip result = strip;
  result.from = -strip.to;
  result.to = -strip.from;
  for (Part& part : result.parts) {
    part = {-part.to, -part.from};
  }
  for (auto* points : {&result.points, &result.few}) {
    for (Point& point : *points) {
      point.place = -point.place;
    }
  }
  return result;
}

} // namespace

DenseMatrix slider_compliance(const Slider& slider, const mesh::SkinMesh& mesh,
                              const ContactCells& cells) {
  if (slider.rigid()) {
    return {};
  }
  const double shear_modulus = slider.youngs_modulus / (2 * (1 + slider.poissons_ratio));
  const SoftBody body(slider.poissons_ratio, slider.pad_thickness);
  const std::vector<Strip> x = strips(cells.lines_x, TractionProfile(mesh, 0)),
                           y = strips(cells.lines_y, TractionProfile(mesh, 1));
  const int count = static_cast<int>(cells.count()), columns = static_cast<int>(cells.columns());
  DenseMatrix result(3 * count, 3 * count);
  for (int from = 0; from < count; ++from) {
    const Strip &x_from = x[from % columns], &y_from = y[from / columns];
    const std::optional<Strip> image =
        mesh.half_model() ? std::optional(mirrored(y_from)) : std::nullopt;
    for (int at = from; at < count; ++at) {
      const Strip &x_at = x[at % columns], &y_at = y[at / columns];
      Influence influence = body.influence(x_at, y_at, x_from, y_from);
      if (image) {
        const Influence other = body.influence(x_at, y_at, x_from, *image);
        for (int c = 0; c < 3; ++c) {
          influence[c][0] += other[c][0];
          influence[c][1] += other[c][1];
          influence[c][2] -= other[c][2];
        }
      }
      for (int c = 0; c < 3; ++c) {
        for (int d = 0; d < 3; ++d) {
          const double value = influence[c][d] / (2 * std::numbers::pi * shear_modulus);
          result(3 * at + c, 3 * from + d) = value;
          result(3 * from + d, 3 * at + c) = value;
        }
      }
    }
  }
  return result;
}

} // namespace ionskin::mechanics
