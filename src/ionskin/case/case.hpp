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

// Plain data of one case, SI units throughout. Read, checked and documented by the schema table
// (case/schema/schema.hpp); everything below `case` in the list of folders sees only these structs.

/// Elastic constants of a layer, isotropic and linear.
struct Material {
  std::string name;
  double youngs_modulus = 0; ///< [Pa]
  double poissons_ratio = 0; ///< [1]
  /// Prony series of the shear modulus, which `youngs_modulus` tells of the first instant: the
  /// share of it that each time takes away. Empty where nothing relaxes.
  std::vector<double> relaxation_times;  ///< [s]
  std::vector<double> relaxation_shares; ///< [1]

  bool relaxes() const { return !relaxation_times.empty(); }
};

/// Role of a layer for the ions: they move in the core alone.
enum class LayerRole { electrode, core };

/// One layer of the skin.
struct Layer {
  std::string name;
  LayerRole role = LayerRole::core;
  Material material;
  double thickness = 0; ///< [m]
  /// Sheet resistance of an electrode's metal, of a square along it [ohm]; 0 is a perfect
  /// conductor.
  double sheet_resistance = 0;
};

/// The two faces normal to y: free of traction, or symmetry planes (u_y = 0, no shear traction).
enum class SideCondition { free, symmetry };

/// The layered skin, bonded to a rigid base.
struct Skin {
  double length = 0; ///< along x [m]
  double width = 0;  ///< along y [m]
  SideCondition sides = SideCondition::free;
  double humidity = 0;       ///< relative, of the air around; 0 is not given
  std::vector<Layer> layers; ///< bottom to top; exactly one core

  double thickness() const;       ///< of all layers [m]
  std::size_t core_index() const; ///< index of the ion-conducting layer
  double core_bottom() const;     ///< height of the core's lower face [m]
  double core_thickness() const;  ///< [m]
  double core_volume() const;     ///< [m3]
  /// Sheet resistances of the bottom and of the top electrode [ohm]: layers that have one are in
  /// parallel; 0 where none has.
  std::array<double, 2> sheet_resistances() const;
};

/// A rigid body whose underside presses on the skin.
struct Slider {
  std::string shape = "flat";        ///< a name from the table in shapes/shape.cpp
  laws::LawValues parameters;        ///< of shapes, that of the chosen one among them
  std::array<double, 2> size{};      ///< plan of the underside along x and y [m]
  std::string profile;               ///< absolute path of the height map; empty without one
  shapes::HeightMap profile_heights; ///< heights in that file
  std::array<double, 2> start{};     ///< centre at the start of a cycle, x and y [m]
  double youngs_modulus = 0;         ///< 0 for a rigid slider [Pa]
  double poissons_ratio = 0;         ///< of a soft one [1]
  double pad_thickness = 0;          ///< of the soft layer on a rigid body; 0 for a half-space [m]
  shapes::Pose pose;                 ///< throughout, but for waypoints with angles of their own
  /// True of angles that waypoints change, see settle_pose in case/slider_motion.hpp.
  shapes::ChangingAngles changing;

  bool rigid() const { return youngs_modulus == 0; }
  std::unique_ptr<const shapes::Shape> underside() const { return underside(pose); }
  /// The underside in another pose; the slider must outlive it.
  std::unique_ptr<const shapes::Shape> underside(const shapes::Pose& at) const;
  /// The rectangle along the skin's axes that holds the underside in every pose.
  shapes::Plan plan() const;
  /// Flat with sharp edges: it touches all over its plan at once.
  bool sharp() const;
  /// Half sizes of the part that touches at once; 0 along a round direction [m].
  std::array<double, 2> flat_half_size() const;
  /// True, along x and along y, where the underside is its own mirror image under x -> -x and under
  /// y -> -y.
  std::array<bool, 2> symmetric() const;
};

/// One cycle of touchdown, slide, lift-off and detached return; the same with several strokes back
/// and forth in contact; or any path.
enum class MotionKind { touch_slide_lift, reciprocating, waypoints };

