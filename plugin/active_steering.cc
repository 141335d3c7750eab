#include "plugin/active_steering.h"

#include <algorithm>

#include "plugin/guest.h"
#include "plugin/model_text.h"

namespace phs::plugin {
namespace {

constexpr double kLeastSpeed = 1;  ///< below it curvature cannot be told [m/s]

}  // namespace

ActiveSteering SteeringOf(const mjModel* m, int actuator) noexcept {
  const int joint = m->actuator_trnid[2 * actuator], body = m->jnt_bodyid[joint];
  return {actuator, m->body_parentid[body], m->body_pos[3 * body] + m->jnt_pos[3 * joint]};
}

Status CheckActiveSteering(const mjModel* m) {
  for (const NamedTuple& tuple : TuplesWithPrefix(m, kSteeringTuple)) {
    const std::string where = "MJCF tuple '" + (kSteeringTuple + tuple.name) + "'";
    const std::vector<int> actuators = tuple.Ids(mjOBJ_ACTUATOR);
    if (actuators.size() != 1 || tuple.elements.size() != 1) {
      return Error{where, "does not name one actuator",
                   "<element objtype=\"actuator\" objname=\"…\"/>", ""};
    }
    const int id = actuators[0], joint = m->actuator_trnid[2 * id];
    if (m->actuator_trntype[id] != mjTRN_JOINT || m->jnt_type[joint] != mjJNT_HINGE ||
        m->actuator_dyntype[id] != mjDYN_FILTER) {
      return Error{where, "names an actuator that steers no axle",
                   "<general dyntype=\"filter\" joint=\"…\"/> on the yaw hinge of an axle",
                   "see bogie_xml/active_steering.xml"};
    }
  }
  return {};
}

double CalcSteeringDemand(const mjModel* m, const mjData* d, const ActiveSteering& s) noexcept {
  mjtNum velocity[6];  // rotation, translation in the frame's own axes
  mj_objectVelocity(m, d, mjOBJ_XBODY, s.frame, velocity, 1);
  return s.ahead * velocity[2] / std::max(velocity[3], kLeastSpeed);
}

void ControlSteering(const mjModel* m, mjData* d) noexcept {
  ForEachSteering(m, [&](const ActiveSteering& s) {
    if (!Guest::Has(d, s.actuator)) d->ctrl[s.actuator] = CalcSteeringDemand(m, d, s);
  });
}

void SettleSteering(const mjModel* m, mjData* d) noexcept {
  ForEachSteering(m, [&](const ActiveSteering& s) {
    d->act[s.actuator - (m->nu - m->na)] = CalcSteeringDemand(m, d, s);
  });
}

}  // namespace phs::plugin
