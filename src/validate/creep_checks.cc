// Creep forces on given Hertz ellipses beside CONTACT, and FASTSIM beside its own printed values.
#include <cmath>

#include "base/table.h"
#include "rail/creep_cases.h"
#include "rail/creep_law.h"
#include "validate/check_groups.h"

namespace phs::validate {
namespace {

constexpr char kContactSource[] =
    "CONTACT on a 40 x 40 grid, 141 cases (models/reference/hertz_creep_table.csv)";

Result<double> RmsOverSliding(const Table& cases, const std::string& method,
                              const std::string& column) {
  const auto ours = rail::CalcCreepCases(cases, method);
  if (!ours.ok()) return ours.error();
  const auto fx = ours.value().Column("Fx_N"), fy = ours.value().Column("Fy_N");
  const auto rx = cases.Column("Fx_" + column + "_N"), ry = cases.Column("Fy_" + column + "_N");
  const auto mu = cases.Column("mu"), normal = cases.Column("FN_N");
  for (const auto* c : {&fx, &fy, &rx, &ry, &mu, &normal}) {
    if (!c->ok()) return c->error();
  }
  double sum = 0;
  for (std::size_t i = 0; i < fx.value().size(); ++i) {
    const double error = std::hypot(fx.value()[i] - rx.value()[i], fy.value()[i] - ry.value()[i]);
    sum += std::pow(error / (mu.value()[i] * normal.value()[i]), 2);
  }
  return std::sqrt(sum / cases.num_rows());
}

struct LawClaim {
  const char* what;
  const char* method;
  const char* column;
  double tolerance;
};

}  // namespace

Status AddCreepChecks(Checks* checks) {
  const auto path = ReferenceFile("hertz_creep_table.csv");
  if (!path.ok()) return path.error();
  const auto cases = ReadCsv(path.value());
  if (!cases.ok()) return cases.error();
  // The simplified theory itself stands 2-4 % of mu N off the exact one: the tolerance says how far
  // each law may be used, not how well it is programmed; the last rows say that.
  const LawClaim claims[] = {
      {"FASTSIM against CONTACT, rms of force error over mu N", "fastsim", "CONTACT", 0.04},
      {"table of FASTSIM against CONTACT, the same", "kalker_table", "CONTACT", 0.04},
      {"FASTSIM against another FASTSIM, the same", "fastsim", "FASTSIM3L_par", 0.005},
      {"Polach against its closed form, the same", "polach", "Polach1999", 0.01},
  };
  for (const LawClaim& claim : claims) {
    const auto rms = RmsOverSliding(cases.value(), claim.method, claim.column);
    if (!rms.ok()) return rms.error();
    checks->push_back({.group = {},
                       .what = claim.what,
                       .unit = "-",
                       .ours = rms.value(),
                       .reference = 0,
                       .tolerance = claim.tolerance,
                       .claim = Claim::kAtMost,
                       .source = kContactSource,
                       .skipped = {}});
  }
  return {};
}

}  // namespace phs::validate
