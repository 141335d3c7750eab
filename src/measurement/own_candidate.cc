#include "measurement/own_candidate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "effects/catalogue.h"
#include "effects/own_law.h"

namespace phs::measurement {
namespace {

/// True if `text` has `word` as a word of its own.
bool Says(const std::string& text, const std::string& word) {
  const auto letter = [&](size_t at) {
    return at < text.size() && std::isalnum(static_cast<unsigned char>(text[at]));
  };
  for (size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    if ((at == 0 || !letter(at - 1)) && !letter(at + word.size())) return true;
  }
  return false;
}

/// Letters, digits and underscores, a letter first: it stands in model.yaml and in paths of
/// numbers.
bool IsName(const std::string& text) {
  const auto fits = [](char c) { return c == '_' || std::isalnum(static_cast<unsigned char>(c)); };
  return !text.empty() && std::isalpha(static_cast<unsigned char>(text[0])) &&
         std::all_of(text.begin(), text.end(), fits);
}

std::string Expression(YamlMap& map, const std::string& key) {
  if (map.IsMap(key)) {
    map.Fail(key, "is a block", "one expression: of a state its rate, as it begins at 0",
             "states: {z_m: \"v - z/1[s]\"}");
    return "";
  }
  std::string text = map.Text(key);
  if (text.find_first_of(";=") != std::string::npos) {
    map.Fail(key, "holds a \"" + text.substr(text.find_first_of(";="), 1) + "\"", "one expression",
             "states have their own block: states: {z_m: \"v - z/1[s]\"}");
  }
  return text;
}

}  // namespace

OwnCandidate ReadOwnCandidate(YamlMap& candidates, const std::string& name,
                              const std::vector<std::string>& channels) {
  OwnCandidate out;
  out.where = candidates.Where(name);
  out.effect.name = name;
  YamlMap map = candidates.Map(name);
  effects::OwnLaw law;
  law.where = map.Word("where", effects::OwnPlaces());
  law.expression = Expression(map, "expression");
  std::string all = law.expression;
  YamlMap states = map.Map("states"), parameters = map.Map("parameters");
  for (const std::string& state : states.Keys()) {
    law.states.emplace_back(state, Expression(states, state));
    all += " " + law.states.back().second;
  }
  for (const std::string& channel : channels) {
    if (Says(all, channel.substr(0, channel.find('_')))) law.channels.push_back(channel);
  }
  for (const std::string& number : parameters.Keys()) {
    const std::vector<double> range = parameters.Numbers(number, {});
    if (range.size() != 2 || !(range[1] > range[0])) {
      std::string given;
      for (const double x : range) given += fmt::format("{}{:g}", given.empty() ? "" : ", ", x);
      parameters.Fail(number, "is no range: [" + given + "]", "[low, high], low < high");
      continue;
    }
    const bool by_factors = range[0] > 0 && range[1] > 20 * range[0];
    out.effect.values[number] =
        by_factors ? std::sqrt(range[0] * range[1]) : 0.5 * (range[0] + range[1]);
    out.numbers.push_back({number, range[0], range[1]});
  }
  if (out.numbers.empty()) {
    map.Fail("parameters", "names no number that could be sought",
             "parameters: {k_N_per_m: [1.0e3, 1.0e6]}, its amount first");
  }
  out.effect.targets = map.Texts("targets");
  out.effect.formula = effects::ToText(law);
  if (!IsName(name)) {
    candidates.Fail(name, "is no name", "letters, digits and _, a letter first");
  }
  if (effects::Catalogue().Find(name) != nullptr) {
    candidates.Fail(name, "is an effect of the catalogue", "another name for a law of one's own");
  }
  return out;
}

Status CheckNumbersAreUsed(const OwnCandidate& own) {
  for (const OwnCandidate::Number& number : own.numbers) {
    if (Says(own.effect.formula, number.name.substr(0, number.name.find('_')))) continue;
    return Error{own.where + ".parameters." + number.name,
                 "does not stand in the expression or in a state",
                 "numbers that the law uses, without their unit there", ""};
  }
  return {};
}

}  // namespace phs::measurement
