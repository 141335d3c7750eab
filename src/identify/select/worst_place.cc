#include "identify/select/worst_place.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "effects/catalogue.h"

namespace phs::identify::search {
namespace {

bool IsAlone(const Candidate& c) { return c.params.targets.size() == 1; }

std::string FamilyOf(const Candidate& c) {
  const hydraulics::EffectInfo* info = effects::Catalogue().FindFor(c.params);
  return info != nullptr ? info->family : "";
}

/// The cylinder whose load cell leaves most over its noise; empty if none leaves more than that.
std::string WorstLoadCell(const FitProblem& problem, const hydraulics::PhsParams& params,
                          const FitResult& fit) {
  constexpr double kNoise = 1.1;  // mean square over that of noise
  std::string worst;
  double most = kNoise;
  for (size_t i = 0; i < params.cylinders.size(); ++i) {
    const int channel = problem.FindOutput("load" + std::to_string(i + 1) + "_N");
    if (channel < 0) continue;
    const double ms = fit.channel_ms[static_cast<size_t>(channel)];
    if (ms > most) most = ms, worst = params.cylinders[i].name;
  }
  return worst;
}

/// What a candidate's single number takes of -2 ln L to first order.
class FirstOrder {
 public:
  FirstOrder(const FitProblem& problem, const FreeModel& model, const FitResult& fit)
      : problem_(problem), model_(model), fit_(fit) {
    weight_ = problem.likelihood().Weights(fit.powers);
    const Eigen::MatrixXd slopes = weight_.asDiagonal() * fit.slopes;
    const Eigen::HouseholderQR<Eigen::MatrixXd> qr(slopes);
    basis_ = qr.householderQ() * Eigen::MatrixXd::Identity(slopes.rows(), slopes.cols());
    left_ = Beside(problem.likelihood().Transform(fit.residual));
  }

  double Takes(const Candidate& candidate) const {
    std::vector<double> values = fit_.values;
    values.push_back(candidate.none.front());
    Eigen::VectorXd residual;
    Eigen::MatrixXd own;
    if (!problem_.Linearise(WithCandidate(model_, candidate), values,
                            static_cast<int>(fit_.values.size()), &residual, &own)) {
      return 0;
    }
    const Eigen::VectorXd does = Beside(problem_.likelihood().Transform(own).col(0));
    const double square = does.squaredNorm();
    return square > 0 ? std::pow(does.dot(left_), 2) / square : 0;
  }

 private:
  Eigen::VectorXd Beside(const Eigen::VectorXd& coefficients) const {
    const Eigen::VectorXd weighted = weight_.cwiseProduct(coefficients);
    return weighted - basis_ * (basis_.transpose() * weighted);
  }

  const FitProblem& problem_;
  const FreeModel& model_;
  const FitResult& fit_;
  Eigen::VectorXd weight_, left_;
  Eigen::MatrixXd basis_;
};

/// Its number's slope where it does nothing is known.
bool IsSimple(const Candidate& c) {
  return IsAlone(c) && c.free.size() == 1 && !(c.free[0].logarithmic && c.none[0] == 0);
}

}  // namespace

void KeepWorstPlace(const FitProblem& problem, const FreeModel& model, const FitResult& fit,
                    std::vector<Candidate>* candidates) {
  struct Place {
    std::string name;
    double takes = 0;
  };
  const std::string loudest = WorstLoadCell(problem, model.params, fit);
  std::map<std::string, Place> worst;  // of each family
  for (const Candidate& c : *candidates) {
    if (c.shows_at_place && IsAlone(c)) worst.try_emplace(FamilyOf(c), Place{loudest});
  }
  if (!loudest.empty() && !worst.empty()) {
    const FirstOrder first(problem, model, fit);
    for (const Candidate& c : *candidates) {
      const auto of_family = worst.find(FamilyOf(c));
      if (of_family == worst.end() || !IsSimple(c)) continue;
      const double takes = first.Takes(c);
      if (takes > of_family->second.takes) of_family->second = {c.params.targets.front(), takes};
    }
  }
  std::erase_if(*candidates, [&](const Candidate& c) {
    return c.shows_at_place && IsAlone(c) && c.params.targets.front() != worst[FamilyOf(c)].name;
  });
}

}  // namespace phs::identify::search
