#include "example_results.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "base/check.h"
#include "base/hdf5_series.h"
#include "base/result_dir.h"

namespace phs::report::testing {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kRadius = 550;
constexpr double kWheelbase = 3.1;
constexpr double kSpeed = 16.7;
constexpr double kLoad = 127.5e3;
// Tangent, transition, arc, transition, tangent: their ends [m].
constexpr double kEnds[] = {100, 180, 480, 560, 700};

double Curvature(double s, int hand) {
  const double full = hand / kRadius;
  if (s <= kEnds[0] || s >= kEnds[3]) return 0;
  if (s < kEnds[1]) return full * (s - kEnds[0]) / (kEnds[1] - kEnds[0]);
  if (s > kEnds[2]) return full * (kEnds[3] - s) / (kEnds[3] - kEnds[2]);
  return full;
}

/// How stiff the axles stand in the frame: 0 = each turns as it likes, 1 = not at all.
double Stiffness(const std::string& bogie) {
  if (bogie == "phs") return 0.3;
  return bogie == "rigid_link" ? 1.0 : 0.6;
}

/// One row under construction: values by name, in the order in which they are named first.
class Row {
 public:
  void Set(const std::string& name, const std::string& unit, double value) {
    if (known_.emplace(name, channels.size()).second) {
      channels.push_back({name, unit, "example"});
      values.push_back(value);
    } else {
      values[known_[name]] = value;
    }
  }
  std::vector<Channel> channels;
  std::vector<double> values;

