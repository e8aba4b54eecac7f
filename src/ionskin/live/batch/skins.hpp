// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/skin.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ionskin::live {

/// White noise of an instrument on the currents of an environment. Its values follow from the seed
/// and from how many steps were taken with it.
struct CurrentNoise {
  double deviation = 0; ///< of each current [A]
  std::uint64_t seed = 0, steps = 0;
};

/// Many skins of one file, the environments of a learner, stepped together: each has its own state,
/// friction and noise, and tables and workspace are shared. What one environment does depends
/// neither on the others nor on which worker steps it.
class Skins {
public:
  /// Inputs and results of a step of all environments; `Value` is float or double. SI units.
  template <class Value> struct Step {
    const double* times = nullptr;    ///< [environment] [s]
    const Value* positions = nullptr; ///< [environment][x, y] [m]
    bool is_force = false;
    const Value* loads = nullptr;           ///< [environment] [N], or height [m]
    std::span<const std::uint32_t> columns; ///< signals that are written
    Value* signals = nullptr;               ///< [environment][column]
    std::uint32_t* flags = nullptr;         ///< [environment]
    const Value* angles = nullptr; ///< [environment][roll, pitch, yaw] [rad]; null: upright
    /// [environment][36], as Skin::stiffness gives it; of a refused environment NaN. Null: not
    /// written
    double* stiffness = nullptr;
  };

  /// @param data outlives this
  /// @param like gives the first state and the friction of all environments
  /// @param workers that may step at once
  Skins(const SkinData& data, const Skin& like, std::size_t environments, std::size_t workers);

  std::size_t environments() const { return states_.size(); }
  const std::vector<std::string>& names() const { return workers_.front().lanes.front().names(); }

  /// Steps the environments from `first` to before `last`. Workers may step ranges that do not
  /// overlap at the same time. Takes no memory.
  template <class Value>
  void step(std::size_t worker, std::size_t first, std::size_t last,
            const Step<Value>& step) noexcept;

  /// Puts an environment back to a detached skin at rest; friction and noise stay. Not while a
  /// worker steps.
  void reset(std::size_t environment) noexcept;
  std::span<const double> state(std::size_t environment) const { return states_[environment]; }
  /// Takes up a state of an environment that `state` gave.
  /// @returns whether it is a state of such a skin; if not nothing changes
  bool restore(std::size_t environment, std::span<const double> state) noexcept;
  /// Takes memory. @returns whether it is within the trained range; if not nothing changes
  bool set_friction(std::size_t environment, double coefficient);
  double friction(std::size_t environment) const { return frictions_[environment].coefficient; }
  CurrentNoise& noise(std::size_t environment) { return noises_[environment]; }

private:
  struct Worker {
    std::vector<Skin> lanes;
    std::vector<ChannelField> fields;
    std::vector<double> signals; ///< [lane][name]
  };
  void add_noise(std::size_t environment, bool refused, std::span<double> signals) noexcept;

  const SkinData& data_;
  std::vector<std::vector<double>> states_;
  std::vector<laws::Friction> frictions_;
  std::vector<CurrentNoise> noises_;
  std::vector<std::size_t> noisy_;    ///< places of the currents that are measured
  std::array<std::size_t, 4> sums_{}; ///< of top, bottom, half their difference, half their sum
  std::vector<double> rest_;
  std::vector<Worker> workers_;
};

} // namespace ionskin::live
