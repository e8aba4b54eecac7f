// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/reading/read_case.hpp"

#include "ionskin/base/error.hpp"
#include "temporary_case.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace ionskin {
namespace {

TEST(ReadCase, FillsTheStructsInSiUnits) {
  const TemporaryCase file(valid_case());
  const Case input = read_case(file.path());
  EXPECT_EQ(input.title, "A touch");
  EXPECT_DOUBLE_EQ(input.skin.length, 0.015);
  EXPECT_EQ(input.skin.sides, SideCondition::free);
  ASSERT_EQ(input.skin.layers.size(), 3U);
  EXPECT_EQ(input.skin.layers[1].name, "ionomer");
  EXPECT_EQ(input.skin.core_index(), 1U);
  EXPECT_EQ(input.skin.layers[0].material.name, "platinum");
  EXPECT_DOUBLE_EQ(input.skin.layers[0].material.youngs_modulus, 168e9);
  EXPECT_DOUBLE_EQ(input.skin.layers[1].material.poissons_ratio, 0.49);
  EXPECT_DOUBLE_EQ(input.slider.size[1], 0.0015);
  EXPECT_DOUBLE_EQ(input.slider.start[0], 0.0045);
  EXPECT_DOUBLE_EQ(input.motion.preload, 1e-6);
  EXPECT_EQ(input.motion.cycles, 1);
  EXPECT_DOUBLE_EQ(input.motion.cycle_duration(), 4);
  EXPECT_EQ(input.contact.friction, 0.3);
  EXPECT_DOUBLE_EQ(input.electrochemistry.temperature, 293.15);
  EXPECT_EQ(input.electrochemistry.valence, 1);
  EXPECT_EQ(input.coupling.law, "fixed-charge");
  EXPECT_EQ(input.strain.kind, StrainSourceKind::contact);
  EXPECT_DOUBLE_EQ(input.readout.sample_interval, 0.01);
  EXPECT_EQ(input.numerics.preset, Preset::standard);
  EXPECT_TRUE(input.output.fields.empty());
  EXPECT_EQ(input.text, valid_case());
}

TEST(ReadCase, PreloadIsAnIndentationOrAForce) {
  const TemporaryCase file(valid_case("preload = \"1 um\"", "preload = \"250 mN\""));
  const CaseDocument document = read_case_document(file.path());
  EXPECT_TRUE(document.input.motion.force_controlled());
  EXPECT_DOUBLE_EQ(document.input.motion.preload_force, 0.25);
  EXPECT_EQ(document.input.motion.preload, 0);
  EXPECT_EQ(document.find("motion.preload")->si, "0.25 N");
  const Case pressed = read_case(file.path(), {"motion.preload=2 um"});
  EXPECT_FALSE(pressed.motion.force_controlled());
  EXPECT_DOUBLE_EQ(pressed.motion.preload, 2e-6);
}

TEST(ReadCase, ASphereWithoutAPlanHasItsDiameter) {
  const TemporaryCase file(
      valid_case("size = [\"3 mm\", \"1.5 mm\"]", "shape = \"sphere\"\nradius = \"8 mm\""));
  const Case input = read_case(file.path());
  EXPECT_DOUBLE_EQ(input.slider.size[0], 0.016);
  EXPECT_DOUBLE_EQ(input.slider.size[1], 0.016);
  EXPECT_FALSE(input.slider.sharp());
}

TEST(ReadCase, AProfileComesFromATableBesideTheCase) {
  const TemporaryCase file(
      valid_case("[slider]", "[slider]\nshape = \"profile\"\nprofile = \"map.csv\""));
  std::ofstream(file.folder() + "/map.csv") << "mm, -2, 0, 2\n-1, 0.2, 0, 0.4\n1, 0.2, 0, 0.4\n";
  const Case input = read_case(file.path());
  const shapes::HeightMap& map = input.slider.profile_heights;
  EXPECT_EQ(map.x.size(), 3U);
  EXPECT_DOUBLE_EQ(map.interpolated(-1e-3, 0.3e-3), 0.1e-3);
  EXPECT_DOUBLE_EQ(map.interpolated(1e-3, 1e-3), 0.2e-3);
  EXPECT_EQ(input.slider.symmetric(), (std::array<bool, 2>{false, true}));
  EXPECT_THAT(input.text, testing::HasSubstr("profile = \"" + file.folder() + "/map.csv\""));
}

TEST(ReadCase, ABadHeightMapIsRefusedWithItsLine) {
  const TemporaryCase file(
      valid_case("[slider]", "[slider]\nshape = \"profile\"\nprofile = \"map.csv\""));
  const auto message = [&](const std::string& table) -> std::string {
    std::ofstream(file.folder() + "/map.csv") << table;
    try {
      read_case(file.path());
    } catch (const UserError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(message("mm,-2,2\n-1,0,0\n-1,0,0\n"),
              testing::HasSubstr("y must ascend\n  in its line 3"));
  EXPECT_THAT(message("mm,-2,2\n-1,0\n"),
              testing::HasSubstr("2 values instead of y and 2 heights"));
  EXPECT_THAT(message("-2,2,4\n-1,0,0\n"), testing::HasSubstr("line 1"));
  EXPECT_THAT(message("mm,-2,2\n-1,0,x\n"),
              testing::HasSubstr("\"x mm\" does not begin with a number"));
  EXPECT_THAT(message("mm,-1,1\n-1,0,0\n1,0,0\n"), testing::HasSubstr("less than slider.size"));
}

TEST(ReadCase, AppliesEditsAndKeepsTheRest) {
  const TemporaryCase file(valid_case());
  const Case input =
      read_case(file.path(), {"contact.friction=0.05", "motion.stroke=3 mm",
                              "coupling.law=column-neutral", "output.fields=[\"0.5 s\"]",
                              "skin.layers[1].thickness=0.1 mm", "numerics.preset=fine"});
  EXPECT_EQ(input.contact.friction, 0.05);
  EXPECT_DOUBLE_EQ(input.motion.stroke, 0.003);
  EXPECT_EQ(input.coupling.law, "column-neutral");
  EXPECT_EQ(input.output.fields, std::vector<double>{0.5});
  EXPECT_DOUBLE_EQ(input.skin.core_thickness(), 1e-4);
  EXPECT_EQ(input.numerics.preset, Preset::fine);
  EXPECT_THAT(input.text, testing::HasSubstr("friction = 0.05 # a comment"));

  const TemporaryCase again(input.text);
  EXPECT_EQ(read_case(again.path()).text, input.text);
}

TEST(ReadCase, ValuesRememberWhereTheyCameFrom) {
  const TemporaryCase file(valid_case());
  const CaseDocument document = read_case_document(
      file.path(), {"contact.friction=0.05", "materials.nafion.poissons_ratio=0.4"});
  const auto origin = [&](const std::string& key) { return document.find(key)->origin; };
  EXPECT_EQ(origin("contact.friction"), ValueOrigin::set_edit);
  EXPECT_EQ(origin("skin.length"), ValueOrigin::file);
  EXPECT_EQ(origin("readout.sample_interval"), ValueOrigin::default_value);
  EXPECT_EQ(origin("materials.nafion.poissons_ratio"), ValueOrigin::set_edit);
  EXPECT_EQ(origin("materials.nafion.youngs_modulus"), ValueOrigin::preset);
  EXPECT_EQ(document.find("skin.length")->place->line, 4U);
  EXPECT_EQ(document.find("skin.length")->si, "0.015 m");
  EXPECT_EQ(document.input.skin.layers[1].material.poissons_ratio, 0.4);
  EXPECT_DOUBLE_EQ(document.input.skin.layers[1].material.youngs_modulus, 249e6);
  EXPECT_EQ(document.find("contact.colour"), nullptr);
}

/// A case that says nothing of its ions but their permittivity.
std::string without_ions(const std::string& core, const std::string& tables = "") {
  std::string text = valid_case("\"nafion\"", "\"" + core + "\"");
  for (const std::string line :
       {"diffusivity = \"7e-11 m2/s\"\n", "fixed_charge_concentration = \"1200 mol/m3\"\n"})
    text.erase(text.find(line), line.size());
  return text + tables;
}

TEST(ReadCase, MaterialOfTheCoreHasItsIons) {
  const TemporaryCase file(without_ions("nafion_wet"));
  const CaseDocument document = read_case_document(file.path());
  const Electrochemistry& ions = document.input.electrochemistry;
  EXPECT_EQ(ions.valence, 1);
  EXPECT_EQ(document.find("electrochemistry.diffusivity")->origin, ValueOrigin::preset);
  EXPECT_EQ(document.find("electrochemistry.valence")->origin, ValueOrigin::preset);
  // The preset rests on this conductivity: 8.2 S/m at 25 degC, by the relation of Nernst and
  // Einstein.
  const double faraday = 96485.33, thermal_energy = 8.314463 * 298.15;
  const double conductivity =
      faraday * faraday * ions.diffusivity * ions.fixed_charge_concentration / thermal_energy;
  EXPECT_NEAR(conductivity, 8.2, 0.1);
}

TEST(ReadCase, MaterialOfTheCoreHasItsWaterWhereTheLawMovesIt) {
  const TemporaryCase dry(valid_case("\"nafion\"", "\"nafion_wet\""));
  EXPECT_EQ(read_case_document(dry.path()).find("water.drag_number"), nullptr);
  std::string text = valid_case("\"nafion\"", "\"nafion_wet\"");
  text.replace(text.find("coefficient = 0.1"), 17,
               "law = \"poroelastic\"\n[water]\ndrained_poissons_ratio = 0.4\n"
               "permeability = \"1e-19 m2\"\ndilution = \"pore-water\"\n");
  const TemporaryCase wet(text);
  const CaseDocument document = read_case_document(wet.path());
  EXPECT_EQ(document.find("water.drag_number")->origin, ValueOrigin::preset);
  EXPECT_DOUBLE_EQ(document.input.water.drag_number, 2.5);
  EXPECT_DOUBLE_EQ(document.input.water.volume_fraction, 0.417);
}

TEST(ReadCase, IonsOfTheCaseComeFirst) {
  const TemporaryCase file(valid_case("\"nafion\"", "\"nafion_wet\""));
  const CaseDocument document = read_case_document(file.path(), {"electrochemistry.valence=2"});
  EXPECT_DOUBLE_EQ(document.input.electrochemistry.diffusivity, 7e-11);
  EXPECT_DOUBLE_EQ(document.input.electrochemistry.fixed_charge_concentration, 1200);
  EXPECT_EQ(document.input.electrochemistry.valence, 2);
  EXPECT_EQ(document.find("electrochemistry.diffusivity")->origin, ValueOrigin::file);
}

TEST(ReadCase, MaterialsOfTheCaseMayHaveIonsToo) {
  const std::string gel = "[materials.gel]\nyoungs_modulus = \"1 MPa\"\npoissons_ratio = 0.4\n"
                          "diffusivity = \"1e-9 m2/s\"\nfixed_charge_concentration = \"0.5 "
                          "mol/L\"\nvalence = 2\n";
  const TemporaryCase file(without_ions("gel", gel));
  const CaseDocument document = read_case_document(file.path());
  EXPECT_EQ(document.input.skin.layers[1].material.name, "gel");
  EXPECT_DOUBLE_EQ(document.input.electrochemistry.diffusivity, 1e-9);
  EXPECT_DOUBLE_EQ(document.input.electrochemistry.resting_concentration(), 250);
  EXPECT_EQ(document.find("electrochemistry.valence")->origin, ValueOrigin::file);
}

TEST(ReadCase, BadIonsOfAMaterialAreNotMissingToo) {
  const std::string message =
      error_of(without_ions("nafion_wet", "[materials.nafion_wet]\ndiffusivity = \"1 mm\"\n"));
  EXPECT_THAT(message, testing::HasSubstr(
                           "materials.nafion_wet.diffusivity: \"1 mm\" has the wrong dimension"));
  EXPECT_THAT(message, testing::Not(testing::HasSubstr("missing key")));
}

TEST(ReadCase, MistakesInEditsPointAtTheEdit) {
  const TemporaryCase file(valid_case());
  const auto message = [&](const std::string& edit) -> std::string {
    try {
      read_case(file.path(), {"numerics.preset=coarse", edit});
    } catch (const UserError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(message("contact.friction=-1"), testing::HasSubstr("--set contact.friction=-1\n"));
  EXPECT_THAT(message("contact.frction=1"), testing::HasSubstr("did you mean contact.friction?"));
  EXPECT_THAT(message("contact.frction=1"), testing::HasSubstr("--set contact.frction=1\n"));
  EXPECT_THAT(message("contact.friction_coefficient=1"),
              testing::HasSubstr("did you mean contact.friction?"));
  EXPECT_THAT(message("contact.friction_law=coulomb"),
              testing::HasSubstr("did you mean contact.law?"));
  EXPECT_THAT(message("materials.nafion.elastic_youngs_modulus=1 GPa"),
              testing::HasSubstr("did you mean materials.nafion.youngs_modulus?"));
  EXPECT_THAT(message("skin.core_thickness=80 um"),
              testing::HasSubstr("did you mean skin.layers[].thickness?"));
  // Two places: the edit, and the line of the file that it conflicts with.
  EXPECT_THAT(message("motion.stroke=10 mm"),
              testing::AllOf(testing::HasSubstr("--set motion.stroke=10 mm\n"),
                             testing::HasSubstr("case.toml:4:10\n")));
}

TEST(ReadCase, NormalisesTheDirection) {
  const TemporaryCase file(
      valid_case("stroke = \"6 mm\"", "stroke = \"0.3 mm\"\ndirection = [3, -4.0]"));
  const Case input = read_case(file.path());
  EXPECT_DOUBLE_EQ(input.motion.direction[0], 0.6);
  EXPECT_DOUBLE_EQ(input.motion.direction[1], -0.8);
}

TEST(ReadCase, PlaneStrainChecksXOnly) {
  const std::string symmetric =
      valid_case("width = \"2 mm\"", "width = \"2 mm\"\nsides = \"symmetry\"");
  const TemporaryCase file(symmetric);
  EXPECT_NO_THROW(read_case(file.path(), {"slider.size[1]=3 mm"}));
  EXPECT_THROW(read_case(file.path(), {"slider.size[1]=3 mm", "motion.stroke=12 mm"}), UserError);
  EXPECT_THROW(read_case(file.path(), {"slider.size[1]=3 mm", "skin.sides=free"}), UserError);
  EXPECT_NO_THROW(read_case(file.path(), {"slider.size[1]=2 mm", "skin.sides=free"}));
}

TEST(ReadCase, StrainFileNeedsNoContact) {
  std::string text =
      valid_case("[coupling]", "[strain]\nsource = \"file\"\nfile = \"s.h5\"\n[coupling]");
  const std::size_t slider = text.find("[slider]");
  text.erase(slider, text.find("[electrochemistry]") - slider);
  for (std::size_t line = text.find("material ="); line != std::string::npos;
       line = text.find("material ="))
    text.erase(line, text.find('\n', line) + 1 - line);
  const TemporaryCase file(text);
  std::ofstream(file.folder() + "/s.h5") << "any";
  const Case input = read_case(file.path());
  EXPECT_EQ(input.strain.kind, StrainSourceKind::file);
  EXPECT_EQ(input.strain.file, file.folder() + "/s.h5");
  EXPECT_DOUBLE_EQ(input.skin.core_thickness(), 180e-6);
  // The written case runs from any folder.
  EXPECT_THAT(input.text, testing::HasSubstr("file = \"" + file.folder() + "/s.h5\""));
}

TEST(ReadCase, StrainFileNeedsTheCoreWhereWaterMoves) {
  std::string text =
      valid_case("coefficient = 0.1", "law = \"poroelastic\"\n[water]\ndrag_number = 2.5\n"
                                      "drained_poissons_ratio = 0.4\n"
                                      "mobility = \"2e-19 m2/(Pa s)\"\n"
                                      "[strain]\nsource = \"file\"\nfile = \"s.h5\"\n");
  const TemporaryCase file(text);
  std::ofstream(file.folder() + "/s.h5") << "any";
  const Skin skin = read_case(file.path()).skin;
  EXPECT_GT(skin.layers[skin.core_index()].material.poissons_ratio, 0.4);
  for (std::size_t line = text.find("material ="); line != std::string::npos;
       line = text.find("material ="))
    text.erase(line, text.find('\n', line) + 1 - line);
  EXPECT_THAT(error_of(text), testing::HasSubstr("missing key skin.layers[1].material"));
}

TEST(ReadCase, ReadsWindowsLineEnds) {
  std::string text;
  for (const char letter : valid_case())
    text += letter == '\n' ? std::string("\r\n") : std::string(1, letter);
  const TemporaryCase file(text);
  EXPECT_EQ(read_case(file.path(), {"contact.law=coulomb"}).contact.friction, 0.3);
}

} // namespace
} // namespace ionskin
