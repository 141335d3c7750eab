// Parsing of one YAML document into a tree that is safe to read: what yaml.h's maps stand on.
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>

#include "base/result.h"

namespace phs {

/// Line of a node in its file, from 1; 0 for a node without a place.
int LineOf(const YAML::Node& node);

/// "a list", "a map", "nothing", or the scalar in quotes: for messages.
std::string Described(const YAML::Node& node);

/// Parses `text` (called `name` in messages). Refused: syntax errors, more than one document, a
/// root that is no map, keys that are no words or given twice, more than 64 levels, more than 16
/// MB, more than a million values (a value used through an alias counts every time).
Result<YAML::Node> ParseYamlDocument(const std::string& text, const std::string& name);

}  // namespace phs
