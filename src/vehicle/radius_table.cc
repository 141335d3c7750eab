#include "vehicle/radius_table.h"

#include <atomic>
#include <cmath>
#include <future>

#include "base/axle_words.h"
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
  const auto& numbers = row.summary.numbers;
  if (numbers && numbers->steady_curve.curvature_1_m != 0) {
    row.radius_m = std::abs(1 / numbers->steady_curve.curvature_1_m);
    row.hand = numbers->steady_curve.curvature_1_m > 0 ? 1 : -1;
  }
  return row;
}

/// A number of the wheelset whose name ends so; null for a run that did not get there.
Json Wheelset(const RunSummary& summary, const std::string& end, double WheelsetMeans::*number) {
  const WheelsetMeans* wheelset =
      summary.numbers ? summary.numbers->steady_curve.FindWheelset(end) : nullptr;
  return wheelset == nullptr ? Json(nullptr) : Json(wheelset->*number);
}

Json OfRun(const RunSummary& summary, double WholeRun::*number) {
  return summary.numbers ? Json(summary.numbers->run.*number) : Json(nullptr);
}

double SteadyTGamma(const RunSummary& summary) {
  return summary.numbers ? summary.numbers->steady_curve.TGamma() : std::nan("");
}

double RunTGamma(const RunSummary& summary) {
  return summary.numbers ? summary.numbers->run.T_gamma_total_J : std::nan("");
}

/// The yardstick's row in the same curve, or null.
const RadiusRow* YardstickRow(const std::vector<RadiusRow>& rows, const RadiusRow& own) {
  for (const RadiusRow& row : rows) {
    if (row.bogie == own.yardstick && row.radius_m == own.radius_m &&
        row.speed_m_s == own.speed_m_s && row.summary.status == "ok") {
      return &row;
    }
  }
  return nullptr;
}

Json DescribeRow(const std::vector<RadiusRow>& rows, const RadiusRow& row) {
  Json out = {{"radius_m", row.radius_m},
              {"hand", HandWord(row.hand)},
              {"speed_m_s", row.speed_m_s},
              {"bogie", row.bogie},
              {"yardstick", row.yardstick},
              {"status", row.summary.status},
              {"reason", row.summary.reason},
              {"angle_of_attack_lead_rad",
               Wheelset(row.summary, "lead", &WheelsetMeans::angle_of_attack_rad)},
              {"angle_of_attack_trail_rad",
               Wheelset(row.summary, "trail", &WheelsetMeans::angle_of_attack_rad)},
              {"T_gamma_N", SteadyTGamma(row.summary)},
              {"T_gamma_total_J", RunTGamma(row.summary)},
              {"sum_Y_lead_N", Wheelset(row.summary, "lead", &WheelsetMeans::sum_Y_N)},
              {"max_sum_Y_N", OfRun(row.summary, &WholeRun::max_sum_Y_N)},
              {"max_Y_over_Q", OfRun(row.summary, &WholeRun::max_Y_over_Q)},
              {"energy_error_relative", OfRun(row.summary, &WholeRun::energy_error_relative)}};
  out["wear_yardstick_over_own_steady"] = nullptr;
  out["wear_yardstick_over_own_run"] = nullptr;
  const RadiusRow* yardstick = YardstickRow(rows, row);
  if (yardstick != nullptr && row.summary.status == "ok") {
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
