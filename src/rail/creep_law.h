// Tangential contact forces: one interface for all creep laws. The laws are the rows of
// creep_laws.cc; axes and signs: creep.h.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "rail/creep.h"

namespace phs::rail {

/// Friction: constant, or falling with slip speed: f(w) = f0 ((1 - A) exp(-B w) + A).
/// Source: Polach, Creep forces in simulations of traction vehicles running on adhesion limit, Wear
/// 258 (2005) 992.
struct FrictionLaw {
  double coefficient = 0.3;     ///< f0 > 0
  double falling_ratio = 1;     ///< A in (0, 1]; 1 = constant
  double falling_rate_s_m = 0;  ///< B >= 0 [s/m]
  /// Coefficient at a slip speed >= 0 [m/s].
  double At(double slip_speed) const {
    if (falling_ratio == 1) return coefficient;
    return coefficient *
           ((1 - falling_ratio) * std::exp(-falling_rate_s_m * slip_speed) + falling_ratio);
  }
};

/// What a law keeps of a patch while only its creepages change; plain data of each law's own.
struct CreepMemo {
  bool filled = false;
  alignas(double) std::array<std::byte, 928> room;
};

/// Thread-safe, allocation-free after creation.
class CreepLaw {
 public:
  virtual ~CreepLaw() = default;
  virtual CreepForce Calc(const CreepInput& input) const noexcept = 0;
  /// The same force with its slope at held friction; for implicit steps. By one-sided differences
  /// where a law knows no better.
  /// `memo`: filled for CalcNear, if the law has use for it; may be null.
  virtual CreepForce CalcWithSlope(const CreepInput& input, CreepSlope* slope,
                                   CreepMemo* memo) const noexcept;
  /// As Calc, to the last bit; quicker near to where `memo` was filled.
  virtual CreepForce CalcNear(const CreepInput& input, const CreepMemo& memo) const noexcept;
  virtual std::string name() const = 0;
};

struct CreepLawParams {
  std::string method = "kalker_table";  ///< name of a row of CreepLaws()
  std::string option;                   ///< of the method, for laws that read one of their own
  ContactMaterial material;
  int fastsim_strips = 40;  ///< grid of FASTSIM (and of the table's source)
  int fastsim_slices = 40;
  bool elliptic_bound = false;       ///< traction bound: parabolic (classic) or elliptic
  bool use_disk_cache = true;        ///< keep the table in $XDG_CACHE_HOME/phs
  bool blended_flexibility = false;  ///< one flexibility at large creepage, as CONTACT's FASTSIM
  SlopeReduction slope_reduction;    ///< of fastsim and kalker_table
  double polach_adhesion = 1;        ///< kA of polach, (0, 1], >= kS
  double polach_slip = 1;            ///< kS of polach, (0, 1]
};

/// What may follow the name of a creep law after a colon.
struct CreepLawOption {
  std::string form;     ///< as in "NAME:form"
  std::string allowed;  ///< what `form` stands for
  /// Puts it into the parameters; false where it is not allowed. Null: the law takes no option.
  bool (*read)(const std::string& option, CreepLawParams* params) = nullptr;
};

/// One creep law.
struct CreepLawRow {
  std::string name;
  std::string text;  ///< what it is, for --help and the docs
  CreepLawOption option;
  std::unique_ptr<CreepLaw> (*make)(const CreepLawParams& params);
};
/// All of them. Names, messages, --help and the docs follow from these rows.
const std::vector<CreepLawRow>& CreepLaws();

Result<std::unique_ptr<CreepLaw>> CreateCreepLaw(const CreepLawParams& params);
/// Reads "METHOD" or "METHOD:OPTION". An error names what is allowed; `params` is then as before.
Status ChooseCreepLaw(const std::string& text, CreepLawParams* params);
/// The methods by name, for messages and --help.
std::vector<std::string> CreepLawNames();
/// "name (text), name (text), …".
std::string DescribeCreepLaws();

}  // namespace phs::rail
