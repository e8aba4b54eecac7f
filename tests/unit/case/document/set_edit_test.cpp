// SPDX-License-Identifier: Apache-2.0
#include "ionskin/case/document/set_edit.hpp"

#include "ionskin/base/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ionskin {
namespace {

using testing::HasSubstr;

std::string edited(const std::string& text, const std::vector<std::string>& arguments) {
  CaseText result("case.toml", text);
  for (const std::string& argument : arguments)
    apply_set_edit(result, argument);
  return result.text();
}

TEST(SetEdit, ReplacesTheValueAndNothingElse) {
  EXPECT_EQ(edited("# top\n[contact]\nfriction = 0.3 # why\nlaw = \"coulomb\"\n",
                   {"contact.friction=0.25"}),
            "# top\n[contact]\nfriction = 0.25 # why\nlaw = \"coulomb\"\n");
}

TEST(SetEdit, QuotesWordsAndQuantitiesOnly) {
  EXPECT_EQ(toml_value_text("0.3"), "0.3");
  EXPECT_EQ(toml_value_text("3 mm"), "\"3 mm\"");
  EXPECT_EQ(toml_value_text("column-neutral"), "\"column-neutral\"");
  EXPECT_EQ(toml_value_text("\"3 mm\""), "\"3 mm\"");
  EXPECT_EQ(toml_value_text("[\"0.5 s\"]"), "[\"0.5 s\"]");
  EXPECT_EQ(toml_value_text("[0.5 s, 1 s]"), "[\"0.5 s\", \"1 s\"]");
  EXPECT_EQ(toml_value_text("true"), "true");
  EXPECT_EQ(toml_value_text("0.3 # no"), "\"0.3 # no\"");
  EXPECT_EQ(toml_value_text("C:\\a"), "\"C:\\\\a\"");
}

TEST(SetEdit, AddsAKeyToItsTable) {
  EXPECT_EQ(edited("[contact]\nfriction = 0.3\n[skin]\n", {"contact.law=coulomb"}),
            "[contact]\nlaw = \"coulomb\"\nfriction = 0.3\n[skin]\n");
  EXPECT_EQ(edited("contact = { friction = 0.3 }\n", {"contact.law=coulomb"}),
            "contact = { friction = 0.3 , law = \"coulomb\"}\n");
  EXPECT_EQ(edited("contact = {}\n", {"contact.friction=1"}), "contact = {friction = 1}\n");
  EXPECT_EQ(edited("contact.friction = 0.3 # x\ntitle = \"\"\n", {"contact.law=coulomb"}),
            "contact.friction = 0.3 # x\ncontact.law = \"coulomb\"\ntitle = \"\"\n");
  EXPECT_EQ(edited("# c\n[contact]\n", {"title=Run"}), "title = \"Run\"\n# c\n[contact]\n");
}

TEST(SetEdit, AddsAMissingTableAtTheEnd) {
  EXPECT_EQ(edited("[skin]", {"numerics.preset=coarse", "numerics.mesh_refinement=2"}),
            "[skin]\n\n[numerics]\nmesh_refinement = 2\npreset = \"coarse\"\n");
  EXPECT_EQ(edited("[materials.a]\nx = 1\n", {"materials.b.poissons_ratio=0.4"}),
            "[materials.a]\nx = 1\n\n[materials]\nb.poissons_ratio = 0.4\n");
}

TEST(SetEdit, AddsATableBeforeItsList) {
  const std::string taxels = "[a]\nb = 1\n# two\n[[readout.taxels]]\nname = \"x\"\n";
  EXPECT_EQ(edited(taxels, {"readout.circuit=open", "readout.taxel_circuit=load"}),
            "[a]\nb = 1\n# two\n[readout]\ntaxel_circuit = \"load\"\ncircuit = "
            "\"open\"\n\n[[readout.taxels]]\nname = \"x\"\n");
}

TEST(SetEdit, ReachesIntoLists) {
  const std::string layers = "[[skin.layers]]\nname = \"a\"\n[[skin.layers]]\nname = \"b\"\n";
  EXPECT_EQ(edited(layers, {"skin.layers[1].name=c"}),
            "[[skin.layers]]\nname = \"a\"\n[[skin.layers]]\nname = \"c\"\n");
  EXPECT_EQ(edited(layers, {"skin.layers[0].thickness=1 um"}),
            "[[skin.layers]]\nthickness = \"1 um\"\nname = \"a\"\n[[skin.layers]]\nname = \"b\"\n");
  EXPECT_EQ(edited("[slider]\nsize = [\"1 mm\", \"2 mm\"]\n", {"slider.size[1]=3 mm"}),
            "[slider]\nsize = [\"1 mm\", \"3 mm\"]\n");
}

TEST(SetEdit, TheLastEditOfAKeyCounts) {
  EXPECT_EQ(edited("[a]\nb = 1\nc = 2\n", {"a.b=10", "a.c=20", "a.b=100"}),
            "[a]\nb = 100\nc = 20\n");
}

TEST(SetEdit, PlacesOfTheFileSurviveEdits) {
  CaseText text("case.toml", "[a]\nb = 1\nc = 2\n[d]\ne = 3\n");
  apply_set_edit(text, "a.new=long text");
  apply_set_edit(text, "a.b=1000");
  apply_set_edit(text, "a.new=other");
  const std::size_t position = text.text().find("3");
  const Place place = text.place(position, 1);
  EXPECT_EQ(place.line, 5U);
  EXPECT_EQ(place.column, 5U);
  EXPECT_EQ(place.line_text, "e = 3");
  EXPECT_FALSE(text.is_edited(position));

  const Place edit = text.place(text.text().find("1000"), 4);
  EXPECT_EQ(edit.origin, "command line");
  EXPECT_EQ(edit.line_text, "--set a.b=1000");
  EXPECT_EQ(edit.line_text.substr(edit.column - 1, edit.length), "1000");
  EXPECT_EQ(text.place(text.text().find("\"other\""), 7).line_text, "--set a.new=other");
}

struct BadEdit {
  std::string argument, what, remedy;
};

class BadSetEdit : public testing::TestWithParam<BadEdit> {};

TEST_P(BadSetEdit, PointsIntoTheArgument) {
  const auto edit = [] {
    edited("[a]\nb = [1, 2]\n[[t]]\nx = 1\n[[t]]\nname = \"up\"\n", {GetParam().argument});
  };
  EXPECT_THAT(edit, testing::ThrowsMessage<UserError>(testing::AllOf(
                        HasSubstr(GetParam().what), HasSubstr(GetParam().remedy),
                        HasSubstr("--set " + GetParam().argument + "\n"), HasSubstr("^"))));
}

INSTANTIATE_TEST_SUITE_P(Table, BadSetEdit,
                         testing::Values(BadEdit{"a.b", "has no value", "--set key=value"},
                                         BadEdit{"a.b=", "has no value", "--set key=value"},
                                         BadEdit{"=3", "names no key", "--set key=value"},
                                         BadEdit{"a..b=3", "is not a key", "keys look like"},
                                         BadEdit{"a=3", "a is a table", "--set a.KEY=VALUE"},
                                         BadEdit{"t=3", "t is a table", "--set t.KEY=VALUE"},
                                         BadEdit{"a.b[2]=3", "b has no entry 2", "2 entries"},
                                         BadEdit{"a.c[0]=3", "no array a.c", "in the file"},
                                         BadEdit{"t.0.x=3", "t is a list, not a table",
                                                 "2 in all, are counted from 0: t[0].x"},
                                         BadEdit{"t.x=3", "t is a list, not a table", "t[0].x"},
                                         BadEdit{"t.up.x=3", "t is a list, not a table", "t[1].x"},
                                         BadEdit{"t[0].x.e=3", "x is a value, not a table",
                                                 "set it by t[0].x=VALUE"}));

} // namespace
} // namespace ionskin
