// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/laws/friction/elastic_slip.hpp"
#include "ionskin/laws/friction/return_mapping.hpp"
#include "ionskin/live/corrections/normal_correction.hpp"
#include "ionskin/live/corrections/tangential_correction.hpp"
#include "ionskin/live/skin_data.hpp"

#include <array>
#include <span>
#include <vector>

namespace ionskin::live {

/// One increment of contact and friction by at most so many sweeps of projected Gauss-Seidel, which
/// start from the forces of the step before, with Newton's steps for the normal and for the
/// tangential forces between them; where they miss a given force, a bracketed search over the
/// indentation. Never fails; the remaining residual is reported. Nothing is allocated after
/// construction.
class LiveContact {
public:
  /// State that passes from step to step; memory of the owner.
  struct State {
    std::span<double> force, surface; ///< [3 cells] [N], [m]
    std::span<double> memory;         ///< of friction, as many as `memory_size()`
    double& indentation;              ///< [m]
    double& assembled_x;              ///< the place whose compliance is used; NaN for none [m]
    double& assembled_y;
  };
  struct Load {
    bool is_force = false;
    double value = 0; ///< on the meshed part [N], or indentation, negative above the skin [m]
  };

  /// Tilt and turn of a slider in a step, docs/model.md (77), (78).
  struct Stance {
    std::array<double, 2> slope{}; ///< of the underside along x and y [1]
    double lowest = 0; ///< height of its lowest point above that of the upright one, about the
                       ///< centre [m]
    double turn = 0;   ///< about z in the step [rad]
  };

  /// @param data outlives this
  explicit LiveContact(const SkinData& data);

  /// Steps the contact; `state` is that before the step on entry and that behind it on return.
  /// @returns the largest change of a force in the last sweep over the largest force
  double step(double time_step, const std::array<double, 2>& place,
              const std::array<double, 2>& travel, const Load& load, State state) noexcept {
    return step(time_step, place, travel, Stance(), load, state);
  }
  double step(double time_step, const std::array<double, 2>& place,
              const std::array<double, 2>& travel, const Stance& stance, const Load& load,
              State state) noexcept;
  /// Takes the compliance of the state's assembled place, after a restore.
  void assemble(const State& state) noexcept;
  /// Goes over to another skin of the same file, with a friction of its own.
  void exchange(laws::Friction& friction, const State& state) noexcept;
  /// Derivative of the wrench on the meshed part, docs/model.md (79), by a rigid motion of the
  /// slider at the end of the last step, which begins as it did, docs/model.md (80): forces along
  /// x, y and z, moments about x, y and z [row] by ways along x, y and z, turns about x, y and z
  /// through the slider's centre on the undeformed top face [column].
  /// @returns false where there was no step in this state, or the equations were not solved
  bool stiffness(const State& state, std::span<double, 36> matrix) noexcept;
  /// Derivatives of the cells' forces by which `stiffness` found the last matrix: [motion][3 cells]
  /// [N/m], [N/rad].
  std::span<const double> force_by_motion() const { return force_by_motion_; }
  /// Leaves the last step, as another state is taken up.
  void leave() noexcept { stepped_ = false; }
  bool slips(std::size_t cell) const { return slips_[cell] != 0; } ///< of the last step
  /// Middle of a cell, from the slider's centre [m].
  const std::array<double, 2>& middle(std::size_t cell) const { return middle_[cell]; }
  /// Numbers that the friction law keeps from step to step: of each cell its elastic slip along x
  /// and y [m] and the limit under which it was made [Pa], or the speed that it follows with a lag
  /// [m/s]; none for a law that remembers nothing.
  std::size_t memory_size() const { return memory_size_; }
  /// Sets another coefficient of the law, which takes memory. Throws where the law has none of it.
  void set_friction(double coefficient);
  double friction() const { return friction_.coefficient; }

private:
  struct Sweep { // changes of a force at most, of all and of the normal ones [N]
    double change = 0, normal_change = 0;
  };
  void tilt(const Stance& stance) noexcept;
  std::array<double, 2> slip(std::size_t cell, const std::array<double, 2>& travel,
                             const State& state) const noexcept;
  const float* column(std::size_t at) noexcept;
  void add(std::size_t cell, const std::array<double, 3>& force, State& state) noexcept;
  Sweep sweep(double time_step, const std::array<double, 2>& travel, State& state) noexcept;
  void remember(double time_step, const std::array<double, 2>& travel, State& state) noexcept;
  laws::ElasticSlip elastic_slip(std::size_t cell, const State& state) const noexcept;
  laws::FrictionResponse friction_at(std::size_t cell, double normal, double time_step,
                                     const std::array<double, 2>& travel,
                                     const State& state) const noexcept;
  bool take_normal(std::span<const std::size_t> touching) noexcept;
  std::span<const std::size_t> find_touching(const State& state) noexcept;
  // The derivatives stand in contact_stiffness.cpp.
  double leave_residual(std::span<const std::size_t> touching, const State& state) noexcept;
  void add_up(const State& state) noexcept;
  bool correct(const Load& load, State& state) noexcept;
  bool correct_friction(double time_step, const std::array<double, 2>& travel,
                        State& state) noexcept;
  double settle(double time_step, const std::array<double, 2>& travel, const Load& load,
                State& state) noexcept;
  double search(double time_step, const std::array<double, 2>& travel, const Load& load,
                State& state) noexcept;

  const SkinData& data_;
  laws::Friction friction_;
  std::size_t size_, memory_size_;
  std::vector<double> gap_; ///< in the stance of the step [m]
  bool tilted_ = false;
  double first_touch_;
  std::vector<std::array<double, 2>> middle_;
  std::vector<float> compliance_;           ///< [column][row], where `assembled_` says so
  std::vector<char> assembled_;             ///< columns
  std::vector<double> own_;                 ///< [3 cells] diagonal
  std::vector<float> diagonals_;            ///< of the mean and of each mode [1 + modes][3 cells]
  std::vector<double> before_;              ///< [3 cells] surface of the step before
  std::vector<double> amplitude_;           ///< of the modes at the assembled place
  std::vector<std::array<double, 2>> drag_; ///< derivative of the friction by the normal force
  std::vector<char> slips_;
  NormalCorrection correction_;
  TangentialCorrection tangential_;
  double largest_ = 0, total_ = 0; ///< normal force of a cell, and of all [N]
  std::vector<std::size_t> touching_;
  std::vector<float> from_gaps_, from_indentation_;
  // The last step, for its derivatives.
  bool stepped_ = false;
  double time_step_ = 0;
  std::array<double, 2> travel_{};
  double turn_ = 0;
  std::vector<double> memory_before_;
  /// Derivatives of each force of a cell by each motion, and those of the surfaces, or what of
  /// their equations is missed.
  std::vector<double> force_by_motion_, surface_by_motion_;
};

/// The friction law of a skin with a coefficient. Throws where there is none of its name.
laws::Friction friction_of(const SkinData& data, double coefficient);

} // namespace ionskin::live
