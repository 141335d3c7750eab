// Tables, key figures and bar charts of the curving report.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/axle_words.h"
#include "base/numbers.h"
#include "report/curving_parts.h"

namespace phs::report {
namespace {

using json = nlohmann::ordered_json;

/// Standard deviation of the leading angle of attack above which an arc is not steady [mrad].
constexpr double kSteadySwing = 0.1;

/// A quantity of the headline table.
struct Metric {
  std::string label;  ///< with unit
  double floor;       ///< smallest size for which a ratio means anything, in that unit
  std::function<double(const BogieRun&)> value;
  /// Angle of attack, > 0 to the outer rail: shown as its magnitude and the rail pointed to.
  bool attack = false;
};

/// "4.61 outer"; on straight track "left" or "right".
std::string AttackText(double to_outer, const CurvingResults& results) {
  if (!std::isfinite(to_outer)) return FormatNumber(to_outer);
  const int hand = results.hand;
  return FormatNumber(std::abs(to_outer)) + " " +
         RailPointedTo(hand == 0 ? to_outer : -hand * to_outer, hand);
}

double Larger(double a, double b) {
  if (!std::isfinite(a)) return b;
  return std::isfinite(b) ? std::max(a, b) : a;
}

/// Angle of attack with the sign that the arc gives it: positive = pointing to the outer rail; on
/// straight track to the left.
double AttackOutward(const BogieRun& run, const CurvingResults& results, const std::string& axle) {
  const double angle = run.Steady("wheelsets", axle, "angle_of_attack_rad");
  return results.hand == 0 ? angle : -results.hand * angle;
}

/// Greatest cylinder force of a bogie in the steady curve [N]; NaN without cylinders.
double GreatestCylinderForce(const BogieRun& run, const std::string& prefix) {
  double greatest = kNoNumber;
  const json::json_pointer at("/steady_curve/cylinders");
  if (!run.summary.contains(at)) return kNoNumber;
  for (const json& cylinder : run.summary.at(at)) {
    if (!cylinder.value("name", "").starts_with(prefix)) continue;
    if (!cylinder.contains("force_N") || !cylinder["force_N"].is_number()) continue;
    greatest = Larger(greatest, std::abs(cylinder["force_N"].get<double>()));
  }
  return greatest;
}

void AddSteadyMetrics(const CurvingResults& results, const std::string& prefix,
                      std::vector<Metric>* metrics) {
  const std::string lead = prefix + "lead";
  const std::string trail = prefix + "trail";
  const auto wheel = [](const std::string& name, const char* key, double scale) {
    return
        [name, key, scale](const BogieRun& run) { return scale * run.Steady("wheels", name, key); };
  };
  const auto wheelset = [](const std::string& name, const char* key, double scale) {
    return [name, key, scale](const BogieRun& run) {
      return scale * run.Steady("wheelsets", name, key);
    };
  };
  const auto attack = [&results](const std::string& axle) {
    return
        [&results, axle](const BogieRun& run) { return 1e3 * AttackOutward(run, results, axle); };
  };
  *metrics = {
      {"Angle of attack, leading axle [mrad]", 0.1, attack(lead), true},
      {"– its swing (standard deviation) [mrad]", 0.1,
       [&results, lead](const BogieRun& run) {
         return 1e3 * run.Deviation(lead + "_angle_of_attack_rad", results.steady_begin,
                                    results.steady_end);
       }},
      {"Angle of attack, trailing axle [mrad]", 0.1, attack(trail), true},
      {"Lateral position, leading axle [mm]", 0.1, wheelset(lead, "lateral_m", 1e3)},
      {"Lateral position, trailing axle [mm]", 0.1, wheelset(trail, "lateral_m", 1e3)},
      {"Track-shifting force ΣY, leading axle [kN]", 0.5, wheelset(lead, "sum_Y_N", 1e-3)},
      {"Track-shifting force ΣY, trailing axle [kN]", 0.5, wheelset(trail, "sum_Y_N", 1e-3)},
      {"Guiding force Y, leading outer wheel [kN]", 0.5, wheel(prefix + "lead_outer", "Y_N", 1e-3)},
      {"Wheel load Q, leading outer wheel [kN]", 0.5, wheel(prefix + "lead_outer", "Q_N", 1e-3)},
      {"Y/Q, leading outer wheel [–]", 0.005, wheel(prefix + "lead_outer", "Y_over_Q", 1)},
      {"Wear number Tγ, leading outer wheel [N]", 1, wheel(prefix + "lead_outer", "T_gamma_N", 1)},
      {"Wear number Tγ, all wheels of the bogie [N]", 1,
       [prefix](const BogieRun& run) { return CurvingResults::SteadyWear(run, prefix); }},
      {"– the spin part beside it, Σ|Mz φ| [N]", 1,
       [prefix](const BogieRun& run) { return CurvingResults::SteadySpin(run, prefix); }},
      {"Bending (steering) of the bogie [mrad]", 0.1,
       [prefix](const BogieRun& run) {
         return 1e3 * run.Number("/steady_curve/" + prefix + "bending_rad");
       }},
      {"Greatest cylinder force [kN]", 0.1,
       [prefix](const BogieRun& run) { return 1e-3 * GreatestCylinderForce(run, prefix); }},
  };
  if (results.Axles(prefix).size() < 3) return;
  metrics->push_back({"Angle of attack, middle axle [mrad]", 0.1, attack(prefix + "mid"), true});
  metrics->push_back({"Track-shifting force ΣY, middle axle [kN]", 0.5,
                      wheelset(prefix + "mid", "sum_Y_N", 1e-3)});
}

/// Of several bogies the value of greatest magnitude; NaN if none has one.
double WorstAxle(const CurvingResults& results,
                 const std::function<double(const std::string&)>& of) {
  double worst = kNoNumber;
  for (const std::string& prefix : results.prefixes) {
    const double value = of(prefix);
    if (!std::isfinite(worst) || std::abs(value) > std::abs(worst)) worst = value;
  }
  return worst;
}

std::vector<Metric> RunMetrics() {
  const auto number = [](const char* pointer, double scale) {
    return [pointer, scale](const BogieRun& run) { return scale * run.Number(pointer); };
  };
  return {{"Greatest angle of attack [mrad]", 0.1, number("/run/max_angle_of_attack_rad", 1e3)},
          {"Greatest ΣY [kN]", 0.5, number("/run/max_sum_Y_N", 1e-3)},
          {"Greatest Y/Q [–]", 0.005, number("/run/max_Y_over_Q", 1)},
          {"Work lost as Tγ along the track, without spin [kJ]", 0.1,
           number("/run/T_gamma_total_J", 1e-3)},
          {"Work lost in creep along the track, with spin [kJ]", 0.1,
           number("/run/lost_creep_J", 1e-3)}};
}

void AddRows(const CurvingResults& results, const std::vector<Metric>& metrics, DataTable* table) {
  for (const Metric& metric : metrics) {
    std::vector<TableCell> row = {metric.label};
    const double own = metric.value(results.reference());
    bool any = false;
    for (const BogieRun& run : results.runs) {
      const double value = metric.value(run);
      any = any || std::isfinite(value);
      row.emplace_back(metric.attack ? AttackText(value, results) : FormatNumber(value),
                       &run == &results.reference());
    }
    for (std::size_t i = 1; i < results.runs.size(); ++i) {
      row.emplace_back(RatioText(metric.value(results.runs[i]), own, metric.floor));
    }
    if (any) table->rows.push_back(std::move(row));
  }
}

double EnergyOf(const BogieRun& run, const std::string& channel) {
  const std::vector<double>* values = run.Channel(channel);
  if (values == nullptr || values->empty()) return kNoNumber;
  // Kinetic energy is recorded as such, all others since the start.
  return values->back() - (channel == "energy_kinetic_J" ? values->front() : 0);
}

}  // namespace

void AddStatus(const CurvingResults& results, ReportPage* page) {
  for (const BogieRun& run : results.runs) {
    if (run.ok()) continue;
    page->Warning(fmt::format(
        "The run of the {} bogie ended as '{}': {}. Its numbers below hold only up to that point.",
        run.label, run.summary.value("status", "?"),
        run.summary.value("reason", "no reason given")));
  }
  for (const BogieRun& run : results.runs) {
    const json curve = run.summary.value("steady_curve", json::object());
    if (!curve.contains("speed_m_s") || curve["speed_m_s"].is_number()) continue;
    page->Warning(fmt::format(
        "The run of the {} bogie ends before its last axle has come to the steady curve (s = {} to "
        "{} m, the last third of the first arc, or of a track without one): it has no means there.",
        run.label, FormatNumber(results.steady_begin, 4), FormatNumber(results.steady_end, 4)));
  }
  for (const BogieRun& run : results.runs) {
    const double swing = WorstAxle(results, [&](const std::string& prefix) {
      return 1e3 * run.Deviation(prefix + "lead_angle_of_attack_rad", results.steady_begin,
                                 results.steady_end);
    });
    if (!(swing > kSteadySwing)) continue;
    page->Warning(
        fmt::format("The {} bogie does not come to rest in the arc: the angle of attack of its "
                    "leading axle keeps "
                    "swinging with a standard deviation of {} mrad. The means below hide that; "
                    "look at the plots.",
                    run.label, FormatNumber(swing, 2)));
  }
}

void AddKeyFigures(const CurvingResults& results, ReportPage* page) {
  struct Key {
    std::string label;
    std::string unit;
    double floor;
    std::function<double(const BogieRun&)> value;
    std::function<double(const BogieRun&)> attack = {};  ///< > 0 to the outer rail [mrad]
  };
  // Of a locomotive the bogie that does worse, and the wear of all its wheels.
  const std::string of = results.prefixes.size() > 1 ? " of the worse bogie" : "";
  const auto worst = [&results](const BogieRun& run, const char* list, const char* name,
                                const char* key, double scale) {
    return WorstAxle(results, [&](const std::string& prefix) {
      return scale * std::abs(run.Steady(list, prefix + name, key));
    });
  };
  const std::vector<Key> keys = {
      {"Angle of attack, leading axle" + of, "mrad", 0.1,
       [&](const BogieRun& run) {
         return worst(run, "wheelsets", "lead", "angle_of_attack_rad", 1e3);
       },
       [&](const BogieRun& run) {
         return WorstAxle(results, [&](const std::string& prefix) {
           return 1e3 * AttackOutward(run, results, prefix + "lead");
         });
       }},
      {"Guiding force Y, leading outer wheel" + of, "kN", 0.5,
       [&](const BogieRun& run) { return worst(run, "wheels", "lead_outer", "Y_N", 1e-3); }},
      {"Y/Q, leading outer wheel" + of, "", 0.005,
       [&](const BogieRun& run) { return worst(run, "wheels", "lead_outer", "Y_over_Q", 1); }},
      {"Wear number Tγ, all wheels", "N", 1,
       [&](const BogieRun& run) { return CurvingResults::SteadyWear(run, ""); }},
  };
  const auto where = [&results](const Key& key, const BogieRun& run) -> std::string {
    if (!key.attack) return "";
    const double to_outer = key.attack(run);
    const int hand = results.hand;
    const std::string side = RailPointedTo(hand == 0 ? to_outer : -hand * to_outer, hand);
    return side.empty() ? "" : hand == 0 ? " to the " + side : " to the " + side + " rail";
  };
  const auto bound_words = [](const std::string& ratio, const Key& key) {
    if (!ratio.starts_with("at least")) return std::string();
    return fmt::format(": below {:g}{} nothing is resolved", key.floor,
                       key.unit.empty() ? "" : " " + key.unit);
  };
  std::vector<KeyFigure> figures;
  for (const Key& key : keys) {
    const double own = key.value(results.reference());
    if (!std::isfinite(own)) continue;
    std::string remark;
    for (std::size_t i = 1; i < results.runs.size(); ++i) {
      const double other = key.value(results.runs[i]);
      if (!std::isfinite(other)) continue;
      const std::string ratio = RatioText(other, own, key.floor);
      remark += fmt::format("{}{}: {}{}{}{}", remark.empty() ? "" : "; ", results.runs[i].label,
                            FormatNumber(other), key.unit.empty() ? "" : " " + key.unit,
                            where(key, results.runs[i]),
                            ratio == "–" ? "" : " (" + ratio + bound_words(ratio, key) + ")");
    }
    figures.push_back({.value = FormatNumber(own),
                       .unit = key.unit + where(key, results.reference()),
                       .label = key.label + ", " + results.reference().label,
                       .remark = remark});
  }
  if (!figures.empty()) page->KeyFigures(figures);
}

void AddHeadlineTable(const CurvingResults& results, ReportPage* page) {
  DataTable table{.caption = "Steady curve: means over the last third of the circular arc"};
  table.head = {"Quantity"};
  for (const BogieRun& run : results.runs) table.head.push_back(run.label);
  for (std::size_t i = 1; i < results.runs.size(); ++i) {
    table.head.push_back(results.runs[i].label + " / " + results.reference().label);
  }
  for (const std::string& prefix : results.prefixes) {
    if (!prefix.empty()) {
      table.rows.push_back({TableCell(prefix == "front_" ? "Front bogie" : "Rear bogie")});
    }
    std::vector<Metric> metrics;
    AddSteadyMetrics(results, prefix, &metrics);
    AddRows(results, metrics, &table);
  }
  table.rows.push_back({TableCell("Whole run")});
  AddRows(results, RunMetrics(), &table);
  page->Add(table);
  page->Note(
      "Angle of attack: yaw of the axle against the radial direction of the track under it, with "
      "the rail that the axle points to (outer: the high rail). Lateral position: positive to the "
      "left. Tγ = |Tx ξ| + |Ty η| is the wear number, by its usual definition without the spin "
      "term "
      "|Mz φ|; the work lost in creep counts all slip, spin included, and so is larger. The last "
      "columns are ratios of magnitudes. “At least”: the number compared with is smaller than a "
      "run resolves (0.1 mrad, 0.1 mm, 0.5 kN, Y/Q 0.005, Tγ 1 N); that bound stands in its place, "
      "so the true ratio is larger.");
}

void AddComparisonBars(const CurvingResults& results, ReportPage* page) {
  page->Heading("Side by side, steady curve");
  page->BeginGrid(static_cast<int>(results.prefixes.size()));
  // Angle, track shift, guiding force and wear: the numbers that decide about wheel and rail.
  for (int index : {0, 5, 7, 11}) {
    for (const std::string& prefix : results.prefixes) {
      std::vector<Metric> metrics;
      AddSteadyMetrics(results, prefix, &metrics);
      const std::string whose =
          prefix.empty() ? "" : ", " + prefix.substr(0, prefix.size() - 1) + " bogie";
      BarChart chart{.title = metrics[index].label + whose, .categories = {""}};
      bool any = false;
      for (const BogieRun& run : results.runs) {
        double value = metrics[index].value(run);
        if (metrics[index].attack) value = std::abs(value);
        any = any || std::isfinite(value);
        chart.bars.push_back({run.label, run.colour, {value}});
      }
      if (any) page->Add(chart);
    }
  }
  page->EndGrid();
}

void AddEnergyTable(const CurvingResults& results, ReportPage* page) {
  const std::vector<std::pair<std::string, std::string>> lines = {
      {"Work of the drives", "work_in_J"},
      {"Lost in creep between wheel and rail", "lost_creep_J"},
      {"Lost in the contact dampers", "lost_contact_J"},
      {"Lost in suspension dampers", "lost_dampers_J"},
      {"Lost in the hydraulic steering (seals, oil)", "lost_phs_J"},
      {"Gained in kinetic energy", "energy_kinetic_J"},
      {"Stored at the end (springs, oil, gravity)", "energy_stored_J"}};
  DataTable table{.caption = "Energy over the whole run [kJ]", .head = {"Where"}};
  for (const BogieRun& run : results.runs) table.head.push_back(run.label);
  for (const auto& [label, channel] : lines) {
    std::vector<TableCell> row = {TableCell(label)};
    bool any = false;
    for (const BogieRun& run : results.runs) {
      const double value = EnergyOf(run, channel);
      any = any || std::isfinite(value);
      row.emplace_back(FormatNumber(1e-3 * value));
    }
    if (any) table.rows.push_back(std::move(row));
  }
  std::vector<TableCell> error = {"Missing in the balance, relative"};
  for (const BogieRun& run : results.runs) {
    error.emplace_back(FormatNumber(run.Number("/run/energy_error_relative"), 2));
  }
  table.rows.push_back(std::move(error));
  page->Paragraph(
      "Work in equals what is gained, stored and lost. The missing part is the numerical error of "
      "the run, over the largest of them; it should stay below 0.001. Creep counts all slip, spin "
      "included; the work lost as Tγ in the first table leaves spin away.");
  page->Add(table);
}

void AddInputs(const CurvingResults& results, ReportPage* page) {
  DataTable table{.caption = "The runs",
                  .head = {"Bogie", "Status", "Time step [ms]", "Times faster than real time"}};
  for (const BogieRun& run : results.runs) {
    table.rows.push_back({TableCell(run.label), TableCell(run.summary.value("status", "?")),
                          TableCell(FormatNumber(1e3 * run.Number("/timestep_s"))),
                          TableCell(FormatNumber(run.Number("/real_time_factor")))});
  }
  page->Add(table);
  if (!results.sections.empty()) {
    DataTable track{.caption = "Track " + results.track_name,
                    .head = {"Section", "From [m]", "To [m]", "Radius [m]"}};
    for (const Section& section : results.sections) {
      track.rows.push_back({TableCell(section.kind), TableCell(FormatNumber(section.begin, 4)),
                            TableCell(FormatNumber(section.end, 4)),
                            TableCell(FormatNumber(section.radius, 4))});
    }
    page->Add(track);
  }
  const json scenario = results.all.value("scenario", json::object());
  if (!scenario.empty()) {
    page->BeginDetails("Scenario as it was run");
    page->Preformatted(scenario.dump(2));
    page->EndDetails();
  }
  for (const BogieRun& run : results.runs) {
    const json inputs = run.summary.value("inputs", json::object());
    if (inputs.empty()) continue;
    page->BeginDetails("Inputs of the " + run.label + " bogie");
    page->Preformatted(inputs.dump(2));
    page->EndDetails();
  }
  page->List(
      {"The vehicle data of the 19E-like bogie are partly assumed (wheelbase, suspension); "
       "each assumption is marked where it stands, in the files of bogie_xml/ and models/.",
       "Wheel-rail contact: real profiles, Hertzian contact patches, creep forces by the law "
       "named in the scenario; Coulomb friction with one coefficient for each contact.",
       "Rail and wheel wear, profile change and rail flexibility beyond the track's own "
       "support springs are not part of the run."});
}

}  // namespace phs::report
