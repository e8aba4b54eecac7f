// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/laws/friction/friction_law.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ionskin::live {

/// Largest number of interpolation nodes of a `PlaceMap` along x or y.
inline constexpr std::size_t most_lines = 17;

/// Number of rigid motions of the slider: translations along x, y and z, then rotations about x, y
/// and z.
inline constexpr std::size_t motions = 6;

/// Vector that depends on the position of the slider: mean + sum over modes of amplitude times
/// mode. The amplitudes are known at the nodes of a grid of positions, and are interpolated by
/// polynomials in between (`place_amplitudes`).
struct PlaceMap {
  std::vector<double> lines_x, lines_y; ///< positions of the nodes along x and y [m]
  std::vector<double> amplitude;        ///< amplitudes at the nodes [node, x fastest][mode] [1]
  std::vector<float> values;            ///< mean, then modes [1 + modes][size]

  std::size_t modes() const { return amplitude.size() / (lines_x.size() * lines_y.size()); }
  /// Length of the vector.
  std::size_t size() const { return values.size() / (1 + modes()); }
};

/// Reduced model of one channel (scalar field over the core, such as the shear [1]) under forces on
/// the contact cells. A linear map gives the strains at some points from the forces; the norm of
/// the strains at a point is the channel there; a second linear map gives the amplitudes of modes
/// of the whole field from the values at the points.
struct ChannelMap {
  /// Number of combinations of the strain components at a point whose norm is the channel; 1 if the
  /// channel is the one combination itself, with its sign.
  std::uint64_t rows_per_point = 0;
  PlaceMap strain; ///< strains by the forces [3 cells][point][row] [1/N]
  PlaceMap fit;    ///< amplitudes of the modes by the channel at the points [mode][point]
  /// Modes that move with the slider: values on the cells of a grid around it [mode][z][y][x].
  std::vector<float> field;
  std::vector<double> x_edges, y_edges; ///< edges of the cells, from the slider's centre [m]
  /// Modes that stay with the skin, as strain at its ends does, on cells that are fixed to it
  /// [mode][z][y][x]. In `fit`, they follow the modes that move with the slider.
  std::vector<float> fixed_field;
  /// Edges of the cells that are fixed to the skin, from its corner [m].
  std::vector<double> fixed_x_edges, fixed_y_edges;
  /// Weights of the z levels for the integral over the thickness of a field, and of the field times
  /// (zeta/h - 1/2) [z] [m].
  std::vector<double> mean, moment;
};

/// Charges on both electrodes of a region of the core, as a linear system. The inputs are the
/// integrals of the driving channel over the region's area, one for each z level [m2]; in laws that
/// depend on the mean over the core, the integrals over the whole core times the region's share of
/// its area follow. Each charge is the sum of an instantaneous part and of first-order states,
/// whose rates are `SkinData::rates`.
struct ChargeModel {
  std::uint64_t inputs = 0;
  std::vector<double> direct; ///< weights of the instantaneous part [top, bottom][input] [C/m2]
  /// Weights of the inputs of the states [top, bottom][rate][input] [C/m2].
  std::vector<double> residue;
};

/// Charge that spreads along the skin from taxel to taxel, by equal amounts on top and bottom:
/// cosine waves over a grid of uniform columns of the core, each a first-order state. No waves:
/// nothing spreads.
struct SpreadMap {
  /// Number of columns over the length and the width of the core.
  std::uint64_t columns_x = 0, columns_y = 0;
  std::vector<std::uint64_t> wave_x, wave_y; ///< half waves over the length and the width [wave]
  std::vector<double> rates;                 ///< relaxation rates [wave] [1/s]
  /// Weights of the integrals of the driving channel over a column [level] [C/m2].
  std::vector<double> weights;
};

/// Error of one signal of the reduced-order model against the full model, on validation touches
/// that were not used for training.
struct SignalError {
  std::string name; ///< of the signal
  /// Phase of the touches in which the error is taken, such as "landing" (`touch_events.hpp`);
  /// empty for whole touches.
  std::string event;
  /// Rms and largest error, and largest value of the signal [unit of the signal].
  double rms = 0, worst = 0, largest = 0;
};

