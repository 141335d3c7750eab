#include "measurement/excitation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "measurement/channel_noise.h"

namespace phs::measurement {
namespace {

struct Excitation {
  int reversals = 0;
  bool moves = false;
};

Excitation FindExcitation(const RigRun& run, const Channel& input) {
  const double noise = std::max(WhiteNoise(input.y, input.bad), Quantum(input.y) / std::sqrt(12.0));
  const double step = std::max(20 * noise, 1e-7);
  Excitation out;
  int direction = 0;
  double low = INFINITY, high = -INFINITY, turn = NAN;
  for (int i = run.First(run.estimation); i < run.Last(run.estimation); ++i) {
    const double at = input.y[static_cast<size_t>(i)];
    low = std::min(low, at), high = std::max(high, at);
    if (std::isnan(turn) || (at - turn) * direction > 0) turn = at;
    if (std::abs(at - turn) <= step) continue;
    out.reversals += direction != 0;
    direction = at > turn ? 1 : -1;
    turn = at;
  }
  out.moves = high - low >= 2 * step;
  return out;
}

}  // namespace

Status CheckExcitation(const std::vector<const RigRun*>& runs, size_t input) {
  Excitation all;
  bool asked = false;
  for (const RigRun* run : runs) {
    if (run->estimation.empty()) continue;
    const Excitation e = FindExcitation(*run, run->inputs[input]);
    asked = true, all.reversals += e.reversals, all.moves |= e.moves;
  }
  const std::string& name = runs.front()->inputs[input].name;
  const std::string& where = runs.front()->source;
  if (asked && !all.moves) {
    return Error{where, name + " does not move in the estimation window",
                 "motion well above its noise",
                 "nothing can be identified from a constant input; choose another window"};
  }
  if (asked && all.reversals < 2) {
    return Error{
        where, fmt::format("{} reverses {} times in the estimation window", name, all.reversals),
        "2 reversals or more",
        "friction and stiffness cannot be told apart, nor friction from an offset, without; "
        "choose a longer window"};
  }
  return {};
}

}  // namespace phs::measurement