 private:
  std::map<std::string, std::size_t> known_;
};

void SetWheel(const std::string& wheel, double outward, double load, double attack, double k,
              Row* row) {
  row->Set(wheel + "_Y_N", "N", outward);
  row->Set(wheel + "_Q_N", "N", load);
  row->Set(wheel + "_Y_over_Q", "1", outward / load);
  row->Set(wheel + "_T_gamma_N", "N", 3 + 2.4e4 * std::abs(attack) + 8e3 * std::abs(k));
  row->Set(wheel + "_T_gamma_spin_N", "N", 1 + 2e3 * std::abs(attack));
  row->Set(wheel + "_contacts", "1", outward > 25e3 ? 2 : 1);
  row->Set(wheel + "_contact_angle_rad", "rad", 0.03 + 0.5 * (outward > 25e3));
  row->Set(wheel + "_contact_y_m", "m", 0.01);
  row->Set(wheel + "_flange_N", "N", std::max(0.0, outward - 20e3));
}

void SetAxle(const std::string& name, double s, double stiffness, int end, int hand, Row* row) {
  const double k = Curvature(s, hand);
  const double radial = end * k * kWheelbase / 2;  // turn in the frame that would be radial
  const double wave = hand * std::sin(2 * M_PI * s / 17) * std::exp(-std::abs(s - 190) / 60);
  const double yaw = (1 - stiffness) * radial + 2e-4 * wave;
  const double attack = yaw - radial - (end > 0 ? 2e-4 : 1e-4) * hand * (k != 0);
  const double lateral = -k * kRadius * (end > 0 ? 7.2e-3 : 2.1e-3) + 1.2e-3 * wave;
  row->Set(name + "_lateral_m", "m", lateral);
  row->Set(name + "_angle_of_attack_rad", "rad", attack);
  row->Set(name + "_yaw_rad", "rad", yaw);
  const double guiding = -attack * 7e6 * (1 + 0.06 * std::sin(0.9 * s));
  const double right = std::max(0.0, guiding) * 1.4 + 6e3;
  const double left = std::max(0.0, -guiding) * 1.4 + 6e3;
  row->Set(name + "_sum_Y_N", "N", right - left);
  const double creep = radial * 5.2e6 * (0.3 + 0.7 * stiffness);
  const double friction = stiffness < 0.5 ? -std::copysign(1.9e3, radial) * (radial != 0) : 0;
  const double pressure = stiffness < 0.5 ? -0.12 * creep : 0;
  row->Set(name + "_steering_moment_Nm", "N m", creep);
  row->Set(name + "_phs_friction_moment_Nm", "N m", friction);
  row->Set(name + "_phs_pressure_moment_Nm", "N m", pressure);
  row->Set(name + "_primary_moment_Nm", "N m", -creep - friction - pressure);
  const double heading = k * (s - kEnds[0]) / 2;
  row->Set(name + "_x_m", "m", s);
  row->Set(name + "_y_m", "m", lateral);
  row->Set(name + "_heading_rad", "rad", heading + attack);
  SetWheel(name + "_left", left, kLoad * (1 - 4 * k) + 1.5e3 * wave, attack, k, row);
  SetWheel(name + "_right", right, kLoad * (1 + 4 * k) - 1.5e3 * wave, attack, k, row);
}

void SetHydraulics(const std::string& prefix, double s, double stiffness, int hand, Row* row) {
  const double bend = (1 - stiffness) * Curvature(s - 1.5, hand) * kWheelbase;
  row->Set(prefix + "bending_rad", "rad", bend);
  row->Set(prefix + "shear_rad", "rad", 1e-5 * std::sin(s));
  if (stiffness > 0.5) return;
  const std::string system = prefix.empty() ? "" : prefix + "bogie_";
  for (int i = 1; i <= 4; ++i) {
    const int sign = i == 1 || i == 4 ? 1 : -1;
    const std::string cylinder = system + "cylinder_" + std::to_string(i);
    row->Set(cylinder + "_force_N", "N",
             sign * 1.2e3 * std::tanh(bend * 2e3) + 40 * std::sin(s + i));
    row->Set(cylinder + "_piston_m", "m", sign * 0.45 * bend);
    row->Set(cylinder + "_friction_N", "N", sign * 1.1e3 * std::tanh(bend * 2e3));
    row->Set(system + "line_L" + std::to_string(i) + "_pressure_Pa", "Pa",
             (i == 1 || i == 4 ? 2.0e6 : 1.8e6) + sign * 8e3 * std::tanh(bend * 2e3));
  }
}

void SetRow(const std::string& bogie, const ExampleOptions& options, double s, Row* row) {
  const double stiffness = Stiffness(bogie);
  row->Set("t_s", "s", s / kSpeed);
  row->Set("s_m", "m", s);
  row->Set("speed_m_s", "m/s", kSpeed);
  row->Set("curvature_1_m", "1/m", Curvature(s, options.hand));
  row->Set("cant_rad", "rad", 40 * Curvature(s, options.hand));
  const std::vector<std::pair<std::string, double>> bogies =
      options.locomotive
          ? std::vector<std::pair<std::string, double>>{{"front_", 0}, {"rear_", 9.3}}
          : std::vector<std::pair<std::string, double>>{{"", 0}};
  for (const auto& [prefix, back] : bogies) {
    SetAxle(prefix + "lead", s - back, stiffness, 1, options.hand, row);
    SetAxle(prefix + "trail", s - back - kWheelbase, stiffness, -1, options.hand, row);
    SetHydraulics(prefix, s - back, stiffness, options.hand, row);
  }
  row->Set("drive_torque_Nm", "N m", 900);
  const double way = s * (1 + stiffness);
  row->Set("energy_kinetic_J", "J", 8.4e6);
  row->Set("energy_stored_J", "J", 12 * stiffness);
  row->Set("work_in_J", "J", 170 * way);
  row->Set("lost_creep_J", "J", 160 * way);
  row->Set("lost_contact_J", "J", 3 * way);
  row->Set("lost_dampers_J", "J", 5 * way);
  row->Set("lost_phs_J", "J", 2 * way);
}

/// Means over the last third of the arc and peaks of a run made by the same laws.
Json Summary(const std::string& bogie, const ExampleOptions& options, bool derailed) {
  Row row;
  SetRow(bogie, options, 430, &row);
  const auto value = [&row](const std::string& name) {
    for (std::size_t i = 0; i < row.channels.size(); ++i) {
      if (row.channels[i].name == name) return row.values[i];
    }
    return std::nan("");
  };
  Json summary = {{"status", derailed ? "derailed" : "ok"},
                  {"reason", derailed ? "a wheel runs on the tip of its flange" : ""},
                  {"bogie", bogie},
                  {"real_time_factor", 31.4},
                  {"timestep_s", 0.001},
                  {"version", "0.1.0"}};
  Json& curve = summary["steady_curve"];
  const std::vector<std::string> prefixes = options.locomotive
                                                ? std::vector<std::string>{"front_", "rear_"}
                                                : std::vector<std::string>{""};
  for (const std::string& prefix : prefixes) {
    for (const char* axle : {"lead", "trail"}) {
      const std::string name = prefix + axle;
      curve["wheelsets"].push_back({{"name", name},
                                    {"lateral_m", value(name + "_lateral_m")},
                                    {"angle_of_attack_rad", value(name + "_angle_of_attack_rad")},
                                    {"yaw_rad", value(name + "_yaw_rad")},
                                    {"sum_Y_N", value(name + "_sum_Y_N")}});
      for (const bool outer : {true, false}) {
        const std::string wheel = name + ((options.hand > 0) == outer ? "_right" : "_left");
        curve["wheels"].push_back({{"name", name + (outer ? "_outer" : "_inner")},
                                   {"Y_N", value(wheel + "_Y_N")},
                                   {"Q_N", value(wheel + "_Q_N")},
                                   {"Y_over_Q", value(wheel + "_Y_over_Q")},
                                   {"T_gamma_N", value(wheel + "_T_gamma_N")},
                                   {"T_gamma_spin_N", value(wheel + "_T_gamma_spin_N")},
                                   {"contacts", value(wheel + "_contacts")}});
      }
      summary["budget"][name] = {{"creep_Nm", value(name + "_steering_moment_Nm")},
                                 {"phs_pressure_Nm", value(name + "_phs_pressure_moment_Nm")},
                                 {"phs_friction_Nm", value(name + "_phs_friction_moment_Nm")},
                                 {"primary_Nm", value(name + "_primary_moment_Nm")}};
    }
    curve[prefix + "bending_rad"] = value(prefix + "bending_rad");
    curve[prefix + "shear_rad"] = value(prefix + "shear_rad");
    const std::string system = prefix.empty() ? "" : prefix + "bogie_";
    for (int i = 1; i <= 4; ++i) {
      const std::string cylinder = system + "cylinder_" + std::to_string(i);
      if (std::isnan(value(cylinder + "_force_N"))) break;
      curve["cylinders"].push_back({{"name", system + std::to_string(i)},
                                    {"force_N", value(cylinder + "_force_N")},
                                    {"piston_m", value(cylinder + "_piston_m")}});
    }
  }
  const double attack = std::abs(curve["wheelsets"][0]["angle_of_attack_rad"].get<double>());
  summary["run"] = {{"T_gamma_total_J", 2.4e4 * attack * 4 * 500},
                    {"max_Y_over_Q", 9.5e6 * attack / kLoad + 0.1},
                    {"max_sum_Y_N", 8e6 * attack},
                    {"max_angle_of_attack_rad", 1.3 * attack},
                    {"energy_error_relative", 2e-4}};
  return summary;
}

Json TrackJson(int hand) {
  Json track = {{"name", "r550_example"}, {"length_m", kEnds[4]}, {"gauge_m", 1.067}};
  const char* kinds[] = {"tangent", "transition", "curve", "transition", "tangent"};
  for (int i = 0; i < 5; ++i) {
    track["sections"].push_back(
        {{"kind", kinds[i]},
         {"begin_s_m", i == 0 ? 0 : kEnds[i - 1]},
         {"end_s_m", kEnds[i]},
         {"radius_m", std::string(kinds[i]) == "curve" ? Json(hand * kRadius) : Json(nullptr)}});
  }
  Json& line = track["centre_line"];
  double x = 0;
  double y = 0;
  double heading = 0;
  for (double s = 0; s <= kEnds[4]; s += 1) {
    line["s_m"].push_back(s);
    line["x_m"].push_back(x);
    line["y_m"].push_back(y);
    line["curvature_1_m"].push_back(Curvature(s, hand));
    heading += Curvature(s + 0.5, hand);
    x += std::cos(heading);
    y += std::sin(heading);
  }
  return track;
}

void WriteSeries(const std::string& path, const std::string& bogie, const ExampleOptions& options,
                 double end) {
  Row row;
  SetRow(bogie, options, kWheelbase + 10, &row);
  auto writer = SeriesWriter::Create(path, row.channels);
  PHS_CHECK(writer.ok());
  // Each bogie's rows lie a little elsewhere, as in real runs.
  const double first = 13.4 + 0.01 * static_cast<double>(bogie.size());
  for (double s = first; s < end; s += options.interval_m) {
    SetRow(bogie, options, s, &row);
    PHS_CHECK(writer.value().Append(row.values.data()).ok());
  }
  PHS_CHECK(writer.value().Close().ok());
}

}  // namespace

void WriteExampleResults(const std::string& directory, const ExampleOptions& options) {
  Json compare;
  for (const std::string& bogie : options.bogies) {
    const bool derailed = options.derailed && bogie == options.bogies.back();
    compare["bogies"][bogie] = Summary(bogie, options, derailed);
    if (!options.series) continue;
    const std::string file = options.single ? "timeseries.h5" : bogie + "_timeseries.h5";
    WriteSeries(directory + "/" + file, bogie, options, derailed ? 350 : kEnds[4]);
    if (options.single) break;
  }
  Json shared = {{"scenario", {{"name", "example"}, {"speed_m_s", kSpeed}, {"friction", 0.4}}},
                 {"track", TrackJson(options.hand)}};
  Json file = options.single ? compare["bogies"][options.bogies.front()] : compare;
  file.update(shared);
  const std::string name = options.single ? "summary.json" : "compare.json";
  PHS_CHECK(WriteFileAtomically(directory + "/" + name, file.dump(1)).ok());
}

}  // namespace phs::report::testing
