// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/laws/friction/elastic_slip.hpp"
#include "ionskin/laws/friction/return_mapping.hpp"
#include "ionskin/live/contact/normal_correction.hpp"
#include "ionskin/live/contact/tangential_correction.hpp"
#include "ionskin/live/data/skin_data.hpp"

#include <array>
#include <span>
#include <vector>

namespace ionskin::live {

/// Solves increments of frictional contact between slider and skin for the reduced-order model.
/// Each step does a limited number of projected Gauss-Seidel sweeps, which start from the forces of
/// the last step, with Newton steps for the normal and for the tangential forces in between. Where
/// sweeps and Newton steps miss a given force, a bracketed search over the indentation follows. A
/// step never fails; it returns the remaining residual. Only construction and `set_friction`
/// allocate.
class LiveContact {
public:
  /// State that passes from step to step. The caller owns the memory.
  struct State {
    /// Forces on the cells and displacements of the skin's surface there [3 cells] [N], [m]; the
    /// components of a cell are normal (into the skin), along x, along y.
    std::span<double> force, surface;
    std::span<double> memory; ///< of the friction law [memory_size()]
    double& indentation;      ///< of the slider into the skin; negative above it [m]
    double& assembled_x; ///< x and y of the position whose compliance is used; NaN for none [m]
    double& assembled_y;
  };
  /// Load of the slider: a held force or a held indentation.
  struct Load {
    bool is_force = false;
    /// Normal force on the modelled part of the skin [N], or indentation, negative above the skin
    /// [m].
    double value = 0;
  };

  /// Tilt of the slider and its rotation about z in a step, docs/model.md (77), (78).
  struct Stance {
    std::array<double, 2> slope{}; ///< slope of the underside along x and y [1]
    /// Height of the lowest point of the tilted underside above that of the upright one, when both
    /// have the same height at the slider's centre [m].
    double lowest = 0;
    double turn = 0; ///< rotation about z in the step [rad]
    /// Yaw of an underside that does not look alike from all sides (`turns_underside`); else 0
    /// [rad].
    double yaw = 0;
  };

  /// Sets up the contact with the friction law of the case.
  /// @param data the trained model; must outlive the contact
  explicit LiveContact(const SkinData& data);

  /// Solves one increment of contact, in parts where the load changes fast. The overload without
  /// a stance is for an upright slider that does not rotate.
  /// @param time_step duration of the step [s]
  /// @param place position of the slider's centre at the end of the step [m]
  /// @param travel displacement of the slider's centre in the step [m]
  /// @param state on entry, state before the step; on return, state after the step
  /// @returns residual: largest change of a force in the last sweep over the largest normal force,
  /// or relative error of a given force, whichever is larger [1]
  double step(double time_step, const std::array<double, 2>& place,
              const std::array<double, 2>& travel, const Load& load, State state) noexcept {
    return step(time_step, place, travel, Stance(), load, state);
  }
  double step(double time_step, const std::array<double, 2>& place,
              const std::array<double, 2>& travel, const Stance& stance, const Load& load,
              State state) noexcept;
  /// Sets up the compliance at the assembled position of a state that was restored.
  void assemble(const State& state) noexcept;
  /// Switches to the state of another skin of the same file, and swaps the friction law.
  void exchange(laws::Friction& friction, const State& state) noexcept;
  /// Computes the derivative of the wrench on the modelled part of the skin, docs/model.md (79), at
  /// the end of the last step, by a rigid motion of the slider, docs/model.md (80). The beginning
  /// of the step stays as it was.
  /// @param state as the last step left it
  /// @param matrix receives [forces along x, y, z (N), moments about x, y, z (N m)][translations
  /// along x, y, z (m), rotations about x, y, z (rad)], the axes through the slider's centre on the
  /// undeformed top face
  /// @returns true, with zeros if nothing touches; false if no step led to this state or the
  /// equations were not solved
  bool stiffness(const State& state, std::span<double, 36> matrix) noexcept;
  /// Derivatives of the cell forces by the rigid motions, from the last call of `stiffness`
  /// [motion][3 cells] [N/m], [N/rad].
  std::span<const double> force_by_motion() const { return force_by_motion_; }
  /// Forgets the last step, when another state is restored: `stiffness` then returns false.
  void leave() noexcept { stepped_ = false; }
  /// True if the cell slipped in the last step.
  bool slips(std::size_t cell) const { return slips_[cell] != 0; }
  /// Middle of a cell, measured from the slider's centre [m].
  const std::array<double, 2>& middle(std::size_t cell) const { return middle_[cell]; }
  /// Number of values that the friction law carries from step to step: for each cell its elastic
  /// slip along x and y [m] and the limit traction under which that slip was made [Pa], or the
  /// low-pass filtered slip speed [m/s]; 0 for a law without memory.
  std::size_t memory_size() const { return memory_size_; }
  /// Sets the coefficient of friction [1]. Allocates memory. Throws where the law does not accept
  /// it.
  void set_friction(double coefficient);
  /// Coefficient of friction [1].
  double friction() const { return friction_.coefficient; }

private:
  void pose(const Stance& stance) noexcept;
  void turn_underside(double yaw) noexcept;
  int parts_of(const Load& load, double before) const noexcept;
  double advance(const Load& load, State& state) noexcept;
  const float* column(std::size_t at) noexcept;
  void add(std::size_t cell, const std::array<double, 3>& force, State& state) noexcept;
  std::array<double, 2> slip(std::size_t cell, const State& state) const noexcept;
  laws::ElasticSlip elastic_slip(std::size_t cell, const State& state) const noexcept;
  laws::FrictionResponse friction_at(std::size_t cell, double normal,
                                     const State& state) const noexcept;
  void remember(State& state) noexcept;

