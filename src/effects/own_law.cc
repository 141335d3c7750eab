#include "effects/own_law.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <memory>
#include <set>

#include "base/words.h"
#include "effects/formula_laws.h"
#include "effects/own_states.h"
#include "effects/targets.h"

namespace phs::effects {
namespace {

using hydraulics::EffectInfo;
using hydraulics::EffectParams;
using hydraulics::Extension;
using hydraulics::ForcePlace;

/// What a place makes of a formula.
struct Place {
  const char* name;
  FormulaUnit unit;
  const char* ending;  ///< of its unit
  const char* words;
  const char* variables;
  bool has_states;
  bool of_rig;
};
constexpr Place kPlaces[] = {
    {"piston", FormulaUnit::kForce, "N", "force [N]", "xvspqtdT", true, false},
    {"mounting", FormulaUnit::kForce, "N", "force [N]", "xvpt", true, true},
    {"reading_N", FormulaUnit::kForce, "N", "force [N]", "xvpqtF", false, true},
    {"reading_m", FormulaUnit::kLength, "m", "length [m]", "xvpqtF", false, true},
    {"reading_Pa", FormulaUnit::kPressure, "Pa", "pressure [Pa]", "xvpqtF", false, true},
    {"volume", FormulaUnit::kVolume, "m3", "volume [m^3]", "p", false, false},
    {"flow", FormulaUnit::kFlow, "m3_per_s", "flow [m^3/s]", "pt", false, false},
};

const Place* FindPlace(const std::string& name) {
  for (const Place& place : kPlaces) {
    if (name == place.name) return &place;
  }
  return nullptr;
}

/// The force of a piston or beside the cylinder.
class OwnForce final : public hydraulics::ForceLaw {
 public:
  OwnForce(Formula force, OwnStates states, std::vector<std::string> names)
      : force_(std::move(force)), states_(std::move(states)), names_(std::move(names)) {}
  double Force(const ForcePlace& place) const noexcept override { return force_.Value(place); }
  std::vector<std::string> StateNames() const override { return names_; }
  void CalcRates(const ForcePlace& place, double* rate) const noexcept override {
    states_.CalcRates(place, rate);
  }
  void Advance(double h, const ForcePlace& place, double* state) const noexcept override {
    states_.Advance(h, place, state);
  }

 private:
  Formula force_;
  OwnStates states_;
  std::vector<std::string> names_;
};

class OwnLoad final : public hydraulics::LoadLaw {
 public:
  OwnLoad(Formula force, OwnStates states) : force_(std::move(force)), states_(std::move(states)) {}
  void Add(const hydraulics::LoadMotion& motion, std::vector<double>* force) const override {
    double state[OwnStates::kMost] = {}, extra[hydraulics::kMaxExtra] = {};
    for (size_t i = 0; i < force->size(); ++i) {
      ForcePlace place;
      place.time = motion.t0_s + static_cast<double>(i) * motion.step_s;
      place.piston = motion.position[i], place.speed = motion.speed[i];
      if (!motion.pressure.empty()) place.bore_rise = motion.pressure[i];
      if (motion.extra != nullptr) motion.extra->At(place.time, extra);
      place.extra = extra, place.state = state;
      (*force)[i] += force_.Value(place);
      if (states_.size() == 0 || i + 1 == force->size()) continue;
      const double way = motion.position[i + 1] - motion.position[i];
      place.speed = way / motion.step_s, place.piston += 0.5 * way;
      states_.Advance(motion.step_s, place, state);
    }
  }

 private:
  Formula force_;
  OwnStates states_;
};

/// The unit after the first "_"; "" is a plain number.
std::pair<std::string, std::string> SymbolAndUnit(const std::string& name) {
  const size_t at = name.find('_');
  if (at == std::string::npos) return {name, ""};
  return {name.substr(0, at), name.substr(at + 1)};
}

constexpr const char* kTaken[] = {"x",   "v",   "s",   "p",   "q",    "t",   "dT",  "pi",
                                  "max", "sin", "cos", "exp", "tanh", "abs", "sqrt"};

/// Everything that a law may name.
class Names {
 public:
  explicit Names(const EffectParams& effect) : effect_(effect) {}

