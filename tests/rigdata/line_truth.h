// One hydraulic line of the true rig: oil, one reservoir with gas, perhaps a blow-off accumulator,
// and everything that a line may have beyond that.
//
//   chamber node (p_c)  ──Q──  remote node (p_r): reservoir, accumulator, rest of the oil
//
// Without a restriction both nodes are one.
// The remote node holds, relative to the static pressure p0, the volume
//   V(p) = C (p − p0)/(1 + ½ s (p − p0)) + [Vg0 − Vg(p, T)] + Vacc(p) + Vair(p) + Vhose(p)
//          − Vvap(p)
// and the balance is  V(p) = displaced − lost + expanded  with every term in m³.
// Signs: displacement into the line > 0; flow Q from chamber to remote > 0; lost volume > 0
// outward. Pressures absolute, Pa.
#pragma once

#include <array>

namespace rigdata {

inline constexpr double kT0 = 293.15;  // of the filling, K

enum class AirForm { kDissolving, kPolytropicDissolving, kLaggingDissolution };
enum class HoseForm { kStiffening, kViscoelastic };
enum class VapourForm { kRelease, kPlateau };
enum class LeakForm { kLaminar, kOrifice, kWidening };

// Flow through a gap or hole under the pressure difference d, m³/s, odd in d.
//   kLaminar g d;  kOrifice g √|d| sgn d (smooth below 2 kPa);  kWidening g d (1 + |d|/10 MPa)
struct LeakPath {
  LeakForm form = LeakForm::kLaminar;
  double conductance = 0;
  double Flow(double d) const;
};

struct LineParams {
  double area = 0;    // m², signed: displaced volume into the line per piston extension
  double p0 = 1.8e6;  // Pa
  double oil_compliance = 1.1e-3 / 1.4e9;  // m³/Pa
  double oil_volume = 1.1e-3;              // m³, for thermal expansion
  double oil_stiffening = 0;               // 1/Pa, s above
  double gas_volume0 = 16.16e-6;           // m³ at p0
  double gas_stop = 0;               // m³ at which the diaphragm lies against its stop; 0 = none
  double gas_stop_softness = 0.02;   // width of the touch-down, relative to gas_stop
  double blow_off_volume = 0;        // m³; 0 = no accumulator
  double blow_off_precharge = 15e6;  // Pa

  double gas_tau = 0;                   // s, heat exchange with the wall; 0 = isothermal
  double gas_coupling = 296.8 / 743.0;  // R/c_v of nitrogen; less where a filler stores heat too
  double wall_tau = 0;                  // s, wall with the surroundings; 0 = wall stays at T0
  double wall_ratio = 0.5;              // gas heat capacity / wall heat capacity

  AirForm air_form = AirForm::kDissolving;
  double air_volume = 0;        // m³ of free air at p0 if nothing were dissolved
  double air_exponent = 1;      // polytropic
  double air_saturation = 8e6;  // Pa, all dissolved above
  double air_lag = 0.5;         // s, of kLaggingDissolution

  HoseForm hose_form = HoseForm::kStiffening;
  double hose_volume = 0;   // m³: limit of the expansion, or compliance × 10 MPa
  double hose_scale = 5e6;  // Pa, stiffening scale
  double hose_tau = 1;      // s, viscoelastic

  VapourForm vapour_form = VapourForm::kRelease;
  double vapour_pressure = 0;  // Pa below which vapour or air comes out
  double vapour_volume = 0;    // m³, scale of what comes out

  LeakPath leak;                  // to the surroundings at 0.1 MPa
  double relief_pressure = 0;     // Pa, opens above; 0 = none
  double relief_conductance = 0;  // m³/(s Pa)

  double chamber_share = 0.2;                // part of the oil compliance that lies at the chamber
  std::array<double, 2> laminar = {0, 0};    // Pa s/m³: outflow, inflow (chamber → remote first)
  std::array<double, 2> turbulent = {0, 0};  // Pa s²/m⁶
  double inertance = 0;                      // kg/m⁴
};

// What a line remembers.
struct LineState {
  double p_chamber = 0, p_remote = 0;
  double flow = 0;         // m³/s, chamber → remote
  double transferred = 0;  // m³, ∫ flow
  double lost = 0;         // m³
  double gas_temperature = 293.15, wall_temperature = 293.15;
  double air_free = 1;    // free share of the air, for the lagging form
  double hose_flow = 0;   // m³, viscoelastic part
  double gas_volume = 0;  // m³, at the last solution
};

// The surroundings at one instant.
struct Surroundings {
  double reservoir_temperature = 293.15;  // K
  double oil_expansion = 0;               // 1, relative growth of the oil volume
  double compliance_growth = 0;           // 1, relative growth of the oil compliance
};

class LineTruth {
 public:
  explicit LineTruth(const LineParams& params);

  LineState Initial() const;
  // Pressure after a step of h with the piston at x; reads `state`, changes nothing. Fills
  // p_chamber, p_remote, flow and transferred of the returned state.
  LineState Solve(const LineState& state, double x, double h, const Surroundings& s) const;
  // Advances everything else (gas heat, air, hose, losses) after Solve; `cross_flow` leaves to the
  // other line.
  void Advance(LineState& solved, const LineState& before, double h, double cross_flow,
               const Surroundings& s) const;

  // V(p) of the remote node and its derivative; public for the tests.
  double Volume(double p, const LineState& state, double h, const Surroundings& s,
                double* derivative) const;
  const LineParams& params() const { return params_; }
  bool HasSegment() const { return has_segment_; }

 private:
  double SolveRemote(double volume, double guess, const LineState& state, double h,
                     const Surroundings& s) const;
  double ChamberPressure(double volume) const;
  // Volume of the gas and −dV/dp.
  double GasVolume(double p, double temperature, double* softness) const;
  double ReliefFlow(double p) const;

  LineParams params_;
  bool has_segment_ = false;
};

}  // namespace rigdata
