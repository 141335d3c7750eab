// What the report says of the run's own error and of limits that it touched.
#include <fmt/format.h>

#include <cmath>

#include "report/curving_parts.h"
#include "report/number_names.h"

namespace phs::report {
namespace {

using json = nlohmann::ordered_json;

constexpr double kEnergyErrorShare = 1e-3;  ///< as docs/results.md says
constexpr double kMovingShare = 0.02;

/// By what a change is judged: of_scale if it has one, else relative; NaN if it has neither.
double Judged(const json& change) {
  const json of_scale = change.value("of_scale", json());
  const json judged = of_scale.is_number() ? of_scale : change.value("relative", json());
  return judged.is_number() ? judged.get<double>() : std::nan("");
}

/// True for what is always shown: the wheels and wheelsets of the steady curve and the whole run.
bool IsHeadline(const std::string& name) {
  return name.starts_with("run.") || name.starts_with("steady_curve.wheelsets.") ||
         name == "steady_curve.T_gamma_N" || name.ends_with("_outer.Y_N") ||
         name.ends_with("_outer.T_gamma_N");
}

void AddChanges(const BogieRun& run, const json& discretisation, ReportPage* page) {
  DataTable table{
      .caption = fmt::format("{}: step {} ms against {} ms", run.label,
                             FormatNumber(1e3 * discretisation.value("timestep_s", 0.0)),
                             FormatNumber(1e3 * discretisation.value("half_step_s", 0.0))),
      .head = {"Number", "Value", "Half step", "Change [%]", "Judged by"}};
  const json changes = discretisation.value("changes", json::object());
  for (const auto& [name, change] : changes.items()) {
    const double judged = Judged(change);
    const bool moves = std::abs(judged) > kMovingShare;
    if (!moves && !IsHeadline(name)) continue;
    const bool of_scale = change.value("of_scale", json()).is_number();
    const NumberName named = NameOfNumber(name);
    table.rows.push_back({TableCell(named.words + " [" + named.unit + "]"),
                          TableCell(FormatNumber(named.factor * change.value("value", 0.0))),
                          TableCell(FormatNumber(named.factor * change.value("half_step", 0.0))),
                          TableCell(FormatNumber(100 * judged, 2), moves),
                          TableCell(of_scale ? "largest magnitude in the run" : "its own size")});
  }
  page->Add(table);
}

}  // namespace

void AddRunWarnings(const CurvingResults& results, ReportPage* page) {
  for (const BogieRun& run : results.runs) {
    for (const json& warning : run.summary.value("warnings", json::array())) {
      page->Warning(fmt::format("{}: {}.", run.label, warning.value("text", "")));
    }
    const double error = run.Number("/run/energy_error_relative");
    if (std::abs(error) > kEnergyErrorShare) {
      page->Warning(
          fmt::format("{}: {} % of the energy is missing in the balance; more than 0.1 % "
                      "asks for a smaller step.",
                      run.label, FormatNumber(100 * error, 2)));
    }
    const json moving =
        run.summary.value("discretisation", json::object()).value("moving", json::array());
    if (moving.empty()) continue;
    page->Warning(
        fmt::format("{}: {} of its numbers move by more than 2 % when the step is "
                    "halved; they are marked under “Inputs and assumptions”.",
                    run.label, moving.size()));
  }
}

void AddDiscretisation(const CurvingResults& results, ReportPage* page) {
  bool any = false;
  for (const BogieRun& run : results.runs) {
    const json discretisation = run.summary.value("discretisation", json());
    if (!discretisation.is_object()) continue;
    if (!any) {
      page->Heading("What the step changes");
      page->Paragraph(
          "Each run was made again with half the step. Numbers that change sign are judged by "
          "their largest magnitude in the run, all others by their own size; what moves by more "
          "than 2 % is in bold. Angles and lateral positions are positive to the left, ΣY to the "
          "right, moments to the left. More numbers are in the result's JSON file.");
    }
    any = true;
    AddChanges(run, discretisation, page);
  }
}

}  // namespace phs::report