/// A place on the path of the slider, with its height or with the force that holds it there.
struct Waypoint {
  double time = 0;                  ///< since the start of the cycle [s]
  std::array<double, 2> position{}; ///< centre, x and y [m]
  std::optional<double> height;     ///< underside above the undeformed top face [m]
  std::optional<double> force;      ///< normal, on the full skin [N]
  std::size_t line = 0;             ///< in the file it was read from, from 1; 0 in a case
  std::optional<double> roll = {}, pitch = {}, yaw = {}; ///< in place of the slider's [rad]
};

/// Drive that holds the slider along the skin while it touches: a spring and a damper from the path
/// of the motion, which the drive's end follows, to the mass of the slider.
struct Drive {
  double stiffness = 0; ///< 0 where nothing gives [N/m]
  double damping = 0;   ///< [N s/m]
  double mass = 0;      ///< [kg]

  bool given() const { return stiffness > 0; }
  double natural_period() const; ///< of the mass on the spring [s]; 0 without mass
};

/// Motion of the slider, repeated `cycles` times. What it does in one cycle, whatever the kind, is
/// said by motion_legs (case/slider_motion.hpp).
struct Motion {
  MotionKind kind = MotionKind::touch_slide_lift;
  double gap = 0;           ///< initial clearance [m]
  double preload = 0;       ///< indentation while sliding [m]; 0 where a force presses
  double preload_force = 0; ///< on the full skin while sliding [N]; 0 where an indentation is given
  double stroke = 0;        ///< [m]; 0 is a press-and-hold
  std::array<double, 2> direction{1, 0}; ///< unit vector of the slide in the x-y plane
  double touchdown = 0;                  ///< duration [s]
  double slide = 0;                      ///< duration of one stroke [s]
  double lift = 0;                       ///< duration [s]
  double return_ = 0;                    ///< duration [s]
  int cycles = 1;
  // reciprocating
  int strokes = 2;  ///< one way each, back and forth
  double dwell = 0; ///< rest at each reversal [s]
  // waypoints: these alone say what happens, and what stands above is not used but for `cycles`
  std::vector<Waypoint> waypoints; ///< ascending in time
  std::string file; ///< absolute path of the file they were read from; empty for those of the case
  Drive drive;

  bool force_controlled() const { return preload_force > 0; }
  double cycle_duration() const; ///< [s]
};

/// Contact and friction between slider and skin.
struct Contact {
  std::string law = "coulomb"; ///< a name from the table in laws/friction/friction_law.cpp
  double friction = 0;         ///< coefficient [1]
  laws::LawValues parameters;  ///< the law's own
};

/// Ions without size, or ions that take room from one another.
enum class IonModel { dilute, steric, thin_layers };

/// Ions and solvent of the core.
struct Electrochemistry {
  double temperature = 0;                ///< [K]
  double diffusivity = 0;                ///< of the mobile cation [m2/s]
  double permittivity = 0;               ///< effective, absolute [F/m]
  double fixed_charge_concentration = 0; ///< c0 [mol/m3]
  int valence = 1;                       ///< of the mobile cation
  IonModel ion_model = IonModel::dilute;
  double largest_concentration = 0; ///< of the mobile cation, of ion model `steric` [mol/m3]
  /// Capacitance of one electrode's double layer at rest, per projected area [F/m2]; 0 for that
  /// which the permittivity makes of the projected area.
  double interface_capacitance = 0;

  /// Concentration of the mobile cation at rest, c0 / v [mol/m3].
  double resting_concentration() const { return fixed_charge_concentration / valence; }
};

/// Coupling of strain to the charge of the core: a law and its values.
struct Coupling {
  std::string law = "fixed-charge";     ///< a name from the table in laws/coupling/coupling_law.cpp
  double coefficient = 0;               ///< k [1]
  laws::LawValues parameters;           ///< the law's own
  std::string measure = "off-diagonal"; ///< a name from the table in laws/shear/shear_measure.cpp
};

/// Permeability of a wall of the core to water: it lets none through, lets it through freely, or
/// lets through in proportion to what the potentials on both sides differ by.
enum class WaterWall { sealed, open, permeable };

