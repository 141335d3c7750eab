// The plugin's own numerics of a tree of bodies against MuJoCo's: bias at any speed, mass matrix, the
// matrix of a half step.
#include "plugin/step_matrix.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "plugin/bias.h"
#include "plugin/dof_chain.h"
#include "tests/plugin/attached_model.h"

namespace phs::plugin {
namespace {

/// Every kind of joint, two branches.
constexpr char kTree[] =
    "<mujoco><option gravity='0.3 -0.2 -9.81'/><worldbody><body name='a' pos='0 0 1'><freejoint/>"
    "<inertial pos='0.1 0.2 0.3' mass='3' diaginertia='1 2 2.5'/><body name='b' pos='1 0 0'>"
    "<joint type='slide' axis='1 1 0'/><joint axis='0 1 1'/><joint axis='1 0 0' pos='0 0.2 0'/>"
    "<inertial pos='0 0.1 0' mass='2' diaginertia='0.5 0.6 0.7'/><body name='c' pos='0 1 0'>"
    "<joint type='ball'/><inertial pos='0.3 0 0' mass='1' diaginertia='0.1 0.2 0.2'/></body></body>"
    "<body name='d' pos='-1 0 0'><joint axis='0 0 1'/><joint type='slide' axis='0 1 0'/>"
    "<inertial pos='0 0 0.2' mass='1.5' diaginertia='0.3 0.2 0.4'/></body></body></worldbody>"
    "</mujoco>";

class TreeTest : public testing::Test {
 protected:
  TreeTest() : m_(LoadText(kTree)), d_(mj_makeData(m_.get())) {
    for (int i = 0; i < m_->nv; ++i) d_->qvel[i] = one_(random_);
    mj_integratePos(m_.get(), d_->qpos, d_->qvel, 0.7);
    mj_forward(m_.get(), d_.get());
  }
  std::vector<double> Draw(int count) {
    std::vector<double> x(static_cast<size_t>(count));
    for (double& value : x) value = one_(random_);
    return x;
  }

  EngineGuard guard_;
  std::mt19937 random_{7};
  std::uniform_real_distribution<> one_{-1, 1};
  ModelPtr m_;
  DataPtr d_;
};

TEST_F(TreeTest, BiasAtAnySpeedEqualsMuJoCos) {
  for (int draw = 0; draw < 20; ++draw) {
    const std::vector<double> w = Draw(m_->nv);
    std::vector<double> bias(w.size());
    const std::vector<double> before(d_->cvel, d_->cvel + 6 * m_->nbody);
    CalcBiasAt(m_.get(), d_.get(), w.data(), bias.data());
    EXPECT_EQ(before, std::vector<double>(d_->cvel, d_->cvel + 6 * m_->nbody));
    std::copy(w.begin(), w.end(), d_->qvel);
    mj_forward(m_.get(), d_.get());
    for (int i = 0; i < m_->nv; ++i) {
      EXPECT_NEAR(bias[static_cast<size_t>(i)], d_->qfrc_bias[i], 1e-13 * 60) << i;
    }
  }
}

TEST_F(TreeTest, MassTimesVectorEqualsMuJoCos) {
  const std::vector<double> x = Draw(m_->nv);
  std::vector<double> ours(x.size()), theirs(x.size());
  const std::vector<int> ancestors = AncestorsOf(m_.get());
  std::vector<double> entries(static_cast<size_t>(m_->nM + m_->nv));
  StepMatrix(m_.get(), ancestors.data(), entries.data()).MulMass(d_.get(), x.data(), ours.data());
  mj_mulM(m_.get(), d_.get(), theirs.data(), x.data());
  for (size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(ours[i], theirs[i], 1e-14 * 10) << i;
}

TEST_F(TreeTest, SpatialDampersSolveAsTheirOuterProducts) {
  const int nv = m_->nv;
  const std::vector<int> chain = DofChain(m_.get(), mj_name2id(m_.get(), mjOBJ_BODY, "c"));
  std::vector<double> entries(static_cast<size_t>(m_->nM + nv)), others(entries);
  const std::vector<int> ancestors = AncestorsOf(m_.get());
  StepMatrix matrix(m_.get(), ancestors.data(), entries.data());
  StepMatrix other(m_.get(), ancestors.data(), others.data());
  matrix.SetMass(d_.get());
  other.SetMass(d_.get());
  SpatialMatrix sum{};
  for (int k = 0; k < 3; ++k) {
    const std::vector<double> g = Draw(6);
    std::vector<double> row(static_cast<size_t>(nv));
    for (const int dof : chain) {
      for (int c = 0; c < 6; ++c) {
        row[static_cast<size_t>(dof)] += d_->cdof[6 * dof + c] * g[static_cast<size_t>(c)];
      }
    }
    for (size_t i = 0; i < 6; ++i) {
      for (size_t j = 0; j < 3; ++j) {
        sum[i].first[j] += 2 * g[i] * g[j];
        sum[i].second[j] += 2 * g[i] * g[3 + j];
      }
    }
    other.AddOuter(2, row.data());
  }
  matrix.AddSpatial(sum, d_->cdof, chain.data(), static_cast<int>(chain.size()));
  // (M + C) x = b by the factors, C x by the rows.
  const std::vector<double> b = Draw(nv);
  std::vector<double> x = b, y = b;
  ASSERT_TRUE(matrix.Factor());
  ASSERT_TRUE(other.Factor());
  matrix.Solve(x.data());
  other.Solve(y.data());
  for (size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(x[i], y[i], 1e-12) << i;
  std::vector<double> back(x.size());
  matrix.MulMass(d_.get(), x.data(), back.data());
  std::vector<double> damped(6);
  for (const int dof : chain) {
    for (int c = 0; c < 6; ++c) {
      damped[static_cast<size_t>(c)] += d_->cdof[6 * dof + c] * x[static_cast<size_t>(dof)];
    }
  }
  for (const int dof : chain) {
    for (size_t i = 0; i < 6; ++i) {
      for (size_t j = 0; j < 6; ++j) {
        const double entry = j < 3 ? sum[i].first[j] : sum[i].second[j - 3];
        back[static_cast<size_t>(dof)] +=
            d_->cdof[6 * dof + static_cast<int>(i)] * entry * damped[j];
      }
    }
  }
  for (size_t i = 0; i < b.size(); ++i) EXPECT_NEAR(back[i], b[i], 1e-12) << i;
}

}  // namespace
}  // namespace phs::plugin
