// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ionskin/laws/law_parameter.hpp"
#include "ionskin/shapes/shape.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace ionskin {

// Plain structs of one case, in SI units throughout. `read_case` (case/reading/read_case.hpp) fills
// and checks them by the schema table (case/schema/schema.hpp). Solvers see only these structs.

/// Isotropic linear elastic constants of the material of a layer, with optional relaxation. With a
/// coupling law that moves water, those of the core are the undrained constants.
struct Material {
  std::string name;
  double youngs_modulus = 0; ///< instantaneous, if the material relaxes [Pa]
  double poissons_ratio = 0; ///< instantaneous, if the material relaxes [1]
  /// Relaxation times of the Prony series of the shear modulus, ascending [s]; empty if the
  /// material does not relax.
  std::vector<double> relaxation_times;
  /// Share of the instantaneous shear modulus that is lost with each relaxation time [1]; as long
  /// as `relaxation_times`, with a sum below 1.
  std::vector<double> relaxation_shares;

  /// True if the material has a Prony series.
  bool relaxes() const { return !relaxation_times.empty(); }
};

/// Role of a layer in the ion transport: ions move only in the core, between electrodes.
enum class LayerRole { electrode, core };

/// One layer of the skin, as an entry of `Skin::layers`.
struct Layer {
  std::string name; ///< unique in the skin
  LayerRole role = LayerRole::core;
  Material material;
  double thickness = 0; ///< [m]
  /// Sheet resistance of the metal of an electrode [ohm], per square along the face; 0 for a
  /// perfect conductor.
  double sheet_resistance = 0;
};

/// Boundary condition on the two faces of the skin that are normal to y: free of traction, or
/// symmetry planes (u_y = 0, no shear traction).
enum class SideCondition { free, symmetry };

/// Geometry and layers of the skin. The lowest face is bonded to a rigid base; one corner of the
/// skin is at x = y = 0.
struct Skin {
  double length = 0; ///< along x [m]
  double width = 0;  ///< along y [m]
  SideCondition sides = SideCondition::free;
  /// Relative humidity of the air with which the skin is in equilibrium [1]; 0 if not given.
  double humidity = 0;
  std::vector<Layer> layers; ///< bottom to top; exactly one core

  double thickness() const; ///< of all layers together [m]
  /// Index of the core in `layers`. Throws InternalError if no layer is a core.
  std::size_t core_index() const;
  double core_bottom() const;    ///< height of the core's lower face above the base [m]
  double core_thickness() const; ///< [m]
  double core_volume() const;    ///< [m3]
  /// Sheet resistances of the bottom electrode and of the top electrode [ohm]. Layers of one
  /// electrode that have a sheet resistance are connected in parallel; 0 if no layer has one.
  std::array<double, 2> sheet_resistances() const;
};

/// The body whose underside presses on the skin: shape, size, pose and, unless it is rigid, elastic
/// constants.
struct Slider {
  std::string shape = "flat"; ///< name of the shape, from the table in shapes/shape.cpp
  /// Parameters of shapes by name [SI], such as "radius": all that the case gives, among them those
  /// of the chosen shape.
  laws::LawValues parameters;
  std::array<double, 2> size{};      ///< of the underside along the slider's own x and y [m]
  std::string profile;               ///< absolute path of the height map file; empty without one
  shapes::HeightMap profile_heights; ///< height map read from `profile`; empty without one
  std::array<double, 2> start{};     ///< centre at the start of a cycle, x and y [m]
  double youngs_modulus = 0;         ///< [Pa]; 0 for a rigid slider
  double poissons_ratio = 0;         ///< of a soft slider [1]
  /// Thickness of a soft layer on a rigid body [m]; 0 for a soft slider that deforms as a
  /// half-space.
  double pad_thickness = 0;
  shapes::Pose pose; ///< angles; at the first waypoint, if waypoints change them
  /// Angles that change along the path; set by `settle_pose` (case/slider_motion.hpp).
  shapes::ChangingAngles changing;

