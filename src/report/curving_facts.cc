// What a reader asks first: how the curve lies, and which wheel carries most.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/axle_words.h"
#include "base/gravity.h"
#include "report/curving_parts.h"

namespace phs::report {
namespace {

using json = nlohmann::ordered_json;

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

/// "S1002 on UIC60, friction 0.35."; empty if the results do not say.
std::string PairWords(const json& all) {
  const json scenario = all.value("scenario", json::object());
  if (!scenario.contains("wheel") || !scenario.contains("rail")) return "";
  std::string text = fmt::format(" Wheels {} on rails {}", scenario.value("wheel", ""),
                                 scenario.value("rail", ""));
  if (scenario.contains("friction") && scenario["friction"].is_number()) {
    text += fmt::format(", friction {:g}", scenario["friction"].get<double>());
  }
  return text + ".";
}

/// How much of the yaw between its outer axles that a radial position asks for a bogie has: it lacks
/// what their angles of attack differ by.
std::string RadialWords(const CurvingResults& results, const BogieRun& run) {
  std::string text;
  for (const std::string& prefix : results.prefixes) {
    const auto axles = results.Axles(prefix);
    if (axles.size() < 2) continue;
    const auto between = [&](const char* key) {
      return run.Steady("wheelsets", prefix + axles.front().name, key) -
             run.Steady("wheelsets", prefix + axles.back().name, key);
    };
    const double bent = between("yaw_rad"), needed = bent - between("angle_of_attack_rad");
    if (!std::isfinite(needed) || std::abs(needed) < 1e-4) continue;
    text +=
        fmt::format(" {}The axles stand {} mrad to each other; radial they would stand {} ({} %).",
                    prefix.empty() ? "" : "The " + prefix.substr(0, prefix.size() - 1) + " bogie: ",
                    FormatNumber(1e3 * std::abs(bent)), FormatNumber(1e3 * std::abs(needed)),
                    FormatNumber(100 * bent / needed));
  }
  return text;
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
                  FormatNumber(std::abs(left)), left >= 0 ? "outer" : "inner") +
          PairWords(results.all),
      "The curve.");
  for (const BogieRun& run : results.runs) {
    if (!run.label.starts_with("PHS")) continue;
    page->Paragraph(
        "Passive hydraulic steering: four cylinders between axle boxes and frame, linked by four "
        "lines (L1 and L4 across the bogie at each axle, L2 and L3 diagonally), in place of rigid "
        "links.",
        "PHS.");
    break;
  }
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
                  ? fmt::format(" a flange or its root carries {} kN ({}).",
                                FormatNumber(1e-3 * flange.value), WheelName(results, flange.name))
                  : " no flange carries anything.";
    }
    text += RadialWords(results, run);
    page->Paragraph(text, "Wheels of the " + run.label + " bogie.");
  }
}

}  // namespace phs::report
