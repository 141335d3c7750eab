// What the catalogue does not hold: on which variables a residual force depends, and a compact
// formula for it, by sparse regression over dimensionally sound terms (formula_selection.h).
//
// Terms are products of plain numbers: x/L, v/V, p/P, q/P, t/T0, dT/K and their powers, the
// direction s of friction (with its memory of reversals), s³ (the shape of a reversal), and waves
// sin and cos of 2 pi x/lambda, alone and times s, with lambda from a scan, and of 2 pi t/T. Of
// forces also what begins at a position, max(x - x1, 0), and a notch, exp(-((x - x1)/w)²) and its
// slope, both flanks of which are seen. Each coefficient has the unit of what the formula gives.
// What a sensor shows has the force F that the load cell carries beside them, also from a force
// on, max(F - F1, 0), a gauge also from a pressure of its own on and in waves over it, and v, v|v|,
// |v| and v² in place of terms with s: a flow past its port, a cable beside that of the drive.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "hydraulics/extension.h"
#include "identify/discrepancy/formula_selection.h"

namespace phs::identify {

/// Places of the model on its own clock, run by run.
using FormulaPlaces = std::vector<std::vector<hydraulics::ForcePlace>>;

struct FormulaData : SelectionData {
  FormulaPlaces places;
  /// A force given at all places -> its weighted column on the rows of `residual`.
  std::function<Eigen::VectorXd(const std::vector<std::vector<double>>&)> column;
  bool has_pressure = false, has_rod_pressure = false, has_temperature = false;
  bool has_friction = true;  ///< terms with speed and direction
  bool has_speed = false;    ///< without friction: terms with speed alone
  bool has_load = false;     ///< without friction: terms with what the load cell carries
  char own = 0;              ///< of a gauge: symbol of the pressure that it shows
  /// Waves over time: one run, evenly sampled, whose places are the rows from `first_row` on.
  bool has_time_waves = false;
  Eigen::Index first_row = 0;
};

FoundFormula SearchFormula(const FormulaData& data, const FormulaLimits& limits);

/// Dependence of a residual on one variable: share of its variance explained by the means over 16
/// equally filled bins, less what chance gives, and the probability of as much by chance (F test
/// with n_eff samples).
struct VariableShare {
  std::string variable;  ///< "x_m", "speed_m_s", "reversal", "p_Pa", "t_s", "temperature_K"
  double share = 0;
  double p_value = 1;
};
/// Of a residual on the rows, variables given on the rows too; largest share first.
std::vector<VariableShare> ShareByVariable(
    const std::vector<double>& residual, double independent,
    const std::vector<std::pair<std::string, std::vector<double>>>& variables);

}  // namespace phs::identify
