#include "analysis/limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/json_path.h"
#include "base/words.h"
#include "base/yaml.h"

namespace phs::analysis {
namespace {

using Json = nlohmann::ordered_json;

constexpr char kRatios[] = "ratios.";

Error UnknownQuantity(const Limit& limit, const Json& document, const std::string& prefix) {
  std::vector<std::string> known = NumberPaths(document);
  for (std::string& path : known) path.insert(0, prefix);
  return {limit.where, Quoted(limit.quantity) + " is no number of the result",
          "paths of numbers in the result, or ratios.A_over_B. and such a path",
          DidYouMean(limit.quantity, known, "check the path")};
}

/// A limit of words is for words, one of bounds for numbers.
bool Fits(const Limit& limit, const Json* found) {
  if (found == nullptr) return false;
  return limit.words.empty() ? found->is_number() || found->is_null() : found->is_string();
}

void AddWordCheck(const Limit& limit, const std::string& bogie, const std::string& word,
                  std::vector<LimitCheck>* checks) {
  const std::string claim = "one of " + JoinWords(limit.words);
  const bool kept = std::find(limit.words.begin(), limit.words.end(), word) != limit.words.end();
  checks->push_back(
      {bogie, limit.quantity, claim, 0, 0,
       kept ? "" : limit.quantity + " is " + Quoted(word) + ", " + claim + " allowed"});
}

void AddChecks(const Limit& limit, const std::string& bogie, const Json& found,
               std::vector<LimitCheck>* checks) {
  if (!limit.words.empty()) return AddWordCheck(limit, bogie, found.get<std::string>(), checks);
  double value = found.is_number() ? found.get<double>() : std::nan("");
  if (limit.of_magnitude) value = std::abs(value);
  const std::string of = limit.of_magnitude ? "magnitude " : "";
  if (std::isfinite(limit.at_most)) {
    checks->push_back({bogie, limit.quantity, fmt::format("{}at most {:g}", of, limit.at_most),
                       value, value - limit.at_most, ""});
  }
  if (std::isfinite(limit.at_least)) {
    checks->push_back({bogie, limit.quantity, fmt::format("{}at least {:g}", of, limit.at_least),
                       value, limit.at_least - value, ""});
  }
}

Status CheckBogies(const Limit& limit, const std::vector<NamedSummary>& summaries,
                   std::vector<LimitCheck>* checks) {
  std::vector<std::string> names;
  bool found_bogie = false;
  bool known = false;
  for (const auto& [bogie, summary] : summaries) {
    names.push_back(bogie);
    if (!limit.bogie.empty() && limit.bogie != bogie) continue;
    found_bogie = true;
    const Json* found = FindPath(summary, limit.quantity);
    known = known || Fits(limit, found);
    // Bogies differ in what they have: only those with this quantity are held to it.
    if (Fits(limit, found)) AddChecks(limit, bogie, *found, checks);
  }
  if (!found_bogie) {
    return Error{limit.where, Quoted(limit.bogie) + " is no bogie of this run", JoinWords(names),
                 DidYouMean(limit.bogie, names)};
  }
  if (known) return {};
  for (const auto& [bogie, summary] : summaries) {
    if (limit.bogie.empty() || limit.bogie == bogie) return UnknownQuantity(limit, summary, "");
  }
  return {};
}

std::string XmlText(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        // XML 1.0 has no other control characters, not even as references.
        out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return out;
}

}  // namespace

Result<std::vector<Limit>> LoadLimits(const std::string& path) {
  auto doc = YamlMap::Load(path);
  if (!doc.ok()) return doc.error();
  YamlMap& map = doc.value();
  std::vector<Limit> limits;
  for (YamlMap& entry : map.Maps("limits")) {
    Limit limit;
    limit.quantity = entry.Text("quantity");
    limit.where = entry.Where("quantity");
    limit.bogie = entry.Text("bogie", "");
    if (entry.Has("at_most")) limit.at_most = entry.Number("at_most", {});
    if (entry.Has("at_least")) limit.at_least = entry.Number("at_least", {});
    limit.of_magnitude = entry.Bool("magnitude", false);
    limit.words = entry.Texts("is");
    const bool bounds = std::isfinite(limit.at_most) || std::isfinite(limit.at_least);
    if (bounds && !limit.words.empty()) entry.Fail("is", "stands beside a bound", "one of them");
    if (limit.words.empty() && !std::isfinite(limit.at_most) && !std::isfinite(limit.at_least)) {
      entry.Number("at_most", {});  // is missing, or mistyped
    }
    if (limit.at_least > limit.at_most) entry.Fail("at_least", "is above at_most");
    limits.push_back(std::move(limit));
  }
  if (limits.empty()) map.Fail("limits", "is empty or missing", "a list of limits", "add one");
  if (Status s = map.Finish(); !s.ok()) return s.error();
  return limits;
}

bool LimitCheck::Passed() const { return reason.empty() && std::isfinite(value) && excess <= 0; }

std::string LimitCheck::Text() const {
  const std::string whose = bogie.empty() ? "" : bogie + ": ";
  if (!reason.empty()) return whose + reason;
  if (!std::isfinite(value)) {
    return fmt::format("{}{} has no value, {} asked: the run did not get there", whose, quantity,
                       claim);
  }
  std::string is = fmt::format("{}{} is {:.6g}, {} allowed", whose, quantity, value, claim);
  if (Passed()) return is;
  return fmt::format("{}: {:.4g} {}", is, excess,
                     claim.find("at most") != std::string::npos ? "too much" : "too little");
}

Result<std::vector<LimitCheck>> CheckLimits(const std::vector<Limit>& limits,
                                            const std::vector<NamedSummary>& summaries,
                                            const Json& ratios) {
  std::vector<LimitCheck> checks;
  for (const auto& [bogie, summary] : summaries) {
    const std::string status = summary.value("status", "");
    checks.push_back({bogie, "status", "ok", 0, 0,
                      status == "ok" ? "" : status + ": " + summary.value("reason", "")});
  }
  for (const Limit& limit : limits) {
    if (!limit.quantity.starts_with(kRatios)) {
      if (Status s = CheckBogies(limit, summaries, &checks); !s.ok()) return s.error();
      continue;
    }
    const Json* found = FindPath(ratios, limit.quantity.substr(sizeof kRatios - 1));
    if (!Fits(limit, found)) {
      return UnknownQuantity(limit, ratios, kRatios);
    }
    AddChecks(limit, "", *found, &checks);
  }
  return checks;
}

std::string JUnitXml(const std::string& suite, const std::vector<LimitCheck>& checks) {
  int failures = 0;
  for (const LimitCheck& check : checks) failures += check.Passed() ? 0 : 1;
  std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
  xml += fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\">\n",
                     XmlText(suite), checks.size(), failures);
  for (const LimitCheck& check : checks) {
    xml += fmt::format("    <testcase classname=\"{}\" name=\"{} {}\"",
                       XmlText(suite + "." + (check.bogie.empty() ? "ratios" : check.bogie)),
                       XmlText(check.quantity), XmlText(check.claim));
    if (check.Passed()) {
      xml += "/>\n";
    } else {
      const std::string text = XmlText(check.Text());
      xml +=
          fmt::format(">\n      <failure message=\"{0}\">{0}</failure>\n    </testcase>\n", text);
    }
  }
  return xml + "  </testsuite>\n</testsuites>\n";
}

}  // namespace phs::analysis
