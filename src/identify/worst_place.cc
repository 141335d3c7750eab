#include "identify/worst_place.h"

#include <string>

namespace phs::identify::search {

void KeepWorstPlace(const FitProblem& problem, const FitResult& fit,
                    const hydraulics::PhsParams& params, std::vector<Candidate>* candidates) {
  constexpr double kNoise = 1.1;  // mean square over that of noise
  std::string worst;
  double most = kNoise;
  for (size_t i = 0; i < params.cylinders.size(); ++i) {
    const int channel = problem.FindOutput("load" + std::to_string(i + 1) + "_N");
    if (channel < 0) continue;
    const double ms = fit.channel_ms[static_cast<size_t>(channel)];
    if (ms > most) most = ms, worst = params.cylinders[i].name;
  }
  std::erase_if(*candidates, [&](const Candidate& c) {
    return c.shows_at_place && !c.params.targets.empty() && c.params.targets.front() != worst;
  });
}

}  // namespace phs::identify::search
