#include "identify/formula_search.h"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "effects/force_formula.h"

namespace phs::identify {
namespace {

using effects::ForceFormula;
using hydraulics::ForcePlace;

/// Least part of a term (of its norm) that the model's free numbers cannot imitate: below, it would
/// only take over what a listed law says.
constexpr double kOwnShare = 0.1;

/// A term on trial: one or two columns.
struct Trial {
  std::string text, second;
  int factors = 1;          ///< for preferring the simpler of two
  double looked_at = 0;     ///< ln of how many were looked at to find this one (waves)
  Eigen::MatrixXd columns;  ///< weighted, what the model can imitate taken out
};

/// `value` rounded to one digit 1, 2 or 5: scales that read well.
double Rounded(double value) {
  if (!(value > 0) || !std::isfinite(value)) return 1;
  const double ten = std::pow(10.0, std::floor(std::log10(value)));
  const double lead = value / ten;
  return ten * (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10);
}

struct Scale {
  double x = 1e-3, v = 1e-3, p = 1e5, q = 1e5, t = 1, T = 1;
};

Scale MeasureScale(const FormulaPlaces& places) {
  double x_low = INFINITY, x_high = -INFINITY;
  Scale largest{0, 0, 0, 0, 0, 0};
  for (const auto& run : places) {
    for (const ForcePlace& at : run) {
      x_low = std::min(x_low, at.piston), x_high = std::max(x_high, at.piston);
      largest.v = std::max(largest.v, std::abs(at.speed));
      largest.p = std::max(largest.p, std::abs(at.bore_rise));
      largest.q = std::max(largest.q, std::abs(at.rod_rise));
      largest.t = std::max(largest.t, std::abs(at.time));
      largest.T = std::max(largest.T, std::abs(at.temperature));
    }
  }
  return {Rounded(0.5 * (x_high - x_low)),
          Rounded(largest.v),
          Rounded(largest.p),
          Rounded(largest.q),
          Rounded(largest.t),
          Rounded(largest.T)};
}

class Library {
 public:
  Library(const FormulaData& data, const Eigen::MatrixXd& model_space)
      : data_(data), model_space_(model_space), scale_(MeasureScale(data.places)) {
    AddPowers();
  }
  std::vector<Trial>& trials() { return trials_; }

  /// Column of a term (coefficient 1 N) with what the model can imitate taken out.
  Eigen::VectorXd Column(const std::string& term, double* whole) const {
    Result<ForceFormula> formula = ForceFormula::Parse("c1*" + term, {{"c1", 1.0}});
    PHS_CHECK(formula.ok());
    std::vector<std::vector<double>> force;
    for (const auto& run : data_.places) {
      std::vector<double>& row = force.emplace_back();
      row.reserve(run.size());
      for (const ForcePlace& at : run) row.push_back(formula.value().Force(at));
    }
    const Eigen::VectorXd c = data_.column(force);
    *whole = c.norm();
    return c - model_space_ * (model_space_.transpose() * c);
  }

  /// The strongest wave over x in this residual, plain and times s.
  void AddWaves(const Eigen::VectorXd& residual) {
    for (const bool turned : {false, true}) {
      const double wave = FindWave(residual, turned);
      if (!(wave > 0)) continue;
      const std::string length = fmt::format("{:.5g}[m]", 1 / wave), s = turned ? "s*" : "";
      Add(s + "sin(2*pi*x/" + length + ")", s + "cos(2*pi*x/" + length + ")", turned ? 3 : 2,
          std::log(waves_));
    }
  }

 private:
  void Add(const std::string& text, const std::string& second, int factors, double looked_at) {
    Trial trial{text, second, factors, looked_at, {}};
    double whole = 0, whole_second = 0;
    const Eigen::VectorXd first = Column(text, &whole);
    trial.columns.resize(first.size(), second.empty() ? 1 : 2);
    trial.columns.col(0) = first;
    if (!second.empty()) trial.columns.col(1) = Column(second, &whole_second);
    const bool own = trial.columns.col(0).norm() > kOwnShare * whole &&
                     (second.empty() || trial.columns.col(1).norm() > kOwnShare * whole_second);
    if (own) trials_.push_back(std::move(trial));
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
    powers(v, 3, v);
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
      Add("s*" + text, "", factors + 1, 0);
    }
    Add("s^3", "", 2, 0);
    Add(signed_v, "", 1, 0);
    Add(x + "*" + signed_v, "", 2, 0);
    Add("s*" + x + "*" + v, "", 3, 0);
    for (size_t i = 0; i < others.size(); ++i) {
      Add(others[i] + "*" + signed_v, "", 2, 0);
      Add("s*" + others[i] + "*" + x, "", 3, 0);
      Add("s*" + others[i] + "*" + v, "", 3, 0);
      Add(others[i] + "*" + x, "", 2, 0);
      for (size_t j = 0; j < i; ++j) Add("s*" + others[i] + "*" + others[j], "", 3, 0);
    }
  }

