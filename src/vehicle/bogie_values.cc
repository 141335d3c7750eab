#include "vehicle/bogie_values.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <set>
#include <sstream>

#include "base/data_path.h"
#include "base/numbers.h"
#include "base/words.h"
#include "vehicle/mjcf_additions.h"
#include "vehicle/mjcf_document.h"

namespace phs::vehicle {
namespace {

using tinyxml2::XMLElement;

/// `*` stands for any letters. On a letter that does not fit the last `*` takes one more.
bool Matches(std::string_view pattern, std::string_view text) {
  std::size_t p = 0, t = 0, star = std::string_view::npos, taken = 0;
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      taken = t;
    } else if (p < pattern.size() && pattern[p] == text[t]) {
      ++p;
      ++t;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      t = ++taken;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

/// "x2" of "1 0.5" is "2 1".
Result<std::string> NewValue(const std::string& own, const std::string& value) {
  const auto factor = value[0] == 'x' ? ParseNumber(value.substr(1)) : std::nullopt;
  if (!factor) return value;
  std::istringstream words(own);
  std::string scaled;
  for (std::string word; words >> word;) {
    const auto number = ParseNumber(word);
    if (!number) return Error{"", Quoted(own) + " is no number to multiply", "numbers", ""};
    scaled += (scaled.empty() ? "" : " ") + Shortest(*number * *factor);
  }
  return scaled;
}

/// The words KEY=VALUE of a custom text.
std::vector<std::pair<std::string, std::string>> ValuesIn(const std::string& data) {
  std::vector<std::pair<std::string, std::string>> found;
  std::istringstream words(data);
  for (std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    if (equals != std::string::npos) {
      found.emplace_back(word.substr(0, equals), word.substr(equals + 1));
    }
  }
  return found;
}

/// One key in one file.
class Setter {
 public:
  Setter(std::string element, std::string attribute, std::string value)
      : element_(std::move(element)), attribute_(std::move(attribute)), value_(std::move(value)) {}

  Status Visit(XMLElement* parent) {
    for (XMLElement* e = parent->FirstChildElement(); e != nullptr; e = e->NextSiblingElement()) {
      if (Status s = VisitOne(e); !s.ok()) return s;
      if (Status s = Visit(e); !s.ok()) return s;
    }
    return {};
  }

  int places() const { return places_; }
  /// Names of everything that has one, and what the elements of the key state.
  const std::set<std::string>& names() const { return names_; }
  const std::set<std::string>& stated() const { return stated_; }

 private:
  Status VisitOne(XMLElement* e) {
    const bool is_class = std::strcmp(e->Name(), "default") == 0;
    const std::string name = AttributeOf(*e, is_class ? "class" : "name");
    if (name.empty()) return {};
    names_.insert(name);
    if (!Matches(element_, name)) return {};
    if (!is_class) return Set(e);
    for (XMLElement* of = e->FirstChildElement(); of != nullptr; of = of->NextSiblingElement()) {
      if (std::strcmp(of->Name(), "default") == 0) continue;
      if (Status s = Set(of); !s.ok()) return s;
    }
    return {};
  }

  Status Set(XMLElement* e) {
    for (const tinyxml2::XMLAttribute* a = e->FirstAttribute(); a != nullptr; a = a->Next()) {
      if (std::strcmp(a->Name(), "name") != 0) stated_.insert(a->Name());
    }
    if (e->Attribute(attribute_.c_str()) != nullptr && attribute_ != "name") {
      const auto made = NewValue(AttributeOf(*e, attribute_.c_str()), value_);
      if (!made.ok()) return made.error();
      e->SetAttribute(attribute_.c_str(), made.value().c_str());
      ++places_;
    }
    return std::strcmp(e->Name(), "text") == 0 ? SetWord(e) : Status();
  }

  Status SetWord(XMLElement* text) {
    std::string data;
    bool found = false;
    for (const auto& [key, own] : ValuesIn(AttributeOf(*text, "data"))) {
      stated_.insert(key);
      std::string word = own;
      if (key == attribute_) {
        const auto made = NewValue(own, value_);
        if (!made.ok()) return made.error();
        word = made.value();
        found = true;
      }
      data += (data.empty() ? "" : " ") + key + "=" + word;
    }
    if (!found) return {};
    text->SetAttribute("data", data.c_str());
    ++places_;
    return {};
  }

  std::string element_, attribute_, value_;
  int places_ = 0;
  std::set<std::string> names_, stated_;
};

std::string Printed(const tinyxml2::XMLDocument& document) {
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  return printer.CStr();
}

/// The text that names the bogie's car body, or null.
XMLElement* CarBodyText(XMLElement* root) {
  XMLElement* found = nullptr;
  ForEach(root, "custom", "text", [&](XMLElement* text) {
    if (AttributeOf(*text, "name") == "phs_car_body") found = text;
  });
  return found;
}

Status SetValue(const std::string& key, const std::string& value, XMLElement* bogie,
                XMLElement* car_body, bool* car_body_changed) {
  const std::size_t dot = key.rfind('.');
  if (dot == std::string::npos || dot == 0 || value.empty()) {
    return Error{"", Quoted(key) + " names no value of an element", "ELEMENT.ATTRIBUTE", ""};
  }
  const std::string element = key.substr(0, dot), attribute = key.substr(dot + 1);
  Setter setter(element, attribute, value);
  if (Status s = setter.Visit(bogie); !s.ok()) return s;
  if (car_body != nullptr) {
    const int before = setter.places();
    if (Status s = setter.Visit(car_body); !s.ok()) return s;
    *car_body_changed = *car_body_changed || setter.places() > before;
  }
  if (setter.places() > 0) return {};
  const std::set<std::string>& set = setter.stated().empty() ? setter.names() : setter.stated();
  const std::vector<std::string> known(set.begin(), set.end());
  if (setter.stated().empty()) {
    return Error{"", "the bogie has no element " + Quoted(element), JoinWords(known),
                 DidYouMean(element, known)};
  }
  return Error{"", Quoted(element) + " states no " + Quoted(attribute), JoinWords(known),
               DidYouMean(attribute, known)};
}

}  // namespace

Result<VariedBogie> VaryBogie(const std::string& bogie, const BogieValues& values) {
  auto path = FindData("bogie", "bogie_xml", bogie, {".xml"});
  if (!path.ok()) return path.error();
  auto document = ReadMjcf(path.value());
  if (!document.ok()) return document.error();
  XMLElement* root = document.value()->RootElement();
  XmlPtr car_body;
  XMLElement* named = CarBodyText(root);
  if (named != nullptr) {
    const std::string body = BesideFile(path.value(), AttributeOf(*named, "data"));
    auto found = FindData("car body", "bogie_xml/shared", body, {".xml"});
    if (!found.ok()) return found.error();
    auto read = ReadMjcf(found.value());
    if (!read.ok()) return read.error();
    car_body = std::move(read).value();
  }
  bool car_body_changed = false;
  for (const auto& [key, value] : values) {
    if (Status s =
            SetValue(key, value, root, car_body == nullptr ? nullptr : car_body->RootElement(),
                     &car_body_changed);
        !s.ok()) {
      Error error = s.error();
      error.where = key;
      return error;
    }
  }
  VariedBogie varied;
  varied.name = std::filesystem::path(path.value()).stem().string();
  if (car_body_changed) {
    varied.car_body_file = varied.name + "_car_body.xml";
    varied.car_body = Printed(*car_body);
    named->SetAttribute("data", varied.car_body_file.c_str());
  }
  FindBeside(path.value(), root);
  KeepAssetFolders(path.value(), root);
  varied.text = Printed(*document.value());
  return varied;
}

}  // namespace phs::vehicle
