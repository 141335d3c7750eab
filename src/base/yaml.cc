#include "base/yaml.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

#include "base/numbers.h"
#include "base/origin.h"
#include "base/result_dir.h"
#include "base/yaml_document.h"
#include "base/yaml_probe.h"

namespace phs {

/// What all maps of one document share.
struct YamlMap::Document {
  std::string path;
  std::optional<Error> error;
  /// The map and the key where `error` says that it is missing.
  std::pair<const Impl*, std::string> missing = {nullptr, ""};
};

struct YamlMap::Impl {
  std::shared_ptr<Document> document;
  std::string prefix;  ///< "a.b."
  struct Entry {
    std::string key;
    int line;
    YAML::Node node;
  };
  std::vector<Entry> entries;
  std::set<std::string> asked;
  std::map<std::string, std::shared_ptr<Impl>> children;  ///< by name: asked twice, the same one
  int line = 1;
  YamlProbe* probe = nullptr;  ///< answers in place of a document
  YamlShape* shape = nullptr;  ///< where it keeps what is asked of this map

  void Read(const YAML::Node& node) {
    if (!node.IsMap()) return;
    line = LineOf(node);
    for (const auto& item : node) {
      entries.push_back({item.first.Scalar(), LineOf(item.first), item.second});
    }
  }
  const YAML::Node* Find(std::string_view key) {
    asked.insert(std::string(key));
    for (const Entry& entry : entries) {
      if (entry.key == key) return &entry.node;
    }
    return nullptr;
  }
  int LineOfKey(std::string_view key) const {
    for (const Entry& entry : entries) {
      if (entry.key == key) return entry.line;
    }
    return line;
  }
  std::string Where(std::string_view key) const {
    return fmt::format("{}:{}: {}{}", document->path, LineOfKey(key), prefix, key);
  }
  void Fail(Error error) {
    if (!document->error) document->error = std::move(error);
  }
  void Missing(std::string_view key, const std::string& allowed) {
    if (!document->error) document->missing = {this, std::string(key)};
    Fail({Where(key), "is missing", allowed, "add it"});
  }
  std::set<std::string> Given() const {
    std::set<std::string> given;
    for (const Entry& entry : entries) given.insert(entry.key);
    return given;
  }
  /// The key that stands there mistyped: for the missing one, or for another that is not there
  /// either. Once all keys have been asked for.
  std::optional<Error> MistypedFor(const std::string& missing) const {
    const std::set<std::string> given = Given();
    std::vector<std::string> unknown, absent;
    std::set_difference(given.begin(), given.end(), asked.begin(), asked.end(),
                        std::back_inserter(unknown));
    std::set_difference(asked.begin(), asked.end(), given.begin(), given.end(),
                        std::back_inserter(absent));
    const std::vector<std::string> known(asked.begin(), asked.end());
    const auto told = [&](const std::string& found, const std::string& meant) {
      return Error{Where(found), "unknown key", JoinWords(known),
                   DidYouMean(found, known, "did you mean " + Quoted(meant) + "?")};
    };
    const std::string found = NearestWord(missing, unknown);
    if (!found.empty()) return told(found, missing);
    for (const std::string& key : unknown) {
      const std::string meant = NearestWord(key, absent);
      if (!meant.empty()) return told(key, meant);
    }
    return std::nullopt;
  }
  double ToNumber(const std::string& where, const YAML::Node& node, const Range& range) {
    const auto value = node.IsScalar() ? ParseNumber(node.Scalar()) : std::nullopt;
    if (value && range.Contains(*value)) return *value;
    if (value) {
      Fail({where, Shortest(*value) + " is out of range", range.Text(), ""});
    } else {
      Fail({where, Described(node) + " is no number", range.Text(), ""});
    }
    return 0;
  }
  std::shared_ptr<Impl> Child(const std::string& name, const YAML::Node& node) {
    if (const auto known = children.find(name); known != children.end()) return known->second;
    auto child = std::make_shared<Impl>();
    child->document = document;
    child->prefix = prefix + name + ".";
    child->line = line;
    child->Read(node);
    children[name] = child;
    return child;
  }
  std::shared_ptr<Impl> Probed(std::string_view key, bool list) {
    auto child = std::make_shared<Impl>();
    child->document = document;
    child->probe = probe;
    child->shape = probe->Map(shape, key, list);
    return child;
  }
  /// Keeps in `first` the topmost unknown key of this map and those read from it.
  void FindUnknown(std::optional<std::pair<int, Error>>* first) const {
    for (const auto& [key, at, node] : entries) {
      if (asked.count(key) > 0) continue;
      if (*first && (*first)->first <= at) break;
      const std::vector<std::string> known(asked.begin(), asked.end());
      *first = {at, Error{Where(key), "unknown key", JoinWords(known),
                          DidYouMean(key, known, "remove it")}};
      break;
    }
    for (const auto& [name, child] : children) child->FindUnknown(first);
  }
};

Result<YamlMap> YamlMap::Load(const std::string& path) {
  auto text = ReadFile(path);
  if (!text.ok()) return text.error();
  NoteInput(path, text.value());
  return Parse(text.value(), path);
}

Result<YamlMap> YamlMap::Parse(const std::string& text, const std::string& name) {
  auto root = ParseYamlDocument(text, name);
  if (!root.ok()) return root.error();
  auto impl = std::make_shared<Impl>();
  impl->document = std::make_shared<Document>();
  impl->document->path = name;
  impl->Read(root.value());
  impl->probe = YamlProbe::For(name);
  if (impl->probe != nullptr) impl->shape = impl->probe->root();
  return YamlMap(impl);
}

bool YamlMap::Has(std::string_view key) const {
  if (impl_->probe != nullptr) return impl_->probe->Has(impl_->shape, key);
  return impl_->Find(key) != nullptr;
}

bool YamlMap::IsMap(std::string_view key) const {
  if (impl_->probe != nullptr) return impl_->probe->IsMap(impl_->shape, key);
  const YAML::Node* node = impl_->Find(key);
  return node != nullptr && node->IsMap();
}

double YamlMap::Number(std::string_view key, const Range& range) {
  if (impl_->probe != nullptr) return impl_->probe->Number(impl_->shape, key, range, {});
  const YAML::Node* node = impl_->Find(key);
  if (node == nullptr) {
    impl_->Missing(key, range.Text());
    return 0;
  }
  return impl_->ToNumber(impl_->Where(key), *node, range);
}

double YamlMap::Number(std::string_view key, const Range& range, double otherwise) {
  if (impl_->probe != nullptr) return impl_->probe->Number(impl_->shape, key, range, otherwise);
  const YAML::Node* node = impl_->Find(key);
  return node == nullptr ? otherwise : impl_->ToNumber(impl_->Where(key), *node, range);
}

int YamlMap::Integer(std::string_view key, int min, int max) {
  const Range range{static_cast<double>(min), static_cast<double>(max)};
  if (impl_->probe != nullptr) return impl_->probe->Integer(impl_->shape, key, range, {});
  const double value = Number(key, range);
  if (value != std::floor(value)) {
    Fail(key, Shortest(value) + " is no whole number", "whole numbers, " + range.Text());
    return min;
  }
  return static_cast<int>(value);
}

int YamlMap::Integer(std::string_view key, int min, int max, int otherwise) {
  if (impl_->probe != nullptr) {
    const Range range{static_cast<double>(min), static_cast<double>(max)};
    return impl_->probe->Integer(impl_->shape, key, range, otherwise);
  }
  return Has(key) ? Integer(key, min, max) : otherwise;
}

bool YamlMap::Bool(std::string_view key, bool otherwise) {
  if (impl_->probe != nullptr) return impl_->probe->Bool(impl_->shape, key, otherwise);
  const YAML::Node* node = impl_->Find(key);
  if (node == nullptr) return otherwise;
  const std::string text = node->IsScalar() ? node->Scalar() : "";
  if (text == "true" || text == "yes" || text == "on") return true;
  if (text == "false" || text == "no" || text == "off") return false;
  Fail(key, Described(*node) + " is neither true nor false", "true, false");
  return otherwise;
}

std::string YamlMap::Text(std::string_view key) {
  if (impl_->probe != nullptr) return impl_->probe->Text(impl_->shape, key, {});
  const YAML::Node* node = impl_->Find(key);
  if (node == nullptr) {
    impl_->Missing(key, "a word");
    return "";
  }
  return Text(key, "");
}

std::string YamlMap::Text(std::string_view key, std::string_view otherwise) {
  if (impl_->probe != nullptr) {
    return impl_->probe->Text(impl_->shape, key, std::string(otherwise));
  }
  const YAML::Node* node = impl_->Find(key);
  if (node == nullptr) return std::string(otherwise);
  if (!node->IsScalar()) {
    Fail(key, Described(*node) + " is no word", "a word");
    return std::string(otherwise);
  }
  return node->Scalar();
}

std::string YamlMap::Word(std::string_view key, const std::vector<std::string>& words) {
  if (impl_->probe != nullptr) return impl_->probe->Word(impl_->shape, key, words, {});
  if (impl_->Find(key) == nullptr) {
    impl_->Missing(key, JoinWords(words));
    return words.empty() ? "" : words[0];
  }
  return Word(key, words, words.empty() ? "" : words[0]);
}

std::string YamlMap::Word(std::string_view key, const std::vector<std::string>& words,
                          std::string_view otherwise) {
  if (impl_->probe != nullptr) {
    return impl_->probe->Word(impl_->shape, key, words, std::string(otherwise));
  }
  std::string word = Text(key, otherwise);
  if (word == otherwise || std::find(words.begin(), words.end(), word) != words.end()) return word;
  Fail(key, Quoted(word) + " is unknown", JoinWords(words), DidYouMean(word, words));
  return std::string(otherwise);
}

std::vector<double> YamlMap::Numbers(std::string_view key, const Range& range) {
  if (impl_->probe != nullptr) return impl_->probe->Numbers(impl_->shape, key, range, true);
  if (impl_->Find(key) == nullptr) {
    impl_->Missing(key, "a list of " + range.Text());
    return {};
  }
  return Numbers(key, range, {});
}

std::vector<double> YamlMap::Numbers(std::string_view key, const Range& range,
                                     std::vector<double> otherwise) {
  if (impl_->probe != nullptr) return impl_->probe->Numbers(impl_->shape, key, range, false);
  const YAML::Node* node = impl_->Find(key);
  if (node == nullptr) return otherwise;
  if (!node->IsSequence()) {
    Fail(key, Described(*node) + " is no list", "a list of numbers, " + range.Text());
    return otherwise;
  }
  std::vector<double> values;
  values.reserve(node->size());
  for (const auto& item : *node) {
    const std::string where =
        fmt::format("{}:{}: {}{}[{}]", path(), LineOf(item), impl_->prefix, key, values.size() + 1);
    values.push_back(impl_->ToNumber(where, item, range));
  }
  return values;
}

std::vector<std::string> YamlMap::Texts(std::string_view key) {
  if (impl_->probe != nullptr) return impl_->probe->Texts(impl_->shape, key);
  const YAML::Node* node = impl_->Find(key);
  std::vector<std::string> words;
  if (node == nullptr) return words;
  if (!node->IsSequence()) {
    Fail(key, Described(*node) + " is no list", "a list of words");
    return words;
  }
  for (const auto& item : *node) {
    if (!item.IsScalar()) {
      Fail(key, "holds " + Described(item) + " as a word", "a list of words");
      return {};
    }
    words.push_back(item.Scalar());
  }
  return words;
}

YamlMap YamlMap::Map(std::string_view key) {
  if (impl_->probe != nullptr) return YamlMap(impl_->Probed(key, false));
  const YAML::Node* node = impl_->Find(key);
  if (node != nullptr && !node->IsMap() && !node->IsNull()) {
    Fail(key, Described(*node) + " is no map", "lines of 'key: value'");
  }
  return YamlMap(impl_->Child(std::string(key), node == nullptr ? YAML::Node() : *node));
}

std::vector<YamlMap> YamlMap::Maps(std::string_view key) {
  if (impl_->probe != nullptr) return {YamlMap(impl_->Probed(key, true))};
  const YAML::Node* node = impl_->Find(key);
  std::vector<YamlMap> maps;
  if (node == nullptr) return maps;
  if (!node->IsSequence()) {
    Fail(key, Described(*node) + " is no list", "a list of maps");
    return maps;
  }
  int index = 0;
  for (const auto& item : *node) {
    if (!item.IsMap()) Fail(key, fmt::format("item {} is no map", index + 1), "a list of maps");
    maps.push_back(YamlMap(impl_->Child(fmt::format("{}[{}]", key, index++), item)));
  }
  return maps;
}

std::vector<std::string> YamlMap::Keys() const {
  if (impl_->probe != nullptr) return impl_->probe->Keys(impl_->shape);
  std::vector<std::string> keys;
  for (const auto& entry : impl_->entries) keys.push_back(entry.key);
  return keys;
}

void YamlMap::Fail(std::string_view key, std::string what, std::string allowed, std::string mend) {
  impl_->Fail({impl_->Where(key), std::move(what), std::move(allowed), std::move(mend)});
}

std::string YamlMap::Where(std::string_view key) const { return impl_->Where(key); }
const std::string& YamlMap::path() const { return impl_->document->path; }

Status YamlMap::Finish() const {
  // Nothing is made of the answers of a probe.
  if (impl_->probe != nullptr) return Error{path(), "is probed", "", ""};
  if (impl_->document->error) {
    const auto& [map, key] = impl_->document->missing;
    const auto mistyped = map == nullptr ? std::nullopt : map->MistypedFor(key);
    return mistyped ? *mistyped : *impl_->document->error;
  }
  std::optional<std::pair<int, Error>> first;
  impl_->FindUnknown(&first);
  return first ? Status(first->second) : Status();
}

}  // namespace phs
