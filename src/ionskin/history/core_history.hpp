// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace ionskin::history {

/// Cells in x and y, nodes in z. x and y count from the skin's corner (frame skin) or from the
/// slider's centre (frame slider); z counts from the bottom of the core. All [m], strictly
/// ascending.
struct StrainGrid {
  std::vector<double> x_edges, y_edges, z_nodes;
  std::size_t columns_x() const { return x_edges.size() - 1; }
  std::size_t columns_y() const { return y_edges.size() - 1; }
  std::size_t values() const { return columns_x() * columns_y() * z_nodes.size(); }
};

/// Origin from which the places of a grid count.
enum class Frame { skin, slider };

/// One scalar at every value of the grid, [z][y][x] with x fastest.
using StrainField = std::vector<double>;

/// Names of the channels that the program makes and knows to use.
namespace channel_name {
inline constexpr const char* shear = "shear";       ///< gamma, by the measure of the case [1]
inline constexpr const char* dilation = "dilation"; ///< -tr e, positive in compression [1]
/// Pore pressure if no water moved, positive in compression [Pa].
inline constexpr const char* undrained_pressure = "undrained_pressure";
} // namespace channel_name

/// Unit of a channel that the program knows, or nullptr.
const std::string* unit_of_channel(std::string_view name);
/// Largest magnitude that a known channel can sensibly have, in its unit.
double largest_of_channel(std::string_view name);
/// Names of the channels, for messages.
std::string known_channels();

/// One scalar of the core over time.
struct HistoryChannel {
  std::string name, unit;
  /// One field per sample; repeated fields (later cycles, detached phases) are shared, not copied.
  std::vector<std::shared_ptr<const StrainField>> samples;
};

/// Scalars of the core over time, by name: the only handover between mechanics and ion transport.
/// Linear in time and in z between the samples, constant over each x-y cell. In the slider frame
/// the cells ride with the slider, whose position is linear in time between the samples too; values
/// are then adjusted so that integrals over the core are linear (see level_integrals.hpp).
struct CoreHistory {
  StrainGrid grid;
  Frame frame = Frame::skin;
  std::string measure;                  ///< name of the shear measure, for the record
  double length = 0, width = 0;         ///< of the core along x and y [m]
  std::vector<double> time;             ///< [s], strictly ascending, at least two samples
  std::vector<double> slider_x;         ///< slider centre per sample [m]; empty in the skin frame
  std::vector<double> slider_y;         ///< likewise; empty when it stays at mid-width
  std::vector<HistoryChannel> channels; ///< on the same grid, with the same samples
  /// Instants after which the response has a fresh fast transient (contact, phase changes) [s]; a
  /// subset of `time`. Time steps restart small there; they land on every other sample without a
  /// restart.
  std::vector<double> event_time;

  /// The channel of a name, or nullptr.
  const HistoryChannel* find(std::string_view name) const;
  /// The channel of a name, which must be there.
  const HistoryChannel& channel(std::string_view name) const;
  /// The channel of a name; where there is none, it is added without samples.
  HistoryChannel& add_channel(const std::string& name, const std::string& unit);
  /// Samples of the shear; the channel is added when it is not there.
  std::vector<std::shared_ptr<const StrainField>>& shear() {
    return add_channel(channel_name::shear, "1").samples;
  }
  const std::vector<std::shared_ptr<const StrainField>>& shear() const {
    return channel(channel_name::shear).samples;
  }

  double core_thickness() const { return grid.z_nodes.back(); }
  /// Duration of the history [s].
  double duration() const { return time.back() - time.front(); }
};

/// Largest magnitude of a channel over all samples.
double largest_magnitude(const HistoryChannel& channel);

/// Place of an instant between two samples: (1 - weight) * sample[index] + weight * sample[index +
/// 1].
struct TimeBracket {
  std::size_t index = 0;
  double weight = 0;
};

/// Samples around an instant, with their weights.
/// @param time [s]; clamped to the history
TimeBracket bracket(const CoreHistory& history, double time);

/// Cell edges in the skin's frame at an instant [m].
std::vector<double> skin_x_edges(const CoreHistory& history, const TimeBracket& at);
std::vector<double> skin_y_edges(const CoreHistory& history, const TimeBracket& at);

/// The field of a channel at an instant, into `field` (resized).
void interpolate_field(const CoreHistory& history, const HistoryChannel& channel,
                       const TimeBracket& at, StrainField& field);

} // namespace ionskin::history
