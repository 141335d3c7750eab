#include "hydraulics/phs_params.h"

#include <cmath>
#include <set>

#include "base/words.h"

namespace phs::hydraulics {
namespace {

Error Bad(const std::string& where, const std::string& what, const std::string& allowed,
          const std::string& mend = "") {
  return Error{where, what, allowed, mend};
}

std::string Number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

// First broken bound, if any.
class Checker {
 public:
  void In(const std::string& where, double value, double min, double max, bool open_min = false) {
    const bool low = open_min ? value > min : value >= min;
    if (!status_.ok() || (std::isfinite(value) && low && value <= max)) return;
    status_ = Bad(where, Number(value) + " is out of range",
                  Number(min) + (open_min ? " < " : " <= ") + "value <= " + Number(max));
  }
  void Require(bool holds, const std::string& where, const std::string& what,
               const std::string& allowed, const std::string& mend = "") {
    if (status_.ok() && !holds) status_ = Bad(where, what, allowed, mend);
  }
  Status status() const { return status_; }

 private:
  Status status_;
};

void CheckCylinder(const CylinderParams& c, const PhsParams& params, Checker* check) {
  check->In(c.name + ".bore_m", c.bore_m, 0, 1, true);
  check->In(c.name + ".rod_m", c.rod_m, 0, 1);
  check->Require(c.rod_m < c.bore_m, c.name + ".rod_m", "the rod is as thick as the bore",
                 "rod_m < bore_m");
  check->In(c.name + ".end_stop.clearance_m", c.end_stop.clearance_m, 0, 1, true);
  check->In(c.name + ".end_stop.stiffness_N_per_m", c.end_stop.stiffness_N_per_m, 0, 1e12, true);
  check->In(c.name + ".end_stop.damping_Ns_per_m", c.end_stop.damping_Ns_per_m, 0, 1e9);
  check->In(c.name + ".end_stop.transition_m", c.end_stop.transition_m, 0, 0.1, true);
  for (const std::string& line : {c.bore_line, c.rod_line}) {
    if (line.empty() || params.FindLine(line) >= 0) continue;
    std::vector<std::string> names;
    for (const LineParams& l : params.lines) names.push_back(l.name);
    std::string known, nearest = NearestWord(line, names);
    for (const std::string& n : names) known += (known.empty() ? "" : ", ") + n;
    check->Require(false, "cylinder " + c.name, "unknown line \"" + line + "\"", known,
                   nearest.empty() ? "" : "did you mean " + nearest + "?");
  }
}

void CheckGas(const std::string& where, const GasChargeParams& gas, Checker* check) {
  check->In(where + ".volume_m3", gas.volume_m3, 0, 1);
  check->In(where + ".polytropic_exponent", gas.polytropic_exponent, 0.9, 2);
  check->In(where + ".thermal_time_s", gas.thermal_time_s, 0, 1e9, true);
  check->In(where + ".min_gas_volume_m3", gas.min_gas_volume_m3, 0, 1);
}

void CheckLine(const LineParams& l, Checker* check) {
  check->In(l.name + ".static_pressure_Pa", l.static_pressure_Pa, 0, 1e8, true);
  check->Require(l.oil_volume_m3 > 0, l.name + ".oil_volume_m3", "the line holds no oil",
                 "0 < value <= 1", "give the oil of chambers, pipes and reservoir");
  check->In(l.name + ".oil_volume_m3", l.oil_volume_m3, 0, 1, true);
  check->In(l.name + ".bulk_modulus_Pa", l.bulk_modulus_Pa, 1e6, 1e11);
  check->In(l.name + ".bulk_modulus_slope", l.bulk_modulus_slope, 0, 20);
  check->Require(l.bulk_modulus_slope * l.static_pressure_Pa < 0.9 * l.bulk_modulus_Pa,
                 l.name + ".bulk_modulus_slope", "the oil would have no stiffness at zero pressure",
                 "slope * static_pressure < 0.9 bulk_modulus");
  check->In(l.name + ".free_air_m3", l.free_air_m3, 0, 1);
  check->In(l.name + ".gas_volume_m3", l.gas_volume_m3, 0, 1);
  CheckGas(l.name + ".reservoir", l.reservoir, check);
  CheckGas(l.name + ".accumulator", l.accumulator, check);
  check->In(l.name + ".accumulator_precharge_Pa", l.accumulator_precharge_Pa, 0, 1e9, true);
  check->Require(l.gas_volume_m3 == 0 || l.reservoir.min_gas_volume_m3 <= l.gas_volume_m3,
                 l.name + ".reservoir.min_gas_volume_m3", "larger than the static gas volume",
                 "min_gas_volume_m3 <= gas_volume_m3");
}

void CheckTable(const FrictionParams& f, Checker* check) {
  const std::string where = "friction.table";
  check->Require(f.speed_m_s.size() == f.force_N.size() && f.speed_m_s.size() >= 3, where,
                 "needs as many speeds as forces, at least three", "equal lengths >= 3");
  if (!check->status().ok()) return;
  bool zero = false, plus = false, minus = false;
  for (size_t i = 0; i < f.speed_m_s.size(); ++i) {
    const double v = f.speed_m_s[i], F = f.force_N[i];
    check->Require(std::isfinite(v) && std::isfinite(F), where, "holds a value that is no number",
                   "finite numbers");
    check->Require(i == 0 || v > f.speed_m_s[i - 1], where, "speeds do not rise",
                   "strictly rising speeds");
    check->Require(v * F >= 0 && (v != 0 || F == 0), where,
                   "friction at " + Number(v) + " m/s drives the motion",
                   "force with the sign of the speed, 0 at 0");
    zero |= v == 0;
    plus |= v > 0;
    minus |= v < 0;
  }
  check->Require(zero && plus && minus, where,
                 "must have the point (0, 0) and speeds on both sides", "");
}

void CheckFriction(const FrictionParams& f, Checker* check) {
  check->In("friction.scale", f.scale, 0, 100);
  if (f.model == FrictionModel::kNone) return;
  if (f.curve == FrictionCurve::kTable) CheckTable(f, check);
  check->In("friction.coulomb_extension_N", f.coulomb_extension_N, 0, 1e6);
  check->In("friction.coulomb_retraction_N", f.coulomb_retraction_N, 0, 1e6);
  check->In("friction.breakaway_extension_N", f.breakaway_extension_N, 0, 1e6);
  check->In("friction.breakaway_retraction_N", f.breakaway_retraction_N, 0, 1e6);
  check->In("friction.stribeck_speed_m_s", f.stribeck_speed_m_s, 0, 10, true);
  check->In("friction.viscous_extension_Ns_per_m", f.viscous_extension_Ns_per_m, 0, 1e7);
  check->In("friction.viscous_retraction_Ns_per_m", f.viscous_retraction_Ns_per_m, 0, 1e7);
  check->In("friction.ramp_speed_m_s", f.ramp_speed_m_s, 0, 1, true);
  check->In("friction.stiffness_N_per_m", f.stiffness_N_per_m, 0, 1e12, true);
  check->In("friction.damping_Ns_per_m", f.damping_Ns_per_m, 0, 1e7);
  check->In("friction.breakaway_ratio", f.breakaway_ratio, 0, 0.99);
}

}  // namespace

double CylinderParams::BoreArea() const { return M_PI / 4 * bore_m * bore_m; }
double CylinderParams::RodArea() const { return M_PI / 4 * (bore_m * bore_m - rod_m * rod_m); }

int PhsParams::FindLine(const std::string& line) const {
  for (size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].name == line) return static_cast<int>(i);
  }
  return -1;
}

