// A PHS as a file: read, written, changed by name, compiled with its effects. What scenarios,
// manifests, the plugin, sweeps and the identification have in common (docs/phs_models.md).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/yaml.h"
#include "hydraulics/phs_params.h"
#include "hydraulics/phs_system.h"
#include "phs_model/failures.h"

namespace phs::phs_model {

/// Model of a bogie whose file, scenario and options name none: hydraulics as measured on the rig.
inline constexpr char kDefaultModel[] = "bo_bo_measured";

/// Reads the format of docs/phs_models.md. Effect names and their keys are checked later, against
/// the catalogue (CreatePhsSystem).
Result<hydraulics::PhsParams> ReadPhsParams(YamlMap& map);
Result<hydraulics::PhsParams> LoadPhsParams(const std::string& path);
/// The same from a name looked up in the data folders (models/phs) or a path.
Result<hydraulics::PhsParams> FindPhsParams(const std::string& name_or_path);
/// The same format; reading it back gives equal parameters.
std::string ToYaml(const hydraulics::PhsParams& params);

/// Reads, checks and compiles a model file with its effects.
Result<hydraulics::PhsSystem> LoadPhsSystem(const std::string& path);
/// Compiles parameters with the catalogue.
Result<hydraulics::PhsSystem> CreatePhsSystem(
    const hydraulics::PhsParams& params,
    std::shared_ptr<const hydraulics::ExtraSeries> extra = nullptr);

/// Switches an effect on with its default parameters (all targets). Error: unknown name (nearest).
Status AddEffect(hydraulics::PhsParams* params, const std::string& effect);

/// A number of the model that can be looked up, varied and fitted.
struct ParameterInfo {
  std::string name;  ///< "L1.gas_volume_m3", "friction.scale", "1.bore_m", "effects.backlash.gap_m"
  std::string unit;
  double value = 0;
  double low = 0;  ///< plausible range
  double high = 0;
};
/// Every addressable parameter of cylinders, lines, friction and element.
std::vector<ParameterInfo> ListParameters(const hydraulics::PhsParams& params);
/// The same and those of the effects switched on.
std::vector<ParameterInfo> ListAllParameters(const hydraulics::PhsParams& params);
Result<double> GetParameter(const hydraulics::PhsParams& params, const std::string& name);
/// Sets one number; "friction.coulomb_N" and "friction.viscous_Ns_per_m" stand for both
/// directions. Does not validate ranges: CreatePhsSystem does.
Status SetParameter(hydraulics::PhsParams* params, const std::string& name, double value);

/// What a run changes in a PHS model.
struct PhsChanges {
  std::map<std::string, double> parameters = {};  ///< by name: "friction.scale" (SetParameter)
  std::vector<Failure> failures = {};
  std::vector<hydraulics::EffectParams> effects = {};  ///< beside those of the file
  std::map<std::string, std::string> places = {};  ///< "run.yaml:7: …" of these, if read there
};

/// A model file with its effects, with changed parameters and the failures that concern `system`.
/// A quarter model that is to serve four `actuators` or more is spread over them (bogie_spread.h).
Result<hydraulics::PhsParams> LoadChangedParams(const std::string& path, const PhsChanges& changes,
                                                const std::string& system, int actuators);
/// The same compiled.
Result<hydraulics::PhsSystem> LoadPhsSystem(const std::string& path, const PhsChanges& changes,
                                            const std::string& system, int actuators);

}  // namespace phs::phs_model
