// What a reader asks first: how the curve lies, and which wheel carries most.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/axle_words.h"
#include "report/curving_parts.h"

namespace phs::report {
namespace {

using json = nlohmann::ordered_json;

constexpr double kGravity = 9.81;  // m/s2, as in the models

/// Cant of the steady part [rad], without sign; NaN if the track was not saved.
double CantOf(const CurvingResults& results) {
  if (!results.all.contains("/track/centre_line/cant_rad"_json_pointer)) return std::nan("");
  const json& line = results.all["track"]["centre_line"];
  const double middle = 0.5 * (results.steady_begin + results.steady_end);
  double best = std::nan(""), nearest = 1e300;
  for (size_t i = 0; i < line.at("s_m").size() && i < line.at("cant_rad").size(); ++i) {
    const double away = std::abs(line.at("s_m").at(i).get<double>() - middle);
    if (away < nearest) nearest = away, best = std::abs(line.at("cant_rad").at(i).get<double>());
  }
  return best;
}

struct WorstWheel {
  double value = 0;
  std::string name = {};
};

WorstWheel LargestOf(const BogieRun& run, const char* key) {
  WorstWheel worst;
  const json* wheels = nullptr;
  if (run.summary.contains("/steady_curve/wheels"_json_pointer)) {
    wheels = &run.summary["steady_curve"]["wheels"];
  }
  for (size_t i = 0; wheels != nullptr && i < wheels->size(); ++i) {
    const json& wheel = (*wheels)[i];
    const double value = std::abs(run.Steady("wheels", wheel.value("name", ""), key));
    if (value > worst.value) worst = {value, wheel.value("name", "")};
  }
  return worst;
}

/// "leading outer wheel" of "lead_outer"; of a locomotive "front bogie's leading outer wheel".
std::string WheelName(const CurvingResults& results, const std::string& wheel) {
  for (const std::string& prefix : results.prefixes) {
    for (const AxleName& axle : results.Axles(prefix)) {
      const std::string head = prefix + axle.name + "_";
      if (!wheel.starts_with(head)) continue;
      const std::string bogie = prefix.empty() ? "" : prefix.substr(0, prefix.size() - 1);
      return (bogie.empty() ? "" : bogie + " bogie's ") + axle.word + " " +
             wheel.substr(head.size()) + " wheel";
    }
  }
  return wheel;
}

}  // namespace

void AddTrackWords(const CurvingResults& results, ReportPage* page) {
  if (results.hand == 0 || !(results.radius > 0)) return;
  const double speed = results.reference().Number("/steady_curve/speed_m_s");
  const double cant = CantOf(results);
  if (!std::isfinite(speed) || !std::isfinite(cant)) return;
  const double left = speed * speed / results.radius * std::cos(cant) - kGravity * std::sin(cant);
  std::string balance;
  if (cant > 0) {
    balance =
        fmt::format("; it balances {} km/h",
                    FormatNumber(3.6 * std::sqrt(kGravity * results.radius * std::tan(cant))));
  }
  page->Paragraph(
      fmt::format("{} curve of R = {} m, canted by {} mrad{}. At {} km/h {} m/s² are left "
                  "towards the {} rail.",
                  results.hand > 0 ? "Left" : "Right", FormatNumber(results.radius),
                  FormatNumber(1e3 * cant), balance, FormatNumber(3.6 * speed),
                  FormatNumber(std::abs(left)), left >= 0 ? "outer" : "inner"),
      "The curve.");
}

void AddWheelWords(const CurvingResults& results, ReportPage* page) {
  for (const BogieRun& run : results.runs) {
    const WorstWheel guiding = LargestOf(run, "Y_N"), ratio = LargestOf(run, "Y_over_Q"),
                     slope = LargestOf(run, "contact_angle_rad"),
                     flange = LargestOf(run, "flange_N");
    if (guiding.name.empty() || ratio.name.empty()) continue;
    std::string text = fmt::format(
        "In the steady curve the largest guiding force is {} kN ({}), the largest Y/Q {} ({}).",
        FormatNumber(1e-3 * guiding.value), WheelName(results, guiding.name),
        FormatNumber(ratio.value), WheelName(results, ratio.name));
    if (!slope.name.empty()) {
      text += fmt::format(" The steepest contact has {}° ({});",
                          FormatNumber(slope.value * 180 / M_PI), WheelName(results, slope.name));
      text += flange.value > 0
                  ? fmt::format(" a flange carries {} kN ({}).", FormatNumber(1e-3 * flange.value),
                                WheelName(results, flange.name))
                  : " no flange carries anything.";
    }
    page->Paragraph(text, "Wheels of the " + run.label + " bogie.");
  }
}

}  // namespace phs::report
