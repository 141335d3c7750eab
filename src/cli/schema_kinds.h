// JSON schemas (draft 7) of the YAML files that phs reads, for editors: keys, units, ranges, words.
// They are asked from the readers themselves (base/yaml_probe.h); effects and the texts of the numbers
// of a PHS come from their tables. `phs schema` prints them; models/schemas holds them for the files
// that ship (scripts/write_pages).
#pragma once

#include <nlohmann/json.hpp>
#include <span>

#include "base/result.h"

namespace phs::cli {

struct SchemaKind {
  const char* name;  ///< "scenario"
  const char* text;
  void (*read)(const std::string& path);
  void (*add)(nlohmann::ordered_json* schema);  ///< what tables know beside; may be null
};

std::span<const SchemaKind> SchemaKinds();
std::vector<std::string> SchemaKindNames();

/// The schema of a kind.
Result<nlohmann::ordered_json> MakeSchema(const SchemaKind& kind);

}  // namespace phs::cli