  // Iteration of a part of a step, defined in contact_iteration.cpp.
  /// Largest change of a force component in a sweep: of any component, and of a normal one [N].
  struct Sweep {
    double change = 0, normal_change = 0;
  };
  /// Cells that open in a Newton step where their normal forces would become negative: all of
  /// them, which is fast but may go round in circles; or the first one, at which the step ends and
  /// another one begins. The latter, like a sweep, always lowers the complementary energy, so that
  /// it comes to an end (Lawson and Hanson 1974, DOI 10.1137/1.9781611971217, chapter 23).
  enum class Opening { at_once, one_by_one };
  Sweep sweep(State& state) noexcept;
  std::span<const std::size_t> find_touching(const State& state) noexcept;
  bool take_normal(std::span<const std::size_t> touching) noexcept;
  double solve_normal(const Load& load, std::span<const std::size_t> touching,
                      const State& state) noexcept;
  bool correct(const Load& load, Opening opening, State& state) noexcept;
  bool correct_friction(State& state) noexcept;
  void add_up(const State& state) noexcept;
  double settle(const Load& load, State& state) noexcept;
  double search(const Load& load, State& state) noexcept;

  // Part of the derivatives, defined in contact_stiffness.cpp.
  laws::FrictionResponse friction_about(std::size_t cell, double normal,
                                        const State& state) const noexcept;
  double leave_residual(std::span<const std::size_t> touching, const State& state) noexcept;

  const SkinData& data_;
  laws::Friction friction_;
  std::size_t size_, memory_size_;
  std::vector<double> gap_; ///< gap of each cell in the stance of the step [m]
  bool posed_ = false;      ///< true if `gap_` is that of a tilted or turned underside
  /// Gap of each cell under the upright underside at the yaw of the step [m], and its derivative by
  /// the yaw [m/rad].
  std::vector<double> upright_gap_, gap_by_yaw_;
  double first_touch_; ///< indentation at which the first cell touches: smallest gap [m]
  std::vector<std::array<double, 2>> middle_; ///< middle of each cell, from the slider's centre [m]
  /// Compliance at the assembled position, of the columns in `assembled_` [column][row] [m/N].
  std::vector<float> compliance_;
  std::vector<char> assembled_; ///< true for the columns of `compliance_` that are set
  std::vector<double> own_;     ///< diagonal of the compliance [3 cells] [m/N]
  /// Diagonals of the mean compliance and of each mode [1 + modes][3 cells].
  std::vector<float> diagonals_;
  std::vector<double> before_; ///< surface displacements at the beginning of the step [3 cells] [m]
  std::vector<double> amplitude_; ///< amplitudes of the compliance modes at the assembled position
  /// Derivative of the tangential force by the normal force [cell].
  std::vector<std::array<double, 2>> drag_;
  std::vector<char> slips_;
  NormalCorrection correction_;
  TangentialCorrection tangential_;
  double tolerance_ = 0;           ///< residual at which the iterations of the part stop [1]
  double largest_ = 0, total_ = 0; ///< largest normal force of a cell, and sum over all cells [N]
  std::vector<std::size_t> touching_; ///< work array: indices of the cells in contact
  /// Work arrays of the normal Newton step: gaps that remain to be closed [m], then force changes
  /// [N]; and force changes by a unit of indentation [N/m] [cell in contact].
  std::vector<float> change_, from_indentation_;
  // Last step or its last part, for the derivatives.
  bool stepped_ = false;
  double time_step_ = 0;
  std::array<double, 2> travel_{};
  double turn_ = 0;
  std::vector<double> memory_before_;
  /// Derivatives of the cell forces and of the surface displacements by each motion; `stiffness`
  /// replaces the displacements by the residuals of the equations [motion][3 cells].
  std::vector<double> force_by_motion_, surface_by_motion_;
};

} // namespace ionskin::live
