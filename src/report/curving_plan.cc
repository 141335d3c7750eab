// The bogies seen from above, and the balance of yaw moments on their axles.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "report/curving_parts.h"
#include "report/decimation.h"

namespace phs::report {
namespace {

using json = nlohmann::ordered_json;

/// Greatest magnitude of a packed-size series over all rows; 0 if there is none.
double Greatest(const std::vector<double>& values) {
  double greatest = 0;
  for (double value : values) {
    if (std::isfinite(value)) greatest = std::max(greatest, std::abs(value));
  }
  return greatest;
}

/// The largest of 1, 2, 3, 4, 5, 10, 20 … that does not exceed `most`.
double RoundFactor(double most) {
  if (!(most > 1)) return 1;
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  return power * std::min(5.0, std::floor(most / power));
}

json PackedPlan(const std::vector<double>& values) {
  const PackedValues packed = Pack(values);
  return {{"least", packed.least}, {"greatest", packed.greatest}, {"packed", packed.base64}};
}

double Wheelbase(const BogieRun& run, const std::string& prefix) {
  const auto* x1 = run.Channel(prefix + "lead_x_m");
  const auto* y1 = run.Channel(prefix + "lead_y_m");
  const auto* x2 = run.Channel(prefix + "trail_x_m");
  const auto* y2 = run.Channel(prefix + "trail_y_m");
  if (x1 == nullptr || y1 == nullptr || x2 == nullptr || y2 == nullptr || x1->empty())
    return kNoNumber;
  return std::hypot(x1->front() - x2->front(), y1->front() - y2->front());
}

json TrackMap(const CurvingResults& results) {
  const json line = results.all.value(json::json_pointer("/track/centre_line"), json::object());
  if (!line.contains("s_m") || line["s_m"].size() < 2) return nullptr;
  json sections = json::array();
  for (const Section& section : results.sections) {
    sections.push_back({{"kind", section.kind},
                        {"begin", section.begin},
                        {"end", section.end},
                        {"label", SectionLabel(section)}});
  }
  // At most about a thousand points: enough for a map.
  json map = {{"name", results.track_name}, {"sections", sections}};
  const std::size_t step = line["s_m"].size() / 1000 + 1;
  for (const auto& [to, from] :
       {std::pair{"s", "s_m"}, std::pair{"x", "x_m"}, std::pair{"y", "y_m"}}) {
    map[to] = json::array();
    const json& values = line.value(from, json::array());
    for (std::size_t i = 0; i < values.size(); i += step) map[to].push_back(values[i]);
  }
  return map;
}

/// Poses of the bogies along the track and the factors they are magnified by.
json PlanSpec(const CurvingResults& results, const std::string& prefix) {
  if (results.reference().Channel("s_m") == nullptr) return nullptr;
  const std::vector<double>& s0 = *results.reference().Channel("s_m");
  if (s0.size() < 2) return nullptr;
  const Grid grid{.begin = s0.front(), .end = s0.back(), .points = 600};
  json spec = {{"grid", {{"begin", grid.begin}, {"end", grid.end}, {"points", grid.points}}},
               {"bogies", json::array()}};
  double attack = 1e-4;
  double lateral = 1e-4;
  double curvature = 1e-6;
  for (const BogieRun& run : results.runs) {
    json bogie = {{"label", run.label}, {"colour", run.colour}};
    const std::vector<double>* s = run.Channel("s_m");
    for (const char* axle : {"lead", "trail"}) {
      for (const auto& [key, suffix] :
           {std::pair{"lateral", "_lateral_m"}, std::pair{"attack", "_angle_of_attack_rad"},
            std::pair{"yaw", "_yaw_rad"}}) {
        const std::vector<double>* y = run.Channel(prefix + axle + suffix);
        if (s == nullptr || y == nullptr) return nullptr;
        bogie[axle][key] = PackedPlan(PutOnGrid(*s, *y, grid));
        if (std::string(key) == "attack") attack = std::max(attack, Greatest(*y));
        if (std::string(key) == "lateral") lateral = std::max(lateral, Greatest(*y));
      }
    }
    spec["bogies"].push_back(std::move(bogie));
  }
  const std::vector<double>* k = results.reference().Channel("curvature_1_m");
  if (k == nullptr) return nullptr;
  curvature = std::max(curvature, Greatest(*k));
  const double wheelbase = Wheelbase(results.reference(), prefix);
  if (!std::isfinite(wheelbase)) return nullptr;
  spec["curvature"] = PackedPlan(PutOnGrid(s0, *k, grid));
  spec["wheelbase"] = wheelbase;
  const json track = results.all.value("track", json::object());
  spec["gauge"] = track.value("gauge_m", 1.067);
  spec["wheel_radius"] = 0.625;  // only how large the wheels are drawn
  // At most 11 degrees of track heading and 20 degrees of attack in the drawing.
  spec["magnification"] = RoundFactor(std::min(0.2 / (curvature * wheelbase / 2), 0.35 / attack));
  spec["lateral_magnification"] = RoundFactor(std::min(12.0, 0.12 / lateral));
  spec["start"] = results.radius > 0 ? (results.steady_begin + results.steady_end) / 2
                                     : (grid.begin + grid.end) / 2;
  spec["track"] = TrackMap(results);
  return spec;
}

MomentBudget FromParts(double creep, double pressure, double friction, double primary, int sign) {
  MomentBudget budget;
  budget.known = std::isfinite(creep) && std::isfinite(primary);
  const auto counted = [sign](double value) { return std::isfinite(value) ? sign * value : 0.0; };
  budget.creep = counted(creep);
  budget.phs_pressure = counted(pressure);
  budget.phs_friction = counted(friction);
  budget.primary = counted(primary);
  budget.rest = -(budget.creep + budget.phs_pressure + budget.phs_friction + budget.primary);
  return budget;
}

/// Bars of the moments on one axle; parts that are nowhere 1 % of the largest are left out.
BarChart BudgetChart(const CurvingResults& results, const std::string& prefix,
                     const std::string& axle, const std::string& word) {
  BarChart chart{.title = "Yaw moments, " + BogieWords(prefix) + word + " axle", .unit = "kN m"};
  const std::vector<std::pair<std::string, double MomentBudget::*>> parts = {
      {"Creep forces between wheel and rail", &MomentBudget::creep},
      {"Oil pressure in the cylinders", &MomentBudget::phs_pressure},
      {"Seal friction of the cylinders", &MomentBudget::phs_friction},
      {"Primary suspension with its links", &MomentBudget::primary},
      {"Rest", &MomentBudget::rest}};
  std::vector<MomentBudget> budgets;
  double largest = 0;
  for (const BogieRun& run : results.runs) {
    budgets.push_back(CalcBudget(run, results, prefix + axle));
    for (const auto& part : parts) {
      largest = std::max(largest, std::abs(budgets.back().*part.second));
    }
    chart.bars.push_back({.label = run.label, .colour = run.colour});
  }
  for (const auto& [name, part] : parts) {
    double here = 0;
    for (const MomentBudget& budget : budgets) here = std::max(here, std::abs(budget.*part));
    if (here < 0.01 * largest) continue;
    chart.categories.push_back(name);
    for (std::size_t i = 0; i < budgets.size(); ++i) {
      chart.bars[i].values.push_back(budgets[i].known ? 1e-3 * budgets[i].*part : kNoNumber);
    }
  }
  return chart;
}

}  // namespace

MomentBudget CalcBudget(const BogieRun& run, const CurvingResults& results,
                        const std::string& axle) {
  // A left curve asks the leading axle to turn left (+) in its bogie and the trailing one right
  // (-).
  const int sign = results.hand * (axle.ends_with("lead") ? 1 : -1);
  if (sign == 0) return {};
  const std::string at = "/budget/" + axle + "/";
  MomentBudget saved =
      FromParts(run.Number(at + "creep_Nm"), run.Number(at + "phs_pressure_Nm"),
                run.Number(at + "phs_friction_Nm"), run.Number(at + "primary_Nm"), sign);
  if (saved.known) return saved;
  const auto mean = [&](const char* suffix) {
    return run.Mean(axle + suffix, results.steady_begin, results.steady_end);
  };
  return FromParts(mean("_steering_moment_Nm"), mean("_phs_pressure_moment_Nm"),
                   mean("_phs_friction_moment_Nm"), mean("_primary_moment_Nm"), sign);
}

void AddPlanView(const CurvingResults& results, ReportPage* page) {
  bool drawn = false;
  for (const std::string& prefix : results.prefixes) {
    json spec = PlanSpec(results, prefix);
    if (spec.is_null()) continue;
    if (drawn) spec["track"] = nullptr;  // the map once
    page->AddFigure(
        "plan",
        fmt::format(
            "{}all angles magnified {:.0f} times (as if the radius were that much smaller), "
            "lateral positions {:.0f} times; dashed: radial direction under each axle",
            prefix.empty()       ? "Axles on the track: "
            : prefix == "front_" ? "Front bogie: "
                                 : "Rear bogie: ",
            spec["magnification"].get<double>(), spec["lateral_magnification"].get<double>()),
        spec.dump(-1, ' ', false, json::error_handler_t::replace));
    drawn = true;
  }
  if (!drawn) page->Note("No poses of the axles were recorded.");
}

namespace {

/// Whether seals act on an axle of any bogie by more than a hundredth of its creep forces.
bool AnyFriction(const CurvingResults& results) {
  for (const BogieRun& run : results.runs) {
    for (const std::string& prefix : results.prefixes) {
      for (const char* axle : {"lead", "trail"}) {
        const MomentBudget budget = CalcBudget(run, results, prefix + axle);
        if (std::abs(budget.phs_friction) > 0.01 * std::abs(budget.creep)) return true;
      }
    }
  }
  return false;
}

}  // namespace

void AddMomentBudget(const CurvingResults& results, ReportPage* page) {
  if (results.hand == 0) {
    page->Note("The track has no circular arc: there is no steering moment to balance.");
    return;
  }
  page->Paragraph(
      "Yaw moments on each axle in the steady curve. Positive: turns the axle towards the radial "
      "direction (steers). Negative: turns it away from it (holds back). In a steady state they "
      "add up to zero, so moments that hold back may together exceed that of the creep forces "
      "where "
      "another part steers, too.");
  page->Paragraph(
      "Primary suspension with its links: all springs, dampers and links that hold the axle in "
      "yaw, "
      "to the frame or to the other axle. Of a link bogie it is nearly all the links', whose "
      "stiffness "
      "its file gives together with that of the springs. The cylinders of a PHS are not in it: "
      "they are the oil pressure and the seal friction. Rest: inertia, and what a run that still "
      "swings does not balance.");
  if (AnyFriction(results)) {
    page->Paragraph(
        "Seal friction may hold back or steer. In the steady curve the pistons stand still, and "
        "the "
        "seals hold whatever they were left with in the transition: friction opposed the piston's "
        "last "
        "motion. Where the axle was still turning towards the radial direction it holds back; "
        "where the axle had turned too far and was coming back it steers.");
  }
  page->BeginGrid(2);
  for (const std::string& prefix : results.prefixes) {
    for (const AxleName& axle : results.Axles(prefix)) {
      if (axle.name != "mid") page->Add(BudgetChart(results, prefix, axle.name, axle.word));
    }
  }
  page->EndGrid();
}

}  // namespace phs::report
