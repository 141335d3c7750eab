#include "report/assessed_quantities.h"

namespace phs::report {
namespace {

constexpr AssessedName kNames[] = {
    {"sum_Y_N", "sum Y, 2 m mean, 99.85 %", "Track-shifting force ΣY, mean over 2 m, 99.85 %", "kN",
     1e-3, 1},
    {"Y_over_Q", "Y/Q, 2 m mean, 99.85 %", "Y/Q, mean over 2 m, 99.85 %", "-", 1, 3},
    {"Q_N", "Q, 99.85 %", "Wheel load Q, 99.85 %", "kN", 1e-3, 1},
    {"Y_qst_N", "Y, quasi-static", "Guiding force Y, quasi-static", "kN", 1e-3, 1},
    {"Q_qst_N", "Q, quasi-static", "Wheel load Q, quasi-static", "kN", 1e-3, 1},
    {"unloading", "wheel unloading (own limit)",
     "Wheel unloading 1 − Q/Q0, 99.85 % (own limit: lifted)", "-", 1, 3},
    {"sum_Y_rms_N", "sum Y, instability, rms", "ΣY in the band of hunting, rms over 100 m", "kN",
     1e-3, 1},
};

}  // namespace

std::span<const AssessedName> AssessedNames() { return kNames; }

}  // namespace phs::report
