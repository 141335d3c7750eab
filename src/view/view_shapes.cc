#include "view/view_shapes.h"

#include <fmt/format.h>

#include <cstring>
#include <filesystem>
#include <vector>

#include "vehicle/mjcf_document.h"
namespace phs::view {
namespace {

using tinyxml2::XMLElement;

/// A body of the vehicle under its own name, or under both of a locomotive's.
std::vector<std::string> PrefixesOf(const std::string& body, XMLElement* root) {
  std::vector<std::string> found;
  for (const char* prefix : {"", "front_", "rear_"}) {
    if (vehicle::FindBody(root, prefix + body) != nullptr) found.emplace_back(prefix);
  }
  return found;
}

/// True if the file of shapes names the body, under a locomotive's names too.
bool HasShapes(const std::string& body, XMLElement* shapes) {
  for (const std::string prefix : {"", "front_", "rear_"}) {
    if (!body.starts_with(prefix)) continue;
    if (vehicle::FindBody(shapes, body.substr(prefix.size())) != nullptr) return true;
  }
  return false;
}

/// What the physics' file draws of bodies with shapes is hidden; of others (a locomotive's car
/// body) it is shown with the car body.
void SetGroups(XMLElement* shapes, int group, XMLElement* element) {
  for (XMLElement* child = element->FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    if (std::strcmp(child->Name(), "geom") == 0) child->SetAttribute("group", group);
    if (std::strcmp(child->Name(), "body") != 0) continue;
    const char* name = child->Attribute("name");
    const bool has = name != nullptr && HasShapes(name, shapes);
    SetGroups(shapes, has ? kHiddenGroup : kBodyGroup, child);
  }
}

/// The children of a body in the file of shapes copied into the vehicle's body of that name.
Status AddBody(const std::string& path, const XMLElement& body, XMLElement* root) {
  const char* name = body.Attribute("name");
  const std::string where = path + ":" + std::to_string(body.GetLineNum());
  if (name == nullptr) return Error{where, "a body has no name", "name=\"…\"", ""};
  // A locomotive has one car body for both: shapes of the half body are left away there.
  for (const std::string& prefix : PrefixesOf(name, root)) {
    XMLElement* target = vehicle::FindBody(root, prefix + name);
    for (const XMLElement* child = body.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      if (std::strcmp(child->Name(), "geom") != 0 && std::strcmp(child->Name(), "site") != 0) {
        return Error{path + ":" + std::to_string(child->GetLineNum()),
                     std::string("<") + child->Name() + "> in the shapes of a body", "geom, site",
                     "bodies and joints belong to the bogie's own file"};
      }
      vehicle::CopyWithPrefix(*child, prefix, target);
    }
  }
  return {};
}

/// True if every site that the tendon is hung on is there under this prefix.
bool HasSites(const XMLElement& tendon, const std::string& prefix, const XMLElement& root) {
  const auto has = [&](const auto& self, const XMLElement& parent,
                       const std::string& name) -> bool {
    for (const XMLElement* child = parent.FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      const bool site = std::strcmp(child->Name(), "site") == 0;
      if (site && child->Attribute("name") != nullptr && name == child->Attribute("name")) {
        return true;
      }
      const bool holds =
          std::strcmp(child->Name(), "body") == 0 || std::strcmp(child->Name(), "worldbody") == 0;
      if (holds && self(self, *child, name)) return true;
    }
    return false;
  };
  for (const XMLElement* end = tendon.FirstChildElement("site"); end != nullptr;
       end = end->NextSiblingElement("site")) {
    const char* site = end->Attribute("site");
    if (site == nullptr || !has(has, root, prefix + site)) return false;
  }
  return true;
}

void AddTendons(const XMLElement& section, XMLElement* root) {
  XMLElement* target = root->InsertNewChildElement("tendon");
  for (const XMLElement* tendon = section.FirstChildElement("spatial"); tendon != nullptr;
       tendon = tendon->NextSiblingElement("spatial")) {
    for (const char* prefix : {"", "front_", "rear_"}) {
      if (HasSites(*tendon, prefix, *root)) vehicle::CopyWithPrefix(*tendon, prefix, target);
    }
  }
}

}  // namespace

Result<bool> AddShapes(const std::string& bogie_path, XMLElement* root) {
  const std::filesystem::path bogie = bogie_path;
  const std::string path = (bogie.parent_path() / "view" / bogie.filename()).string();
  if (!std::filesystem::exists(path)) return false;
  auto shapes = vehicle::ReadMjcf(path);
  if (!shapes.ok()) return shapes.error();
  for (XMLElement* world = root->FirstChildElement("worldbody"); world != nullptr;
       world = world->NextSiblingElement("worldbody")) {
    SetGroups(shapes.value()->RootElement(), kBodyGroup, world);
  }
  const XMLElement* from = shapes.value()->RootElement();
  for (const XMLElement* section = from->FirstChildElement(); section != nullptr;
       section = section->NextSiblingElement()) {
    const std::string kind = section->Name();
    if (kind == "worldbody") {
      for (const XMLElement* body = section->FirstChildElement("body"); body != nullptr;
           body = body->NextSiblingElement("body")) {
        if (Status s = AddBody(path, *body, root); !s.ok()) return s.error();
      }
    } else if (kind == "default" || kind == "asset") {
      root->InsertEndChild(section->DeepClone(root->GetDocument()));
    } else if (kind != "tendon") {
      return Error{path + ":" + std::to_string(section->GetLineNum()),
                   "<" + kind + "> in a file of shapes", "worldbody, tendon, default, asset",
                   "physics belongs to the bogie's own file"};
    }
  }
  for (const XMLElement* section = from->FirstChildElement("tendon"); section != nullptr;
       section = section->NextSiblingElement("tendon")) {
    AddTendons(*section, root);
  }
  return true;
}

void AddMesh(const std::string& name, const Mesh& mesh, XMLElement* root) {
  fmt::memory_buffer vertices;
  for (const auto& v : mesh.vertex) {
    fmt::format_to(std::back_inserter(vertices), "{:.6g} {:.6g} {:.6g} ", v.x(), v.y(), v.z());
  }
  fmt::memory_buffer faces;
  for (const auto& f : mesh.face) {
    fmt::format_to(std::back_inserter(faces), "{} {} {} ", f[0], f[1], f[2]);
  }
  XMLElement* asset = root->InsertNewChildElement("asset")->InsertNewChildElement("mesh");
  asset->SetAttribute("name", name.c_str());
  asset->SetAttribute("vertex", fmt::to_string(vertices).c_str());
  asset->SetAttribute("face", fmt::to_string(faces).c_str());
}

int CountTendons(const std::string& kind, const XMLElement* root) {
  int count = 0;
  for (const XMLElement* section = root->FirstChildElement("tendon"); section != nullptr;
       section = section->NextSiblingElement("tendon")) {
    for (const XMLElement* tendon = section->FirstChildElement("spatial"); tendon != nullptr;
         tendon = tendon->NextSiblingElement("spatial")) {
      const char* name = tendon->Attribute("name");
      if (name != nullptr && std::string(name).starts_with(kind + ":")) ++count;
    }
  }
  return count;
}

}  // namespace phs::view