/// Volume in which swelling dilutes the cations: that of the mixture or that of the pore water.
enum class WaterDilution { mixture, pore_water };

/// Water in the core, of coupling laws that move it. What is 0 was not given.
struct Water {
  double drag_number = 0;               ///< n_d: water molecules that a cation drags [1]
  double drained_poissons_ratio = 0;    ///< at constant water potential [1]
  double drained_modulus = 0;           ///< M, oedometric, at constant water potential [Pa]
  double permeability = 0;              ///< at zero current [m2]
  double viscosity = 0;                 ///< of the water in the pores [Pa s]
  double mobility = 0;                  ///< K, permeability over viscosity [m2/(Pa s)]
  double consolidation_coefficient = 0; ///< c_v [m2/s]
  WaterDilution dilution = WaterDilution::mixture;
  double volume_fraction = 0; ///< of water in the core [1]
  WaterWall bottom_wall = WaterWall::sealed, top_wall = WaterWall::sealed;
  double bottom_conductance = 0, top_conductance = 0; ///< of permeable walls [m/(Pa s)]
  double bottom_pressure = 0, top_pressure = 0; ///< of the water outside, above that at rest [Pa]
};

/// Source of the strain of Study 2.
enum class StrainSourceKind { contact, file, prescribed };

/// Waveform of a prescribed load over time: from the first instant on, growing evenly, or swinging.
enum class LoadWaveform { step, ramp, sine };

/// The strain of Study 2: that of the contact, of a file, or prescribed.
struct StrainSource {
  StrainSourceKind kind = StrainSourceKind::contact;
  std::string file; ///< absolute path; empty without one
  // prescribed: a load that is uniform along the skin, one of the three; 0 is not given
  double pressure = 0;    ///< on both faces, positive in compression [Pa]
  double compression = 0; ///< by how much the core is held thinner [m]
  double curvature = 0;   ///< of the skin along x, positive with the top face stretched [1/m]
  LoadWaveform waveform = LoadWaveform::step;
  double rise = 0;      ///< of `ramp`: after it the load is held [s]
  double frequency = 0; ///< of `sine` [Hz]
  double duration = 0;  ///< of the run [s]
};

/// Instead of a circuit of its own: a taxel is part of the one conductor of the electrode.
inline constexpr const char* shared_circuit = "shared";

/// A rectangle of the top electrode with a lead of its own.
struct Taxel {
  std::string name;
  std::array<double, 2> lower{}, upper{}; ///< corners, x and y [m]
  std::string circuit;                    ///< of its own; empty for `Readout::taxel_circuit`
  laws::LawValues parameters;             ///< of it, where they differ from those of the readout
};

/// Leads of the taxels of a grid: one each on the top face, or those of lines that cross, columns
/// on the top face and rows on the bottom one.
enum class TaxelWiring { single, crossbar };

/// Equal taxels over the whole top electrode, instead of a list of them.
struct TaxelGrid {
  int rows = 0, columns = 0; ///< along y and along x; 0 without a grid
  double gap = 0;            ///< between neighbours [m]
  TaxelWiring wiring = TaxelWiring::single;
};

/// Taxels read one row after another, each row by the circuits of its taxels for a while.
struct Scan {
  double dwell = 0;           ///< on a row [s]; 0 for no scan
  bool grounds_others = true; ///< true if taxels that are not read are grounded; open otherwise
};

/// Part of the metal of both electrodes that the leads touch: all over, or at the ends of the skin
/// along x, or at a part of the end at x = 0 that begins at y = 0.
enum class ElectrodeContact { everywhere, one_end, both_ends, corner };

/// Length of a contact at a corner over the width of the skin.
inline constexpr double corner_share = 0.25;

