// Nitrogen as a real gas: the equation of Benedict, Webb and Rubin with specific volumes v.
// rho = 1/v:
//
//   p = R T rho + (B0 R T - A0 - C0/T²) rho² + (b R T - a) rho³ + a alpha rho⁶
//       + c rho³ (1 + gamma rho²) exp(-gamma rho²) / T²
//   c_v = c_v0(T) + 6/T³ (C0 rho - c/gamma) + 3c/T³ (2/gamma + rho²) exp(-gamma rho²)
//   c_v0 = R [N1/T³ + N2/T² + N3/T + (N4-1) + N5 T + N6 T² + N7 T³ + N8 y² e^y/(e^y-1)²], y = N9/T
//
// Units: p [Pa], T [K], rho [kg/m3], energies [J/kg]. Good for 200 … 600 K and up to 30 MPa.
// Source: Löwe, M.Eng. thesis, Univ. of Pretoria, eqs. 14, 17-19 after Otis and Pourmovahed (1985)
// and Cooper and Goldfrank (1967). The thesis prints C0 with exponent -6, c as a molar value, eq.
// 18 without the square in (e^y - 1)² and eq. 19 with 2/gamma - rho²; here all four are corrected:
// c_v must be the temperature derivative of the internal energy that the pressure equation implies.
#pragma once

namespace phs::hydraulics {

struct BwrConstants {
  double R = 296.797;           ///< J/(kg K)
  double A0 = 136.0474619;      ///< m5/(kg s2)
  double B0 = 1.454417e-3;      ///< m3/kg
  double C0 = 1.0405873e+6;     ///< K2 m5/(kg s2)
  double a = 0.115703387;       ///< m8/(kg2 s2)
  double b = 2.96625e-6;        ///< m6/kg2
  double c = 3357.48;           ///< K2 m8/(kg2 s2)
  double alpha = 5.7863972e-9;  ///< m9/kg3
  double gamma = 6.7539311e-6;  ///< m6/kg2
};

/// p(rho, T) with slopes.
struct BwrPressure {
  double p = 0;        ///< [Pa]
  double dp_drho = 0;  ///< [Pa m3/kg]
  double dp_dT = 0;    ///< [Pa/K]
  double decay = 0;    ///< exp(-gamma rho²), for CalcBwrResidualCv
};
BwrPressure CalcBwrPressure(double rho, double T, const BwrConstants& k = {});
/// rho(p, T): the root on the gas branch, for T above the critical 126.2 K.
double CalcBwrDensity(double p, double T, const BwrConstants& k = {});

/// Ideal part and real isochoric heat capacity [J/(kg K)].
double CalcNitrogenCv0(double T);
double CalcBwrResidualCv(double rho, double T, double decay, const BwrConstants& k = {});
double CalcBwrCv(double rho, double T, const BwrConstants& k = {});
/// Internal energy and entropy [J/kg], [J/(kg K)], up to one constant each.
double CalcBwrEnergy(double rho, double T, const BwrConstants& k = {});
double CalcBwrEntropy(double rho, double T, const BwrConstants& k = {});

}  // namespace phs::hydraulics
