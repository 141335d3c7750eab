// phs stability: eigenvalues over speed, linear critical speed, limit cycle by speed ramps.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include "analysis/critical_speeds.h"
#include "analysis/plain_track.h"
#include "analysis/stability_json.h"
#include "base/result_dir.h"
#include "cli/run_options.h"
#include "cli/verb_table.h"
#include "report/analysis_report.h"

namespace phs::cli {
namespace {

using Json = nlohmann::ordered_json;

struct StabilityVerb {
  CommonOptions common;
  vehicle::Scenario scenario;
  analysis::StabilityOptions scan;
  analysis::LimitCycleOptions cycle;
  bool ramp = false;
  double timestep_s = 0;  ///< of the ramps; 0 = chosen
};

void PrintSpectra(const analysis::StabilityResult& result) {
  fmt::print("{:>10}{:>10}{:>14}{:>14}{:>12}\n", "speed", "", "growth", "least damping", "of mode");
  fmt::print("{:>10}{:>10}{:>14}{:>14}{:>12}\n", "m/s", "km/h", "1/s", "%", "Hz");
  const size_t every = std::max<size_t>(1, result.spectra.size() / 16);
  for (size_t i = 0; i < result.spectra.size(); i += every) {
    const analysis::SpeedSpectrum& s = result.spectra[i];
    double ratio = std::numeric_limits<double>::infinity();
    double frequency = 0;
    for (const std::complex<double>& value : s.eigenvalues) {
      if (std::abs(value.imag()) < analysis::kNeutral) continue;
      const double damping = -value.real() / std::abs(value);
      if (damping >= ratio) continue;
      ratio = damping;
      frequency = std::abs(value.imag()) / (2 * std::numbers::pi);
    }
    fmt::print("{:>10.2f}{:>10.1f}{:>14.3f}{:>14.2f}{:>12.2f}\n", s.speed, 3.6 * s.speed, s.growth,
               100 * ratio, frequency);
  }
}

void PrintText(const StabilityVerb& verb, const analysis::StabilityResult& result,
               const std::optional<analysis::LimitCycle>& cycle) {
  fmt::print("{}: linear stability on straight track\n\n", verb.scenario.bogie);
  PrintSpectra(result);
  const double hertz = std::abs(result.mode.eigenvalue.imag()) / (2 * std::numbers::pi);
  if (std::isfinite(result.critical_speed)) {
    fmt::print(
        "\nlinear critical speed {:.3f} m/s ({:.1f} km/h), mode {:.2f} Hz, wavelength {:.1f} m\n",
        result.critical_speed, 3.6 * result.critical_speed, hertz, result.critical_speed / hertz);
  } else if (result.spectra[0].growth > 0) {
    fmt::print("\nunstable from the lowest speed on: no critical speed in {:g} … {:g} m/s\n",
               verb.scan.min_speed_m_s, verb.scan.max_speed_m_s);
  } else {
    fmt::print("\nstable at all speeds {:g} … {:g} m/s\n", verb.scan.min_speed_m_s,
               verb.scan.max_speed_m_s);
  }
  for (const analysis::Crossing& c : result.crossings) {
    if (c.speed == result.critical_speed) continue;
    fmt::print("and becomes {} at {:.3f} m/s\n", c.to_unstable ? "unstable again" : "stable",
               c.speed);
  }
  if (!cycle) return;
  if (std::isfinite(cycle->critical_speed)) {
    fmt::print(
        "non-linear critical speed {:.2f} m/s ({:.1f} km/h): there hunting of {:.1f} mm dies\n",
        cycle->critical_speed, 3.6 * cycle->critical_speed, 1e3 * cycle->amplitude);
  } else if (cycle->derailed) {
    fmt::print("limit cycle: derailed at the start of the ramp; begin lower (--ramp-from)\n");
  } else if (cycle->down.size() > 1) {
    fmt::print("limit cycle: it lives down to the lowest speed of the ramp, {:g} m/s\n",
               verb.cycle.low_speed_m_s);
  } else {
    fmt::print("limit cycle: none at {:g} m/s or below\n", verb.cycle.high_speed_m_s);
  }
}

/// The vehicle for time runs, at a step given or chosen.
Result<vehicle::Simulation> ForTimeRuns(const StabilityVerb& verb, double largest_step) {
  if (!(verb.timestep_s > 0)) return analysis::CreateForRamps(verb.scenario, largest_step);
  vehicle::Scenario scenario = verb.scenario;
  scenario.timestep_s = verb.timestep_s;
  return vehicle::Simulation::Create(scenario);
}

int RunStability(StabilityVerb verb) {
  auto asked = OpenAskedDir(verb.common);
  if (!asked.ok()) return BadInput(asked.error());
  std::optional<ResultDir>& dir = asked.value();
  verb.scenario.speed_m_s = 20;
  const auto track = analysis::StraightTrack::For(verb.scenario.bogie, verb.scenario.track);
  if (!track.ok()) return BadInput(track.error());
  verb.scenario.track = track.value().name();
  // The linear analysis takes no step; a small one passes the check of stiffness.
  verb.scenario.timestep_s = 1e-4;
  auto simulation = vehicle::Simulation::Create(verb.scenario);
  if (!simulation.ok()) return BadInput(simulation.error());
  std::optional<analysis::LimitCycle> cycle;
  Json json;
  auto result = [&] {
    ProgressLine progress("stability of " + verb.scenario.bogie, verb.common.quiet);
    return analysis::AnalyseStability(&simulation.value(), verb.scan,
                                      [&](double share) { return progress(share); });
  }();
  if (!result.ok()) return BadInput(result.error());
  json = analysis::StabilityJson(simulation.value(), result.value());
  if (verb.ramp) {
    verb.cycle = analysis::ChooseRamp(verb.scan, result.value(), verb.cycle);
    auto runs = ForTimeRuns(verb, simulation.value().largest_stable_step());
    if (!runs.ok()) return BadInput(runs.error());
    ProgressLine progress("limit cycle of " + verb.scenario.bogie, verb.common.quiet);
    auto found = analysis::FindLimitCycle(&runs.value(), result.value().mode, verb.cycle,
                                          [&](double share) { return progress(share); });
    if (!found.ok()) return BadInput(found.error());
    cycle = std::move(found).value();
    json["limit_cycle"] = analysis::LimitCycleJson(*cycle, verb.cycle);
  }
  if (verb.common.format == "json") {
    fmt::print("{}\n", json.dump(2));
  } else {
    PrintText(verb, result.value(), cycle);
  }
  if (!dir) return kDone;
  const Status s = Publish(verb.common, "stability.json", json.dump(2) + "\n",
                           &report::WriteStabilityReport, &*dir);
  return s.ok() ? kDone : BadInput(s.error());
}

}  // namespace

void AddStability(CLI::App* verb, Action* action) {
  auto o = std::make_shared<StabilityVerb>();
  AddCommonOptions(verb, &o->common);
  verb->add_option("--bogie", o->scenario.bogie, "Bogie: a name or an MJCF file")->required();
  verb->add_option("--vehicle", o->scenario.vehicle, "bogie, or locomotive: two under a body")
      ->check(CLI::IsMember({"bogie", "locomotive"}));
  verb->add_option("--phs", o->scenario.phs, "PHS model, instead of the bogie's");
  verb->add_option("--wheel", o->scenario.wheel, "Wheel profile, instead of the bogie's");
  verb->add_option("--rail", o->scenario.rail, "Rail profile, instead of the bogie's");
  AddTrackOption(verb, &o->scenario.track,
                 "Straight track; default one as wide as the bogie's own");
  AddFrictionOption(verb, &o->scenario.friction);
  verb->add_option("--from", o->scan.min_speed_m_s, "Lowest speed, m/s")->capture_default_str();
  verb->add_option("--to", o->scan.max_speed_m_s, "Highest speed, m/s")->capture_default_str();
  verb->add_option("--speeds", o->scan.speeds, "Number of speeds")->capture_default_str();
  verb->add_flag("--ramp", o->ramp, "Limit cycle and non-linear critical speed by speed ramps");
  verb->add_option("--ramp-from", o->cycle.high_speed_m_s,
                   "Start of the down ramp, m/s; default 1.2 times the critical speed");
  verb->add_option("--ramp-to", o->cycle.low_speed_m_s,
                   "Its end at the latest, m/s; default a sixth of the critical speed");
  AddTimestepOption(verb, &o->timestep_s, "Step of the ramps (default chosen)");
  verb->add_option("--ramp-rate", o->cycle.rate_m_s2, "m/s^2")->capture_default_str();
  verb->callback([=] { *action = [=] { return RunStability(*o); }; });
}

}  // namespace phs::cli
