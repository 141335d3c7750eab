#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/json_path.h"
#include "jobs/alarms_found.h"

namespace phs::jobs {
namespace {

using analysis::Extremes;
using analysis::PairSignal;
using Json = nlohmann::ordered_json;

constexpr double kBefore_s = 2;    ///< of a burst that the report draws
constexpr double kDrawn_s = 0.05;  ///< interval there

/// Largest values over the rows from `from_s` to `to_s`.
struct Safety {
  double Y_over_Q = 0, sum_Y_N = 0, unloading = 0;
  void Raise(const AlarmRun& run, double from_s, double to_s) {
    for (size_t i = 0; i < run.time_s.size(); ++i) {
      if (run.time_s[i] < from_s || run.time_s[i] > to_s) continue;
      Y_over_Q = std::max(Y_over_Q, run.Y_over_Q[i]);
      sum_Y_N = std::max(sum_Y_N, run.sum_Y_N[i]);
      unloading = std::max(unloading, run.unloading[i]);
    }
  }
  Json ToJson() const {
    return {{"Y_over_Q", Y_over_Q}, {"sum_Y_N", sum_Y_N}, {"unloading", unloading}};
  }
};

Json Drawn(const AlarmsFound& found, const Burst& burst, size_t signal) {
  const auto x = analysis::CalcSignal(found.signals[signal], burst.run.pressure_Pa,
                                      burst.run.interval_s, found.ask.times);
  Json json = {{"service", found.ask.services[burst.task.service].name},
               {"t_s", Json::array()},
               {"signal", Json::array()},
               {"pressure_Pa", Json::object()}};
  const size_t every =
      std::max<size_t>(1, static_cast<size_t>(std::lround(kDrawn_s / burst.run.interval_s)));
  for (size_t i = 0; i < x.size(); i += every) {
    const double since = burst.run.time_s[i] - burst.task.at_s;
    if (since < -kBefore_s) continue;
    json["t_s"].push_back(since);
    json["signal"].push_back(found.signals[signal].sign() * x[i]);
    for (size_t l = 0; l < found.lines.size(); ++l) {
      json["pressure_Pa"][found.lines[l]].push_back(burst.run.pressure_Pa[l][i]);
    }
  }
  return json;
}

/// Every burst of a hose; its summary goes into `hose_json`.
Json BurstsJson(const AlarmsFound& found, size_t hose, Json* hose_json) {
  Json list = Json::array();
  Safety until, before;
  int alarmed = 0, named = 0;
  for (const Burst* burst : found.BurstsOf(found.lines[hose])) {
    const double seconds = burst->seconds[found.chosen[hose]];
    const double at = burst->task.at_s, end = std::min(at + seconds, at + found.ask.after_s);
    Safety own;
    own.Raise(burst->run, at, end);
    until.Raise(burst->run, at, end);
    before.Raise(burst->run, found.ask.run_in_s, at - burst->run.interval_s);
    const auto& t = burst->run.time_s;
    const size_t row = std::min<size_t>(
        t.size() - 1, static_cast<size_t>(std::lower_bound(t.begin(), t.end(), end) - t.begin()));
    size_t lowest = 0;
    for (size_t l = 0; l < found.lines.size(); ++l) {
      if (burst->run.pressure_Pa[l][row] < burst->run.pressure_Pa[lowest][row]) lowest = l;
    }
    alarmed += std::isfinite(seconds) ? 1 : 0;
    named += std::isfinite(seconds) && lowest == hose ? 1 : 0;
    list.push_back({{"service", found.ask.services[burst->task.service].name},
                    {"status", burst->run.status},
                    {"at_s", at},
                    {"seconds_to_alarm", NumberOrNull(seconds)},
                    {"lowest_line", found.lines[lowest]},
                    {"until_alarm", own.ToJson()}});
  }
  (*hose_json)["runs"] = list.size();
  (*hose_json)["alarmed"] = alarmed;
  (*hose_json)["named_by_lowest_pressure"] = named;
  (*hose_json)["until_alarm"] = until.ToJson();
  (*hose_json)["before_burst"] = before.ToJson();
  return list;
}

Json HoseJson(const AlarmsFound& found, size_t hose) {
  const size_t s = found.chosen[hose];
  const PairSignal& signal = found.signals[s];
  double mean = 0;
  const double slowest = found.Slowest(found.lines[hose], s, &mean);
  Json json = {{"name", found.lines[hose]},
               {"first", found.lines[static_cast<size_t>(signal.first)]},
               {"second", found.lines[static_cast<size_t>(signal.second)]},
               {"form", signal.form->name},
               {"against_mean", signal.against_mean},
               {"unit", signal.form->unit},
               {"alarm", signal.above ? "above" : "below"},
               {"threshold", signal.sign() * found.thresholds[s]},
               {"largest_seconds_to_alarm", NumberOrNull(slowest)},
               {"mean_seconds_to_alarm", mean},
               {"margin", found.Margin(found.lines[hose], s)}};
  Json bursts = BurstsJson(found, hose, &json);
  json["learned"] = Json::array();
  int count = 0;
  for (size_t k = 0; k < found.ask.services.size(); ++k) {
    const Extremes& law = found.laws[k][s];
    const double sign = signal.sign();
    std::vector<double> maxima = found.maxima[k][s];
    for (double& x : maxima) x *= sign;
    json["learned"].push_back({{"service", found.ask.services[k].name},
                               {"blocks", law.count},
                               {"location", sign * law.location},
                               {"scale", law.scale},
                               {"shape", law.shape},
                               {"level", sign * law.Level(found.block_share)},
                               {"upper_level", sign * law.UpperLevel(found.block_share)},
                               {"maxima", maxima}});
    count += found.false_count[k][hose];
  }
  json["false_alarms"] = count;
  json["bursts"] = std::move(bursts);
  json["drawn"] = Drawn(found, *found.BurstsOf(found.lines[hose]).front(), s);
  return json;
}

Json FalseAlarmsJson(const AlarmsFound& found) {
  double km = 0;
  int count = 0;
  Json services = Json::array();
  for (size_t k = 0; k < found.ask.services.size(); ++k) {
    int own = 0;
    for (const int n : found.false_count[k]) own += n;
    services.push_back({{"name", found.ask.services[k].name},
                        {"speed_m_s", found.ask.services[k].speed_m_s},
                        {"distance_km", found.tested_km[k]},
                        {"count", own},
                        {"upper_per_1000_km",
                         1e3 * analysis::PoissonUpper(own) / std::max(found.tested_km[k], 1e-9)}});
    km += found.tested_km[k], count += own;
  }
  return {{"distance_km", km},
          {"count", count},
          {"upper_per_1000_km", 1e3 * analysis::PoissonUpper(count) / std::max(km, 1e-9)},
          {"services", services}};
}

}  // namespace

std::vector<const Burst*> AlarmsFound::BurstsOf(const std::string& line) const {
  std::vector<const Burst*> of_line;
  for (const Burst& burst : bursts) {
    if (burst.task.line == line) of_line.push_back(&burst);
  }
  return of_line;
}

double AlarmsFound::Slowest(const std::string& line, size_t signal, double* mean) const {
  double slowest = 0, sum = 0, count = 0;
  for (const Burst* burst : BurstsOf(line)) {
    slowest = std::max(slowest, burst->seconds[signal]);
    sum += std::min(burst->seconds[signal], ask.after_s), ++count;
  }
  *mean = sum / count;
  return slowest;
}

double AlarmsFound::Margin(const std::string& line, size_t signal) const {
  double usual = -HUGE_VAL, settled = HUGE_VAL;
  for (const auto& service : laws) usual = std::max(usual, service[signal].Level(0.5));
  for (const Burst* burst : BurstsOf(line)) settled = std::min(settled, burst->settled[signal]);
  return (settled - thresholds[signal]) / std::max(thresholds[signal] - usual, 1e-9);
}

Json AlarmsJson(const AlarmsFound& found) {
  Json json = {{"status", "ok"},
               {"wanted_per_1000_km", found.ask.wanted_per_1000_km},
               {"lag_s", found.ask.times.lag_s},
               {"mean_s", found.ask.times.mean_s},
               {"block_m", found.block_m},
               {"learn_km_per_service", found.ask.learn_km},
               {"lines", found.lines},
               {"false_alarms", FalseAlarmsJson(found)},
               {"hoses", Json::array()}};
  for (size_t hose = 0; hose < found.lines.size(); ++hose) {
    json["hoses"].push_back(HoseJson(found, hose));
    const Json& made = json["hoses"].back();
    if (made["alarmed"] != made["runs"]) json["status"] = "not all alarmed";
  }
  return json;
}

std::string SignalsCsv(const AlarmsFound& found) {
  std::string text =
      "hose,first,second,form,alarm,threshold,unit,largest_seconds,mean_seconds,margin,"
      "against_mean\n";
  for (const std::string& line : found.lines) {
    for (size_t s = 0; s < found.signals.size(); ++s) {
      const PairSignal& signal = found.signals[s];
      double mean = 0;
      const double slowest = found.Slowest(line, s, &mean);
      text += fmt::format("{},{},{},{},{},{:.6g},{},{},{:.3f},{:.4g},{}\n", line,
                          found.lines[static_cast<size_t>(signal.first)],
                          found.lines[static_cast<size_t>(signal.second)], signal.form->name,
                          signal.above ? "above" : "below", signal.sign() * found.thresholds[s],
                          signal.form->unit,
                          std::isfinite(slowest) ? fmt::format("{:.3f}", slowest) : "", mean,
                          found.Margin(line, s), signal.against_mean ? "yes" : "no");
    }
  }
  return text;
}

}  // namespace phs::jobs
