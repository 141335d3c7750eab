// Hydraulic oil ISO VG 68: viscosity, density, expansion over temperature, and oil with air.
//
// Viscosity by ASTM D341 (Walther): lg lg(nu + 0.7) = A - B lg T, nu in mm²/s, T in K; through
// nu(40 °C) = 68 mm²/s (ISO 3448, the meaning of the grade) and nu(100 °C) = 8.7 mm²/s, which is a
// viscosity index of about 100 (ISO 2909; typical data sheet value of a mineral HLP 68 oil).
// Density 880 kg/m3 at 15 °C, expansion 7e-4 1/K (typical of mineral oil).
// Range: -20 … +100 °C; outside it the temperature is clamped.
#pragma once

namespace phs::hydraulics {

struct OilParams {
  double viscosity_40C_mm2_s = 68;
  double viscosity_100C_mm2_s = 8.7;
  double density_15C_kg_m3 = 880;
  double expansion_1_per_K = 7e-4;
};

/// Kinematic viscosity [m2/s].
double CalcKinematicViscosity(double temperature_K, const OilParams& oil = {});
/// Density [kg/m3] at atmospheric pressure.
double CalcDensity(double temperature_K, const OilParams& oil = {});
/// Dynamic viscosity [Pa s].
double CalcDynamicViscosity(double temperature_K, const OilParams& oil = {});

/// Dynamic viscosity over that at 20 °C: laminar resistances, stated at 20 °C, grow with it.
double CalcViscosityRatio(double temperature_K, const OilParams& oil = {});

/// Bulk modulus of oil with free air [Pa]: isentropic tangent 1/K = (1/beta + (a/n)(p_a/p)^(1/n)/p)
/// / (1 + a (p_a/p)^(1/n)), a = free air volume at atmospheric pressure per oil volume. Source:
/// volume balance of the two phases (e.g. Merritt, Hydraulic Control Systems, 1967, eq. 2-11).
double CalcEffectiveBulkModulus(double pressure, double bulk_modulus, double air_fraction,
                                double polytropic_exponent);

}  // namespace phs::hydraulics
