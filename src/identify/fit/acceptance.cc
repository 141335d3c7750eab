#include "identify/fit/acceptance.h"

namespace phs::identify {
namespace {

constexpr AcceptanceNumber kNumbers[] = {
    {"false_alarms", &Acceptance::false_alarms, 1e-12, 0.5},
    {"least_share", &Acceptance::least_share, 0, 0.99},
    {"noise_known", &Acceptance::noise_known, 1e-3, 1},
};

constexpr RulePart kParts[] = {
    {"structures", &SearchRule::structures, "the number of structures tried is paid for, 2 ln M"},
    {"cross_validation", &SearchRule::cross_validation, "it gains on parts of the record left out"},
    {"beyond_zero", &SearchRule::beyond_zero,
     "its amount is beyond zero by its interval, and not at the end of its range"},
    {"plain_first", &SearchRule::plain_first,
     "a physical cause goes before a fault of an instrument, a special case before what contains "
     "it, where they explain as much"},
    {"options", &SearchRule::options, "optional numbers of an effect are tried"},
    {"elsewhere", &SearchRule::elsewhere,
     "candidates are tried about a robust fit and with moved numbers held, too"},
    {"superfluous", &SearchRule::superfluous, "what the later ones made superfluous goes"},
    {"bends", &SearchRule::bends,
     "what another form of a stronger effect would explain for the larger part goes"},
    {"challenge", &SearchRule::challenge, "one formula may take the place of all listed effects"},
    {"names", &SearchRule::names, "a formula that is a listed effect gets its name"},
    {"formula", &SearchRule::formula, "what no effect explains is described by a formula"},
};

}  // namespace

int LeastPeriods(const Acceptance& accept) {
  constexpr int kMost = 1000;
  double harmonic = 1;
  int k = 1;
  while (k < kMost && harmonic / k >= accept.least_share) harmonic += 1.0 / ++k;
  return k;
}

std::span<const AcceptanceNumber> AcceptanceNumbers() { return kNumbers; }
std::span<const RulePart> RuleParts() { return kParts; }

}  // namespace phs::identify
