#include "vehicle/bogie_import.h"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <set>

#include "base/words.h"

namespace phs::vehicle {
namespace {

using tinyxml2::XMLElement;

/// Shortest text that reads back to the same number.
std::string Text(double value) { return fmt::format("{}", value); }

template <typename Values>
std::string Texts(const Values& values) {
  std::string text;
  for (const double v : values) text += (text.empty() ? "" : " ") + Text(v);
  return text;
}

void Set(XMLElement* element, const char* name, const std::string& value) {
  element->SetAttribute(name, value.c_str());
}

class Writer {
 public:
  Writer(const UrdfModel& urdf, const BogieMapping& mapping) : urdf_(urdf), map_(mapping) {}

  Result<std::string> Write() {
    if (Status s = Check(); !s.ok()) return s.error();
    XMLElement* root = document_.NewElement("mujoco");
    document_.InsertFirstChild(root);
    Set(root, "model", map_.name);
    AddNote(root);
    AddSettings(root);
    XMLElement* world = root->InsertNewChildElement("worldbody");
    if (Status s = AddBody(*urdf_.Find(map_.frame), world); !s.ok()) return s.error();
    AddCylinders(root);
    AddCustom(root);
    AddActuators(root);
    XMLElement* key = root->InsertNewChildElement("keyframe")->InsertNewChildElement("key");
    Set(key, "name", "test");
    tinyxml2::XMLPrinter printer;
    document_.Print(&printer);
    return std::string(printer.CStr());
  }

 private:
  Error AtLink(const std::string& link, const std::string& what, const std::string& allowed,
               const std::string& mend = "") const {
    return {urdf_.path + ": link '" + link + "'", what, allowed, mend};
  }

  Result<const UrdfLink*> Link(const std::string& name, const std::string& used_as) const {
    if (const UrdfLink* link = urdf_.Find(name)) return link;
    std::vector<std::string> known;
    for (const UrdfLink& l : urdf_.links) known.push_back(l.name);
    return Error{map_.path + ": " + used_as + " " + Quoted(name),
                 "is no link of URDF " + Quoted(urdf_.path), JoinWords(known),
                 DidYouMean(name, known)};
  }

  Status CheckAxle(const AxleMapping& axle) {
    auto boxes = Link(axle.boxes, "boxes of axle " + axle.name);
    if (!boxes.ok()) return boxes.error();
    auto wheelset = Link(axle.wheelset, "wheelset of axle " + axle.name);
    if (!wheelset.ok()) return wheelset.error();
    if (boxes.value()->parent != map_.frame) {
      return AtLink(axle.boxes, "hangs on '" + boxes.value()->parent + "'",
                    "axle boxes hang on the frame '" + map_.frame + "'");
    }
    const UrdfLink& w = *wheelset.value();
    if (w.parent != axle.boxes) {
      return AtLink(axle.wheelset, "hangs on '" + w.parent + "'",
                    "the wheelset hangs on its boxes '" + axle.boxes + "'");
    }
    const bool about_y = std::abs(std::abs(w.axis[1]) - 1) < 1e-9;
    if (w.joint_type != "continuous" || !about_y) {
      return Error{urdf_.path + ": joint '" + w.joint + "'",
                   "is " + w.joint_type + " about (" + Texts(w.axis) + ")",
                   "type=\"continuous\" with <axis xyz=\"0 1 0\"/>: the wheelset spins about y",
                   ""};
    }
    suspension_[axle.boxes] = &axle.suspension;
    prefix_[axle.boxes] = axle.name;
    spin_[axle.wheelset] = &axle;
    return {};
  }

  Status Check() {
    auto frame = Link(map_.frame, "frame");
    if (!frame.ok()) return frame.error();
    if (!frame.value()->parent.empty()) {
      return AtLink(map_.frame,
                    "is not the root of the tree: it hangs on '" + frame.value()->parent + "'",
                    "the frame is the root link");
    }
    for (const AxleMapping& axle : map_.axles) {
      if (Status s = CheckAxle(axle); !s.ok()) return s;
    }
    for (const SprungMapping& sprung : map_.sprung) {
      auto link = Link(sprung.link, "sprung link");
      if (!link.ok()) return link.error();
      suspension_[sprung.link] = &sprung.suspension;
      prefix_[sprung.link] = sprung.link;
    }
    for (const CylinderMapping& c : map_.cylinders) {
      for (const std::string& end : {c.from_link, c.to_link}) {
        auto link = Link(end, "cylinder " + c.name + " ends on");
        if (!link.ok()) return link.error();
      }
    }
    for (const UrdfLink& link : urdf_.links) {
      if (Status s = CheckLink(link); !s.ok()) return s;
    }
    return {};
  }

