// The report of stability.json: critical speeds, root locus, mode at the limit, limit cycle.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <map>
#include <nlohmann/json.hpp>
#include <vector>

#include "report/analysis_report.h"
#include "report/json_fields.h"
#include "report/moving_shape.h"
#include "report/report_page.h"

namespace phs::report {
namespace {

using json = nlohmann::ordered_json;

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

/// Complex amplitude of a swinging quantity.
std::complex<double> Swing(const json& body, const char* quantity, const char* amplitude) {
  const json part = body.value(quantity, json::object());
  const double size = NumberOf(part, amplitude);
  const double phase = NumberOf(part, "phase_rad");
  return std::isfinite(size) && std::isfinite(phase) ? std::polar(std::abs(size), phase) : 0;
}

/// Plan view: wheelsets with their wheels, what stands at a wheelset's place (axle boxes) beside
/// the wheels, and other bodies as lines along with one across.
MovingShape ModeShape(const json& mode) {
  constexpr double kHalfAxle = 0.9, kWheel = 0.75, kWheelRadius = 0.3, kBox = 1.0;  // [m]
  constexpr double kSamePlace = 0.05;                                               // [m]
  const double frequency = NumberOf(mode, "frequency_Hz");
  MovingShape shape{.title = "Least stable mode seen from above, motion enlarged",
                    .keys = {{"wheelsets, faint a quarter period apart", 0},
                             {"axle boxes", 1},
                             {"other bodies", 7, 1}},
                    .traces_deg = {0, 90, 180, 270},
                    .period_s = PlayedPeriod(frequency)};
  const json bodies = mode.value("bodies", json::array());
  std::vector<double> wheelsets;
  for (const json& body : bodies) {
    if (body.value("wheelset", false)) wheelsets.push_back(NumberOf(body, "x_m"));
  }
  std::vector<double> others;  // places of bodies drawn: the next one there is drawn larger
  for (const json& body : bodies) {
    const double x = NumberOf(body, "x_m");
    if (!std::isfinite(x)) continue;
    const std::complex<double> dx = Swing(body, "longitudinal", "amplitude_m");
    const std::complex<double> dy = Swing(body, "lateral", "amplitude_m");
    const std::complex<double> yaw = Swing(body, "yaw", "amplitude_rad");
    const auto line = [&](int key, double along0, double left0, double along1, double left1,
                          double width, bool trace = false) {
      shape.lines.push_back({.name = body.value("name", ""),
                             .key = key,
                             .from = PointOfBody(x, along0, left0, dx, dy, yaw),
                             .to = PointOfBody(x, along1, left1, dx, dy, yaw),
                             .width_px = width,
                             .trace = trace});
    };
    const auto there = [x](double place) { return std::abs(place - x) < kSamePlace; };
    if (body.value("wheelset", false)) {
      line(0, 0, -kHalfAxle, 0, kHalfAxle, 4, true);
      for (const double side : {-kWheel, kWheel})
        line(0, -kWheelRadius, side, kWheelRadius, side, 3);
    } else if (std::any_of(wheelsets.begin(), wheelsets.end(), there)) {
      for (const double side : {-kBox, kBox}) line(1, -0.15, side, 0.15, side, 6);
    } else {
      const auto before = static_cast<double>(std::count_if(others.begin(), others.end(), there));
      others.push_back(x);
      line(2, -0.9 - 0.3 * before, 0, 0.9 + 0.3 * before, 0, 2);
      line(2, 0, -0.5 - 0.2 * before, 0, 0.5 + 0.2 * before, 2);
    }
  }
  Enlarge(0.35, &shape.lines);
  return shape;
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

/// The branch of the map in parts: where the speed rises along it there is hunting, where it falls
/// the brink. Less than 0.03 m/s is no turn.
std::vector<Curve> PartsOfMap(const json& points) {
  constexpr double kNoTurn = 0.03;
  std::vector<Curve> parts;
  std::array<int, 2> count = {0, 0};
  size_t begin = 0, turn = 0;
  const auto speed = [&](size_t i) { return NumberOf(points[i], "speed_m_s"); };
  const auto close = [&](size_t end) {
    const bool rises = speed(end) > speed(begin);
    Curve part = RampCurve(json(points.begin() + static_cast<long>(begin),
                                points.begin() + static_cast<long>(end) + 1),
                           rises ? "hunting" : "brink", rises ? 0 : 1);
    if (const int n = ++count[rises ? 0 : 1]; n > 1) part.label += fmt::format(" ({})", n);
    parts.push_back(std::move(part));
    begin = end;
  };
  for (size_t i = 1; i < points.size(); ++i) {
    const double way = speed(turn) - speed(begin);
    if ((speed(i) - speed(turn)) * way >= 0) {
      turn = i;
    } else if (std::abs(speed(i) - speed(turn)) > kNoTurn) {
      if (std::abs(way) > kNoTurn) close(turn);
      turn = i;
    }
  }
  if (points.size() > 1) close(points.size() - 1);
  return parts;
}

void AddHuntingMap(const json& map, ReportPage* page) {
  const json points = map.value("points", json::array());
  if (points.empty()) return;
  page->Section("Map of hunting");
  page->Paragraph(fmt::format(
      "At which speed does a periodic motion of this amplitude keep itself up? By harmonic balance "
      "with {} harmonics. Beyond the brink a disturbance grows, below it dies; hunting is what it "
      "grows to. Below the lowest speed hunting cannot live.",
      map.value("harmonics", 0)));
  page->Add(XyPlot{.title = "Amplitude over speed",
                   .x_label = "speed [km/h]",
                   .y_label = "lateral amplitude of the leading wheelset [mm]",
                   .curves = PartsOfMap(points)});
}

void AddStabilityGlance(const json& result, ReportPage* page) {
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
  const json map = result.value("hunting_map", json::object());
  const json least =
      map.contains("least") && map["least"].is_object() ? map["least"] : json::object();
  if (const double v = 3.6 * NumberOf(least, "speed_m_s"); std::isfinite(v)) {
    figures.push_back({.value = FormatNumber(v),
                       .unit = "km/h",
                       .label = "lowest speed of the map of hunting",
                       .remark = "below it hunting cannot live"});
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
  AddStabilityGlance(result, &page);
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
    page.Paragraph(PlayedWords(NumberOf(mode, "frequency_Hz")) + " " +
                   GrowthWords(NumberOf(mode, "real_1_s"), NumberOf(mode, "frequency_Hz")));
    AddMovingShape(ModeShape(mode), &page);
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
  AddHuntingMap(result.value("hunting_map", json::object()), &page);
  return page.Write(path);
}

}  // namespace phs::report