  Status AddNumbers() {
    for (const auto& [name, value] : effect_.values) {
      std::string symbol;
      Result<Dimension> dimension = Take(name, &symbol);
      if (!dimension.ok()) return dimension.error();
      names_.numbers[symbol] = {value, dimension.value()};
    }
    return {};
  }
  Status AddState(const std::string& name) {
    std::string symbol;
    Result<Dimension> dimension = Take(name, &symbol);
    if (!dimension.ok()) return dimension.error();
    names_.states.emplace_back(symbol, dimension.value());
    return {};
  }
  /// The channels of the run, in their order; those that the law does not ask for stay unnamed.
  Status AddChannels(const std::vector<std::string>& asked, const std::vector<std::string>& there) {
    for (const std::string& name : asked) {
      if (std::find(there.begin(), there.end(), name) != there.end()) continue;
      return Error{
          "effects." + effect_.name,
          "asks for the channel " + name + ", which this run does not have",
          there.empty() ? "extra: {" + name + ": COLUMN} in a manifest of a rig" : JoinWords(there),
          DidYouMean(name, there)};
    }
    for (const std::string& name : there) {
      names_.extra.emplace_back("", Dimension());
      if (std::find(asked.begin(), asked.end(), name) == asked.end()) continue;
      std::string symbol;
      Result<Dimension> dimension = Take(name, &symbol);
      if (!dimension.ok()) return dimension.error();
      names_.extra.back() = {symbol, dimension.value()};
    }
    return {};
  }
  const FormulaNames& names() const { return names_; }

 private:
  Result<Dimension> Take(const std::string& name, std::string* symbol) {
    const std::pair<std::string, std::string> symbol_and_unit = SymbolAndUnit(name);
    const std::string& word = symbol_and_unit.first;
    const std::string& unit = symbol_and_unit.second;
    *symbol = word;
    const std::string where = "effects." + effect_.name + "." + name;
    const bool starts = !word.empty() && std::isalpha(static_cast<unsigned char>(word[0]));
    const bool plain =
        std::all_of(word.begin(), word.end(), [](unsigned char c) { return std::isalnum(c); });
    if (!starts || !plain) {
      return Error{where, "is no name", "letters and digits, then _UNIT: k_N_per_m"};
    }
    const bool taken = std::any_of(std::begin(kTaken), std::end(kTaken),
                                   [&](const char* known) { return word == known; });
    if (taken || !used_.insert(word).second) {
      return Error{where, word + " means something else already", "a name of its own"};
    }
    Result<Dimension> dimension = DimensionOf(unit);
    if (dimension.ok()) return dimension;
    return Error{where, "\"" + unit + "\" is no unit", dimension.error().allowed,
                 "a name and its unit: k_N_per_m; without \"_\" a plain number"};
  }

  const EffectParams& effect_;
  FormulaNames names_;
  std::set<std::string> used_;
};

Error At(const EffectParams& effect, const std::string& part, Error error) {
  error.where = "effects." + effect.name + "." + part + ": " + error.where;
  return error;
}

/// A formula of the law, over the variables that its place knows.
Result<Formula> ParsePart(const EffectParams& effect, const Place& place, const std::string& part,
                          const std::string& text, const FormulaNames& names,
                          const Dimension& whole, const std::string& words) {
  Result<Formula> formula = Formula::Parse(text, names, whole, words);
  if (!formula.ok()) return At(effect, part, formula.error());
  const std::string other = formula.value().VariableOtherThan(place.variables);
  if (!other.empty()) {
    return Error{"effects." + effect.name + "." + part,
                 other + " is not known at " + std::string(place.name),
                 std::string("of the variables: ") + place.variables};
  }
  return formula;
}

struct ParsedLaw {
  const Place* place = nullptr;
  std::vector<Formula> gives;  ///< one
  OwnStates states;
  std::vector<std::string> state_names;
};

Result<ParsedLaw> ParseLaw(const EffectParams& effect, const Extension& extension) {
  Result<OwnLaw> law = ParseOwnLaw(effect.formula);
  if (!law.ok()) return At(effect, "formula", law.error());
  const OwnLaw& own = law.value();
  ParsedLaw out;
  out.place = FindPlace(own.where);
  if (!own.states.empty() && !out.place->has_states) {
    return RefuseEffect(effect, "states at " + own.where, "states at piston and mounting");
  }
  if (own.states.size() > OwnStates::kMost) {
    return RefuseEffect(effect, "too many states", "at most 4");
  }
  if (!own.channels.empty() && !out.place->has_states && !out.place->of_rig) {
    return RefuseEffect(effect, "a further channel at " + own.where,
                        "channels at piston, mounting and readings");
  }
  Names names(effect);
  if (Status s = names.AddNumbers(); !s.ok()) return s.error();
  for (const auto& state : own.states) {
    if (Status s = names.AddState(state.first); !s.ok()) return s.error();
  }
  if (Status s = names.AddChannels(own.channels, extension.extra_names()); !s.ok()) {
    return s.error();
  }
  Result<Formula> gives = ParsePart(effect, *out.place, "expression", own.expression, names.names(),
                                    DimensionOf(out.place->ending).value(), out.place->words);
  if (!gives.ok()) return gives.error();
  out.gives.push_back(std::move(gives.value()));
  std::vector<Formula> rates;
  for (const auto& [name, rate] : own.states) {
    const auto [symbol, unit] = SymbolAndUnit(name);
    Dimension whole = DimensionOf(unit).value();
    whole[2] -= 1;
    Result<Formula> parsed =
        ParsePart(effect, *out.place, "states." + name, rate, names.names(), whole,
                  "rate of " + name + " [" + (unit.empty() ? "1" : unit) + "/s]");
    if (!parsed.ok()) return parsed.error();
    rates.push_back(std::move(parsed.value()));
    out.state_names.push_back(effect.name + "_" + symbol);
  }
  out.states = OwnStates(std::move(rates));
  return out;
}

Status InstallOwnLaw(const EffectParams& effect, Extension* extension) {
  Result<ParsedLaw> parsed = ParseLaw(effect, *extension);
  if (!parsed.ok()) return parsed.error();
  ParsedLaw& law = parsed.value();
  const Formula& gives = law.gives.front();
  const std::string where = law.place->name;
  if (where == "volume") return AddVolume(effect, gives, extension);
  if (where == "flow") return AddFlow(effect, gives, extension);
  if (where == "mounting") {
    extension->AddLoad(std::make_unique<OwnLoad>(gives, law.states));
    return {};
  }
  if (where != "piston") return AddReading(effect, gives, law.place->unit, extension);
  for (const int i : TargetCylinders(effect, extension->params())) {
    if (i < 0) return RefuseEffect(effect, "a force acts on cylinders, not on lines", "cylinders");
    extension->AddForce(i, std::make_unique<OwnForce>(gives, law.states, law.state_names));
  }
  return {};
}

std::string Trimmed(const std::string& text) {
  const size_t begin = text.find_first_not_of(" \t\n");
  if (begin == std::string::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\n") - begin + 1);
}

std::vector<std::string> Split(const std::string& text, char at) {
  std::vector<std::string> parts;
  for (size_t begin = 0; begin <= text.size();) {
    const size_t end = std::min(text.find(at, begin), text.size());
    parts.push_back(Trimmed(text.substr(begin, end - begin)));
    begin = end + 1;
  }
  return parts;
}

}  // namespace

const std::vector<std::string>& OwnPlaces() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> out;
    for (const Place& place : kPlaces) out.emplace_back(place.name);
    return out;
  }();
  return names;
}

