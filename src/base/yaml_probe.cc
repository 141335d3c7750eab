#include "base/yaml_probe.h"

#include <algorithm>
#include <cmath>
#include <deque>

#include "base/check.h"

namespace phs {
namespace {

using Json = nlohmann::ordered_json;
using Value = YamlShape::Value;

constexpr size_t kMostRuns = 20000;

thread_local YamlProbe* active = nullptr;

/// A number that the range allows, nearer to its lower or to its upper end.
double Within(const Range& range, bool high) {
  const bool below = std::isfinite(range.min), above = std::isfinite(range.max);
  if (below && above) return range.min + (high ? 0.75 : 0.25) * (range.max - range.min);
  if (below) return range.min + (high ? 2 : 1);
  if (above) return range.max - (high ? 1 : 2);
  return high ? 2 : 1;
}

/// Two ranges of one number: a bound that differs depends on something and is none.
Range Both(Range a, const Range& b) {
  if (a.min != b.min || a.open_min != b.open_min) {
    a.min = -std::numeric_limits<double>::infinity();
    a.open_min = false;
  }
  if (a.max != b.max || a.open_max != b.open_max) {
    a.max = std::numeric_limits<double>::infinity();
    a.open_max = false;
  }
  return a;
}

Json NumberSchema(const Value& value, const char* type) {
  Json json = {{"type", type}};
  const Range range = value.range.value_or(Range{});
  if (std::isfinite(range.min)) json[range.open_min ? "exclusiveMinimum" : "minimum"] = range.min;
  if (std::isfinite(range.max)) json[range.open_max ? "exclusiveMaximum" : "maximum"] = range.max;
  return json;
}

/// Any scalar reads as a text: `name: 12` is the name "12".
Json TextSchema() { return {{"type", {"string", "number", "boolean"}}}; }

Json SchemaOf(const Value& value, const std::string& kind) {
  if (kind == "number" || kind == "integer") return NumberSchema(value, kind.c_str());
  if (kind == "numbers") return {{"type", "array"}, {"items", NumberSchema(value, "number")}};
  if (kind == "text") return TextSchema();
  if (kind == "texts") return {{"type", "array"}, {"items", TextSchema()}};
  if (kind == "word") return {{"enum", value.words}};
  if (kind == "bool") {
    return {{"anyOf", {{{"type", "boolean"}}, {{"enum", {"yes", "no", "on", "off"}}}}}};
  }
  if (kind == "maps") return {{"type", "array"}, {"items", value.map->ToJson()}};
  Json map = value.map->ToJson();
  map["type"] = {"object", "null"};
  return map;
}

/// A default outside the range stands for "not given".
bool IsUsable(const Value& value) {
  if (!value.otherwise || value.otherwise->is_null()) return false;
  if (!value.otherwise->is_number() || !value.range) return true;
  return value.range->Contains(value.otherwise->get<double>());
}

Json SchemaOf(const Value& value) {
  Json json = Json::object();
  if (value.kinds.size() == 1) {
    json = SchemaOf(value, *value.kinds.begin());
  } else if (!value.kinds.empty()) {
    for (const std::string& kind : value.kinds) json["anyOf"].push_back(SchemaOf(value, kind));
  }
  if (IsUsable(value)) json["default"] = *value.otherwise;
  return json;
}

}  // namespace

Json YamlShape::ToJson() const {
  Json json = {{"type", "object"}, {"properties", Json::object()}};
  Json required = Json::array();
  for (const std::string& key : order) {
    if (names && key == kAnyName) continue;
    const Value& value = values.at(key);
    json["properties"][key] = SchemaOf(value);
    if (value.required == visits) required.push_back(key);
  }
  if (!required.empty()) json["required"] = required;
  const auto any = values.find(kAnyName);
  json["additionalProperties"] = !names                ? Json(false)
                                 : any == values.end() ? Json::object()
                                                       : SchemaOf(any->second);
  return json;
}

YamlShape ProbeYaml(const std::string& path, const std::function<void()>& read) {
  YamlShape shape;
  std::set<std::pair<std::string, int>> tried;
  std::deque<YamlProbe::Choices> left = {{}};
  for (size_t runs = 0; !left.empty(); ++runs) {
    PHS_CHECK(runs < kMostRuns);
    YamlProbe probe;
    probe.path_ = path;
    probe.root_ = &shape;
    probe.given_ = left.front();
    left.pop_front();
    for (const bool high : {false, true}) {
      probe.high_ = high;
      probe.made_.clear();
      YamlProbe* const outer = std::exchange(active, &probe);
      read();
      active = outer;
      probe.EndRun();
      YamlProbe::Choices before;
      for (const YamlProbe::Made& made : probe.made_) {
        tried.insert({made.question, made.choice});
        for (int other = 0; other < made.choices; ++other) {
          if (!tried.insert({made.question, other}).second) continue;
          left.push_back(before);
          left.back()[made.question] = other;
        }
        before[made.question] = made.choice;
      }
    }
  }
  return shape;
}

YamlProbe* YamlProbe::For(const std::string& path) {
  return active != nullptr && active->path_ == path ? active : nullptr;
}

int YamlProbe::Choose(const std::string& question, int choices) {
  for (const Made& made : made_) {
    if (made.question == question) return made.choice;
  }
  const auto given = given_.find(question);
  const int choice = given == given_.end() ? 0 : std::min(given->second, choices - 1);
  made_.push_back({question, choice, choices});
  return choice;
}

void YamlProbe::Visit(YamlShape* map) { visited_.insert(map); }

YamlShape::Value& YamlProbe::Asked(YamlShape* map, std::string_view key, const char* kind,
                                   bool required) {
  Visit(map);
  const std::string name(key);
  const auto [at, is_new] = map->values.try_emplace(name);
  if (is_new) map->order.push_back(name);
  if (*kind != '\0') at->second.kinds.insert(kind);
  if (required) required_.insert(&at->second);
  return at->second;
}

void YamlProbe::Keep(const Json& otherwise, Value* value) {
  if (!value->otherwise) {
    value->otherwise = otherwise;
  } else if (*value->otherwise != otherwise) {
    value->otherwise = Json(nullptr);
  }
}

void YamlProbe::EndRun() {
  for (YamlShape* map : visited_) ++map->visits;
  for (Value* value : required_) ++value->required;
  visited_.clear();
  required_.clear();
}

bool YamlProbe::Has(YamlShape* map, std::string_view key) {
  Asked(map, key, "", false);
  return Choose("has " + map->path + std::string(key), 2) == 0;
}

bool YamlProbe::IsMap(YamlShape* map, std::string_view key) {
  Asked(map, key, "", false);
  return Choose("map " + map->path + std::string(key), 2) == 0;
}

double YamlProbe::Number(YamlShape* map, std::string_view key, const Range& range,
                         std::optional<double> otherwise) {
  Value& value = Asked(map, key, "number", !otherwise);
  value.range = value.range ? Both(*value.range, range) : range;
  if (otherwise) Keep(std::isfinite(*otherwise) ? Json(*otherwise) : Json(nullptr), &value);
  return otherwise && !high_ ? *otherwise : Within(range, high_);
}

int YamlProbe::Integer(YamlShape* map, std::string_view key, const Range& range,
                       std::optional<int> otherwise) {
  Value& value = Asked(map, key, "integer", !otherwise);
  value.range = value.range ? Both(*value.range, range) : range;
  if (otherwise) Keep(*otherwise, &value);
  // Few: such a number may be a count.
  return otherwise && !high_ ? *otherwise : static_cast<int>(range.min) + (high_ ? 1 : 0);
}

bool YamlProbe::Bool(YamlShape* map, std::string_view key, bool otherwise) {
  Keep(otherwise, &Asked(map, key, "bool", false));
  return Choose("bool " + map->path + std::string(key), 2) == 0;
}

std::string YamlProbe::Text(YamlShape* map, std::string_view key,
                            std::optional<std::string> otherwise) {
  Value& value = Asked(map, key, "text", !otherwise);
  if (otherwise) Keep(otherwise->empty() ? Json(nullptr) : Json(*otherwise), &value);
  return otherwise && !high_ ? *otherwise : YamlShape::kAnyName;
}

std::string YamlProbe::Word(YamlShape* map, std::string_view key,
                            const std::vector<std::string>& words,
                            std::optional<std::string> otherwise) {
  Value& value = Asked(map, key, "word", !otherwise);
  for (const std::string& word : words) {
    if (std::find(value.words.begin(), value.words.end(), word) == value.words.end()) {
      value.words.push_back(word);
    }
  }
  if (otherwise) Keep(otherwise->empty() ? Json(nullptr) : Json(*otherwise), &value);
  const int chosen = Choose("word " + map->path + std::string(key), static_cast<int>(words.size()));
  return words.empty() ? "" : words[static_cast<size_t>(chosen)];
}

std::vector<double> YamlProbe::Numbers(YamlShape* map, std::string_view key, const Range& range,
                                       bool required) {
  Value& value = Asked(map, key, "numbers", required);
  value.range = value.range ? Both(*value.range, range) : range;
  return {Within(range, high_)};
}

std::vector<std::string> YamlProbe::Texts(YamlShape* map, std::string_view key) {
  Asked(map, key, "texts", false);
  return {YamlShape::kAnyName};
}

YamlShape* YamlProbe::Map(YamlShape* map, std::string_view key, bool list) {
  Value& value = Asked(map, key, list ? "maps" : "map", false);
  if (!value.map) {
    value.map = std::make_shared<YamlShape>();
    value.map->path = map->path + std::string(key) + (list ? "[]." : ".");
  }
  Visit(value.map.get());
  return value.map.get();
}

std::vector<std::string> YamlProbe::Keys(YamlShape* map) {
  Visit(map);
  std::vector<std::string> known;
  for (const Made& made : made_) {
    const std::string has = "has " + map->path;
    const std::string key = made.question.substr(std::min(has.size(), made.question.size()));
    if (made.question.starts_with(has) && map->values.contains(key)) known.push_back(key);
  }
  if (!known.empty()) return known;
  map->names = true;
  return {YamlShape::kAnyName};
}

}  // namespace phs
