#include "base/yaml.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

namespace phs {
namespace {

constexpr int kMaxDepth = 64;

/// What all maps of one document share.
struct Document {
  std::string path;
  std::optional<Error> error;
};

std::optional<double> ParseNumber(const std::string& text) {
  const char* begin = text.c_str();
  const char* end = begin + text.size();
  if (begin != end && *begin == '+') ++begin;
  double value = 0;
  const auto [rest, fault] = std::from_chars(begin, end, value);
  if (fault != std::errc() || rest != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::string Join(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

int LineOf(const YAML::Node& node) { return node.Mark().line + 1; }

/// Refuses what a map of this reader cannot hold: aliases that nest too deeply, repeated keys.
std::optional<Error> CheckTree(const YAML::Node& node, const std::string& path, int depth) {
  if (depth > kMaxDepth) {
    return Error{fmt::format("{}:{}", path, LineOf(node)), "nests too deeply",
                 fmt::format("{} levels", kMaxDepth), ""};
  }
  if (node.IsSequence()) {
    for (const auto& item : node) {
      if (auto error = CheckTree(item, path, depth + 1)) return error;
    }
  }
  if (!node.IsMap()) return std::nullopt;
  std::set<std::string> keys;
  for (const auto& item : node) {
    if (!item.first.IsScalar()) {
      return Error{fmt::format("{}:{}", path, LineOf(item.first)), "a key is not a word", "words",
                   ""};
    }
    const std::string key = item.first.Scalar();
    if (!keys.insert(key).second) {
      return Error{fmt::format("{}:{}: {}", path, LineOf(item.first), key), "is given twice",
                   "each key once", "remove one of the two"};
    }
    if (auto error = CheckTree(item.second, path, depth + 1)) return error;
  }
  return std::nullopt;
}

}  // namespace

bool Range::Contains(double value) const {
  if (!std::isfinite(value)) return false;
  return (open_min ? value > min : value >= min) && (open_max ? value < max : value <= max);
}

std::string Range::Text() const {
  const bool has_min = std::isfinite(min);
  const bool has_max = std::isfinite(max);
  if (has_min && has_max) {
    return fmt::format("{:g} {} x {} {:g}", min, open_min ? "<" : "<=", open_max ? "<" : "<=", max);
  }
  if (has_min) return fmt::format("x {} {:g}", open_min ? ">" : ">=", min);
  if (has_max) return fmt::format("x {} {:g}", open_max ? "<" : "<=", max);
  return "finite numbers";
}

struct YamlMap::Impl {
  std::shared_ptr<Document> document;
  std::string prefix;  ///< "a.b."
  std::vector<std::pair<std::string, YAML::Node>> entries;
  std::set<std::string> asked;
  std::map<std::string, std::shared_ptr<Impl>> children;  ///< by name: asked twice, the same one
  int line = 1;

  void Read(const YAML::Node& node) {
    line = LineOf(node);
    if (!node.IsMap()) return;
    for (const auto& item : node) entries.emplace_back(item.first.Scalar(), item.second);
  }
  const YAML::Node* Find(std::string_view key) {
    asked.insert(std::string(key));
    for (const auto& entry : entries) {
      if (entry.first == key) return &entry.second;
    }
    return nullptr;
  }
  std::string Where(std::string_view key) const {
    int at = line;
    for (const auto& entry : entries) {
      if (entry.first == key) at = LineOf(entry.second);
    }
    return fmt::format("{}:{}: {}{}", document->path, at, prefix, key);
  }
  void Fail(Error error) {
    if (!document->error) document->error = std::move(error);
  }
  void Missing(std::string_view key, const std::string& allowed) {
    Fail({Where(key), "is missing", allowed, "add it"});
  }
  double ToNumber(std::string_view key, const YAML::Node& node, const Range& range) {
    const auto value = node.IsScalar() ? ParseNumber(node.Scalar()) : std::nullopt;
    if (!value) {
      Fail({Where(key),
            fmt::format("'{}' is no number", node.IsScalar() ? node.Scalar() : "a list"),
            range.Text(), ""});
      return 0;
    }
    if (!range.Contains(*value)) {
      Fail({Where(key), fmt::format("{:g} is out of range", *value), range.Text(), ""});
      return 0;
    }
    return *value;
  }
  std::shared_ptr<Impl> Child(const std::string& name, const YAML::Node& node) {
    if (const auto known = children.find(name); known != children.end()) return known->second;
    auto child = std::make_shared<Impl>();
    child->document = document;
    child->prefix = prefix + name + ".";
    child->Read(node);
    children[name] = child;
    return child;
  }
  /// The first unknown key of this map and those read from it.
  std::optional<Error> Unknown() const {
    for (const auto& [key, node] : entries) {
      if (asked.count(key) > 0) continue;
      const std::vector<std::string> known(asked.begin(), asked.end());
      const std::string nearest = NearestWord(key, known);
      return Error{Where(key), "unknown key", Join(known),
                   nearest.empty() ? "remove it" : "did you mean '" + nearest + "'?"};
    }
    for (const auto& [name, child] : children) {
      if (auto error = child->Unknown()) return error;
    }
    return std::nullopt;
  }
};

Result<YamlMap> YamlMap::Load(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (!file || !(text << file.rdbuf())) {
    return Error{path, "cannot be read", "a readable YAML file", "check the path"};
  }
  return Parse(text.str(), path);
}

Result<YamlMap> YamlMap::Parse(const std::string& text, const std::string& name) {
  auto impl = std::make_shared<Impl>();
  impl->document = std::make_shared<Document>();
  impl->document->path = name;
  try {
    const YAML::Node root = YAML::Load(text);
    if (!root.IsMap()) return Error{name + ":1", "is no map", "lines of 'key: value'", ""};
    if (auto error = CheckTree(root, name, 0)) return *error;
    impl->Read(root);
  } catch (const YAML::Exception& e) {
    return Error{fmt::format("{}:{}", name, e.mark.line + 1), e.msg, "YAML", "mend the syntax"};
  }
  return YamlMap(impl);
}

bool YamlMap::Has(std::string_view key) const { return impl_->Find(key) != nullptr; }

double YamlMap::Number(std::string_view key, const Range& range) {
  const YAML::Node* node = impl_->Find(key);
  if (node == nullptr) {
    impl_->Missing(key, range.Text());
    return 0;
  }
  return impl_->ToNumber(key, *node, range);
}

double YamlMap::Number(std::string_view key, const Range& range, double otherwise) {
  const YAML::Node* node = impl_->Find(key);
  return node == nullptr ? otherwise : impl_->ToNumber(key, *node, range);
}

int YamlMap::Integer(std::string_view key, int min, int max) {
  const Range range{static_cast<double>(min), static_cast<double>(max)};
  const double value = Number(key, range);
  if (value != std::floor(value)) {
    Fail(key, fmt::format("{:g} is no whole number", value), "whole numbers, " + range.Text());
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
  Fail(key, "'" + text + "' is neither true nor false", "true, false");
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
    Fail(key, "is no word", "a word");
    return std::string(otherwise);
  }
  return node->Scalar();
}

std::string YamlMap::Word(std::string_view key, const std::vector<std::string>& words) {
  if (impl_->Find(key) == nullptr) {
    impl_->Missing(key, Join(words));
    return words.empty() ? "" : words[0];
  }
  return Word(key, words, words.empty() ? "" : words[0]);
}

std::string YamlMap::Word(std::string_view key, const std::vector<std::string>& words,
                          std::string_view otherwise) {
  const std::string word = Text(key, otherwise);
  if (word == otherwise || std::find(words.begin(), words.end(), word) != words.end()) return word;
  const std::string nearest = NearestWord(word, words);
  Fail(key, "'" + word + "' is unknown", Join(words),
       nearest.empty() ? "" : "did you mean '" + nearest + "'?");
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
    Fail(key, "is no list", "a list of numbers, " + range.Text());
    return otherwise;
  }
  std::vector<double> values;
  for (const auto& item : *node) values.push_back(impl_->ToNumber(key, item, range));
  return values;
}

std::vector<std::string> YamlMap::Texts(std::string_view key) {
  const YAML::Node* node = impl_->Find(key);
  std::vector<std::string> words;
  if (node == nullptr) return words;
  if (!node->IsSequence()) {
    Fail(key, "is no list", "a list of words");
    return words;
  }
  for (const auto& item : *node) {
    if (!item.IsScalar()) {
      Fail(key, "holds something that is no word", "a list of words");
      return {};
    }
    words.push_back(item.Scalar());
  }
  return words;
}

YamlMap YamlMap::Map(std::string_view key) {
  const YAML::Node* node = impl_->Find(key);
  if (node != nullptr && !node->IsMap() && !node->IsNull()) {
    Fail(key, "is no map", "lines of 'key: value'");
  }
  return YamlMap(impl_->Child(std::string(key), node == nullptr ? YAML::Node() : *node));
}

std::vector<YamlMap> YamlMap::Maps(std::string_view key) {
  const YAML::Node* node = impl_->Find(key);
  std::vector<YamlMap> maps;
  if (node == nullptr) return maps;
  if (!node->IsSequence()) {
    Fail(key, "is no list", "a list of maps");
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
  for (const auto& entry : impl_->entries) keys.push_back(entry.first);
  return keys;
}

void YamlMap::Fail(std::string_view key, std::string what, std::string allowed, std::string mend) {
  impl_->Fail({impl_->Where(key), std::move(what), std::move(allowed), std::move(mend)});
}

std::string YamlMap::Where(std::string_view key) const { return impl_->Where(key); }
const std::string& YamlMap::path() const { return impl_->document->path; }

Status YamlMap::Finish() const {
  if (impl_->document->error) return *impl_->document->error;
  if (auto error = impl_->Unknown()) return *error;
  return {};
}

}  // namespace phs
