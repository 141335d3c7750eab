// Measurements of a bogie in a curve for the tests and examples of `rig: bogie`.
//
// The vehicle is simulated by the product, so this is no independent truth; what would make it too
// easy is taken away: another creep law (Kalker's simplified theory strip by strip instead of the
// table), half the step, irregular rails, springs and hydraulics off the declared ones, samples
// averaged over their interval, noise, quantisation, an odometer that errs.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "base/table.h"
#include "tests/rigdata/random_source.h"
#include "vehicle/simulation.h"

namespace phs::identify {

struct BogieSensor {
  std::string column;   ///< as in the data file
  std::string channel;  ///< of a run
  double noise;         ///< standard deviation, unit of the channel
  double quantum;       ///< step of the converter
};

/// Cylinders and lines as on the rigs, and what a measuring wheelset in the leading axle gives.
inline std::vector<BogieSensor> BogieSensors(bool measuring_wheelset) {
  std::vector<BogieSensor> sensors;
  for (const char* id : {"1", "2", "3", "4"}) {
    const std::string name = id;
    sensors.push_back({"piston" + name + "_m", "cylinder_" + name + "_piston_m", 5e-6, 1e-6});
    sensors.push_back({"load" + name + "_N", "cylinder_" + name + "_force_N", 60, 10});
    sensors.push_back({"pL" + name + "_Pa", "line_L" + name + "_pressure_Pa", 5e3, 1e3});
  }
  if (measuring_wheelset) {
    for (const char* side : {"left", "right"}) {
      const std::string wheel = std::string("lead_") + side;
      sensors.push_back({wheel + "_Y_N", wheel + "_Y_N", 300, 50});
      sensors.push_back({wheel + "_Q_N", wheel + "_Q_N", 400, 50});
    }
    for (const char* axle : {"lead", "trail"}) {
      const std::string name = axle;
      sensors.push_back({name + "_lateral_m", name + "_lateral_m", 1e-4, 2e-5});
      sensors.push_back({name + "_angle_of_attack_rad", name + "_angle_of_attack_rad", 3e-5, 1e-5});
    }
  }
  return sensors;
}

/// Runs `truth` and writes what the sensors show to `path`. False: the run failed.
inline bool MeasureBogie(vehicle::Scenario truth, const std::vector<BogieSensor>& sensors,
                         double step_s, unsigned long seed, const std::string& path) {
  truth.record_interval_s = truth.timestep_s;
  auto simulation = vehicle::Simulation::Create(truth);
  if (!simulation.ok()) return false;
  auto done = simulation.value().Run();
  if (!done.ok() || done.value().status != "ok") return false;
  const vehicle::RunOutcome& run = done.value();
  const auto each = static_cast<size_t>(std::lround(step_s / truth.timestep_s));
  const size_t rows = run.columns[0].size() / each;
  std::vector<std::string> names = {"t_s", "s_m", "speed_m_s"};
  std::vector<std::vector<double>> columns(3);
  const auto mean = [&](const std::string& channel, size_t row) {
    const auto& y = run.columns[static_cast<size_t>(run.Find(channel))];
    double sum = 0;
    for (size_t i = 0; i < each; ++i) sum += y[row * each + i];
    return sum / static_cast<double>(each);
  };
  rigdata::RandomSource odometer(seed, "odometer");
  for (size_t k = 0; k < rows; ++k) {
    columns[0].push_back(std::round(1e6 * static_cast<double>(k) * step_s) / 1e6);
    columns[1].push_back(std::round(1e3 * (mean("s_m", k) + 0.02 * odometer.Normal())) / 1e3);
    columns[2].push_back(std::round(1e3 * (mean("speed_m_s", k) + 0.02 * odometer.Normal())) / 1e3);
  }
  for (const BogieSensor& sensor : sensors) {
    rigdata::RandomSource random(seed, sensor.column);
    names.push_back(sensor.column), columns.emplace_back();
    for (size_t k = 0; k < rows; ++k) {
      const double shown = mean(sensor.channel, k) + sensor.noise * random.Normal();
      const double steps = std::round(shown / sensor.quantum);  // short decimals in the file
      columns.back().push_back(sensor.quantum < 1 ? steps / std::round(1 / sensor.quantum)
                                                  : steps * sensor.quantum);
    }
  }
  return WriteCsv(path, names, columns).ok();
}

}  // namespace phs::identify
