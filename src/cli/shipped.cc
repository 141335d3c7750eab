#include "cli/shipped.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "base/data_path.h"
#include "effects/catalogue.h"
#include "measurement/manifest.h"
#include "vehicle/running_effects.h"

namespace phs::cli {
namespace {

std::string ReadText(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<ShippedItem> ItemsOf(const std::string& folder, const std::string& extension) {
  std::vector<ShippedItem> items;
  for (const std::string& name : ListData(folder, {extension})) {
    const auto path = FindData(folder, folder, name, {extension});
    if (path.ok()) items.push_back({name, FirstSentence(path.value()), path.value()});
  }
  return items;
}

std::vector<ShippedItem> Profiles() {
  std::vector<ShippedItem> items = ItemsOf("models/profiles", ".prw");
  for (ShippedItem& item : items) item.text = "wheel profile";
  for (ShippedItem& item : ItemsOf("models/profiles", ".prr")) {
    item.text = "rail profile";
    items.push_back(std::move(item));
  }
  return items;
}

std::vector<ShippedItem> Rigs() {
  std::vector<ShippedItem> items;
  for (const std::string& name : measurement::ListManifests()) {
    const auto path = measurement::FindManifest(name);
    if (path.ok()) items.push_back({name, FirstSentence(path.value()), path.value()});
  }
  return items;
}

/// Effects of the PHS and those of wheel and track.
std::vector<hydraulics::EffectInfo> AllEffects() {
  std::vector<hydraulics::EffectInfo> all = effects::Catalogue().effects();
  for (const vehicle::RunningEffect& effect : vehicle::RunningEffects()) {
    all.push_back(effect.info);
  }
  return all;
}

std::vector<ShippedItem> Effects() {
  std::vector<ShippedItem> items;
  for (const auto& info : AllEffects()) items.push_back({info.name, info.text, ""});
  return items;
}

constexpr ShippedKind kShippedKinds[] = {
    {"bogies", "for --bogie and `bogie:` of a scenario",
     [] { return ItemsOf("bogie_xml", ".xml"); }},
    {"tracks", "for --track and `track:`", [] { return ItemsOf("models/tracks", ".yaml"); }},
    {"profiles", "for `wheel:` and `rail:`", &Profiles},
    {"phs", "PHS models, for --phs, `phs:` and `model:`",
     [] { return ItemsOf("models/phs", ".yaml"); }},
    {"effects", "what a real PHS, wheel or track has beside, for `effects:`", &Effects},
    {"scenarios", "for simulate, compare, sweep, alarms, view and video",
     [] { return ItemsOf("models/scenarios", ".yaml"); }},
    {"rigs", "manifests, for rig and identify", &Rigs},
    {"studies", "for study", [] { return ItemsOf("models/studies", ".yaml"); }},
    {"sweeps", "for sweep and study", [] { return ItemsOf("models/sweeps", ".yaml"); }},
};

/// `text` up to the end of its first sentence, spaces made single.
std::string Sentence(const std::string& text) {
  std::string sentence;
  for (size_t i = 0; i < text.size(); ++i) {
    const bool space = std::isspace(static_cast<unsigned char>(text[i])) != 0;
    if (space && (sentence.empty() || sentence.back() == ' ')) continue;
    sentence += space ? ' ' : text[i];
    const bool ends = i + 1 == text.size() || std::isspace(static_cast<unsigned char>(text[i + 1]));
    // "T. P. Löwe": a point after a single letter ends nothing.
    const size_t n = sentence.size();
    const bool initial = n >= 2 && std::isupper(static_cast<unsigned char>(sentence[n - 2])) &&
                         (n == 2 || sentence[n - 3] == ' ');
    if (text[i] == '.' && ends && !initial) break;
  }
  while (!sentence.empty() && (sentence.back() == ' ' || sentence.back() == '.')) {
    sentence.pop_back();
  }
  return sentence;
}

/// The comment lines ("# …") that a file begins with.
std::string LeadingComment(const std::string& text) {
  std::string comment;
  size_t at = 0;
  while (at < text.size() && text[at] == '#') {
    const size_t end = std::min(text.find('\n', at), text.size());
    const std::string line = text.substr(at + 1, end - at - 1);
    if (line.find("yaml-language-server:") == std::string::npos) comment += line + " ";
    at = end + 1;
  }
  return comment;
}

}  // namespace

std::span<const ShippedKind> ShippedKinds() { return kShippedKinds; }

std::vector<std::string> ShippedKindNames() {
  std::vector<std::string> names;
  for (const ShippedKind& kind : kShippedKinds) names.push_back(kind.name);
  return names;
}

std::string FirstSentence(const std::string& path) {
  const std::string text = ReadText(path);
  for (const std::string key : {"\ndescription: ", "\nquestion: "}) {
    const size_t at = text.find(key);
    if (at == std::string::npos) continue;
    const size_t begin = at + key.size();
    return Sentence(text.substr(begin, text.find('\n', begin) - begin));
  }
  if (const size_t at = text.find("<!--"); at != std::string::npos) {
    return Sentence(text.substr(at + 4, text.find("-->", at) - at - 4));
  }
  return Sentence(LeadingComment(text));
}

std::string ShownText(const ShippedItem& item) {
  if (!item.path.empty()) return fmt::format("# {}\n{}", item.path, ReadText(item.path));
  for (const auto& info : AllEffects()) {
    if (info.name != item.name) continue;
    std::string text = fmt::format("{}: {}\n", info.name, info.text);
    if (!info.targets.empty()) text += fmt::format("acts on {}\n", info.targets);
    for (const auto& p : info.parameters) {
      text += fmt::format("  {:32} {:8} default {:g}, allowed {:g} … {:g}: {}\n", p.name, p.unit,
                          p.otherwise, p.min, p.max, p.text);
    }
    return text;
  }
  return "";
}

}  // namespace phs::cli
