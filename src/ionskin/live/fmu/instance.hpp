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

/// A skin in the life of an FMU: its inputs, outputs and time. After construction nothing is
/// allocated.
class Instance {
public:
  enum class Mode { instantiated, initialization, stepping, terminated };

  explicit Instance(SkinData data);
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  Mode mode() const { return mode_; }
  double time() const { return time_; } ///< of the last step, or of the start [s]
  const std::string& guid() const { return guid_; }
  std::string shortfall() const { return live::shortfall(data_); }

  void set_start(double time) { time_ = time; }
  void enter_initialization() { mode_ = Mode::initialization; }
  /// The first step of the skin, under the inputs as they are.
  void exit_initialization();
  void terminate() { mode_ = Mode::terminated; }
  void reset();
  /// Makes a step under the inputs as they are. @returns whether it was made; if not nothing has
  /// moved
  bool step(double time);

  /// Value of a real variable by its reference; null for none.
  const double* real(std::size_t reference);
  bool is_output(std::size_t reference) const {
    return reference >= reference::signals && reference - reference::signals < signals_.size();
  }
  double* input(std::size_t reference);
  bool inputs_are_finite() const;
  /// Takes the coefficient of friction to the nearest trained one. @returns whether it changed
  bool limit_friction();
  std::uint32_t flags();
  bool& force_control();

  /// Size of a state, in numbers.
  std::size_t state_size() const;
  /// Copies the state, for `restore`. @param state [state_size()]
  void save(std::span<double> state) const;
  /// Takes up a state that `save` gave.
  /// @returns true if it is a state of such a skin; if not, nothing changes
  bool restore(std::span<const double> state);

private:
  bool trained(double friction) const;
  double* find_input(std::size_t reference);
  /// Takes memory where the coefficient of friction is another than before.
  std::uint32_t evaluate(double time);
  /// In initialization mode outputs follow the inputs, whatever was asked before.
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
  bool followed_ = false;
  std::uint32_t flags_ = 0;
};

} // namespace ionskin::live::fmu
