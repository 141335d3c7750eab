// Writing model files (docs/phs_models.md).
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "hydraulics/phs_numbers.h"
#include "phs_model/effects_yaml.h"
#include "phs_model/keys.h"
#include "phs_model/phs_model.h"

namespace phs::phs_model {

using hydraulics::CylinderParams;
using hydraulics::EffectParams;
using hydraulics::FrictionCurve;
using hydraulics::FrictionParams;
using hydraulics::LineParams;
using hydraulics::PhsParams;

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

/// The numbers of `part` that stand in the block `block` ("": beside the blocks).
template <typename Part>
void WriteNumbers(Writer* w, int indent, const std::string& block, const Part& part) {
  Part copy = part;
  for (const auto& row : hydraulics::Numbers<Part>()) {
    const std::string& where = row.info.where;
    const size_t dot = where.find('.');
    const bool inside = dot != std::string::npos;
    if ((inside ? where.substr(0, dot) : "") != block) continue;
    if (row.written != nullptr && !row.written(part)) continue;
    w->Num(indent, inside ? where.substr(dot + 1) : where, row.of(copy));
  }
}

void WriteFriction(Writer* w, const PhsParams& params) {
  const FrictionParams& f = params.friction;
  w->Open(0, "friction");
  w->Raw(2, "model", kModels[static_cast<int>(f.model)]);
  w->Raw(2, "curve", kCurves[static_cast<int>(f.curve)]);
  if (f.curve == FrictionCurve::kTable) {
    w->Nums(2, "speed_m_s", f.speed_m_s);
    w->Nums(2, "force_N", f.force_N);
  }
  WriteNumbers(w, 2, "friction", params);
}

void WriteCylinder(Writer* w, const CylinderParams& c) {
  w->out() += "  - name: \"" + c.name + "\"\n";
  w->Text(4, "bore_line", c.bore_line);
  w->Text(4, "rod_line", c.rod_line);
  WriteNumbers(w, 4, "", c);
  w->Open(4, "end_stop");
  WriteNumbers(w, 6, "end_stop", c);
}

void WriteLine(Writer* w, const LineParams& l) {
  w->out() += "  - name: \"" + l.name + "\"\n";
  WriteNumbers(w, 4, "", l);
  for (const auto& [block, gas] :
       {std::pair{"reservoir", &l.reservoir}, std::pair{"accumulator", &l.accumulator}}) {
    w->Open(4, block);
    w->Raw(6, "law", gas->law->name);
    WriteNumbers(w, 6, block, l);
  }
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
  WriteNumbers(&w, 0, "", params);
  w.Raw(0, "balance", kBalances[static_cast<int>(params.balance)]);
  w.Open(0, "cylinders");
  for (const CylinderParams& c : params.cylinders) WriteCylinder(&w, c);
  if (!params.lines.empty()) w.Open(0, "lines");
  for (const LineParams& l : params.lines) WriteLine(&w, l);
  WriteFriction(&w, params);
  w.Open(0, "element");
  WriteNumbers(&w, 2, "element", params);
  WriteEffects(&w, params.effects);
  return w.out();
}

}  // namespace phs::phs_model
