// How effects enter a PHS without the core knowing them. An effect is a row of an EffectTable: its
// parameters and an Install function that adds laws to the places below. The core calls only laws
// that are present, so a model without effects pays nothing.
//
//   volume      VolumeLaw at a line: takes up volume as pressure rises (air, hoses)
//   flow        FlowLaw between two pressures: leakage, resistance; with inertance a state
//   friction    LevelLaw: how the level depends on speed, pressure, place, rest time; BristleLaw:
//               how it is reached; ForceLaw: a force beside it
//   mounting    MountLaw: what lies between mounting and piston
//   instrument  ReadingLaw: what a sensor of a rig shows of the truth
//   environment AmbientLaw: warmth over time
//   element     LoadLaw: what hangs on the driven end of a bench or rig
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "hydraulics/effect_forms.h"
#include "hydraulics/extra_series.h"
#include "hydraulics/friction_laws.h"
#include "hydraulics/load_law.h"
#include "hydraulics/mount_law.h"
#include "hydraulics/oil_laws.h"
#include "hydraulics/phs_params.h"
#include "hydraulics/reading_law.h"

namespace phs::hydraulics {

/// Where a flow law begins and ends.
enum class Port { kBore, kRod, kLine, kAtmosphere };

/// What an effect may add to while a system is being built.
class Extension {
 public:
  virtual ~Extension() = default;
  virtual const PhsParams& params() const = 0;
  /// Further channels that the run brings, in their order.
  virtual std::vector<std::string> extra_names() const { return {}; }
  virtual void AddVolume(int line, std::unique_ptr<VolumeLaw> law) = 0;
  /// Between two ports of a cylinder (kBore, kRod of `cylinder`), a line (`line`) or atmosphere.
  /// The law may ask for the piston of `cylinder`, also between others; -1: for none.
  virtual void AddFlow(Port from, Port to, int cylinder, int line, const std::string& name,
                       std::unique_ptr<FlowLaw> law) = 0;
  /// Puts `law` between the chamber (kBore or kRod) of `cylinder` and its line. `share` of the
  /// line's oil volume moves to the chamber side (0.02 … 0.98).
  virtual void SplitChamber(Port chamber, int cylinder, double share, const std::string& name,
                            std::unique_ptr<FlowLaw> law) = 0;
  /// Puts `law` between a line and the gas of its reservoir, from the line on; the blow-off stays at
  /// the line. Without a reservoir nothing happens.
  virtual void SplitReservoir(int line, const std::string& name, std::unique_ptr<FlowLaw> law) = 0;
  virtual void AddLevel(int cylinder, std::unique_ptr<const LevelLaw> law) = 0;
  /// Beside friction, on the piston.
  virtual void AddForce(int cylinder, std::unique_ptr<const ForceLaw> law) = 0;
  /// In place of the declared one, and of a static friction law; the last one counts.
  virtual void SetBristle(int cylinder, std::unique_ptr<const BristleLaw> law) = 0;
  virtual void AddMount(int cylinder, std::unique_ptr<const MountLaw> law) = 0;
  virtual void AddReading(int cylinder, Sensor sensor, std::unique_ptr<const ReadingLaw> law) = 0;
  /// At the driven end of a bench or rig.
  virtual void AddLoad(std::unique_ptr<const LoadLaw> law) = 0;
  virtual void AddAmbient(std::unique_ptr<const AmbientLaw> law) = 0;
  /// Line parameters may still be changed (precharge, gas law): laws are compiled afterwards.
  virtual LineParams& line(int index) = 0;
};

/// One parameter of an effect.
struct EffectParameter {
  std::string name;  ///< with unit suffix, "gap_m"
  std::string unit;
  double otherwise;  ///< default
  double min, max;   ///< allowed
  double low, high;  ///< plausible
  std::string text;
  bool by_factors = false;  ///< fitted as its logarithm, however short its range
};

/// One row of the catalogue.
struct EffectInfo {
  std::string name;
  std::string family;   ///< hydraulic, friction, mounting, instrument, environment
  std::string targets;  ///< "cylinders", "lines", "cylinders or lines" or "" (whole system)
  std::string text;     ///< the law in one line
  std::vector<EffectParameter> parameters;
  /// Adds the law. `value(name)` of every parameter is in `values`, defaults filled in.
  Status (*install)(const EffectParams& effect, Extension* extension);
  EffectSearch search = {};  ///< how it is looked for in data
  bool has_formula = false;  ///< needs EffectParams::formula
};

/// The catalogue as the core sees it.
class EffectTable {
 public:
  virtual ~EffectTable() = default;
  virtual const std::vector<EffectInfo>& effects() const = 0;
  /// Row of laws that a model brings with it (effects/own_law.h), under a name of its own.
  virtual const EffectInfo* own() const { return nullptr; }
  const EffectInfo* Find(const std::string& name) const;
  /// The row of an effect of a model: by its name, or own() if it brings a formula; null: none.
  const EffectInfo* FindFor(const EffectParams& effect) const;
};

}  // namespace phs::hydraulics
