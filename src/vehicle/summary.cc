#include "vehicle/summary.h"

#include <algorithm>

namespace phs::vehicle {
namespace {

using Json = nlohmann::ordered_json;

template <typename Part, size_t n>
void AddNumbers(const Part& part, const SummaryNumber<Part> (&numbers)[n], Json* out) {
  for (const auto& number : numbers) (*out)[number.key] = part.*number.value;
}

template <typename Part, size_t n>
Json NamedParts(const std::vector<Part>& parts, const SummaryNumber<Part> (&numbers)[n]) {
  Json list = Json::array();
  for (const Part& part : parts) {
    Json one = {{"name", part.name}};
    if constexpr (requires { part.side; }) one["side"] = part.side;
    AddNumbers(part, numbers, &one);
    list.push_back(std::move(one));
  }
  return list;
}

/// a / b wherever both hold a number; names are kept so that the entries can be found.
Json Ratio(const Json& a, const Json& b) {
  if (a.is_number() && b.is_number()) {
    const double denominator = b.get<double>();
    return denominator == 0 ? Json(nullptr) : Json(a.get<double>() / denominator);
  }
  if (a.is_object() && b.is_object()) {
    Json ratio = Json::object();
    for (const auto& [key, value] : a.items()) {
      if (!b.contains(key)) continue;
      if (key == "name" || key == "side") {
        ratio[key] = value;
      } else if (Json part = Ratio(value, b[key]); !part.is_null()) {
        ratio[key] = part;
      }
    }
    return ratio;
  }
  if (a.is_array() && b.is_array()) {
    Json ratio = Json::array();
    for (size_t i = 0; i < std::min(a.size(), b.size()); ++i) ratio.push_back(Ratio(a[i], b[i]));
    return ratio;
  }
  return nullptr;
}

}  // namespace

Json SteadyCurveJson(const SteadyMeans& means) {
  Json curve = {
      {"begin_s_m", means.begin_s_m},
      {"end_s_m", means.end_s_m},
      {"radius_m", means.curvature_1_m == 0 ? Json(nullptr) : Json(1 / means.curvature_1_m)},
      {"speed_m_s", means.speed_m_s},
      {"wheelsets", NamedParts(means.wheelsets, kWheelsetNumbers)},
      {"wheels", NamedParts(means.wheels, kWheelNumbers)}};
  for (const BogieMeans& bogie : means.bogies) {
    for (const auto& number : kBogieNumbers) {
      curve[bogie.prefix + number.key] = bogie.*number.value;
    }
  }
  curve["cylinders"] = NamedParts(means.cylinders, kCylinderNumbers);
  curve["lines"] = NamedParts(means.lines, kLineNumbers);
  return curve;
}

Json SummaryJson(const RunSummary& s) {
  Json summary = {{"status", s.status},
                  {"reason", s.reason},
                  {"bogie", s.bogie},
                  {"real_time_factor", s.real_time_factor},
                  {"timestep_s", s.timestep_s},
                  {"largest_stable_step_s", s.largest_stable_step_s},
                  {"warnings", WarningsJson(s.warnings)}};
  if (!s.numbers) return summary;
  summary["steady_curve"] = SteadyCurveJson(s.numbers->steady_curve);
  AddNumbers(s.numbers->run, kRunNumbers, &summary["run"]);
  summary["run"]["steps"] = s.numbers->run.steps;
  for (const AxleMoments& moments : s.numbers->budget) {
    AddNumbers(moments, kMomentNumbers, &summary["budget"][moments.name]);
  }
  return summary;
}

Json Compare(const std::vector<std::pair<std::string, Json>>& summaries, const Scenario& scenario,
             const rail::Track& track) {
  Json out;
  for (const auto& [name, summary] : summaries) out["bogies"][name] = summary;
  out["ratios"] = Json::object();
  for (const auto& [a, of_a] : summaries) {
    for (const auto& [b, of_b] : summaries) {
      if (a == b) continue;
      Json ratio;
      for (const char* part : {"steady_curve", "run", "budget"}) {
        if (of_a.contains(part) && of_b.contains(part)) ratio[part] = Ratio(of_a[part], of_b[part]);
      }
      out["ratios"][a + "_over_" + b] = ratio;
    }
  }
  out["scenario"] = DescribeScenario(scenario);
  out["track"] = DescribeTrack(track);
  return out;
}

}  // namespace phs::vehicle
