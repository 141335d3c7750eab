#include "plugin/observer.h"

#include <fmt/format.h>

#include <algorithm>

namespace phs::plugin {
namespace {

int HeaviestBody(const mjModel* m) {
  return static_cast<int>(std::max_element(m->body_mass, m->body_mass + m->nbody) - m->body_mass);
}

}  // namespace

std::vector<ChannelKind> ChannelKinds() {
  return {{"run", "", RunChannels()},
          {"wheelset", "WHEELSET_", WheelsetChannels()},
          {"wheel", "WHEEL_", WheelChannels()},
          {"bogie", "(BOGIE_)", BogieChannels()},
          {"cylinder", "(PHS_)cylinder_NAME_", CylinderChannels()},
          {"line", "(PHS_)line_NAME_", LineChannels()},
          {"element", "KIND_NAME_", ElementChannels()}};
}

void Observer::Add(std::span<const ChannelRow> rows, const std::string& prefix,
                   ChannelPlace place) {
  for (const ChannelRow& row : rows) {
    channels_.push_back({prefix + row.name, row.unit, row.text});
    sources_.push_back({&row, place});
  }
}

Observer::Observer(const mjModel* m, const Binding& binding)
    : binding_(binding), car_body_(HeaviestBody(m)), bogies_(FindBogies(binding)) {
  Add(RunChannels(), "", {});
  for (int i = 0; i < static_cast<int>(binding.wheelsets().size()); ++i) {
    const std::string& name = binding.wheelsets()[static_cast<size_t>(i)].name;
    Add(WheelsetChannels(), name + "_", {i});
    Add(WheelChannels(), name + "_left_", {i, static_cast<int>(rail::Side::kLeft)});
    Add(WheelChannels(), name + "_right_", {i, static_cast<int>(rail::Side::kRight)});
  }
  for (int i = 0; i < static_cast<int>(bogies_.size()); ++i) {
    Add(BogieChannels(), bogies_[static_cast<size_t>(i)].prefix, {i});
  }
  for (int i = 0; i < static_cast<int>(binding.phs().size()); ++i) {
    const PhsBinding& phs = binding.phs()[static_cast<size_t>(i)];
    const std::string prefix = binding.phs().size() > 1 ? phs.name + "_" : "";
    int part = 0;
    for (const std::string& name : phs.system->cylinder_names()) {
      Add(CylinderChannels(), fmt::format("{}cylinder_{}_", prefix, name), {i, part++});
    }
    part = 0;
    for (const std::string& name : phs.system->line_names()) {
      Add(LineChannels(), fmt::format("{}line_{}_", prefix, name), {i, part++});
    }
  }
  AddElements(m);
}

void Observer::AddElements(const mjModel* m) {
  for (int i = 0; i < static_cast<int>(binding_.elements().size()); ++i) {
    const Elements& elements = *binding_.elements()[static_cast<size_t>(i)];
    if (elements.InEngine()) continue;
    for (int part = 0; part < elements.Count(); ++part) {
      Add(ElementChannels(), elements.Name(m, part) + "_", {i, part});
    }
  }
}

Instant Observer::InstantOf(const mjModel* m, const mjData* d) const {
  Instant at{.m = m, .d = d, .binding = &binding_, .bogies = &bogies_, .car_body = car_body_};
  for (size_t i = 0; i < binding_.wheelsets().size(); ++i) {
    at.wheelsets.push_back(binding_.CalcWheelset(m, d, static_cast<int>(i)));
  }
  for (size_t i = 0; i < binding_.phs().size(); ++i) {
    at.phs.push_back(binding_.CalcPhs(m, d, static_cast<int>(i)));
  }
  for (const WheelsetState& w : at.wheelsets) {
    if (at.leading == nullptr || w.frame.s > at.leading->frame.s) at.leading = &w;
  }
  return at;
}

void Observer::Observe(const mjModel* m, const mjData* d, double* row) const {
  const Instant at = InstantOf(m, d);
  for (size_t i = 0; i < sources_.size(); ++i) {
    row[i] = sources_[i].row->value(at, sources_[i].place);
  }
}

}  // namespace phs::plugin