  Status CheckLink(const UrdfLink& link) const {
    if (!link.has_inertial || !(link.mass > 0)) {
      return AtLink(link.name, "has no mass", "<inertial> with <mass value=\"…\"/> > 0");
    }
    for (int i = 0; i < 3; ++i) {
      if (!(link.inertia[static_cast<size_t>(i)] > 0)) {
        return AtLink(link.name, "has a moment of inertia that is not positive",
                      "<inertia ixx iyy izz> > 0");
      }
    }
    if (link.parent.empty() || spin_.count(link.name) > 0) return {};
    const bool sprung = suspension_.count(link.name) > 0;
    const bool free_type = link.joint_type == "floating" || link.joint_type == "fixed";
    if (sprung ? !free_type : link.joint_type != "fixed") {
      return Error{urdf_.path + ": joint '" + link.joint + "'",
                   "is " + link.joint_type + ", which this import cannot use here",
                   sprung ? "floating or fixed, with the directions in the mapping's suspension"
                          : "fixed, for a link that the mapping does not name",
                   "name link '" + link.name + "' in the mapping or make the joint fixed"};
    }
    return {};
  }

  void AddNote(XMLElement* root) {
    root->InsertNewComment(
        (" Made by phs import from " + urdf_.path + " and " + map_.path + ". ").c_str());
  }

  void AddSettings(XMLElement* root) {
    XMLElement* compiler = root->InsertNewChildElement("compiler");
    Set(compiler, "angle", "radian");
    Set(compiler, "autolimits", "false");
    XMLElement* size = root->InsertNewChildElement("size");
    Set(size, "nuserdata", "512");
    XMLElement* option = root->InsertNewChildElement("option");
    Set(option, "timestep", Text(map_.timestep_s));
    Set(option, "integrator", "Euler");
    Set(option, "gravity", "0 0 -9.81");
    XMLElement* flag = option->InsertNewChildElement("flag");
    Set(flag, "contact", "disable");
    Set(flag, "constraint", "disable");
  }

  static void AddInertial(const UrdfLink& link, XMLElement* body) {
    XMLElement* inertial = body->InsertNewChildElement("inertial");
    Set(inertial, "pos", Texts(link.inertial.position));
    Set(inertial, "mass", Text(link.mass));
    const bool turned = link.inertial.quaternion != std::array<double, 4>{1, 0, 0, 0};
    const bool products = link.inertia[3] != 0 || link.inertia[4] != 0 || link.inertia[5] != 0;
    if (products) {
      Set(inertial, "fullinertia", Texts(link.inertia));
    } else {
      Set(inertial, "diaginertia",
          Texts(std::array{link.inertia[0], link.inertia[1], link.inertia[2]}));
    }
    if (turned) Set(inertial, "quat", Texts(link.inertial.quaternion));
  }

  static void AddDirection(const std::string& prefix, const SpringDirection& s, XMLElement* body) {
    static const std::map<std::string, const char*> axes = {{"x", "1 0 0"},     {"y", "0 1 0"},
                                                            {"z", "0 0 1"},     {"roll", "1 0 0"},
                                                            {"pitch", "0 1 0"}, {"yaw", "0 0 1"}};
    XMLElement* joint = body->InsertNewChildElement("joint");
    Set(joint, "name", prefix + "_" + s.direction);
    Set(joint, "type", s.direction.size() > 1 ? "hinge" : "slide");
    Set(joint, "axis", axes.at(s.direction));
    Set(joint, "stiffness", Text(s.stiffness));
    Set(joint, "damping", Text(s.damping));
    if (s.preload_N != 0) Set(joint, "springref", Text(s.preload_N / s.stiffness));
  }

  void AddJoints(const UrdfLink& link, XMLElement* body) const {
    if (link.parent.empty()) {
      Set(body->InsertNewChildElement("freejoint"), "name", link.name + "_free");
      return;
    }
    if (const auto spin = spin_.find(link.name); spin != spin_.end()) {
      XMLElement* joint = body->InsertNewChildElement("joint");
      Set(joint, "name", spin->second->name + "_spin");
      Set(joint, "type", "hinge");
      Set(joint, "axis", "0 1 0");
      if (spin->second->rotor_inertia > 0) {
        Set(joint, "armature", Text(spin->second->rotor_inertia));
      }
    }
    if (const auto found = suspension_.find(link.name); found != suspension_.end()) {
      for (const SpringDirection& s : *found->second) {
        AddDirection(prefix_.at(link.name), s, body);
      }
    }
  }

  void AddSites(const UrdfLink& link, XMLElement* body) const {
    const auto add = [&](const std::string& name, const double* at) {
      XMLElement* site = body->InsertNewChildElement("site");
      Set(site, "name", name);
      Set(site, "pos", Texts(std::array{at[0], at[1], at[2]}));
    };
    if (link.name == map_.frame) add("coupler", map_.coupler_m);
    for (const CylinderMapping& c : map_.cylinders) {
      if (c.from_link == link.name) add("cylinder_" + c.name + "_from", c.from_m);
      if (c.to_link == link.name) add("cylinder_" + c.name + "_to", c.to_m);
    }
  }

