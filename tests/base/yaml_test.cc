#include "base/yaml.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fstream>
#include <functional>

#include "base/numbers.h"
#include "scratch_dir.h"

namespace phs {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

YamlMap Parsed(const std::string& text) {
  auto map = YamlMap::Parse(text, "x.yaml");
  EXPECT_TRUE(map.ok()) << (map.ok() ? "" : map.error().Line());
  return map.value();
}

TEST(Yaml, ReadsEveryKindOfValue) {
  YamlMap map = Parsed(
      "radius_m: 550\nsign: -1\nsteep: +2.5e-3\nsteered: yes\nname: 'two words'\nlaw: polach\n"
      "list: [1, 2.5, -3]\nwords: [a, b]\nnested: {depth: {x: 7}}\nitems:\n  - {k: 1}\n  - {k: "
      "2}\n");
  EXPECT_EQ(map.Number("radius_m", {.min = 80}), 550);
  EXPECT_EQ(map.Integer("sign", -1, 1), -1);
  EXPECT_EQ(map.Number("steep", {}), 0.0025);
  EXPECT_TRUE(map.Bool("steered", false));
  EXPECT_EQ(map.Text("name"), "two words");
  EXPECT_EQ(map.Word("law", {"linear", "polach"}), "polach");
  EXPECT_THAT(map.Numbers("list", {}), ElementsAre(1, 2.5, -3));
  EXPECT_THAT(map.Texts("words"), ElementsAre("a", "b"));
  EXPECT_EQ(map.Map("nested").Map("depth").Number("x", {}), 7);
  std::vector<YamlMap> items = map.Maps("items");
  ASSERT_EQ(items.size(), 2u);
  EXPECT_EQ(items[0].Integer("k", 0, 9) + items[1].Integer("k", 0, 9), 3);
  EXPECT_THAT(map.Keys(), ElementsAre("radius_m", "sign", "steep", "steered", "name", "law", "list",
                                      "words", "nested", "items"));
  EXPECT_TRUE(map.Finish().ok());
}

TEST(Yaml, DefaultsStandInForAbsentKeys) {
  YamlMap map = Parsed("here: 1\n");
  EXPECT_EQ(map.Number("speed_m_s", {.min = 0}, 20.0), 20);
  EXPECT_EQ(map.Integer("count", 1, 3, 2), 2);
  EXPECT_TRUE(map.Bool("flag", true));
  EXPECT_EQ(map.Text("text", "t"), "t");
  EXPECT_EQ(map.Word("law", {"a", "b"}, "b"), "b");
  EXPECT_THAT(map.Numbers("list", {}, {4.0}), ElementsAre(4));
  EXPECT_TRUE(map.Texts("words").empty());
  EXPECT_TRUE(map.Maps("items").empty());
  EXPECT_TRUE(map.Map("nested").Keys().empty());
  EXPECT_FALSE(map.Has("there"));
  EXPECT_TRUE(map.Has("here"));
  EXPECT_TRUE(map.Finish().ok());
}

/// What Finish says after `read`.
std::string ErrorOf(const std::string& text, const std::function<void(YamlMap&)>& read) {
  YamlMap map = Parsed(text);
  read(map);
  const Status status = map.Finish();
  return status.ok() ? "no error" : status.error().Line();
}

TEST(Yaml, UnknownKeyNamesTheNearest) {
  EXPECT_EQ(ErrorOf("a: 1\nradius: 550\n",
                    [](YamlMap& m) {
                      m.Number("a", {});
                      m.Number("radius_m", {}, 1.0);
                    }),
            "x.yaml:2: radius: unknown key; allowed: a, radius_m; did you mean 'radius_m'?");
  EXPECT_EQ(ErrorOf("a: 1\ncolour_of_paint: red\n", [](YamlMap& m) { m.Number("a", {}); }),
            "x.yaml:2: colour_of_paint: unknown key; allowed: a; remove it");
}

TEST(Yaml, AMistypedKeyIsNotToldAsAMissingOne) {
  const auto read = [](YamlMap& m) {
    m.Text("track");
    m.Text("bogie", "phs");
  };
  EXPECT_EQ(ErrorOf("trak: straight\n", read),
            "x.yaml:1: trak: unknown key; allowed: bogie, track; did you mean 'track'?");
  EXPECT_EQ(ErrorOf("bogie: phs\n", read), "x.yaml:1: track: is missing; allowed: a word; add it");
  EXPECT_EQ(ErrorOf("bogie: phs\nweather: dry\n", read),
            "x.yaml:1: track: is missing; allowed: a word; add it");
  EXPECT_EQ(ErrorOf("bogy: phs\n", read),
            "x.yaml:1: bogy: unknown key; allowed: bogie, track; did you mean 'bogie'?");
}

TEST(Yaml, TopmostUnknownKeyOfNestedMapsIsNamed) {
  EXPECT_THAT(ErrorOf("z:\n  gap: 1\n  wrong: 2\na:\n  other: 3\n",
                      [](YamlMap& m) {
                        m.Map("z").Number("gap", {});
                        m.Map("a");
                      }),
              HasSubstr("x.yaml:3: z.wrong: unknown key"));
}

TEST(Yaml, MessagesOfNumbers) {
  const auto number = [](YamlMap& m) { m.Number("k", {.min = 0, .max = 5, .open_min = true}); };
  EXPECT_EQ(ErrorOf("k: 0\n", number), "x.yaml:1: k: 0 is out of range; allowed: 0 < x <= 5");
  EXPECT_EQ(ErrorOf("k: 5.25\n", number), "x.yaml:1: k: 5.25 is out of range; allowed: 0 < x <= 5");
  EXPECT_EQ(ErrorOf("k: 5m\n", number), "x.yaml:1: k: '5m' is no number; allowed: 0 < x <= 5");
  EXPECT_EQ(ErrorOf("k: [1]\n", number), "x.yaml:1: k: a list is no number; allowed: 0 < x <= 5");
  EXPECT_EQ(ErrorOf("k:\nj: 1\n", number),
            "x.yaml:1: k: nothing is no number; allowed: 0 < x <= 5");
  EXPECT_EQ(ErrorOf("# c\nother: 1\n", number),
            "x.yaml:2: k: is missing; allowed: 0 < x <= 5; add it");
  EXPECT_EQ(ErrorOf("k: 1.5\n", [](YamlMap& m) { m.Integer("k", 0, 2147483647); }),
            "x.yaml:1: k: 1.5 is no whole number; allowed: whole numbers, 0 <= x <= 2147483647");
}

TEST(Yaml, NotANumberAndInfinityAreRefused) {
  for (const char* word : {"nan", ".nan", "inf", "-inf", ".inf", "1e999", "0x10", "1,5", "++1"}) {
    EXPECT_THAT(
        ErrorOf(std::string("k: \"") + word + "\"\n", [](YamlMap& m) { m.Number("k", {}); }),
        HasSubstr("is no number; allowed: finite numbers"))
        << word;
  }
}

TEST(Yaml, MessagesOfLists) {
  EXPECT_EQ(ErrorOf("k:\n  - 1\n  - -2\n", [](YamlMap& m) { m.Numbers("k", {.min = 0}); }),
            "x.yaml:3: k[2]: -2 is out of range; allowed: x >= 0");
  EXPECT_EQ(ErrorOf("k: 3\n", [](YamlMap& m) { m.Numbers("k", {.max = 9, .open_max = true}); }),
            "x.yaml:1: k: '3' is no list; allowed: a list of numbers, x < 9");
  EXPECT_EQ(ErrorOf("other: 3\n", [](YamlMap& m) { m.Numbers("k", {}); }),
            "x.yaml:1: k: is missing; allowed: a list of finite numbers; add it");
  EXPECT_EQ(ErrorOf("k: {}\n", [](YamlMap& m) { m.Texts("k"); }),
            "x.yaml:1: k: a map is no list; allowed: a list of words");
  EXPECT_EQ(ErrorOf("k: [[a]]\n", [](YamlMap& m) { m.Texts("k"); }),
            "x.yaml:1: k: holds a list as a word; allowed: a list of words");
  EXPECT_EQ(ErrorOf("k: a\n", [](YamlMap& m) { m.Maps("k"); }),
            "x.yaml:1: k: 'a' is no list; allowed: a list of maps");
  EXPECT_EQ(ErrorOf("k: [{}, a]\n", [](YamlMap& m) { m.Maps("k"); }),
            "x.yaml:1: k: item 2 is no map; allowed: a list of maps");
}

TEST(Yaml, MessagesOfWords) {
  EXPECT_EQ(ErrorOf("k: [a]\n", [](YamlMap& m) { m.Text("k"); }),
            "x.yaml:1: k: a list is no word; allowed: a word");
  EXPECT_EQ(ErrorOf("other: a\n", [](YamlMap& m) { m.Text("k"); }),
            "x.yaml:1: k: is missing; allowed: a word; add it");
  EXPECT_EQ(ErrorOf("k: polack\n",
                    [](YamlMap& m) {
                      m.Word("k", {"linear", "polach"});
                    }),
            "x.yaml:1: k: 'polack' is unknown; allowed: linear, polach; did you mean 'polach'?");
  EXPECT_EQ(ErrorOf("other: a\n",
                    [](YamlMap& m) {
                      m.Word("k", {"linear", "polach"});
                    }),
            "x.yaml:1: k: is missing; allowed: linear, polach; add it");
  EXPECT_EQ(ErrorOf("k: maybe\n", [](YamlMap& m) { m.Bool("k", true); }),
            "x.yaml:1: k: 'maybe' is neither true nor false; allowed: true, false");
  EXPECT_EQ(ErrorOf("k: a\n", [](YamlMap& m) { m.Map("k"); }),
            "x.yaml:1: k: 'a' is no map; allowed: lines of 'key: value'");
}

TEST(Yaml, FirstErrorOfTheDocumentIsKeptAndShared) {
  YamlMap map = Parsed("a: {x: wrong}\nb: wrong\n");
  YamlMap nested = map.Map("a");
  nested.Number("x", {});
  map.Number("b", {});
  map.Fail("b", "is wrong in another way");
  EXPECT_THAT(map.Finish().error().Line(), HasSubstr("x.yaml:1: a.x: 'wrong' is no number"));
  EXPECT_EQ(nested.Finish().error().Line(), map.Finish().error().Line());
}

TEST(Yaml, CallersErrorHasItsPlace) {
  YamlMap map = Parsed("a: 1\nb:\n  c: 2\n");
  YamlMap b = map.Map("b");
  EXPECT_EQ(b.Where("c"), "x.yaml:3: b.c");
  b.Fail("c", "is more than a", "c < a", "lower it");
  EXPECT_EQ(map.Finish().error().Line(), "x.yaml:3: b.c: is more than a; allowed: c < a; lower it");
}

std::string ParseError(const std::string& text) {
  auto map = YamlMap::Parse(text, "x.yaml");
  return map.ok() ? "no error" : map.error().Line();
}

TEST(Yaml, MessagesOfBrokenDocuments) {
  EXPECT_EQ(ParseError("a: 1\nb: 2\na: 3\n"),
            "x.yaml:3: a: is given twice; allowed: each key once; remove one of the two");
  EXPECT_EQ(ParseError(""), "x.yaml:1: is no map; allowed: lines of 'key: value'");
  EXPECT_EQ(ParseError("- 1\n"), "x.yaml:1: is no map; allowed: lines of 'key: value'");
  EXPECT_EQ(ParseError("a: 1\n---\nb: 2\n"),
            "x.yaml:2: begins a second document; allowed: one document in a file; remove what ends "
            "the first ('---', a stray bracket)");
  EXPECT_EQ(ParseError("? [1, 2]\n: 3\n"), "x.yaml:1: a key is not a word; allowed: words");
  EXPECT_THAT(ParseError("a: 1\nb: [1, 2\n"), HasSubstr("allowed: YAML; mend the syntax"));
  EXPECT_THAT(ParseError("a: 1\n b: 2\n"), HasSubstr("x.yaml:2: "));
  EXPECT_EQ(ParseError(std::string((16u << 20) + 1, ' ')),
            "x.yaml: is too large; allowed: at most 16 MB of YAML");
}

TEST(Yaml, HostileDocumentsAreRefusedQuickly) {
  std::string deep = "a: ";
  for (int i = 0; i < 100; ++i) deep += "[";
  EXPECT_THAT(ParseError(deep + std::string(100, ']') + "\n"), HasSubstr("nests too deeply"));
  const std::string very_deep = "a: " + std::string(200000, '[');
  EXPECT_NE(ParseError(very_deep), "no error");
  EXPECT_NE(ParseError("a: &x [*x, *x]\n"), "no error");
  std::string laughs = "l0: &l0 [1,1,1,1,1,1,1,1,1,1]\n";
  for (int i = 1; i < 12; ++i) {
    laughs += "l" + std::to_string(i) + ": &l" + std::to_string(i) + " [";
    for (int j = 0; j < 10; ++j) {
      laughs += (j > 0 ? ",*l" : "*l") + std::to_string(i - 1);
    }
    laughs += "]\n";
  }
  EXPECT_THAT(ParseError(laughs), HasSubstr("holds too many values"));
}

TEST(Yaml, MessageStaysOnOneLine) {
  const std::string line =
      ErrorOf("k: \"two\\nlines\\e[31m\"\n", [](YamlMap& m) { m.Number("k", {}); });
  EXPECT_EQ(line, "x.yaml:1: k: 'two lines [31m' is no number; allowed: finite numbers");
  EXPECT_LT(
      ErrorOf("k: " + std::string(5000, 'x') + "\n", [](YamlMap& m) { m.Number("k", {}); }).size(),
      150u);
}

TEST(Yaml, LoadNamesTheFile) {
  const ScratchDir scratch;
  std::ofstream(scratch.File("s.yaml")) << "k: 1\n";
  auto map = YamlMap::Load(scratch.File("s.yaml"));
  ASSERT_TRUE(map.ok());
  EXPECT_EQ(map.value().path(), scratch.File("s.yaml"));
  EXPECT_EQ(YamlMap::Load(scratch.File("t.yaml")).error().Line(),
            scratch.File("t.yaml") +
                ": cannot be read (No such file or directory); allowed: a "
                "readable file; check the path");
  EXPECT_THAT(YamlMap::Load(scratch.path()).error().Line(), HasSubstr("is a directory"));
}

RC_GTEST_PROP(Yaml, EveryFiniteNumberSurvivesTheWayThroughText, (double value)) {
  RC_PRE(std::isfinite(value));
  YamlMap map = Parsed("k: " + Shortest(value) + "\n");
  RC_ASSERT(map.Number("k", {}) == value);
  RC_ASSERT(map.Finish().ok());
}

RC_GTEST_PROP(Yaml, AnyTextIsReadOrRefused, (const std::string& text)) {
  auto map = YamlMap::Parse(text, "x.yaml");
  if (!map.ok()) RC_ASSERT(map.error().Line().find('\n') == std::string::npos);
}

// yaml-cpp finds documents without end behind these.
TEST(Yaml, StrayBracketsAreRefused) {
  for (const char* text : {"]", "}", "a: 1\n]", "a: 1\n}\n", "- ]", "a: ]"}) {
    EXPECT_FALSE(YamlMap::Parse(text, "x.yaml").ok()) << text;
  }
}

TEST(Range, EndsAndWords) {
  const Range half_open{.min = 0, .max = 1, .open_max = true};
  EXPECT_TRUE(half_open.Contains(0));
  EXPECT_FALSE(half_open.Contains(1));
  EXPECT_FALSE(half_open.Contains(std::nan("")));
  EXPECT_FALSE(Range{}.Contains(std::numeric_limits<double>::infinity()));
  EXPECT_EQ(half_open.Text(), "0 <= x < 1");
  EXPECT_EQ((Range{.min = 0, .open_min = true}.Text()), "x > 0");
  EXPECT_EQ((Range{.max = 0.1}.Text()), "x <= 0.1");
  EXPECT_EQ(Range{}.Text(), "finite numbers");
}

}  // namespace
}  // namespace phs
