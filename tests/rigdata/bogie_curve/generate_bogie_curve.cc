// generate_bogie_curve: a measured run of a steered bogie through a curve, by equations of its own.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "truth.h"

namespace bogie_curve {
namespace {

constexpr const char* kUsage =
    "generate_bogie_curve --curve r250|r300|r550 --out RUN.csv\n"
    "                     [--pair S1002|cone] [--phs bo_bo|bo_bo_measured]\n"
    "                     [--profiles DIR] [--truth FILE.json] [--seed N] [--hide NAME=VALUE]…\n"
    "                     [--interval S] [--step S] [--exact]\n"
    "Writes what the instruments show; seals, gas, oil and speed are drawn a little off the\n"
    "declared. --exact: without instruments and as declared. DIR holds S1002.prw and UIC60.prr;\n"
    "cone: a cone of 0.15 on a head of one arc of 100 mm.\n"
    "What can be hidden:\n";

struct Options {
  std::string curve, pair = "S1002", phs = "bo_bo", profiles, out, truth, command;
  uint64_t seed = 1;
  std::vector<std::pair<std::string, double>> hide;
  RunWish wish;
  bool exact = false;
};

double ToNumber(const std::string& option, const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0') {
    throw std::invalid_argument(option + ": '" + text + "' is no number");
  }
  return value;
}

void TakeHidden(const std::string& text, Options* o) {
  const size_t equals = text.find('=');
  if (equals == std::string::npos) throw std::invalid_argument("--hide wants NAME=VALUE");
  const std::string name = text.substr(0, equals);
  o->hide.emplace_back(name, ToNumber("--hide " + name, text.substr(equals + 1)));
}

Options Parse(int argc, char** argv) {
  Options o;
  o.command = "generate_bogie_curve";
  for (int i = 1; i < argc; ++i) {
    const std::string key = argv[i];
    // Where files lie is nothing that decides what is in them.
    const bool place = key == "--profiles" || key == "--out" || key == "--truth";
    if (key == "--exact") {
      o.exact = true;
      continue;
    }
    if (i + 1 >= argc) throw std::invalid_argument(key + " is unknown or needs a value");
    const std::string value = argv[++i];
    if (!place) o.command += " " + key + " " + value;
    if (key == "--curve") {
      o.curve = value;
    } else if (key == "--pair") {
      o.pair = value;
    } else if (key == "--phs") {
      o.phs = value;
    } else if (key == "--profiles") {
      o.profiles = value;
    } else if (key == "--out") {
      o.out = value;
    } else if (key == "--truth") {
      o.truth = value;
    } else if (key == "--seed") {
      o.seed = static_cast<uint64_t>(ToNumber(key, value));
    } else if (key == "--interval") {
      o.wish.interval = ToNumber(key, value);
    } else if (key == "--step") {
      o.wish.step = ToNumber(key, value);
    } else if (key == "--hide") {
      TakeHidden(value, &o);
    } else {
      throw std::invalid_argument("unknown option " + key);
    }
  }
  if (o.curve.empty() || o.out.empty()) {
    throw std::invalid_argument("--curve and --out are needed");
  }
  if (o.pair != "cone" && (o.pair != "S1002" || o.profiles.empty())) {
    throw std::invalid_argument("--pair is S1002, which needs --profiles, or cone");
  }
  if (o.phs != "bo_bo" && o.phs != "bo_bo_measured") {
    throw std::invalid_argument("--phs is bo_bo or bo_bo_measured");
  }
  if (!(o.wish.step > 0) || !(o.wish.interval >= o.wish.step)) {
    throw std::invalid_argument("--step must be > 0 and --interval no shorter");
  }
  return o;
}

void WriteText(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (!file) throw std::runtime_error("cannot write " + path);
}

int Run(const Options& o) {
  Truth truth = DeclaredTruth(o.curve);
  truth.pair = o.pair;
  truth.phs = o.phs;
  if (o.phs == "bo_bo_measured") truth.steering = SteeringNumbers::Measured();
  if (!o.exact) DrawOffDeclared(o.seed, &truth);
  for (const auto& [name, value] : o.hide) Hide(name, value, &truth);
  const TrackLine track(truth.design);
  const BogieMotion bogie = MakeBogie(truth, track, o.profiles);
  RunWish wish = o.wish;
  wish.last_s = track.Length() - 5;
  MeasuredRun run = Measure(bogie, wish);
  if (o.exact) {
    for (double& q : run.quantum) q *= 1e-3;
  } else {
    AddInstruments(o.seed, &run);
  }
  WriteText(o.out, Csv(run));
  if (!o.truth.empty()) WriteText(o.truth, TruthJson(truth, o.command));
  return 0;
}

}  // namespace
}  // namespace bogie_curve

int main(int argc, char** argv) {
  try {
    return bogie_curve::Run(bogie_curve::Parse(argc, argv));
  } catch (const std::invalid_argument& usage) {
    std::fprintf(stderr, "generate_bogie_curve: %s\n%s", usage.what(), bogie_curve::kUsage);
    for (const auto& h : bogie_curve::HideableList()) {
      std::fprintf(stderr, "  %-14s %s\n", h.name, h.text);
    }
    return 2;
  } catch (const std::exception& failure) {
    std::fprintf(stderr, "generate_bogie_curve: %s\n", failure.what());
    return 1;
  }
}
