#include "identify/models/joined_forward.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/words.h"
#include "identify/fit/effect_variants.h"
#include "phs_model/phs_model.h"

namespace phs::identify::search {

using hydraulics::PhsParams;
namespace {

bool IsNamed(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

double NumberOf(const PhsParams& params, const std::string& name) {
  return phs_model::GetParameter(params, name).value();
}

/// Declared value of a number that all share: the geometric mean, or the mean where one is not
/// positive.
double SharedStart(const std::vector<JoinedPart>& parts, const std::string& name) {
  double logs = 0, sum = 0, least = 1e300;
  for (const JoinedPart& part : parts) {
    const double value = NumberOf(part.declared, name);
    logs += std::log(std::max(value, 1e-300)), sum += value, least = std::min(least, value);
  }
  const auto count = static_cast<double>(parts.size());
  return least > 0 ? std::exp(logs / count) : sum / count;
}

/// Every model knows every free number.
Status CheckKnown(const std::vector<JoinedPart>& parts, const FreeModel& common) {
  for (const JoinedPart& part : parts) {
    for (const FreeParameter& p : common.free) {
      const Result<double> value = phs_model::GetParameter(part.declared, p.name);
      if (value.ok() && (value.value() > 0 || !p.logarithmic)) continue;
      return Error{part.declared.name + ": " + p.name,
                   "is free in " + parts.front().declared.name + " and is not, or is 0, here",
                   "models of one structure", "name the free numbers under free:"};
    }
  }
  return {};
}

/// The number begun at `start`, with bounds as far from it as they were.
FreeParameter BegunAt(FreeParameter number, const std::string& name, double start) {
  const double before = number.start;
  number.name = name, number.start = start;
  if (number.logarithmic && before > 0 && start > 0) {
    number.low *= start / before, number.high *= start / before;
  } else {
    number.low += start - before, number.high += start - before;
  }
  return number;
}

}  // namespace

std::string NameOfRun(size_t run, const std::string& number) {
  return "run" + std::to_string(run + 1) + "." + number;
}

Result<std::shared_ptr<const JoinedForward>> JoinedForward::Create(
    std::vector<JoinedPart> parts, const std::vector<std::string>& shared,
    std::shared_ptr<const measurement::JoinedData> data, std::shared_ptr<const ForwardModel> lead) {
  auto out = std::shared_ptr<JoinedForward>(new JoinedForward);
  out->lead_ = lead != nullptr ? std::move(lead) : parts.front().forward;
  out->data_ = std::move(data);
  out->declared_ = parts.front().declared;
  const FreeModel common = out->lead_->Declared(out->declared_);
  std::vector<std::string> names;
  for (const FreeParameter& p : common.free) names.push_back(p.name);
  for (const std::string& name : shared) {
    if (IsNamed(names, name)) continue;
    return Error{"shared", "\"" + name + "\" is no number that is fitted", JoinWords(names),
                 DidYouMean(name, names)};
  }
  if (Status s = CheckKnown(parts, common); !s.ok()) return s.error();
  for (const FreeParameter& p : common.free) {
    if (IsNamed(shared, p.name)) {
      out->shared_.push_back(p.name);
      out->free_.free.push_back(BegunAt(p, p.name, SharedStart(parts, p.name)));
      continue;
    }
    out->own_.push_back(p.name);
    for (size_t r = 0; r < parts.size(); ++r) {
      const double value = NumberOf(parts[r].declared, p.name);
      out->declared_.of_runs[NameOfRun(r, p.name)] = value;
      out->free_.free.push_back(BegunAt(p, NameOfRun(r, p.name), value));
    }
  }
  for (const JoinedPart& part : parts) {
    const auto& blocks = part.forward->Measured();
    const bool some = std::any_of(blocks.begin(), blocks.end(),
                                  [](const MeasuredBlock& b) { return !b.values.empty(); });
    out->fitted_.push_back(some);
    if (some) out->measured_.insert(out->measured_.end(), blocks.begin(), blocks.end());
  }
  const auto idle = std::find(out->fitted_.begin(), out->fitted_.end(), 0);
  if (!out->own_.empty() && idle != out->fitted_.end()) {
    const auto r = static_cast<size_t>(idle - out->fitted_.begin());
    return Error{"runs",
                 "run " + std::to_string(r + 1) +
                     " has numbers of its own and no estimation "
                     "window to fit them in",
                 "a window in every run", "or share them: " + JoinWords(out->own_)};
  }
  out->parts_ = std::move(parts);
  return std::shared_ptr<const JoinedForward>(std::move(out));
}

PhsParams JoinedForward::ParamsOf(const PhsParams& all, size_t run) const {
  PhsParams out = parts_[run].declared;
  for (const std::string& name : shared_) {
    PHS_CHECK(phs_model::SetParameter(&out, name, NumberOf(all, name)).ok());
  }
  for (const std::string& name : own_) {
    const auto own = all.of_runs.find(NameOfRun(run, name));
    if (own == all.of_runs.end()) continue;
    PHS_CHECK(phs_model::SetParameter(&out, name, own->second).ok());
  }
  for (const hydraulics::EffectParams& effect : all.effects) {
    if (!IsIn(parts_[run].declared, effect.name)) out.effects.push_back(effect);
  }
  return out;
}

Channels JoinedForward::Join(const std::vector<Channels>& runs) const {
  const size_t count = data_->data.time_s.size();
  Channels out(data_->data.outputs.size(), std::vector<double>(count, 0.0));
  for (size_t r = 0; r < runs.size(); ++r) {
    for (size_t c = 0; c < runs[r].size(); ++c) {
      std::vector<double>& channel = out[static_cast<size_t>(data_->outputs[r][c])];
      for (const auto& place : data_->places[r]) {
        channel[static_cast<size_t>(place.joined)] = runs[r][c][static_cast<size_t>(place.sample)];
      }
    }
  }
  return out;
}

Status JoinedForward::Each(Asked ask, const PhsParams& params, Span span, Channels* out) const {
  out->clear();
  std::vector<Channels> whole;
  for (size_t r = 0; r < parts_.size(); ++r) {
    if (span == Span::kEstimation && !fitted_[r]) continue;
    Channels run;
    Status done = (parts_[r].forward.get()->*ask)(ParamsOf(params, r), span, &run);
    if (!done.ok()) return done;
    if (span == Span::kWhole) {
      whole.push_back(std::move(run));
    } else {
      std::move(run.begin(), run.end(), std::back_inserter(*out));
    }
  }
  if (span == Span::kWhole) *out = Join(whole);
  return {};
}

Status JoinedForward::Run(const PhsParams& params, Span span, Channels* out) const {
  return Each(&ForwardModel::Run, params, span, out);
}

Status JoinedForward::Uncertainty(const PhsParams& params, Span span, Channels* deviation) const {
  return Each(&ForwardModel::Uncertainty, params, span, deviation);
}

Status JoinedForward::TheoryDifferences(const PhsParams& params, Span span,
                                        std::vector<Channels>* differences) const {
  return EachSet(&ForwardModel::TheoryDifferences, params, span, differences);
}

Status JoinedForward::InputErrors(const PhsParams& params, Span span,
                                  std::vector<Channels>* draws) const {
  return EachSet(&ForwardModel::InputErrors, params, span, draws);
}

Status JoinedForward::EachSet(AskedSets ask, const PhsParams& params, Span span,
                              std::vector<Channels>* out) const {
  out->clear();
  std::vector<std::vector<Channels>> runs;
  size_t most = 0;
  for (size_t r = 0; r < parts_.size(); ++r) {
    if (span == Span::kEstimation && !fitted_[r]) continue;
    std::vector<Channels>& own = runs.emplace_back();
    Status done = (parts_[r].forward.get()->*ask)(ParamsOf(params, r), span, &own);
    if (!done.ok()) return done;
    if (own.empty()) return {};
    most = std::max(most, own.size());
  }
  for (size_t t = 0; t < most; ++t) {
    std::vector<Channels> one;
    for (std::vector<Channels>& own : runs) {
      one.push_back(t < own.size() ? own[t] : own.front());
      if (t < own.size()) continue;  // a set that this run does not know
      for (std::vector<double>& row : one.back()) std::fill(row.begin(), row.end(), 0.0);
    }
    if (span == Span::kWhole) {
      out->push_back(Join(one));
      continue;
    }
    Channels& all = out->emplace_back();
    for (Channels& run : one) std::move(run.begin(), run.end(), std::back_inserter(all));
  }
  return {};
}

Result<FormulaFrame> JoinedForward::Frame(const PhsParams& params,
                                          const std::string& channel) const {
  FormulaFrame frame;
  std::vector<std::function<Channels(const Channels&)>> rows;
  std::vector<size_t> records;
  for (size_t r = 0; r < parts_.size(); ++r) {
    if (!fitted_[r]) continue;
    Result<FormulaFrame> own = parts_[r].forward->Frame(ParamsOf(params, r), channel);
    if (!own.ok()) return own.error();
    rows.push_back(own.value().rows), records.push_back(own.value().places.size());
    std::vector<std::vector<hydraulics::ForcePlace>> places = std::move(frame.places);
    std::move(own.value().places.begin(), own.value().places.end(), std::back_inserter(places));
    frame = std::move(own).value();
    frame.places = std::move(places);
  }
  frame.has_time_waves = false;
  frame.rows = [rows, records](const Channels& values) {
    Channels out;
    size_t next = 0;
    for (size_t r = 0; r < rows.size(); ++r) {
      const auto begin = values.begin() + static_cast<long>(next);
      next += records[r];
      Channels own = rows[r]({begin, values.begin() + static_cast<long>(next)});
      std::move(own.begin(), own.end(), std::back_inserter(out));
    }
    return out;
  };
  return frame;
}

bool JoinedForward::TellsLines() const {
  return std::all_of(parts_.begin(), parts_.end(),
                     [](const JoinedPart& part) { return part.forward->TellsLines(); });
}

FreeModel JoinedForward::Declared(const PhsParams& declared) const {
  FreeModel out = free_;
  out.params = declared;
  out.params.of_runs = declared_.of_runs;
  return out;
}

std::vector<Candidate> JoinedForward::Candidates(const PhsParams& params) const {
  std::vector<Candidate> out = lead_->Candidates(ParamsOf(params, 0));
  // Each run has a clock of its own: nothing begins at one time in all.
  const auto begins = [](const FreeParameter& p) { return IsInstant(p.name); };
  std::erase_if(out, [&](Candidate& c) {
    std::erase_if(c.options, [&](const EffectOption& option) {
      return std::any_of(option.free.begin(), option.free.end(), begins);
    });
    return std::any_of(c.free.begin(), c.free.end(), begins);
  });
  return out;
}

std::shared_ptr<const ForwardModel> JoinedForward::Driven(const rigs::RigMotion& motion,
                                                          double until_s) const {
  auto driven = parts_.front().forward->Driven(motion, until_s);
  if (driven == nullptr) return nullptr;
  auto out = std::shared_ptr<JoinedForward>(new JoinedForward(*this));
  out->parts_ = {{std::move(driven), parts_.front().declared}};
  out->fitted_ = {1}, out->measured_ = out->parts_.front().forward->Measured();
  return out;
}

std::shared_ptr<const ForwardModel> JoinedForward::About(const PhsParams& params) const {
  auto out = std::shared_ptr<JoinedForward>(new JoinedForward(*this));
  bool any = false;
  for (size_t r = 0; r < parts_.size(); ++r) {
    auto about = parts_[r].forward->About(ParamsOf(params, r));
    if (about == nullptr) continue;
    out->parts_[r].forward = std::move(about), any = true;
  }
  return any ? out : nullptr;
}

std::shared_ptr<const ForwardModel> JoinedForward::Coarse(double step_s) const {
  auto out = std::shared_ptr<JoinedForward>(new JoinedForward(*this));
  out->measured_.clear();
  for (size_t r = 0; r < parts_.size(); ++r) {
    out->parts_[r].forward = parts_[r].forward->Coarse(step_s);
    if (!fitted_[r]) continue;
    const auto& blocks = out->parts_[r].forward->Measured();
    out->measured_.insert(out->measured_.end(), blocks.begin(), blocks.end());
  }
  return out;
}

}  // namespace phs::identify::search
