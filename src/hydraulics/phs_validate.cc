#include "hydraulics/phs_validate.h"

#include <cmath>
#include <set>

#include "base/words.h"
#include "hydraulics/phs_numbers.h"

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
  void In(const std::string& where, double value, const Range& allowed) {
    Require(allowed.Contains(value), where, Number(value) + " is out of range", allowed.Text());
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
  check->Require(c.rod_m < c.bore_m, c.name + ".rod_m", "the rod is as thick as the bore",
                 "rod_m < bore_m");
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

void CheckTemperature(const std::string& where, double T, Checker* check) {
  check->Require(T == 0 || T >= 200, where, Number(T) + " is out of range", "0 or 200 … 400");
}

void CheckLine(const LineParams& l, Checker* check) {
  CheckTemperature(l.name + ".temperature_K", l.temperature_K, check);
  check->Require(l.bulk_modulus_slope * l.static_pressure_Pa < 0.9 * l.bulk_modulus_Pa,
                 l.name + ".bulk_modulus_slope", "the oil would have no stiffness at zero pressure",
                 "slope * static_pressure < 0.9 bulk_modulus");
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

}  // namespace

Status Validate(const PhsParams& params) {
  Checker check;
  check.Require(!params.cylinders.empty() && params.cylinders.size() <= 16, "cylinders",
                std::to_string(params.cylinders.size()) + " cylinders", "1 to 16");
  check.Require(params.lines.size() <= 16, "lines", "too many lines", "0 to 16");
  PhsParams numbers = params;
  ForEachNumber(&numbers, [&](const std::string& name, const NumberInfo& info, double value) {
    check.In(name, value, info.allowed);
  });
  CheckTemperature("filled_at_K", params.filled_at_K, &check);
  for (const LineParams& l : params.lines) {
    check.Require(l.temperature_K == 0 || params.filled_at_K > 0, l.name + ".temperature_K",
                  "given without filled_at_K", "with filled_at_K",
                  "say at which temperature the lines were filled");
  }
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
  if (params.friction.model != FrictionModel::kNone &&
      params.friction.curve == FrictionCurve::kTable) {
    CheckTable(params.friction, &check);
  }
  return check.status();
}

}  // namespace phs::hydraulics
