// SPDX-License-Identifier: Apache-2.0
#include "temporary_case.hpp"

#include "ionskin/base/error.hpp"
#include "ionskin/case/reading/read_case.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <ostream>

namespace ionskin {
namespace {

using testing::HasSubstr;

/// One mistake in the valid case, and what the message must hold.
struct Mistake {
  std::string name;
  std::string replace, with;
  std::string what;
  std::string place;  ///< "line:column" of the caret
  std::string marked; ///< the line in the excerpt with its carets below
  std::string remedy;
};

std::ostream& operator<<(std::ostream& stream, const Mistake& mistake) {
  return stream << mistake.name;
}

class BadCase : public testing::TestWithParam<Mistake> {};

TEST_P(BadCase, SaysWhatWhereAndRemedy) {
  const Mistake& mistake = GetParam();
  const std::string message = error_of(valid_case(mistake.replace, mistake.with));
  EXPECT_THAT(message, HasSubstr(mistake.what));
  EXPECT_THAT(message, HasSubstr("case.toml:" + mistake.place + "\n"));
  EXPECT_THAT(message, HasSubstr(mistake.marked));
  EXPECT_THAT(message, HasSubstr(mistake.remedy));
}

INSTANTIATE_TEST_SUITE_P(
    SingleKeys, BadCase,
    testing::Values(
        Mistake{"UnknownKey", "friction = 0.3", "friction = 0.3\ncolour = \"red\" #",
                "unknown key contact.colour", "40:1",
                "40 | colour = \"red\" # # a comment\n    | ^^^^^^\n",
                "keys of contact: law, friction"},
        Mistake{"UnknownSection", "[coupling]", "[chassis]\nload = 3\n[coupling]",
                "unknown section chassis", "46:1", "^^^^^^^^^", "sections of a case: title, skin"},
        Mistake{"MisspeltKey", "friction = 0.3", "frction = 0.3", "unknown key contact.frction",
                "39:1", "39 | frction = 0.3 # a comment\n    | ^^^^^^^\n",
                "did you mean contact.friction?"},
        Mistake{"MisspeltSection", "[contact]", "[contat]", "unknown section contat", "38:1",
                "38 | [contat]\n    | ^^^^^^^^", "did you mean contact?"},
        Mistake{"KeyInTheWrongSection", "[contact]\nfriction = 0.3", "friction = 0.3\n[contact]",
                "unknown key motion.friction", "38:1", "^^^^^^^^",
                "did you mean contact.friction?"},
        Mistake{"MissingUnit", "length = \"15 mm\"", "length = 15", "skin.length has no unit: 15",
                "4:10", "4 | length = 15\n   |          ^^\n", "such as \"15 mm\""},
        Mistake{"MissingUnitOfASmallNumber", "length = \"15 mm\"", "length = 1e-6",
                "1e-06 is a bare number", "4:10", "^^^^", "such as \"1e-06 m\""},
        Mistake{"MissingUnitOfATemperature", "fixed_charge_concentration = \"1200 mol/m3\"",
                "temperature = 293.15\nfixed_charge_concentration = \"1200 mol/m3\"",
                "293.15 is a bare number", "44:15", "^^^^^^", "such as \"293.15 K\""},
        Mistake{"MissingUnitOfATemperatureInCelsius",
                "fixed_charge_concentration = \"1200 mol/m3\"",
                "temperature = 20\nfixed_charge_concentration = \"1200 mol/m3\"",
                "20 is a bare number", "44:15", "^^", "such as \"20 degC\""},
        Mistake{"MissingUnitOfAConcentration", "fixed_charge_concentration = \"1200 mol/m3\"",
                "fixed_charge_concentration = 1200", "1200 is a bare number", "44:30", "^^^^",
                "such as \"1200 mol/m3\""},
        Mistake{"MissingUnitInText", "length = \"15 mm\"", "length = \"15\"",
                "missing unit in \"15\"", "4:10", "^^^^", "units of a length: mm"},
        Mistake{"UnknownUnit", "slide = \"2 s\"", "slide = \"2 sce\"", "unknown unit \"sce\"",
                "34:9", "^^^^^^^", "units of a time: s, ms"},
        Mistake{"WrongDimension", "width = \"2 mm\"", "width = \"2 s\"", "wrong dimension", "5:9",
                "5 | width = \"2 s\"\n   |         ^^^^^\n",
                "expected a length such as \"mm\", got a time"},
        Mistake{"NegativeThickness", "thickness = \"180 um\"", "thickness = \"-180 um\"",
                "skin.layers[1].thickness = \"-180 um\" (-0.00018 m) is out of range", "17:13",
                "^^^^^^^^^", "at least 1e-09 m"},
        Mistake{"IncompressibleCore", "[slider]",
                "[materials.nafion]\npoissons_ratio = 0.5\n[slider]",
                "materials.nafion.poissons_ratio = 0.5 is out of range", "26:18", "^^^",
                "needs a mixed formulation"},
        Mistake{"ZeroDuration", "lift = \"0.5 s\"", "lift = \"0 s\"",
                "motion.lift = \"0 s\" is out of range", "35:8", "^^^^^", "at least 1e-06 s"},
        Mistake{"FrictionOfTooMuchSpeed", "friction = 0.3",
                "friction = 0.3\nlaw = \"viscous\"\nreference_speed = \"0.1 mm/s\" #",
                "at 3 mm/s, the fastest of the motion, contact.law = \"viscous\" has a coefficient "
                "of friction of 9; at most 2 is allowed",
                "40:7", "40 | law = \"viscous\"\n", "or the speed of the motion"},
        Mistake{"UnknownChoice", "coefficient = 0.1", "coefficient = 0.1\nlaw = \"fixd-charge\"",
                "coupling.law = \"fixd-charge\" is unknown", "48:7", "^^^^^^^^^^^^^",
                "did you mean \"fixed-charge\"?"},
        Mistake{"NumberInQuotes", "friction = 0.3", "friction = \"0.3\"",
                "contact.friction = \"0.3\" is not a number", "39:12", "^^^^^", "without quotes"},
        Mistake{"NotFinite", "coefficient = 0.1", "coefficient = nan", "out of range", "47:15",
                "^^^", "at most 1000000"},
        Mistake{"NotAnInteger", "stroke = \"6 mm\"", "stroke = \"6 mm\"\ncycles = 2.5",
                "motion.cycles = 2.5 is not an integer", "33:10", "^^^", "whole number"},
        Mistake{"NotAPair", "size = [\"3 mm\", \"1.5 mm\"]", "size = [\"3 mm\"]", "is not a pair",
                "26:8", "^^^^^^^^", "along x and along y"},
        Mistake{"EntryOfAPair", "\"1.5 mm\"]", "1.5]", "slider.size has no unit: 1.5", "26:17",
                "^^^", "\"1.5 m\"; units of a length: mm"},
        Mistake{"SectionIsAValue", "title = \"A touch\"", "title = \"A touch\"\nnumerics = 3",
                "numerics must be a table", "2:12", "^", "write a section [numerics]"}),
    [](const auto& instance) { return instance.param.name; });

INSTANTIATE_TEST_SUITE_P(
    BetweenKeys, BadCase,
    testing::Values(
        Mistake{
            "SliderOffTheSkinAtTheEnd", "stroke = \"6 mm\"", "stroke = \"10 mm\"",
            "not inside the skin at the end of the slide: it reaches from 13 mm to 16 mm along x",
            "32:10", "^^^^^^^ travel", "above 1.5 mm and below 3.5 mm along x"},
        Mistake{"SliderOffTheSkinAtTheStart", "start = [\"4.5 mm\", \"1 mm\"]",
                "start = [\"4.5 mm\", \"0.5 mm\"]", "not inside the skin at the start of the slide",
                "27:9", "centre at the start", "above 0.75 mm and below 1.25 mm along y"},
        Mistake{"SliderLargerThanTheSkin", "size = [\"3 mm\", \"1.5 mm\"]",
                "size = [\"10 mm\", \"1.5 mm\"]", "not inside the skin", "4:10", "^^^^^^^ the skin",
                "need more than 16 mm of the 15 mm"},
        Mistake{"EdgesRounderThanTheSlider", "[motion]", "edge_radius = \"1 mm\"\n[motion]",
                "more than half the slider's smaller side", "29:15", "^^^^^^", "at most 0.75 mm"},
        Mistake{"RadiusOfAFlatSlider", "[motion]", "radius = \"1 mm\"\n[motion]",
                "slider.radius does not belong to this shape", "29:10", "^^^^^^",
                "\"cylinder\" or \"sphere\""},
        Mistake{"PadOfARigidSlider", "[motion]", "pad_thickness = \"1 mm\"\n[motion]",
                "slider.pad_thickness is given, but the slider is rigid", "29:17", "^^^^^^",
                "give slider.youngs_modulus, or remove it"},
        Mistake{"PoissonsRatioOfARigidSlider", "[motion]", "poissons_ratio = 0.4\n[motion]",
                "slider.poissons_ratio is given, but the slider is rigid", "29:18", "^^^",
                "give slider.youngs_modulus, or remove it"},
        Mistake{"SofterThanAnything", "[motion]", "youngs_modulus = \"1 Pa\"\n[motion]",
                "slider.youngs_modulus", "29:18", "^^^^^^", "100 Pa"},
        Mistake{"RoundWithoutRadius", "[slider]", "[slider]\nshape = \"sphere\"",
                "missing key slider.radius", "25:1", "^^^^^^^^", "a length such as"},
        Mistake{"LongerThanItsDiameter", "[slider]",
                "[slider]\nshape = \"cylinder\"\nradius = \"1 mm\"",
                "more than the diameter of 2 mm", "28:8", "^^^^^^^^", "at most 2 mm"},
        Mistake{"TwoCores", "role = \"electrode\"", "role = \"core\"",
                "the skin has 2 layers with role = \"core\"", "9:8", "^^^^^^", "exactly one core"},
        Mistake{"NoCore", "role = \"core\"", "role = \"electrode\"",
                "the skin has 0 layers with role = \"core\"", "15:8", "^^^^^^^^^^^",
                "exactly one core"},
        Mistake{"TwinNames", "name = \"top electrode\"", "name = \"bottom electrode\"",
                "two layers have the name \"bottom electrode\"", "8:8", "second",
                "a name of its own"},
        Mistake{"UnknownMaterial", "material = \"nafion\"", "material = \"nafoin\"",
                "unknown material \"nafoin\"", "16:12", "^^^^^^^^", "did you mean \"nafion\"?"},
        Mistake{"PreloadThroughTheSkin", "preload = \"1 um\"", "preload = \"0.2 mm\"",
                "reaches through the skin", "31:11", "^^^^^^^^", "below 0.2 mm"},
        Mistake{"PreloadOfNoForceAndNoLength", "preload = \"1 um\"", "preload = \"1 s\"",
                "expected a length such as \"mm\", got a time", "31:11", "^^^^^",
                "units of a length: mm, um, nm, cm, m; units of a force: N, mN, kN"},
        Mistake{
            "PreloadWithoutAUnit", "preload = \"1 um\"", "preload = 2",
            "2 is a bare number, expected a length or a force", "31:11", "^",
            "such as \"2 m\" or \"2 N\"; units of a length: mm, um, nm, cm, m; units of a force"},
        Mistake{"PreloadForceOfZero", "preload = \"1 um\"", "preload = \"0 N\"",
                "motion.preload = \"0 N\" is out of range", "31:11", "^^^^^", "at least 1e-12 N"},
        Mistake{"DirectionWithoutLength", "stroke = \"6 mm\"",
                "stroke = \"6 mm\"\ndirection = [0, 0.0]", "motion.direction has no length",
                "33:13", "^^^^^^^^", "must differ from 0"},
        Mistake{"SampleIntervalTooLong", "[coupling]",
                "[readout]\nsample_interval = \"5 s\"\n[coupling]", "longer than the run of 4 s",
                "47:19", "^^^^^", "at most 4 s"},
        Mistake{"AmplifierWithoutItsCircuit", "[coupling]",
                "[readout]\namplifier_range = \"1 mA\"\n[coupling]",
                "readout.amplifier_range is given, but the circuit has none", "47:19", "^^^^^^",
                "set readout.circuit = \"amplifier\""},
        Mistake{"TaxelGridWithoutColumns", "[coupling]",
                "[readout]\ntaxels = {rows = 2}\n[coupling]",
                "missing key readout.taxels.columns of the grid of taxels", "47:18", "^",
                "a grid has both: taxels = {rows = 2, columns = 4}"},
        Mistake{"TaxelGridWithoutRoom", "[coupling]",
                "[readout]\ntaxels = {rows = 3, columns = 1, gap = \"1 mm\"}\n[coupling]",
                "the gaps leave no room for the taxels along y: 2 of 1 mm on 2 mm", "47:40",
                "^^^^^^", "it must be below 1 mm"},
        Mistake{"TaxelCircuitWithoutTaxels", "[coupling]",
                "[readout]\ntaxel_circuit = \"open\"\n[coupling]",
                "readout.taxel_circuit is given, but the case has no taxels", "47:17", "^^^^^^",
                "or remove the key"},
        Mistake{"AmplifierOfACutElectrode", "[coupling]",
                "[readout]\ncircuit = \"amplifier\"\ntaxel_circuit = \"open\"\ntaxels = {rows = 1, "
                "columns = 2}\n[coupling]",
                "the instrument of readout.circuit = \"amplifier\" reads one electrode", "47:11",
                "^^^^^^^^^^^", "readout.taxel_circuit = \"amplifier\" reads each of them"},
        Mistake{"ScanOfSharedTaxels", "[coupling]",
                "[readout]\nscan = {dwell = \"10 ms\"}\ntaxels = {rows = 1, columns = "
                "2}\n[coupling]",
                "readout.scan reads taxels row by row, but none has a circuit of its own", "47:17",
                "^^^^^^^", "set readout.taxel_circuit"},
        Mistake{"ScanWithoutDwell", "[coupling]",
                "[readout]\nscan = {others = \"open\"}\n[coupling]",
                "readout.scan.others is given, but nothing is scanned", "47:18", "^^^^^^",
                "add readout.scan.dwell"},
        Mistake{"TooFastAScan", "[coupling]",
                "[readout]\ntaxel_circuit = \"open\"\ntaxels = {rows = 1, columns = 2}\nscan = "
                "{dwell = \"10 us\"}\n[coupling]",
                "switches over the run of 4 s, more than 20000", "49:17", "^^^^^^^",
                "it must be at least 0.0002 s"},
        Mistake{"TooManyTaxelsWithCircuits", "[coupling]",
                "[readout]\ntaxel_circuit = \"open\"\ntaxels = {rows = 21, columns = "
                "20}\n[coupling]",
                "420 taxels have circuits of their own", "47:17", "^^^^^^",
                "at most 400 may: use fewer taxels"},
        Mistake{"ThinLayersWithTaxelCircuits", "\"1200 mol/m3\"",
                "\"1200 mol/m3\"\nion_model = \"thin-layers\"\n[readout]\ntaxel_circuit = "
                "\"open\"\ntaxels = {rows = 1, columns = 2}",
                "supports only one conductor as the top electrode", "45:13", "^^^^^^",
                "or readout.taxel_circuit = \"shared\""},
        Mistake{"DiluteIonsWithLargestConcentration", "\"1200 mol/m3\"",
                "\"1200 mol/m3\"\nlargest_concentration = \"5000 mol/m3\"",
                "largest_concentration is given, but dilute ions have none", "45:25",
                "^^^^^^^^^^^^^", "set electrochemistry.ion_model = \"steric\""},
        Mistake{"ThinLayersWithoutWater", "\"1200 mol/m3\"",
                "\"1200 mol/m3\"\nion_model = \"thin-layers\"",
                "holds where water drives the cations, not under coupling.law = \"fixed-charge\"",
                "45:13", "^^^^^^^^^^^^^", "set coupling.law = \"poroelastic\""},
        Mistake{"StericIonsThatDoNotFit", "\"1200 mol/m3\"",
                "\"1200 mol/m3\"\nlargest_concentration = \"1200 mol/m3\"\nion_model = \"steric\"",
                "the cations at rest do not fit into the core", "45:25", "^^^^^^^^^^^^^",
                "it must exceed 1200 mol/m3"},
        Mistake{"StericIonsWithoutLargestConcentration", "\"1200 mol/m3\"",
                "\"1200 mol/m3\"\nion_model = \"steric\"",
                "missing key electrochemistry.largest_concentration in", "41:1",
                "41 | [electrochemistry]", "add it: a concentration such as"},
        Mistake{"UnknownIonModel", "\"1200 mol/m3\"", "\"1200 mol/m3\"\nion_model = \"sterik\"",
                "sterik", "45:13", "^^^^^^^^", "did you mean \"steric\"?"},
        Mistake{"FieldsAfterTheEnd", "[coupling]",
                "[output]\nfields = [\"1 s\", \"4.5 s\"]\n[coupling]",
                "output.fields: 4.5 s lies behind the end", "47:10", "^^^^^^^", "from 0 s to 4 s"},
        Mistake{"MissingKey", "preload = \"1 um\"\n", "", "missing key motion.preload in", "29:1",
                "29 | [motion]\n    | ^^^^^^^^\n", "add it: a length such as \"1 mm\" or a force"},
        Mistake{"MissingKeyOfALayer", "thickness = \"180 um\"\n", "",
                "missing key skin.layers[1].thickness", "13:1", "^^^^^^^^^^^^^^^",
                "add it: a length"},
        Mistake{"MaterialWithoutPoissonsRatio", "material = \"nafion\"\nthickness = \"180 um\"",
                "material = \"jelly\"\nthickness = \"180 um\"\n[materials.jelly]\nyoungs_modulus = "
                "\"1 MPa\"",
                "missing key materials.jelly.poissons_ratio", "18:1", "^^^^^^^^^^^^^^^^^",
                "below 0.5"},
        Mistake{"PresetWithoutYoungsModulus", "\"nafion\"", "\"nafion_sodium\"",
                "missing key materials.nafion_sodium.youngs_modulus", "16:12", "^^^^^^^^^^^^^^^",
                "the preset leaves it out; add it to the case: \"1 GPa\", say"},
        Mistake{"MaterialWithoutIons", "diffusivity = \"7e-11 m2/s\"\n", "",
                "missing key electrochemistry.diffusivity in", "41:1", "41 | [electrochemistry]",
                "add it: a diffusivity such as"}),
    [](const auto& instance) { return instance.param.name; });

std::string with_taxels(const std::string& taxels) {
  return valid_case("[coupling]", taxels + "\n[coupling]");
}

std::string taxel(const std::string& name, const std::string& lower, const std::string& upper) {
  return "[[readout.taxels]]\nname = \"" + name + "\"\nlower = [" + lower + "]\nupper = [" + upper +
         "]\n";
}

TEST(BadCase, TaxelsThatOverlap) {
  const std::string message =
      error_of(with_taxels(taxel("a", "\"0 mm\", \"0 mm\"", "\"2 mm\", \"2 mm\"") +
                           taxel("b", "\"1.9 mm\", \"0 mm\"", "\"4 mm\", \"2 mm\"")));
  EXPECT_THAT(message, HasSubstr("the taxels \"a\" and \"b\" overlap"));
  EXPECT_THAT(message, HasSubstr("case.toml:52:9\n"));
  EXPECT_THAT(message, HasSubstr("^^^^^^^^^^^^^^^^^^ second"));
}

TEST(BadCase, TaxelsThatTouchAreFine) {
  const TemporaryCase file(with_taxels(taxel("a", "\"0 mm\", \"0 mm\"", "\"2.1 mm\", \"2 mm\"") +
                                       taxel("b", "\"2.1 mm\", \"0 mm\"", "\"15 mm\", \"2 mm\"")));
  const Case input = read_case(file.path());
  ASSERT_EQ(input.readout.taxels.size(), 2U);
  EXPECT_EQ(input.readout.taxels[1].name, "b");
  EXPECT_DOUBLE_EQ(input.readout.taxels[1].lower[0], 2.1e-3);
}

TEST(BadCase, TaxelsHaveCircuitsOfTheirOwn) {
  const std::string left = taxel("a", "\"0 mm\", \"0 mm\"", "\"2 mm\", \"2 mm\""),
                    right = taxel("b", "\"2 mm\", \"0 mm\"", "\"15 mm\", \"2 mm\"");
  const TemporaryCase file(
      with_taxels(left + "circuit = \"load\"\nload_resistance = \"2 kOhm\"\n" + right));
  const Readout readout = read_case(file.path()).readout;
  EXPECT_TRUE(readout.is_cut());
  EXPECT_TRUE(readout.has_own_circuit(0));
  EXPECT_FALSE(readout.has_own_circuit(1));
  EXPECT_EQ(readout.circuit_of(0), "load");
  EXPECT_EQ(readout.parameters_of(0).at("load_resistance"), 2e3);
  EXPECT_EQ(readout.circuit_of(1), "short");
  EXPECT_EQ(readout.parameters_of(1).at("load_resistance"), 1e6);

  const TemporaryCase all(with_taxels("[readout]\ntaxel_circuit = \"open\"\n" + left +
                                      "circuit = \"shared\"\n" + right));
  const Readout mixed = read_case(all.path()).readout;
  EXPECT_FALSE(mixed.has_own_circuit(0));
  EXPECT_EQ(mixed.circuit_of(1), "open");
}

TEST(BadCase, CircuitsOfTaxelsThatCannotBe) {
  const auto one = [](const std::string& upper, const std::string& more) {
    return error_of(with_taxels(taxel("a", "\"0 mm\", \"0 mm\"", upper) + more));
  };
  EXPECT_THAT(one("\"2 mm\", \"2 mm\"", "circuit = \"open\"\nload_resistance = \"2 kOhm\"\n"),
              HasSubstr("the taxel \"a\" has load_resistance, but its circuit has none"));
  EXPECT_THAT(one("\"2 mm\", \"2 mm\"", "load_resistance = \"2 kOhm\"\n"),
              HasSubstr("give it circuit = \"load\" or \"parallel-rc\""));
  EXPECT_THAT(one("\"0.1 mm\", \"2 mm\"", "circuit = \"open\"\n"),
              HasSubstr("too small for a circuit of its own: 0.1 mm along x"));
  EXPECT_THAT(one("\"2 mm\", \"2 mm\"", "circuit = \"opne\"\n"), HasSubstr("open"));
}

TEST(BadCase, LinesThatCross) {
  const auto with = [](const std::string& grid, const std::string& more) {
    return with_taxels("[readout]\ntaxels = {rows = 2, columns = 3" + grid + "}\n" + more);
  };
  const std::string crossbar = ", wiring = \"crossbar\"";
  const TemporaryCase file(with(crossbar, "row_circuit = \"load\"\n"));
  const Readout readout = read_case(file.path()).readout;
  EXPECT_TRUE(readout.is_crossbar() && readout.is_cut() && readout.has_own_circuit(5));
  EXPECT_EQ(readout.circuit_of(0), "short"); // of the columns
  const std::vector<Taxel> lines = readout.lines();
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_EQ(lines[1].name, "c2");
  EXPECT_EQ(lines[1].upper[1], readout.taxels.back().upper[1]);
  EXPECT_EQ(lines[4].name, "r2");
  EXPECT_EQ(lines[4].circuit, "load");
  EXPECT_EQ(lines[4].lower[0], 0);
  EXPECT_FALSE(readout.lines_are_held());

  EXPECT_THAT(error_of(with(crossbar + ", gap = \"0.1 mm\"", "")),
              HasSubstr("the lines of a crossbar touch, and readout.taxels.gap is given"));
  EXPECT_THAT(error_of(with(crossbar, "taxel_circuit = \"shared\"\n")),
              HasSubstr("cuts both electrodes into lines"));
  const std::string floating = "taxel_circuit = \"open\"\nrow_circuit = \"load\"\n";
  EXPECT_THAT(error_of(with(crossbar, floating)),
              HasSubstr("no line of the crossbar is at the ground: the columns have the circuit "
                        "\"open\", the rows \"load\""));
  EXPECT_THAT(error_of(with(crossbar, floating + "scan = {dwell = \"1 ms\", others = \"open\"}\n")),
              HasSubstr("set readout.row_circuit = \"short\""));
  EXPECT_NO_THROW(
      read_case(TemporaryCase(with(crossbar, floating + "scan = {dwell = \"1 ms\"}\n")).path()));
  EXPECT_THAT(error_of(with(", wiring = \"crosbar\"", "")), HasSubstr("crossbar"));
  EXPECT_THAT(error_of(with_taxels("[readout]\nrow_circuit = \"open\"\n")),
              HasSubstr("readout.row_circuit is given, but no rows are conductors of their own"));
  EXPECT_THAT(error_of(with_taxels("[readout]\ntaxels = {wiring = \"crossbar\"}\n")),
              HasSubstr("missing key readout.taxels.rows"));
  const TemporaryCase held(with(crossbar, "scan = {dwell = \"1 ms\"}\n"));
  EXPECT_THAT(read_case(held.path()).notes,
              testing::Contains(HasSubstr("Set readout.scan.others = \"open\"")));
}

TEST(BadCase, TaxelsOffTheSkinOrWithoutExtentOrName) {
  const std::string three = taxel("a", "\"0 mm\", \"1 mm\"", "\"2 mm\", \"1 mm\"") +
                            taxel("a", "\"3 mm\", \"0 mm\"", "\"16 mm\", \"2 mm\"") +
                            taxel("rest", "\"2 mm\", \"0 mm\"", "\"3 mm\", \"2 mm\"");
  const std::string bad = error_of(with_taxels(three + "[[readout.taxels]]\nname = \"d\"\n"));
  EXPECT_THAT(bad, HasSubstr("missing key readout.taxels[3].lower"));
  const std::string message = error_of(with_taxels(three));
  EXPECT_THAT(message, HasSubstr("4 problems in"));
  EXPECT_THAT(message, HasSubstr("has no extent along y: it reaches from 1 mm to 1 mm"));
  EXPECT_THAT(message, HasSubstr("leaves the top face: it reaches to 16 mm along x"));
  EXPECT_THAT(message, HasSubstr("two taxels have the name \"a\""));
  EXPECT_THAT(message, HasSubstr("\"rest\" cannot name a taxel"));
}

TEST(BadCase, KeysOfOlderVersionsAreNotedAndTheirValuesStillJudged) {
  const auto with = [](const std::string& text) {
    return valid_case() + "[numerics.shared_positions]\n" + text;
  };
  const std::vector<std::string> notes =
      read_case_text(with("to = [\"4 mm\", \"0.9 mm\"]\n"), "case.toml").input.notes;
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes.front(), "numerics.shared_positions.to has no effect any more: remove it.");
  EXPECT_TRUE(read_case_text(valid_case(), "case.toml").input.notes.empty());
  EXPECT_THAT(error_of(with("to = [\"4 s\", \"0.9 mm\"]\n")),
              HasSubstr("numerics.shared_positions.to"));
}

std::string with_drive(const std::string& keys) {
  return valid_case() + "[motion.drive]\n" + keys;
}

TEST(BadCase, DriveHasASpringAndPositiveValues) {
  EXPECT_THAT(error_of(with_drive("mass = \"5 g\"\n")),
              HasSubstr("motion.drive.mass is given, but the drive has no spring"));
  EXPECT_THAT(error_of(with_drive("stiffness = \"0 N/m\"\n")), HasSubstr("motion.drive.stiffness"));
  EXPECT_THAT(error_of(with_drive("stiffness = \"200 N\"\n")), HasSubstr("a stiffness"));
  EXPECT_THAT(error_of(with_drive("stiffness = \"200 N/m\"\nmass = \"-1 g\"\n")),
              HasSubstr("motion.drive.mass"));
  EXPECT_THAT(error_of(with_drive("stifness = \"200 N/m\"\n")),
              HasSubstr("motion.drive.stiffness"));
}

TEST(BadCase, DriveOfFrictionThatFallsWithSpeedNeedsMassOrDamping) {
  const std::string law = "[contact]\nlaw = \"stribeck\"\nfriction = 0.3\n"
                          "kinetic_friction = 0.2\nstribeck_speed = \"1 mm/s\"\n";
  const auto with = [&](const std::string& friction, const std::string& drive) {
    return valid_case("[contact]\nfriction = 0.3 # a comment\n", friction) +
           "[motion.drive]\nstiffness = \"200 N/m\"\n" + drive;
  };
  EXPECT_THAT(error_of(with(law, "")), HasSubstr("has neither mass nor damping"));
  EXPECT_EQ(error_of(with(law, "mass = \"5 g\"\n")), "");
  EXPECT_EQ(error_of(with(law, "damping = \"0.1 N s/m\"\n")), "");
  EXPECT_EQ(error_of(with("[contact]\nfriction = 0.3\n", "")), "");
  EXPECT_THAT(error_of(with(law, "mass = \"1e-9 g\"\n")), HasSubstr("raise motion.drive.mass"));
}

TEST(BadCase, TaxelsAreAValue) {
  EXPECT_THAT(error_of(with_taxels("[readout]\ntaxels = 4\n")),
              HasSubstr("write one section [[readout.taxels]] for each taxel"));
}

TEST(BadCase, MissingSectionIsOneProblem) {
  const std::string message = error_of(valid_case("[contact]\nfriction = 0.3 # a comment\n", ""));
  EXPECT_THAT(message, HasSubstr("missing section [contact] in"));
  EXPECT_THAT(message, HasSubstr("add it with its keys: friction"));
}

TEST(BadCase, NoLayers) {
  std::string text = valid_case();
  const std::size_t first = text.find("[[skin.layers]]");
  text.erase(first, text.find("[slider]") - first);
  EXPECT_THAT(error_of(text), HasSubstr("the skin has no layers"));
  EXPECT_THAT(error_of(text), HasSubstr("case.toml:3:1\n"));
  EXPECT_THAT(error_of(text), HasSubstr("add sections [[skin.layers]]"));
}

TEST(BadCase, LayersAreAValue) {
  const std::string message = error_of("[skin]\nlayers = \"three\"\n");
  EXPECT_THAT(message, HasSubstr("skin.layers must be a list of tables"));
  EXPECT_THAT(message, HasSubstr("case.toml:2:10\n"));
  EXPECT_THAT(message, HasSubstr("write one section [[skin.layers]] for each layer"));
}

TEST(BadCase, CoreWithoutElectrodes) {
  std::string text = valid_case();
  const std::size_t last = text.rfind("[[skin.layers]]");
  text.erase(last, text.find("[slider]") - last);
  EXPECT_THAT(error_of(text), HasSubstr("the top electrode is missing"));
  EXPECT_THAT(error_of(text), HasSubstr("case.toml:15:8\n"));
}

TEST(BadCase, BrokenTomlShowsTheLine) {
  const std::string message = error_of(valid_case("friction = 0.3", "friction = = 0.3"));
  EXPECT_THAT(message, HasSubstr("not valid TOML"));
  EXPECT_THAT(message, HasSubstr("case.toml"));
  EXPECT_THAT(message, HasSubstr("39 | friction = = 0.3"));
  EXPECT_THAT(message, HasSubstr("^--- here"));
  EXPECT_THAT(message, HasSubstr("texts and quantities stand in quotes"));
  EXPECT_THAT(message, testing::Not(HasSubstr("toml::")));
}

TEST(BadCase, EmptyFileNamesTheSections) {
  const std::string message = error_of("");
  for (const char* section :
       {"[skin]", "[slider]", "[motion]", "[contact]", "[electrochemistry]", "[coupling]"})
    EXPECT_THAT(message, HasSubstr(section));
}

TEST(BadCase, AllMistakesAreReportedTogether) {
  std::string text = valid_case("friction = 0.3", "frction = 0.3");
  text.replace(text.find("15 mm"), 5, "15 ms");
  text.replace(text.find("lift = \"0.5 s\""), 14, "lift = \"0 s\"  ");
  const std::string message = error_of(text);
  EXPECT_THAT(message, HasSubstr("3 problems in"));
  EXPECT_THAT(message, HasSubstr("got a time"));
  EXPECT_THAT(message, HasSubstr("motion.lift = \"0 s\""));
  EXPECT_THAT(message, HasSubstr("did you mean contact.friction?"));
  // The misspelt key is not reported as a missing one as well.
  EXPECT_THAT(message, testing::Not(HasSubstr("missing key")));
}

TEST(BadCase, UnreadableFile) {
  try {
    read_case("/nowhere/case.toml");
    FAIL() << "a missing file was read";
  } catch (const UserError& error) {
    EXPECT_THAT(error.what(), HasSubstr("/nowhere/case.toml cannot be read: No such file"));
    EXPECT_THAT(error.what(), HasSubstr("check its name"));
  }
}

TEST(BadCase, FolderInsteadOfFile) {
  const TemporaryCase file(valid_case());
  EXPECT_THAT([&] { read_case(file.folder()); },
              testing::ThrowsMessage<UserError>(HasSubstr("is a folder")));
}

TEST(BadCase, MissingStrainFile) {
  const std::string message = error_of(
      valid_case("[coupling]", "[strain]\nsource = \"file\"\nfile = \"none.h5\"\n[coupling]"));
  EXPECT_THAT(message, HasSubstr("none.h5 cannot be read"));
  EXPECT_THAT(message, HasSubstr("case.toml:48:8\n"));
  EXPECT_THAT(message, HasSubstr("relative to the folder of the case file"));
}

TEST(BadCase, CaretsStandUnderWideCharactersAndTabs) {
  const std::string message =
      error_of(valid_case("title = \"A touch\"", "title = \"é\"\n\tcolöur = 1"));
  // toml11 takes no umlauts in bare keys; its own excerpt shows the line.
  EXPECT_THAT(message, HasSubstr("not valid TOML"));
  const std::string quoted = error_of(valid_case("title = \"A touch\"", "\t\"colöur\" = \"é\""));
  EXPECT_THAT(quoted, HasSubstr(" 1 | \t\"colöur\" = \"é\"\n   | \t^^^^^^^^\n"));
}

TEST(SoftSlider, HasNoPlaceBetweenPlanesOfSymmetry) {
  std::string text = valid_case("[slider]", "[slider]\nyoungs_modulus = \"1 MPa\"");
  const std::string before = "width = \"2 mm\"";
  text.replace(text.find(before), before.size(), before + "\nsides = \"symmetry\"");
  const std::string message = error_of(text);
  EXPECT_THAT(message, HasSubstr("a soft slider needs free sides"));
  EXPECT_THAT(message, HasSubstr("case.toml:27:18\n"));
  EXPECT_THAT(message, HasSubstr("set skin.sides = \"free\", or remove slider.youngs_modulus"));
}

} // namespace
} // namespace ionskin
