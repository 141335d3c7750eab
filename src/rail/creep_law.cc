#include "rail/creep_law.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/numbers.h"
#include "base/words.h"
#include "rail/creep_table_cache.h"
#include "rail/fastsim.h"
#include "rail/kalker.h"
#include "rail/polach.h"

namespace phs::rail {
namespace {

bool InContact(const CreepInput& in) {
  return in.normal > 0 && in.friction > 0 && in.a > 0 && in.b > 0;
}

/// Discretisation, interpolation and Polach's missing spin moment may let a patch deliver a little
/// power; the spin moment, the least certain of the three, then takes the value of no power.
CreepForce Passive(const CreepInput& in, CreepForce f) {
  const double delivered = f.x * in.xi + f.y * in.eta + f.moment * in.phi;
  if (delivered > 0 && in.phi != 0) f.moment -= delivered / in.phi;
  return f;
}

class LinearLaw : public CreepLaw {
 public:
  explicit LinearLaw(const ContactMaterial& m)
      : shear_(m.shear_modulus_Pa), curve_(m.poisson_ratio) {}
  CreepForce Calc(const CreepInput& in) const noexcept override {
    if (!InContact(in)) return {};
    return CalcLinearCreep(in, curve_.At(in.a / in.b), shear_);
  }
  std::string name() const override { return "linear"; }

 private:
  double shear_;
  KalkerCurve curve_;
};

class PolachLaw : public CreepLaw {
 public:
  explicit PolachLaw(const CreepLawParams& p)
      : shear_(p.material.shear_modulus_Pa),
        adhesion_(p.polach_adhesion),
        slip_(p.polach_slip),
        curve_(p.material.poisson_ratio) {}
  CreepForce Calc(const CreepInput& in) const noexcept override {
    if (!InContact(in)) return {};
    return Passive(in, CalcPolach(in, curve_.At(in.a / in.b), shear_, adhesion_, slip_));
  }
  std::string name() const override { return "polach"; }

 private:
  double shear_;
  double adhesion_;
  double slip_;
  KalkerCurve curve_;
};

/// FASTSIM, or the table of it: `Source` gives the normalised force.
template <typename Source>
class SimplifiedTheoryLaw : public CreepLaw {
 public:
  SimplifiedTheoryLaw(const CreepLawParams& p, Source source)
      : params_(p), curve_(p.material.poisson_ratio), source_(std::move(source)) {}
  CreepForce Calc(const CreepInput& in) const noexcept override {
    if (!InContact(in)) return {};
    const double shear = params_.material.shear_modulus_Pa;
    const KalkerCoefficients c = curve_.At(in.a / in.b);
    CreepInput changed = in;
    if (params_.slope_reduction.active()) {
      changed = WithSlopeReduction(changed, c, shear, params_.slope_reduction);
    }
    if (params_.blended_flexibility) changed = WithBlendedFlexibility(changed, c, shear);
    const NormalisedForce f = source_(Normalise(changed, c, shear, params_.elliptic_bound));
    const double limit = in.friction * in.normal;
    return Passive(in, {limit * f.x, limit * f.y, limit * (in.a + in.b) * f.moment});
  }
  std::string name() const override { return params_.method; }

