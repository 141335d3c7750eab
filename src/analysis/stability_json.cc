#include "analysis/stability_json.h"

#include <cmath>
#include <numbers>

#include "base/json_path.h"

namespace phs::analysis {
namespace {

using Json = nlohmann::ordered_json;

Json Polar(const std::complex<double>& z, const char* unit) {
  // The phase of what hardly moves is noise.
  const double amplitude = std::abs(z) < 1e-6 ? 0 : std::abs(z);
  return {{std::string("amplitude_") + unit, amplitude},
          {"phase_rad", amplitude == 0 ? 0 : std::arg(z)}};
}

Json BodyJson(const vehicle::Simulation& simulation, const BodyMotion& motion, int body) {
  const mjModel* m = simulation.model();
  bool wheelset = false;
  for (const auto& w : simulation.binding().wheelsets()) wheelset = wheelset || w.body == body;
  double place[3] = {0, 0, 0};  // at rest, from the chain of body offsets
  for (int b = body; b > 0; b = m->body_parentid[b]) {
    for (int i = 0; i < 3; ++i) place[i] += m->body_pos[3 * b + i];
  }
  Json json = {{"name", motion.body}, {"wheelset", wheelset}, {"x_m", place[0]}, {"z_m", place[2]}};
  json["longitudinal"] = Polar(motion.translation[0], "m");
  json["lateral"] = Polar(motion.translation[1], "m");
  json["vertical"] = Polar(motion.translation[2], "m");
  json["roll"] = Polar(motion.rotation[0], "rad");
  json["pitch"] = wheelset ? Polar(0, "rad") : Polar(motion.rotation[1], "rad");
  json["yaw"] = Polar(motion.rotation[2], "rad");
  return json;
}

Json ModeJson(const vehicle::Simulation& simulation, const VibrationMode& mode) {
  const double frequency = std::abs(mode.eigenvalue.imag()) / (2 * std::numbers::pi);
  Json json = {{"speed_m_s", mode.speed},
               {"real_1_s", mode.eigenvalue.real()},
               {"imag_rad_s", std::abs(mode.eigenvalue.imag())},
               {"frequency_Hz", frequency},
               {"damping_ratio", -mode.eigenvalue.real() / std::abs(mode.eigenvalue)},
               {"wavelength_m", NumberOrNull(mode.speed / frequency)},
               {"bodies", Json::array()}};
  for (size_t i = 0; i < mode.motion.size(); ++i) {
    json["bodies"].push_back(BodyJson(simulation, mode.motion[i], static_cast<int>(i) + 1));
  }
  return json;
}

Json RampJson(const std::vector<RampPoint>& ramp) {
  Json json = Json::array();
  for (const RampPoint& p : ramp) {
    json.push_back({{"speed_m_s", p.speed}, {"amplitude_m", p.amplitude}});
  }
  return json;
}

}  // namespace

Json StabilityJson(const vehicle::Simulation& simulation, const StabilityResult& result) {
  Json json;
  json["bogie"] = simulation.scenario().bogie;
  json["vehicle"] = simulation.scenario().vehicle;
  json["friction"] = simulation.binding().friction();
  json["critical_speed_m_s"] = NumberOrNull(result.critical_speed);
  json["crossings"] = Json::array();
  for (const Crossing& c : result.crossings) {
    json["crossings"].push_back({{"speed_m_s", c.speed}, {"to_unstable", c.to_unstable}});
  }
  json["unstable_at_least_speed"] = !result.spectra.empty() && result.spectra[0].growth > 0;
  json["critical_mode"] = ModeJson(simulation, result.mode);
  json["eigenvalues"] = Json::array();
  for (const SpeedSpectrum& s : result.spectra) {
    for (const std::complex<double>& value : s.eigenvalues) {
      json["eigenvalues"].push_back(
          {{"speed_m_s", s.speed}, {"real_1_s", value.real()}, {"imag_rad_s", value.imag()}});
    }
  }
  return json;
}

Json LimitCycleJson(const LimitCycle& cycle, const LimitCycleOptions& options) {
  return {{"nonlinear_critical_speed_m_s", NumberOrNull(cycle.critical_speed)},
          {"resolution_m_s", options.resolution_m_s},
          {"amplitude_m", cycle.amplitude},
          {"derailed", cycle.derailed},
          {"ramp_rate_m_s2", options.rate_m_s2},
          {"down", RampJson(cycle.down)},
          {"up", RampJson(cycle.up)}};
}

}  // namespace phs::analysis
