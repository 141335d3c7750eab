// docs/phs_models.md names every key of a model file and every effect as the program has them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "effects/catalogue.h"
#include "phs_model/phs_model.h"

namespace phs::effects {

using phs_model::FindPhsParams;
namespace {

const std::string kDocument = std::string(PHS_SOURCE_DIR) + "/docs/phs_models.md";
const std::string kBegin =
    "<!-- effects: written by PHS_WRITE_DOCS=1 test_phs_model --gtest_filter=PhsModelsDoc.* -->\n";
const std::string kEnd = "<!-- /effects -->";

std::string Document() {
  std::ifstream file(kDocument);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string Bounds(double low, double high) { return fmt::format("{:g} … {:g}", low, high); }

std::string EffectText(const hydraulics::EffectInfo& effect) {
  std::string text = fmt::format("### `{}`\n{}: {}.", effect.name, effect.family, effect.text);
  if (!effect.targets.empty()) text += " Acts on " + effect.targets + ".";
  if (effect.has_formula) {
    return text +
           " Needs `formula:`; keys and variables: [identify.md](identify.md), "
           "src/effects/formula.h.\n\n";
  }
  text += "\n\n| key | unit | default | allowed | plausible | |\n|---|---|---|---|---|---|\n";
  for (const hydraulics::EffectParameter& p : effect.parameters) {
    text += fmt::format("| `{}` | {} | {:g} | {} | {} | {} |\n", p.name, p.unit, p.otherwise,
                        Bounds(p.min, p.max), Bounds(p.low, p.high), p.text);
  }
  return text + "\n";
}

std::string EffectsText() {
  std::string text;
  for (const hydraulics::EffectInfo& effect : Catalogue().effects()) text += EffectText(effect);
  return text;
}

TEST(PhsModelsDoc, HasEveryEffectAsTheCatalogueSaysIt) {
  std::string document = Document();
  const size_t begin = document.find(kBegin), end = document.find(kEnd);
  ASSERT_NE(begin, std::string::npos);
  ASSERT_NE(end, std::string::npos);
  const size_t from = begin + kBegin.size();
  if (std::getenv("PHS_WRITE_DOCS") != nullptr) {
    std::ofstream(kDocument) << document.replace(from, end - from, EffectsText());
    document = Document();
  }
  EXPECT_EQ(document.substr(from, document.find(kEnd) - from), EffectsText())
      << "write it anew: see the comment in docs/phs_models.md";
}

TEST(PhsModelsDoc, HasEveryNumberOfTheModel) {
  const std::string document = Document();
  const auto params = FindPhsParams("bo_bo");
  ASSERT_TRUE(params.ok());
  for (const phs_model::ParameterInfo& p : phs_model::ListParameters(params.value())) {
    const std::string key = p.name.substr(p.name.rfind('.') + 1);
    EXPECT_NE(document.find(key), std::string::npos) << p.name;
  }
}

}  // namespace
}  // namespace phs::effects