 private:
  CreepLawParams params_;
  KalkerCurve curve_;
  Source source_;
};

struct FastsimSource {
  Fastsim fastsim;
  NormalisedForce operator()(const NormalisedCreepage& c) const noexcept { return fastsim.Calc(c); }
};
struct TableSource {
  std::shared_ptr<const CreepTable> table;
  NormalisedForce operator()(const NormalisedCreepage& c) const noexcept { return table->At(c); }
};

Status InRange(const char* key, double value, double low, double high) {
  if (value >= low && value <= high) return {};
  return Error{key, "is " + std::to_string(value),
               std::to_string(low) + " … " + std::to_string(high), ""};
}

Status Validate(const CreepLawParams& p) {
  const Status checks[] = {
      InRange("shear_modulus_Pa", p.material.shear_modulus_Pa, 1e9, 1e12),
      InRange("poisson_ratio", p.material.poisson_ratio, 0, 0.5),
      InRange("fastsim_strips", p.fastsim_strips, 2, Fastsim::kMaxStrips),
      InRange("fastsim_slices", p.fastsim_slices, 2, 1000),
      InRange("slope_reduction.k0", p.slope_reduction.k0, 1e-3, 1),
      InRange("slope_reduction.alpha", p.slope_reduction.alpha, 0, 1),
      InRange("slope_reduction.beta", p.slope_reduction.beta, 0, 1e3),
      InRange("polach_adhesion", p.polach_adhesion, 1e-3, 1),
      InRange("polach_slip", p.polach_slip, 1e-3, p.polach_adhesion),
  };
  for (const Status& check : checks) {
    if (!check.ok()) return check;
  }
  return {};
}

}  // namespace

CreepForce CreepLaw::CalcWithSlope(const CreepInput& input, CreepSlope* slope) const noexcept {
  constexpr double kShare = 1e-3;     // of the creepage
  constexpr double kSmallest = 1e-7;  // where there is none
  const CreepForce here = Calc(input);
  CreepInput moved = input;
  const double dxi = kSmallest + kShare * std::abs(input.xi);
  moved.xi += dxi;
  const CreepForce along = Calc(moved);
  moved.xi = input.xi;
  const double deta = kSmallest + kShare * std::abs(input.eta);
  moved.eta += deta;
  const CreepForce across = Calc(moved);
  *slope = {(along.x - here.x) / dxi, (across.x - here.x) / deta, (along.y - here.y) / dxi,
            (across.y - here.y) / deta};
  return here;
}

double FrictionLaw::At(double slip_speed) const {
  return coefficient *
         ((1 - falling_ratio) * std::exp(-falling_rate_s_m * slip_speed) + falling_ratio);
}

const std::vector<std::string>& CreepLawNames() {
  static const std::vector<std::string> names = {"linear", "fastsim", "polach", "kalker_table"};
  return names;
}

Status ChooseCreepLaw(const std::string& text, CreepLawParams* params) {
  const size_t colon = text.find(':');
  const std::string method = text.substr(0, colon);
  const std::vector<std::string>& names = CreepLawNames();
  if (std::find(names.begin(), names.end(), method) == names.end()) {
    return Error{"creep law", "'" + method + "' is not known", JoinWords(names),
                 DidYouMean(method, names)};
  }
  if (colon != std::string::npos) {
    const auto cells = ParseNumber(text.substr(colon + 1));
    const bool whole = cells && *cells == std::floor(*cells) && *cells >= 4 && *cells <= 200;
    if (!whole || (method != "fastsim" && method != "kalker_table")) {
      return Error{"creep law", "'" + text + "' has no such grid",
                   "fastsim:N or kalker_table:N with N = 4 … 200 strips and slices", ""};
    }
    params->fastsim_strips = params->fastsim_slices = static_cast<int>(*cells);
  }
  params->method = method;
  return {};
}

Result<std::unique_ptr<CreepLaw>> CreateCreepLaw(const CreepLawParams& params) {
  const Status valid = Validate(params);
  if (!valid.ok()) return valid.error();
  using Law = std::unique_ptr<CreepLaw>;
  if (params.method == "linear") return Law(new LinearLaw(params.material));
  if (params.method == "polach") return Law(new PolachLaw(params));
  const FastsimParams grid{params.fastsim_strips, params.fastsim_slices, params.elliptic_bound,
                           FastsimCells::kStrip};
  if (params.method == "fastsim") {
    return Law(new SimplifiedTheoryLaw<FastsimSource>(params, {Fastsim(grid)}));
  }
  if (params.method == "kalker_table") {
    return Law(new SimplifiedTheoryLaw<TableSource>(
        params, {SharedCreepTable(grid, params.use_disk_cache)}));
  }
  return Error{"creep law", "'" + params.method + "' is not known",
               "linear, fastsim, polach, kalker_table", ""};
}

}  // namespace phs::rail
