// `phs list` and `phs show`: every name has a line, every name listed can be shown and asked for.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/base/execute.h"

namespace phs {
namespace {

using Json = nlohmann::ordered_json;
using testing::HasSubstr;

Json Listed() { return Json::parse(ExecutePhs("list --format json").text); }

TEST(ListTest, EveryKindHasNamesAndEveryNameALine) {
  const Json listed = Listed();
  EXPECT_EQ(listed.size(), 9u);
  for (const auto& [kind, items] : listed.items()) {
    EXPECT_FALSE(items.empty()) << kind;
    for (const Json& item : items) {
      EXPECT_FALSE(item.at("text").get<std::string>().empty()) << kind << " " << item.at("name");
    }
  }
}

TEST(ListTest, TextAndJsonSayTheSame) {
  const std::string text = ExecutePhs("list").text;
  const Json listed = Listed();
  for (const auto& [kind, items] : listed.items()) {
    EXPECT_THAT(text, HasSubstr(kind + ": "));
    EXPECT_EQ(ExecutePhs("list " + kind).text.substr(0, kind.size()), kind);
    for (const Json& item : items) EXPECT_THAT(text, HasSubstr(item.at("text").get<std::string>()));
  }
}

TEST(ListTest, OneNameOfEachKindIsShown) {
  const Json listed = Listed();
  for (const auto& [kind, items] : listed.items()) {
    const std::string name = items.back().at("name");
    const Output out = ExecutePhs("show " + name);
    EXPECT_EQ(out.code, 0);
    EXPECT_THAT(out.text, HasSubstr(kind + ": " + name + "\n"));
  }
  EXPECT_THAT(ExecutePhs("show backlash").text, HasSubstr("gap_m"));
  EXPECT_THAT(ExecutePhs("show bo_bo").text, HasSubstr("\nname: bo_bo\n"));
}

TEST(ListTest, AMistypedNameOrKindIsAnswered) {
  const Output name = ExecutePhs("show backlsh");
  EXPECT_EQ(name.code, 3);
  EXPECT_THAT(name.text, HasSubstr("did you mean 'backlash'"));
  EXPECT_EQ(ExecutePhs("list bogie").code, 2);
}

}  // namespace
}  // namespace phs
