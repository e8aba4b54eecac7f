// SPDX-License-Identifier: Apache-2.0

// Reading a case takes work in proportion to its lists. The work is measured as bytes asked of the
// allocator, which every copy of a line, a text or a list costs, and which no other load changes.

#include "ionskin/base/error.hpp"
#include "ionskin/case/document/set_edit.hpp"
#include "ionskin/case/reading/read_case.hpp"
#include "ionskin/case/text/toml_text.hpp"
#include "temporary_case.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <functional>
#include <new>
#include <string>
#include <vector>

namespace {
std::atomic<std::size_t> allocated = 0;
}

void* operator new(std::size_t size) {
  allocated += size;
  if (void* memory = std::malloc(size == 0 ? 1 : size))
    return memory;
  throw std::bad_alloc();
}
// std::stable_sort takes memory by this operator, and returns it by the operator delete below.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  allocated += size;
  return std::malloc(size == 0 ? 1 : size);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace ionskin {
namespace {

using testing::HasSubstr;

struct LongList {
  std::string name;
  std::function<std::string(int)> text;
  std::function<std::vector<std::string>(int)> edits = [](int) {
    return std::vector<std::string>();
  };
};

std::string repeated(int count, const std::function<std::string(int)>& part) {
  std::string text;
  for (int i = 0; i < count; ++i)
    text += part(i);
  return text;
}

std::vector<std::string> each(int count, const std::function<std::string(int)>& part) {
  std::vector<std::string> all;
  for (int i = 0; i < count; ++i)
    all.push_back(part(i));
  return all;
}

std::string with_waypoints(const std::string& waypoints) {
  std::string text = valid_case("start = [\"4.5 mm\", \"1 mm\"]\n", "");
  const std::size_t begin = text.find("[motion]"), end = text.find("[contact]");
  return text.replace(begin, end - begin, "[motion]\nkind = \"waypoints\"\n" + waypoints + "\n");
}

const std::vector<LongList>& long_lists() {
  static const std::vector<LongList> lists{
      {"instants in one line",
       [](int n) {
         return valid_case() + "\n[output]\nfields = [" +
                repeated(n, [](int i) { return fmt::format("\"{} us\",", i); }) + "]\n";
       }},
      {"instants in many lines",
       [](int n) {
         return valid_case() + "\n[output]\nfields = [" +
                repeated(n, [](int i) { return fmt::format("\"{} us\",\n", i); }) + "]\n";
       }},
      {"waypoints in one line",
       [](int n) {
         return with_waypoints("waypoints = [" +
                               repeated(n,
                                        [](int i) {
                                          return fmt::format(
                                              "{{time=\"{} ms\",position=[\"4 mm\",\"1 mm\"],"
                                              "height=\"{} um\"}},",
                                              i, i == 0 ? 1 : -1);
                                        }) +
                               "]");
       }},
      {"waypoints in sections",
       [](int n) {
         return with_waypoints(repeated(n, [](int i) {
           return fmt::format("[[motion.waypoints]]\ntime = \"{} ms\"\nposition = [\"4 mm\", \"1 "
                              "mm\"]\nheight = \"{} um\"\n",
                              i, i == 0 ? 1 : -1);
         }));
       }},
      {"unknown keys",
       [](int n) {
         return repeated(n, [](int i) { return fmt::format("unknown_{} = 1\n", i); }) +
                valid_case();
       }},
      {"materials",
       [](int n) {
         return valid_case() + "\n" + repeated(n, [](int i) {
                  return fmt::format("[materials.m{}]\nyoungs_modulus = \"1 GPa\"\n", i);
                });
       }},
      {"taxels",
       [](int n) {
         return valid_case() + "\n" + repeated(n, [n](int i) {
                  return fmt::format("[[readout.taxels]]\nname = \"t{}\"\nlower = [\"{} mm\", \"0 "
                                     "mm\"]\nupper = [\"{} mm\", \"1 mm\"]\n",
                                     i, 14.0 * i / n, 14.0 * (i + 0.5) / n);
                });
       }},
      {"edits of many keys", [](int) { return valid_case(); },
       [](int n) { return each(n, [](int i) { return fmt::format("contact.k{}=1", i); }); }},
      {"edits of one key", [](int) { return valid_case(); },
       [](int n) {
         return each(n, [](int i) { return fmt::format("contact.friction=0.{}", i + 1); });
       }},
      {"edits of one table that is not there", [](int) { return valid_case(); },
       [](int n) { return each(n, [](int i) { return fmt::format("output.k{}=1", i); }); }}};
  return lists;
}

double work_of(const LongList& list, int count) {
  const std::string text = list.text(count);
  const std::vector<std::string> edits = list.edits(count);
  const std::size_t before = allocated;
  try {
    read_case_text(text, "case.toml", edits);
  } catch (const UserError&) {
  }
  return static_cast<double>(allocated - before);
}

TEST(LongLists, CostWorkInProportion) {
  for (const LongList& list : long_lists()) {
    const double some = work_of(list, 100), four_times = work_of(list, 400);
    EXPECT_LT(four_times, 6 * some) << list.name;
  }
}

TEST(LongLists, KeepThePlacesOfTheirEntries) {
  std::string text = valid_case() + "\n[output]\nfields = [";
  for (int i = 0; i < 200; ++i)
    text += fmt::format("\"{} us\",", i);
  const std::string message = error_of(text + "\"7 kg\"]\n");
  const std::size_t begin = text.rfind('\n');
  EXPECT_THAT(message, HasSubstr("\"7 kg\""));
  EXPECT_THAT(message, HasSubstr(fmt::format(":{}\n", text.size() - begin)));
  EXPECT_THAT(message, HasSubstr("199 us\",\"7 kg\"]"));
}

TEST(LongLists, TellWhereTheyAreNoToml) {
  std::string text = valid_case() + "\n[output]\nfields = [";
  for (int i = 0; i < 200; ++i)
    text += fmt::format("\"{} us\",", i);
  const std::string message = error_of(text + "]]\n");
  const auto line = std::count(text.begin(), text.end(), '\n') + 1;
  EXPECT_THAT(message, HasSubstr("not valid TOML"));
  EXPECT_THAT(message, HasSubstr(fmt::format("case.toml:{}:", line)));
  EXPECT_THAT(message, HasSubstr("texts and quantities stand in quotes"));
}

TEST(LongLists, BracesOfManyKeysAreRefused) {
  std::string keys;
  for (int i = 0; i < 2000; ++i)
    keys += fmt::format("{}k{} = 1", i == 0 ? "" : ", ", i);
  EXPECT_THAT(error_of("x = {" + keys + "}\n" + valid_case()),
              testing::AllOf(HasSubstr("in braces in one line"), HasSubstr("write a section")));
}

std::string edited_text(const std::string& text, const std::vector<std::string>& edits) {
  CaseText result("case.toml", text);
  apply_set_edits(result, edits);
  return result.text();
}

TEST(LongLists, EditsTogetherDoWhatTheyDoOneByOne) {
  const std::string text =
      "a = {}\nb = {x = 1}\nl = [1, 2]\n[c]\ny = 1\n[materials.m]\nz = 1\nd.e = 1\n";
  const std::vector<std::string> all{"c.y=2",
                                     "c.y=3",
                                     "a.p=1",
                                     "a.q=2",
                                     "b.x=5",
                                     "b.w=6",
                                     "l[1]=7",
                                     "c.n=8",
                                     "c.m=9",
                                     "new.k=1",
                                     "new.j=2",
                                     "other.k.i=3",
                                     "other.h=4",
                                     "top=1",
                                     "second=2",
                                     "materials.n.v=1",
                                     "materials.o.v=1",
                                     "materials.m.d.f=1",
                                     "b={x = 7}",
                                     "b.x=8",
                                     "l=[3, 4]",
                                     "l[0]=5",
                                     "top=3"};
  CaseText one_by_one("case.toml", text);
  for (const std::string& edit : all)
    apply_set_edits(one_by_one, {edit});
  EXPECT_EQ(toml::format(TomlText(edited_text(text, all), "").root()),
            toml::format(TomlText(one_by_one.text(), "").root()));
}

TEST(LongLists, TheEditThatDoesNotFitIsFoundAmongMany) {
  std::vector<std::string> edits = each(50, [](int i) { return fmt::format("contact.k{}=1", i); });
  edits.insert(edits.begin() + 20, "title.deep=1");
  EXPECT_THAT([&] { edited_text(valid_case(), edits); },
              testing::ThrowsMessage<UserError>(HasSubstr("--set title.deep=1\n")));
}

TEST(LongLists, EditsThatUndoOneAnotherAreRefused) {
  std::vector<std::string> edits;
  for (int i = 0; i < 200; ++i) {
    edits.push_back("a={b = 1}");
    edits.push_back("a.b=2");
  }
  EXPECT_THAT([&] { edited_text("a = 1\n", edits); },
              testing::ThrowsMessage<UserError>(HasSubstr("again and again")));
}

} // namespace
} // namespace ionskin
