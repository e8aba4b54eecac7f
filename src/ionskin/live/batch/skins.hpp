// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/skin.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ionskin::live {

/// White noise of an instrument that is added to the currents of one environment. Its values depend
/// only on the seed and on the number of steps taken with it.
struct CurrentNoise {
  double deviation = 0; ///< standard deviation on each current [A]
  /// Seed, and number of steps taken with the noise.
  std::uint64_t seed = 0, steps = 0;
};

/// Many reduced-order skins of one file, stepped together, as environments of a learner. Each has
/// its own state, friction and noise; they share tables and workspace. The result of an environment
/// depends neither on the other environments nor on the worker that steps it.
class Skins {
public:
  /// Inputs and outputs of a step of all environments, in memory of the caller. `Value` is float or
  /// double. SI units.
  template <class Value> struct Step {
    const double* times = nullptr;    ///< [environment] [s]
    const Value* positions = nullptr; ///< [environment][x, y] [m]
    /// True if `loads` are normal forces, false if they are heights of the underside.
    bool is_force = false;
    const Value* loads = nullptr;           ///< normal force [N] or height [m] [environment]
    std::span<const std::uint32_t> columns; ///< indices of the signals that are written
    Value* signals = nullptr;               ///< result [environment][column]
    std::uint32_t* flags = nullptr;         ///< result: bits of `flag` [environment]
    const Value* angles = nullptr; ///< [environment][roll, pitch, yaw] [rad]; null for upright
    /// Result: stiffness as `Skin::stiffness` computes it [environment][36]; NaN for an environment
    /// that refused its step. Null: not computed.
    double* stiffness = nullptr;
  };

  /// Makes environments in the state and with the friction of one skin, without noise.
  /// @param data the trained model; must outlive this
  /// @param like skin of the same file whose state and friction all environments take
  /// @param environments number of environments
  /// @param workers number of threads that may step at once, at least 1
  Skins(const SkinData& data, const Skin& like, std::size_t environments, std::size_t workers);

  std::size_t environments() const { return states_.size(); }
  /// Names of the signals, as `Skin::names`.
  const std::vector<std::string>& names() const { return workers_.front().lanes.front().names(); }

  /// Advances the environments from `first` to before `last`. Several threads may call it at the
  /// same time for ranges that do not overlap, each with a worker of its own. Allocates nothing.
  /// @param worker index of the workspace, below the number of workers
  template <class Value>
  void step(std::size_t worker, std::size_t first, std::size_t last,
            const Step<Value>& step) noexcept;

  /// Resets an environment to a skin at rest without contact; friction and noise stay. Not to be
  /// called while a worker steps.
  void reset(std::size_t environment) noexcept;
  /// State of an environment, for `restore`.
  std::span<const double> state(std::size_t environment) const { return states_[environment]; }
  /// Replaces the state of an environment by one that `state` returned. Not to be called while a
  /// worker steps.
  /// @returns false, with nothing changed, if it is not a state of such a skin
  bool restore(std::size_t environment, std::span<const double> state) noexcept;
  /// Sets the coefficient of friction [1] of an environment. Allocates memory.
  /// @returns false, with nothing changed, if it is outside the trained range
  bool set_friction(std::size_t environment, double coefficient);
  /// Coefficient of friction of an environment [1].
  double friction(std::size_t environment) const { return frictions_[environment].coefficient; }
  /// Noise of an environment, which the caller may change between steps.
  CurrentNoise& noise(std::size_t environment) { return noises_[environment]; }

private:
  struct Worker {
    std::vector<Skin> lanes;
    std::vector<ChannelField> fields;
    std::vector<double> signals; ///< signals of each lane [lane][name]
  };
  void add_noise(std::size_t environment, bool refused, std::span<double> signals) noexcept;

  const SkinData& data_;
  std::vector<std::vector<double>> states_; ///< state of each environment
  std::vector<laws::Friction> frictions_;
  std::vector<CurrentNoise> noises_;
  std::vector<std::size_t> noisy_; ///< indices of the currents that carry noise of their own
  /// Indices of the currents of top and bottom, half their difference and half their sum.
  std::array<std::size_t, 4> sums_{};
  std::vector<double> rest_; ///< state of a skin at rest without contact
  std::vector<Worker> workers_;
};

} // namespace ionskin::live
