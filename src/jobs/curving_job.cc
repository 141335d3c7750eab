#include "jobs/curving_job.h"

#include <algorithm>
#include <cmath>

#include "analysis/curve_family.h"
#include "analysis/pair_conicity.h"
#include "analysis/steady_curve.h"
#include "base/axle_words.h"
#include "base/gravity.h"
#include "base/origin.h"
#include "report/analysis_report.h"
#include "vehicle/compose.h"
#include "vehicle/summary.h"

namespace phs::jobs {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kDryRail = 0.35;  ///< where neither user nor track says

/// The curves for one bogie: on the gauge of the track asked for, else of the bogie's own.
Result<analysis::CurveFamily> FamilyFor(const CurvingRequest& request, const std::string& bogie) {
  const std::string own = request.track.empty() ? vehicle::TrackOf(bogie) : request.track;
  const auto base = own.empty() ? Result<analysis::TrackBase>(analysis::TrackBase{})
                                : analysis::ReadTrackBase(own);
  if (!base.ok()) return base.error();
  analysis::CurveFamily family = analysis::FamilyOn(base.value());
  if (!std::isfinite(family.base.friction)) family.base.friction = kDryRail;
  family.speed_limit_m_s = request.speed_limit_km_h / 3.6;
  if (request.largest_cant_m >= 0) family.largest_cant_m = request.largest_cant_m;
  if (std::isfinite(request.deficiency_m)) family.deficiency_m = request.deficiency_m;
  return family;
}

/// The radii to solve for; without any asked for, 0 = the first arc of the track asked for.
std::vector<double> RadiiOf(const CurvingRequest& request) {
  if (!request.radii.empty()) return request.radii;
  if (!request.track.empty() && analysis::FirstArc(analysis::CurveFamily(), request.track).ok())
    return {0};
  return {150, 200, 250, 300, 350, 400, 500, 600, 800, 1000, 1500};
}

/// Largest difference between the steady state and the time run, each quantity against its scale:
/// angle of attack against a/R of 1.5 m, forces against the static wheel load, shift against 10 mm.
double LargestDifference(const vehicle::SteadyMeans& a, const vehicle::SteadyMeans& b,
                         double radius, double load) {
  double largest = 0;
  const auto compare = [&](double x, double y, double scale) {
    if (std::isfinite(x) && std::isfinite(y)) largest = std::max(largest, std::abs(x - y) / scale);
  };
  for (size_t i = 0; i < a.wheelsets.size(); ++i) {
    const vehicle::WheelsetMeans &own = a.wheelsets[i], &other = b.wheelsets[i];
    compare(own.angle_of_attack_rad, other.angle_of_attack_rad, 1.5 / radius);
    compare(own.lateral_m, other.lateral_m, 0.01);
  }
  for (size_t i = 0; i < a.wheels.size(); ++i) {
    compare(a.wheels[i].Y_N, b.wheels[i].Y_N, load);
    compare(a.wheels[i].Q_N, b.wheels[i].Q_N, load);
  }
  return largest;
}

/// The same curve run through in time: difference and how much longer it takes.
Status AddTimeRun(vehicle::Simulation* simulation, double radius, double load,
                  const analysis::SteadyCurve& solved, const Watch& watch, Json* row) {
  auto run = simulation->Run([&](double) { return !watch.IsStopped(); });
  if (!run.ok()) return run.status();
  const vehicle::RunSummary summary = vehicle::Summarise(*simulation, run.value());
  Json& check = (*row)["time_run"];
  check["status"] = summary.status;
  const double seconds = run.value().end_time_s / run.value().real_time_factor;
  check["faster"] = seconds / solved.processor_s;
  if (summary.status != "ok" || !summary.numbers) return {};
  const vehicle::SteadyMeans& timed = summary.numbers->steady_curve;
  check["largest_difference"] = LargestDifference(solved.steady, timed, radius, load);
  check["steady_curve"] = vehicle::SteadyCurveJson(timed);
  return {};
}

/// The vehicle on the curve; its track file is gone again.
Result<vehicle::Simulation> OnCurve(const CurvingRequest& request,
                                    const analysis::CurveFamily& family, const std::string& bogie,
                                    bool own_arc, const analysis::FamilyCurve& curve) {
  vehicle::Scenario scenario = request.scenario;
  scenario.bogie = bogie;
  scenario.speed_m_s = curve.speed_m_s;
  scenario.track = request.track;
  if (own_arc) return vehicle::Simulation::Create(scenario);
  const auto track = analysis::TrackOf(family, curve);
  if (!track.ok()) return track.error();
  scenario.track = track.value().path();
  return vehicle::Simulation::Create(scenario);
}

/// Fills `conicity`, too, if it is empty: it is the same in all curves.
Result<Json> SolveOne(const CurvingRequest& request, const std::string& bogie, double asked,
                      const Watch& watch, Json* conicity) {
  const auto family = FamilyFor(request, bogie);
  if (!family.ok()) return family.error();
  const bool own_arc = asked == 0;
  const auto curve = own_arc ? analysis::FirstArc(family.value(), request.track)
                             : analysis::CurveOfRadius(family.value(), asked);
  if (!curve.ok()) return curve.error();
  const double radius = curve.value().radius_m;
  auto simulation = OnCurve(request, family.value(), bogie, own_arc, curve.value());
  if (!simulation.ok()) return simulation.error();
  if (conicity->is_null()) {
    *conicity = analysis::ConicityJson(analysis::CalcConicity(simulation.value()));
  }
  Json row = {{"radius_m", radius},
              {"hand", HandWord(curve.value().hand)},
              {"speed_m_s", curve.value().speed_m_s},
              {"cant_m", curve.value().cant_m},
              {"gauge_m", family.value().base.gauge_m},
              {"status", "ok"},
              {"reason", ""}};
  auto solved = analysis::SolveSteadyCurve(&simulation.value());
  if (!solved.ok()) {
    row["status"] = "no_steady_state";
    row["reason"] = solved.error().Line();
    return row;
  }
  const vehicle::SteadyMeans& steady = solved.value().steady;
  row["steady_curve"] = vehicle::SteadyCurveJson(steady);
  const vehicle::WheelsetMeans& lead = steady.wheelsets.front();
  row["angle_of_attack_lead_rad"] = lead.angle_of_attack_rad;
  row["sum_Y_lead_N"] = lead.sum_Y_N;
  const analysis::CurveTotals totals = analysis::CalcCurveTotals(steady);
  row["largest_Y_N"] = totals.largest_Y_N;
  row["T_gamma_N"] = totals.T_gamma_N;
  row["coasting_m_s2"] = solved.value().coasting_m_s2;
  row["residual"] = solved.value().residual;
  row["evaluations"] = solved.value().evaluations;
  row["processor_s"] = solved.value().processor_s;
  const mjModel* m = simulation.value().model();
  const double load =
      m->body_subtreemass[0] * kGravity / (2.0 * static_cast<double>(steady.wheelsets.size()));
  if (request.time_run) {
    if (Status s = AddTimeRun(&simulation.value(), radius, load, solved.value(), watch, &row);
        !s.ok()) {
      return s.error();
    }
  }
  return row;
}

/// Radii and bogies, before the first is solved.
Status CheckCurves(const CurvingRequest& request, const std::vector<double>& radii) {
  for (const std::string& bogie : request.bogies) {
    const auto family = FamilyFor(request, bogie);
    if (!family.ok()) return family.error();
    for (const double radius : radii) {
      const auto curve = radius == 0 ? analysis::FirstArc(family.value(), request.track)
                                     : analysis::CurveOfRadius(family.value(), radius);
      if (!curve.ok()) return curve.error();
    }
  }
  return {};
}

}  // namespace

