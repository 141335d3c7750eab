#include "vehicle/compose.h"

#include <cstring>
#include <filesystem>

#include "base/data_path.h"
#include "effects/catalogue.h"
#include "plugin/model_text.h"
#include "vehicle/mjcf_document.h"

namespace phs::vehicle {
namespace {

using tinyxml2::XMLElement;

/// Children of a single bogie's frame that the locomotive replaces by its own.
bool BelongsToSingleBogie(const XMLElement& child) {
  const char* name = child.Attribute("name");
  return std::strcmp(child.Name(), "freejoint") == 0 ||
         (name != nullptr && std::strcmp(name, "half_body") == 0);
}

/// Sections whose elements belong to one bogie and are repeated per bogie.
bool IsPerBogie(const XMLElement& section, const XMLElement& element) {
  const char* name = element.Attribute("name");
  if (std::strcmp(section.Name(), "custom") == 0) {
    return name != nullptr && std::strchr(name, ':') != nullptr;
  }
  return std::strcmp(section.Name(), "tendon") == 0 ||
         std::strcmp(section.Name(), "actuator") == 0 || std::strcmp(section.Name(), "sensor") == 0;
}

/// The two frames of the car body filled with the bogie's parts; the single bogie removed.
Status PutBogiesUnderBody(const std::string& bogie_path, XMLElement* root) {
  auto body_path = FindData("car body", "bogie_xml/shared", "locomotive_body", {".xml"});
  if (!body_path.ok()) return body_path.error();
  auto body = ReadMjcf(body_path.value());
  if (!body.ok()) return body.error();
  XMLElement* frame = FindBody(root, "frame");
  if (frame == nullptr) {
    return Error{bogie_path, "has no body 'frame', which a locomotive puts under its body",
                 "<body name=\"frame\"> with the wheelsets inside", ""};
  }
  XMLElement* car_root = body.value()->RootElement();
  for (const char* prefix : {"front_", "rear_"}) {
    XMLElement* place = FindBody(car_root, std::string(prefix) + "frame");
    if (place == nullptr) {
      return Error{body_path.value(), std::string("has no body '") + prefix + "frame'", "", ""};
    }
    for (const XMLElement* child = frame->FirstChildElement(); child != nullptr;
         child = child->NextSiblingElement()) {
      if (!BelongsToSingleBogie(*child)) CopyWithPrefix(*child, prefix, place);
    }
    for (XMLElement* section = root->FirstChildElement(); section != nullptr;
         section = section->NextSiblingElement()) {
      XMLElement* copies = nullptr;
      for (const XMLElement* e = section->FirstChildElement(); e != nullptr;
           e = e->NextSiblingElement()) {
        if (!IsPerBogie(*section, *e)) continue;
        if (copies == nullptr) copies = car_root->InsertNewChildElement(section->Name());
        CopyWithPrefix(*e, prefix, copies);
      }
    }
  }
  for (XMLElement* section = root->FirstChildElement(); section != nullptr;
       section = section->NextSiblingElement()) {
    for (XMLElement* e = section->FirstChildElement(); e != nullptr;) {
      XMLElement* next = e->NextSiblingElement();
      if (IsPerBogie(*section, *e)) section->DeleteChild(e);
      e = next;
    }
  }
  frame->Parent()->DeleteChild(frame);
  for (const XMLElement* section = car_root->FirstChildElement(); section != nullptr;
       section = section->NextSiblingElement()) {
    root->InsertEndChild(section->DeepClone(root->GetDocument()));
  }
  return {};
}

/// MuJoCo 2.2.2 wants actuators without state before those with state.
void MoveStatefulActuatorsLast(XMLElement* root) {
  XMLElement* stateless = root->InsertNewChildElement("actuator");
  XMLElement* stateful = root->InsertNewChildElement("actuator");
  for (XMLElement* section = root->FirstChildElement("actuator"); section != stateless;
       section = section->NextSiblingElement("actuator")) {
    while (XMLElement* e = section->FirstChildElement()) {
      const char* group = e->Attribute("class");
      const bool has_state = e->Attribute("dyntype") != nullptr ||
                             (group != nullptr && std::strcmp(group, "cylinder") == 0);
      (has_state ? stateful : stateless)->InsertEndChild(e);
    }
  }
}

/// One force-free user actuator per state beyond those the file carries. True if any was added.
Result<bool> AddStateCarriers(const Scenario& scenario, const std::string& bogie_path,
                              XMLElement* root) {
  bool added = false;
  XMLElement* carriers = nullptr;
  for (XMLElement* custom = root->FirstChildElement("custom"); custom != nullptr;
       custom = custom->NextSiblingElement("custom")) {
    for (XMLElement* tuple = custom->FirstChildElement("tuple"); tuple != nullptr;
         tuple = tuple->NextSiblingElement("tuple")) {
      const std::string name = tuple->Attribute("name") == nullptr ? "" : tuple->Attribute("name");
      if (!name.starts_with("phs:")) continue;
      std::string model = scenario.phs;
      for (XMLElement* section = root->FirstChildElement("custom");
           section != nullptr && model.empty(); section = section->NextSiblingElement("custom")) {
        for (XMLElement* text = section->FirstChildElement("text"); text != nullptr;
             text = text->NextSiblingElement("text")) {
          if (text->Attribute("name", name.c_str()) != nullptr) model = text->Attribute("data");
        }
      }
      auto path = FindData("PHS model", "models/phs", model.empty() ? "bo_bo" : model, {".yaml"});
      if (!path.ok()) return path.error();
      auto system = effects::LoadPhsSystem(path.value());
      if (!system.ok()) return system.error();
      int listed = 0;
      const XMLElement* last = nullptr;
      for (XMLElement* e = tuple->FirstChildElement("element"); e != nullptr;
           e = e->NextSiblingElement("element")) {
        last = e;
        ++listed;
      }
      if (last == nullptr) {
        return Error{bogie_path + ": tuple '" + name + "'", "is empty", "one actuator per cylinder",
                     ""};
      }
      for (int i = listed; i < system.value().num_states(); ++i) {
        if (carriers == nullptr) carriers = root->InsertNewChildElement("actuator");
        const std::string carrier = name.substr(4) + "_state_" + std::to_string(i + 1);
        XMLElement* actuator = carriers->InsertNewChildElement("general");
        actuator->SetAttribute("name", carrier.c_str());
        XMLElement* element = tuple->InsertNewChildElement("element");
        element->SetAttribute("objtype", "actuator");
        element->SetAttribute("objname", carrier.c_str());
        // Any transmission serves: gain and bias are zero. The first cylinder's tendon is at hand.
        std::string tendon;
        for (XMLElement* section = root->FirstChildElement("actuator"); section != nullptr;
             section = section->NextSiblingElement("actuator")) {
          for (XMLElement* e = section->FirstChildElement(); e != nullptr;
               e = e->NextSiblingElement()) {
            const char* own = e->Attribute("name");
            if (own != nullptr && e->Attribute("tendon") != nullptr &&
                last->Attribute("objname", own) != nullptr) {
              tendon = e->Attribute("tendon");
            }
          }
        }
        actuator->SetAttribute("tendon", tendon.c_str());
        actuator->SetAttribute("dyntype", "user");
        actuator->SetAttribute("gaintype", "fixed");
        actuator->SetAttribute("gainprm", "0");
        actuator->SetAttribute("biastype", "none");
        added = true;
      }
    }
  }
  return added;
}

/// userdata large enough for every PHS.
void EnlargeUserData(int values, XMLElement* root) {
  XMLElement* size = root->InsertNewChildElement("size");
  size->SetAttribute("nuserdata", values);
}

}  // namespace

Result<ModelPtr> ComposeVehicle(const Scenario& scenario) {
  auto path = FindData("bogie", "bogie_xml", scenario.bogie, {".xml"});
  if (!path.ok()) return path.error();
  auto document = ReadMjcf(path.value());
  if (!document.ok()) return document.error();
  XMLElement* root = document.value()->RootElement();
  const bool locomotive = scenario.vehicle == "locomotive";
  if (locomotive) {
    if (Status s = PutBogiesUnderBody(path.value(), root); !s.ok()) return s.error();
  }
  auto added = AddStateCarriers(scenario, path.value(), root);
  if (!added.ok()) return added.error();
  // Nothing to add: the file as it stands, as any MuJoCo program loads it.
  if (!locomotive && !added.value()) return LoadMjcf(path.value());
  MoveStatefulActuatorsLast(root);
  EnlargeUserData(512, root);
  return CompileMjcf(*document.value(), path.value());
}

}  // namespace phs::vehicle