  /// Wave number [1/m] that takes most from the residual: coarse scan on thinned places, then a
  /// finer one around the best. 0: the motion is too short to tell.
  double FindWave(const Eigen::VectorXd& residual, bool turned) {
    if (!places_known_) CollectRows();
    if (row_x_.empty()) return 0;
    const double span = x_high_ - x_low_;
    if (!(span > 0)) return 0;
    const double first = 1.5 / span, last = 300 / span, step = 0.25 / span;
    waves_ = (last - first) / step;
    const auto power = [&](double wave) {
      double c = 0, s = 0;
      for (size_t i = 0; i < row_x_.size(); ++i) {
        const double a = 2 * M_PI * wave * row_x_[i];
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

  /// x, s and weight on (at most 6000 of) the rows, read off through the caller's own columns.
  void CollectRows() {
    places_known_ = true;
    std::vector<std::vector<double>> x, s, one;
    for (const auto& run : data_.places) {
      x.emplace_back(), s.emplace_back(), one.emplace_back(run.size(), 1.0);
      for (const ForcePlace& at : run) {
        x.back().push_back(at.piston), s.back().push_back(at.direction);
      }
    }
    const Eigen::VectorXd w = data_.column(one), wx = data_.column(x), ws = data_.column(s);
    const Eigen::Index stride = std::max<Eigen::Index>(1, w.size() / 6000);
    for (Eigen::Index i = 0; i < w.size(); i += stride) {
      if (!(w[i] > 0)) continue;
      row_.push_back(static_cast<size_t>(i)), row_weight_.push_back(w[i]);
      row_x_.push_back(wx[i] / w[i]), row_s_.push_back(std::clamp(ws[i] / w[i], -1.0, 1.0));
      x_low_ = std::min(x_low_, row_x_.back()), x_high_ = std::max(x_high_, row_x_.back());
    }
  }

  const FormulaData& data_;
  const Eigen::MatrixXd& model_space_;
  const Scale scale_;
  std::vector<Trial> trials_;
  bool places_known_ = false;
  std::vector<size_t> row_;
  std::vector<double> row_x_, row_s_, row_weight_;
  double x_low_ = INFINITY, x_high_ = -INFINITY, waves_ = 1;
};

Eigen::MatrixXd Joined(const std::vector<Trial>& terms) {
  Eigen::Index count = 0;
  for (const Trial& t : terms) count += t.columns.cols();
  Eigen::MatrixXd out(terms.empty() ? 0 : terms[0].columns.rows(), count);
  Eigen::Index at = 0;
  for (const Trial& t : terms) {
    out.middleCols(at, t.columns.cols()) = t.columns;
    at += t.columns.cols();
  }
  return out;
}

Eigen::VectorXd Solve(const Eigen::MatrixXd& columns, const Eigen::VectorXd& residual) {
  return columns.colPivHouseholderQr().solve(residual);
}

/// Evidence for going from `before` to `after` with `count` more numbers.
double Evidence(const FormulaData& data, const Eigen::VectorXd& before,
                const Eigen::VectorXd& after, Eigen::Index count, double tried) {
  const double n = data.independent(after);
  return n * std::log(before.squaredNorm() / std::max(after.squaredNorm(), 1e-300)) -
         static_cast<double>(count) * std::log(n) - 2 * tried;
}

/// Share of the rms that the terms remove from blocks on which they were not fitted.
double CrossValidate(const Eigen::MatrixXd& columns, const Eigen::VectorXd& residual) {
  constexpr int kBlocks = 8;
  const Eigen::Index n = residual.size();
  double held = 0;
  for (int b = 0; b < kBlocks; ++b) {
    const Eigen::Index begin = b * n / kBlocks, count = (b + 1) * n / kBlocks - begin;
    Eigen::MatrixXd c = columns;
    Eigen::VectorXd r = residual;
    c.middleRows(begin, count).setZero();
    r.segment(begin, count).setZero();
    const Eigen::VectorXd x = Solve(c, r);
    held += (residual.segment(begin, count) - columns.middleRows(begin, count) * x).squaredNorm();
  }
  return 1 - std::sqrt(held / std::max(residual.squaredNorm(), 1e-300));
}

/// Orthonormal basis of what the model's free numbers can imitate.
Eigen::MatrixXd ModelSpace(const Eigen::MatrixXd& jacobian, Eigen::Index rows) {
  if (jacobian.cols() == 0) return Eigen::MatrixXd(rows, 0);
  Eigen::MatrixXd scaled = jacobian;
  for (Eigen::Index j = 0; j < scaled.cols(); ++j) {
    const double norm = scaled.col(j).norm();
    if (norm > 0) scaled.col(j) /= norm;
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(scaled);
  qr.setThreshold(1e-7);
  return qr.householderQ() * Eigen::MatrixXd::Identity(rows, qr.rank());
}

void DropSuperfluous(const FormulaData& data, const FormulaLimits& limits,
                     const Eigen::VectorXd& residual, double tried, std::vector<Trial>* terms) {
  for (size_t i = 0; i < terms->size() && terms->size() > 1;) {
    std::vector<Trial> rest = *terms;
    rest.erase(rest.begin() + static_cast<long>(i));
    const Eigen::MatrixXd with = Joined(*terms), without = Joined(rest);
    const Eigen::VectorXd after = residual - with * Solve(with, residual);
    const Eigen::VectorXd before = residual - without * Solve(without, residual);
    const double evidence =
        Evidence(data, before, after, (*terms)[i].columns.cols(), tried + (*terms)[i].looked_at);
    if (evidence < limits.threshold) {
      *terms = rest;
      i = 0;
    } else {
      ++i;
    }
  }
}

}  // namespace

FoundFormula SearchFormula(const FormulaData& data, const FormulaLimits& limits) {
  FoundFormula out;
  const Eigen::MatrixXd space = ModelSpace(data.jacobian, data.residual.size());
  const Eigen::VectorXd residual = data.residual - space * (space.transpose() * data.residual);
  Library library(data, space);
  std::vector<Trial> terms;
  std::vector<FormulaTerm> words;
  Eigen::VectorXd now = residual;
  const double tried = std::log(std::max<size_t>(2, library.trials().size()));
  for (int round = 0; round < limits.max_terms; ++round) {
    const size_t lasting = library.trials().size();
    library.AddWaves(now);
    const Trial* best = nullptr;
    double best_score = -std::numeric_limits<double>::infinity(), best_evidence = 0, best_gain = 0;
    const double independent = data.independent(now);
    const Eigen::MatrixXd taken =
        terms.empty() ? Eigen::MatrixXd(now.size(), 0) : ModelSpace(Joined(terms), now.size());
    for (const Trial& trial : library.trials()) {
      const Eigen::MatrixXd own = trial.columns - taken * (taken.transpose() * trial.columns);
      const Eigen::MatrixXd normal = own.transpose() * own;
      // A term that those taken already imitate brings nothing.
      if (normal.diagonal().minCoeff() < 1e-6 * trial.columns.squaredNorm()) continue;
      const Eigen::VectorXd right = own.transpose() * now;
      const double taken_off = right.dot(normal.ldlt().solve(right)) / now.squaredNorm();
      if (!(taken_off > 0 && taken_off < 1)) continue;
      const double score = -independent * std::log(1 - taken_off) - 2 * trial.looked_at -
                           2 * trial.factors -
                           static_cast<double>(trial.columns.cols()) * std::log(independent);
      if (score > best_score) best = &trial, best_score = score;
    }
    if (best != nullptr) {
      std::vector<Trial> joined = terms;
      joined.push_back(*best);
      const Eigen::MatrixXd columns = Joined(joined);
      const Eigen::VectorXd after = residual - columns * Solve(columns, residual);
      best_evidence = Evidence(data, now, after, best->columns.cols(), tried + best->looked_at);
      best_gain = 1 - after.norm() / std::max(now.norm(), 1e-300);
    }
    if (best == nullptr || best_evidence < limits.threshold || best_gain < limits.min_gain) break;
    terms.push_back(*best);
    words.push_back({best->text, best->second, best_evidence, best_gain});
    library.trials().resize(lasting);
    const Eigen::MatrixXd columns = Joined(terms);
    now = residual - columns * Solve(columns, residual);
  }
  if (terms.empty()) return out;
  DropSuperfluous(data, limits, residual, tried, &terms);
  std::erase_if(words, [&](const FormulaTerm& w) {
    return std::none_of(terms.begin(), terms.end(),
                        [&](const Trial& t) { return t.text == w.text; });
  });
  const Eigen::MatrixXd columns = Joined(terms);
  const Eigen::VectorXd x = Solve(columns, residual);
  out.gain = 1 - (residual - columns * x).norm() / std::max(residual.norm(), 1e-300);
  out.cross_validation_gain = CrossValidate(columns, residual);
  if (out.cross_validation_gain <= 0) return {};
  out.terms = std::move(words);
  out.coefficients.assign(x.data(), x.data() + x.size());
  int k = 0;
  for (const FormulaTerm& term : out.terms) {
    for (const std::string& text : {term.text, term.second}) {
      if (!text.empty()) out.text += fmt::format("{}c{}*{}", k > 0 ? " + " : "", k + 1, text), ++k;
    }
  }
  return out;
}

}  // namespace phs::identify
