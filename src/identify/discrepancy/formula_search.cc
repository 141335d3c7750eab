#include "identify/discrepancy/formula_search.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "effects/formula.h"
#include "identify/fit/acceptance.h"
#include "measurement/time_wave.h"

namespace phs::identify {

using measurement::FindTimeWave;
using measurement::TimeWave;
namespace {

using effects::Formula;
using hydraulics::ForcePlace;

struct Scale {
  double x = 1e-3, v = 1e-3, p = 1e5, q = 1e5, t = 1, T = 1, F = 1e3;
};

Scale MeasureScale(const FormulaPlaces& places) {
  double x_low = INFINITY, x_high = -INFINITY;
  Scale largest{0, 0, 0, 0, 0, 0, 0};
  for (const auto& run : places) {
    for (const ForcePlace& at : run) {
      x_low = std::min(x_low, at.piston), x_high = std::max(x_high, at.piston);
      largest.v = std::max(largest.v, std::abs(at.speed));
      largest.p = std::max(largest.p, std::abs(at.bore_rise));
      largest.q = std::max(largest.q, std::abs(at.rod_rise));
      largest.t = std::max(largest.t, std::abs(at.time));
      largest.T = std::max(largest.T, std::abs(at.temperature));
      largest.F = std::max(largest.F, std::abs(at.force));
    }
  }
  return {RoundScale(0.5 * (x_high - x_low)),
          RoundScale(largest.v),
          RoundScale(largest.p),
          RoundScale(largest.q),
          RoundScale(largest.t),
          RoundScale(largest.T),
          RoundScale(largest.F)};
}

class PlaceTerms final : public TermLibrary {
 public:
  PlaceTerms(const FormulaData& data, const Eigen::MatrixXd& model_space)
      : TermLibrary(model_space), data_(data), scale_(MeasureScale(data.places)) {
    AddPowers();
  }

  /// The strongest wave over x in this residual, plain and times s, and over t. Its length is that
  /// which takes most beside the model's own numbers.
  void AddForResidual(const Eigen::VectorXd& residual) override {
    if (!places_known_) CollectRows();
    const Variable x{"x", "m", scale_.x, row_x_}, load{"F", "N", scale_.F, row_F_};
    // What a load cell or a sensor has been set to zero with, or not.
    for (const Wave kind : {Wave::kPlain, Wave::kZeroed, Wave::kTurned}) {
      if (kind != Wave::kTurned || data_.has_friction) AddWave(residual, x, kind);
    }
    if (data_.has_friction) AddLocal(residual, x, Local::kNotch);
    if (!data_.has_friction && data_.own == 0) AddLocal(residual, x, Local::kStep);
    if (data_.has_load) AddLocal(residual, load, Local::kStep);
    if (data_.own != 0) AddLocal(residual, OwnPressure(), Local::kStep);
    for (const bool squared : {false, true}) {
      if (data_.has_friction) AddRamp(residual, x, squared);
      if (data_.has_load) AddRamp(residual, load, squared);
      if (data_.own != 0) AddRamp(residual, OwnPressure(), squared);
    }
    if (data_.has_time_waves) AddTimeWaves(residual);
  }

 private:
  enum class Wave {
    kPlain,
    kZeroed,  ///< nothing where the motion begins: a sensor has been set to zero there
    kTurned,  ///< times s
  };

  struct Variable {
    const char *symbol, *unit;
    double scale;
    const std::vector<double>& rows;
  };

  /// A gauge's own pressure.
  Variable OwnPressure() const {
    return data_.own == 'q' ? Variable{"q", "Pa", scale_.q, row_own_}
                            : Variable{"p", "Pa", scale_.p, row_own_};
  }