int PhsParams::FindCylinder(const std::string& cylinder) const {
  for (size_t i = 0; i < cylinders.size(); ++i) {
    if (cylinders[i].name == cylinder) return static_cast<int>(i);
  }
  return -1;
}

Status Validate(const PhsParams& params) {
  Checker check;
  check.Require(!params.cylinders.empty() && params.cylinders.size() <= 16, "cylinders",
                std::to_string(params.cylinders.size()) + " cylinders", "1 to 16");
  check.Require(params.lines.size() <= 16, "lines", "too many lines", "0 to 16");
  check.In("temperature_K", params.temperature_K, 200, 400);
  std::set<std::string> names;
  for (const CylinderParams& c : params.cylinders) {
    check.Require(!c.name.empty() && names.insert(c.name).second, "cylinders",
                  "name \"" + c.name + "\" is empty or used twice", "one name each");
    CheckCylinder(c, params, &check);
  }
  for (const LineParams& l : params.lines) {
    check.Require(!l.name.empty() && names.insert(l.name).second, "lines",
                  "name \"" + l.name + "\" is empty or used twice", "one name each");
    CheckLine(l, &check);
  }
  CheckFriction(params.friction, &check);
  check.In("element.mass_kg", params.element.mass_kg, 0, 1e6);
  check.In("element.stiffness_N_per_m", params.element.stiffness_N_per_m, 0, 1e12);
  check.In("element.pressure_area_m2", params.element.pressure_area_m2, -10, 10);
  check.In("element.offset_N", params.element.offset_N, -1e7, 1e7);
  return check.status();
}

}  // namespace phs::hydraulics