  bool rigid() const { return youngs_modulus == 0; }
  /// The underside in the pose `pose`. The result refers to `profile_heights`: the slider must
  /// outlive it.
  std::unique_ptr<const shapes::Shape> underside() const { return underside(pose); }
  /// The underside in the pose `at`. The result refers to `profile_heights`: the slider must
  /// outlive it.
  std::unique_ptr<const shapes::Shape> underside(const shapes::Pose& at) const;
  /// The rectangle along the skin's axes, centred on the slider, that contains the underside in
  /// every pose of the motion. It refers to `profile_heights`: the slider must outlive it.
  shapes::Plan plan() const;
  /// True if the underside is flat with sharp edges, so that its whole plan touches at once.
  bool sharp() const;
  /// Half sizes, along x and along y, of the part of the underside that touches at once [m]; 0
  /// along a direction in which the underside is round.
  std::array<double, 2> flat_half_size() const;
  /// Symmetry of the underside about its centre: true at index 0 if it is symmetric under x -> -x,
  /// at index 1 if it is symmetric under y -> -y. Both are false if the yaw changes over time.
  std::array<bool, 2> symmetric() const;
};

/// Kind of one cycle of the motion: touchdown, slide, lift-off and detached return; the same cycle
/// with several strokes back and forth in contact; or any path through waypoints.
enum class MotionKind { touch_slide_lift, reciprocating, waypoints };

/// A point of the slider's path in time: its position and either its height or its normal force.
struct Waypoint {
  double time = 0;                  ///< since the start of the cycle [s]
  std::array<double, 2> position{}; ///< centre of the slider, x and y [m]
  std::optional<double> height;     ///< of the underside above the undeformed top face [m]
  std::optional<double> force;      ///< normal force on the full skin [N], if no height is given
  std::size_t line = 0; ///< line of the waypoint file, from 1; 0 for a waypoint of the case file
  /// Angles of the slider at this waypoint [rad]. `settle_pose` fills empty ones from
  /// `Slider::pose`.
  std::optional<double> roll = {}, pitch = {}, yaw = {};
};

/// Compliant drive of the slider along the skin, while it touches. A spring and a damper in
/// parallel connect the slider's mass to a point that follows the path of the motion.
struct Drive {
  double stiffness = 0; ///< [N/m]; 0 without a drive: the slider follows the path itself
  double damping = 0;   ///< [N s/m]
  double mass = 0;      ///< of the slider [kg]; 0 for one without inertia

  bool given() const { return stiffness > 0; } ///< true if the slider is on a drive
  /// Natural period of the mass on the spring [s]; 0 without mass or without a drive.
  double natural_period() const;
};

/// Motion of the slider, repeated `cycles` times. `motion_legs` (case/slider_motion.hpp) turns any
/// kind of motion into the linear legs of one cycle.
struct Motion {
  MotionKind kind = MotionKind::touch_slide_lift;
  double gap = 0;           ///< clearance between slider and skin at the start of a cycle [m]
  double preload = 0;       ///< indentation while sliding [m]; 0 if `preload_force` is given
  double preload_force = 0; ///< normal force on the full skin while sliding [N]; 0 if `preload` is
  double stroke = 0;        ///< length of the slide [m]; 0 presses and holds
  std::array<double, 2> direction{1, 0}; ///< unit vector of the slide in the x-y plane
  double touchdown = 0;                  ///< duration of the descent [s]
  double slide = 0;                      ///< duration of one stroke [s]
  double lift = 0;                       ///< duration of the ascent [s]
  double return_ = 0;                    ///< duration of the detached return to the start [s]
  int cycles = 1;                        ///< number of cycles
  // Members of `reciprocating` only.
  int strokes = 2;  ///< number of one-way strokes, back and forth
  double dwell = 0; ///< rest at each reversal [s]
  // Members of `waypoints` only, which uses none of the members above but `cycles`.
  std::vector<Waypoint> waypoints; ///< ascending in time, the first at 0 s
  std::string file; ///< absolute path of the waypoint file; empty for waypoints of the case file
  Drive drive;      ///< compliant drive along the skin, of any kind of motion

  /// True if strokes are pressed by a force instead of an indentation.
  bool force_controlled() const { return preload_force > 0; }
  double cycle_duration() const; ///< [s]
};

/// Friction law between slider and skin, with its parameters.
struct Contact {
  std::string law = "coulomb"; ///< a name from the table in laws/friction/friction_law.cpp
  double friction = 0;         ///< coefficient of friction [1]
  laws::LawValues parameters;  ///< further parameters of the law by name [SI]
};

