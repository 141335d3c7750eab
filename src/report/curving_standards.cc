// The run beside the limits of the standards, and what it wears.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "report/assessed_quantities.h"
#include "report/curving_parts.h"
#include "report/number_names.h"

namespace phs::report {
namespace {

using json = nlohmann::ordered_json;

std::string Heading(const AssessedName& q) {
  const std::string unit = q.unit;
  return unit == "-" ? q.heading : fmt::format("{} [{}]", q.heading, unit);
}

/// Null for a run without an assessment.
const json* Assessed(const BogieRun& run) {
  if (!run.summary.contains("assessment")) return nullptr;
  const json& assessment = run.summary["assessment"];
  return assessment.value("status", "") == "ok" ? &assessment : nullptr;
}

/// Entry of the worst wheelset and section; null if the run has none.
const json* Worst(const BogieRun& run, const char* key) {
  const json* assessment = Assessed(run);
  if (assessment == nullptr || !assessment->contains("worst")) return nullptr;
  const json& worst = assessment->at("worst");
  return worst.contains(key) ? &worst.at(key) : nullptr;
}

TableCell Number(const json& json, const char* key, double scale) {
  if (!json.contains(key) || !json[key].is_number()) return TableCell("–");
  return TableCell(FormatNumber(scale * json[key].get<double>()));
}

void AddLimits(const CurvingResults& results, ReportPage* page) {
  DataTable table{.caption = "Worst wheelset and section of each bogie", .head = {"", "Limit"}};
  for (const BogieRun& run : results.runs) {
    table.head.push_back(run.label);
    table.head.push_back("where");
  }
  for (const AssessedName& q : AssessedNames()) {
    std::vector<TableCell> row = {TableCell(Heading(q))};
    for (const BogieRun& run : results.runs) {
      const json* worst = Worst(run, q.key);
      if (row.size() == 1 && worst != nullptr) row.push_back(Number(*worst, "limit", q.scale));
      if (row.size() == 1) continue;
      if (worst == nullptr) {
        row.insert(row.end(), {TableCell("–"), TableCell("")});
        continue;
      }
      TableCell value = Number(*worst, "value", q.scale);
      value.strong = !worst->value("kept", true);
      if (value.strong) value.text += " beyond";
      row.push_back(value);
      row.emplace_back(fmt::format("{}, {:.0f} m", PlaceWords(worst->value("wheelset", ""), "axle"),
                                   worst->value("section_begin_s_m", 0.0)));
    }
    if (row.size() > 1) table.rows.push_back(std::move(row));
  }
  page->Add(table);
}

void AddRide(const CurvingResults& results, ReportPage* page) {
  DataTable table{.caption = "Car body acceleration, 0.4 … 10 Hz, on each section [m/s²]",
                  .head = {"Section"}};
  for (const BogieRun& run : results.runs) {
    for (const char* what : {"lateral, 99.85 %", "rms", "vertical, 99.85 %", "rms"}) {
      table.head.push_back(run.label + ": " + what);
    }
  }
  const json* first = Assessed(results.reference());
  if (first == nullptr) return;
  for (std::size_t i = 0; i < first->at("sections").size(); ++i) {
    const json& section = first->at("sections").at(i);
    std::vector<TableCell> row = {
        TableCell(fmt::format("{}, {:.0f} … {:.0f} m", section.value("kind", ""),
                              section.value("begin_s_m", 0.0), section.value("end_s_m", 0.0)))};
    for (const BogieRun& run : results.runs) {
      const json* assessment = Assessed(run);
      const bool there = assessment != nullptr && i < assessment->at("sections").size();
      for (const char* axis : {"lateral", "vertical"}) {
        if (!there || !assessment->at("sections").at(i).at("ride").contains(axis)) {
          row.insert(row.end(), {TableCell("–"), TableCell("–")});
          continue;
        }
        const json& ride = assessment->at("sections").at(i).at("ride").at(axis);
        row.push_back(TableCell(FormatNumber(std::max(std::abs(ride.value("low_m_s2", 0.0)),
                                                      std::abs(ride.value("high_m_s2", 0.0))))));
        row.push_back(Number(ride, "rms_m_s2", 1));
      }
    }
    table.rows.push_back(std::move(row));
  }
  page->Add(table);
}

void AddWear(const CurvingResults& results, ReportPage* page) {
  DataTable table{.caption = "Wear and rolling contact fatigue of every wheel", .head = {"Wheel"}};
  for (const BogieRun& run : results.runs) {
    for (const char* what : {"Tγ, steady [N]", "regime", "RCF damage per 10⁶ passes [–]",
                             "worn over the run [mm²/km]"}) {
      table.head.push_back(run.label + ": " + what);
    }
  }
  const json* first = Assessed(results.reference());
  if (first == nullptr) return;
  for (std::size_t i = 0; i < first->at("wheels").size(); ++i) {
    std::vector<TableCell> row = {
        TableCell(PlaceWords(first->at("wheels").at(i).value("name", ""), "wheel"))};
    for (const BogieRun& run : results.runs) {
      const json* assessment = Assessed(run);
      if (assessment == nullptr || i >= assessment->at("wheels").size()) {
        row.insert(row.end(), 4, TableCell("–"));
        continue;
      }
      const json& wheel = assessment->at("wheels").at(i);
      row.push_back(Number(wheel, "steady_T_gamma_N", 1));
      row.emplace_back(wheel.value("steady_wear_regime", "–"));
      row.push_back(Number(wheel, "steady_rcf_damage_per_pass", 1e6));
      row.push_back(Number(wheel, "worn_area_mm2_per_km", 1));
    }
    table.rows.push_back(std::move(row));
  }
  page->Add(table);
  page->Note(
      "Regimes and worn section after Pearce and Sherratt (British Rail Research, 1991), fatigue "
      "of "
      "the rail after Burstow (whole life rail model, 2003): empirical, to rank designs. RCF "
      "damage is "
      "the share of the rail's life that passes use up: 1 is a whole life, so 5 per 10⁶ passes is "
      "a "
      "life of 200 000 axle passes; the model's greatest is 10. A pass without fatigue may be one "
      "that wears cracks off. Tγ here, too, is without spin.");
}

}  // namespace

bool HasStandards(const CurvingResults& results) {
  for (const BogieRun& run : results.runs) {
    if (Assessed(run) != nullptr) return true;
  }
  return false;
}

void AddStandards(const CurvingResults& results, ReportPage* page) {
  page->Paragraph(
      "Processed as EN 14363 and UIC 518 ask: low-pass 20 Hz, mean over 2 m every 0.5 m, "
      "percentiles of each section; quasi-static values are medians on full arcs. One simulated "
      "run does not replace the standard's sections and statistics.");
  for (const BogieRun& run : results.runs) {
    const json* assessment = Assessed(run);
    if (assessment == nullptr || !assessment->value("limits_are_orientation", false)) continue;
    page->Warning(fmt::format(
        "The limits are made for 1435 mm gauge and 22.5 t. Here the gauge is {:.0f} mm and an axle "
        "carries {:.1f} t: they are orientation.",
        1e3 * assessment->value("gauge_m", 0.0),
        2 * assessment->value("static_wheel_load_N", 0.0) / 9810));
    break;
  }
  AddLimits(results, page);
  AddRide(results, page);
  AddWear(results, page);
}

}  // namespace phs::report
