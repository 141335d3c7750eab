#include "vehicle/radius_table.h"

#include <atomic>
#include <cmath>
#include <future>

#include "vehicle/compose.h"
#include "vehicle/scenario_file.h"
#include "vehicle/summary.h"

namespace phs::vehicle {
namespace {

using Json = nlohmann::ordered_json;

/// One bogie, as asked for, in one curve.
struct RadiusCase {
  Scenario scenario;
  std::string bogie;
};

Result<RadiusRow> RunOne(const RadiusCase& asked) {
  const Scenario& scenario = asked.scenario;
  auto simulation = Simulation::Create(scenario);
  if (!simulation.ok()) return simulation.error();
  auto outcome = simulation.value().Run();
  if (!outcome.ok()) return outcome.error();
  RadiusRow row;
  row.bogie = BogieLabel(asked.bogie);
  row.yardstick = YardstickOf(scenario.bogie);
  row.speed_m_s = scenario.speed_m_s;
  row.summary = Summarise(simulation.value(), outcome.value());
  const Json::json_pointer radius("/steady_curve/radius_m");
  if (row.summary.contains(radius) && row.summary[radius].is_number()) {
    row.radius_m = std::abs(row.summary[radius].get<double>());
    row.hand = row.summary[radius].get<double>() > 0 ? 1 : -1;
  }
  return row;
}

Json At(const Json& json, const std::string& pointer) {
  const Json::json_pointer p(pointer);
  return json.contains(p) ? json.at(p) : Json(nullptr);
}

/// Wheelset `name` of the steady curve; null for a run that did not get there.
Json Wheelset(const Json& summary, const std::string& end, const char* key) {
  if (!summary.contains("steady_curve")) return nullptr;
  for (const Json& w : summary["steady_curve"]["wheelsets"]) {
    if (w["name"].get<std::string>().ends_with(end)) return w[key];
  }
  return nullptr;
}

double SteadyTGamma(const Json& summary) {
  if (!summary.contains("steady_curve")) return std::nan("");
  double sum = 0;
  for (const Json& wheel : summary["steady_curve"]["wheels"]) {
    sum += wheel["T_gamma_N"].is_number() ? wheel["T_gamma_N"].get<double>() : std::nan("");
  }
  return sum;
}

double RunTGamma(const Json& summary) {
  const Json total = At(summary, "/run/T_gamma_total_J");
  return total.is_number() ? total.get<double>() : std::nan("");
}

/// The yardstick's row in the same curve, or null.
const RadiusRow* YardstickRow(const std::vector<RadiusRow>& rows, const RadiusRow& own) {
  for (const RadiusRow& row : rows) {
    if (row.bogie == own.yardstick && row.radius_m == own.radius_m &&
        row.speed_m_s == own.speed_m_s && row.summary["status"] == "ok") {
      return &row;
    }
  }
  return nullptr;
}

Json DescribeRow(const std::vector<RadiusRow>& rows, const RadiusRow& row) {
  Json out = {{"radius_m", row.radius_m},
              {"hand", row.hand > 0   ? "left"
                       : row.hand < 0 ? "right"
                                      : ""},
              {"speed_m_s", row.speed_m_s},
              {"bogie", row.bogie},
              {"yardstick", row.yardstick},
              {"status", row.summary["status"]},
              {"reason", row.summary["reason"]},
              {"angle_of_attack_lead_rad", Wheelset(row.summary, "lead", "angle_of_attack_rad")},
              {"angle_of_attack_trail_rad", Wheelset(row.summary, "trail", "angle_of_attack_rad")},
              {"T_gamma_N", SteadyTGamma(row.summary)},
              {"T_gamma_total_J", RunTGamma(row.summary)},
              {"sum_Y_lead_N", Wheelset(row.summary, "lead", "sum_Y_N")},
              {"max_sum_Y_N", At(row.summary, "/run/max_sum_Y_N")},
              {"max_Y_over_Q", At(row.summary, "/run/max_Y_over_Q")},
              {"energy_error_relative", At(row.summary, "/run/energy_error_relative")}};
  out["wear_yardstick_over_own_steady"] = nullptr;
  out["wear_yardstick_over_own_run"] = nullptr;
  const RadiusRow* yardstick = YardstickRow(rows, row);
  if (yardstick != nullptr && row.summary["status"] == "ok") {
    out["wear_yardstick_over_own_steady"] =
        SteadyTGamma(yardstick->summary) / SteadyTGamma(row.summary);
    out["wear_yardstick_over_own_run"] = RunTGamma(yardstick->summary) / RunTGamma(row.summary);
  }
  return out;
}

}  // namespace

Result<Scenario> ScenarioOfRadius(const Scenario& base, int radius_m) {
  auto curve = LoadScenario("curve_r" + std::to_string(radius_m));
  if (!curve.ok()) return curve.error();
  Scenario own = base;
  own.name = curve.value().name;
  own.track = curve.value().track;
  own.speed_m_s = curve.value().speed_m_s;
  return own;
}

Result<std::vector<RadiusRow>> RunRadii(const std::vector<Scenario>& curves,
                                        const std::vector<std::string>& bogies,
                                        const Progress& progress) {
  std::vector<RadiusCase> all;
  for (const Scenario& curve : curves) {
    for (const std::string& bogie : bogies) {
      all.push_back({curve, bogie});
      UseBogie(bogie, &all.back().scenario);
    }
  }
  std::vector<RadiusRow> rows;
  for (size_t i = 0; i < all.size(); i += 2) {
    std::future<Result<RadiusRow>> second;
    if (i + 1 < all.size()) {
      second = std::async(std::launch::async | std::launch::deferred,
                          [&, i] { return RunOne(all[i + 1]); });
    }
    auto first = RunOne(all[i]);
    if (!first.ok()) return first.error();
    rows.push_back(std::move(first).value());
    if (second.valid()) {
      auto other = second.get();
      if (!other.ok()) return other.error();
      rows.push_back(std::move(other).value());
    }
    if (progress && !progress(static_cast<double>(rows.size()) / all.size())) break;
  }
  return rows;
}

Json DescribeRadii(const std::vector<RadiusRow>& rows, const Scenario& base) {
  Json out;
  out["scenario"] = DescribeScenario(base);
  out["rows"] = Json::array();
  for (const RadiusRow& row : rows) out["rows"].push_back(DescribeRow(rows, row));
  return out;
}

}  // namespace phs::vehicle
