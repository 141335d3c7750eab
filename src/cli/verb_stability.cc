// phs stability: eigenvalues over speed, linear critical speed, limit cycle by speed ramps.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>

#include "base/result_dir.h"
#include "cli/number_within.h"
#include "cli/result_checks.h"
#include "cli/run_options.h"
#include "cli/verb_table.h"
#include "jobs/stability_job.h"

namespace phs::cli {
namespace {

struct StabilityVerb {
  CommonOptions common;
  ResultChecks checks;
  jobs::StabilityRequest request;
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

void PrintMap(const std::vector<analysis::HuntingPoint>& map) {
  if (map.empty()) return;
  fmt::print("\n{:>12}{:>10}{:>10}{:>16}\n", "amplitude", "speed", "", "2nd harmonic");
  fmt::print("{:>12}{:>10}{:>10}{:>16}\n", "mm", "km/h", "Hz", "mm");
  for (const analysis::HuntingPoint& p : map) {
    fmt::print("{:>12.3f}{:>10.1f}{:>10.3f}{:>16.3f}\n", 1e3 * p.amplitude, 3.6 * p.speed,
               p.frequency, p.harmonics.empty() ? 0 : 1e3 * p.harmonics.front());
  }
}

void PrintText(const jobs::StabilityRequest& request, const jobs::Stability& stability) {
  const analysis::StabilityResult& result = stability.linear;
  const std::optional<analysis::LimitCycle>& cycle = stability.cycle;
  fmt::print("{}: linear stability on straight track\n\n", request.scenario.bogie);
  PrintSpectra(result);
  const double hertz = std::abs(result.mode.eigenvalue.imag()) / (2 * std::numbers::pi);
  if (std::isfinite(result.critical_speed)) {
    fmt::print(
        "\nlinear critical speed {:.3f} m/s ({:.1f} km/h), mode {:.2f} Hz, wavelength {:.1f} m\n",
        result.critical_speed, 3.6 * result.critical_speed, hertz, result.critical_speed / hertz);
  } else if (result.spectra[0].growth > 0) {
    fmt::print("\nunstable from the lowest speed on: no critical speed in {:g} … {:g} m/s\n",
               request.scan.min_speed_m_s, request.scan.max_speed_m_s);
  } else {
    fmt::print("\nstable at all speeds {:g} … {:g} m/s\n", request.scan.min_speed_m_s,
               request.scan.max_speed_m_s);
  }
  for (const analysis::Crossing& c : result.crossings) {
    if (c.speed == result.critical_speed) continue;
    fmt::print("and becomes {} at {:.3f} m/s\n", c.to_unstable ? "unstable again" : "stable",
               c.speed);
  }
  PrintMap(stability.map);
  if (!cycle) return;
  if (std::isfinite(cycle->critical_speed)) {
    fmt::print(
        "non-linear critical speed {:.2f} m/s ({:.1f} km/h): there hunting of {:.1f} mm dies\n",
        cycle->critical_speed, 3.6 * cycle->critical_speed, 1e3 * cycle->amplitude);
  } else if (cycle->derailed) {
    fmt::print("limit cycle: derailed at the start of the ramp; begin lower (--ramp-from)\n");
  } else if (cycle->down.size() > 1) {
    fmt::print("limit cycle: it lives down to the lowest speed of the ramp, {:g} m/s\n",
               stability.ramp.low_speed_m_s);
  } else {
    fmt::print("limit cycle: none at {:g} m/s or below\n", stability.ramp.high_speed_m_s);
  }
}

/// Two lines of progress, one for each part.
Result<jobs::Stability> Analyse(const StabilityVerb& verb) {
  const auto stopped = [] { return StopSignal() != 0; };
  ProgressLine scan("stability of " + verb.request.scenario.bogie, verb.common.quiet);
  std::optional<ProgressLine> ramp;
  return jobs::AnalyseStability(
      verb.request, {.progress = [&](double share) { return scan(share); }, .stopped = stopped},
      {.progress =
           [&](double share) {
             if (!ramp) {
               ramp.emplace("limit cycle of " + verb.request.scenario.bogie, verb.common.quiet);
             }
             return (*ramp)(share);
           },
       .stopped = stopped});
}

/// What limits are held against: a vehicle that was stable at all speeds has a critical speed of at
/// least the highest.
nlohmann::ordered_json Checked(const jobs::StabilityRequest& request,
                               const jobs::Stability& stability) {
  nlohmann::ordered_json json = stability.json;
  const analysis::StabilityResult& linear = stability.linear;
  const std::optional<analysis::LimitCycle>& cycle = stability.cycle;
  const bool stable = !std::isfinite(linear.critical_speed) && linear.spectra[0].growth <= 0;
  if (stable) json["critical_speed_m_s"] = request.scan.max_speed_m_s;
  const bool no_cycle =
      cycle && !std::isfinite(cycle->critical_speed) && !cycle->derailed && cycle->down.size() <= 1;
  if (no_cycle) {
    json["limit_cycle"]["nonlinear_critical_speed_m_s"] = stability.ramp.high_speed_m_s;
  }
  return json;
}

int RunStability(StabilityVerb verb) {
  if (Status s = verb.checks.Read(); !s.ok()) return BadInput(s.error());
  auto asked = OpenAskedDir(verb.common);
  if (!asked.ok()) return BadInput(asked.error());
  std::optional<ResultDir>& dir = asked.value();
  const auto stability = Analyse(verb);
  if (!stability.ok()) return BadInput(stability.error());
  if (verb.common.format == "json") {
    fmt::print("{}\n", stability.value().json.dump(2));
  } else {
    PrintText(verb.request, stability.value());
  }
  if (dir) {
    if (Status s = jobs::WriteStability(stability.value(), &*dir); !s.ok()) {
      return BadInput(s.error());
    }
    if (Status s = CommitAndTell(verb.common, &*dir); !s.ok()) return BadInput(s.error());
  }
  return verb.checks.Conclude(
      "stability", {{verb.request.scenario.bogie, Checked(verb.request, stability.value())}},
      kDone);
}

}  // namespace

void AddStability(CLI::App* verb, Action* action) {
  auto o = std::make_shared<StabilityVerb>();
  AddCommonOptions(verb, &o->common);
  o->checks.AddOptions(verb);
  verb->add_option("--bogie", o->request.scenario.bogie, "Bogie: a name or an MJCF file")
      ->required();
  verb->add_option("--vehicle", o->request.scenario.vehicle,
                   "bogie, or locomotive: two under a body")
      ->check(CLI::IsMember({"bogie", "locomotive"}));
  verb->add_option("--phs", o->request.scenario.phs, "PHS model, instead of the bogie's");
  verb->add_option("--wheel", o->request.scenario.wheel, "Wheel profile, instead of the bogie's");
  verb->add_option("--rail", o->request.scenario.rail, "Rail profile, instead of the bogie's");
  AddTrackOption(verb, &o->request.scenario.track,
                 "Straight track; default one as wide as the bogie's own");
  AddFrictionOption(verb, &o->request.scenario.friction);
  verb->add_option("--from", o->request.scan.min_speed_m_s, "Lowest speed, m/s")
      ->capture_default_str();
  verb->add_option("--to", o->request.scan.max_speed_m_s, "Highest speed, m/s")
      ->capture_default_str();
  verb->add_option("--speeds", o->request.scan.speeds, "Number of speeds")->capture_default_str();
  verb->add_flag("--ramp", o->request.ramp,
                 "Limit cycle and non-linear critical speed by speed ramps");
  verb->add_option("--ramp-from", o->request.cycle.high_speed_m_s,
                   "Start of the down ramp, m/s; default 1.2 times the critical speed");
  verb->add_option("--ramp-to", o->request.cycle.low_speed_m_s,
                   "Its end at the latest, m/s; default a sixth of the critical speed");
  verb->add_flag("--map", o->request.map,
                 "Map of hunting by harmonic balance: speed over amplitude");
  verb->add_option("--map-to", o->request.balance.largest_m, "Largest amplitude of the map, m")
      ->check(NumberWithin(1e-4, 0.03))
      ->capture_default_str();
  verb->add_option("--harmonics", o->request.balance.harmonics, "Of the map")
      ->check(CLI::Range(1, 15))
      ->capture_default_str();
  verb->add_option("--samples", o->request.balance.samples, "Of the map, over one period")
      ->check(CLI::Range(16, 1024))
      ->capture_default_str();
  AddTimestepOption(verb, &o->request.timestep_s, "Step of the ramps (default chosen)");
  verb->add_option("--ramp-rate", o->request.cycle.rate_m_s2, "m/s^2")->capture_default_str();
  verb->callback([=] { *action = [=] { return RunStability(*o); }; });
}

}  // namespace phs::cli
