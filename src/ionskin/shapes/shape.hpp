// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/laws/law_parameter.hpp"
#include "ionskin/shapes/height_map.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ionskin::shapes {

/// Height that stands for places beyond the body, where nothing touches [m].
inline constexpr double unreachable_gap = 1.0;

/// Plan of any slider, whatever its shape.
struct Plan {
  std::array<double, 2> size{}; ///< of the underside along x and y [m]
  const HeightMap& heights;     ///< empty for shapes without one
};

/// Angles of a slider: it is tilted by roll and pitch about its own axes x and y, and turned with
/// them by yaw about z, docs/model.md (77) [rad].
struct Pose {
  double roll = 0, pitch = 0, yaw = 0;

  bool tilted() const { return roll != 0 || pitch != 0; }
  bool operator==(const Pose&) const = default;
};

/// Angles that change over time.
struct ChangingAngles {
  bool roll = false, pitch = false, yaw = false;

  bool any() const { return roll || pitch || yaw; }
};

/// Load that presses a slider into the skin at worst; one of the first two may be 0.
struct Pressing {
  double indentation = 0;   ///< [m]
  double force = 0;         ///< [N]
  double plane_modulus = 0; ///< E / (1 - nu^2) of the softest layer [Pa]
  double length = 0;        ///< of the contact along y [m]
};

/// Values of a case that do not go together.
struct Misfit {
  std::string message;
  std::vector<std::string> keys; ///< of the section `slider`: "radius"
  std::string remedy;
};

/// The underside of a slider with the values of its parameters. Places are counted from the
/// slider's centre [m].
class Shape {
public:
  // Traits of the shape's row; a shape that differs hides them.
  static constexpr bool takes_heights = false;
  static constexpr bool has_whole_plan = false;

  virtual ~Shape() = default;

  /// Height of the underside at a place within the plan [m], at most `unreachable_gap` above
  /// `lowest`.
  virtual double height(const Plan& plan, double x, double y) const = 0;
  /// Least height within the plan [m].
  virtual double lowest(const Plan&) const { return 0; }
  /// Least height within the plan of the shape on a slope along x and y, `height + slope . (x, y)`
  /// [m].
  virtual double lowest_on_slope(const Plan& plan, const std::array<double, 2>& slope) const;
  /// True if all of the plan touches at once, up to sharp edges.
  virtual bool sharp() const { return false; }
  /// Half sizes of the part that touches at once; 0 along a round direction [m]. Along a direction
  /// in which it is half the plan the slider ends at a sharp edge.
  virtual std::array<double, 2> flat_half_size(const Plan&) const { return {0, 0}; }
  /// True, along x and along y, where the underside is its own mirror image under x -> -x and under
  /// y -> -y.
  virtual std::array<bool, 2> symmetric(const Plan&) const { return {true, true}; }
  /// An upper bound of how far the contact reaches along a direction beyond the part that touches
  /// at once [m]; infinity for all of the plan.
  virtual double border(const Plan& plan, const Pressing& pressing,
                        std::size_t direction) const = 0;
  /// True if it looks the same from all sides, all of its plan.
  virtual bool turns_into_itself(const Plan&) const { return false; }
  /// Plan of the whole body [m], for cases that give none; of rows that `have_whole_plan`.
  virtual std::optional<std::array<double, 2>> whole_plan() const { return {}; }
  /// Parameters that do not go together with one another or with the plan.
  virtual std::vector<Misfit> misfits(const Plan&) const { return {}; }
};

/// One row of the table of shapes.
struct ShapeRow {
  std::string_view name;                          ///< value of `slider.shape`
  std::string_view meaning;                       ///< "a cylinder with its axis along y"
  bool takes_heights;                             ///< from the file `slider.profile`
  bool has_whole_plan;                            ///< true if a case need not give `slider.size`
  std::span<const laws::LawParameter> parameters; ///< keys `slider.NAME`
  std::unique_ptr<const Shape> (*with)(const laws::LawValues& values);
};

/// All shapes; the first is the default of a case.
std::span<const ShapeRow> shapes();

/// The row of a name that the schema has checked. Throws InternalError for any other.
const ShapeRow& shape_row(std::string_view name);

/// The shape of a name that the schema has checked. A parameter without a value is 0: cases without
/// contact need not give any.
std::unique_ptr<const Shape> shape(std::string_view name, const laws::LawValues& values);

} // namespace ionskin::shapes
