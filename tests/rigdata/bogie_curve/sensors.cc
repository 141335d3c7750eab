#include "sensors.h"

#include <cmath>
#include <cstdio>
#include <functional>
#include <stdexcept>

#include "../random_source.h"

namespace bogie_curve {
namespace {

struct Instrument {
  const char* column;
  double noise, quantum;  // standard deviation; step of the converter
  std::function<double(const BogieReading&)> value;
};

// Draw-wire sensors at the pistons, strain gauges at the eyes, pressure cells, lasers against the
// rails; a measuring wheelset in front.
const std::vector<Instrument>& Instruments() {
  using R = BogieReading;
  static const std::vector<Instrument> list = {
      {"s_m", 0.02, 1e-3, [](const R& r) { return r.lead_s; }},
      {"piston1_m", 2e-5, 1e-6, [](const R& r) { return r.piston[0]; }},
      {"piston2_m", 2e-5, 1e-6, [](const R& r) { return r.piston[1]; }},
      {"piston3_m", 2e-5, 1e-6, [](const R& r) { return r.piston[2]; }},
      {"piston4_m", 2e-5, 1e-6, [](const R& r) { return r.piston[3]; }},
      {"load1_N", 100, 10, [](const R& r) { return r.tension[0]; }},
      {"load2_N", 100, 10, [](const R& r) { return r.tension[1]; }},
      {"load3_N", 100, 10, [](const R& r) { return r.tension[2]; }},
      {"load4_N", 100, 10, [](const R& r) { return r.tension[3]; }},
      {"pL1_Pa", 1e4, 1e3, [](const R& r) { return r.pressure[0]; }},
      {"pL2_Pa", 1e4, 1e3, [](const R& r) { return r.pressure[1]; }},
      {"pL3_Pa", 1e4, 1e3, [](const R& r) { return r.pressure[2]; }},
      {"pL4_Pa", 1e4, 1e3, [](const R& r) { return r.pressure[3]; }},
      {"lead_lateral_m", 2e-4, 1e-5, [](const R& r) { return r.lateral[0]; }},
      {"trail_lateral_m", 2e-4, 1e-5, [](const R& r) { return r.lateral[1]; }},
      {"lead_angle_of_attack_rad", 1e-4, 1e-5, [](const R& r) { return r.angle_of_attack[0]; }},
      {"trail_angle_of_attack_rad", 1e-4, 1e-5, [](const R& r) { return r.angle_of_attack[1]; }},
      {"lead_left_Y_N", 500, 50, [](const R& r) { return r.Y[0][0]; }},
      {"lead_right_Y_N", 500, 50, [](const R& r) { return r.Y[0][1]; }},
      {"lead_left_Q_N", 800, 50, [](const R& r) { return r.Q[0][0]; }},
      {"lead_right_Q_N", 800, 50, [](const R& r) { return r.Q[0][1]; }},
  };
  return list;
}

}  // namespace

MeasuredRun Measure(const BogieMotion& bogie, const RunWish& wish) {
  const std::vector<Instrument>& list = Instruments();
  MeasuredRun run;
  run.names.push_back("t_s"), run.quantum.push_back(1e-6), run.columns.emplace_back();
  for (const Instrument& i : list) {
    run.names.push_back(i.column), run.quantum.push_back(i.quantum), run.columns.emplace_back();
  }
  const int each = static_cast<int>(std::lround(wish.interval / wish.step));
  MotionState state = bogie.Start();
  const double keep = std::exp(-wish.step / wish.loosens_in);
  double s = bogie.Read(state).lead_s;
  while (s < wish.first_s) {
    // Before the measured place the lines are tight, and the track shakes the seals loose, little
    // by little: without any hold an uneven bogie hunts, and the seals would keep what they catch.
    state.leaking = s >= wish.loose_until_s;
    bogie.Step(wish.step, &state);
    for (double& bristle : state.bristle) bristle *= state.leaking ? 1 : keep;
    s = bogie.Read(state).lead_s;
  }
  for (int row = 0; s < wish.last_s; ++row) {
    std::vector<double> sum(list.size(), 0.0);
    for (int k = 0; k < each; ++k) {
      bogie.Step(wish.step, &state);
      const BogieReading reading = bogie.Read(state);
      s = reading.lead_s;
      for (size_t i = 0; i < list.size(); ++i) sum[i] += list[i].value(reading) / each;
    }
    if (!std::isfinite(s)) throw std::runtime_error("the run diverges: take a smaller step");
    run.columns[0].push_back(row * wish.interval);
    for (size_t i = 0; i < list.size(); ++i) run.columns[i + 1].push_back(sum[i]);
  }
  return run;
}

void AddInstruments(uint64_t seed, MeasuredRun* run) {
  const std::vector<Instrument>& list = Instruments();
  for (size_t i = 0; i < list.size(); ++i) {
    rigdata::RandomSource random(seed, list[i].column);
    for (double& y : run->columns[i + 1]) y += list[i].noise * random.Normal();
  }
}

std::string Csv(const MeasuredRun& run) {
  std::string text;
  for (size_t i = 0; i < run.names.size(); ++i) text += (i > 0 ? "," : "") + run.names[i];
  text += '\n';
  char cell[40];
  for (size_t row = 0; row < run.columns[0].size(); ++row) {
    for (size_t i = 0; i < run.columns.size(); ++i) {
      const double steps = std::round(run.columns[i][row] / run.quantum[i]) + 0.0;
      // Whole steps, written with just their digits.
      const int digits =
          static_cast<int>(std::max(0.0, std::ceil(-std::log10(run.quantum[i]) - 1e-9)));
      std::snprintf(cell, sizeof cell, "%s%.*f", i > 0 ? "," : "", digits, steps * run.quantum[i]);
      text += cell;
    }
    text += '\n';
  }
  return text;
}

}  // namespace bogie_curve
