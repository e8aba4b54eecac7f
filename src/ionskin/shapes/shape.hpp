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

/// Height that marks positions beyond the body, where nothing can touch the skin [m].
inline constexpr double unreachable_gap = 1.0;

/// Plan of a slider: the rectangle that its underside covers, centred on the slider. It refers to
/// the height map of the slider, which must outlive it.
struct Plan {
  std::array<double, 2> size{}; ///< of the rectangle along x and y [m]
  const HeightMap& heights;     ///< height map; empty for shapes that take none
};

/// Angles of a slider [rad]: tilts by roll and pitch about its own axes x and y, then a turn by yaw
/// about z, docs/model.md (77).
struct Pose {
  double roll = 0, pitch = 0, yaw = 0;

  /// True if roll or pitch differ from 0.
  bool tilted() const { return roll != 0 || pitch != 0; }
  bool operator==(const Pose&) const = default;
};

/// Set of the angles of a slider that change along its path: true for each of them.
struct ChangingAngles {
  bool roll = false, pitch = false, yaw = false;

  /// True if any angle changes.
  bool any() const { return roll || pitch || yaw; }
};

/// Heaviest load of a slider along its path, from which `Shape::border` bounds the contact.
struct Pressing {
  double indentation = 0;   ///< largest indentation [m]; 0 if only forces are given
  double force = 0;         ///< largest normal force [N]; 0 if only heights are given
  double plane_modulus = 0; ///< plane-strain modulus of skin and slider together [Pa]
  double length = 0;        ///< length of a line contact along y [m]
};

/// A conflict between parameters of a slider, for an error message.
struct Misfit {
  std::string message;           ///< the conflict, with the actual values
  std::vector<std::string> keys; ///< keys of the section `slider` in conflict: "radius"
  std::string remedy;            ///< advice to the user
};

/// The underside of a slider, with the values of its parameters. Positions are measured from the
/// slider's centre [m], heights upwards [m]. In arrays and as `direction`, 0 is x and 1 is y.
class Shape {
public:
  // Traits of the shape's row; a shape with other values hides them by members of its own.
  static constexpr bool takes_heights = false;
  static constexpr bool has_whole_plan = false;

  virtual ~Shape() = default;

  /// Height of the underside at a position within the plan [m], at most `unreachable_gap` above
  /// `lowest`.
  virtual double height(const Plan& plan, double x, double y) const = 0;
  /// Least height of the underside within the plan [m].
  virtual double lowest(const Plan&) const { return 0; }
  /// Least value of height(x, y) + slope[0] x + slope[1] y within the plan [m]: the lowest point of
  /// the underside after a small tilt. By default searched on a grid that is refined.
  /// @param slope of the tilt along x and y [1]
  virtual double lowest_on_slope(const Plan& plan, const std::array<double, 2>& slope) const;
  /// True if the underside is flat up to sharp edges, so that its whole plan touches at once.
  virtual bool sharp() const { return false; }
  /// Half sizes, along x and y, of the part of the underside that touches at once [m]; 0 along a
  /// direction in which the underside is round. Half the plan means that the slider ends at a sharp
  /// edge along this direction.
  virtual std::array<double, 2> flat_half_size(const Plan&) const { return {0, 0}; }
  /// Symmetry of the underside: true at index 0 if it is symmetric under x -> -x, at index 1 if it
  /// is symmetric under y -> -y.
  virtual std::array<bool, 2> symmetric(const Plan&) const { return {true, true}; }
  /// Upper bound of the distance that the contact reaches along `direction` beyond the part that
  /// touches at once [m], without friction; infinity where only the plan bounds it.
  virtual double border(const Plan& plan, const Pressing& pressing,
                        std::size_t direction) const = 0;
  /// True if the sides of the plan are along x and y in every pose.
  virtual bool along_axes() const { return true; }
  /// True if the underside is a body of revolution about z that its plan does not cut, so that a
  /// turn about z does not change it.
  virtual bool turns_into_itself(const Plan&) const { return false; }
  /// Size of the whole body along x and y [m], the plan of a case without `slider.size`; empty
  /// unless the shape's row says `has_whole_plan`.
  virtual std::optional<std::array<double, 2>> whole_plan() const { return {}; }
  /// Conflicts of the parameters with one another or with the plan; empty if there are none.
  virtual std::vector<Misfit> misfits(const Plan&) const { return {}; }
};

/// One row of the table of shapes: what the schema of a case and its reader need of a shape.
struct ShapeRow {
  std::string_view name;                          ///< value of `slider.shape`
  std::string_view meaning;                       ///< in words: "a cylinder with its axis along y"
  bool takes_heights;                             ///< true if it needs the file `slider.profile`
  bool has_whole_plan;                            ///< true if a case need not give `slider.size`
  std::span<const laws::LawParameter> parameters; ///< declarations of its keys `slider.NAME`
  /// Makes the shape from parameter values by name [SI]; parameters without a value are 0.
  std::unique_ptr<const Shape> (*with)(const laws::LawValues& values);
};

/// Table of all shapes; the first is the default of a case.
std::span<const ShapeRow> shapes();

/// Looks up the row of a shape by its name, which the schema has checked. Throws InternalError for
/// an unknown name.
const ShapeRow& shape_row(std::string_view name);

/// Makes a shape by its name, which the schema has checked. Throws InternalError for an unknown
/// name.
/// @param values parameter values by name [SI]. A parameter without a value is 0, as cases without
///   contact need not give any; names of other shapes are ignored.
std::unique_ptr<const Shape> shape(std::string_view name, const laws::LawValues& values);

} // namespace ionskin::shapes
