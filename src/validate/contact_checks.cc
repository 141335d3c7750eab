// Wheel-rail contact beside CONTACT's printed results, the closed theories of Hertz and Carter.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "base/data_path.h"
#include "base/numbers.h"
#include "base/table.h"
#include "rail/carter.h"
#include "rail/contact_reference.h"
#include "rail/creep_law.h"
#include "rail/fastsim.h"
#include "rail/hertz.h"
#include "rail/wheelset_cases.h"
#include "validate/check_groups.h"

namespace phs::validate {
namespace {

constexpr double kShear = 82e9;
constexpr double kPoisson = 0.28;
constexpr char kHertz[] = "complete elliptic integrals (models/reference/hertz_m_n_table.csv)";
constexpr char kA22[] =
    "CONTACT, example mbench_a22_left: Manchester case A-2.2, 21 positions, 10 kN per wheel";
constexpr char kTractcurv[] = "CONTACT, example tractcurv: Eurosprinter (Polach 2005)";

constexpr char kA22Right[] =
    "CONTACT, example mbench_a22_right: the climbing wheel, every second position";
constexpr char kConicity[] =
    "CONTACT's creepages of both wheels, 10 kN each, gauge 1435 mm (conicity_s1002_uic60.csv)";

Result<Table> Reference(const std::string& name) {
  const auto path = ReferenceFile(name);
  if (!path.ok()) return path.error();
  return ReadCsv(path.value());
}

double At(const Table& table, const char* name, int row) {
  const int column = table.Find(name);
  if (column < 0) return std::nan("");
  return table.columns[static_cast<std::size_t>(column)][static_cast<std::size_t>(row)];
}

Check AtMost(const char* what, const char* unit, double ours, double tolerance,
             const char* source) {
  return {{}, what, unit, ours, 0, tolerance, Claim::kAtMost, source, {}};
}

Check Near(const char* what, const char* unit, double ours, double reference, double tolerance,
           const char* source) {
  return {{}, what, unit, ours, reference, tolerance, Claim::kNear, source, {}};
}

Status AddHertz(Checks* checks) {
  const auto table = Reference("hertz_m_n_table.csv");
  if (!table.ok()) return table.error();
  const rail::Hertz hertz(kShear, kPoisson);
  const double modulus = kShear / (1 - kPoisson);
  const double sum = 5;  // A + B [1/m]; the coefficients do not depend on it
  double axes = 0;
  double approach = 0;
  for (int row = 0; row < table.value().num_rows(); ++row) {
    const auto cell = [&](std::size_t i) {
      return table.value().columns[i][static_cast<std::size_t>(row)];
    };
    if (cell(1) > 0.9999) continue;  // five digits of the cosine are too few there
    const double small = sum * (1 - std::cos(cell(0) * std::numbers::pi / 180)) / 2;
    const rail::HertzContact c = hertz.AtApproach(1e-4, small, sum - small);
    const double a0 = std::cbrt(3 * c.normal / (4 * modulus * sum));
    axes = std::max({axes, std::abs(c.a / a0 / cell(2) - 1), std::abs(c.b / a0 / cell(3) - 1)});
    approach = std::max(approach, std::abs(1e-4 / (a0 * a0 * sum) / cell(5) - 1));
  }
  checks->push_back(AtMost("Hertz: axes of the ellipse, largest relative error over 28 shapes", "-",
                           axes, 2e-4, kHertz));
  checks->push_back(AtMost("Hertz: approach, the same", "-", approach, 2e-4, kHertz));
  return {};
}

/// Case of one wheel: its table and CONTACT's reference points.
struct A22 {
  Table table;
  std::vector<rail::ContactReference> reference;
};

Result<A22> CalcA22(const std::string& poses, std::optional<rail::Side> side = {}) {
  const auto path = ReferenceFile("mbench_a22_" + poses + ".inp");
  if (!path.ok()) return path.error();
  auto cases = rail::ReadContactInput(path.value());
  if (!cases.ok()) return cases.error();
  rail::WheelRailParams& pair = cases.value().wheel_rail;
  const auto wheel = FindData("wheel profile", "models/profiles", "S1002", {".prw"});
  const auto rail = FindData("rail profile", "models/profiles", "UIC60", {".prr"});
  if (!wheel.ok()) return wheel.error();
  if (!rail.ok()) return rail.error();
  pair.wheel_profile = wheel.value();
  pair.rail_profile = rail.value();
  pair.damping_ratio = 0;
  pair.creep.method = "fastsim";
  pair.creep.blended_flexibility = true;  // at full slip along the slip, as CONTACT
  if (side) cases.value().side = *side;
  auto table = rail::CalcWheelsetCases(cases.value());
  if (!table.ok()) return table.error();
  auto reference = rail::CalcContactReferences(cases.value(), table.value());
  if (!reference.ok()) return reference.error();
  return A22{std::move(table).value(), std::move(reference).value()};
}

/// Largest differences over the positions of a wheel.
struct Worst {
  double place = 0, angle = 0, pressure = 0, sink = 0, force = 0, squares = 0;
};

Worst CompareA22(const A22& ours, const Table& ref, double left_out) {
  const Table& t = ours.table;
  Worst w;
  int before = -1;
  for (int row = 0; row < t.num_rows(); ++row) {
    const int k = static_cast<int>(At(t, "case", row)) - 1;
    const double force = std::hypot(At(t, "FX_N", row) - At(ref, "FX(TR)", k),
                                    At(t, "FY_N", row) - At(ref, "FY(TR)", k)) /
                         (0.3 * At(ref, "FN", k));
    double peak = 0;
    for (int other = 0; other < t.num_rows(); ++other) {
      if (At(t, "case", other) == k + 1) peak = std::max(peak, At(t, "pmax_MPa", other));
    }
    w.pressure = std::max(w.pressure, std::abs(peak / At(ref, "PMAX", k) - 1));
    // The sink along the normal: what CONTACT calls the approach.
    const double height = At(t, "z_solved_mm", row) - At(ref, "Z_WS", k);
    w.sink = std::max(
        w.sink, std::abs(height) * std::cos(At(ref, "DELTCP(TR)", k)) / At(ref, "APPROACH", k));
    w.force = std::max(w.force, force);
    if (k != before) w.squares += force * force / ref.num_rows();
    before = k;
    if (At(ref, "Y_WS", k) == left_out) continue;
    const rail::ContactReference& r = ours.reference[static_cast<std::size_t>(k)];
    w.place = std::max(w.place, std::abs(r.rail_y_mm - At(ref, "YCP(R)", k)));
    w.angle = std::max(w.angle, std::abs(r.angle_rad - At(ref, "DELTCP(TR)", k)));
  }
  return w;
}

/// `left_out`: the position where CONTACT's own contact jumps from tread to flange root.
Status AddWheel(const std::string& wheel, double left_out, const char* source, Checks* checks) {
  const auto ours = CalcA22(wheel);
  const auto theirs = Reference("mbench_a22_" + wheel + "_ref.csv");
  if (!ours.ok()) return ours.error();
  if (!theirs.ok()) return theirs.error();
  const Worst w = CompareA22(ours.value(), theirs.value(), left_out);
  const std::string head = "A-2.2, " + wheel + " wheel: ";
  const std::string but = left_out > 0 ? ", but at y = " + Shortest(left_out) + " mm" : "";
  const auto add = [&](const std::string& what, const char* unit, double value, double tolerance) {
    Check check = AtMost("", unit, value, tolerance, source);
    check.what = head + what;
    checks->push_back(check);
  };
  add("reference point on the rail" + but, "mm", w.place, 0.3);
  add("contact angle there" + but, "rad", w.angle, 0.002);
  add("peak pressure, relative", "-", w.pressure, 0.08);
  add("sink along the normal over CONTACT's approach", "-", w.sink, 0.15);
  add("tangential force as a vector over mu N, largest", "-", w.force, 0.06);
  add("the same, rms", "-", std::sqrt(w.squares), 0.04);
  return {};
}

Status AddA22(Checks* checks) {
  if (Status s = AddWheel("left", -1, kA22, checks); !s.ok()) return s;
  return AddWheel("right", 5, kA22Right, checks);
}

/// Conicity r0 (xi_right - xi_left)/(2 y) of the creepages at both wheels' reference points.
Status AddConicity(Checks* checks) {
  const auto left = CalcA22("left");
  const auto right = CalcA22("left", rail::Side::kRight);
  const auto theirs = Reference("conicity_s1002_uic60.csv");
  if (!left.ok()) return left.error();
  if (!right.ok()) return right.error();
  if (!theirs.ok()) return theirs.error();
  for (int row = 0; row < theirs.value().num_rows(); ++row) {
    const double y = At(theirs.value(), "y_mm", row);
    const auto k = static_cast<std::size_t>(std::lround(y / 0.5));
    const double ours =
        (right.value().reference[k].radius_mm - left.value().reference[k].radius_mm) / (2 * y);
    const double reference = At(theirs.value(), "conicity", row);
    Check check = Near("", "-", ours, reference, 0.03 * reference, kConicity);
    check.what = "conicity under 10 kN at y = " + Shortest(y) + " mm";
    checks->push_back(check);
  }
  return {};
}

Status AddFastsim(Checks* checks) {
  const auto table = Reference("fastsim_ref.csv");
  if (!table.ok()) return table.error();
  rail::CreepInput in{8e-3, 4e-3, 82e3, 0, -6.25e-4, 0.625, 30, 0.3};
  const rail::KalkerCoefficients c = rail::CalcKalkerCoefficients(2, kPoisson);
  in = rail::WithBlendedFlexibility(in, c, kShear);
  for (int row = 0; row < table.value().num_rows(); ++row) {
    const std::string label = table.value().text[0][static_cast<std::size_t>(row)];
    if (label.find("FASTSIM") == std::string::npos || label.find("rev") != std::string::npos) {
      continue;
    }
    const int n = label.find("200") != std::string::npos ? 200 : 40;
    const bool elliptic = label.find("elliptic") != std::string::npos;
    const rail::NormalisedForce f = rail::Fastsim({n, n, elliptic, rail::FastsimCells::kUniform})
                                        .Calc(rail::Normalise(in, c, kShear, elliptic));
    const double limit = in.friction * in.normal;
    const double reference = At(table.value(), "FS", row);
    Check check = Near("", "N", limit * f.y, reference, 0.001 * std::abs(reference),
                       "CONTACT, example fastsim: a 8, b 4 mm, 82 kN, lateral creepage and spin");
    check.what = "lateral force, " + label;
    checks->push_back(check);
  }
  return {};
}

/// Line contact of CONTACT's example: R 500 mm, a 1 mm, f 0.3, creepage -0.024 %.
Status AddCarter(Checks* checks) {
  const auto table = Reference("carter2d_ref.csv");
  if (!table.ok()) return table.error();
  const double printed = At(table.value(), "FX/FSTAT/FN", 0);
  checks->push_back(Near("Carter's formula, F/(mu N) at adhesion a' = 0.6 a", "-",
                         rail::CalcCarter(-2.4e-4, 0.5, 1e-3, 0.3), printed, 0.01,
                         "CONTACT, example carter2d (55 elements)"));
  // FASTSIM on an ellipse 50 times as long across: the simplified theory's own error.
  rail::CreepLawParams params;
  params.method = "fastsim";
  const auto law = rail::CreateCreepLaw(params);
  if (!law.ok()) return law.error();
  rail::CreepInput in;
  in.a = 1e-3;
  in.b = 50e-3;
  // p0 = a E*/(2 R) of a line contact, N = 2/3 pi a b p0.
  in.normal = 2.0 / 3 * std::numbers::pi * in.a * in.b * in.a * kShear / (1 - kPoisson) / (2 * 0.5);
  in.friction = 0.3;
  in.speed = 30;
  double worst = 0;
  for (int i = 1; i <= 20; ++i) {
    in.xi = -6e-5 * i;
    const double ours = law.value()->Calc(in).x / (in.friction * in.normal);
    worst = std::max(worst, std::abs(ours - rail::CalcCarterStrips(in.xi, 0.5, in.a, in.friction)));
  }
  checks->push_back(AtMost("FASTSIM on a narrow long ellipse, error over mu N, all creepages", "-",
                           worst, 0.05, "Carter 1926, strip by strip"));
  return {};
}

Status AddTractcurv(Checks* checks) {
  const auto table = Reference("tractcurv_ref.csv");
  if (!table.ok()) return table.error();
  rail::CreepLawParams classic;
  classic.method = "fastsim";
  rail::CreepLawParams modified = classic;
  modified.slope_reduction = {0.54, 0.02, 0.62};
  const auto coulomb = rail::CreateCreepLaw(classic);
  const auto reduced = rail::CreateCreepLaw(modified);
  if (!coulomb.ok()) return coulomb.error();
  if (!reduced.ok()) return reduced.error();
  rail::CreepInput in;
  in.normal = 106700;
  // The ellipse from the printed peak pressure 640.7 MPa and a/b = 0.5.
  in.b = std::sqrt(3 * in.normal / (2 * std::numbers::pi * 640.7e6) / 0.5);
  in.a = 0.5 * in.b;
  in.speed = 10;
  const rail::FrictionLaw falling{0.36, 0.38, std::log(2.0) / 0.99};
  double worst[3] = {};  // CONTACT Coulomb, FASTSIM Coulomb, modified FASTSIM
  for (int row = 0; row < table.value().num_rows(); ++row) {
    const bool is_reduced = row >= 90;
    if (row >= 30 && row < 60) continue;  // CONTACT with an interface layer: not modelled
    in.xi = At(table.value(), "CKSI", row);
    in.friction = is_reduced ? falling.At(in.speed * in.xi) : 0.33;
    const double ours = (is_reduced ? reduced : coulomb).value()->Calc(in).x;
    const double limit = (is_reduced ? 0.36 : 0.33) * in.normal;
    double& most = worst[is_reduced ? 2 : row >= 60 ? 1 : 0];
    most = std::max(most, std::abs(ours - At(table.value(), "FX", row)) / limit);
  }
  checks->push_back(AtMost("creep curve, FASTSIM against CONTACT, error over mu N, 30 creepages",
                           "-", worst[0], 0.05, kTractcurv));
  checks->push_back(
      AtMost("creep curve, FASTSIM against FASTSIM, the same", "-", worst[1], 0.02, kTractcurv));
  checks->push_back(AtMost("creep curve with falling friction and reduced slope, the same", "-",
                           worst[2], 0.02, kTractcurv));
  return {};
}

}  // namespace

Status AddContactChecks(Checks* checks) {
  for (const auto add :
       {&AddHertz, &AddA22, &AddConicity, &AddFastsim, &AddCarter, &AddTractcurv}) {
    if (Status s = add(checks); !s.ok()) return s;
  }
  return {};
}

}  // namespace phs::validate
