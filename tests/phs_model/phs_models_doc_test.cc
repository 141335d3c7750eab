// docs/phs_models.md is made from the rows of the program: every key of a model file with unit,
// range and default, and every effect. scripts/write_pages writes it anew.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "effects/catalogue.h"
#include "hydraulics/phs_numbers.h"
#include "phs_model/keys.h"
#include "phs_model/phs_model.h"
#include "tests/base/page_section.h"

namespace phs::phs_model {
namespace {

using hydraulics::CylinderParams;
using hydraulics::LineParams;
using hydraulics::PhsParams;

std::string Bounds(const Range& range) {
  if (range.open_min && range.min == 0) return fmt::format("> 0, ≤ {:g}", range.max);
  return fmt::format("{:g} … {:g}", range.min, range.max);
}

std::string Line(const std::string& key, const std::string& allowed, const std::string& otherwise,
                 const std::string& text) {
  return fmt::format("| `{}` | {} | {} | {} |\n", key, allowed, otherwise, text);
}

bool InBlock(const std::string& where, const std::string& block, bool nested) {
  if (nested) return true;
  const size_t dot = where.find('.');
  return (dot == std::string::npos ? "" : where.substr(0, dot)) == block;
}

/// The keys of a part; of the whole only those of `block`.
template <typename Part>
std::string KeysText(FilePart part, const std::string& block) {
  std::string text = "| key | unit, range | default | meaning |\n|---|---|---|---|\n";
  const bool nested = part != FilePart::kWhole;
  for (const KeyRow& row : OtherKeys()) {
    if (row.part != part || !InBlock(row.where, block, nested)) continue;
    text += Line(row.where, row.allowed, row.otherwise, row.text);
  }
  Part otherwise;
  for (const auto& row : hydraulics::Numbers<Part>()) {
    if (!InBlock(row.info.where, block, nested)) continue;
    std::string meaning = row.info.text;
    if (row.info.where != row.info.key) meaning += ". As a parameter: `" + row.info.key + "`";
    text += Line(row.info.where,
                 (row.info.unit == "-" ? "" : row.info.unit + ", ") + Bounds(row.info.allowed),
                 fmt::format("{:g}", row.of(otherwise)), meaning);
  }
  return text;
}

/// Where `phs identify` looks for it.
std::string SoughtText(const hydraulics::EffectSearch& search) {
  std::string where;
  const auto add = [&where](bool there, const char* rig) {
    if (there) where += (where.empty() ? "" : ", ") + std::string(rig);
  };
  add(!search.rig.empty(), "hydraulic rig");
  add(!search.steps.empty(), "table of steps");
  add(!search.bench.empty(), "bench");
  add(!search.bogie.empty(), "bogie");
  return where.empty() ? "" : " Looked for on: " + where + ".";
}

std::string EffectText(const hydraulics::EffectInfo& effect) {
  std::string text = fmt::format("### `{}`\n{}: {}.", effect.name, effect.family, effect.text);
  if (!effect.targets.empty()) text += " Acts on " + effect.targets + ".";
  text += SoughtText(effect.search);
  if (effect.has_formula) {
    return text +
           " Needs `formula:`; keys and variables: [identify.md](identify.md), "
           "src/effects/formula.h.\n\n";
  }
  text += "\n\n| key | unit | default | allowed | plausible | |\n|---|---|---|---|---|---|\n";
  for (const hydraulics::EffectParameter& p : effect.parameters) {
    text += fmt::format("| `{}` | {} | {:g} | {:g} … {:g} | {:g} … {:g} | {} |\n", p.name, p.unit,
                        p.otherwise, p.min, p.max, p.low, p.high, p.text);
  }
  return text + "\n";
}

std::string EffectsText() {
  std::string text;
  for (const auto& effect : effects::Catalogue().effects()) text += EffectText(effect);
  return text;
}

void ExpectSection(const std::string& name, const std::string& expected) {
  ExpectPageSection("phs_models.md", name, expected);
}

TEST(PhsModelsDoc, HasEveryKeyAndEffectAsTheProgramSaysIt) {
  ExpectSection("whole", KeysText<PhsParams>(FilePart::kWhole, ""));
  ExpectSection("cylinder", KeysText<CylinderParams>(FilePart::kCylinder, ""));
  ExpectSection("line", KeysText<LineParams>(FilePart::kLine, ""));
  ExpectSection("friction", KeysText<PhsParams>(FilePart::kWhole, "friction"));
  ExpectSection("element", KeysText<PhsParams>(FilePart::kWhole, "element"));
  ExpectSection("effects", EffectsText());
}

}  // namespace
}  // namespace phs::phs_model
