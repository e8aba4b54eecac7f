// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace ionskin::live {

/// Largest number of interpolation nodes along x or y.
inline constexpr std::size_t most_lines = 17;

/// Motions of a rigid slider: along x, y and z, about x, y and z.
inline constexpr std::size_t motions = 6;

/// Values that depend on the slider's place: a mean and modes, whose amplitudes are polynomials
/// through nodes at the crossings of lines.
struct PlaceMap {
  std::vector<double> lines_x, lines_y; ///< [m]
  std::vector<double> amplitude;        ///< [node, x fastest][mode]
  std::vector<float> values;            ///< [1 + modes][size], the mean first

  std::size_t modes() const { return amplitude.size() / (lines_x.size() * lines_y.size()); }
  std::size_t size() const { return values.size() / (1 + modes()); }
};

/// A channel of the core, such as the shear, from the forces of the contact cells: strains at a few
/// points, the channel there, and from it modes of the whole field.
struct ChannelMap {
  std::uint64_t rows_per_point = 0; ///< strains whose norm is the channel; 1: the strain itself
  PlaceMap strain;                  ///< [3 cells][point][row] [1/N]
  PlaceMap fit;                     ///< [mode][point]
  std::vector<float> field;         ///< [mode][z][y][x]: values on the cells of the slider's frame
  std::vector<double> x_edges, y_edges; ///< of the cells, from the slider's centre [m]
  /// Values of the modes behind those, which stay with the skin as strain at its ends does:
  /// [mode][z][y][x]
  std::vector<float> fixed_field;
  std::vector<double> fixed_x_edges, fixed_y_edges; ///< of their cells, from the skin's corner [m]
  std::vector<double> mean, moment; ///< [z] weights of the integral and of the first moment [m]
};

/// Charges of a region of the core from the integrals of the driving channel over its area, one for
/// each level: an instantaneous part and first-order states with common rates.
struct ChargeModel {
  std::uint64_t inputs = 0;
  std::vector<double> direct;  ///< [top, bottom][input]
  std::vector<double> residue; ///< [top, bottom][rate][input]
};

/// Charge that spreads along the skin from taxel to taxel, alike on top and bottom: cosine waves
/// over uniform columns of the core, each a first-order state. Without waves nothing spreads.
struct SpreadMap {
  std::uint64_t columns_x = 0, columns_y = 0;
  std::vector<std::uint64_t> wave_x, wave_y; ///< half waves over the core [wave]
  std::vector<double> rates;                 ///< [wave] [1/s]
  std::vector<double> weights; ///< [level] of the integral of the driving channel over a column
};

/// Error of the reduced skin against the full model on trajectories that it was not trained on.
struct SignalError {
  std::string name;
  std::string event; ///< of the touches, such as "landing"; empty: over the whole of them
  double rms = 0, worst = 0, largest = 0; ///< of the error, and of the signal [its unit]
};

/// All that a `.live` file holds, SI units.
struct SkinData {
  std::string case_text, version, command;
  std::uint64_t seed = 0, trajectories = 0;
  std::string friction_law;
  double friction = 0; ///< of the case
  double lowest_friction = 0, highest_friction = 0;
  std::vector<std::string> friction_parameters;
  std::vector<double> friction_values;
  // contact
  std::vector<double> cell_lines_x, cell_lines_y; ///< edges of the cells from the centre [m]
  std::vector<double> area, gap;                  ///< of the cells, x fastest [m2], [m]
  PlaceMap compliance;                            ///< [3 cells][3 cells], symmetric [m/N]
  double meshed_share = 1;           ///< of the skin, 0.5 for the half beside its plane of symmetry
  double stiffness = 0;              ///< of the trained contact under the heaviest load [N/m]
  std::array<double, 2> direction{}; ///< along which the tangential force is given
  // core
  double length = 0, width = 0, thickness = 0; ///< [m]
  std::vector<ChannelMap> channels;            ///< the shear; the last one drives the ions
  std::vector<double> rates;                   ///< of the states [1/s]
  ChargeModel whole, part;                     ///< of the electrode, of a taxel
  SpreadMap spread;                            ///< of the taxels' charges
  std::vector<std::string> taxels;
  std::vector<double> taxel_corners; ///< [taxel][x low, y low, x high, y high] [m]
  // trained range
  std::array<double, 2> lowest_place{}, highest_place{}; ///< of the slider's centre [m]
  double heaviest_force = 0;                             ///< [N]
  double deepest_indentation = 0;                        ///< [m]
  double fastest = 0;                                    ///< [m/s]
  double steepest = 0;                                   ///< tilt [rad]
  double fastest_turn = 0;                               ///< about z [rad/s]
  std::uint64_t turns_into_itself = 0;                   ///< 1 if the underside does, about z
  std::vector<double> slopes;      ///< lines of the tables of slopes: ascending, 0 in the middle
  std::vector<double> lowest;      ///< [slope along y][along x], as LiveContact::Stance has it [m]
  std::vector<SignalError> errors; ///< errors of whole touches first
};

/// Number of digits of the digest at the end of a file.
inline constexpr std::size_t digest_digits = 32;

/// The content of a file, digest included.
std::string skin_bytes(const SkinData& data);

/// Writes under a temporary name, then renames. Throws base::UnwritableFile.
void write_skin(const std::filesystem::path& path, const SkinData& data);

/// Throws UserError when the file cannot be read, is not such a file, is damaged, or holds sizes
/// that do not fit each other.
SkinData read_skin(const std::filesystem::path& path);

/// True if a file calls itself a live skin, whole or not.
bool is_skin_file(const std::filesystem::path& path);

} // namespace ionskin::live
