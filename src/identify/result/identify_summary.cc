#include <fmt/format.h>

#include "base/words.h"
#include "identify/result/result_json.h"

namespace phs::identify::search {
namespace {

std::string NumbersOf(const Json& effect) {
  std::string out;
  for (const auto& [name, p] : effect["parameters"].items()) {
    out += fmt::format("  {} {:.4g} [{:.4g}, {:.4g}]", name, p["value"].get<double>(),
                       p["low"].get<double>(), p["high"].get<double>());
  }
  const Json held = effect.value("held", Json::object());
  for (const auto& [name, value] : held.items()) {
    out += fmt::format("  {} {:.4g} (held)", name, value.get<double>());
  }
  return out;
}

}  // namespace

std::string EffectLine(const Json& e) {
  std::string line = "effect " + e["name"].get<std::string>();
  if (e.contains("on")) line += " on " + JoinWords(e["on"].get<std::vector<std::string>>());
  if (e.contains("formula") && e["formula"].is_string()) {
    line += "  " + e["formula"].get<std::string>();
  }
  line += NumbersOf(e);
  line += fmt::format("  delta BIC {:.0f}", e["evidence"]["delta_bic"].get<double>());
  if (!e["confusable_with"].empty()) {
    line +=
        "  not told apart from " + JoinWords(e["confusable_with"].get<std::vector<std::string>>());
  }
  if (e.contains("form")) {
    line += "\n  and of its own form  " + e["form"]["formula"].get<std::string>() +
            NumbersOf(e["form"]);
  }
  return line + "\n";
}

std::string Summary(const Json& result) {
  std::string out = FindingLines(result);
  if (result.contains("verdict")) out += VerdictLines(result);
  for (const Json& e : result["effects"]) out += EffectLine(e);
  for (const auto& [name, s] : result["channels"].items()) {
    out += fmt::format("{:14} validation rmse {:.4g} -> {:.4g}  (nrmse {:.4f} -> {:.4f})\n", name,
                       s["before"]["rmse"].get<double>(), s["after"]["rmse"].get<double>(),
                       s["before"]["nrmse"].get<double>(), s["after"]["nrmse"].get<double>());
  }
  const Json& left = result["unexplained"];
  out += fmt::format("unexplained: {} {:.2f} times its noise and uncertainty",
                     left["channel"].get<std::string>(), left["residual_over_noise"].get<double>());
  if (!left["depends_on"].empty()) {
    out += ", depends on " + JoinWords(left["depends_on"].get<std::vector<std::string>>());
  }
  return out + "\n" + NextTestLines(result);
}

std::string FindingLines(const Json& result) {
  constexpr size_t kMostFindings = 4;
  std::string out;
  const Json& findings = result["data_findings"];
  for (size_t i = 0; i < findings.size() && i < kMostFindings; ++i) {
    out += "data: " + findings[i]["channel"].get<std::string>() + " " +
           findings[i]["text"].get<std::string>() + "\n";
  }
  if (findings.size() > kMostFindings) {
    out += fmt::format("data: {} more findings in result.json\n", findings.size() - kMostFindings);
  }
  return out;
}

std::string NextTestLines(const Json& result) {
  std::string out;
  for (const Json& test : result.value("next_test", Json::array())) {
    out += "next test: " + test.get<std::string>() + "\n";
  }
  return out;
}

}  // namespace phs::identify::search
