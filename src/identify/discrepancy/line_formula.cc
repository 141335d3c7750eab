#include "identify/discrepancy/line_formula.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "effects/formula.h"
#include "effects/unlisted.h"
#include "identify/fit/acceptance.h"
#include "identify/fit/fit_intervals.h"
#include "measurement/time_wave.h"

namespace phs::identify::search {
namespace {

using effects::FormulaUnit;
using hydraulics::EffectParams;
using hydraulics::PhsParams;

/// Where a law may act, and the pressure that it sees: lowest and highest above static.
struct LinePlace {
  FormulaUnit unit = FormulaUnit::kVolume;
  std::vector<std::string> targets;
  double low = 0, high = 0;
  double end_s = 1;  ///< of the record
  /// Channel of its pressure, where waves over time can be sought in it; empty: they cannot.
  std::string wave_channel = {};
  double wave_step_s = 0;
};

struct Model {
  const FitProblem& problem;
  const FreeModel& free;
  const std::vector<double>& values;
  Eigen::VectorXd residual;
  bool has_law = false;  ///< its last effect is a law of this place
};

class LineTerms final : public TermLibrary {
 public:
  LineTerms(const Model& model, const LinePlace& place, const Eigen::MatrixXd& model_space,
            bool thresholds_only)
      : TermLibrary(model_space),
        model_(model),
        place_(place),
        scale_(RoundScale(std::max(std::abs(place.low), place.high))) {
    if (thresholds_only) return;
    const std::string p = fmt::format("(p/{:g}[Pa])", scale_);
    Add(p, 1), Add(p + "^2", 2), Add(p + "^3", 3);
    Add(p + "*abs" + p, 2);
    if (place.unit != FormulaUnit::kFlow) return;
    Add(fmt::format("(t/{:g}[s])*", RoundScale(place.end_s)) + p, 2);
  }

  /// The ramps that fit best beyond a pressure, above and below static: sought among sums of a few
  /// that the model has answered to.
  void AddForResidual(const Eigen::VectorXd& residual) override {
    if (!place_.wave_channel.empty()) AddTimeWave(residual);
    for (const double end : {place_.high, place_.low}) {
      if (std::abs(end) < 0.05 * scale_) continue;
      for (const int power : {1, 2}) AddBestRamp(residual, end, power);
    }
  }

 private:
  static constexpr int kGrid = 12, kScan = 240;

  /// Oil that something beside the rig presses in and sucks out again: the strongest wave of the
  /// line's pressure.
  void AddTimeWave(const Eigen::VectorXd& residual) {
    const FitProblem& problem = model_.problem;
    const int channel = problem.FindOutput(place_.wave_channel);
    if (channel < 0) return;
    const Block& rows = problem.block(static_cast<size_t>(channel));
    const Eigen::VectorXd weight = problem.Weighted(
        place_.wave_channel, {std::vector<double>(static_cast<size_t>(rows.count), 1.0)});
    const Eigen::VectorXd here = residual.segment(rows.begin, rows.count)
                                     .cwiseProduct(weight.segment(rows.begin, rows.count));
    const auto wave = measurement::FindTimeWave({here.data(), here.data() + here.size()},
                                                place_.wave_step_s, LeastPeriods({}));
    if (!(wave.frequency_Hz > 0)) return;
    const std::string angle = fmt::format("(2*pi*t/{:.8g}[s])", 1 / wave.frequency_Hz);
    Eigen::MatrixXd columns(model_.residual.size(), 2);
    columns << Column("sin" + angle), Column("cos" + angle);
    AddColumns("sin" + angle, "cos" + angle, 2, std::log(wave.looked_at), columns);
  }

  std::string Ramp(double share, double end, int power) const {
    const double onset = std::abs(share * end);
    const std::string beyond = end > 0 ? fmt::format("max(p-{:.4g}[Pa],0[Pa])", onset)
                                       : fmt::format("max(-p-{:.4g}[Pa],0[Pa])", onset);
    return fmt::format("({}/{:g}[Pa]){}", beyond, scale_, power == 2 ? "^2" : "");
  }

  /// Share of the residual's square that a term takes.
  double Taken(const Eigen::VectorXd& residual, const std::string& term) const {
    const Eigen::VectorXd c = Own(Column(term));
    const double norm = c.squaredNorm();
    return norm > 0 ? std::pow(c.dot(residual), 2) / norm : 0;
  }

  /// Ramps max(p - p_k, 0)/P from onsets p_k on a grid up to `end`, what the model can imitate
  /// taken out. A ramp from between two of them is their mean, a squared one their sum from its
  /// onset on.
  struct RampGrid {
    double end = 0;
    Eigen::MatrixXd own, products;
    double Step() const { return 1.0 / static_cast<double>(own.cols()); }
  };

