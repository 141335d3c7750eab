// The report of stability.json: critical speeds, root locus, mode at the limit, limit cycle.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>

#include "report/analysis_report.h"
#include "report/json_fields.h"
#include "report/report_page.h"

namespace phs::report {
namespace {

using json = nlohmann::ordered_json;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Least damping ratio -Re/|λ| of the oscillating eigenvalues at each speed.
Curve LeastDamping(const json& eigenvalues) {
  std::map<double, double> least;
  for (const json& value : eigenvalues) {
    const double speed = NumberOf(value, "speed_m_s");
    const double real = NumberOf(value, "real_1_s");
    const double imag = NumberOf(value, "imag_rad_s");
    if (!std::isfinite(speed) || !(std::abs(imag) > 1e-6)) continue;
    const double ratio = -real / std::hypot(real, imag);
    const auto [at, added] = least.emplace(speed, ratio);
    if (!added) at->second = std::min(at->second, ratio);
  }
  Curve curve{.label = "least damping ratio"};
  for (const auto& [speed, ratio] : least) {
    curve.x.push_back(3.6 * speed);
    curve.y.push_back(100 * ratio);
  }
  return curve;
}

Curve Points(const json& eigenvalues, bool frequency) {
  Curve curve{.label = frequency ? "frequency" : "growth rate", .points = true};
  for (const json& value : eigenvalues) {
    const double imag = NumberOf(value, "imag_rad_s");
    if (frequency && !(imag > 1e-6 && imag < 2 * M_PI * 30)) continue;
    // Heavily damped modes would squeeze what matters.
    if (!frequency && NumberOf(value, "real_1_s") < -50) continue;
    curve.x.push_back(3.6 * NumberOf(value, "speed_m_s"));
    curve.y.push_back(frequency ? imag / (2 * M_PI) : NumberOf(value, "real_1_s"));
  }
  return curve;
}

/// Eigenvalues in the complex plane, upper half, in three bands of speed. Modes that die out faster
/// than they swing tell nothing about hunting and would squeeze the picture.
XyPlot RootLocus(const json& eigenvalues) {
  double least = 1e300;
  double greatest = 0;
  for (const json& value : eigenvalues) {
    least = std::min(least, NumberOf(value, "speed_m_s"));
    greatest = std::max(greatest, NumberOf(value, "speed_m_s"));
  }
  XyPlot plot{.title = "Root locus (right of zero: unstable)",
              .x_label = "real part [1/s]",
              .y_label = "frequency [Hz]"};
  for (int band = 0; band < 3; ++band) {
    const double low = least + (greatest - least) * band / 3;
    const double high = least + (greatest - least) * (band + 1) / 3;
    plot.curves.push_back(Curve{.label = fmt::format("{:.0f} – {:.0f} km/h", 3.6 * low, 3.6 * high),
                                .colour = band,
                                .points = true});
  }
  for (const json& value : eigenvalues) {
    const double real = NumberOf(value, "real_1_s");
    const double imag = NumberOf(value, "imag_rad_s");
    if (!(imag > 1e-6) || imag < -real || imag > 2 * M_PI * 30) continue;
    const double share = (NumberOf(value, "speed_m_s") - least) / std::max(greatest - least, 1e-9);
    Curve& curve = plot.curves[static_cast<size_t>(std::clamp(static_cast<int>(3 * share), 0, 2))];
    curve.x.push_back(real);
    curve.y.push_back(imag / (2 * M_PI));
  }
  return plot;
}

/// Value of a swinging quantity at a phase.
double At(const json& body, const char* quantity, const char* amplitude, double phase) {
  const json part = body.value(quantity, json::object());
  return NumberOf(part, amplitude) * std::cos(NumberOf(part, "phase_rad") + phase);
}

/// Plan view: wheelsets as lines across, other bodies as lines along, at four instants.
XyPlot ModeShape(const json& mode) {
  constexpr double kDrawn = 0.35;          // of a motion of one metre [m]
  constexpr double kHalf[2] = {0.9, 0.6};  // of a body along, of a wheelset across [m]
  XyPlot plot{.title = "Mode at the limit seen from above, a quarter period apart",
              .x_label = "along the track [m]",
              .y_label = "to the left [m], motion enlarged"};
  for (int quarter = 0; quarter < 4; ++quarter) {
    Curve curve{.label = fmt::format("{}°", 90 * quarter), .colour = quarter, .dash = quarter};
    for (const json& body : mode.value("bodies", json::array())) {
      const double phase = M_PI / 2 * quarter;
      const bool wheelset = body.value("wheelset", false);
      const double x =
          NumberOf(body, "x_m") + kDrawn * At(body, "longitudinal", "amplitude_m", phase);
      const double y = kDrawn * At(body, "lateral", "amplitude_m", phase);
      const double yaw = kDrawn * At(body, "yaw", "amplitude_rad", phase);
      for (const double end : {-kHalf[wheelset], kHalf[wheelset]}) {
        curve.x.push_back(x + (wheelset ? -yaw * end : end));
        curve.y.push_back(y + (wheelset ? end : yaw * end));
      }
      curve.x.push_back(kNone);
      curve.y.push_back(kNone);
    }
    plot.curves.push_back(std::move(curve));
  }
  return plot;
}

DataTable ModeTable(const json& mode) {
  DataTable table{.caption = "Amplitude and phase of each body (wheelset's largest motion = 1 m)",
                  .head = {"Body", "lateral [m]", "phase [°]", "yaw [rad]", "phase [°]",
                           "roll [rad]", "phase [°]", "along [m]", "phase [°]"}};
  for (const json& body : mode.value("bodies", json::array())) {
    std::vector<TableCell> row = {TableCell(body.value("name", ""))};
    for (const auto& [quantity, unit] : {std::pair{"lateral", "amplitude_m"},
                                         {"yaw", "amplitude_rad"},
                                         {"roll", "amplitude_rad"},
                                         {"longitudinal", "amplitude_m"}}) {
      const json part = body.value(quantity, json::object());
      row.emplace_back(FormatNumber(NumberOf(part, unit)));
      row.emplace_back(fmt::format("{:.0f}", 180 / M_PI * NumberOf(part, "phase_rad")));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

Curve RampCurve(const json& ramp, const std::string& label, int colour) {
  Curve curve{.label = label, .colour = colour, .dash = colour};
  for (const json& point : ramp) {
    curve.x.push_back(3.6 * NumberOf(point, "speed_m_s"));
    curve.y.push_back(1e3 * NumberOf(point, "amplitude_m"));
  }
  return curve;
}

void AddGlance(const json& result, ReportPage* page) {
  std::vector<KeyFigure> figures;
  const double critical = 3.6 * NumberOf(result, "critical_speed_m_s");
  const json mode = result.value("critical_mode", json::object());
  if (std::isfinite(critical)) {
    figures.push_back(
        {.value = FormatNumber(critical), .unit = "km/h", .label = "linear critical speed"});
    if (const double f = NumberOf(mode, "frequency_Hz"); std::isfinite(f)) {
      figures.push_back({.value = FormatNumber(f), .unit = "Hz", .label = "frequency there"});
    }
    if (const double length = NumberOf(mode, "wavelength_m"); std::isfinite(length)) {
      figures.push_back({.value = FormatNumber(length), .unit = "m", .label = "wavelength there"});
    }
  }
  const json cycle = result.value("limit_cycle", json::object());
  if (const double v = 3.6 * NumberOf(cycle, "nonlinear_critical_speed_m_s"); std::isfinite(v)) {
    figures.push_back({.value = FormatNumber(v),
                       .unit = "km/h",
                       .label = "non-linear critical speed",
                       .remark = "below it hunting dies out"});
  }
  if (!figures.empty()) page->KeyFigures(figures);
  if (result.value("unstable_at_least_speed", false)) {
    page->Warning("Unstable already at the lowest speed of the scan.");
  } else if (!std::isfinite(critical)) {
    page->Note("No critical speed in the range of speeds.");
  }
}

}  // namespace

Status WriteStabilityReport(const std::string& stability_file, const std::string& path) {
  const Result<json> read = ReadJsonObject(stability_file);
  if (!read.ok()) return read.error();
  const json& result = read.value();
  const json eigenvalues = result.value("eigenvalues", json::array());
  ReportPage page("Stability over speed", result.value("bogie", ""));
  page.Section("At a glance");
  AddGlance(result, &page);
  page.Section("Over speed");
  page.BeginGrid(2);
  const std::string speed = "speed [km/h]";
  page.Add(RootLocus(eigenvalues));
  page.Add(XyPlot{.title = "Growth rate of every mode (above zero: unstable)",
                  .x_label = speed,
                  .y_label = "real part [1/s]",
                  .curves = {Points(eigenvalues, false)}});
  page.Add(XyPlot{.title = "Frequency of the oscillating modes",
                  .x_label = speed,
                  .y_label = "frequency [Hz]",
                  .curves = {Points(eigenvalues, true)}});
  page.Add(XyPlot{.title = "Least damping ratio",
                  .x_label = speed,
                  .y_label = "damping ratio [%]",
                  .curves = {LeastDamping(eigenvalues)}});
  page.EndGrid();
  if (const json mode = result.value("critical_mode", json::object()); !mode.empty()) {
    page.Section("Least stable mode");
    page.Paragraph(fmt::format(
        "At {} km/h: {} Hz, damping ratio {} %.", FormatNumber(3.6 * NumberOf(mode, "speed_m_s")),
        FormatNumber(NumberOf(mode, "frequency_Hz")),
        FormatNumber(std::round(1e4 * NumberOf(mode, "damping_ratio")) / 100)));
    page.Add(ModeShape(mode));
    page.Add(ModeTable(mode));
  }
  if (const json cycle = result.value("limit_cycle", json::object()); !cycle.empty()) {
    page.Section("Limit cycle");
    page.Paragraph(
        "Amplitude of the leading wheelset's lateral motion while the speed goes slowly down from "
        "above the linear critical speed, and slowly up with a small disturbance. Between the "
        "non-linear and the linear critical speed the vehicle runs straight until something "
        "disturbs it enough.");
    page.Add(XyPlot{.title = "Hunting over speed",
                    .x_label = speed,
                    .y_label = "lateral amplitude [mm]",
                    .curves = {RampCurve(cycle.value("down", json::array()), "down", 0),
                               RampCurve(cycle.value("up", json::array()), "up", 1)}});
  }
  return page.Write(path);
}

}  // namespace phs::report
