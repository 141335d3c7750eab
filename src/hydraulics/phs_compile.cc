// PhsParams + effects -> the compiled form. Laws of effects are collected first, because an effect
// may still change the parameters of a line.
#include <algorithm>
#include <utility>

#include "hydraulics/node_gases.h"
#include "hydraulics/phs_system_impl.h"
#include "hydraulics/phs_validate.h"
#include "hydraulics/pipe.h"
#include "hydraulics/warm_filling.h"

namespace phs::hydraulics {
namespace {

struct PendingFlow {
  Port from, to;
  int cylinder, line;
  std::string name;
  std::unique_ptr<FlowLaw> law;
};
struct PendingSplit {
  Port chamber;
  int cylinder;
  double share;
  std::string name;
  std::unique_ptr<FlowLaw> law;
};
struct PendingReservoir {
  int line;
  std::string name;
  std::unique_ptr<FlowLaw> law;
};

class Builder final : public Extension {
 public:
  Builder(const PhsParams& params, std::shared_ptr<const ExtraSeries> extra)
      : params_(params), lines_(params.lines), extra_(std::move(extra)) {
    friction_.resize(params.cylinders.size());
    mounts_.resize(params.cylinders.size());
    readings_.resize(params.cylinders.size());
  }
  const PhsParams& params() const override { return params_; }
  std::vector<std::string> extra_names() const override {
    return extra_ ? extra_->names : std::vector<std::string>();
  }
  void AddVolume(int line, std::unique_ptr<VolumeLaw> law) override {
    volumes_.emplace_back(line, std::move(law));
  }
  void AddFlow(Port from, Port to, int cylinder, int line, const std::string& name,
               std::unique_ptr<FlowLaw> law) override {
    flows_.push_back({from, to, cylinder, line, name, std::move(law)});
  }
  void SplitChamber(Port chamber, int cylinder, double share, const std::string& name,
                    std::unique_ptr<FlowLaw> law) override {
    splits_.push_back({chamber, cylinder, share, name, std::move(law)});
  }
  void SplitReservoir(int line, const std::string& name, std::unique_ptr<FlowLaw> law) override {
    reservoirs_.push_back({line, name, std::move(law)});
  }
  void AddLevel(int cylinder, std::unique_ptr<const LevelLaw> law) override {
    friction_[cylinder].levels.push_back(std::move(law));
  }
  void AddForce(int cylinder, std::unique_ptr<const ForceLaw> law) override {
    friction_[cylinder].forces.push_back(std::move(law));
  }
  void SetBristle(int cylinder, std::unique_ptr<const BristleLaw> law) override {
    friction_[cylinder].bristle = std::move(law);
  }
  void AddMount(int cylinder, std::unique_ptr<const MountLaw> law) override {
    mounts_[cylinder].push_back(std::move(law));
  }
  void AddReading(int cylinder, Sensor sensor, std::unique_ptr<const ReadingLaw> law) override {
    readings_[cylinder][static_cast<int>(sensor)].push_back(std::move(law));
  }
  void AddLoad(std::unique_ptr<const LoadLaw> law) override { loads_.push_back(std::move(law)); }
  void AddAmbient(std::unique_ptr<const AmbientLaw> law) override {
    ambient_.push_back(std::move(law));
  }
  LineParams& line(int index) override { return lines_[index]; }

  CompiledPhs Compile();
  /// First thing that does not fit, if any (too many flows …).
  Status status() const { return status_; }

 private:
  void CompileNodes(CompiledPhs* sys);
  void CompileCylinders(CompiledPhs* sys);
  void CompileSplits(CompiledPhs* sys);
  void CompileReservoirs(CompiledPhs* sys);
  /// A part of a line that is to be behind a law: `share` of the line's oil. -1: there are too
  /// many.
  int SplitOff(int line, double share, const std::string& effect, CompiledPhs* sys);
  void CompileFlows(CompiledPhs* sys);
  void CompileStates(CompiledPhs* sys);
  int PortNode(const CompiledPhs& sys, Port port, int cylinder, int line) const;

