// What the plugin reads from a model's <custom> section, and how the names are built.
//
//   <text name="phs_track" data="curve_r550"/>      track (models/tracks or a path)
//   <text name="phs_wheel" data="S1002"/>           wheel profile
//   <text name="phs_rail" data="UIC60"/>            rail profile
//   <text name="phs_creep" data="kalker_table"/>    creep law
//   <numeric name="phs_friction" data="0.3"/>       else the track's, else 0.3
//   <text name="phs_friction_condition" data="wet"/>  friction and creep slope by name, instead
//   <numeric name="phs_speed_m_s" data="20"/>       speed that the drives hold; 0 = no speed hold
//   <tuple name="wheelset:NAME">  body, spin joint, primary yaw joint, optional drive actuator
//   <tuple name="phs:NAME">       actuators: the cylinders in order, then carriers of extra states
//   <text  name="phs:NAME" data="bo_bo"/>           PHS model (models/phs or a path)
//   <tuple name="KIND:NAME">, <text name="KIND:NAME">  element, steering (active_steering.h)
#pragma once

#include <mujoco/mujoco.h>

#include <optional>
#include <string>
#include <vector>

namespace phs::plugin {

/// Text of a <custom><text>, or nothing.
std::optional<std::string> CustomText(const mjModel* m, const std::string& name);
/// First value of a <custom><numeric>, or nothing.
std::optional<double> CustomNumber(const mjModel* m, const std::string& name);

/// One object named in a tuple.
struct TupleElement {
  int type = 0;  ///< mjtObj
  int id = -1;
};
/// A <custom><tuple> whose name starts with a prefix; `name` is what follows the prefix.
struct NamedTuple {
  std::string name;
  std::vector<TupleElement> elements;
  /// Ids of the elements of one type, in order.
  std::vector<int> Ids(int type) const;
};
std::vector<NamedTuple> TuplesWithPrefix(const mjModel* m, const std::string& prefix);

/// Name of an object, "" if it has none.
std::string ObjectName(const mjModel* m, int type, int id);

}  // namespace phs::plugin
