#include "base/yaml.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/numbers.h"
#include "base/result_dir.h"
#include "base/yaml_document.h"

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
  /// The key that stands there for a missing one, mistyped. Once all keys have been asked for.
  std::optional<Error> MistypedFor(const std::string& key) const {
    std::vector<std::string> unknown;
    for (const Entry& entry : entries) {
      if (asked.count(entry.key) == 0) unknown.push_back(entry.key);
    }
    const std::string found = NearestWord(key, unknown);
    if (found.empty()) return std::nullopt;
    return Error{Where(found), "unknown key",
                 JoinWords(std::vector<std::string>(asked.begin(), asked.end())),
                 DidYouMean(found, {key}, "did you mean " + Quoted(key) + "?")};
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
  return Parse(text.value(), path);
}

Result<YamlMap> YamlMap::Parse(const std::string& text, const std::string& name) {
  auto root = ParseYamlDocument(text, name);
  if (!root.ok()) return root.error();
  auto impl = std::make_shared<Impl>();
  impl->document = std::make_shared<Document>();
  impl->document->path = name;
  impl->Read(root.value());
  return YamlMap(impl);
}

bool YamlMap::Has(std::string_view key) const { return impl_->Find(key) != nullptr; }

bool YamlMap::IsMap(std::string_view key) const {
  const YAML::Node* node = impl_->Find(key);
  return node != nullptr && node->IsMap();
}

double YamlMap::Number(std::string_view key, const Range& range) {
  const YAML::Node* node = impl_->Find(key);
  if (node == nullptr) {
    impl_->Missing(key, range.Text());
    return 0;
  }
  return impl_->ToNumber(impl_->Where(key), *node, range);
}

double YamlMap::Number(std::string_view key, const Range& range, double otherwise) {
  const YAML::Node* node = impl_->Find(key);
  return node == nullptr ? otherwise : impl_->ToNumber(impl_->Where(key), *node, range);
}

int YamlMap::Integer(std::string_view key, int min, int max) {
  const Range range{static_cast<double>(min), static_cast<double>(max)};
  const double value = Number(key, range);
  if (value != std::floor(value)) {
    Fail(key, Shortest(value) + " is no whole number", "whole numbers, " + range.Text());
    return min;
  }
  return static_cast<int>(value);
}

int YamlMap::Integer(std::string_view key, int min, int max, int otherwise) {
  return Has(key) ? Integer(key, min, max) : otherwise;
}

bool YamlMap::Bool(std::string_view key, bool otherwise) {
  const YAML::Node* node = impl_->Find(key);
  if (node == nullptr) return otherwise;
  const std::string text = node->IsScalar() ? node->Scalar() : "";
  if (text == "true" || text == "yes" || text == "on") return true;
  if (text == "false" || text == "no" || text == "off") return false;
  Fail(key, Described(*node) + " is neither true nor false", "true, false");
  return otherwise;
}

std::string YamlMap::Text(std::string_view key) {
  const YAML::Node* node = impl_->Find(key);
  if (node == nullptr) {
    impl_->Missing(key, "a word");
    return "";
  }
  return Text(key, "");
}

std::string YamlMap::Text(std::string_view key, std::string_view otherwise) {
  const YAML::Node* node = impl_->Find(key);
  if (node == nullptr) return std::string(otherwise);
  if (!node->IsScalar()) {
    Fail(key, Described(*node) + " is no word", "a word");
    return std::string(otherwise);
  }
  return node->Scalar();
}

std::string YamlMap::Word(std::string_view key, const std::vector<std::string>& words) {
  if (impl_->Find(key) == nullptr) {
    impl_->Missing(key, JoinWords(words));
    return words.empty() ? "" : words[0];
  }
  return Word(key, words, words.empty() ? "" : words[0]);
}

std::string YamlMap::Word(std::string_view key, const std::vector<std::string>& words,
                          std::string_view otherwise) {
  const std::string word = Text(key, otherwise);
  if (word == otherwise || std::find(words.begin(), words.end(), word) != words.end()) return word;
  Fail(key, Quoted(word) + " is unknown", JoinWords(words), DidYouMean(word, words));
  return std::string(otherwise);
}

std::vector<double> YamlMap::Numbers(std::string_view key, const Range& range) {
  if (impl_->Find(key) == nullptr) {
    impl_->Missing(key, "a list of " + range.Text());
    return {};
  }
  return Numbers(key, range, {});
}

std::vector<double> YamlMap::Numbers(std::string_view key, const Range& range,
                                     std::vector<double> otherwise) {
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
  const YAML::Node* node = impl_->Find(key);
  if (node != nullptr && !node->IsMap() && !node->IsNull()) {
    Fail(key, Described(*node) + " is no map", "lines of 'key: value'");
  }
  return YamlMap(impl_->Child(std::string(key), node == nullptr ? YAML::Node() : *node));
}

std::vector<YamlMap> YamlMap::Maps(std::string_view key) {
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