  const PhsParams& params_;
  std::vector<LineParams> lines_;
  std::vector<std::pair<int, std::unique_ptr<VolumeLaw>>> volumes_;
  std::vector<PendingFlow> flows_;
  std::vector<PendingSplit> splits_;
  std::vector<PendingReservoir> reservoirs_;
  std::vector<int> line_of_;  ///< of every node
  std::vector<FrictionLaws> friction_;
  std::vector<MountLaws> mounts_;
  std::vector<std::array<ReadingLaws, kSensors>> readings_;
  LoadLaws loads_;
  std::shared_ptr<const ExtraSeries> extra_;
  std::vector<std::unique_ptr<const AmbientLaw>> ambient_;
  std::vector<std::string> path_names_;
  Status status_;
};

void Builder::CompileNodes(CompiledPhs* sys) {
  for (const LineParams& line : lines_) {
    Node node = MakeNode(line, params_.temperature_K);
    node.sequential = params_.balance == BalanceMethod::kSequential;
    if (node.sequential && (line.reservoir.stop_spread > 0 || line.reservoir.stop_share < 1 ||
                            line.accumulator_spread_Pa > 0)) {
      status_ =
          Error{"balance", "sequential, with a stop or an opening that is spread or gives way",
                "unified with these effects", "remove the spread or set balance: unified"};
    }
    sys->nodes.push_back(std::move(node));
    line_of_.push_back(static_cast<int>(line_of_.size()));
  }
  for (auto& [line, law] : volumes_) {
    sys->nodes[line].laws.push_back({law.get(), -1});
    sys->volume_laws.push_back(std::move(law));
  }
}

void Builder::CompileCylinders(CompiledPhs* sys) {
  for (size_t i = 0; i < params_.cylinders.size(); ++i) {
    const CylinderParams& from = params_.cylinders[i];
    CompiledCylinder c;
    c.bore = params_.FindLine(from.bore_line);
    c.rod = params_.FindLine(from.rod_line);
    c.bore_area = from.BoreArea();
    c.rod_area = from.RodArea();
    if (c.bore >= 0) c.bore_p0 = lines_[c.bore].static_pressure_Pa;
    if (c.rod >= 0) c.rod_p0 = lines_[c.rod].static_pressure_Pa;
    c.friction = Friction(params_.friction, std::move(friction_[i]));
    c.stop = from.end_stop;
    c.mount = Mount(std::move(mounts_[i]));
    c.readings = std::move(readings_[i]);
    sys->has_mounts |= c.mount.present();
    sys->friction_needs_pressure |= c.friction.depends_on_pressure();
    sys->cylinders.push_back(std::move(c));
    sys->cylinder_names.push_back(from.name);
  }
}

int Builder::SplitOff(int line, double share, const std::string& effect, CompiledPhs* sys) {
  if (static_cast<int>(sys->nodes.size()) >= kMaxNodes) {
    status_ = Error{"effects." + effect, "too many chambers with a resistance",
                    "at most " + std::to_string(kMaxNodes) + " pressures", "name fewer targets"};
    return -1;
  }
  Node part;
  Node& main = sys->nodes[static_cast<size_t>(line)];
  part.p0 = main.p0;
  part.oil = main.oil;
  part.softening = main.softening;
  part.expansion = main.expansion;
  part.temperature = main.temperature;
  const double oil = share * lines_[static_cast<size_t>(line)].oil_volume_m3;
  part.oil_volume = oil;
  part.air = kTraceAir * oil * kAtmosphere;
  main.oil_volume -= oil;
  main.air -= part.air;
  sys->nodes.push_back(std::move(part));
  line_of_.push_back(line);
  return static_cast<int>(sys->nodes.size()) - 1;
}

void Builder::CompileReservoirs(CompiledPhs* sys) {
  constexpr double kOil = 0.01;  // of the line's, on the reservoir's side
  for (PendingReservoir& behind : reservoirs_) {
    const auto apart = std::find_if(sys->paths.begin(), sys->paths.end(), [&](const Path& path) {
      return path.from == behind.line && path.part == path.to;
    });
    if (apart != sys->paths.end()) {
      apart->law = InSeries(std::move(apart->law), std::move(behind.law));
      continue;
    }
    const auto is_gas = [](const NodeGas& g) { return !g.blow_off; };
    const auto& all = sys->nodes[static_cast<size_t>(behind.line)].gases;
    if (std::none_of(all.begin(), all.end(), is_gas)) continue;
    const int part = SplitOff(behind.line, kOil, behind.name, sys);
    if (part < 0) return;
    auto& gases = sys->nodes[static_cast<size_t>(behind.line)].gases;
    const auto blow_offs = std::stable_partition(gases.begin(), gases.end(), is_gas);
    sys->nodes[static_cast<size_t>(part)].gases = {gases.begin(), blow_offs};
    gases.erase(gases.begin(), blow_offs);
    Path path;
    path.from = behind.line;
    path.to = path.part = part;
    path.law = std::move(behind.law);
    sys->paths.push_back(std::move(path));
    path_names_.push_back(sys->line_names[static_cast<size_t>(behind.line)] + "." + behind.name);
  }
}

void Builder::CompileSplits(CompiledPhs* sys) {
  for (PendingSplit& split : splits_) {
    CompiledCylinder& c = sys->cylinders[split.cylinder];
    int& chamber = split.chamber == Port::kBore ? c.bore : c.rod;
    if (chamber == kOpen) continue;
    const int line = chamber;
    if (line >= static_cast<int>(lines_.size())) {
      for (Path& path : sys->paths) {
        if (path.from == line) path.law = InSeries(std::move(path.law), std::move(split.law));
      }
      continue;
    }
    const int part = SplitOff(line, split.share, split.name, sys);
    if (part < 0) return;
    chamber = part;
    Path path;
    path.from = path.part = chamber;
    path.to = line;
    path.law = std::move(split.law);
    sys->paths.push_back(std::move(path));
    path_names_.push_back(sys->cylinder_names[split.cylinder] +
                          (split.chamber == Port::kBore ? ".bore_" : ".rod_") + split.name);
  }
}

int Builder::PortNode(const CompiledPhs& sys, Port port, int cylinder, int line) const {
  switch (port) {
    case Port::kBore:
      return sys.cylinders[cylinder].bore;
    case Port::kRod:
      return sys.cylinders[cylinder].rod;
    case Port::kLine:
      return line;
    case Port::kAtmosphere:
      return kOpen;
  }
  return kOpen;
}

void Builder::CompileFlows(CompiledPhs* sys) {
  for (PendingFlow& flow : flows_) {
    Path path;
    path.from = PortNode(*sys, flow.from, flow.cylinder, flow.line);
    path.to = PortNode(*sys, flow.to, flow.cylinder, flow.line);
    if (path.from == path.to) continue;
    path.cylinder = flow.cylinder;
    path.law = std::move(flow.law);
    sys->paths.push_back(std::move(path));
    const bool of_cylinder = flow.from != Port::kLine && flow.cylinder >= 0;
    path_names_.push_back(
        (of_cylinder ? sys->cylinder_names[flow.cylinder] : sys->line_names[flow.line]) + "." +
        flow.name);
  }
}

void Builder::CompileStates(CompiledPhs* sys) {
  // The second of a name is NAME_2.
  auto add = [sys](const std::string& name) {
    std::vector<std::string>& names = sys->state_names;
    std::string free = name;
    for (int n = 2; std::find(names.begin(), names.end(), free) != names.end(); ++n) {
      free = name + "_" + std::to_string(n);
    }
    names.push_back(free);
    return sys->num_states() - 1;
  };
  for (size_t i = 0; i < sys->cylinders.size(); ++i) {
    CompiledCylinder& c = sys->cylinders[i];
    const std::string& name = sys->cylinder_names[i];
    if (c.friction.model() == FrictionModel::kPresliding) c.bristle = add(name + ".bristle");
    for (int k = 0; k < c.friction.num_memories(); ++k) {
      const int state = add(name + "." + c.friction.MemoryName(k));
      if (k == 0) c.memory = state;
    }
    if (c.mount.present()) c.mount_state = add(name + ".mount");
    for (const MaxwellBranch& branch : c.mount.branches()) add(name + "." + branch.name);
  }
  sys->first_slow = sys->num_states();
  for (size_t n = 0; n < sys->nodes.size(); ++n) {
    const std::string& line = lines_[static_cast<size_t>(line_of_[n])].name;
    int parts[2] = {};
    for (NodeGas& g : sys->nodes[n].gases) {
      const int part = ++parts[g.blow_off ? 1 : 0];
      if (!g.gas.HasTemperatureState()) continue;
      const std::string place =
          line + (g.blow_off ? ".accumulator" : ".gas") + (part > 1 ? std::to_string(part) : "");
      g.state = add(place + "_temperature");
      if (g.gas.HasWallState()) g.wall_state = add(place + "_wall_temperature");
    }
    for (NodeLaw& l : sys->nodes[n].laws) {
      const std::string memory = l.law->MemoryName();
      if (!memory.empty()) l.state = add(line + "." + memory);
    }
  }
  for (size_t k = 0; k < sys->paths.size(); ++k) {
    Path& path = sys->paths[k];
    path.volume = add(path_names_[k] + "_volume");
    if (!(path.law->Inertance() > 0)) continue;
    path.flow = add(path_names_[k] + "_flow");
    path.num_lags = path.law->num_lags();
    for (int lag = 0; lag < path.num_lags; ++lag) {
      const int state = add(path_names_[k] + "_lag" + std::to_string(lag + 1));
      if (lag == 0) path.lag = state;
    }
  }
}

CompiledPhs Builder::Compile() {
  CompiledPhs compiled;
  CompiledPhs* sys = &compiled;
  sys->params = params_;
  for (const LineParams& line : lines_) sys->line_names.push_back(line.name);
  CompileNodes(sys);
  CompileCylinders(sys);
  CompileSplits(sys);
  CompileReservoirs(sys);
  CompileFlows(sys);
  CompileStates(sys);
  for (Node& node : sys->nodes) node.Prepare();
  sys->ambient = std::move(ambient_);
  sys->loads = std::move(loads_);
  sys->extra = extra_;
  if (static_cast<int>(sys->paths.size()) > kMaxPaths || sys->num_states() > kMaxStates) {
    status_ = Error{params_.name, "too many flows or states for one system",
                    "at most " + std::to_string(kMaxPaths) + " flows", "switch effects off"};
  }
  return compiled;
}

Status InstallEffects(const PhsParams& params, const EffectTable* table, Builder* builder) {
  for (const EffectParams& effect : params.effects) {
    if (table == nullptr) {
      return Error{"effects." + effect.name, "this entry has no catalogue of effects", "",
                   "load the model with phs_model::LoadPhsSystem"};
    }
    Result<EffectParams> full = CompleteEffect(params, effect, *table);
    if (!full.ok()) return full.error();
    const EffectInfo* info = table->FindFor(effect);
    if (Status s = info->install(full.value(), builder); !s.ok()) return s;
  }
  return {};
}

}  // namespace

Result<PhsSystem> PhsSystem::Create(const PhsParams& stated, const EffectTable* effects,
                                    std::shared_ptr<const ExtraSeries> extra) {
  if (Status s = Validate(stated); !s.ok()) return s.error();
  Result<PhsParams> warm = AtItsTemperature(stated);
  if (!warm.ok()) return warm.error();
  const PhsParams& params = warm.value();
  Builder builder(params, std::move(extra));
  if (Status s = InstallEffects(params, effects, &builder); !s.ok()) return s.error();
  // Effects may have changed line numbers: the same limits hold.
  PhsParams changed = params;
  for (size_t i = 0; i < params.lines.size(); ++i) {
    changed.lines[i] = builder.line(static_cast<int>(i));
  }
  if (Status s = Validate(changed); !s.ok()) return s.error();
  auto impl = std::make_unique<Impl>();
  static_cast<CompiledPhs&>(*impl) = builder.Compile();
  if (!builder.status().ok()) return builder.status().error();
  return PhsSystem(std::move(impl));
}

}  // namespace phs::hydraulics
