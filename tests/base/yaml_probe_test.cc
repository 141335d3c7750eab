// What a probe learns from a reader: every key, also those behind a choice, and nothing else.
#include "base/yaml_probe.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/yaml.h"
#include "tests/base/scratch_dir.h"

namespace phs {
namespace {

using Json = nlohmann::ordered_json;

/// A reader with all that readers do: a choice by word, keys that exclude each other, lists, names.
void Read(const std::string& path) {
  auto doc = YamlMap::Load(path);
  if (!doc.ok()) return;
  YamlMap& map = doc.value();
  const double width = map.Number("width_m", {.min = 0, .max = 2, .open_min = true});
  map.Number("inset_m", {.min = 0, .max = width}, 0.0);
  if (map.Has("speed_m_s")) {
    map.Number("speed_m_s", {.min = 1});
  } else {
    map.Number("speed_km_h", {.min = 3.6});
  }
  const std::string kind = map.Word("kind", {"plain", "deep"});
  if (kind == "deep") {
    for (YamlMap entry : map.Maps("parts")) {
      entry.Text("name");
      if (entry.Bool("heavy", false)) entry.Number("mass_kg", {.min = 0}, 5.0);
    }
  }
  if (map.IsMap("friction")) {
    map.Map("friction").Integer("level", 1, 9, 3);
  } else {
    map.Number("friction", {.min = 0, .max = 1}, 0.3);
  }
  YamlMap named = map.Map("columns");
  for (const std::string& key : named.Keys()) named.Text(key);
  map.Numbers("levels", {.min = -1}, {});
  if (!map.Finish().ok()) return;
  ADD_FAILURE() << "a probe was taken for a document";
}

class YamlProbeTest : public testing::Test {
 protected:
  YamlProbeTest() {
    const std::string path = dir_.Write("any.yaml", "of: no matter\n");
    schema_ = ProbeYaml(path, [&] { Read(path); }).ToJson();
  }
  const Json& At(const std::string& pointer) const {
    return schema_.at(Json::json_pointer("/properties/" + pointer));
  }
  ScratchDir dir_;
  Json schema_;
};

TEST_F(YamlProbeTest, RangesWordsAndDefaults) {
  EXPECT_EQ(At("width_m"),
            Json::parse(R"({"type":"number","exclusiveMinimum":0.0,"maximum":2.0})"));
  EXPECT_EQ(At("kind"), Json::parse(R"({"enum":["plain","deep"]})"));
  EXPECT_EQ(At("levels/items/minimum"), -1);
  EXPECT_EQ(schema_["additionalProperties"], false);
}

TEST_F(YamlProbeTest, ABoundThatDependsOnAnotherValueIsLeftOut) {
  EXPECT_EQ(At("inset_m"), Json::parse(R"({"type":"number","minimum":0.0,"default":0.0})"));
}

TEST_F(YamlProbeTest, KeysBehindChoicesAreFound) {
  EXPECT_EQ(At("parts/items/properties/mass_kg/default"), 5.0);
  EXPECT_EQ(At("parts/items/required"), Json::parse(R"(["name"])"));
  EXPECT_EQ(At("speed_km_h/minimum"), 3.6);
  EXPECT_EQ(At("friction/anyOf").size(), 2u) << "a number or a map";
}

TEST_F(YamlProbeTest, OnlyWhatEveryRunNeedsIsRequired) {
  EXPECT_EQ(schema_["required"], Json::parse(R"(["width_m","kind"])"));
}

TEST_F(YamlProbeTest, NamesAsKeys) {
  EXPECT_TRUE(At("columns/additionalProperties").is_object());
  EXPECT_EQ(At("columns/properties").size(), 0u);
}

TEST(YamlProbe, OtherDocumentsAreReadAsTheyAre) {
  ScratchDir dir;
  const std::string probed = dir.Write("probed.yaml", "a: 1\n");
  const std::string other = dir.Write("other.yaml", "a: 7\n");
  double value = 0;
  ProbeYaml(probed, [&] { value = YamlMap::Load(other).value().Number("a", {}); });
  EXPECT_EQ(value, 7);
}

}  // namespace
}  // namespace phs