  const RampGrid& Grid(double end) {
    for (const RampGrid& grid : grids_) {
      if (grid.end == end) return grid;
    }
    RampGrid grid;
    grid.end = end;
    grid.own.resize(model_.residual.size(), kGrid);
    for (int k = 0; k < kGrid; ++k) {
      grid.own.col(k) = Own(Column(Ramp(k / static_cast<double>(kGrid), end, 1)));
    }
    grid.products = grid.own.transpose() * grid.own;
    grids_.push_back(std::move(grid));
    return grids_.back();
  }

  /// The ramp from `share` of the end as a sum of those of the grid.
  static Eigen::VectorXd Weights(const RampGrid& grid, double share, int power) {
    const Eigen::Index count = grid.own.cols();
    const double place = share / grid.Step();
    const auto k = std::min(static_cast<Eigen::Index>(place), count - 1);
    const double part = place - static_cast<double>(k);
    Eigen::VectorXd w = Eigen::VectorXd::Zero(count + 1);  // the last begins at the end: nothing
    w[k] = 1 - part, w[k + 1] = part;
    if (power == 2) {  // trapezes from the onset on
      w *= 0.5 * (1 - part);
      w[k + 1] += 0.5 * (1 - part);
      for (Eigen::Index i = k + 1; i < count; ++i) w[i] += 0.5, w[i + 1] += 0.5;
    }
    return w.head(count);
  }

  void AddBestRamp(const Eigen::VectorXd& residual, double end, int power) {
    const RampGrid& grid = Grid(end);
    const Eigen::VectorXd along = grid.own.transpose() * residual;
    double best = 0.5, most = -1;
    for (int k = 0; k < kScan; ++k) {
      const double share = k / static_cast<double>(kScan);
      const Eigen::VectorXd w = Weights(grid, share, power);
      const double norm = w.dot(grid.products * w);
      const double taken = norm > 0 ? std::pow(w.dot(along), 2) / norm : 0;
      if (taken > most) most = taken, best = share;
    }
    // Between the grid's onsets the sum is not quite the ramp.
    most = Taken(residual, Ramp(best, end, power));
    for (double step = grid.Step() / 2; step > grid.Step() / 40; step /= 2) {
      const double about = best;
      for (const double share : {about - step, about + step}) {
        if (share <= 0 || share >= 1) continue;
        const double taken = Taken(residual, Ramp(share, end, power));
        if (taken > most) most = taken, best = share;
      }
    }
    Add(Ramp(best, end, power), power + 1, std::log(2 * kGrid));
  }

  /// What the model answers to the term (coefficient 1), weighted; zeros where it refuses it.
  Eigen::VectorXd Column(const std::string& term) const {
    const bool wave = term.starts_with("sin") || term.starts_with("cos");
    const double amount = place_.unit == FormulaUnit::kVolume || wave ? 1e-8 : 1e-10;
    FreeModel with = model_.free;
    const std::string unit = effects::UnitSuffix(place_.unit);
    if (model_.has_law) {
      EffectParams& law = with.params.effects.back();
      law.formula += " + c6*" + term;
      law.values["c6_" + unit] = amount;
    } else {
      EffectParams law{effects::UnlistedInfo().name, place_.targets, {{"c1_" + unit, amount}}};
      law.formula = "c1*" + term;
      with.params.effects.push_back(std::move(law));
    }
    const Eigen::VectorXd r = model_.problem.Residual(with, model_.values);
    if (r.size() == 0) return Eigen::VectorXd::Zero(model_.residual.size());
    return (model_.residual - r) / amount;
  }

  void Add(const std::string& term, int factors, double looked_at = 0) {
    AddColumns(term, "", factors, looked_at, Column(term));
  }

