// What a run was given, as it stands in its results: scenario and track.
#include "phs_model/phs_model.h"
#include "vehicle/summary.h"

namespace phs::vehicle {

using Json = nlohmann::ordered_json;

namespace {

Json DescribeFailures(const std::vector<phs_model::Failure>& failures) {
  Json list = Json::array();
  for (const phs_model::Failure& f : failures) {
    Json one = {{"kind", f.kind}, {"line", f.line}};
    if (!f.system.empty()) one["system"] = f.system;
    if (phs_model::HasTime(f)) one["at_s"] = f.at_s;
    if (f.kind == "line_leak") one["conductance_m3_per_Pas"] = f.conductance_m3_per_Pas;
    if (f.kind == "air") one["air_m3"] = f.air_m3;
    list.push_back(std::move(one));
  }
  return list;
}

}  // namespace

Json DescribeScenario(const Scenario& s) {
  const auto number_or_null = [](double x) { return x < 0 ? Json(nullptr) : Json(x); };
  Json described = {{"name", s.name},
                    {"track", s.track},
                    {"vehicle", s.vehicle},
                    {"wheel", s.wheel},
                    {"rail", s.rail},
                    {"creep", s.creep},
                    {"contact_fineness", s.contact_fineness},
                    {"phs", s.phs},
                    {"speed_m_s", s.speed_m_s},
                    {"friction", number_or_null(s.friction.tread)},
                    {"flange_friction", number_or_null(s.friction.flange)},
                    {"friction_condition", s.friction.condition},
                    {"falling_ratio", number_or_null(s.friction.falling_ratio)},
                    {"falling_rate_s_m", number_or_null(s.friction.falling_rate_s_m)},
                    {"timestep_s", s.timestep_s > 0 ? Json(s.timestep_s) : Json(nullptr)},
                    {"record_interval_s", s.record_interval_s}};
  if (s.running.active) {
    described["running"] = {{"drive_torque_Nm", s.running.drive_torque_Nm},
                            {"block_force_N", s.running.block_force_N},
                            {"block_friction", s.running.block_friction},
                            {"begin_s", s.running.begin_s},
                            {"ramp_s", s.running.ramp_s}};
    if (s.running.end_s > 0) described["running"]["end_s"] = s.running.end_s;
  }
  if (!s.phs_changes.failures.empty()) {
    described["failures"] = DescribeFailures(s.phs_changes.failures);
  }
  if (!s.phs_changes.parameters.empty()) {
    described["phs_parameters"] = s.phs_changes.parameters;
  }
  for (const hydraulics::EffectParams& effect : s.effects) {
    Json& own = described["effects"][effect.name] = Json::object();
    if (!effect.targets.empty()) own["targets"] = effect.targets;
    if (!effect.formula.empty()) own["formula"] = effect.formula;
    for (const auto& [key, value] : effect.values) own[key] = value;
  }
  for (const Scenario::JointChange& change : s.joints) {
    Json& joint = described["joints"][change.joint];
    if (change.stiffness >= 0) joint["stiffness"] = change.stiffness;
    if (change.damping >= 0) joint["damping"] = change.damping;
  }
  return described;
}

Json DescribeTrack(const rail::Track& track) {
  Json sections = Json::array();
  for (const rail::TrackSection& section : track.sections()) {
    sections.push_back(
        {{"kind", section.kind},
         {"begin_s_m", section.begin_s},
         {"end_s_m", section.end_s},
         {"radius_m", section.curvature == 0 ? Json(nullptr) : Json(1 / section.curvature)}});
  }
  Json line = {{"s_m", Json::array()},
               {"x_m", Json::array()},
               {"y_m", Json::array()},
               {"curvature_1_m", Json::array()},
               {"cant_rad", Json::array()}};
  const int count = 400;
  for (int i = 0; i <= count; ++i) {
    const rail::TrackFrame f = track.FrameAt(track.length() * i / count);
    line["s_m"].push_back(f.s);
    line["x_m"].push_back(f.origin[0]);
    line["y_m"].push_back(f.origin[1]);
    line["curvature_1_m"].push_back(f.curvature);
    line["cant_rad"].push_back(f.cant);
  }
  return {{"name", track.name()},
          {"length_m", track.length()},
          {"gauge_m", track.gauge()},
          {"sections", sections},
          {"centre_line", line}};
}

}  // namespace phs::vehicle