/// Model of the mobile cations: point charges (`dilute`); ions of finite size, whose concentration
/// stays below a maximum (`steric`); or double layers as thin capacitors on a conductor
/// (`thin_layers`), a first-order model for the law "poroelastic" only.
enum class IonModel { dilute, steric, thin_layers };

/// Transport properties of the ions in the core.
struct Electrochemistry {
  double temperature = 0;                ///< [K]
  double diffusivity = 0;                ///< of the mobile cation [m2/s]
  double permittivity = 0;               ///< effective permittivity of the core, absolute [F/m]
  double fixed_charge_concentration = 0; ///< c0, of the anions in the unstrained core [mol/m3]
  int valence = 1;                       ///< v, charge number of the mobile cation [1]
  IonModel ion_model = IonModel::dilute;
  /// Upper limit of the cation concentration [mol/m3]; used by the ion model `steric` only.
  double largest_concentration = 0;
  /// Capacitance of the double layer of one electrode at rest, per projected area [F/m2]; 0 for the
  /// capacitance that follows from the permittivity and the projected area.
  double interface_capacitance = 0;

  /// Concentration of the mobile cation at rest, c0 / v [mol/m3].
  double resting_concentration() const { return fixed_charge_concentration / valence; }
};

/// Coupling law by which strain of the core drives its ions, with its parameters.
struct Coupling {
  std::string law = "fixed-charge"; ///< a name from the table in laws/coupling/coupling_law.cpp
  double coefficient = 0;           ///< k [1]; not used by laws that move water
  laws::LawValues parameters;       ///< further parameters of the law by name [SI]
  /// Scalar measure of the shear strain, a name from the table in laws/shear/shear_measure.cpp; not
  /// used by laws that move water.
  std::string measure = "off-diagonal";
};

/// Boundary condition for water at the bottom or top wall of the core: no flux (`sealed`), the
/// potential outside (`open`), or a flux in proportion to the difference of the potentials on both
/// sides (`permeable`), docs/model.md (74).
enum class WaterWall { sealed, open, permeable };

/// Volume in which swelling dilutes the cations: the whole core (polymer and water), or its pore
/// water only, which dilutes them more.
enum class WaterDilution { mixture, pore_water };

/// Properties of the water in the core and at its walls; used only by coupling laws that move
/// water. A value of 0 was not given. Exactly one of `drained_poissons_ratio` and `drained_modulus`
/// is given, and at least one of `permeability`, `mobility` and `consolidation_coefficient`.
struct Water {
  double drag_number = 0;            ///< n_d, electro-osmotic drag: water molecules per cation [1]
  double drained_poissons_ratio = 0; ///< of the core at constant water potential [1]
  double drained_modulus = 0;        ///< M, oedometric modulus at constant water potential [Pa]
  double permeability = 0;           ///< hydraulic permeability of the core at zero current [m2]
  double viscosity = 0;              ///< of the water in the pores [Pa s]
  double mobility = 0;               ///< K, permeability over viscosity [m2/(Pa s)]
  double consolidation_coefficient = 0; ///< c_v, diffusivity of the water pressure [m2/s]
  WaterDilution dilution = WaterDilution::mixture;
  double volume_fraction = 0; ///< of water in the core [1]; needed by `pore_water` dilution
  WaterWall bottom_wall = WaterWall::sealed, top_wall = WaterWall::sealed;
  /// Hydraulic conductances of permeable walls: volume per area, time and pressure [m/(Pa s)].
  double bottom_conductance = 0, top_conductance = 0;
  /// Pressures of the water outside open or permeable walls, relative to the state at rest [Pa].
  double bottom_pressure = 0, top_pressure = 0;
};

/// Source of the strain that drives Study 2: Study 1 (`contact`), a strain file, or a prescribed
/// load that is uniform along the skin.
enum class StrainSourceKind { contact, file, prescribed };

/// Waveform of a prescribed load over time: constant from the first instant (`step`), growing
/// linearly and then held (`ramp`), or sinusoidal (`sine`).
enum class LoadWaveform { step, ramp, sine };

