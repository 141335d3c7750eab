#include "cli/schema_kinds.h"

#include <cmath>

#include "analysis/limits.h"
#include "base/data_path.h"
#include "base/yaml_probe.h"
#include "effects/catalogue.h"
#include "hydraulics/phs_numbers.h"
#include "jobs/design_study.h"
#include "measurement/manifest.h"
#include "phs_model/keys.h"
#include "phs_model/phs_model.h"
#include "rail/track_layout.h"
#include "sweep/study_file.h"
#include "validate/known_misses.h"
#include "vehicle/bogie_mapping.h"
#include "vehicle/running_effects.h"
#include "vehicle/scenario_file.h"

namespace phs::cli {
namespace {

using Json = nlohmann::ordered_json;
using hydraulics::EffectInfo;
using phs_model::FilePart;

/// One effect with its parameters, as `effects:` of a file has it.
Json EffectSchema(const EffectInfo& effect) {
  Json properties = Json::object();
  if (!effect.targets.empty()) {
    properties["targets"] = {{"type", "array"},
                             {"items", {{"type", {"string", "number"}}}},
                             {"description", effect.targets + "; all without"}};
  }
  if (effect.has_formula) properties["formula"] = {{"type", "string"}};
  for (const auto& p : effect.parameters) {
    Json& number =
        properties[p.name] = {{"type", "number"}, {"description", p.text + " [" + p.unit + "]"}};
    if (std::isfinite(p.min)) number["minimum"] = p.min;
    if (std::isfinite(p.max)) number["maximum"] = p.max;
    if (std::isfinite(p.otherwise)) number["default"] = p.otherwise;
  }
  return {{"type", {"object", "null"}},
          {"description", effect.text},
          {"properties", properties},
          {"additionalProperties", effect.has_formula ? Json({{"type", "number"}}) : Json(false)}};
}

void AddEffects(const std::vector<EffectInfo>& effects, Json* schema) {
  Json& node = (*schema)["properties"]["effects"];
  // Under any other name: a law that the file brings with it.
  const Json own = {
      {"type", "object"},
      {"description", "a law of one's own (docs/identify.md)"},
      {"properties",
       {{"formula", {{"type", "string"}}},
        {"targets", {{"type", "array"}, {"items", {{"type", {"string", "number"}}}}}}}},
      {"required", Json::array({"formula"})},
      {"additionalProperties", {{"type", "number"}}}};
  node = {
      {"type", {"object", "null"}}, {"properties", Json::object()}, {"additionalProperties", own}};
  for (const EffectInfo& effect : effects) node["properties"][effect.name] = EffectSchema(effect);
}

/// Puts a description at "end_stop.clearance_m" below `part`; a place that nobody reads gets none.
void Describe(const std::string& where, const std::string& text, Json* part) {
  Json* node = part;
  for (size_t begin = 0; begin <= where.size();) {
    const size_t end = std::min(where.find('.', begin), where.size());
    const auto properties = node->find("properties");
    if (properties == node->end()) return;
    const auto found = properties->find(where.substr(begin, end - begin));
    if (found == properties->end()) return;
    node = &*found;
    begin = end + 1;
  }
  (*node)["description"] = text;
}

template <typename Part>
void DescribeNumbers(Json* part) {
  for (const auto& row : hydraulics::Numbers<Part>()) {
    Describe(row.info.where, row.info.text + " [" + row.info.unit + "]", part);
  }
}

void AddPhsTexts(Json* schema) {
  AddEffects(effects::Catalogue().effects(), schema);
  Json& properties = (*schema)["properties"];
  DescribeNumbers<hydraulics::PhsParams>(schema);
  for (Json* part : {&properties["cylinder_defaults"], &properties["cylinders"]["items"]}) {
    DescribeNumbers<hydraulics::CylinderParams>(part);
  }
  for (Json* part : {&properties["line_defaults"], &properties["lines"]["items"]}) {
    DescribeNumbers<hydraulics::LineParams>(part);
  }
  for (const phs_model::KeyRow& row : phs_model::OtherKeys()) {
    if (row.part == FilePart::kWhole) Describe(row.where, row.text, schema);
    if (row.part == FilePart::kCylinder)
      Describe(row.where, row.text, &properties["cylinders"]["items"]);
    if (row.part == FilePart::kLine) Describe(row.where, row.text, &properties["lines"]["items"]);
  }
}

void AddScenarioEffects(Json* schema) {
  std::vector<EffectInfo> effects = effects::Catalogue().effects();
  for (const vehicle::RunningEffect& effect : vehicle::RunningEffects()) {
    effects.push_back(effect.info);
  }
  AddEffects(effects, schema);
}

constexpr SchemaKind kKinds[] = {
    {"scenario", "scenario of simulate, compare and curving (docs/scenarios.md)",
     [](const std::string& path) { static_cast<void>(vehicle::LoadScenario(path)); },
     &AddScenarioEffects},
    {"track", "track (docs/tracks.md)",
     [](const std::string& path) { static_cast<void>(rail::ReadTrackLayout(path, false, 20)); },
     nullptr},
    {"phs", "PHS model (docs/phs_models.md)",
     [](const std::string& path) { static_cast<void>(phs_model::LoadPhsParams(path)); },
     &AddPhsTexts},
    {"rig", "manifest of rig and identify (docs/rig.md, docs/identify.md)",
     [](const std::string& path) {
       static_cast<void>(measurement::LoadManifest(path, measurement::WindowNeed::kNone));
     },
     nullptr},
    {"study", "study of sweep (docs/sweep.md)",
     [](const std::string& path) { static_cast<void>(sweep::LoadStudy(path)); }, nullptr},
    {"design_study", "design study of study (docs/studies.md)",
     [](const std::string& path) { static_cast<void>(jobs::ReadDesignStudy(path)); }, nullptr},
    {"mapping", "mapping of a URDF bogie for import (docs/import.md)",
     [](const std::string& path) { static_cast<void>(vehicle::LoadBogieMapping(path)); }, nullptr},
    {"limits", "limits for --check (docs/checks.md)",
     [](const std::string& path) { static_cast<void>(analysis::LoadLimits(path)); }, nullptr},
    {"known_misses", "what `phs validate` is known to miss",
     [](const std::string& path) { static_cast<void>(validate::LoadKnownMisses(path)); }, nullptr},
};

}  // namespace

std::span<const SchemaKind> SchemaKinds() { return kKinds; }

std::vector<std::string> SchemaKindNames() {
  std::vector<std::string> names;
  for (const SchemaKind& kind : kKinds) names.emplace_back(kind.name);
  return names;
}

Result<Json> MakeSchema(const SchemaKind& kind) {
  // A readable file; what stands in it is not read.
  const auto path = FindData("scenario", "models/scenarios", "curve_r550", {".yaml"});
  if (!path.ok()) return path.error();
  const YamlShape shape = ProbeYaml(path.value(), [&] { kind.read(path.value()); });
  Json schema = {
      {"$schema", "http://json-schema.org/draft-07/schema#"},
      {"title", std::string("phs ") + kind.name},
      {"description", std::string("A ") + kind.text + "; made by `phs schema " + kind.name + "`"}};
  schema.update(shape.ToJson());
  if (kind.add != nullptr) kind.add(&schema);
  return schema;
}

}  // namespace phs::cli
