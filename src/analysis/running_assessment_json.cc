#include "analysis/running_assessment_json.h"

#include "base/json_path.h"
#include "rail/wear.h"

namespace phs::analysis {
namespace {

using Json = nlohmann::ordered_json;

Json RideJson(const AccelerationStatistics& ride) {
  return {{"low_m_s2", ride.low}, {"high_m_s2", ride.high}, {"rms_m_s2", ride.rms}};
}

Json SectionJson(const AssessedSection& section) {
  Json out = {{"kind", section.kind},
              {"begin_s_m", section.begin_s_m},
              {"end_s_m", section.end_s_m},
              {"radius_m", section.kind == "curve" ? Json(section.radius_m) : Json(nullptr)},
              {"wheelsets", Json::array()}};
  for (const AssessedWheelset& wheelset : section.wheelsets) {
    Json own = {{"name", wheelset.name}};
    for (const AssessedQuantity& q : wheelset.quantities) {
      own[q.name] = {{"value", q.value}, {"limit", q.limit}, {"kept", q.kept()}};
    }
    if (wheelset.hunting_Hz > 0) own["hunting_Hz"] = wheelset.hunting_Hz;
    out["wheelsets"].push_back(std::move(own));
  }
  Json& ride = out["ride"];
  if (section.ride_lateral) ride["lateral"] = RideJson(*section.ride_lateral);
  if (section.ride_vertical) ride["vertical"] = RideJson(*section.ride_vertical);
  return out;
}

Json WheelJson(const AssessedWheel& wheel) {
  Json out = {{"name", wheel.name},
              {"worn_area_mm2_per_km", NumberOrNull(wheel.worn_area_mm2_per_km)}};
  const double mean = wheel.steady_T_gamma_N;
  if (!std::isfinite(mean)) return out;
  out["steady_T_gamma_N"] = mean;
  out["steady_wear_regime"] = rail::NameOf(rail::WearRegimeOf(mean));
  out["steady_rcf_damage_per_pass"] = rail::CalcRcfDamage(mean, false);
  out["steady_rcf_net_of_wear_per_pass"] = rail::CalcRcfDamage(mean, true);
  return out;
}

}  // namespace

Json AssessmentJson(const Assessment& a) {
  if (!a.assessed()) return {{"status", "not assessed"}, {"reason", a.reason}};
  Json out = {{"status", "ok"},
              {"processing", "EN 14363, UIC 518: one run, sections as simulated"},
              {"limits_made_for", {{"gauge_m", 1.435}, {"axle_load_t", 22.5}}},
              {"limits_are_orientation", a.limits_are_orientation},
              {"gauge_m", a.gauge_m},
              {"static_wheel_load_N", a.static_wheel_load_N},
              {"nadal_Y_over_Q", NumberOrNull(a.nadal_Y_over_Q)},
              {"worst", Json::object()},
              {"sections", Json::array()},
              {"wheels", Json::array()}};
  for (const WorstQuantity& worst : a.worst) {
    const AssessedQuantity& q = worst.quantity;
    out["worst"][q.name] = {
        {"value", q.value},           {"limit", q.limit},
        {"share", worst.Share()},     {"kept", q.kept()},
        {"wheelset", worst.wheelset}, {"section_begin_s_m", worst.section_begin_s_m}};
  }
  for (const AssessedSection& section : a.sections) {
    out["sections"].push_back(SectionJson(section));
  }
  for (const AssessedWheel& wheel : a.wheels) out["wheels"].push_back(WheelJson(wheel));
  return out;
}

}  // namespace phs::analysis