std::string ToText(const OwnLaw& law) {
  std::string text = law.where + " = " + law.expression;
  for (const auto& [name, rate] : law.states) text += fmt::format("; d{}/dt = {}", name, rate);
  for (size_t i = 0; i < law.channels.size(); ++i) {
    text += (i == 0 ? "; given " : ", ") + law.channels[i];
  }
  return text;
}

Result<OwnLaw> ParseOwnLaw(const std::string& text) {
  OwnLaw law;
  for (const std::string& part : Split(text, ';')) {
    if (part.starts_with("given ")) {
      law.channels = Split(part.substr(6), ',');
      continue;
    }
    const size_t equals = part.find('=');
    const std::string left = Trimmed(part.substr(0, equals));
    const std::string right = equals == std::string::npos ? "" : Trimmed(part.substr(equals + 1));
    const bool rate = left.size() > 4 && left[0] == 'd' && left.ends_with("/dt");
    if (right.empty() || (!rate && (FindPlace(left) == nullptr || !law.where.empty()))) {
      return Error{"\"" + part + "\"", "is no part of a law",
                   "PLACE = …; dNAME_UNIT/dt = …; given CHANNEL_UNIT with a place of " +
                       JoinWords(OwnPlaces()),
                   DidYouMean(left, OwnPlaces())};
    }
    if (rate) {
      law.states.emplace_back(left.substr(1, left.size() - 4), right);
    } else {
      law.where = left, law.expression = right;
    }
  }
  if (law.where.empty()) {
    return Error{"\"" + text + "\"", "does not say where it acts",
                 "PLACE = … with a place of " + JoinWords(OwnPlaces())};
  }
  return law;
}

const hydraulics::EffectInfo& OwnLawInfo() {
  static const EffectInfo info = {
      "own", "own", "cylinders or lines", "a law that the model brings with it", {}, InstallOwnLaw,
      {},    true};
  return info;
}

bool OwnActsOnOil(const EffectParams& effect) {
  const Result<OwnLaw> law = ParseOwnLaw(effect.formula);
  return law.ok() && (law.value().where == "volume" || law.value().where == "flow");
}

bool StaysOnRig(const EffectParams& effect) {
  if (effect.formula.empty()) return false;
  const Result<OwnLaw> law = ParseOwnLaw(effect.formula);
  return law.ok() && FindPlace(law.value().where)->of_rig;
}

}  // namespace phs::effects
