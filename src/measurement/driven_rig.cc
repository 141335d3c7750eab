#include "measurement/driven_rig.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "measurement/zero_position.h"

namespace phs::measurement {
namespace {

Status CheckFinite(const DrivenRig& rig) {
  const auto& channels = rig.predicted.channels;
  for (size_t k = 0; k < channels.size(); ++k) {
    for (size_t i = 0; i < channels[k].size(); ++i) {
      if (std::isfinite(channels[k][i])) continue;
      const double t = rig.input.motion.t0_s + static_cast<double>(i) * rig.input.motion.step_s;
      return Error{rig.model.output_names()[k],
                   fmt::format("the model has no finite value at {:.6g} s", t), "",
                   "check the model's parameters; raise `substeps` in the manifest"};
    }
  }
  return {};
}

/// Motion and measured positions counted from elsewhere.
void TakeZeros(const ZeroPositions& zeros, RigCase* input) {
  for (size_t a = 0; a < input->motion.position_m.size(); ++a) {
    for (double& x : input->motion.position_m[a]) x -= zeros.inputs[a];
    for (double& x : input->run.inputs[a].y) x -= zeros.inputs[a];
  }
  for (size_t c = 0; c < input->run.outputs.size(); ++c) {
    for (double& x : input->run.outputs[c].y) x -= zeros.outputs[c];
  }
}

void CountFromStaticState(const rigs::RigModel& model, RigCase* input) {
  std::vector<BeginningChannel> inputs, outputs;
  std::vector<double> least;
  for (size_t a = 0; a < input->run.inputs.size(); ++a) {
    const Channel& channel = input->run.inputs[a];
    inputs.push_back({channel.name, input->motion.position_m[a].front(), 0});
    least.push_back(std::max(5 * channel.noise.level, 1e-5));
  }
  for (const Channel& c : input->run.outputs) outputs.push_back(BeginningOf(c.name, c.y));
  const PredictFrom predict =
      [&](const std::vector<double>& from) -> Result<std::vector<std::vector<double>>> {
    rigs::RigMotion motion = input->motion;
    for (size_t a = 0; a < motion.position_m.size(); ++a) {
      for (double& x : motion.position_m[a]) x -= from[a];
    }
    rigs::RigPrediction out;
    if (Status s = model.Run(motion, &out); !s.ok()) return s.error();
    return std::move(out.channels);
  };
  const ZeroPositions zeros = FindZeroPositions(inputs, least, outputs, predict);
  if (!zeros.any()) return;
  TakeZeros(zeros, input);
  NameZeros(inputs, zeros.inputs, &input->run.findings);
  NameZeros(outputs, zeros.outputs, &input->run.findings);
}

}  // namespace

std::vector<double> DrivenRig::Times() const {
  std::vector<double> t;
  t.reserve(static_cast<size_t>(input.motion.num_samples()));
  for (int i = 0; i < input.motion.num_samples(); ++i) {
    t.push_back(input.motion.t0_s + i * input.motion.step_s);
  }
  return t;
}

Result<DrivenRig> DriveRig(const Manifest& manifest, const hydraulics::PhsParams& params) {
  const Result<rigs::RigKind> kind = rigs::ParseRigKind(manifest.rig);
  if (!kind.ok()) return kind.error();
  Result<rigs::RigModel> made = rigs::RigModel::Create(kind.value(), params, manifest.options);
  if (!made.ok()) return made.error();
  Result<RigCase> input = ReadRigCase(manifest, made.value());
  if (!input.ok()) return input.error();
  if (input.value().run.extra) {  // further channels of the record, which its laws may read
    rigs::RigOptions options = manifest.options;
    options.extra = input.value().run.extra;
    made = rigs::RigModel::Create(kind.value(), params, options);
    if (!made.ok()) return made.error();
  }
  const bool by_position = manifest.options.driven_by == rigs::Drive::kPosition;
  if (by_position && kind.value() != rigs::RigKind::kElement && input.value().compared()) {
    CountFromStaticState(made.value(), &input.value());
  }
  DrivenRig rig{std::move(made).value(), std::move(input).value(), {}};
  if (Status s = rig.model.Run(rig.input.motion, &rig.predicted); !s.ok()) return s.error();
  if (Status s = CheckFinite(rig); !s.ok()) return s.error();
  if (Status s = CheckStroke(rig.model, rig.input.motion, rig.predicted.channels); !s.ok()) {
    Error error = s.error();
    error.where =
        (rig.input.measured() ? rig.input.run.source : manifest.path) + ": " + error.where;
    return error;
  }
  return rig;
}

Result<DrivenRig> DriveRig(const Manifest& manifest) {
  const Result<hydraulics::PhsParams> params = DeclaredModel(manifest);
  if (!params.ok()) return params.error();
  return DriveRig(manifest, params.value());
}

}  // namespace phs::measurement
