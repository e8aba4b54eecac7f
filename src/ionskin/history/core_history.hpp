// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace ionskin::history {

/// Grid on which channels of the core are sampled: cells along x and y, given by their edges, and
/// nodes along z. x and y are measured from the skin's corner in the frame `skin` and from the
/// slider's centre in the frame `slider`, z from the bottom of the core. All in [m], strictly
/// ascending.
struct StrainGrid {
  std::vector<double> x_edges, y_edges, z_nodes;
  std::size_t columns_x() const { return x_edges.size() - 1; }
  std::size_t columns_y() const { return y_edges.size() - 1; }
  std::size_t values() const { return columns_x() * columns_y() * z_nodes.size(); }
};

/// Origin of the x and y coordinates of a grid: the corner of the skin, or the centre of the moving
/// slider.
enum class Frame { skin, slider };

/// Values of one scalar on the whole grid, in the shape [z][y][x] with x fastest.
using StrainField = std::vector<double>;

/// Names of the strain channels that ionskin writes and reads.
namespace channel_name {
inline constexpr const char* shear = "shear";       ///< shear gamma by the measure of the case [1]
inline constexpr const char* dilation = "dilation"; ///< -tr(strain), positive in compression [1]
/// Pore pressure as it would be if no water moved, positive in compression [Pa].
inline constexpr const char* undrained_pressure = "undrained_pressure";
} // namespace channel_name

/// Unit of a channel by its name; nullptr for a name that ionskin does not know.
const std::string* unit_of_channel(std::string_view name);
/// Largest magnitude that a channel may have in a strain file, in the unit of the channel; 0 for a
/// name that ionskin does not know.
double largest_of_channel(std::string_view name);
/// Lists the names of the channels that ionskin knows, separated by commas, for messages.
std::string known_channels();

/// Strain channel: one scalar field over the core, sampled in time.
struct HistoryChannel {
  std::string name, unit;
  /// One field for each sample time, in `unit`. Samples with identical fields (later cycles, a
  /// slider off the skin) share one field instead of a copy.
  std::vector<std::shared_ptr<const StrainField>> samples;
};

/// Strain history of the core: named channels sampled over a grid and time. It is all that passes
/// from Study 1 (mechanics) to Study 2 (ion transport). Channels are linear in time and in z
/// between samples, and constant over each x-y cell. In the slider frame the cells move with the
/// slider, whose position is linear in time between samples, too; values are then adjusted so that
/// integrals over the core stay linear in time (level_integrals.hpp).
struct CoreHistory {
  StrainGrid grid;
  Frame frame = Frame::skin;
  std::string measure;          ///< name of the shear measure, only for the record
  double length = 0, width = 0; ///< size of the core along x and y [m]
  std::vector<double> time;     ///< sample times [s], strictly ascending, at least two
  std::vector<double> slider_x; ///< slider centre x at each sample [m]; empty in the skin frame
  std::vector<double> slider_y; ///< slider centre y at each sample [m]; empty: at mid-width
  std::vector<HistoryChannel> channels; ///< all on `grid`, with one sample for each time
  /// Instants after which the response has a fresh fast transient, such as a contact or a change of
  /// phase [s]; a subset of `time`. Time integration restarts with small steps there. Its steps end
  /// on every other sample as well, without a restart.
  std::vector<double> event_time;

  /// The channel of a given name, or nullptr.
  const HistoryChannel* find(std::string_view name) const;
  /// The channel of a given name. Throws InternalError when there is none.
  const HistoryChannel& channel(std::string_view name) const;
  /// The channel of a given name; adds it, with the unit and without samples, where there is none.
  HistoryChannel& add_channel(const std::string& name, const std::string& unit);
  /// Samples of the channel `shear` [1]. Adds an empty channel where there is none.
  std::vector<std::shared_ptr<const StrainField>>& shear() {
    return add_channel(channel_name::shear, "1").samples;
  }
  /// Samples of the channel `shear` [1]. Throws InternalError when there is no such channel.
  const std::vector<std::shared_ptr<const StrainField>>& shear() const {
    return channel(channel_name::shear).samples;
  }

  /// Thickness of the core [m].
  double core_thickness() const { return grid.z_nodes.back(); }
  /// Duration of the history [s].
  double duration() const { return time.back() - time.front(); }
};

/// Largest magnitude of a channel over all cells, levels and samples, in the unit of the channel.
double largest_magnitude(const HistoryChannel& channel);

/// Weights that interpolate linearly in time between two samples: (1 - weight) * sample[index] +
/// weight * sample[index + 1].
struct TimeBracket {
  std::size_t index = 0;
  double weight = 0;
};

/// Finds the samples around an instant, and their weights.
/// @param time [s]; clamped to the begin and the end of the history
TimeBracket bracket(const CoreHistory& history, double time);

/// Edges of the grid cells along x at an instant, measured from the skin's corner [m].
std::vector<double> skin_x_edges(const CoreHistory& history, const TimeBracket& at);
/// Edges of the grid cells along y at an instant, measured from the skin's corner [m].
std::vector<double> skin_y_edges(const CoreHistory& history, const TimeBracket& at);

/// Interpolates a channel at an instant, on the grid of the history. In the slider frame the result
/// is adjusted by `keep_level_integrals_linear`.
/// @param field receives the values, [z][y][x]; resized
void interpolate_field(const CoreHistory& history, const HistoryChannel& channel,
                       const TimeBracket& at, StrainField& field);

} // namespace ionskin::history
