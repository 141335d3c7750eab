// A scenario written back in the form that LoadScenario reads.
#include <fmt/format.h>

#include "base/data_path.h"
#include "base/numbers.h"
#include "phs_model/effects_yaml.h"
#include "phs_model/phs_model.h"
#include "vehicle/scenario_file.h"

namespace phs::vehicle {
namespace {

class Lines {
 public:
  void Text(const std::string& key, const std::string& value) {
    if (!value.empty()) out_ += fmt::format("{}: \"{}\"\n", key, Escaped(value));
  }
  void Word(const std::string& key, const std::string& value) {
    if (!value.empty()) out_ += fmt::format("{}: {}\n", key, value);
  }
  void Number(const std::string& key, double value) {
    out_ += fmt::format("{}: {}\n", key, Shortest(value));
  }
  void Raw(const std::string& text) { out_ += text; }
  const std::string& out() const { return out_; }
  static std::string Escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
      if (c == '"' || c == '\\') out += '\\';
      out += c;
    }
    return out;
  }

 private:
  std::string out_;
};

/// `key: {a: 1, b: 2}` of the numbers that are set.
void WriteMap(const std::string& key, const std::vector<std::pair<std::string, double>>& numbers,
              const std::string& first, Lines* out) {
  std::string inside = first;
  for (const auto& [name, value] : numbers) {
    inside += (inside.empty() ? "" : ", ") + name + ": " + Shortest(value);
  }
  out->Raw(key + ": {" + inside + "}\n");
}

void WriteFriction(const rail::FrictionSettings& f, Lines* out) {
  std::vector<std::pair<std::string, double>> set;
  if (f.tread >= 0) set.emplace_back("tread", f.tread);
  if (f.flange >= 0) set.emplace_back("flange", f.flange);
  if (f.falling_ratio >= 0) set.emplace_back("falling_ratio", f.falling_ratio);
  if (f.falling_rate_s_m >= 0) set.emplace_back("falling_rate_s_m", f.falling_rate_s_m);
  if (set.empty() && f.condition.empty()) return;
  WriteMap("friction", set, f.condition.empty() ? "" : "condition: " + f.condition, out);
}

void WriteFailures(const std::vector<phs_model::Failure>& failures, Lines* out) {
  if (failures.empty()) return;
  out->Raw("failures:\n");
  for (const phs_model::Failure& f : failures) {
    std::string item = "kind: " + f.kind + ", line: \"" + f.line + "\"";
    if (!f.system.empty()) item += ", system: " + f.system;
    if (phs_model::HasTime(f)) item += ", at_s: " + Shortest(f.at_s);
    if (f.kind == "line_leak") {
      item += ", conductance_m3_per_Pas: " + Shortest(f.conductance_m3_per_Pas);
    }
    if (f.kind == "air") item += ", air_m3: " + Shortest(f.air_m3);
    out->Raw("  - {" + item + "}\n");
  }
}

}  // namespace

std::string ToYaml(const Scenario& s) {
  Lines out;
  out.Text("track", Anywhere(s.track));
  out.Text("bogie", Anywhere(s.bogie));
  out.Word("vehicle", s.vehicle);
  out.Text("wheel", Anywhere(s.wheel));
  out.Text("rail", Anywhere(s.rail));
  out.Word("creep", s.creep);
  if (s.contact_fineness != 1) out.Number("contact_fineness", s.contact_fineness);
  out.Text("phs", Anywhere(s.phs));
  out.Number("speed_m_s", s.speed_m_s);
  WriteFriction(s.friction, &out);
  if (s.timestep_s > 0) out.Number("timestep_s", s.timestep_s);
  if (s.duration_s > 0) out.Number("duration_s", s.duration_s);
  out.Number("start_s_m", s.start_s_m);
  out.Number("record_interval_s", s.record_interval_s);
  if (s.running.active) {
    WriteMap("running",
             {{"drive_torque_Nm", s.running.drive_torque_Nm},
              {"block_force_N", s.running.block_force_N},
              {"block_friction", s.running.block_friction},
              {"begin_s", s.running.begin_s},
              {"ramp_s", s.running.ramp_s},
              {"end_s", s.running.end_s}},
             "", &out);
  }
  WriteFailures(s.phs_changes.failures, &out);
  if (!s.phs_changes.parameters.empty()) {
    out.Raw("phs_parameters:\n");
    for (const auto& [name, value] : s.phs_changes.parameters) out.Number("  " + name, value);
  }
  for (size_t i = 0; i < s.joints.size(); ++i) {
    const Scenario::JointChange& joint = s.joints[i];
    if (i == 0) out.Raw("joints:\n");
    std::vector<std::pair<std::string, double>> set;
    if (joint.stiffness >= 0) set.emplace_back("stiffness", joint.stiffness);
    if (joint.damping >= 0) set.emplace_back("damping", joint.damping);
    WriteMap("  " + joint.joint, set, "", &out);
  }
  out.Raw(phs_model::EffectsToYaml(s.effects));
  return out.out();
}

}  // namespace phs::vehicle