  static std::pair<std::string, std::string> WaveTexts(const Variable& over, double wave,
                                                       Wave kind) {
    const std::string angle = fmt::format("(2*pi*{}/{:.5g}[{}])", over.symbol, 1 / wave, over.unit);
    const std::string s = kind == Wave::kTurned ? "s*" : "";
    return {s + "sin" + angle, kind == Wave::kZeroed ? "(cos" + angle + "-1)" : s + "cos" + angle};
  }

  void AddWave(const Eigen::VectorXd& residual, const Variable& over, Wave kind) {
    if (over.rows.empty()) return;
    const auto [low, high] = std::minmax_element(over.rows.begin(), over.rows.end());
    const double span = *high - *low;
    double wave = FindWave(residual, over, span, kind == Wave::kTurned);
    if (!(wave > 0)) return;
    wave = Refine(wave, 0.5 / span, 9, [&](double at) {
      const auto [sine, cosine] = WaveTexts(over, at, kind);
      return TakenOff(residual, sine, cosine);
    });
    const auto [sine, cosine] = WaveTexts(over, wave, kind);
    Add(sine, cosine, kind == Wave::kTurned ? 3 : 2, std::log(waves_));
  }

  /// Square that a term takes from the residual beside what the model can imitate.
  double TakenOff(const Eigen::VectorXd& residual, const std::string& text,
                  const std::string& second = "") const {
    Eigen::MatrixXd columns(residual.size(), second.empty() ? 1 : 2);
    columns.col(0) = Column(text);
    if (!second.empty()) columns.col(1) = Column(second);
    const Eigen::MatrixXd own = Own(columns);
    const Eigen::VectorXd right = own.transpose() * residual;
    return right.dot((own.transpose() * own).ldlt().solve(right));
  }

  /// The number about `best` for which `taken` is largest, by steps to either side that are halved.
  static double Refine(double best, double step, int halvings,
                       const std::function<double(double)>& taken) {
    double most = taken(best);
    for (; halvings > 0; --halvings, step *= 0.5) {
      for (const double at : {best - step, best + step}) {
        if (const double now = taken(at); now > most) best = at, most = now;
      }
    }
    return best;
  }

  /// What begins at a position (a stop, an end of a guide) or at a force (an amplifier that gives
  /// way), to either side; squared: without a kink.
  void AddRamp(const Eigen::VectorXd& residual, const Variable& over, bool squared = false) {
    constexpr int kPositions = 24;
    std::vector<double> x = over.rows;
    if (x.size() < 2 * kPositions) return;
    std::sort(x.begin(), x.end());
    const auto text = [&](double from, bool above) {
      const std::string start = fmt::format("{:.4g}[{}]", std::abs(from), over.unit);
      const char* sign = from < 0 ? "-" : "";
      const std::string way = above ? over.symbol + std::string(from < 0 ? "+" : "-") + start
                                    : sign + start + "-" + over.symbol;
      return fmt::format("(max({0},0[{1}])/{2:g}[{1}]){3}", way, over.unit, over.scale,
                         squared ? "^2" : "");
    };
    double best = 0, most = 0;
    bool best_above = true;
    for (int k = 1; k < kPositions; ++k) {
      for (const bool above : {true, false}) {
        const double at = x[static_cast<size_t>(k) * x.size() / kPositions];
        const double taken = TakenOff(residual, text(at, above));
        if (taken > most) most = taken, best = at, best_above = above;
      }
    }
    if (!(most > 0)) return;
    best = Refine(best, (x.back() - x.front()) / (2 * kPositions), 7,
                  [&](double at) { return TakenOff(residual, text(at, best_above)); });
    Add(text(best, best_above), "", squared ? 3 : 2, std::log(2 * kPositions));
  }

  enum class Local {
    kNotch,  ///< a place that holds or pushes away: a detent, a burr that a spring rides over
    kStep,   ///< another value beyond a place: a scale's joint, an amplifier with a dead zone
  };

