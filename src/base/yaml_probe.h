// What a reader of YAML asks for, found out from the reader itself: it is run again and again on a
// document that answers each of its questions in every way (is the key there? which of the words?),
// and what it asks is kept. So the schema of a kind of file (`phs schema`) cannot differ from what
// reads that file.
//
//   YamlShape shape = ProbeYaml(path, [&] { LoadScenario(path); });   // path: a file of that kind
//   Json schema = shape.ToJson();
//
// Each answer is tried once, in the first place where it can be given. A bound or a default that is
// not the same in every run depends on other values and is left out.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/range.h"

namespace phs {

/// What was asked about one map.
struct YamlShape {
  /// About one key.
  struct Value {
    std::set<std::string> kinds;  ///< number, integer, bool, text, word, numbers, texts, map, maps
    std::optional<Range> range;
    std::vector<std::string> words;
    std::optional<nlohmann::ordered_json> otherwise;  ///< null: differs from run to run
    std::shared_ptr<YamlShape> map;                   ///< of a map, or of each map of a list
    int required = 0;                                 ///< runs that cannot do without it
  };
  std::string path;                ///< "lines[].reservoir."
  std::vector<std::string> order;  ///< keys as first asked
  std::map<std::string, Value> values;
  bool names = false;  ///< its keys are names: `values[kAnyName]` is what each of them holds
  int visits = 0;      ///< runs that came here

  static constexpr char kAnyName[] = "NAME";
  /// JSON schema (draft 7).
  nlohmann::ordered_json ToJson() const;
};

/// All that `read` asks of the document at `path`.
YamlShape ProbeYaml(const std::string& path, const std::function<void()>& read);

/// The side of YamlMap: one run of the reader.
class YamlProbe {
 public:
  using Json = nlohmann::ordered_json;
  /// The probe that is to answer for the document `path`; null: it is read as it is.
  static YamlProbe* For(const std::string& path);

  YamlShape* root() { return root_; }
  bool Has(YamlShape* map, std::string_view key);
  bool IsMap(YamlShape* map, std::string_view key);
  double Number(YamlShape* map, std::string_view key, const Range& range,
                std::optional<double> otherwise);
  int Integer(YamlShape* map, std::string_view key, const Range& range,
              std::optional<int> otherwise);
  bool Bool(YamlShape* map, std::string_view key, bool otherwise);
  std::string Text(YamlShape* map, std::string_view key, std::optional<std::string> otherwise);
  std::string Word(YamlShape* map, std::string_view key, const std::vector<std::string>& words,
                   std::optional<std::string> otherwise);
  std::vector<double> Numbers(YamlShape* map, std::string_view key, const Range& range,
                              bool required);
  std::vector<std::string> Texts(YamlShape* map, std::string_view key);
  /// The shape of the map below `key`, or of the maps of the list there.
  YamlShape* Map(YamlShape* map, std::string_view key, bool list);
  /// The keys of a reader that asks for each it knows (Has) before it takes them in their order; else
  /// one key that stands for any name.
  std::vector<std::string> Keys(YamlShape* map);

 private:
  friend YamlShape ProbeYaml(const std::string& path, const std::function<void()>& read);
  using Choices = std::map<std::string, int>;
  struct Made {
    std::string question;
    int choice, choices;
  };
  int Choose(const std::string& question, int choices);
  YamlShape::Value& Asked(YamlShape* map, std::string_view key, const char* kind, bool required);
  void Keep(const Json& otherwise, YamlShape::Value* value);
  void Visit(YamlShape* map);
  void EndRun();

  std::string path_;
  YamlShape* root_ = nullptr;
  Choices given_;
  std::vector<Made> made_;
  bool high_ = false;  ///< which end of the ranges values are taken from
  std::set<YamlShape*> visited_;
  std::set<YamlShape::Value*> required_;
};

}  // namespace phs
