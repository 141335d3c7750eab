// The sentences of the first screen, made from the numbers of result.json.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/identify_glance.h"
#include "report/identify_parts.h"

namespace phs::report {
namespace {

using json = nlohmann::ordered_json;

json EffectsOf(const IdentifyResults& results) {
  return results.all.value("effects", json::array());
}

std::string TextAt(const IdentifyResults& results, const char* key) {
  const auto found = results.all.find(key);
  return found != results.all.end() && found->is_string() ? found->get<std::string>() : "";
}

std::string Joined(const std::vector<std::string>& parts) {
  std::string text;
  for (size_t i = 0; i < parts.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  }
  return text;
}

/// "gap 0.121 mm (95 %: 0.117 to 0.125)".
std::string Amount(const std::string& key, const json& parameter) {
  const ReadableName name = Readable(key);
  const bool plain = name.unit == "–";
  const auto number = [&](const char* at) {
    return FormatNumber(name.factor * NumberAt(parameter, at), FiguresOf(parameter));
  };
  std::string text = (plain ? Spaced(key) : name.words) + " " + number("/value");
  if (!plain) text += " " + name.unit;
  const bool known =
      std::isfinite(NumberAt(parameter, "/low")) && std::isfinite(NumberAt(parameter, "/high"));
  return known ? text + fmt::format(" (95 %: {} to {})", number("/low"), number("/high")) : text;
}

/// " in quarter_setup3" of an effect of one run among several.
std::string InRun(const json& effect) {
  const auto run = effect.find("run");
  return run != effect.end() && run->is_string() ? " in " + run->get<std::string>() : "";
}

/// Its name, place and formula, and its numbers where they are one or two.
std::string WithAmounts(const json& effect) {
  constexpr size_t kMost = 2;
  const std::string text = DescribeEffect(effect) + InRun(effect);
  const json parameters = effect.value("parameters", json::object());
  if (parameters.size() > kMost) {
    return text + fmt::format(" with {} numbers (table of effects)", parameters.size());
  }
  std::vector<std::string> amounts;
  for (const auto& [key, parameter] : parameters.items()) {
    amounts.push_back(Amount(key, parameter));
  }
  const json held = effect.value("held", json::object());
  for (const auto& [key, value] : held.items()) {
    amounts.push_back(Amount(key, {{"value", value}}) + " (held by its form)");
  }
  return amounts.empty() ? text : text + " with " + Joined(amounts);
}

/// Each name once: an effect may act in several runs.
std::vector<std::string> Described(const json& effects, bool amounts) {
  std::vector<std::string> names;
  for (const json& effect : effects) {
    const std::string name = amounts ? WithAmounts(effect) : DescribeEffect(effect);
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  return names;
}

/// "backlash from mount compliance" of effects that the record does not tell apart.
std::string Rivals(const json& effects) {
  std::vector<std::string> parts;
  for (const json& effect : effects) {
    const json twins = effect.value("confusable_with", json::array());
    if (twins.empty()) continue;
    std::string others;
    for (const json& twin : twins) {
      if (!twin.is_string()) continue;
      others += (others.empty() ? " from " : " or ") + Spaced(twin.get<std::string>());
    }
    parts.push_back(DescribeEffect(effect) + others);
  }
  return Joined(parts);
}

std::string Sentence(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text.empty() || text.back() == '.' ? text : text + ".";
}

bool IsSteps(const IdentifyResults& results) { return TextAt(results, "rig") == "steps"; }

/// How well an accepted effect passed: its gains, or those of steps left out.
std::string EvidenceOf(const json& effect) {
  const double bic = NumberAt(effect, "/evidence/delta_bic");
  const double gain = NumberAt(effect, "/evidence/cross_validation_gain");
  std::vector<std::string> parts;
  if (std::isfinite(bic)) parts.push_back("ΔBIC " + FormatNumber(bic));
  if (std::isfinite(gain)) {
    parts.push_back(fmt::format("{} % less error on the parts of the record left out in turn",
                                FormatNumber(100 * gain)));
  }
  for (const auto& [before, after, what] :
       {std::tuple{"/evidence/error_left_out_before", "/evidence/error_left_out_after",
                   "the settled pressures"},
        std::tuple{"/evidence/error_begin_before", "/evidence/error_begin_after",
                   "the pressures just after the step"}}) {
    const double a = NumberAt(effect, before), b = NumberAt(effect, after);
    if (!std::isfinite(a) || !std::isfinite(b)) continue;
    parts.push_back(fmt::format("{} within {} % in place of {} %", what, FormatNumber(100 * b),
                                FormatNumber(100 * a)));
  }
  return Joined(parts);
}

/// The same of all; those with the same grounds together.
std::string Evidence(const json& effects) {
  std::vector<std::pair<std::string, std::vector<std::string>>> grounds;
  for (const json& effect : effects) {
    const std::string text = EvidenceOf(effect);
    if (text.empty()) continue;
    const auto same = std::find_if(grounds.begin(), grounds.end(),
                                   [&](const auto& ground) { return ground.first == text; });
    auto& names = same != grounds.end() ? same->second : grounds.emplace_back(text, 0).second;
    names.push_back(DescribeEffect(effect) + InRun(effect));
  }
  std::string text;
  for (const auto& [ground, names] : grounds) {
    text += (text.empty() ? "" : "; ") + Joined(names) +
            (names.size() > 1 ? " bring " : " brings ") + ground;
  }
  return text;
}

/// How far what is left stands above the noise.
std::string LeftOverNoise(const IdentifyResults& results) {
  const double over = NumberAt(results.all, "/unexplained/residual_over_noise");
  if (!std::isfinite(over)) return "";
  const json left = results.all.value("unexplained", json::object());
  const std::string channel = left.value("channel", "");
  return fmt::format("the worst channel{} is left with {} times its noise and uncertainty",
                     channel.empty() ? "" : ", " + Readable(channel).words + ",",
                     FormatNumber(over));
}

struct Change {
  double before = NAN, after = NAN;
};

/// What falls or rises by more than a twentieth.
std::pair<int, int> CountChanges(const json& channels) {
  constexpr double kSame = 0.05;
  int better = 0, worse = 0;
  for (const auto& [name, scores] : channels.items()) {
    const double a = NumberAt(scores, "/before/nrmse"), b = NumberAt(scores, "/after/nrmse");
    if (b < (1 - kSame) * a) ++better;
    if (b > (1 + kSame) * a) ++worse;
  }
  return {better, worse};
}

std::string StepsChanged(const json& channels) {
  std::vector<std::string> parts;
  for (const auto& [key, what] : {std::pair{"p_end_Pa", "settled pressure"},
                                  std::pair{"p_begin_Pa", "pressure just after the step"}}) {
    const json scores = channels.value(key, json::object());
    const Change c{NumberAt(scores, "/before/m_re_percent"),
                   NumberAt(scores, "/after/m_re_percent")};
    if (!std::isfinite(c.before) || !std::isfinite(c.after)) continue;
    parts.push_back(
        fmt::format("from {} % to {} % ({})", FormatNumber(c.before), FormatNumber(c.after), what));
  }
  if (parts.empty()) return "No error is known.";
  return "Of steps that took no part in their fit the mean relative error goes " + Joined(parts) +
         ".";
}

}  // namespace

VerdictWords WordsOfVerdict(const IdentifyResults& results) {
  const std::string word = TextAt(results, "verdict");
  std::string text = TextAt(results, "verdict_text");
  const json effects = EffectsOf(results);
  if (word == "sufficient")
    return {text.empty() ? "The declared model suffices." : Sentence(text), 0};
  if (word == "explained") {
    return {"Explained by " + Joined(Described(effects, false)) + ".", 0};
  }
  if (word == "undecidable") {
    return {Sentence(text.empty() ? "cannot be told from this record" : Spaced(text)), 1};
  }
  if (word == "not_described") return {"Not described by this model.", 2};
  if (!word.empty()) return {Sentence(Spaced(word)), 1};
  if (effects.empty()) return {"No effect was accepted.", 1};
  return {"Needed: " + Joined(Described(effects, false)) + ".", 1};
}

std::string WhatWasMissing(const IdentifyResults& results) {
  const json effects = EffectsOf(results);
  const std::string word = TextAt(results, "verdict");
  const size_t tried = results.all.value("candidates", json::array()).size();
  const std::string of = tried > 0 ? fmt::format(" of the {} candidates", tried) : "";
  if (effects.empty()) {
    if (word == "not_described") {
      return "Something is there that neither the declared model nor any" +
             (of.empty() ? std::string(" candidate") : of) +
             " describes, or the data contradict themselves: the reasons stand below.";
    }
    if (IsSteps(results)) {
      return "Nothing: no effect" + of + " lowers the error of the steps left out of the fit.";
    }
    return "No missing effect is supported by the data: with its free numbers fitted, the declared "
           "model says what can be said.";
  }
  const std::string lacks = "The declared model lacks " + Joined(Described(effects, true));
  if (word == "not_described") {
    return lacks +
           ", but that is not enough, or the data contradict themselves: the reasons stand below.";
  }
  return lacks + ".";
}

std::string HowSure(const IdentifyResults& results) {
  const json effects = EffectsOf(results);
  const std::string rivals = Rivals(effects);
  const std::string evidence = Evidence(effects);
  const std::string noise = LeftOverNoise(results);
  std::string text;
  if (!rivals.empty()) {
    text = "this record does not tell " + rivals + ": take the name as one of these";
  }
  const std::string steps = IsSteps(results) && !evidence.empty()
                                ? "every step was left out of the fit that foretells it"
                                : "";
  for (const std::string& part : {evidence, steps, noise}) {
    if (!part.empty()) text += (text.empty() ? "" : "; ") + part;
  }
  if (text.empty() && IsSteps(results)) {
    text =
        "every step was predicted by a fit without it, and no candidate did better than the "
        "declared model";
  }
  return text.empty() ? "The result holds no measure of it." : Sentence(text);
}

std::string WhatItChanged(const IdentifyResults& results) {
  const json channels = results.all.value("channels", json::object());
  if (IsSteps(results)) return StepsChanged(channels);
  const std::string lead = LeadingChannel(results);
  if (lead.empty()) return "No error is known.";
  const json scores = channels.value(lead, json::object());
  const ReadableName name = Readable(lead);
  const double a = NumberAt(scores, "/before/nrmse"), b = NumberAt(scores, "/after/nrmse");
  const double from = name.factor * NumberAt(scores, "/before/rmse");
  const double to = name.factor * NumberAt(scores, "/after/rmse");
  const auto [better, worse] = CountChanges(channels);
  std::string text =
      "On the validation window, which took no part in fit or choice, the error of "
      "the " +
      name.words;
  if (EffectsOf(results).empty()) {
    text += fmt::format(" is {} % of its standard deviation; nothing was added to the model",
                        FormatNumber(100 * b));
  } else {
    text += fmt::format(" goes from {} % to {} % of its standard deviation", FormatNumber(100 * a),
                        FormatNumber(100 * b));
    if (std::isfinite(from) && std::isfinite(to)) {
      text += fmt::format(" ({} to {} {})", FormatNumber(from), FormatNumber(to), name.unit);
    }
    if (channels.size() > 1) {
      text += fmt::format("; of {} channels {} get better and {} worse by more than 5 %",
                          channels.size(), better, worse);
    }
  }
  return text + ".";
}

std::string WhatNext(const IdentifyResults& results) {
  const std::vector<std::string> tests = NextTests(results);
  return tests.empty() ? "" : Sentence(tests.front());
}

std::string LeadingChannel(const IdentifyResults& results) {
  const json channels = results.all.value("channels", json::object());
  const json effects = EffectsOf(results);
  const auto named = [&](const json& part, const char* pointer) {
    const json::json_pointer at(pointer);
    const bool text = part.contains(at) && part.at(at).is_string();
    return text && channels.contains(part.at(at).get<std::string>())
               ? part.at(at).get<std::string>()
               : std::string();
  };
  std::vector<std::string> order;
  if (!effects.empty()) order.push_back(named(effects[0], "/evidence/best_channel"));
  if (effects.empty()) order.push_back(named(results.all, "/unexplained/channel"));
  order.push_back(named(results.all, "/localised/channel"));
  for (const std::string& name : order) {
    if (!name.empty()) return name;
  }
  return channels.empty() ? "" : channels.begin().key();
}

}  // namespace phs::report