  /// A bump and its slope, or a step of finite width, where and as wide as it takes most.
  void AddLocal(const Eigen::VectorXd& residual, const Variable& over, Local shape) {
    constexpr int kPositions = 12, kWidths = 5;
    std::vector<double> x = over.rows;
    if (x.size() < 2 * kPositions) return;
    std::sort(x.begin(), x.end());
    const auto texts = [&](double at, double width) -> std::pair<std::string, std::string> {
      const std::string away = fmt::format("(({0}{1}{2:.4g}[{3}])/{4:.4g}[{3}])", over.symbol,
                                           at < 0 ? "+" : "-", std::abs(at), over.unit, width);
      if (shape == Local::kStep) return {"tanh" + away, "1"};
      const std::string bump = "exp(-" + away + "^2)";
      return {bump, away + "*" + bump};
    };
    // A step counts beyond what an offset takes: at the end of the motion it is one.
    const double offset = shape == Local::kStep ? TakenOff(residual, "1") : 0;
    // Of one whose flanks are not both seen nobody knows that it ends. Within two widths a bump is
    // down to e^-4, a step at 0.96 of its height.
    const auto taken_at = [&](double at, double width) {
      if (!(at - 2 * width > x.front() && at + 2 * width < x.back())) return 0.0;
      const auto [first, second] = texts(at, width);
      return TakenOff(residual, first, second) - offset;
    };
    double best = 0, wide = 0, most = 0;
    for (int k = 1; k <= kPositions; ++k) {
      const double at = x[static_cast<size_t>(k) * x.size() / (kPositions + 1)];
      for (int i = 0; i < kWidths; ++i) {
        const double width = (x.back() - x.front()) / 40 * std::pow(10.0, i / (kWidths - 1.0));
        const double taken = taken_at(at, width);
        if (taken > most) most = taken, best = at, wide = width;
      }
    }
    if (!(most > 0)) return;
    for (int round = 0; round < 2; ++round) {
      best = Refine(best, 0.5 * wide, 8, [&](double at) { return taken_at(at, wide); });
      wide = std::exp(Refine(std::log(wide), 0.3, 7,
                             [&](double log) { return taken_at(best, std::exp(log)); }));
    }
    const auto [first, second] = texts(best, wide);
    const double looked_at = std::log(kPositions * kWidths);
    if (shape == Local::kNotch) return Add(first, second, 3, looked_at);
    // To either side alike, or to one alone.
    for (const std::string& step : {first, "(1+" + first + ")", "(1-" + first + ")"}) {
      if (taken_at(best, wide) > 0.5 * TakenOff(residual, step)) Add(step, "", 3, looked_at);
    }
  }

  /// A wave over time: as it is, and as strong as the rig is fast (a drive's inverter).
  void AddTimeWaves(const Eigen::VectorXd& residual) {
    const std::vector<ForcePlace>& run = data_.places.front();
    if (run.size() < 2) return;
    if (weight_.size() == 0) weight_ = data_.column({std::vector<double>(run.size(), 1.0)});
    std::vector<double> plain, by_speed;
    for (size_t i = 0; i < run.size(); ++i) {
      const Eigen::Index row = data_.first_row + static_cast<Eigen::Index>(i);
      plain.push_back(residual[row] * weight_[row]);
      by_speed.push_back(plain.back() * std::abs(run[i].speed));
    }
    const std::string speed = fmt::format("(abs(v)/{:g}[m/s])*", scale_.v);
    for (const auto& [weighted, times] : {std::pair{&plain, std::string()}, {&by_speed, speed}}) {
      const TimeWave wave = FindTimeWave(*weighted, run[1].time - run[0].time, LeastPeriods({}));
      if (!(wave.frequency_Hz > 0)) continue;
      const std::string angle = fmt::format("(2*pi*t/{:.8g}[s])", 1 / wave.frequency_Hz);
      Add(times + "sin" + angle, times + "cos" + angle, 2, std::log(wave.looked_at));
    }
  }

