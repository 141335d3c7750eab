#include "set_writer.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace rigdata {
namespace {

using Json = nlohmann::ordered_json;

void WriteText(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw std::runtime_error("cannot write " + path);
}

std::string Csv(const Record& record) {
  std::string text = "t_s";
  for (const char* name : kChannelNames) text += std::string(",") + name;
  text += '\n';
  char line[160];
  for (size_t i = 0; i < record.size(); ++i) {
    const auto& c = record.channel;
    std::snprintf(line, sizeof line, "%.3f,%.8f,%.8f,%.3f,%.1f,%.1f\n", record.t[i],
                  c[kActuator][i], c[kPiston][i], c[kLoad][i], c[kPBore][i], c[kPRod][i]);
    text += line;
  }
  return text;
}

std::string Manifest(const RigSet& set) {
  char text[400];
  std::snprintf(text, sizeof text,
                "rig: quarter\nmodel: quarter_setup2\ndata: run.csv\n"
                "estimation: [%.1f, %.1f]\nvalidation: [%.1f, %.1f]\n",
                set.estimation.begin, set.estimation.end, set.validation.begin, set.validation.end);
  return text;
}

// What makes the set again; a motion from a file is not in it.
std::string Command(const SetWish& wish) {
  std::string names, grades;
  for (const EffectWish& e : wish.effects) {
    names += (names.empty() ? "" : "+") + e.name;
    grades +=
        std::string(grades.empty() ? "" : "+") + (e.grade == Grade::kStrong ? "strong" : "weak");
  }
  return "generate_rig_data --effect " + (names.empty() ? "none" : names) +
         (grades.empty() ? "" : " --grade " + grades) + " --seed " + std::to_string(wish.seed);
}

Json PerChannel(const ChannelNumbers& numbers) {
  Json json;
  for (const Channel c : {kPiston, kLoad, kPBore, kPRod}) json[kChannelNames[c]] = numbers[c];
  return json;
}

}  // namespace

std::string TruthJson(const RigSet& set) {
  Json json;
  if (set.wish.motion.position.empty()) json["command"] = Command(set.wish);
  json["rig"] = "quarter";
  json["seed"] = set.wish.seed;
  json["effects"] = Json::array();
  for (const HiddenTruth& h : set.hidden) {
    Json numbers = Json::object();
    for (const auto& [name, value] : h.numbers) numbers[name] = value;
    json["effects"].push_back({{"name", h.name},
                               {"listed", h.listed},
                               {"grade", h.grade == Grade::kStrong ? "strong" : "weak"},
                               {"form", h.form},
                               {"size_over_noise", h.size_over_noise},
                               {"parameters", numbers}});
  }
  json["factors_on_declared"] = {{"oil_compliance_bore", set.base.oil_bore},
                                 {"gas_volume_bore", set.base.gas_bore},
                                 {"oil_compliance_rod", set.base.oil_rod},
                                 {"gas_volume_rod", set.base.gas_rod},
                                 {"friction", set.base.friction}};
  for (int c = 0; c < kChannels; ++c) {
    const NoiseParams& n = set.noise[c];
    json["noise"][kChannelNames[c]] = {{"white", n.white},     {"coloured", n.coloured},
                                       {"tau_s", n.tau},       {"hum", n.hum},
                                       {"quantum", n.quantum}, {"level", NoiseLevel(n)}};
  }
  json["validation_rmse"] = {{"true_model", PerChannel(set.floor)},
                             {"true_model_true_motion", PerChannel(set.noise_only)},
                             {"declared_refit", PerChannel(set.declared)}};
  return json.dump(1) + "\n";
}

void WriteSet(const RigSet& set, const std::string& folder, const std::string& truth_path) {
  std::filesystem::create_directories(folder);
  const auto truth_folder = std::filesystem::path(truth_path).parent_path();
  if (!truth_folder.empty()) std::filesystem::create_directories(truth_folder);
  WriteText(folder + "/run.csv", Csv(set.record));
  WriteText(folder + "/MANIFEST.yaml", Manifest(set));
  // By another name first: a truth that is there belongs to a whole set.
  WriteText(truth_path + ".part", TruthJson(set));
  std::filesystem::rename(truth_path + ".part", truth_path);
}

}  // namespace rigdata
