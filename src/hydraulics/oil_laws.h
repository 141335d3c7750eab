// Laws that effects add to lines and chambers: volume taken up, flow between pressures, warmth.
#pragma once

#include <string>

namespace phs::hydraulics {

/// How the memory of a VolumeLaw moves: dm/dt = rate(p, m).
struct MemoryRate {
  double rate = 0;         ///< [1/s]
  double rate_slope = 0;   ///< d(rate)/dm [1/s], <= 0
  double rate_rise = 0;    ///< d(rate)/dp [1/(s Pa)]
  double volume_rise = 0;  ///< dV/dm at constant pressure [m3]
};

/// Volume taken up above the static state at pressure p: Volume(p0) = 0, rising with p (passive).
/// A law may have a memory m, one number that follows the pressure with a lag (creep, dissolving
/// gas): 0 in the static state, of the order of one.
class VolumeLaw {
 public:
  virtual ~VolumeLaw() = default;
  /// `volume` [m3] and `slope` dV/dp [m3/Pa] >= 0 at constant memory are added to.
  virtual void Add(double pressure, double memory, double* volume,
                   double* slope) const noexcept = 0;
  /// Integral of p dV from the static state, less what was lost on the way [J].
  virtual double Energy(double pressure, double memory) const noexcept = 0;
  /// Name of the memory among the states, "creep"; empty = none.
  virtual std::string MemoryName() const { return {}; }
  virtual MemoryRate Memory(double /*pressure*/, double /*memory*/) const noexcept { return {}; }
  /// Available power lost by the memory's moving [W], >= 0.
  virtual double Loss(double /*pressure*/, double /*memory*/) const noexcept { return 0; }
};

/// When, where and how warm it is where oil flows.
struct FlowPlace {
  double time = 0;    ///< [s]
  double warmer = 0;  ///< temperature above the model's [K]
  /// Dynamic viscosity over that at the model's static temperature (oil.h): 1 while it stays there.
  double viscosity = 1;
  double passed = 0;  ///< volume that has gone through so far [m3]
  /// Of the piston that the path belongs to: extension [m], and its rate [m/s] while a step is
  /// solved, 0 where losses are asked for.
  double piston = 0, speed = 0;
};

/// One lag of the oil behind the flow q of its pipe: dq_k/dt = rate (q - q_k), which holds the flow
/// back by a pressure resistance (q - q_k).
struct FlowLag {
  double rate = 0;        ///< [1/s] > 0
  double resistance = 0;  ///< [Pa s/m3] >= 0
};

/// Flow through an opening or pipe: rises with the pressure difference, Flow(0) = 0 (passive). Or
/// what a part lets pass that gives way between two chambers: it falls with the volume that went.
class FlowLaw {
 public:
  virtual ~FlowLaw() = default;
  /// Volume flow [m3/s] from the high to the low side at p_from - p_to = `dp` [Pa]; `slope` =
  /// d/d(dp).
  virtual double Flow(const FlowPlace& at, double dp, double* slope) const noexcept = 0;
  /// Inverse: pressure drop [Pa] at `flow`, and its slope. Asked for with an inertance and in series;
  /// found by the root of Flow, within 1 GPa, where a law has no form of its own.
  virtual double Drop(const FlowPlace& at, double flow, double* slope) const noexcept;
  /// rho l / A [kg/m4]; 0 = the flow follows the pressure at once.
  virtual double Inertance() const noexcept { return 0; }
  /// Lags of the flow, beside Drop; of a law with inertance.
  virtual int num_lags() const noexcept { return 0; }
  virtual FlowLag Lag(const FlowPlace& /*at*/, int /*lag*/) const noexcept { return {}; }
  /// True where the drop is the smoother of the two sides (turbulent flow: q ~ sqrt(dp), steep at
  /// zero), so that a step is solved for the flow: Newton on dp = Drop(q) does not circle about
  /// zero.
  virtual bool SolvedByDrop() const noexcept { return false; }
  /// True where it holds up to a pressure difference, so that Drop jumps at rest. A step that flows
  /// is then solved for the flow, and what would turn the flow brings it to rest first: Newton by
  /// Flow goes to and fro between rest and the steep slope beyond.
  virtual bool Sticks() const noexcept { return false; }
  /// By how much the flow falls with the volume that has gone through, -dq/d(passed) [1/s] >= 0.
  virtual double Return(const FlowPlace& /*at*/, double /*dp*/) const noexcept { return 0; }
  /// Energy held by what gave way [J], and its derivative over `passed` [Pa].
  virtual double Stored(double /*passed*/) const noexcept { return 0; }
  virtual double Held(double /*passed*/) const noexcept { return 0; }
};

/// Warmth of surroundings and oil above the static temperature; several add up.
class AmbientLaw {
 public:
  virtual ~AmbientLaw() = default;
  virtual double Rise(double time) const noexcept = 0;  ///< [K]
};

}  // namespace phs::hydraulics