  Status AddBody(const UrdfLink& link, XMLElement* parent) {
    if (link.inertial.quaternion != std::array<double, 4>{1, 0, 0, 0} &&
        (link.inertia[3] != 0 || link.inertia[4] != 0 || link.inertia[5] != 0)) {
      return AtLink(link.name, "turns its inertia axes and has products of inertia",
                    "one of the two (MJCF knows no both)", "give the inertia in the link's axes");
    }
    XMLElement* body = parent->InsertNewChildElement("body");
    Set(body, "name", link.name);
    if (link.parent.empty()) {
      Set(body, "pos", "0 0 " + Text(map_.wheel_radius_m));
    } else {
      Set(body, "pos", Texts(link.origin.position));
      if (link.origin.quaternion != std::array<double, 4>{1, 0, 0, 0}) {
        Set(body, "quat", Texts(link.origin.quaternion));
      }
    }
    AddJoints(link, body);
    AddInertial(link, body);
    AddSites(link, body);
    for (const UrdfLink& child : urdf_.links) {
      if (child.parent != link.name) continue;
      if (Status s = AddBody(child, body); !s.ok()) return s;
    }
    return {};
  }

  void AddCylinders(XMLElement* root) {
    if (map_.cylinders.empty()) return;
    XMLElement* tendons = root->InsertNewChildElement("tendon");
    for (const CylinderMapping& c : map_.cylinders) {
      XMLElement* spatial = tendons->InsertNewChildElement("spatial");
      Set(spatial, "name", "cylinder_" + c.name);
      for (const char* end : {"_from", "_to"}) {
        Set(spatial->InsertNewChildElement("site"), "site", "cylinder_" + c.name + end);
      }
    }
  }

  static void AddElement(XMLElement* tuple, const char* type, const std::string& name) {
    XMLElement* element = tuple->InsertNewChildElement("element");
    Set(element, "objtype", type);
    Set(element, "objname", name);
  }

  static void AddText(XMLElement* custom, const std::string& name, const std::string& data) {
    if (data.empty()) return;
    XMLElement* text = custom->InsertNewChildElement("text");
    Set(text, "name", name);
    Set(text, "data", data);
  }

  void AddCustom(XMLElement* root) {
    XMLElement* custom = root->InsertNewChildElement("custom");
    AddText(custom, "phs_track", map_.track);
    AddText(custom, "phs_wheel", map_.wheel);
    AddText(custom, "phs_rail", map_.rail);
    AddText(custom, "phs_creep", map_.creep);
    AddText(custom, "phs_yardstick", map_.yardstick);
    for (const auto& [name, value] : {std::pair{"phs_speed_m_s", map_.speed_m_s},
                                      std::pair{"phs_wheel_radius_m", map_.wheel_radius_m},
                                      std::pair{"phs_flange_back_m", map_.flange_back_m}}) {
      if (value == 0 && std::string(name) == "phs_flange_back_m") continue;
      XMLElement* numeric = custom->InsertNewChildElement("numeric");
      Set(numeric, "name", name);
      Set(numeric, "data", Text(value));
    }
    for (const AxleMapping& axle : map_.axles) {
      XMLElement* tuple = custom->InsertNewChildElement("tuple");
      Set(tuple, "name", "wheelset:" + axle.name);
      AddElement(tuple, "body", axle.wheelset);
      AddElement(tuple, "joint", axle.name + "_spin");
      for (const SpringDirection& s : axle.suspension) {
        if (s.direction == "yaw") AddElement(tuple, "joint", axle.name + "_yaw");
      }
      if (axle.driven) AddElement(tuple, "actuator", axle.name + "_drive");
    }
    if (map_.cylinders.empty()) return;
    AddText(custom, "phs:bogie", map_.phs);
    XMLElement* tuple = custom->InsertNewChildElement("tuple");
    Set(tuple, "name", "phs:bogie");
    for (const CylinderMapping& c : map_.cylinders) {
      AddElement(tuple, "actuator", "cylinder_" + c.name);
    }
  }

  void AddActuators(XMLElement* root) {
    XMLElement* actuators = root->InsertNewChildElement("actuator");
    for (const AxleMapping& axle : map_.axles) {
      if (!axle.driven) continue;
      XMLElement* motor = actuators->InsertNewChildElement("motor");
      Set(motor, "name", axle.name + "_drive");
      Set(motor, "joint", axle.name + "_spin");
    }
    for (const CylinderMapping& c : map_.cylinders) {
      XMLElement* cylinder = actuators->InsertNewChildElement("general");
      Set(cylinder, "name", "cylinder_" + c.name);
      Set(cylinder, "tendon", "cylinder_" + c.name);
      Set(cylinder, "dyntype", "user");
      Set(cylinder, "gaintype", "fixed");
      Set(cylinder, "gainprm", "0");
      Set(cylinder, "biastype", "user");
    }
  }

  const UrdfModel& urdf_;
  const BogieMapping& map_;
  tinyxml2::XMLDocument document_;
  std::map<std::string, const std::vector<SpringDirection>*> suspension_;  ///< by link
  std::map<std::string, std::string> prefix_;                              ///< of joints, by link
  std::map<std::string, const AxleMapping*> spin_;                         ///< by wheelset link
};

}  // namespace

Result<std::string> ImportBogie(const UrdfModel& urdf, const BogieMapping& mapping) {
  return Writer(urdf, mapping).Write();
}

}  // namespace phs::vehicle