Result<Json> SolveCurves(const CurvingRequest& request, const Watch& watch,
                         const CurvingTeller& tell) {
  const std::vector<double> radii = RadiiOf(request);
  const double count = static_cast<double>(radii.size() * request.bogies.size());
  double done = 0;
  if (Status s = CheckCurves(request, radii); !s.ok()) return s.error();
  Json json = {{"bogies", Json::object()}, {"conicity", Json::object()}};
  for (const std::string& bogie : request.bogies) {
    if (tell.begin) tell.begin(bogie);
    Json& rows = json["bogies"][bogie] = Json::array();
    for (const double radius : radii) {
      if (!watch.GoesOn(done++ / count)) return Error{"curving", "was stopped", "", ""};
      auto row = SolveOne(request, bogie, radius, watch, &json["conicity"][bogie]);
      if (!row.ok()) return row.error();
      if (tell.row) tell.row(row.value());
      rows.push_back(std::move(row).value());
    }
  }
  return json;
}

Status WriteCurves(const Json& curves, ResultDir* dir) {
  const std::string file = dir->File("curving.json");
  if (Status s = WriteFileAtomically(file, curves.dump(2) + "\n"); !s.ok()) return s;
  if (Status s = WriteOrigin(dir->File("")); !s.ok()) return s;
  return report::WriteSteadyCurvingReport(file, dir->File("report.html"));
}

}  // namespace phs::jobs
