#include "rail/simplified_theory.h"

#include <cmath>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

#include "base/numbers.h"
#include "rail/creep_table_cache.h"
#include "rail/fastsim.h"
#include "rail/kalker.h"

namespace phs::rail {
namespace {

struct FastsimSource {
  Fastsim fastsim;
  NormalisedForce operator()(const NormalisedCreepage& c) const noexcept { return fastsim.Calc(c); }
};
struct TableSource {
  std::shared_ptr<const CreepTable> table;
  NormalisedForce operator()(const NormalisedCreepage& c) const noexcept { return table->At(c); }
  /// `cell`: filled if not null.
  NormalisedForce operator()(const NormalisedCreepage& c, NormalisedSlope* slope,
                             CreepTable::Cell* cell) const noexcept {
    return table->At(c, slope, cell);
  }
  NormalisedForce operator()(const NormalisedCreepage& c,
                             const CreepTable::Cell& cell) const noexcept {
    return table->At(c, cell);
  }
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
    const KalkerCoefficients c = curve_.AtShare(in.a / (in.a + in.b));
    CreepInput changed = in;
    if (params_.slope_reduction.active()) {
      changed = WithSlopeReduction(changed, c, shear, params_.slope_reduction);
    }
    if (params_.blended_flexibility) changed = WithBlendedFlexibility(changed, c, shear);
    return ForceOf(in, source_(Normalised(changed, c)));
  }
  CreepForce CalcNear(const CreepInput& in, const CreepMemo& memo) const noexcept override {
    if constexpr (kTabulated) {
      if (memo.filled && InContact(in)) {
        const Kept& kept = *std::launder(reinterpret_cast<const Kept*>(memo.room.data()));
        const double share = in.a / (in.a + in.b);
        const KalkerCoefficients c =
            share == kept.share ? kept.coefficients : curve_.AtShare(share);
        return ForceOf(in, source_(Normalised(in, c), kept.cell));
      }
    }
    return Calc(in);
  }
  CreepForce CalcWithSlope(const CreepInput& in, CreepSlope* slope,
                           CreepMemo* memo) const noexcept override {
    // The changes of creepage below have slopes of their own.
    const bool changed = params_.slope_reduction.active() || params_.blended_flexibility;
    if constexpr (kTabulated) {
      if (!changed && InContact(in)) return CalcClosed(in, slope, memo);
    }
    return CreepLaw::CalcWithSlope(in, slope, memo);
  }
  std::string name() const override { return params_.method; }

 private:
  /// A table has slopes of its own and a part that serves for creepages nearby.
  static constexpr bool kTabulated = std::is_same_v<Source, TableSource>;
  /// What a memo holds of a patch.
  struct Kept {
    double share;  ///< a/(a + b)
    KalkerCoefficients coefficients;
    CreepTable::Cell cell;
  };
  static_assert(sizeof(Kept) <= sizeof(CreepMemo::room));

  NormalisedCreepage Normalised(const CreepInput& in, const KalkerCoefficients& c) const {
    return Normalise(in, c, params_.material.shear_modulus_Pa, params_.elliptic_bound);
  }

  static CreepForce ForceOf(const CreepInput& in, const NormalisedForce& f) {
    const double limit = in.friction * in.normal;
    return WithoutDelivery(in, {limit * f.x, limit * f.y, limit * (in.a + in.b) * f.moment});
  }

  /// With the table's own slope: u and v are proportional to xi and eta.
  CreepForce CalcClosed(const CreepInput& in, CreepSlope* slope, CreepMemo* memo) const noexcept {
    const double share = in.a / (in.a + in.b);
    const KalkerCoefficients c = curve_.AtShare(share);
    CreepInput unit = in;
    unit.xi = unit.eta = 1;
    const NormalisedCreepage per = Normalised(unit, c);
    NormalisedCreepage creepage = per;
    creepage.u *= in.xi;
    creepage.v *= in.eta;
    CreepTable::Cell* cell = nullptr;
    if (memo != nullptr) {
      Kept* kept = new (memo->room.data()) Kept;
      kept->share = share;
      kept->coefficients = c;
      cell = &kept->cell;
      memo->filled = true;
    }
    NormalisedSlope s;
    const NormalisedForce force = source_(creepage, &s, cell);
    const double limit = in.friction * in.normal;
    *slope = {limit * s.x_u * per.u, limit * s.x_v * per.v, limit * s.y_u * per.u,
              limit * s.y_v * per.v};
    return ForceOf(in, force);
  }

  CreepLawParams params_;
  KalkerCurve curve_;
  Source source_;
};

FastsimParams GridOf(const CreepLawParams& p) {
  return {p.fastsim_strips, p.fastsim_slices, p.elliptic_bound, FastsimCells::kStrip};
}

std::unique_ptr<CreepLaw> MakeFastsim(const CreepLawParams& p) {
  return std::make_unique<SimplifiedTheoryLaw<FastsimSource>>(p, FastsimSource{Fastsim(GridOf(p))});
}

std::unique_ptr<CreepLaw> MakeTable(const CreepLawParams& p) {
  return std::make_unique<SimplifiedTheoryLaw<TableSource>>(
      p, TableSource{SharedCreepTable(GridOf(p), p.use_disk_cache)});
}

bool ReadGrid(const std::string& option, CreepLawParams* p) {
  const auto cells = ParseNumber(option);
  if (!cells || *cells != std::floor(*cells) || !(*cells >= 4 && *cells <= 200)) return false;
  p->fastsim_strips = p->fastsim_slices = static_cast<int>(*cells);
  return true;
}

CreepLawOption GridOption() { return {"N", "N = 4 … 200 strips and slices", ReadGrid}; }

}  // namespace

CreepLawRow FastsimRow() {
  return {"fastsim", "FASTSIM, Kalker's simplified theory", GridOption(), MakeFastsim};
}

CreepLawRow KalkerTableRow() {
  return {"kalker_table", "FASTSIM from a table", GridOption(), MakeTable};
}

}  // namespace phs::rail
