#include <cmath>
#include <cstdlib>
#include <exception>
#include <map>
#include <sstream>
#include <string>

#include "base/yaml.h"
#include "phs_model/phs_model.h"
#include "plugin/observer.h"
#include "plugin/phs_mujoco.h"
#include "plugin/registry.h"
#include "plugin/settle.h"

namespace {

using phs::Error;
using phs::Result;
using phs::plugin::AttachOptions;

std::string& LastError() {
  thread_local std::string text;
  return text;
}

int Fail(const std::string& text) {
  LastError() = text;
  return -1;
}

int NotAttached(const std::string& function, const mjModel* m) {
  return Fail(function + ": the model is not attached" +
              (phs::plugin::WasAttached(m)
                   ? ": it was copied or saved from one that is detached; attach it"
                   : ""));
}

/// True if MuJoCo found positions, speeds or accelerations too bad to go on and reset the data.
bool WasReset(const mjData* d) {
  for (const int kind : {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC}) {
    if (d->warning[kind].number > 0) return true;
  }
  return false;
}

/// "kind:line" or "kind:line:at_s", several separated by commas.
Result<std::vector<phs::phs_model::Failure>> ParseFailures(const std::string& text) {
  std::vector<phs::phs_model::Failure> failures;
  std::stringstream items(text);
  for (std::string item; std::getline(items, item, ',');) {
    std::stringstream parts(item);
    phs::phs_model::Failure failure;
    std::string time;
    std::getline(parts, failure.kind, ':');
    std::getline(parts, failure.line, ':');
    if (std::getline(parts, time)) {
      char* rest = nullptr;
      failure.at_s = std::strtod(time.c_str(), &rest);
      if (time.empty() || *rest != '\0' || !std::isfinite(failure.at_s)) {
        return Error{"option 'failures'", phs::Quoted(time) + " is no time", "seconds", ""};
      }
    }
    failures.push_back(std::move(failure));
  }
  return failures;
}

Result<AttachOptions> ParseOptions(const std::string& text) {
  AttachOptions options;
  const std::map<std::string, std::string*> words = {
      {"track", &options.track},       {"wheel", &options.wheel_profile},
      {"rail", &options.rail_profile}, {"creep", &options.creep_law},
      {"phs", &options.phs_model},     {"friction_condition", &options.friction.condition}};
  const std::map<std::string, double*> numbers = {
      {"friction", &options.friction.tread},
      {"flange_friction", &options.friction.flange},
      {"falling_ratio", &options.friction.falling_ratio},
      {"falling_rate_s_m", &options.friction.falling_rate_s_m},
      {"speed_m_s", &options.speed_m_s},
      {"start_s_m", &options.start_s_m}};
  size_t begin = 0;
  while (begin < text.size()) {
    const size_t end = std::min(text.find(';', begin), text.size());
    const std::string item = text.substr(begin, end - begin);
    begin = end + 1;
    if (item.empty()) continue;
    const size_t equals = item.find('=');
    const std::string key = item.substr(0, equals);
    const std::string value = equals == std::string::npos ? "" : item.substr(equals + 1);
    if (key == "failures") {
      auto failures = ParseFailures(value);
      if (!failures.ok()) return failures.error();
      options.phs_changes.failures = std::move(failures).value();
    } else if (const auto word = words.find(key); word != words.end()) {
      *word->second = value;
    } else if (const auto number = numbers.find(key); number != numbers.end()) {
      char* rest = nullptr;
      *number->second = std::strtod(value.c_str(), &rest);
      if (value.empty() || *rest != '\0' || !(*number->second >= 0)) {
        return Error{"option '" + key + "'", "'" + value + "' is no number", "a number >= 0", ""};
      }
    } else {
      std::vector<std::string> known = {"failures"};
      for (const auto& [name, unused] : words) known.push_back(name);
      for (const auto& [name, unused] : numbers) known.push_back(name);
      const std::string nearest = phs::NearestWord(key, known);
      return Error{"option '" + key + "'", "is unknown",
                   "track, wheel, rail, creep, phs, friction, flange_friction, friction_condition, "
                   "falling_ratio, falling_rate_s_m, speed_m_s, start_s_m, failures",
                   nearest.empty() ? "" : "did you mean '" + nearest + "'?"};
    }
  }
  return options;
}

/// Runs `work`; no exception crosses the C border.
template <typename Work>
int Guard(Work work) {
  try {
    LastError().clear();
    return work();
  } catch (const std::exception& e) {
    return Fail(std::string("internal fault: ") + e.what());
  }
}

}  // namespace

extern "C" {

int phs_attach(mjModel* m, const char* options) {
  return Guard([&] {
    if (m == nullptr) return Fail("phs_attach: the model is NULL");
    const auto parsed = ParseOptions(options == nullptr ? "" : options);
    if (!parsed.ok()) return Fail(parsed.error().Line());
    const phs::Status status = phs::plugin::Attach(m, parsed.value());
    return status.ok() ? 0 : Fail(status.error().Line());
  });
}

void phs_detach(mjModel* m) {
  Guard([&] {
    phs::plugin::Detach(m);
    return 0;
  });
}

const char* phs_version(void) { return PHS_VERSION; }

const char* phs_last_error(void) { return LastError().c_str(); }

int phs_reset(const mjModel* m, mjData* d) {
  return Guard([&] {
    if (phs::plugin::Find(m) == nullptr) return NotAttached("phs_reset", m);
    phs::plugin::StandInFront(m);
    phs::plugin::ResetToStart(m, d);
    return 0;
  });
}

int phs_num_outputs(const mjModel* m) {
  return Guard([&] {
    const phs::plugin::Binding* binding = phs::plugin::Find(m);
    if (binding == nullptr) return NotAttached("phs_num_outputs", m);
    return static_cast<int>(phs::plugin::Observer(m, *binding).channels().size());
  });
}

const char* phs_output_name(const mjModel* m, int index) {
  thread_local std::string name;
  const char* text = nullptr;
  Guard([&] {
    const phs::plugin::Binding* binding = phs::plugin::Find(m);
    if (binding == nullptr) return NotAttached("phs_output_name", m);
    const phs::plugin::Observer observer(m, *binding);
    if (index < 0 || index >= static_cast<int>(observer.channels().size())) {
      return Fail("phs_output_name: index out of range");
    }
    name = observer.channels()[index].name;
    text = name.c_str();
    return 0;
  });
  // NOLINTNEXTLINE(clang-analyzer-cplusplus.InnerPointer): the name lives as long as its thread
  return text;
}

int phs_outputs(const mjModel* m, const mjData* d, double* values) {
  return Guard([&] {
    const phs::plugin::Binding* binding = phs::plugin::Find(m);
    if (binding == nullptr) return NotAttached("phs_outputs", m);
    if (WasReset(d)) {
      return Fail(
          "phs_outputs: the run diverged, MuJoCo reset it and went on; make the step smaller");
    }
    const std::string bypassed = phs::plugin::Bypassed(m);
    if (!bypassed.empty()) {
      return Fail("phs_outputs: " + bypassed + " (phs_reset puts the plugin in front again)");
    }
    phs::plugin::Observer(m, *binding).Observe(m, d, values);
    return 0;
  });
}

}  // extern "C"
