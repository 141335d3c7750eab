#include "phs_model/failures.h"

#include "base/words.h"
#include "effects/targets.h"
#include "phs_model/bogie_spread.h"

namespace phs::phs_model {
namespace {

using hydraulics::EffectParams;
using hydraulics::LineParams;
using hydraulics::PhsParams;

constexpr double kAtmospheric = 101325;     ///< [Pa]
constexpr double kBurstConductance = 1e-8;  ///< 18 l/s at 1.8 MPa [m3/(Pa s)]

void AddLeak(const std::string& line, double conductance, double at_s, PhsParams* params) {
  EffectParams leak;
  leak.name = "external_leakage";
  leak.targets = {line};
  leak.values = {{"conductance_m3_per_Pas", conductance}, {"start_s", at_s}};
  params->effects.push_back(std::move(leak));
}

/// An effect that describes a part of the line no longer does: the part has failed.
void TakeOff(const std::string& effect, int line, PhsParams* params) {
  for (EffectParams& e : params->effects) {
    if (e.name != effect) continue;
    std::vector<int> lines = effects::TargetLines(e, *params);
    e.targets.clear();
    std::erase(lines, line);
    for (const int l : lines) e.targets.push_back(params->lines[static_cast<size_t>(l)].name);
  }
  // No target would mean every line: those that are left without were of this line alone.
  std::erase_if(params->effects,
                [&](const EffectParams& e) { return e.name == effect && e.targets.empty(); });
}

Status ApplyOne(const Failure& failure, PhsParams* params) {
  const int index = params->FindLine(failure.line);
  if (index < 0) {
    std::vector<std::string> lines;
    for (const LineParams& l : params->lines) lines.push_back(l.name);
    return Error{"failures: line " + Quoted(failure.line), "is not in PHS model " + params->name,
                 JoinWords(lines), DidYouMean(failure.line, lines)};
  }
  LineParams& line = params->lines[static_cast<size_t>(index)];
  if (failure.kind == "line_burst") {
    AddLeak(line.name, kBurstConductance, failure.at_s, params);
  } else if (failure.kind == "line_leak") {
    AddLeak(line.name, failure.conductance_m3_per_Pas, failure.at_s, params);
  } else if (failure.kind == "reservoir_gas_lost") {
    line.gas_volume_m3 = 0;
    line.reservoir.min_gas_volume_m3 = 0;
    TakeOff("diaphragm_stop", index, params);
    line.static_pressure_Pa = kAtmospheric;
  } else if (failure.kind == "accumulator_gas_lost") {
    if (line.accumulator.volume_m3 <= 0) {
      return Error{"failures: line " + Quoted(failure.line), "has no accumulator",
                   "a line with a blow-off accumulator", "on the Bo-Bo: L1 or L4"};
    }
    line.accumulator_precharge_Pa = kAtmospheric;
    TakeOff("accumulator_precharge", index, params);
  } else if (failure.kind == "air") {
    line.free_air_m3 += failure.air_m3;
  } else {
    return Error{"failures: kind " + Quoted(failure.kind), "is unknown", JoinWords(FailureKinds()),
                 DidYouMean(failure.kind, FailureKinds())};
  }
  return {};
}

}  // namespace

const std::vector<std::string>& FailureKinds() {
  static const std::vector<std::string> kinds = {"line_burst", "line_leak", "reservoir_gas_lost",
                                                 "accumulator_gas_lost", "air"};
  return kinds;
}

bool HasTime(const Failure& failure) {
  return failure.kind == "line_burst" || failure.kind == "line_leak";
}

std::vector<Failure> ReadFailures(YamlMap* map, double speed_m_s, double start_s_m) {
  std::vector<Failure> failures;
  for (YamlMap entry : map->Maps("failures")) {
    Failure f;
    f.kind = entry.Word("kind", FailureKinds());
    f.line = entry.Text("line");
    f.system = entry.Text("system", "");
    if (HasTime(f)) {
      if (entry.Has("at_m")) {
        if (entry.Has("at_s")) entry.Fail("at_m", "repeats at_s", "one of the two");
        f.at_m = entry.Number("at_m", {.min = start_s_m});
        f.at_s = (f.at_m - start_s_m) / std::max(speed_m_s, 1e-6);
      } else {
        f.at_s = entry.Number("at_s", {.min = 0, .max = 1e6}, 0.0);
      }
    }
    if (f.kind == "line_leak") {
      f.conductance_m3_per_Pas =
          entry.Number("conductance_m3_per_Pas", {.min = 0, .max = 1e-3, .open_min = true},
                       f.conductance_m3_per_Pas);
    }
    if (f.kind == "air") f.air_m3 = entry.Number("air_m3", {.min = 0, .max = 1e-3}, f.air_m3);
    failures.push_back(std::move(f));
  }
  return failures;
}

Status ApplyFailures(const std::vector<Failure>& failures, const std::string& system,
                     PhsParams* params) {
  for (const Failure& failure : failures) {
    if (!failure.system.empty() && failure.system != system) continue;
    if (Status s = ApplyOne(failure, params); !s.ok()) return s;
  }
  return {};
}

}  // namespace phs::phs_model
