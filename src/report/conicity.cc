#include "report/conicity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "report/curving_results.h"
#include "report/json_fields.h"

namespace phs::report {
namespace {

using json = nlohmann::ordered_json;

constexpr double kNamed_mm = 3;  ///< the amplitude that EN 15302 compares pairs at
constexpr double kSame_mm = 1e-6;

/// A curve and the bogies that have it.
struct Shared {
  std::vector<std::string> bogies;
  double load_N = 0;
  Curve curve;
};

/// Texts and who they hold of.
struct Said {
  std::string text;
  std::vector<std::string> bogies;
};

std::string Joined(const std::vector<std::string>& bogies, size_t all) {
  if (bogies.size() == all) return "";
  return fmt::format("{}", fmt::join(bogies, ", "));
}

/// Profile files often hold the section as it lies, inclined already.
std::string Inclination(double rad) {
  if (rad == 0) return "as its file has it";
  return fmt::format("inclined 1:{:.0f} against its file", 1 / std::tan(std::abs(rad)));
}

std::string ConicityWords(const json& pair) {
  const double worn = 1e3 * NumberOf(pair, "worn_depth_m");
  return fmt::format(
      "Wheel {}{}, radius {:.1f} mm, flange backs {:.1f} mm apart; rail {}, {}; gauge {:.1f} mm, "
      "measured {:.1f} mm below the rail top.",
      pair.value("wheel", "?"),
      worn != 0 ? fmt::format(" worn hollow by {:.2g} mm", worn) : std::string(),
      1e3 * NumberOf(pair, "wheel_radius_m"), 1e3 * NumberOf(pair, "flange_back_distance_m"),
      pair.value("rail", "?"), Inclination(NumberOf(pair, "rail_inclination_rad")),
      1e3 * NumberOf(pair, "gauge_m"), 1e3 * NumberOf(pair, "gauge_depth_m"));
}

Curve ReadCurve(const json& saved) {
  Curve curve;
  const json amplitudes = saved.value("amplitude_m", json::array());
  const json values = saved.value("equivalent", json::array());
  for (size_t i = 0; i < std::min(amplitudes.size(), values.size()); ++i) {
    curve.x.push_back(1e3 * AsNumber(amplitudes[i]));
    curve.y.push_back(AsNumber(values[i]));
  }
  return curve;
}

void Collect(const ConicityOf& bogie, std::vector<Shared>* curves) {
  for (const json& saved : bogie.conicity.value("curves", json::array())) {
    const Curve read = ReadCurve(saved);
    const double load = NumberOf(saved, "wheel_load_N");
    const auto same = std::find_if(curves->begin(), curves->end(), [&](const Shared& s) {
      return s.load_N == load && s.curve.x == read.x && s.curve.y == read.y;
    });
    if (same != curves->end()) {
      same->bogies.push_back(bogie.label);
      continue;
    }
    Shared own{{bogie.label}, load, read};
    own.curve.colour = (bogie.colour + (load > 0 ? 4 : 0)) % 8;
    own.curve.dash = load > 0 ? 1 : 0;
    curves->push_back(std::move(own));
  }
}

void Say(const std::string& text, const std::string& bogie, std::vector<Said>* said) {
  const auto same =
      std::find_if(said->begin(), said->end(), [&](const Said& one) { return one.text == text; });
  if (same != said->end()) {
    same->bogies.push_back(bogie);
  } else {
    said->push_back({text, {bogie}});
  }
}

std::string LoadedName(const Shared& one, size_t all) {
  const std::string who = Joined(one.bogies, all);
  const std::string load =
      one.load_N > 0 ? fmt::format("elastic, {} kN on each wheel", FormatNumber(1e-3 * one.load_N))
                     : std::string("rigid bodies");
  return who.empty() ? load : who + ": " + load;
}

/// At an amplitude of the curve; NaN elsewhere.
double ConicityAt(const Curve& curve, double amplitude_mm) {
  for (size_t i = 0; i < curve.x.size(); ++i) {
    if (std::abs(curve.x[i] - amplitude_mm) < kSame_mm) return curve.y[i];
  }
  return std::nan("");
}

void AddConicityPlot(const std::vector<Shared>& curves, ReportPage* page) {
  XyPlot plot{.title = "Equivalent conicity over the amplitude of the lateral motion",
              .x_label = "amplitude [mm]",
              .y_label = "equivalent conicity tan γe [–]"};
  for (const Shared& one : curves) plot.curves.push_back(one.curve);
  Curve named{.label = fmt::format("at {:g} mm", kNamed_mm), .colour = 3, .points = true};
  for (const Shared& one : curves) {
    const double value = ConicityAt(one.curve, kNamed_mm);
    if (!std::isfinite(value)) continue;
    named.x.push_back(kNamed_mm);
    named.y.push_back(value);
  }
  if (!named.x.empty()) plot.curves.push_back(std::move(named));
  page->Add(plot);
}

void AddConicityTable(const std::vector<Shared>& curves, ReportPage* page) {
  DataTable table{.caption = "Equivalent conicity tan γe [–]", .head = {"Amplitude [mm]"}};
  double most = 0;
  for (const Shared& one : curves) {
    table.head.push_back(one.curve.label);
    if (!one.curve.x.empty()) most = std::max(most, one.curve.x.back());
  }
  for (double amplitude = 1; amplitude < most + kSame_mm; ++amplitude) {
    const bool named = amplitude == kNamed_mm;
    std::vector<TableCell> row = {TableCell(fmt::format("{:g}", amplitude))};
    for (const Shared& one : curves) {
      row.emplace_back(FormatNumber(ConicityAt(one.curve, amplitude)), named);
    }
    table.rows.push_back(std::move(row));
  }
  page->Add(table);
}

}  // namespace

std::vector<ConicityOf> ConicityOfBogies(const json& conicity,
                                         const std::vector<std::string>& bogies) {
  std::vector<ConicityOf> all;
  for (const std::string& name : bogies) {
    const int colour = static_cast<int>(all.size()) % 8;
    all.push_back({BogieLabel(name), colour, conicity.value(name, json())});
  }
  return all;
}

void AddConicity(const std::vector<ConicityOf>& bogies, ReportPage* page) {
  page->Section("Conicity");
  std::vector<Shared> curves;
  std::vector<Said> pairs, missing;
  for (const ConicityOf& bogie : bogies) {
    const json& found = bogie.conicity;
    if (!found.is_object()) {
      Say("it was not kept with this result, which an older version wrote; run it again",
          bogie.label, &missing);
    } else if (!found.contains("curves")) {
      Say(found.value("missing", "the results give no reason"), bogie.label, &missing);
    } else {
      Collect(bogie, &curves);
      Say(ConicityWords(found), bogie.label, &pairs);
    }
  }
  for (const Said& one : missing) {
    const std::string who = Joined(one.bogies, bogies.size());
    page->Note(fmt::format("There is no conicity curve{}: {}.", who.empty() ? "" : " of " + who,
                           one.text));
  }
  if (curves.empty()) return;
  for (Shared& one : curves) one.curve.label = LoadedName(one, bogies.size());
  for (const Said& one : pairs) {
    page->Paragraph(one.text, Joined(one.bogies, bogies.size()));
  }
  page->Paragraph(fmt::format(
      "A wheelset alone, without yaw, swings about the middle of these rails as y″ = −(Δr(y) − "
      "Δr(y₀)) / (e r₀), with Δr the difference of the rolling radii right less left, e the "
      "distance "
      "of the contact points and r₀ the radius in the middle. tan γe = (π/L)² 2 e r₀ is the "
      "inclination of the cones whose wave has the same length L at the same amplitude (EN "
      "15302:2008, annex B). Pairs are compared at {:g} mm (marked, bold in the table). A larger "
      "value steers more in curves and makes hunting begin at a lower speed. Where the curve rises "
      "steeply a flange touches (drag in the plot to zoom).",
      kNamed_mm));
  page->BeginGrid(2);
  AddConicityPlot(curves, page);
  AddConicityTable(curves, page);
  page->EndGrid();
}

}  // namespace phs::report