  const Model& model_;
  const LinePlace& place_;
  const double scale_;
  std::vector<RampGrid> grids_;
};

/// Lines of the first cylinder, each alone and together, and its piston.
std::vector<LinePlace> LinePlaces(const FitProblem& problem, const PhsParams& params) {
  const Result<FormulaFrame> frame = problem.forward().Frame(params, "p_bore_Pa");
  if (!frame.ok() || params.cylinders.empty()) return {};
  const auto& cylinder = params.cylinders.front();
  LinePlace bore, rod, across;
  double end = 0, step = 0;
  const auto widen = [](LinePlace* place, double rise) {
    place->low = std::min(place->low, rise), place->high = std::max(place->high, rise);
  };
  for (const auto& record : frame.value().places) {
    for (const auto& p : record) {
      widen(&bore, p.bore_rise), widen(&rod, p.rod_rise);
      widen(&across, p.bore_rise - p.rod_rise);
      end = std::max(end, p.time);
    }
  }
  std::vector<LinePlace> out;
  if (frame.value().has_time_waves && frame.value().places.front().size() > 1) {
    step = frame.value().places.front()[1].time - frame.value().places.front()[0].time;
  }
  const bool has_bore = params.FindLine(cylinder.bore_line) >= 0;
  const bool has_rod = params.FindLine(cylinder.rod_line) >= 0;
  for (const FormulaUnit unit : {FormulaUnit::kVolume, FormulaUnit::kFlow}) {
    const bool waves = step > 0 && unit == FormulaUnit::kFlow;
    const auto add = [&](const std::string& line, const LinePlace& seen, const char* channel) {
      out.push_back({unit, {line}, seen.low, seen.high, end, waves ? channel : "", step});
    };
    if (has_bore) add(cylinder.bore_line, bore, "p_bore_Pa");
    if (has_rod) add(cylinder.rod_line, rod, "p_rod_Pa");
    if (!has_bore || !has_rod) continue;
    out.push_back({unit,
                   {cylinder.bore_line, cylinder.rod_line},
                   std::min(bore.low, rod.low),
                   std::max(bore.high, rod.high),
                   end});
    if (unit == FormulaUnit::kFlow && params.FindLine(cylinder.name) < 0) {
      out.push_back({unit, {cylinder.name}, across.low, across.high, end});
    }
  }
  return out;
}

FoundFormula SearchAt(const Model& at, const LinePlace& place, const SelectionData& data,
                      const Eigen::MatrixXd& space, const FormulaLimits& limits,
                      bool thresholds_only = false) {
  LineTerms terms(at, place, space, thresholds_only);
  FoundFormula found = SelectTerms(data, space, limits, &terms);
  found.unit = effects::UnitSuffix(place.unit);
  found.targets = place.targets;
  return found;
}

double TotalEvidence(const FoundFormula& found) {
  double sum = 0;
  for (const FormulaTerm& term : found.terms) sum += term.evidence;
  return sum;
}

}  // namespace

FoundFormula SearchLineFormula(const FitProblem& problem, const FreeModel& model,
                               const std::vector<double>& values, const FormulaLimits& limits) {
  const std::vector<LinePlace> places = LinePlaces(problem, problem.Params(model, values));
  Model at{problem, model, values, {}};
  SelectionData data;
  if (places.empty() || !problem.Linearise(model, values, 0, &at.residual, &data.jacobian)) {
    return {};
  }
  data.residual = at.residual;
  data.independent = [&](const Eigen::VectorXd& r) {
    return IndependentSamples(r, problem.likelihood().blocks());
  };
  const Eigen::MatrixXd space = ModelSpace(data.jacobian, data.residual.size());
  std::vector<FoundFormula> found(places.size());
  problem.ForEach(static_cast<int>(places.size()), [&](int k) {
    found[static_cast<size_t>(k)] =
        SearchAt(at, places[static_cast<size_t>(k)], data, space, limits);
  });
  // In both lines must say more than in one: the other may hardly come to where the law acts.
  const auto worth = [&](const FoundFormula& f) {
    return TotalEvidence(f) - (f.targets.size() > 1 ? limits.threshold : 0);
  };
  const auto best = std::max_element(found.begin(), found.end(), [&](const auto& a, const auto& b) {
    return worth(a) < worth(b);
  });
  return best == found.end() ? FoundFormula{} : *best;
}

FoundFormula SearchAnew(const FitProblem& problem, const FreeModel& model,
                        const std::vector<double>& values, size_t base, const FoundFormula& law,
                        bool thresholds_only, const FormulaLimits& limits) {
  Model at{problem, model, values, {}, true};
  SelectionData data;
  Eigen::MatrixXd whole;
  if (!problem.Linearise(model, values, 0, &at.residual, &whole)) return {};
  data.residual = at.residual;
  for (size_t k = base; k < values.size(); ++k) {
    data.residual -=
        model.free[k].ToCoordinate(values[k]) * whole.col(static_cast<Eigen::Index>(k));
  }
  data.jacobian = whole.leftCols(static_cast<Eigen::Index>(base));
  data.independent = [&](const Eigen::VectorXd& r) {
    return IndependentSamples(r, problem.likelihood().blocks());
  };
  const Eigen::MatrixXd space = ModelSpace(data.jacobian, data.residual.size());
  for (const LinePlace& place : LinePlaces(problem, problem.Params(model, values))) {
    if (place.targets != law.targets || effects::UnitSuffix(place.unit) != law.unit) continue;
    return SearchAt(at, place, data, space, limits, thresholds_only);
  }
  return {};
}

}  // namespace phs::identify::search
