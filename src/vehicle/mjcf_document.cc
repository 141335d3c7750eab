#include "vehicle/mjcf_document.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <set>

#include "base/origin.h"

namespace phs::vehicle {
namespace {

using tinyxml2::XMLDocument;
using tinyxml2::XMLElement;
using tinyxml2::XMLNode;

constexpr int kMaxIncludeDepth = 20;

Error NoElement(const std::string& path) {
  return {path, "has no element", "a readable MJCF file", ""};
}

Status ExpandIncludes(const std::filesystem::path& folder, int depth, XMLElement* element) {
  for (XMLElement* child = element->FirstChildElement(); child != nullptr;) {
    XMLElement* next = child->NextSiblingElement();
    if (std::strcmp(child->Name(), "include") != 0) {
      if (Status s = ExpandIncludes(folder, depth, child); !s.ok()) return s;
      child = next;
      continue;
    }
    const char* file = child->Attribute("file");
    const std::string where = "line " + std::to_string(child->GetLineNum()) + ": include";
    if (file == nullptr) return Error{where, "has no file", "file=\"…\"", ""};
    if (depth >= kMaxIncludeDepth) return Error{where, "includes nest too deeply", "20 levels", ""};
    const std::string path = (folder / file).string();
    XMLDocument included;
    if (included.LoadFile(path.c_str()) != tinyxml2::XML_SUCCESS) {
      return Error{path, included.ErrorStr(), "a readable MJCF file", ""};
    }
    if (included.RootElement() == nullptr) return NoElement(path);
    NoteInput(path);
    if (Status s = ExpandIncludes(folder, depth + 1, included.RootElement()); !s.ok()) return s;
    XMLNode* after = child;
    for (const XMLNode* node = included.RootElement()->FirstChild(); node != nullptr;
         node = node->NextSibling()) {
      after = element->InsertAfterChild(after, node->DeepClone(element->GetDocument()));
    }
    element->DeleteChild(child);
    child = next;
  }
  return {};
}

bool IsReference(const char* attribute) {
  static const std::set<std::string> kNames = {
      "name",  "joint", "joint1", "joint2", "jointinparent", "tendon",  "site",      "site1",
      "site2", "body",  "body1",  "body2",  "geom",          "objname", "cranksite", "slidersite"};
  return kNames.count(attribute) > 0;
}

/// "phs:bogie" and "wheelset:lead" keep their kind: the prefix goes behind the colon.
std::string Prefixed(const std::string& name, const std::string& prefix) {
  const size_t colon = name.find(':');
  return colon == std::string::npos ? prefix + name
                                    : name.substr(0, colon + 1) + prefix + name.substr(colon + 1);
}

void PrefixNames(const std::string& prefix, XMLElement* element) {
  for (const tinyxml2::XMLAttribute* a = element->FirstAttribute(); a != nullptr; a = a->Next()) {
    if (IsReference(a->Name())) {
      const std::string value = Prefixed(a->Value(), prefix);
      element->SetAttribute(a->Name(), value.c_str());
    }
  }
  for (XMLElement* child = element->FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    PrefixNames(prefix, child);
  }
}

}  // namespace

Result<XmlPtr> ReadMjcf(const std::string& path) {
  auto document = std::make_unique<XMLDocument>();
  if (document->LoadFile(path.c_str()) != tinyxml2::XML_SUCCESS) {
    return Error{path, document->ErrorStr(), "a readable MJCF file", ""};
  }
  NoteInput(path);
  XMLElement* root = document->RootElement();
  if (root == nullptr) return NoElement(path);
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  if (Status s = ExpandIncludes(folder, 0, root); !s.ok()) {
    Error error = s.error();
    error.where = path + ": " + error.where;
    return error;
  }
  return document;
}

XMLElement* CopyWithPrefix(const XMLElement& element, const std::string& prefix, XMLNode* target) {
  XMLElement* copy = element.DeepClone(target->GetDocument())->ToElement();
  PrefixNames(prefix, copy);
  target->InsertEndChild(copy);
  return copy;
}

XMLElement* FindBody(XMLElement* root, const std::string& name) {
  for (XMLElement* child = root->FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    const bool is_body = std::strcmp(child->Name(), "body") == 0;
    if (is_body && child->Attribute("name") != nullptr && name == child->Attribute("name")) {
      return child;
    }
    if (is_body || std::strcmp(child->Name(), "worldbody") == 0) {
      if (XMLElement* found = FindBody(child, name)) return found;
    }
  }
  return nullptr;
}

Result<ModelPtr> CompileMjcf(const XMLDocument& document, const std::string& origin) {
  InstallEngineHandlers();
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  const auto vfs = std::make_unique<mjVFS>();
  mj_defaultVFS(vfs.get());
  constexpr char kName[] = "composed.xml";
  const int size = printer.CStrSize() - 1;
  mj_makeEmptyFileVFS(vfs.get(), kName, size);
  const int at = mj_findFileVFS(vfs.get(), kName);
  std::memcpy(vfs->filedata[at], printer.CStr(), static_cast<size_t>(size));
  char message[1000] = "";
  ModelPtr model;
  try {
    model.reset(mj_loadXML(kName, vfs.get(), message, sizeof message));
  } catch (const EngineError& e) {
    std::snprintf(message, sizeof message, "%s", e.what());
  }
  mj_deleteVFS(vfs.get());
  if (model != nullptr) return model;
  std::string text = message;
  std::replace(text.begin(), text.end(), '\n', ' ');
  return Error{origin, text, "an MJCF model of MuJoCo 2.2.2", ""};
}

}  // namespace phs::vehicle
