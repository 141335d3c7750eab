#include "vehicle/compose.h"

#include <algorithm>
#include <cstring>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/data_path.h"
#include "phs_model/phs_model.h"
#include "plugin/model_text.h"
#include "vehicle/box_springs.h"
#include "vehicle/mjcf_additions.h"
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

/// Data of a custom text of a file, or "".
std::string TextOf(const XMLElement* root, const std::string& name) {
  for (const XMLElement* custom = root->FirstChildElement("custom"); custom != nullptr;
       custom = custom->NextSiblingElement("custom")) {
    for (const XMLElement* text = custom->FirstChildElement("text"); text != nullptr;
         text = text->NextSiblingElement("text")) {
      const char* own = text->Attribute("name");
      const char* data = text->Attribute("data");
      if (own != nullptr && data != nullptr && name == own) return data;
    }
  }
  return "";
}

/// The same of a bogie by name or path.
std::string TextOfBogie(const std::string& bogie, const std::string& name) {
  auto path = FindData("bogie", "bogie_xml", bogie, {".xml"});
  if (!path.ok()) return "";
  auto document = ReadMjcf(path.value());
  return document.ok() ? TextOf(document.value()->RootElement(), name) : "";
}

/// Calls `visit(class)` for every named default class in `parent`, nested ones too.
template <typename Visit>
void ForEachClass(const XMLElement* parent, Visit visit) {
  for (const XMLElement* d = parent->FirstChildElement("default"); d != nullptr;
       d = d->NextSiblingElement("default")) {
    if (d->Attribute("class") != nullptr) visit(*d);
    ForEachClass(d, visit);
  }
}

/// A bogie that does not share the product's settings (an imported one) has no joint classes for
/// the suspension of the car body: they come from there.
Status AddClassesOfCarBody(XMLElement* root) {
  auto path = FindData("settings", "bogie_xml/shared", "settings", {".xml"});
  if (!path.ok()) return path.error();
  auto settings = ReadMjcf(path.value());
  if (!settings.ok()) return settings.error();
  std::set<std::string> own;
  ForEachClass(root, [&](const XMLElement& d) { own.insert(d.Attribute("class")); });
  XMLElement* added = nullptr;
  ForEachClass(settings.value()->RootElement(), [&](const XMLElement& d) {
    const std::string name = d.Attribute("class");
    if (!name.starts_with("secondary_") || own.contains(name)) return;
    if (added == nullptr) added = root->InsertNewChildElement("default");
    added->InsertEndChild(d.DeepClone(root->GetDocument()));
  });
  return {};
}

/// The two frames of the car body filled with the bogie's parts; the single bogie removed.
Status PutBogiesUnderBody(const std::string& bogie_path, XMLElement* root) {
  const std::string named = TextOf(root, "phs_car_body");
  auto body_path =
      FindData("car body", "bogie_xml/shared",
               named.empty() ? "locomotive_body" : BesideFile(bogie_path, named), {".xml"});
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
  if (Status s = AddClassesOfCarBody(root); !s.ok()) return s;
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

/// States of the PHS that the tuple `name` stands for: the scenario's model or the file's.
Result<int> CountStates(const Scenario& scenario, const std::string& name, int actuators,
                        XMLElement* root) {
  std::string model = scenario.phs;
  ForEach(root, "custom", "text", [&](XMLElement* text) {
    if (model.empty() && AttributeOf(*text, "name") == name) model = AttributeOf(*text, "data");
  });
  auto path = FindData("PHS model", "models/phs", model.empty() ? phs_model::kDefaultModel : model,
                       {".yaml"});
  if (!path.ok()) return path.error();
  auto system =
      phs_model::LoadPhsSystem(path.value(), scenario.phs_changes, name.substr(4), actuators);
  if (!system.ok()) return system.error();
  return system.value().num_states();
}

/// What an actuator acts on: {"tendon", its name} or {"joint", its name}; empty if neither.
using Transmission = std::pair<std::string, std::string>;
Transmission TransmissionOf(XMLElement* root, const std::string& name) {
  Transmission found;
  ForEach(root, "actuator", "general", [&](XMLElement* actuator) {
    if (AttributeOf(*actuator, "name") != name) return;
    for (const char* kind : {"tendon", "joint"}) {
      const std::string target = AttributeOf(*actuator, kind);
      if (!target.empty()) found = {kind, target};
    }
  });
  return found;
}

/// Appends one force-free actuator with a state to the document and to the PHS tuple.
void AddCarrier(const std::string& name, const Transmission& on, XMLElement* carriers,
                XMLElement* tuple) {
  XMLElement* actuator = carriers->InsertNewChildElement("general");
  actuator->SetAttribute("name", name.c_str());
  actuator->SetAttribute(on.first.c_str(), on.second.c_str());
  actuator->SetAttribute("dyntype", "user");
  actuator->SetAttribute("gaintype", "fixed");
  actuator->SetAttribute("gainprm", "0");
  actuator->SetAttribute("biastype", "none");
  XMLElement* element = tuple->InsertNewChildElement("element");
  element->SetAttribute("objtype", "actuator");
  element->SetAttribute("objname", name.c_str());
}

/// One force-free user actuator per state beyond those the file carries. True if any was added.
/// `values` grows by the numbers of cylinders and states.
Result<bool> AddStateCarriers(const Scenario& scenario, const std::string& bogie_path,
                              XMLElement* root, int* values) {
  std::vector<XMLElement*> tuples;
  ForEach(root, "custom", "tuple", [&](XMLElement* tuple) {
    if (AttributeOf(*tuple, "name").starts_with("phs:")) tuples.push_back(tuple);
  });
  XMLElement* carriers = nullptr;
  for (XMLElement* tuple : tuples) {
    const std::string name = AttributeOf(*tuple, "name");
    int listed = 0;
    std::string first;
    for (const XMLElement* e = tuple->FirstChildElement("element"); e != nullptr;
         e = e->NextSiblingElement("element")) {
      if (listed++ == 0) first = AttributeOf(*e, "objname");
    }
    // Any transmission serves, since gain and bias are zero: the first cylinder's is at hand.
    const Transmission on = TransmissionOf(root, first);
    if (on.second.empty()) {
      return Error{bogie_path + ": tuple '" + name + "'", "names no cylinder",
                   "one general actuator on a tendon or a slide joint per cylinder", ""};
    }
    auto states = CountStates(scenario, name, listed, root);
    if (!states.ok()) return states.error();
    *values += listed + states.value();
    for (int i = listed; i < states.value(); ++i) {
      if (carriers == nullptr) carriers = root->InsertNewChildElement("actuator");
      AddCarrier(name.substr(4) + "_state_" + std::to_string(i + 1), on, carriers, tuple);
    }
  }
  return carriers != nullptr;
}

}  // namespace

