#include "sweep/study_inputs.h"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include "base/data_path.h"
#include "base/numbers.h"
#include "base/origin.h"
#include "base/result_dir.h"
#include "base/sha256.h"
#include "base/yaml_document.h"
#include "phs_model/phs_model.h"

namespace phs::sweep {
namespace {

namespace fs = std::filesystem;
using Folders = std::vector<fs::path>;

constexpr char kInput[] = "input ";
constexpr char kVersion[] = "program " PHS_VERSION "\n";
constexpr std::size_t kLongestName = 4096;

/// What a run reads when its files name nothing else.
const std::vector<std::string>& DefaultNames() {
  static const std::vector<std::string> names = {
      "phs", "straight", "S1002", "UIC60", phs_model::kDefaultModel, "settings", "locomotive_body"};
  return names;
}

struct Shelf {
  const char* folder;
  std::vector<std::string> extensions;
};
const std::vector<Shelf>& Shelves() {
  static const std::vector<Shelf> shelves = {
      {"models/tracks", {".yaml"}}, {"models/phs", {".yaml"}},
      {"models/rigs", {".yaml"}},   {"models/profiles", {".prw", ".prr", ".yaml", ".csv"}},
      {"bogie_xml", {".xml"}},      {"bogie_xml/shared", {".xml"}}};
  return shelves;
}

/// Values of a YAML tree.
void CollectTexts(const YAML::Node& node, std::vector<std::string>* texts) {
  if (node.IsScalar()) {
    texts->push_back(node.Scalar());
  } else if (node.IsSequence()) {
    for (const auto& item : node) CollectTexts(item, texts);
  } else if (node.IsMap()) {
    for (const auto& item : node) CollectTexts(item.second, texts);
  }
}

/// What stands in quotes: values of attributes.
std::vector<std::string> QuotedTexts(const std::string& text) {
  std::vector<std::string> texts;
  for (std::size_t at = 0; (at = text.find_first_of("\"'", at)) != std::string::npos;) {
    const std::size_t end = text.find(text[at], at + 1);
    if (end == std::string::npos) break;
    texts.push_back(text.substr(at + 1, end - at - 1));
    at = end + 1;
  }
  return texts;
}

std::vector<std::string> TextsOf(const fs::path& path, const std::string& text) {
  std::vector<std::string> texts;
  if (path.extension() == ".xml") return QuotedTexts(text);
  if (path.extension() != ".yaml") return texts;
  const auto document = ParseYamlDocument(text, path.string());
  if (document.ok()) CollectTexts(document.value(), &texts);
  return texts;
}

class Finder {
 public:
  Finder() {
    for (const Shelf& shelf : Shelves()) {
      for (const std::string& name : ListData(shelf.folder, shelf.extensions)) {
        on_shelves_[name].push_back(&shelf);
      }
    }
  }

  /// Follows a text that may name a file: "x", "x@y", a path.
  void Follow(const std::string& text, const Folders& folders) {
    if (text.empty() || text.size() > kLongestName || ParseNumber(text)) return;
    if (const std::size_t at = text.find('@'); at != std::string::npos) {
      Follow(text.substr(0, at), folders);
      Follow(text.substr(at + 1), folders);
    }
    for (const fs::path& folder : folders) {
      for (const char* ending : {"", ".yaml", ".xml"}) Take(folder / (text + ending), folders);
    }
    const auto shelves = on_shelves_.find(fs::path(text).stem().string());
    if (shelves == on_shelves_.end()) return;
    for (const Shelf* shelf : shelves->second) {
      const auto path = FindData("", shelf->folder, text, shelf->extensions);
      if (path.ok()) Take(path.value(), folders);
    }
  }

  const std::set<std::string>& found() const { return found_; }

 private:
  void Take(const fs::path& path, Folders folders) {
    std::error_code fault;
    if (!fs::is_regular_file(path, fault)) return;
    const fs::path whole = fs::weakly_canonical(path, fault);
    if (fault || !found_.insert(whole.string()).second) return;
    const auto text = ReadFile(whole.string());
    if (!text.ok()) return;
    const std::vector<std::string> texts = TextsOf(whole, text.value());
    folders.push_back(whole.parent_path());
    for (const std::string& one : texts) {  // meshdir, texturedir
      if (one.empty() || one.size() > kLongestName) continue;
      if (fs::is_directory(whole.parent_path() / one, fault)) {
        folders.push_back(whole.parent_path() / one);
      }
    }
    std::sort(folders.begin(), folders.end());
    folders.erase(std::unique(folders.begin(), folders.end()), folders.end());
    for (const std::string& one : texts) Follow(one, folders);
  }

  std::map<std::string, std::vector<const Shelf*>> on_shelves_;
  std::set<std::string> found_;
};

/// "SHA256 PATH"; a file that cannot be read has no digest.
std::string InputLine(const std::string& path) {
  const auto text = ReadFile(path);
  if (text.ok()) NoteInput(path, text.value());
  return (text.ok() ? Sha256(text.value()) : "unreadable") + " " + path;
}

}  // namespace

std::vector<std::string> InputFiles(const Study& study) {
  Finder finder;
  std::error_code none;
  const Folders folders = {fs::current_path(none), fs::absolute(study.path, none).parent_path()};
  finder.Follow(fs::absolute(study.path, none).string(), {fs::path("/")});
  for (const std::string& name : DefaultNames()) finder.Follow(name, {});
  for (const StudyCase& c : study.cases) {
    finder.Follow(fs::absolute(c.base, none).string(), folders);
    if (c.subject->inputs == nullptr) continue;
    for (const std::string& file : c.subject->inputs(c.base)) {
      finder.Follow(fs::absolute(file, none).string(), folders);
    }
  }
  // Values of axes may name files too, from the place of the scenario or manifest.
  Folders places = folders;
  for (const StudyCase& c : study.cases) places.push_back(fs::absolute(c.base).parent_path());
  std::set<std::string> values;
  for (const auto& run : study.runs) values.insert(run.begin(), run.end());
  for (const StudyCase& c : study.cases) {
    for (const auto& [key, value] : c.set) values.insert(value);
  }
  for (const std::string& value : values) finder.Follow(value, places);
  return {finder.found().begin(), finder.found().end()};
}

std::string PlanText(const Study& study) {
  std::string text = kVersion;
  for (const std::string& path : InputFiles(study)) text += kInput + InputLine(path) + "\n";
  text += "\n# study\n" + study.text + "\n# runs\n";
  for (const auto& run : study.runs) text += fmt::format("{}\n", fmt::join(run, ","));
  return text;
}

Status CheckInputs(const std::string& plan_text) {
  std::istringstream lines(plan_text);
  for (std::string line; std::getline(lines, line) && !line.empty();) {
    if (!line.starts_with(kInput)) continue;
    const std::string was = line.substr(sizeof kInput - 1);
    const std::string path = was.substr(was.find(' ') + 1);
    if (was == InputLine(path)) continue;
    return Error{path, "has changed since the sweep was begun: its runs would be mixed", "",
                 "put it back and --resume, or --force starts anew"};
  }
  return {};
}

}  // namespace phs::sweep
