// Writing model files (docs/phs_models.md).
#include <cstdio>
#include <cstdlib>

#include "hydraulics/effects_yaml.h"
#include "hydraulics/phs_params.h"
#include "hydraulics/phs_params_words.h"

namespace phs::hydraulics {
namespace {

class Writer {
 public:
  void Text(int indent, const std::string& key, const std::string& value) {
    if (!value.empty()) Raw(indent, key, "\"" + Escaped(value) + "\"");
  }
  void Num(int indent, const std::string& key, double value) { Raw(indent, key, Shortest(value)); }
  void Raw(int indent, const std::string& key, const std::string& value) {
    out_ += std::string(indent, ' ') + key + ": " + value + "\n";
  }
  void Open(int indent, const std::string& key) { out_ += std::string(indent, ' ') + key + ":\n"; }
  void Nums(int indent, const std::string& key, const std::vector<double>& values) {
    std::string list;
    for (double v : values) list += (list.empty() ? "" : ", ") + Shortest(v);
    Raw(indent, key, "[" + list + "]");
  }
  std::string& out() { return out_; }

 private:
  static std::string Escaped(const std::string& text) {
    std::string out;
    for (char c : text) {
      if (c == '"' || c == '\\') out += '\\';
      if (c == '\n') {
        out += "\\n";
      } else {
        out += c;
      }
    }
    return out;
  }
  static std::string Shortest(double value) {
    char text[40];
    for (int digits = 6; digits <= 17; ++digits) {
      std::snprintf(text, sizeof text, "%.*g", digits, value);
      if (std::strtod(text, nullptr) == value) break;
    }
    return text;
  }
  std::string out_;
};

void WriteGas(Writer* w, int indent, const GasChargeParams& gas) {
  w->Raw(indent, "law", gas.law->name);
  w->Num(indent, "volume_m3", gas.volume_m3);
  w->Num(indent, "polytropic_exponent", gas.polytropic_exponent);
  w->Num(indent, "thermal_time_s", gas.thermal_time_s);
  w->Num(indent, "min_gas_volume_m3", gas.min_gas_volume_m3);
}

void WriteFriction(Writer* w, const FrictionParams& f) {
  w->Open(0, "friction");
  w->Raw(2, "model", kModels[static_cast<int>(f.model)]);
  w->Raw(2, "curve", kCurves[static_cast<int>(f.curve)]);
  w->Num(2, "scale", f.scale);
  if (f.curve == FrictionCurve::kTable) {
    w->Nums(2, "speed_m_s", f.speed_m_s);
    w->Nums(2, "force_N", f.force_N);
  } else {
    w->Num(2, "coulomb_extension_N", f.coulomb_extension_N);
    w->Num(2, "coulomb_retraction_N", f.coulomb_retraction_N);
    w->Num(2, "breakaway_extension_N", f.breakaway_extension_N);
    w->Num(2, "breakaway_retraction_N", f.breakaway_retraction_N);
    w->Num(2, "stribeck_speed_m_s", f.stribeck_speed_m_s);
    w->Num(2, "viscous_extension_Ns_per_m", f.viscous_extension_Ns_per_m);
    w->Num(2, "viscous_retraction_Ns_per_m", f.viscous_retraction_Ns_per_m);
    w->Num(2, "ramp_speed_m_s", f.ramp_speed_m_s);
  }
  w->Num(2, "stiffness_N_per_m", f.stiffness_N_per_m);
  w->Num(2, "damping_Ns_per_m", f.damping_Ns_per_m);
  w->Num(2, "breakaway_ratio", f.breakaway_ratio);
}

void WriteCylinder(Writer* w, const CylinderParams& c) {
  w->out() += "  - name: \"" + c.name + "\"\n";
  w->Text(4, "bore_line", c.bore_line);
  w->Text(4, "rod_line", c.rod_line);
  w->Num(4, "bore_m", c.bore_m);
  w->Num(4, "rod_m", c.rod_m);
  w->Open(4, "end_stop");
  w->Num(6, "clearance_m", c.end_stop.clearance_m);
  w->Num(6, "stiffness_N_per_m", c.end_stop.stiffness_N_per_m);
  w->Num(6, "damping_Ns_per_m", c.end_stop.damping_Ns_per_m);
  w->Num(6, "transition_m", c.end_stop.transition_m);
}

void WriteLine(Writer* w, const LineParams& l) {
  w->out() += "  - name: \"" + l.name + "\"\n";
  w->Num(4, "static_pressure_Pa", l.static_pressure_Pa);
  w->Num(4, "oil_volume_m3", l.oil_volume_m3);
  w->Num(4, "bulk_modulus_Pa", l.bulk_modulus_Pa);
  w->Num(4, "bulk_modulus_slope", l.bulk_modulus_slope);
  w->Num(4, "free_air_m3", l.free_air_m3);
  w->Open(4, "reservoir");
  WriteGas(w, 6, l.reservoir);
  w->Num(6, "gas_volume_m3", l.gas_volume_m3);
  w->Open(4, "accumulator");
  WriteGas(w, 6, l.accumulator);
  w->Num(6, "precharge_Pa", l.accumulator_precharge_Pa);
}

void WriteEffects(Writer* w, const std::vector<EffectParams>& effects) {
  if (effects.empty()) return;
  w->Open(0, "effects");
  for (const EffectParams& effect : effects) {
    if (effect.values.empty() && effect.targets.empty() && effect.formula.empty()) {
      w->Raw(2, effect.name, "{}");
      continue;
    }
    w->Open(2, effect.name);
    if (!effect.targets.empty()) {
      std::string list;
      for (const std::string& t : effect.targets) {
        if (!list.empty()) list += ", ";
        list.append("\"").append(t).append("\"");
      }
      w->Raw(4, "targets", "[" + list + "]");
    }
    w->Text(4, "formula", effect.formula);
    for (const auto& [key, value] : effect.values) w->Num(4, key, value);
  }
}

}  // namespace

std::string EffectsToYaml(const std::vector<EffectParams>& effects) {
  Writer w;
  WriteEffects(&w, effects);
  return w.out();
}

std::string ToYaml(const PhsParams& params) {
  Writer w;
  w.Text(0, "name", params.name);
  w.Text(0, "description", params.description);
  w.Text(0, "source", params.source);
  w.Num(0, "temperature_K", params.temperature_K);
  w.Raw(0, "balance", kBalances[static_cast<int>(params.balance)]);
  w.Open(0, "cylinders");
  for (const CylinderParams& c : params.cylinders) WriteCylinder(&w, c);
  if (!params.lines.empty()) w.Open(0, "lines");
  for (const LineParams& l : params.lines) WriteLine(&w, l);
  WriteFriction(&w, params.friction);
  w.Open(0, "element");
  w.Num(2, "mass_kg", params.element.mass_kg);
  w.Num(2, "stiffness_N_per_m", params.element.stiffness_N_per_m);
  w.Num(2, "pressure_area_m2", params.element.pressure_area_m2);
  w.Num(2, "offset_N", params.element.offset_N);
  WriteEffects(&w, params.effects);
  return w.out();
}

}  // namespace phs::hydraulics
