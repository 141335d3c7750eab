// The PHS beside the measurements of T. P. Löwe's thesis and the reference equation of nitrogen.
#include <cmath>

#include "base/data_path.h"
#include "hydraulics/bwr_nitrogen.h"
#include "phs_model/phs_model.h"
#include "rigs/step_table.h"
#include "validate/check_groups.h"
#include "validate/table_b1_checks.h"

namespace phs::validate {
namespace {

using hydraulics::PhsParams;
using rigs::StepRow;
using TableRows = std::vector<StepRow>;

std::string Thesis(const std::string& place) { return kThesis + place; }

void AddVolumes(const PhsParams& p, Checks* checks) {
  const auto& c = p.cylinders[0];
  const double chambers = c.end_stop.clearance_m * (c.BoreArea() + c.RodArea());
  const auto& rod = p.lines[p.FindLine(c.rod_line)];
  const std::string source = Thesis("Table 4-1");
  auto add = [&](const char* what, double ours, double reference, double share) {
    checks->push_back(
        {{}, what, "m3", ours, reference, share * reference, Claim::kNear, source, {}});
  };
  add("volume of both chambers at mid stroke, calculated there", chambers, 4.47e-4, 0.002);
  add("volume of both chambers, measured", chambers, 4.5e-4, 0.01);
  add("volume of the blow-off accumulator, measured", rod.accumulator.volume_m3, 0.74e-3, 0.02);
  add("volume of a reservoir, measured", rod.reservoir.volume_m3, 0.31e-3, 0.04);
}

/// Force at rest with the precharge pressures as the thesis sets them.
void AddPrecharge(const PhsParams& p, Checks* checks) {
  const auto& c = p.cylinders[0];
  const double force = 2.0e6 * c.RodArea() - 1.8e6 * c.BoreArea();
  checks->push_back({{},
                     "cylinder force at the precharges of 1.8 and 2.0 MPa",
                     "N",
                     force,
                     0,
                     50,
                     Claim::kNear,
                     Thesis("4.1.4; 50 N = 0.4 % of either side, the pressures are rounded"),
                     {}});
}

/// Mean slope of pressure over compression of the closed chamber with its free air.
Status AddBulkModulus(Checks* checks) {
  Result<PhsParams> params = phs_model::FindPhsParams("single_cylinder");
  if (!params.ok()) return params.error();
  Result<hydraulics::PhsSystem> made = phs_model::CreatePhsSystem(params.value());
  if (!made.ok()) return made.error();
  const auto& line = params.value().lines[0];
  const double area = params.value().cylinders[0].BoreArea();
  std::vector<double> state(made.value().num_states(), 0.0);
  auto compression = [&](double target) {  // displaced volume at which `target` is reached
    double low = 0, high = 5e-3;
    for (int i = 0; i < 60; ++i) {
      const double x = -0.5 * (low + high), v = 0;
      double p = 0;
      hydraulics::PhsOutputs out;
      out.energy = false;
      out.p_bore = &p;
      made.value().Calc(0, &x, &v, state.data(), &out);
      (p < target ? low : high) = -x;
    }
    return area * low;
  };
  auto modulus = [&](double from, double to) {
    return line.oil_volume_m3 * (to - from) / (compression(to) - compression(from));
  };
  checks->push_back({{},
                     "bulk modulus of the closed chamber, slope from 2 to 20 MPa, 3.58 ml of air",
                     "Pa",
                     modulus(2e6, 20e6),
                     1.4e9,
                     0.1e9,
                     Claim::kNear,
                     Thesis("5.1.1, 5.2"),
                     {}});
  checks->push_back({{},
                     "bulk modulus of the closed chamber below 1 MPa, where the thesis sees air",
                     "Pa",
                     modulus(0.2e6, 1e6),
                     0.7e9,
                     0,
                     Claim::kOrientation,
                     Thesis("5.1.1: air matters below 2 MPa; half the modulus taken as the mark"),
                     {}});
  return {};
}

Result<double> Settled(const PhsParams& params, const TableRows& rows, int row) {
  for (const StepRow& r : rows) {
    if (r.row != row) continue;
    Result<std::vector<double>> p = rigs::PredictSettled(params, {r});
    if (!p.ok()) return p.error();
    return p.value()[0];
  }
  return Error{"step table", "has no row " + std::to_string(row), "", ""};
}

Status AddBlowOff(const PhsParams& p, const TableRows& rows, Checks* checks) {
  Result<double> plateau = Settled(p, rows, 13);
  if (!plateau.ok()) return plateau.error();
  checks->push_back({{},
                     "blow-off plateau: rod pressure (gauge) held at 8.73 mm",
                     "Pa",
                     plateau.value(),
                     15.2e6,
                     0.5e6,
                     Claim::kNear,
                     Thesis("Table B-1 row 13, settled"),
                     {}});
  return {};
}

/// Pressure rise of the rod side per step, held: how much stiffer each setup is than the next. The
/// ratio of two measured slopes is good to about a fifth (steps of 1 to 3 mm read by laser).
Status AddStiffnessOrder(const TableRows& rows, Checks* checks) {
  const int row_of[] = {1, 9, 19, 29};
  double slope[4], measured[4];
  for (int k = 0; k < 4; ++k) {
    Result<PhsParams> p = phs_model::FindPhsParams("quarter_setup" + std::to_string(k + 1));
    if (!p.ok()) return p.error();
    Result<double> end = Settled(p.value(), rows, row_of[k]);
    if (!end.ok()) return end.error();
    const double p0 = 2.0e6 - hydraulics::kAtmosphere;
    for (const StepRow& r : rows) {
      if (r.row != row_of[k]) continue;
      slope[k] = (end.value() - p0) / r.piston_step_m;
      measured[k] = (r.end_Pa - p0) / r.piston_step_m;
    }
  }
  for (int k = 0; k < 3; ++k) {
    const std::string names = std::to_string(k + 1) + " over " + std::to_string(k + 2);
    const double ratio = measured[k] / measured[k + 1];
    const std::string source =
        "Table B-1 rows " + std::to_string(row_of[k]) + ", " + std::to_string(row_of[k + 1]);
    checks->push_back({{},
                       "stiffness of the rod side, setup " + names,
                       "-",
                       slope[k] / slope[k + 1],
                       ratio,
                       0.2 * ratio,
                       Claim::kNear,
                       Thesis(source),
                       {}});
  }
  return {};
}

void AddNitrogen(Checks* checks) {
  const char* source =
      "Span et al., J. Phys. Chem. Ref. Data 29 (2000) 1361, reference equation of nitrogen";
  const double rho = 164.2394;
  checks->push_back({{},
                     "BWR pressure of nitrogen at 164.24 kg/m3, 300 K",
                     "Pa",
                     hydraulics::CalcBwrPressure(rho, 300).p,
                     15e6,
                     0.05e6,
                     Claim::kNear,
                     source,
                     {}});
  checks->push_back({{},
                     "BWR isochoric heat capacity there",
                     "J/(kg K)",
                     hydraulics::CalcBwrCv(rho, 300),
                     773.6,
                     11,
                     Claim::kNear,
                     source,
                     {}});
}

}  // namespace

Status AddHydraulicsChecks(Checks* checks) {
  Result<PhsParams> setup2 = phs_model::FindPhsParams("quarter_setup2");
  if (!setup2.ok()) return setup2.error();
  Result<std::string> path = FindData("step table", "models/rigs", "lowe_table_b1", {".csv"});
  if (!path.ok()) return path.error();
  Result<TableRows> rows = rigs::ReadStepTable(path.value());
  if (!rows.ok()) return rows.error();
  AddVolumes(setup2.value(), checks);
  AddPrecharge(setup2.value(), checks);
  AddNitrogen(checks);
  for (const Status& s : {AddBulkModulus(checks), AddBlowOff(setup2.value(), rows.value(), checks),
                          AddStiffnessOrder(rows.value(), checks)}) {
    if (!s.ok()) return s;
  }
  return AddTableB1Checks(checks);
}

}  // namespace phs::validate
