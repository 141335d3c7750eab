// phs alarms: a pair of line pressures and a threshold for every hose that may be lost.
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "base/result_dir.h"
#include "cli/number_within.h"
#include "cli/result_checks.h"
#include "cli/verb_table.h"
#include "jobs/alarms_job.h"
#include "jobs/sweep_job.h"
#include "vehicle/scenario_file.h"

namespace phs::cli {
namespace {

using Json = nlohmann::ordered_json;

struct AlarmsOptions {
  CommonOptions common;
  ResultChecks checks;
  std::vector<std::string> scenarios;
  jobs::AlarmsRequest request;
};

double Number(const Json& value) { return value.is_number() ? value.get<double>() : std::nan(""); }

void Print(const Json& all) {
  fmt::print("{:<6}{:<24}{:>18}{:>12}{:>12}{:>9}{:>8}{:>10}{:>8}\n", "hose", "signal", "alarm",
             "mean s", "slowest s", "alarms", "Y/Q", "sum Y kN", "false");
  for (const Json& hose : all.at("hoses")) {
    const std::string signal = fmt::format(
        "{} {}, {}{}", hose.at("form").get<std::string>(), hose.at("first").get<std::string>(),
        hose.at("second").get<std::string>(), hose.at("against_mean") ? " - mean" : "");
    const bool pressure = hose.at("unit") == "Pa";
    const std::string alarm =
        fmt::format("{} {:.3g}{}", hose.at("alarm").get<std::string>(),
                    Number(hose.at("threshold")) * (pressure ? 1e-6 : 1), pressure ? " MPa" : "");
    fmt::print(
        "{:<6}{:<24}{:>18}{:>12.2f}{:>12.2f}{:>9}{:>8.2f}{:>10.1f}{:>8}\n",
        hose.at("name").get<std::string>(), signal, alarm, Number(hose.at("mean_seconds_to_alarm")),
        Number(hose.at("largest_seconds_to_alarm")),
        fmt::format("{}/{}", hose.at("alarmed").get<int>(), hose.at("runs").get<int>()),
        Number(hose.at("until_alarm").at("Y_over_Q")),
        1e-3 * Number(hose.at("until_alarm").at("sum_Y_N")), hose.at("false_alarms").get<int>());
  }
  const Json& found = all.at("false_alarms");
  fmt::print(
      "{} false alarms in {:.1f} km without failure: at most {:.3g} in 1000 km (Poisson, 95 %); "
      "wanted {:g}\n",
      found.at("count").get<int>(), Number(found.at("distance_km")),
      Number(found.at("upper_per_1000_km")), Number(all.at("wanted_per_1000_km")));
}

int RunAlarms(AlarmsOptions options) {
  if (Status s = options.checks.Read(); !s.ok()) return BadInput(s.error());
  for (const std::string& name : options.scenarios) {
    auto scenario = vehicle::LoadScenario(name);
    if (!scenario.ok()) return BadInput(scenario.error());
    options.request.services.push_back(std::move(scenario).value());
  }
  options.request.workers = jobs::NumWorkers(options.request.workers);
  auto asked = OpenAskedDir(options.common);
  if (!asked.ok()) return BadInput(asked.error());
  std::optional<ResultDir>& dir = asked.value();
  const auto alarms = [&] {
    ProgressLine progress("alarms", options.common.quiet);
    return jobs::FindAlarms(options.request,
                            {.progress = [&](double share) { return progress(share); }});
  }();
  if (!alarms.ok()) return BadInput(alarms.error());
  if (!alarms.value().all) return Stopped("nothing is kept");
  const Json& json = alarms.value().json;
  if (options.common.format == "json") {
    fmt::print("{}\n", json.dump(2));
  } else {
    Print(json);
  }
  if (dir) {
    if (Status s = jobs::WriteAlarms(alarms.value(), &*dir); !s.ok()) return BadInput(s.error());
    if (Status s = CommitAndTell(options.common, &*dir); !s.ok()) return BadInput(s.error());
  }
  return options.checks.Conclude("alarms", {{"alarms", json}},
                                 json.at("status") == "ok" ? kDone : kFailed);
}

}  // namespace

void AddAlarms(CLI::App* verb, Action* action) {
  auto o = std::make_shared<AlarmsOptions>();
  AddCommonOptions(verb, &o->common);
  o->checks.AddOptions(verb);
  verb->add_option("scenario", o->scenarios, "Services: scenarios on tracks with a spectrum")
      ->required();
  jobs::AlarmsRequest& ask = o->request;
  ask.workers = 0;
  verb->add_option("--wanted", ask.wanted_per_1000_km,
                   "False alarms in 1000 km that are wanted at most, all hoses together")
      ->check(NumberWithin(1e-6, 1e3))
      ->capture_default_str();
  verb->add_option("--learn-km", ask.learn_km, "Distance to learn from, in each service")
      ->check(NumberWithin(1.0, 1e5))
      ->capture_default_str();
  verb->add_option("--test-km", ask.test_km, "Distance to count on, all services together")
      ->check(NumberWithin(1.0, 1e6))
      ->capture_default_str();
  verb->add_option("--bursts", ask.bursts, "Bursts of each hose in each service")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  verb->add_option("--lag", ask.times.lag_s, "Lag behind every signal, s")
      ->check(NumberWithin(0.0, 60.0))
      ->capture_default_str();
  verb->add_option("--mean", ask.times.mean_s,
                   "Time over which the mean is taken that signals are also told against, s")
      ->check(NumberWithin(1.0, 1e5))
      ->capture_default_str();
  verb->add_option("--block", ask.block_m,
                   "Block of track whose extremes are learned from, m; 0: a whole run")
      ->check(NumberWithin(10.0, 1e5) | NumberWithin(0.0, 0.0))
      ->capture_default_str();
  verb->add_option("--seed", ask.seed, "Of the tracks that are drawn")->capture_default_str();
  verb->add_option("--workers", ask.workers, "Runs at a time (one per core without it)")
      ->check(CLI::Range(1, 4096));
  verb->footer("Exit code 1 when a burst gives no alarm or a limit is missed.");
  verb->callback([=] { *action = [=] { return RunAlarms(*o); }; });
}

}  // namespace phs::cli
