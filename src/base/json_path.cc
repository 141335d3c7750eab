#include "base/json_path.h"

#include <limits>
#include <sstream>

#include "base/words.h"

namespace phs {
namespace {

using Json = nlohmann::ordered_json;

/// The part of `node` called `part`: a key of a map or the entry of a list with that name.
const Json* PartOf(const Json& node, const std::string& part) {
  if (node.is_object()) {
    const auto found = node.find(part);
    return found == node.end() ? nullptr : &*found;
  }
  if (!node.is_array()) return nullptr;
  for (const Json& entry : node) {
    if (entry.is_object() && entry.value("name", "") == part) return &entry;
  }
  return nullptr;
}

void CollectPaths(const Json& node, const std::string& path, std::vector<std::string>* paths) {
  const std::string dot = path.empty() ? "" : path + ".";
  if (node.is_number() || (node.is_null() && !path.empty())) {
    paths->push_back(path);
  } else if (node.is_object()) {
    for (const auto& [key, value] : node.items()) CollectPaths(value, dot + key, paths);
  } else if (node.is_array()) {
    for (const Json& entry : node) {
      if (entry.is_object() && entry.contains("name")) {
        CollectPaths(entry, dot + entry["name"].get<std::string>(), paths);
      }
    }
  }
}

}  // namespace

const Json* FindPath(const Json& document, const std::string& path) {
  const Json* node = &document;
  std::istringstream parts(path);
  for (std::string part; node != nullptr && std::getline(parts, part, '.');) {
    node = PartOf(*node, part);
  }
  return node;
}

std::vector<std::string> NumberPaths(const Json& document) {
  std::vector<std::string> paths;
  CollectPaths(document, "", &paths);
  return paths;
}

Result<double> NumberAt(const Json& document, const std::string& path) {
  const Json* found = FindPath(document, path);
  if (found != nullptr && found->is_number()) return found->get<double>();
  if (found != nullptr && found->is_null()) return std::numeric_limits<double>::quiet_NaN();
  return Error{path, "is no number of the result", "paths of numbers in summary.json",
               DidYouMean(path, NumberPaths(document), "check the path")};
}

}  // namespace phs