/// Readout: what the electrodes are connected to, and how signals are sampled.
struct Readout {
  double sample_interval = 0;        ///< [s]
  std::string circuit = "short";     ///< a name from the table in circuits/circuit.cpp
  std::string instrument = "ad8605"; ///< a name from the table in circuits/instruments.cpp
  laws::LawValues parameters;        ///< of circuits, that of the chosen one among them
  ElectrodeContact contact = ElectrodeContact::one_end; ///< matters with sheet resistances only
  TaxelGrid taxel_grid;                                 ///< as written
  std::vector<Taxel> taxels; ///< disjoint, those of a grid too; empty for one whole electrode
  /// Circuit of the taxels: `shared_circuit`, or a name from the table of circuits.
  std::string taxel_circuit = shared_circuit;

  /// Circuit of the rows of a crossbar, a name from the table of circuits.
  std::string row_circuit = "short";

  /// True if both electrodes are cut into lines, whose crossings are the taxels.
  bool is_crossbar() const { return taxel_grid.wiring == TaxelWiring::crossbar; }
  /// The lines of a crossbar as rectangles with their circuits: the columns of the top face, c1 to
  /// cN, whose circuit is that of the taxels, then the rows of the bottom face, r1 to rM. Empty
  /// without a crossbar.
  std::vector<Taxel> lines() const;
  /// True if the ground holds every line of a crossbar all the time.
  bool lines_are_held() const;

  /// True if a taxel is a conductor with a circuit of its own, apart from the electrode, or lies
  /// where two such lines cross.
  bool has_own_circuit(std::size_t taxel) const;
  /// True if any taxel has a circuit of its own.
  bool is_cut() const;
  /// The circuit of a taxel, of its column where lines cross, and all its parameters.
  const std::string& circuit_of(std::size_t taxel) const;
  laws::LawValues parameters_of(std::size_t taxel) const;

  Scan scan;
  /// The row that a taxel is read with: that of a grid; of a list every taxel is one.
  std::size_t scan_row(std::size_t taxel) const;
  /// The row that is read at a time since the begin of the run [s].
  std::size_t row_read_at(double time) const;
};

/// Sets of mesh sizes and tolerances.
enum class Preset { coarse, standard, fine };

/// Mesh sizes, tolerances and steps.
struct Numerics {
  Preset preset = Preset::standard;
  double mesh_refinement = 1; ///< divides every mesh size
  double time_refinement = 1; ///< divides every time step
  /// Multiplies the elements through core and top electrode's face beside `mesh_refinement`; no key
  /// of a case, but for the coarser solutions that give the errors.
  double thickness_refinement = 1;
  double time_tolerance = 0;  ///< relative error of the charge per time step; 0: the preset's
  bool error_estimate = true; ///< solve coarser solutions, which give the errors of results
};

/// Output that a run keeps beside signals and metrics.
struct Output {
  std::vector<double> fields; ///< instants at which fields are written [s]
};

/// A slider of a case beside the first one, on the same skin.
struct FurtherSlider {
  Slider slider;
  Motion motion;
  Contact contact;
};

/// One study as plain values in SI units; `read_case` makes it and checks it.
struct Case {
  std::string title;
  Skin skin;
  Slider slider;
  Motion motion;
  Contact contact;
  /// Sliders of a list [[slider]] behind its first entry, which `slider`, `motion` and `contact`
  /// are.
  std::vector<FurtherSlider> further_sliders;
  Electrochemistry electrochemistry;
  Coupling coupling;
  Water water;
  StrainSource strain;
  Readout readout;
  Numerics numerics;
  Output output;
  /// Notes on the case as it is written, for a reader of the results; nothing is computed from it.
  std::vector<std::string> notes;
  std::string text; ///< the TOML text with all `--set` edits applied, as written to case.toml
  /// Every key with its value in SI units, those of defaults and of material presets included.
  std::string values;

  /// True if the potential varies along the metal of an electrode.
  bool has_sheet_resistance() const;
};

/// Largest number of sliders of a case.
inline constexpr std::size_t most_sliders = 4;

/// One case for each slider, in order, in which it is alone on the skin.
std::vector<Case> cases_of_sliders(const Case& input);

/// Between symmetry planes a slider over the whole width, wherever it goes, makes plane strain.
bool covers_width(const Case& input);

} // namespace ionskin
