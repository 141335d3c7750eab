#include "plugin/model_checks.h"

#include <algorithm>
#include <map>

#include "base/words.h"
#include "phs_model/phs_model.h"
#include "plugin/active_steering.h"
#include "plugin/elements.h"
#include "plugin/model_text.h"

namespace phs::plugin {
namespace {

using Names = std::vector<std::string>;

const Names& TextNames() {
  static const Names names = {"phs_track",     "phs_wheel",    "phs_rail",
                              "phs_creep",     "phs_contact",  "phs_friction_condition",
                              "phs_yardstick", "phs_car_body", "phs_vehicle"};
  return names;
}

const Names& NumberNames() {
  static const Names names = {"phs_friction",
                              "phs_speed_m_s",
                              "phs_wheel_radius_m",
                              "phs_flange_back_m",
                              "phs_box_lever_m",
                              "phs_linear_conicity",
                              "phs_linear_half_base_m",
                              "phs_linear_f11_N",
                              "phs_linear_f22_N",
                              "phs_linear_f23_Nm",
                              "phs_linear_f33_Nm2",
                              "phs_linear_limit_N",
                              "phs_linear_stiffness_N_per_m",
                              "phs_linear_damping_Ns_per_m",
                              "phs_linear_load_N",
                              "phs_linear_clearance_m",
                              "phs_linear_flange_N_per_m"};
  return names;
}

bool Contains(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// One `<text>` or `<numeric>`: of our names, of the other kind, or near one of ours.
Status CheckField(const std::string& element, const std::string& name, const Names& own,
                  const Names& other, const std::string& other_element) {
  if (!name.starts_with("phs") || name.find(':') != std::string::npos) return {};
  if (Contains(own, name)) return {};
  const std::string where = "MJCF " + element + " '" + name + "'";
  if (Contains(other, name)) {
    return Error{where, "is of the wrong kind", "<" + other_element + " name=\"" + name + "\" …/>",
                 ""};
  }
  Names known = own;
  known.insert(known.end(), other.begin(), other.end());
  return Error{where, "is no field that is read", JoinWords(known), DidYouMean(name, known)};
}

Status CheckFields(const mjModel* m) {
  for (int i = 0; i < m->ntext; ++i) {
    Status s =
        CheckField("text", ObjectName(m, mjOBJ_TEXT, i), TextNames(), NumberNames(), "numeric");
    if (!s.ok()) return s;
  }
  for (int i = 0; i < m->nnumeric; ++i) {
    Status s =
        CheckField("numeric", ObjectName(m, mjOBJ_NUMERIC, i), NumberNames(), TextNames(), "text");
    if (!s.ok()) return s;
  }
  return {};
}

/// `kind:NAME` of tuples and texts.
Status CheckKinds(const mjModel* m) {
  Names kinds = {"wheelset", "phs", "steering"};
  for (const ElementKind& kind : ElementKinds()) {
    if (!kind.keys.empty()) kinds.emplace_back(kind.name);
  }
  for (int i = 0; i < m->ntuple; ++i) {
    const std::string name = ObjectName(m, mjOBJ_TUPLE, i);
    const size_t colon = name.find(':');
    if (colon == std::string::npos) continue;
    const std::string kind = name.substr(0, colon);
    if (Contains(kinds, kind) || NearestWord(kind, kinds).empty()) continue;
    const std::string nearest = DidYouMean(kind, kinds);
    for (std::string& known : kinds) known += ":NAME";
    return Error{"MJCF tuple '" + name + "'", "is of no kind that is read", JoinWords(kinds),
                 nearest};
  }
  for (int i = 0; i < m->ntext; ++i) {
    const std::string name = ObjectName(m, mjOBJ_TEXT, i);
    if (!name.starts_with("phs:") || mj_name2id(m, mjOBJ_TUPLE, name.c_str()) >= 0) continue;
    Names known;
    for (const NamedTuple& tuple : TuplesWithPrefix(m, "phs:"))
      known.push_back("phs:" + tuple.name);
    return Error{"MJCF text '" + name + "'", "names the model of a PHS that is not there",
                 known.empty() ? "a tuple of the same name" : JoinWords(known),
                 DidYouMean(name, known)};
  }
  return {};
}

/// Notes who takes `id`; an error if somebody has it already.
Status Take(const mjModel* m, mjtObj type, int id, const std::string& owner, const char* as,
            std::map<int, std::string>* taken) {
  const auto [at, first] = taken->emplace(id, owner);
  if (first) return {};
  const std::string what = type == mjOBJ_BODY ? "body" : "actuator";
  const bool same = at->second == owner;
  return Error{"MJCF tuple '" + owner + "'",
               "names " + what + " '" + ObjectName(m, type, id) + "' " +
                   (same ? std::string("twice") : "as '" + at->second + "' does"),
               std::string("each ") + what + " as one " + as, ""};
}

Status CheckTwice(const mjModel* m) {
  std::map<int, std::string> bodies, actuators;
  for (const NamedTuple& tuple : TuplesWithPrefix(m, "wheelset:")) {
    for (const int body : tuple.Ids(mjOBJ_BODY)) {
      Status s = Take(m, mjOBJ_BODY, body, "wheelset:" + tuple.name, "wheelset", &bodies);
      if (!s.ok()) return s;
    }
  }
  for (const NamedTuple& tuple : TuplesWithPrefix(m, "phs:")) {
    for (const int actuator : tuple.Ids(mjOBJ_ACTUATOR)) {
      Status s =
          Take(m, mjOBJ_ACTUATOR, actuator, "phs:" + tuple.name, "cylinder or state", &actuators);
      if (!s.ok()) return s;
    }
  }
  return {};
}

Status CheckSpeed(const mjModel* m, const AttachOptions& options) {
  const bool asked = options.speed_m_s != AttachOptions::kUnset;
  const double speed = asked ? options.speed_m_s : CustomNumber(m, "phs_speed_m_s").value_or(0);
  if (speed >= 0) return {};
  return Error{asked ? "speed_m_s" : "MJCF numeric 'phs_speed_m_s'",
               "is " + std::to_string(speed) + " m/s", "0 or more: a vehicle runs forward",
               "turn the track (NAME_right, mirror_of) or the vehicle"};
}

Status CheckFailures(const mjModel* m, const AttachOptions& options) {
  Names known;
  for (const NamedTuple& tuple : TuplesWithPrefix(m, "phs:")) known.push_back(tuple.name);
  for (const phs_model::Failure& failure : options.phs_changes.failures) {
    if (failure.system.empty() || Contains(known, failure.system)) continue;
    return Error{"failures: system " + Quoted(failure.system), "is no PHS of this vehicle",
                 known.empty() ? "none: it has no PHS" : JoinWords(known),
                 DidYouMean(failure.system, known)};
  }
  return {};
}

Status CheckKey(const mjModel* m) {
  if (TuplesWithPrefix(m, "wheelset:").empty()) return {};
  if (mj_name2id(m, mjOBJ_KEY, "test") >= 0) return {};
  return Error{"MJCF key 'test'", "is missing: the settled, rolling start is kept in it",
               "<keyframe><key name=\"test\"/></keyframe>", "phs adds it by itself"};
}

/// A bogie that is linked to the car body steers under a whole one alone: half a body on one bogie
/// has no yaw of its own.
Status CheckVehicle(const mjModel* m) {
  const auto vehicle = CustomText(m, "phs_vehicle");
  if (!vehicle) return {};
  const std::string where = "MJCF text 'phs_vehicle'";
  if (*vehicle != "locomotive") return Error{where, "is " + Quoted(*vehicle), "locomotive", ""};
  if (mj_name2id(m, mjOBJ_BODY, "front_frame") >= 0) return {};
  return Error{where, "asks for a locomotive: this bogie is steered by its car body",
               "two bogies under a body", "vehicle: locomotive in the scenario"};
}

}  // namespace

Status CheckModel(const mjModel* m, const AttachOptions& options) {
  for (const Status& s :
       {CheckFields(m), CheckKinds(m), CheckTwice(m), CheckSpeed(m, options),
        CheckFailures(m, options), CheckKey(m), CheckVehicle(m), CheckActiveSteering(m)}) {
    if (!s.ok()) return s;
  }
  return {};
}

bool IsCylinder(const mjModel* m, int actuator) {
  if (m->actuator_biastype[actuator] != mjBIAS_USER) return false;
  const int on = m->actuator_trntype[actuator];
  return on == mjTRN_TENDON ||
         (on == mjTRN_JOINT && m->jnt_type[m->actuator_trnid[2 * actuator]] == mjJNT_SLIDE);
}

}  // namespace phs::plugin
