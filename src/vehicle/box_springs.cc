#include "vehicle/box_springs.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "base/words.h"
#include "plugin/model_text.h"

namespace phs::vehicle {
namespace {

using tinyxml2::XMLElement;

constexpr char kEnding[] = "_box";
constexpr double kNoArm = 1e-9;  // [m] shorter levers are none

std::string BoxAt(const mjModel* m, int site) {
  const std::string name = plugin::ObjectName(m, mjOBJ_SITE, site);
  return name.ends_with(kEnding) ? name.substr(0, name.size() - std::string(kEnding).size()) : "";
}

std::vector<int> JointsOf(const mjModel* m, int body, int type) {
  std::vector<int> joints;
  for (int k = 0; k < m->body_jntnum[body]; ++k) {
    const int joint = m->body_jntadr[body] + k;
    if (m->jnt_type[joint] == type) joints.push_back(joint);
  }
  return joints;
}

double Stiffness(const Scenario& scenario, const mjModel* m, int joint) {
  for (const Scenario::JointChange& change : scenario.joints) {
    if (change.joint == plugin::ObjectName(m, mjOBJ_JOINT, joint) && change.stiffness >= 0) {
      return change.stiffness;
    }
  }
  return m->jnt_stiffness[joint];
}

bool IsSprung(const mjModel* m, int site) {
  const std::vector<int> slides = JointsOf(m, m->site_bodyid[site], mjJNT_SLIDE);
  return std::any_of(slides.begin(), slides.end(), [m](int j) { return m->jnt_stiffness[j] > 0; });
}

int CountBoxes(const mjModel* m, int body) {
  int count = 0;
  for (int s = 0; s < m->nsite; ++s) {
    if (m->site_bodyid[s] == body && !BoxAt(m, s).empty()) ++count;
  }
  return count;
}

void AddJoint(const mjModel* m, int joint, double coefficient, XMLElement* tendon) {
  XMLElement* along = tendon->InsertNewChildElement("joint");
  along->SetAttribute("joint", plugin::ObjectName(m, mjOBJ_JOINT, joint).c_str());
  along->SetAttribute("coef", Shortest(coefficient).c_str());
}

/// What the box has beyond its share, along each slide of its body.
void AddAt(const Scenario& scenario, const mjModel* m, int site, double factor,
           XMLElement* tendons) {
  const int body = m->site_bodyid[site];
  for (const int slide : JointsOf(m, body, mjJNT_SLIDE)) {
    const double stiffness = (factor - 1) * Stiffness(scenario, m, slide) / CountBoxes(m, body);
    if (stiffness == 0) continue;
    XMLElement* tendon = tendons->InsertNewChildElement("fixed");
    tendon->SetAttribute("stiffness", Shortest(stiffness).c_str());
    AddJoint(m, slide, 1, tendon);
    for (const int hinge : JointsOf(m, body, mjJNT_HINGE)) {
      double from[3], moved[3];
      mju_sub3(from, m->site_pos + 3 * site, m->jnt_pos + 3 * hinge);
      mju_cross(moved, m->jnt_axis + 3 * hinge, from);
      const double arm = mju_dot3(moved, m->jnt_axis + 3 * slide);
      if (std::abs(arm) > kNoArm) AddJoint(m, hinge, arm, tendon);
    }
  }
}

}  // namespace

std::vector<std::string> BoxNames(const mjModel* m) {
  std::vector<std::string> names;
  for (int s = 0; s < m->nsite; ++s) {
    if (!BoxAt(m, s).empty() && IsSprung(m, s)) names.push_back(BoxAt(m, s));
  }
  return names;
}

Status AddBoxSprings(const Scenario& scenario, const mjModel* m, XMLElement* root) {
  XMLElement* tendons = nullptr;
  const std::vector<std::string> names = BoxNames(m);
  for (const Scenario::BoxSpring& asked : scenario.box_springs) {
    if (!asked.box.empty() && std::find(names.begin(), names.end(), asked.box) == names.end()) {
      return Error{
          "effects.box_spring.targets",
          Quoted(asked.box) + " is no axle box on springs of bogie " + scenario.bogie,
          names.empty() ? "a site NAME_box on a body with a sprung slide joint" : JoinWords(names),
          DidYouMean(asked.box, names)};
    }
    if (tendons == nullptr) tendons = root->InsertNewChildElement("tendon");
    for (int s = 0; s < m->nsite; ++s) {
      const std::string box = BoxAt(m, s);
      if (box.empty() || !IsSprung(m, s)) continue;
      if (asked.box.empty() || asked.box == box) AddAt(scenario, m, s, asked.factor, tendons);
    }
  }
  return {};
}

}  // namespace phs::vehicle
