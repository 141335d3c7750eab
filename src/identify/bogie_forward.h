// A bogie on its track as a fit sees it: a scenario simulated with MuJoCo, its outputs taken where
// the measured vehicle was.
//
// The numbers of a fit are those of a PHS model (hydraulics::PhsParams): the declared PHS of the
// scenario and, in its list of effects, whatever is tried. Effects of wheel and track
// (vehicle/running_effects.h) stand in the same list and are taken out of it before a run; so one
// search serves both. Nothing measured drives the run but the track, the speed and the place: the
// whole run is predicted.
//
// Place, not time, joins run and measurement: output(t_i) is that of the simulated vehicle where
// its leading wheelset has come as far along the track as the measured one had at t_i. A speed that
// is not quite held so moves no curve; what it does to the forces is not followed.
#pragma once

#include <string>
#include <vector>

#include "identify/effect_variants.h"
#include "identify/record_forward.h"
#include "measurement/fit_data.h"
#include "vehicle/scenario.h"
#include "vehicle/simulation.h"

namespace phs::identify::search {

/// What is declared of a bogie on a track.
struct BogieModel {
  vehicle::Scenario scenario;
  hydraulics::PhsParams phs;            ///< the scenario's, with its own changes
  std::vector<std::string> free;        ///< free numbers of the baseline
  std::vector<std::string> candidates;  ///< effects to look for; empty: all
  std::vector<std::string> observed;    ///< every channel that a run records
  std::vector<std::string> unit;        ///< of each
  double start_m = 0;                   ///< place of the leading wheelset when a run starts
  double friction = 0;                  ///< of wheel on rail
  double track_length_m = 0;
};

/// Loads scenario and PHS and looks at one instant of the run. Errors: what the files say wrongly,
/// a bogie without PHS, free numbers that it does not have.
Result<BogieModel> LoadBogieModel(const std::string& scenario, const std::vector<std::string>& free,
                                  const std::vector<std::string>& candidates);

/// The scenario with the numbers and effects of `params` put in: what runs, and what is written.
Result<vehicle::Scenario> ScenarioWith(const BogieModel& model,
                                       const hydraulics::PhsParams& params);

/// Channel of a run that a measured column stands for: itself, or of a rig's names "piston1_m",
/// "load1_N", "pL1_Pa". Empty: none.
std::string RunChannelOf(const BogieModel& model, const std::string& column);

class BogieForward final : public RecordForward {
 public:
  /// `data` must outlive it; its driving motion is the place of the leading wheelset.
  BogieForward(const measurement::FitData& data, BogieModel model, int stride = 1);

  FreeModel Declared(const hydraulics::PhsParams& declared) const override;
  std::vector<Candidate> Candidates(const hydraulics::PhsParams& params) const override;
  std::shared_ptr<const ForwardModel> Coarse(double step_s) const override;

 private:
  Status RunSpan(const hydraulics::PhsParams& params, Span span, Channels* out) const override;
  /// What the creep theory leaves open: rms difference over the span between two laws of creep that
  /// agree where slip is small (Kalker's linear theory) and differ towards saturation.
  Status UncertaintySpan(const hydraulics::PhsParams& params, Span span,
                         Channels* deviation) const override;
  Status RunScenario(vehicle::Scenario scenario, Span span, Channels* out) const;
  size_t Rows(Span span) const;

  const measurement::FitData& data_;
  BogieModel model_;
  int stride_ = 1;
};

}  // namespace phs::identify::search