  /// Column of a term (coefficient 1).
  Eigen::VectorXd Column(const std::string& term) const {
    Result<Formula> formula = Formula::Parse("c1*" + term, {{"c1", 1.0}});
    PHS_CHECK(formula.ok());
    std::vector<std::vector<double>> force;
    for (const auto& run : data_.places) {
      std::vector<double>& row = force.emplace_back();
      row.reserve(run.size());
      for (const ForcePlace& at : run) row.push_back(formula.value().Value(at));
    }
    return data_.column(force);
  }

  void Add(const std::string& text, const std::string& second, int factors, double looked_at) {
    Eigen::MatrixXd columns(data_.residual.size(), second.empty() ? 1 : 2);
    columns.col(0) = Column(text);
    if (!second.empty()) columns.col(1) = Column(second);
    AddColumns(text, second, factors, looked_at, columns);
  }

  void AddPowers() {
    std::vector<std::pair<std::string, int>> plain;  // even in direction, with their factors
    const auto powers = [&](const std::string& ratio, int most, const std::string& root) {
      plain.emplace_back(ratio, 1);
      for (int k = 2; k <= most; ++k) plain.emplace_back(fmt::format("{}^{}", ratio, k), k);
      if (!root.empty()) plain.emplace_back("sqrt(" + root + ")", 2);
    };
    const auto ratio = [](const char* symbol, double scale, const char* unit) {
      return fmt::format("({}/{:g}[{}])", symbol, scale, unit);
    };
    const std::string x = ratio("x", scale_.x, "m"), v = ratio("abs(v)", scale_.v, "m/s");
    const std::string signed_v = ratio("v", scale_.v, "m/s");
    powers(x, 3, "");
    if (data_.has_friction) powers(v, 3, v);
    std::vector<std::string> others = {ratio("t", scale_.t, "s")};
    powers(others[0], 2, "");
    if (data_.has_pressure) {
      others.push_back(ratio("p", scale_.p, "Pa"));
      powers(others.back(), 2, "abs" + others.back());
    }
    if (data_.has_rod_pressure) {
      others.push_back(ratio("q", scale_.q, "Pa"));
      powers(others.back(), 2, "abs" + others.back());
    }
    if (data_.has_temperature) {
      others.push_back(ratio("dT", scale_.T, "K"));
      powers(others.back(), 2, "");
    }
    for (const auto& [text, factors] : plain) {
      Add(text, "", factors, 0);
      if (data_.has_friction) Add("s*" + text, "", factors + 1, 0);
    }
    for (const std::string& other : others) Add(fmt::format("{}*{}", other, x), "", 2, 0);
    if (data_.has_friction) {
      AddWithFriction(x, v, signed_v, others);
    } else if (data_.has_speed) {
      Add(v, "", 1, 0), Add(v + "^2", "", 2, 0);
      Add(signed_v, "", 1, 0), Add(signed_v + "*" + v, "", 2, 0);
    }
    if (data_.has_load) AddLoad(ratio("F", scale_.F, "N"), x, v, others);
  }

  void AddLoad(const std::string& F, const std::string& x, const std::string& v,
               const std::vector<std::string>& others) {
    Add(F, "", 1, 0), Add(F + "^2", "", 2, 0), Add(F + "^3", "", 3, 0), Add("abs" + F, "", 2, 0);
    Add(F + "*" + x, "", 2, 0), Add(F + "*" + x + "^2", "", 3, 0);
    for (const std::string& other : others) Add(F + "*" + other, "", 2, 0);
    if (data_.has_speed) Add(F + "*" + v, "", 2, 0);
  }

