#include "base/yaml_document.h"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>

#include <optional>
#include <set>
#include <sstream>
#include <vector>

#include "base/words.h"

namespace phs {
namespace {

constexpr int kMaxDepth = 64;
constexpr int kMaxValues = 1'000'000;
constexpr size_t kMaxBytes = 16u << 20;

/// Walks a tree and stops at the first thing that no reader could hold.
class TreeCheck {
 public:
  explicit TreeCheck(std::string name) : name_(std::move(name)) {}

  std::optional<Error> Check(const YAML::Node& node, int depth) {
    if (depth > kMaxDepth) {
      return Fault(node, "nests too deeply", fmt::format("{} levels", kMaxDepth));
    }
    if (++values_ > kMaxValues) {
      return Fault(node, "holds too many values", fmt::format("{}, aliases counted", kMaxValues));
    }
    if (node.IsSequence()) return CheckSequence(node, depth);
    if (node.IsMap()) return CheckMap(node, depth);
    return std::nullopt;
  }

 private:
  Error Fault(const YAML::Node& node, std::string what, std::string allowed) const {
    return {fmt::format("{}:{}", name_, LineOf(node)), std::move(what), std::move(allowed), ""};
  }

  std::optional<Error> CheckSequence(const YAML::Node& node, int depth) {
    for (const auto& item : node) {
      if (auto error = Check(item, depth + 1)) return error;
    }
    return std::nullopt;
  }

  std::optional<Error> CheckMap(const YAML::Node& node, int depth) {
    std::set<std::string> keys;
    for (const auto& item : node) {
      if (!item.first.IsScalar()) return Fault(item.first, "a key is not a word", "words");
      const std::string& key = item.first.Scalar();
      if (!keys.insert(key).second) {
        return Error{fmt::format("{}:{}: {}", name_, LineOf(item.first), key), "is given twice",
                     "each key once", "remove one of the two"};
      }
      if (auto error = Check(item.second, depth + 1)) return error;
    }
    return std::nullopt;
  }

  std::string name_;
  int values_ = 0;
};

/// Notes where documents begin, and builds nothing.
class DocumentStarts : public YAML::EventHandler {
 public:
  void OnDocumentStart(const YAML::Mark& mark) override { lines_.push_back(mark.line + 1); }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t,
                const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}
  const std::vector<int>& lines() const { return lines_; }

 private:
  std::vector<int> lines_;
};

/// Line of the second document, if there is one. Never asks for a third: on a stray closing bracket
/// yaml-cpp gives documents without end.
std::optional<int> SecondDocument(const std::string& text) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  DocumentStarts starts;
  for (int i = 0; i < 2 && parser.HandleNextDocument(starts); ++i) {
  }
  if (starts.lines().size() < 2) return std::nullopt;
  return starts.lines()[1];
}

}  // namespace

int LineOf(const YAML::Node& node) { return node.Mark().line + 1; }

std::string Described(const YAML::Node& node) {
  if (node.IsMap()) return "a map";
  if (node.IsSequence()) return "a list";
  return node.IsScalar() ? Quoted(node.Scalar()) : "nothing";
}

Result<YAML::Node> ParseYamlDocument(const std::string& text, const std::string& name) {
  if (text.size() > kMaxBytes) return Error{name, "is too large", "at most 16 MB of YAML", ""};
  try {
    if (const auto line = SecondDocument(text)) {
      return Error{fmt::format("{}:{}", name, *line), "begins a second document",
                   "one document in a file", "remove what ends the first ('---', a stray bracket)"};
    }
    const YAML::Node document = YAML::Load(text);
    if (!document.IsMap()) return Error{name + ":1", "is no map", "lines of 'key: value'", ""};
    if (auto error = TreeCheck(name).Check(document, 0)) return *error;
    return document;
  } catch (const YAML::Exception& fault) {
    return Error{fmt::format("{}:{}", name, fault.mark.line + 1), fault.msg, "YAML",
                 "mend the syntax"};
  }
}

}  // namespace phs