/// The strain that drives Study 2: where it comes from, and the load where it is prescribed.
struct StrainSource {
  StrainSourceKind kind = StrainSourceKind::contact;
  std::string file; ///< absolute path of the strain file; empty without one
  // Members of a prescribed load only. At most one of pressure, compression and curvature is given;
  // the others are 0.
  double pressure = 0;    ///< on both faces, positive in compression [Pa]
  double compression = 0; ///< prescribed decrease of the core's thickness [m]
  double curvature = 0;   ///< of the skin along x, positive with the top face stretched [1/m]
  LoadWaveform waveform = LoadWaveform::step;
  double rise = 0;      ///< time in which the load of a `ramp` grows [s]
  double frequency = 0; ///< of a `sine` [Hz]
  double duration = 0;  ///< of the run [s]
};

/// Circuit name of a taxel that has no circuit of its own: it is part of the one conductor of the
/// top electrode, and has the circuit of that electrode.
inline constexpr const char* shared_circuit = "shared";

/// A taxel: a rectangle of the top electrode with a lead of its own. Also a line of a crossbar, see
/// `Readout::lines`.
struct Taxel {
  std::string name;                       ///< unique; ends the names of the taxel's columns
  std::array<double, 2> lower{}, upper{}; ///< corners with the least and greatest x and y [m]
  std::string circuit; ///< name of its circuit; empty for `Readout::taxel_circuit`
  /// Circuit parameters by name [SI] that replace those of `Readout::parameters` for this taxel.
  laws::LawValues parameters;
};

/// Wiring of a grid of taxels: one lead for each taxel on the top face (`single`), or columns of
/// the top electrode that cross rows of the bottom electrode, with one lead for each line
/// (`crossbar`).
enum class TaxelWiring { single, crossbar };

/// Regular grid of equal taxels over the whole top electrode, instead of a list of taxels.
struct TaxelGrid {
  int rows = 0, columns = 0; ///< numbers of taxels along y and along x; 0 without a grid
  double gap = 0;            ///< bare strip between neighbouring taxels [m]; 0 if they touch
  TaxelWiring wiring = TaxelWiring::single;
};

/// Multiplexed readout: one row of taxels after another is connected to its circuits, for the time
/// `dwell` each.
struct Scan {
  double dwell = 0;           ///< time on each row [s]; 0 reads all taxels all the time
  bool grounds_others = true; ///< true if rows that are not read are grounded, false if open
};

/// Part of the metal of both electrodes that the leads touch: the whole face, the end at x = 0,
/// both ends along x, or the part of the end at x = 0 from y = 0 to `corner_share` times the width.
enum class ElectrodeContact { everywhere, one_end, both_ends, corner };

/// Length of a lead at a corner, `ElectrodeContact::corner`, over the width of the skin [1].
inline constexpr double corner_share = 0.25;

/// Readout: taxels, the circuits that connect the electrodes, and the sampling of the signals.
struct Readout {
  /// Interval of the sampled currents, each of which is the mean current over one interval [s].
  double sample_interval = 0;
  /// Circuit between the two electrodes, a name from the table in circuits/circuit.cpp.
  std::string circuit = "short";
  /// Instrument whose noise is estimated, a name from the table in circuits/instruments.cpp.
  std::string instrument = "ad8605";
  /// White voltage noise [V/sqrt(Hz)] and current noise [A/sqrt(Hz)] at the input, one-sided, and
  /// bits of the converter, instead of those of the named instrument where they are given.
  std::optional<double> instrument_voltage_noise, instrument_current_noise;
  std::optional<int> instrument_bits;
  /// Parameters of circuits by name [SI]: all that the case gives, among them those of the chosen
  /// circuits.
  laws::LawValues parameters;
  /// Part of the electrodes that the leads touch; matters only with sheet resistances.
  ElectrodeContact contact = ElectrodeContact::one_end;
  TaxelGrid taxel_grid;      ///< grid as the case gives it; `taxels` holds its taxels
  std::vector<Taxel> taxels; ///< disjoint, of a list or of the grid; empty for one whole electrode
  /// Circuit between each taxel and the bottom electrode: `shared_circuit`, or a name from the
  /// table of circuits. Of a crossbar, the circuit of every column.
  std::string taxel_circuit = shared_circuit;

  /// Circuit between each row of a crossbar and the ground, a name from the table of circuits.
  std::string row_circuit = "short";

  /// True if both electrodes are cut into lines: columns of the top electrode and rows of the
  /// bottom electrode, whose crossings are the taxels.
  bool is_crossbar() const { return taxel_grid.wiring == TaxelWiring::crossbar; }
  /// The lines of a crossbar as rectangles with their circuits: the columns of the top face, c1 to
  /// cN, then the rows of the bottom face, r1 to rM. Empty without a crossbar or without taxels.
  std::vector<Taxel> lines() const;
  /// True if every line of a crossbar is at ground potential all the time, read or not. Only for a
  /// crossbar with taxels.
  bool lines_are_held() const;

