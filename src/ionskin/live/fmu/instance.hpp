// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/live/errors/shortfall.hpp"
#include "ionskin/live/fmu/variables.hpp"
#include "ionskin/live/skin.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace ionskin::live::fmu {

/// Instance of the FMU: a skin with its inputs, outputs, time and mode in the sense of FMI 2.0.
/// Allocates nothing after construction, unless the coefficient of friction changes.
class Instance {
public:
  /// Mode of the instance, as FMI 2.0 defines it.
  enum class Mode { instantiated, initialization, stepping, terminated };

  /// Makes an instance in the mode `instantiated`, with all inputs at their start values.
  explicit Instance(SkinData data);
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  Mode mode() const { return mode_; }
  /// Time at the end of the last step, or start time [s].
  double time() const { return time_; }
  /// Identifier of the skin (`fmu::guid`).
  const std::string& guid() const { return guid_; }
  /// Line on errors above the promised one (`live::shortfall`); empty if there is none.
  std::string shortfall() const { return live::shortfall(data_); }

  /// Sets the start time [s].
  void set_start(double time) { time_ = time; }
  void enter_initialization() { mode_ = Mode::initialization; }
  /// Makes the first step of the skin, with the present inputs, at the start time.
  void exit_initialization();
  void terminate() { mode_ = Mode::terminated; }
  /// Returns to the mode `instantiated`, with a skin at rest without contact and all inputs at
  /// their start values.
  void reset();
  /// Makes a step with the present inputs.
  /// @param time at the end of the step [s]
  /// @returns false, with state and outputs unchanged, if the skin refuses the step
  bool step(double time);

  /// Value of a real variable, by its value reference; null if there is no such variable.
  const double* real(std::size_t reference);
  /// True if a value reference is that of a signal.
  bool is_output(std::size_t reference) const {
    return reference >= reference::signals && reference - reference::signals < signals_.size();
  }
  /// Input variable by its value reference, to be written; null if there is no such input.
  double* input(std::size_t reference);
  bool inputs_are_finite() const;
  /// Moves the coefficient of friction into the trained range. Leaves a value that is not finite,
  /// which a step refuses.
  /// @returns true if the coefficient was outside
  bool limit_friction();
  /// Bits of `live::flag` of the last step.
  std::uint32_t flags();
  /// Parameter `force_control`, to be read or written: true if the input `force` presses the
  /// slider, false if the input `height` holds it.
  bool& force_control();

  /// Number of values of a state.
  std::size_t state_size() const;
  /// Copies the state, for `restore`.
  /// @param state receives the state [state_size()]
  void save(std::span<double> state) const;
  /// Replaces the state by one that `save` copied.
  /// @returns false, with nothing changed, if it is not a state of such a skin
  bool restore(std::span<const double> state);

private:
  /// True if a coefficient of friction is within the trained range.
  bool trained(double friction) const;
  /// Input variable, as `input` returns it, without noting a change.
  double* find_input(std::size_t reference);
  /// Steps the skin with the present inputs, and returns its flags. Allocates memory when the
  /// coefficient of friction differs from that of the last step.
  std::uint32_t evaluate(double time);
  /// Recomputes the first step after inputs changed in initialization mode, where outputs must
  /// follow the inputs.
  void follow_inputs();

  SkinData data_;
  std::string guid_;
  std::array<double, reference::inputs> start_{};
  Skin skin_;
  std::vector<double> signals_;
  Mode mode_ = Mode::instantiated;
  double time_ = 0;
  std::array<double, reference::inputs> inputs_{};
  std::vector<std::size_t> trained_angles_;
  Skin::Angles angles_{};
  bool force_control_ = false;
  bool followed_ = false; ///< false after an input changed, until `follow_inputs`
  std::uint32_t flags_ = 0;
};

} // namespace ionskin::live::fmu