/// Trained reduced-order model of a skin: all that a `.live` file holds, in SI units. `train_skin`
/// makes it, and `Skin` steps it.
struct SkinData {
  /// Case file, version of ionskin and command line of the training, for the record.
  std::string case_text, version, command;
  /// Seed and number of the random touches of the training.
  std::uint64_t seed = 0, trajectories = 0;
  std::string friction_law; ///< name of the law
  double friction = 0;      ///< coefficient of friction of the case [1]
  /// Trained range of the coefficient of friction [1].
  double lowest_friction = 0, highest_friction = 0;
  /// Further parameters of the friction law: names, and values in SI units.
  std::vector<std::string> friction_parameters;
  std::vector<double> friction_values;
  // contact
  /// Edges of the contact cells, from the slider's centre [m].
  std::vector<double> cell_lines_x, cell_lines_y;
  /// Area of each contact cell [m2], and its gap to the underside of the upright slider at
  /// indentation 0 [m] [cell, x fastest].
  std::vector<double> area, gap;
  /// Displacements of the contact cells by the forces on them [3 cells][3 cells], symmetric [m/N];
  /// the components of a cell are normal (into the skin), along x, along y.
  PlaceMap compliance;
  /// Share of the skin that is modelled: 1, or 0.5 for one half beside a plane of symmetry.
  double meshed_share = 1;
  /// Normal stiffness of the modelled part of the contact under the heaviest trained load [N/m].
  double stiffness = 0;
  /// Direction, x and y, along which the signal `tangential_force` is taken.
  std::array<double, 2> direction{};
  // core
  double length = 0, width = 0, thickness = 0; ///< of the core [m]
  /// Channels of the core: the shear first; the last one drives the ions.
  std::vector<ChannelMap> channels;
  std::vector<double> rates;         ///< rates of the states of `whole` and `part` [1/s]
  ChargeModel whole, part;           ///< charges of the whole electrode, and of one taxel
  SpreadMap spread;                  ///< spreading of charge between taxels
  std::vector<std::string> taxels;   ///< names
  std::vector<double> taxel_corners; ///< [taxel][x low, y low, x high, y high] [m]
  // trained range
  /// Rectangle of the trained positions of the slider's centre [m].
  std::array<double, 2> lowest_place{}, highest_place{};
  double heaviest_force = 0;      ///< on the whole skin [N]
  double deepest_indentation = 0; ///< [m]
  double fastest = 0;             ///< slider along the skin [m/s]
  double steepest = 0;     ///< largest trained tilt, roll and pitch together; 0 for none [rad]
  double fastest_turn = 0; ///< fastest trained rotation about z; 0 for none [rad/s]
  /// 1 if the underside is rotationally symmetric about z, else 0.
  std::uint64_t turns_into_itself = 0;
  /// Gaps as `gap`, at yaws that are evenly spread over a full turn from 0 on [yaw][cell] [m];
  /// empty unless `turns_underside`.
  std::vector<float> turned_gap;
  /// Slopes at which `lowest` is tabulated (`slope_lines`); empty without a trained tilt [1].
  std::vector<double> slopes;
  /// Table of `LiveContact::Stance::lowest` over the slopes [slope along y][slope along x] [m].
  std::vector<double> lowest;
  std::vector<SignalError> errors; ///< errors over whole touches first
};

/// True if the skin is trained for rotations about z that change the gaps of its contact cells.
inline bool turns_underside(const SkinData& data) {
  return data.fastest_turn > 0 && data.turns_into_itself == 0;
}

/// Friction law of a trained skin, with another coefficient of friction [1]. Throws where no law
/// has its name or a parameter is unknown.
laws::Friction friction_of(const SkinData& data, double coefficient);

/// Serialises a model into the content of a `.live` file, digest included.
std::string skin_bytes(const SkinData& data);

/// Writes a `.live` file, under a temporary name, then renames it. Throws base::UnwritableFile.
void write_skin(const std::filesystem::path& path, const SkinData& data);

/// Reads and checks the content of a `.live` file. Throws UserError when it is not that of a
/// `.live` file, is damaged, or holds arrays whose sizes do not fit each other.
/// @param path of the file, for messages
SkinData skin_of_bytes(std::string_view bytes, const std::string& path);

/// Reads and checks a `.live` file. Throws UserError when the file cannot be read, is not a `.live`
/// file, is damaged, or holds arrays whose sizes do not fit each other.
SkinData read_skin(const std::filesystem::path& path);

/// True if a file begins like a `.live` file, of any format version and whether complete or not;
/// false if it is not a regular file.
bool is_skin_file(const std::filesystem::path& path);

/// True if forces pressed the slider in the touches on which the errors of a skin were measured,
/// false if heights were held.
bool validated_by_force(const SkinData& data);

} // namespace ionskin::live