Result<VehicleDocument> ComposeDocument(const Scenario& scenario) {
  auto path = FindData("bogie", "bogie_xml", scenario.bogie, {".xml"});
  if (!path.ok()) return path.error();
  auto document = ReadMjcf(path.value());
  if (!document.ok()) return document.error();
  XMLElement* root = document.value()->RootElement();
  const bool locomotive = scenario.vehicle == "locomotive";
  if (locomotive) {
    if (Status s = PutBogiesUnderBody(path.value(), root); !s.ok()) return s.error();
  }
  bool changed = FindBeside(path.value(), root) || locomotive;
  int values = 0;
  auto added = AddStateCarriers(scenario, path.value(), root, &values);
  if (!added.ok()) return added.error();
  if (locomotive || added.value()) MoveStatefulActuatorsLast(root);
  changed = EnlargeUserData(values, root) || changed || added.value();
  changed = AddStartKey(root) || changed;
  if (changed) KeepAssetFolders(path.value(), root);
  return VehicleDocument{path.value(), std::move(document).value(), changed};
}

Result<ModelPtr> ComposeVehicle(const Scenario& scenario) {
  auto composed = ComposeDocument(scenario);
  if (!composed.ok()) return composed.error();
  VehicleDocument& vehicle = composed.value();
  if (!scenario.box_springs.empty()) {
    auto plain = CompileMjcf(*vehicle.document, vehicle.path);
    if (!plain.ok()) return plain.error();
    const Status added =
        AddBoxSprings(scenario, plain.value().get(), vehicle.document->RootElement());
    if (!added.ok()) return added.error();
    if (!vehicle.changed) KeepAssetFolders(vehicle.path, vehicle.document->RootElement());
    vehicle.changed = true;
  }
  // Nothing to add: the file as it stands, as any MuJoCo program loads it.
  auto model =
      vehicle.changed ? CompileMjcf(*vehicle.document, vehicle.path) : LoadMjcf(vehicle.path);
  if (model.ok() && !SaysStep(vehicle.document->RootElement())) {
    model.value()->opt.timestep = kDefaultStep_s;
  }
  return model;
}

std::vector<ComparedBogie> ListComparedBogies() {
  std::vector<ComparedBogie> bogies;
  for (const std::string& name : ListData("bogie_xml", {".xml"})) {
    const std::string yardstick = YardstickOf(name);
    if (!yardstick.empty() && TextOfBogie(name, "phs_vehicle").empty()) {
      bogies.push_back({name, yardstick});
    }
  }
  // A yardstick stands before those measured with it.
  std::stable_sort(bogies.begin(), bogies.end(), [](const auto& a, const auto& b) {
    const bool a_first = a.name == a.yardstick;
    const bool b_first = b.name == b.yardstick;
    return a.yardstick != b.yardstick ? a.yardstick < b.yardstick : a_first && !b_first;
  });
  return bogies;
}

std::string YardstickOf(const std::string& bogie) { return TextOfBogie(bogie, "phs_yardstick"); }

std::string TrackOf(const std::string& bogie) {
  auto path = FindData("bogie", "bogie_xml", bogie, {".xml"});
  if (!path.ok()) return "";
  auto document = ReadMjcf(path.value());
  if (!document.ok()) return "";
  return BesideFile(path.value(), TextOf(document.value()->RootElement(), "phs_track"));
}

std::string PhsModelOf(const std::string& bogie) {
  auto path = FindData("bogie", "bogie_xml", bogie, {".xml"});
  if (!path.ok()) return "";
  auto document = ReadMjcf(path.value());
  if (!document.ok()) return "";
  std::string model;
  ForEach(document.value()->RootElement(), "custom", "text", [&](XMLElement* text) {
    if (model.empty() && AttributeOf(*text, "name").starts_with("phs:")) {
      model = BesideFile(path.value(), AttributeOf(*text, "data"));
    }
  });
  return model;
}

}  // namespace phs::vehicle
