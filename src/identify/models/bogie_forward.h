// A bogie on its track as a fit sees it: a scenario simulated with MuJoCo, its outputs taken where
// the measured vehicle was.
//
// The numbers of a fit are those of a PHS model (hydraulics::PhsParams): the declared PHS of the
// scenario and, in its list of effects, whatever is tried. Effects of wheel and track
// (vehicle/running_effects.h) stand in the same list and are taken out of it before a run; so one
// search serves both. Nothing measured drives the run but the track, the speed and the place;
// forces and pressures of the PHS are those at the measured ways where all of these are
// (measured_ways.h).
//
// Place, not time, joins run and measurement: output(t_i) is that of the simulated vehicle where
// its leading wheelset has come as far along the track as the measured one had at t_i. A speed that
// is not quite held so moves no curve; what it does to the forces is not followed.
#pragma once

#include <deque>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "identify/fit/effect_variants.h"
#include "identify/models/bogie_model.h"
#include "identify/models/measured_ways.h"
#include "identify/models/record_forward.h"
#include "measurement/fit_data.h"

namespace phs::identify::search {

/// The last runs by what was run.
class KeptRuns {
 public:
  bool Find(const std::string& key, Channels* out);
  void Keep(const std::string& key, const Channels& run);

 private:
  std::mutex mutex_;
  std::deque<std::pair<std::string, Channels>> runs_;
};

class BogieForward final : public RecordForward {
 public:
  /// `data` must outlive it; its driving motion is the place of the leading wheelset.
  BogieForward(const measurement::FitData& data, BogieModel model, int stride = 1);

  FreeModel Declared(const hydraulics::PhsParams& declared) const override;
  std::vector<Candidate> Candidates(const hydraulics::PhsParams& params) const override;
  std::shared_ptr<const ForwardModel> Coarse(double step_s) const override;
  bool CoarseRunsAsLong() const override { return true; }
  /// By measured ways: the vehicle runs with the PHS of `params`, so that the numbers of the PHS
  /// come from its forces and pressures alone. Where axles find their place (0.04 to 0.08 mm between
  /// two programs) would else pull them.
  std::shared_ptr<const ForwardModel> About(const hydraulics::PhsParams& params) const override;
  /// The longest stable step, if by it the run up to the end of the estimation window differs by no
  /// more than a tenth of the noise in any channel; else 0.
  Result<double> FitStep(const hydraulics::PhsParams& params) const;
  /// True if forces and pressures are those at the measured ways.
  bool ByMeasuredWays() const { return ways_ != nullptr; }

 private:
  Status RunSpan(const hydraulics::PhsParams& params, Span span, Channels* out) const override;
  /// For the measured ways: nothing else that is uncertain drives it.
  Status UncertaintySpan(const hydraulics::PhsParams& params, Span span,
                         Channels* deviation) const override;
  Status InputErrorsSpan(const hydraulics::PhsParams& params, Span span,
                         std::vector<Channels>* draws) const override;
  Channels NoErrors(Span span) const;  ///< zeros for every output
  /// Other laws than its own that agree where slip, or presliding, is small and where all slides,
  /// and differ between; at measured ways also how pistons tremble and where axles find their place.
  Status TheorySpan(const hydraulics::PhsParams& params, Span span,
                    std::vector<Channels>* differences) const override;
  hydraulics::PhsParams OfVehicle(const hydraulics::PhsParams& params, Span span) const;
  Status RunTheory(vehicle::Scenario scenario, const hydraulics::PhsParams& params, Span span,
                   Channels* out) const;
  /// On the rows of the span.
  Status RunScenario(vehicle::Scenario scenario, Span span, Channels* out) const;
  /// Every sample of the span, from the last runs where it is one of them.
  Status RunKept(vehicle::Scenario scenario, Span span, Channels* out) const;
  /// Every sample from the first on, so many.
  Status Simulate(const vehicle::Scenario& scenario, size_t samples, Channels* out,
                  double* largest_step_s = nullptr) const;
  size_t Samples(Span span) const;

  const measurement::FitData& data_;
  BogieModel model_;
  int stride_ = 1;
  std::shared_ptr<KeptRuns> kept_;  ///< shared with what Coarse() gave
  std::shared_ptr<const MeasuredWays> ways_;
  std::shared_ptr<const hydraulics::PhsParams> held_;  ///< PHS of the vehicle's run; null: as asked
};

}  // namespace phs::identify::search
