#include "analysis/axle_modes_json.h"

#include <utility>

namespace phs::analysis {
namespace {

using Json = nlohmann::ordered_json;

const char* StiffnessKey(const AxleMode& mode) {
  return mode.rotation ? "stiffness_Nm_per_rad" : "stiffness_N_per_m";
}

Json AxleModeJson(const AxleMode& mode, const BogiePlan& plan) {
  Json json;
  json[StiffnessKey(mode)] = mode.stiffness;
  json[mode.rotation ? "damping_Nms_per_rad" : "damping_Ns_per_m"] = mode.damping;
  json[mode.rotation ? "amplitude_rad" : "amplitude_m"] = mode.amplitude;
  json["loss_per_cycle_J"] = mode.loss_per_cycle;
  Json at_most = Json::object();
  for (size_t i = 0; i < mode.cylinder_force_N.size() && i < plan.cylinders.size(); ++i) {
    at_most["cylinders"].push_back({{"name", plan.cylinders[i].name},
                                    {"stroke_m", mode.cylinder_stroke_m[i]},
                                    {"force_N", mode.cylinder_force_N[i]}});
  }
  for (size_t i = 0; i < mode.line_pressure_Pa.size(); ++i) {
    at_most["lines"].push_back(
        {{"name", plan.lines[i]}, {"pressure_Pa", mode.line_pressure_Pa[i]}});
  }
  json["at_greatest_displacement"] = std::move(at_most);
  json["loop"] = {{mode.rotation ? "displacement_rad" : "displacement_m", mode.loop_displacement},
                  {mode.rotation ? "moment_Nm" : "force_N", mode.loop_force}};
  return json;
}

Json ClosedFormJson(const AxleMode& mode) {
  const ModeClosedForm& form = mode.closed_form;
  return {{StiffnessKey(mode), form.total()},
          {"springs", form.springs},
          {"seals", form.seals},
          {"lines", form.lines}};
}

Json PlanJson(const BogiePlan& plan) {
  Json json = {{"axles", Json::array()}, {"cylinders", Json::array()}};
  for (const auto& axle : plan.axles) {
    json["axles"].push_back({{"name", axle.name}, {"x_m", axle.x}});
  }
  for (const auto& cylinder : plan.cylinders) {
    json["cylinders"].push_back({{"name", cylinder.name},
                                 {"from_m", {cylinder.from[0], cylinder.from[1]}},
                                 {"to_m", {cylinder.to[0], cylinder.to[1]}}});
  }
  return json;
}

}  // namespace

Json AxleModesJson(const std::string& bogie, const AxleModes& modes,
                   const AxleModeOptions& options) {
  Json json;
  for (size_t i = 0; i < modes.large.size(); ++i) {
    Json& mode = json[modes.large[i].name] = AxleModeJson(modes.large[i], modes.plan);
    mode["small_amplitude"] = AxleModeJson(modes.small[i], modes.plan);
    mode["closed_form"] = ClosedFormJson(modes.small[i]);
  }
  json["bogie"] = bogie;
  json["frequency_Hz"] = options.frequency_Hz;
  json["lever_m"] = modes.lever_m;
  json["plan"] = PlanJson(modes.plan);
  return json;
}

}  // namespace phs::analysis