  void AddWithFriction(const std::string& x, const std::string& v, const std::string& signed_v,
                       const std::vector<std::string>& others) {
    Add("s^3", "", 2, 0);
    Add(signed_v, "", 1, 0);
    Add(x + "*" + signed_v, "", 2, 0);
    Add("s*" + x + "*" + v, "", 3, 0);
    for (size_t i = 0; i < others.size(); ++i) {
      Add(others[i] + "*" + signed_v, "", 2, 0);
      Add("s*" + others[i] + "*" + x, "", 3, 0);
      Add("s*" + others[i] + "*" + v, "", 3, 0);
      for (size_t j = 0; j < i; ++j) Add("s*" + others[i] + "*" + others[j], "", 3, 0);
    }
  }

  /// Wave number [1/unit of the variable, which covers `span`] that takes most from the residual:
  /// coarse scan on thinned places, then a finer one around the best. 0: the motion is too short to
  /// tell.
  double FindWave(const Eigen::VectorXd& residual, const Variable& over, double span, bool turned) {
    constexpr double kLeastWaves = 1.5;  // over what the motion covers; fewer are no wave
    if (!(span > 0)) return 0;
    const double first = kLeastWaves / span, last = 300 / span, step = 0.25 / span;
    waves_ = (last - first) / step;
    const auto power = [&](double wave) {
      double c = 0, s = 0;
      for (size_t i = 0; i < row_.size(); ++i) {
        const double a = 2 * M_PI * wave * over.rows[i];
        const double r = residual[static_cast<Eigen::Index>(row_[i])] * row_weight_[i] *
                         (turned ? row_s_[i] : 1);
        c += r * std::cos(a), s += r * std::sin(a);
      }
      return c * c + s * s;
    };
    double best = 0, best_power = 0;
    for (double wave = first; wave < last; wave += step) {
      if (const double now = power(wave); now > best_power) best = wave, best_power = now;
    }
    for (double fine = 0.5 * step; fine > 1e-3 * step; fine *= 0.5) {
      for (const double wave : {best - fine, best + fine}) {
        if (const double now = power(wave); now > best_power) best = wave, best_power = now;
      }
    }
    return best;
  }

  /// x, s, F, a gauge's own pressure and weight on (at most 6000 of) the rows, read off through the
  /// caller's own columns.
  void CollectRows() {
    places_known_ = true;
    std::vector<std::vector<double>> x, s, load, own, one;
    for (const auto& run : data_.places) {
      x.emplace_back(), s.emplace_back(), load.emplace_back(), own.emplace_back();
      one.emplace_back(run.size(), 1.0);
      for (const ForcePlace& at : run) {
        x.back().push_back(at.piston), s.back().push_back(at.direction);
        load.back().push_back(at.force);
        own.back().push_back(data_.own == 'q' ? at.rod_rise : at.bore_rise);
      }
    }
    const Eigen::VectorXd w = data_.column(one), wx = data_.column(x), ws = data_.column(s),
                          wF = data_.column(load), wp = data_.column(own);
    const Eigen::Index stride = std::max<Eigen::Index>(1, w.size() / 6000);
    for (Eigen::Index i = 0; i < w.size(); i += stride) {
      if (!(w[i] > 0)) continue;
      row_.push_back(static_cast<size_t>(i)), row_weight_.push_back(w[i]);
      row_x_.push_back(wx[i] / w[i]), row_s_.push_back(std::clamp(ws[i] / w[i], -1.0, 1.0));
      row_F_.push_back(wF[i] / w[i]), row_own_.push_back(wp[i] / w[i]);
    }
  }

  const FormulaData& data_;
  const Scale scale_;
  Eigen::VectorXd weight_;  ///< of a sample, for waves over time
  bool places_known_ = false;
  std::vector<size_t> row_;
  std::vector<double> row_x_, row_s_, row_F_, row_own_, row_weight_;
  double waves_ = 1;
};

}  // namespace

FoundFormula SearchFormula(const FormulaData& data, const FormulaLimits& limits) {
  const Eigen::MatrixXd space = ModelSpace(data.jacobian, data.residual.size());
  PlaceTerms terms(data, space);
  return SelectTerms(data, space, limits, &terms);
}

}  // namespace phs::identify