  /// True if the taxel of this index is a conductor of its own, with a circuit of its own, or the
  /// crossing of two lines of a crossbar; false if it is part of one conductor with other taxels.
  bool has_own_circuit(std::size_t taxel) const;
  /// True if any taxel has a circuit of its own.
  bool is_cut() const;
  /// Name of the circuit of the taxel of this index; of a crossbar, of its column. It is `circuit`
  /// for a taxel without a circuit of its own.
  const std::string& circuit_of(std::size_t taxel) const;
  /// Circuit parameters of the taxel of this index by name [SI]: `parameters`, replaced by those
  /// that the taxel gives itself.
  laws::LawValues parameters_of(std::size_t taxel) const;

  Scan scan; ///< multiplexing of the taxels; its `dwell` is 0 without one
  /// Index of the row with which the taxel of this index is read: its row in a grid, or the index
  /// itself in a list of taxels, each of which is a row of its own.
  std::size_t scan_row(std::size_t taxel) const;
  /// Index of the row that a scan reads at a time since the start of the run [s]. Only with taxels
  /// and with `scan.dwell` above 0.
  std::size_t row_read_at(double time) const;
};

/// Set of mesh sizes and tolerances, by the accuracy it aims at: a first look (`coarse`), 1 %
/// (`standard`), or 0.25 % (`fine`).
enum class Preset { coarse, standard, fine };

/// Resolution of the solvers: a preset and factors that refine it.
struct Numerics {
  Preset preset = Preset::standard;
  double mesh_refinement = 1; ///< divides every mesh size of the preset [1]
  double time_refinement = 1; ///< divides every time step of the preset [1]
  /// Multiplies, beside `mesh_refinement`, the numbers of elements through the core and in the face
  /// of the top electrode [1]. No key of a case: only coarser solutions for error estimates set it.
  double thickness_refinement = 1;
  /// Error of the charge that one time step may add, relative to the largest charge so far [1]; 0
  /// for the tolerance of the preset.
  double time_tolerance = 0;
  bool error_estimate = true; ///< true if coarser solutions are computed to estimate errors
};

/// Output that a run writes in addition to signals and metrics.
struct Output {
  std::vector<double> fields; ///< instants at which fields are written [s]; empty for none
};

/// One more slider on the same skin, beside the first slider of a case, with its motion and its
/// friction law.
struct FurtherSlider {
  Slider slider;
  Motion motion;
  Contact contact;
};

/// All input of one run as plain values in SI units. `read_case` (case/reading/read_case.hpp) makes
/// and checks it.
struct Case {
  std::string title; ///< for reports
  Skin skin;
  Slider slider;
  Motion motion;
  Contact contact;
  /// The second and later sliders of a list [[slider]] in the case file; empty for a single slider.
  /// `slider`, `motion` and `contact` hold the first one.
  std::vector<FurtherSlider> further_sliders;
  Electrochemistry electrochemistry;
  Coupling coupling;
  Water water;
  StrainSource strain;
  Readout readout;
  Numerics numerics;
  Output output;
  /// Remarks on how the case is written, such as keys without effect, one or more sentences each,
  /// for a reader of the results; no result depends on them.
  std::vector<std::string> notes;
  std::string text; ///< the TOML text with all `--set` edits applied, as written to case.toml
  /// Every key with its value in SI units, one "key = value" a line, with defaults and values of
  /// material presets.
  std::string values;

  /// True if the potential varies along the metal of an electrode: it has a sheet resistance, and
  /// the leads do not touch it everywhere.
  bool has_sheet_resistance() const;
};

/// Largest number of sliders of a case, the first one included.
inline constexpr std::size_t most_sliders = 4;

/// Splits a case of several sliders into one case for each slider, in order, with only that slider
/// on the skin. A case of one slider gives one copy.
std::vector<Case> cases_of_sliders(const Case& input);

/// True if the deformation is plane strain: the sides of the skin are symmetry planes, and the
/// first slider covers the whole width of the skin at every position of its path.
bool covers_width(const Case& input);

} // namespace ionskin
