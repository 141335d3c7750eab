#include "vehicle/mjcf_additions.h"

#include <filesystem>

#include "base/data_path.h"

namespace phs::vehicle {
namespace {

using tinyxml2::XMLElement;

/// Joints in `parent` and below.
int CountJoints(const XMLElement* parent) {
  int count = 0;
  for (const XMLElement* child = parent->FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    const std::string tag = child->Name();
    if (tag == "joint" || tag == "freejoint") ++count;
    if (tag == "body" || tag == "worldbody") count += CountJoints(child);
  }
  return count;
}

int RoomFor(const XMLElement* root, int cylinders_and_states) {
  return 64 + 6 * CountJoints(root) + 4 * cylinders_and_states;
}

}  // namespace

std::string AttributeOf(const XMLElement& element, const char* name) {
  const char* value = element.Attribute(name);
  return value == nullptr ? std::string() : std::string(value);
}

bool EnlargeUserData(int cylinders_and_states, XMLElement* root) {
  const int values = RoomFor(root, cylinders_and_states);
  int own = 0;
  for (const XMLElement* size = root->FirstChildElement("size"); size != nullptr;
       size = size->NextSiblingElement("size")) {
    own = size->IntAttribute("nuserdata", own);
  }
  if (own >= values) return false;
  root->InsertNewChildElement("size")->SetAttribute("nuserdata", values);
  return true;
}

bool AddStartKey(XMLElement* root) {
  bool there = false;
  ForEach(root, "keyframe", "key",
          [&](XMLElement* key) { there = there || AttributeOf(*key, "name") == "test"; });
  if (there) return false;
  root->InsertNewChildElement("keyframe")
      ->InsertNewChildElement("key")
      ->SetAttribute("name", "test");
  return true;
}

bool FindBeside(const std::string& bogie_path, XMLElement* root) {
  bool found = false;
  ForEach(root, "custom", "text", [&](XMLElement* text) {
    const std::string name = AttributeOf(*text, "name");
    const bool path = name == "phs_track" || name == "phs_wheel" || name == "phs_rail" ||
                      name.starts_with("phs:");
    if (!path) return;
    const std::string data = AttributeOf(*text, "data");
    const std::string beside = BesideFile(bogie_path, data);
    if (beside == data) return;
    text->SetAttribute("data", Anywhere(beside).c_str());
    found = true;
  });
  return found;
}

void KeepAssetFolders(const std::string& bogie_path, XMLElement* root) {
  if (root->FirstChildElement("asset") == nullptr) return;
  const auto folder = std::filesystem::absolute(bogie_path).parent_path();
  XMLElement* last = root->InsertNewChildElement("compiler");
  for (const char* kind : {"meshdir", "texturedir"}) {
    std::string own;
    for (const XMLElement* compiler = root->FirstChildElement("compiler"); compiler != nullptr;
         compiler = compiler->NextSiblingElement("compiler")) {
      if (compiler->Attribute(kind) != nullptr) own = compiler->Attribute(kind);
    }
    last->SetAttribute(kind, (folder / own / "").lexically_normal().c_str());
  }
}

bool SaysStep(const XMLElement* root) {
  bool says = false;
  for (const XMLElement* option = root->FirstChildElement("option"); option != nullptr;
       option = option->NextSiblingElement("option")) {
    says = says || option->Attribute("timestep") != nullptr;
  }
  return says;
}

}  // namespace phs::vehicle
