#include "vehicle/urdf_file.h"

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <functional>
#include <mutex>
#include <string_view>
#include <utility>

#include "base/origin.h"
#include "base/result_dir.h"

namespace phs::vehicle {
namespace {

/// Keeps what the parser would print: its messages name the element.
class MessageKeeper final : public console_bridge::OutputHandler {
 public:
  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level < console_bridge::CONSOLE_BRIDGE_LOG_ERROR) return;
    text_ += (text_.empty() ? "" : "; ") + text;
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

UrdfPose PoseOf(const urdf::Pose& pose) {
  UrdfPose out;
  out.position = {pose.position.x, pose.position.y, pose.position.z};
  out.quaternion = {pose.rotation.w, pose.rotation.x, pose.rotation.y, pose.rotation.z};
  return out;
}

std::string TypeName(int type) {
  switch (type) {
    case urdf::Joint::REVOLUTE:
      return "revolute";
    case urdf::Joint::CONTINUOUS:
      return "continuous";
    case urdf::Joint::PRISMATIC:
      return "prismatic";
    case urdf::Joint::FLOATING:
      return "floating";
    case urdf::Joint::PLANAR:
      return "planar";
    case urdf::Joint::FIXED:
      return "fixed";
    default:
      return "unknown";
  }
}

UrdfLink LinkOf(const urdf::Link& from) {
  UrdfLink link;
  link.name = from.name;
  if (from.inertial != nullptr) {
    const urdf::Inertial& i = *from.inertial;
    link.has_inertial = true;
    link.mass = i.mass;
    link.inertial = PoseOf(i.origin);
    link.inertia = {i.ixx, i.iyy, i.izz, i.ixy, i.ixz, i.iyz};
  }
  if (from.parent_joint != nullptr) {
    const urdf::Joint& j = *from.parent_joint;
    link.parent = j.parent_link_name;
    link.joint = j.name;
    link.joint_type = TypeName(j.type);
    link.origin = PoseOf(j.parent_to_joint_origin_transform);
    link.axis = {j.axis.x, j.axis.y, j.axis.z};
  }
  return link;
}

constexpr int kMostNested = 100;  ///< elements inside elements
constexpr int kMostLinks = 1000;

/// The end of what begins at `at` with '<' and is no element, e.g. a comment; else `at`.
size_t BehindRemark(const std::string& text, size_t at) {
  for (const auto& [begin, end] :
       {std::pair{"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}, {"<!", ">"}}) {
    const std::string_view opening = begin;
    if (text.compare(at, opening.size(), opening) != 0) continue;
    const size_t found = text.find(end, at + opening.size());
    return found == std::string::npos ? text.size() : found + std::string_view(end).size();
  }
  return at;
}

/// Elements nested or chained without limit would end the parser's stack: they are counted first.
Status CheckSize(const std::string& text, const std::string& path) {
  int depth = 0, links = 0;
  for (size_t at = 0; (at = text.find('<', at)) != std::string::npos;) {
    if (const size_t behind = BehindRemark(text, at); behind != at) {
      at = behind;
      continue;
    }
    const size_t end = std::min(text.find('>', at), text.size());
    if (text.compare(at, 2, "</") == 0) {
      --depth;
    } else if (text[end - 1] != '/') {
      ++depth;
    }
    links += text.compare(at, 5, "<link") == 0;
    if (depth > kMostNested || links > kMostLinks) {
      return Error{path, depth > kMostNested ? "nests elements too deeply" : "has too many links",
                   std::to_string(kMostNested) + " levels of elements, " +
                       std::to_string(kMostLinks) + " links",
                   ""};
    }
    at = end;
  }
  return {};
}

}  // namespace

const UrdfLink* UrdfModel::Find(const std::string& link) const {
  for (const UrdfLink& own : links) {
    if (own.name == link) return &own;
  }
  return nullptr;
}

Result<UrdfModel> ReadUrdf(const std::string& path) {
  auto text = ReadFile(path);
  if (!text.ok()) return text.error();
  NoteInput(path, text.value());
  if (Status s = CheckSize(text.value(), path); !s.ok()) return s.error();
  // The handler is global to the process.
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  MessageKeeper messages;
  console_bridge::useOutputHandler(&messages);
  urdf::ModelInterfaceSharedPtr parsed;
  std::string fault;
  try {
    // Its parser steps over as many bytes as the first of a letter announces, also past the end.
    parsed = urdf::parseURDF(text.value() + "\n\n\n\n");
  } catch (const std::exception& e) {
    fault = e.what();
  }
  console_bridge::restorePreviousOutputHandler();
  if (parsed == nullptr || parsed->getRoot() == nullptr) {
    if (!messages.text().empty()) fault = messages.text();
    return Error{path, fault.empty() ? "is no URDF model" : fault,
                 "a URDF file (robot, link, joint)", ""};
  }
  UrdfModel model;
  model.path = path;
  model.name = parsed->getName();
  const std::function<void(const urdf::Link&)> visit = [&](const urdf::Link& link) {
    model.links.push_back(LinkOf(link));
    for (const auto& child : link.child_links) visit(*child);
  };
  visit(*parsed->getRoot());
  return model;
}

}  // namespace phs::vehicle
