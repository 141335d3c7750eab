#include "python/own_functions.h"

#include <pybind11/numpy.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "plugin/model_text.h"
#include "plugin/observer.h"

namespace phs::python {
namespace {

using Numbers = py::array_t<double>;

/// {name: place} of the named objects of one type.
template <typename Place>
py::dict NamesOf(const mjModel* m, mjtObj type, int count, const Place& place) {
  py::dict names;
  for (int i = 0; i < count; ++i) {
    const std::string name = plugin::ObjectName(m, type, i);
    if (!name.empty()) names[py::str(name)] = place(i);
  }
  return names;
}

/// One run's functions and the arrays that they read. Made and destroyed on the thread of the run,
/// whose Python state it keeps; between calls that thread is without the GIL.
class Functions {
 public:
  Functions(const vehicle::Simulation& simulation, const py::object& begin,
            std::shared_ptr<RaisedFault> fault)
      : fault_(std::move(fault)) {
    Begin(simulation, begin);
    released_.emplace();
  }
  ~Functions() { released_.reset(); }  // the members go with the GIL

  bool Call(const vehicle::OwnView& view, vehicle::OwnValues* values) noexcept {
    const py::gil_scoped_acquire held;
    try {
      Fill(view);
      Read(step_(view.d->time), values);
      return true;
    } catch (...) {
      fault_->Keep(std::current_exception());
      return false;
    }
  }

 private:
  void Begin(const vehicle::Simulation& simulation, const py::object& begin) {
    const mjModel* m = simulation.model();
    const plugin::Binding& binding = simulation.binding();
    const plugin::Observer observer(m, binding);
    qpos_ = Numbers(m->nq);
    qvel_ = Numbers(m->nv);
    act_ = Numbers(m->na);
    xpos_ = Numbers({m->nbody, 3});
    xmat_ = Numbers({m->nbody, 3, 3});
    channels_ = Numbers(static_cast<py::ssize_t>(observer.channels().size()));
    py::dict names, arrays;
    names["bodies"] = NamesOf(m, mjOBJ_BODY, m->nbody, [](int i) { return i; });
    names["joints"] = NamesOf(m, mjOBJ_JOINT, m->njnt, [&](int i) {
      return py::make_tuple(m->jnt_qposadr[i], m->jnt_dofadr[i], m->jnt_type[i] >= mjJNT_SLIDE);
    });
    py::dict actuators = NamesOf(m, mjOBJ_ACTUATOR, m->nu, [](int i) { return i; });
    for (int i = 0; i < m->nu; ++i) {
      const py::str name(plugin::ObjectName(m, mjOBJ_ACTUATOR, i));
      if (binding.Owns(i) && actuators.contains(name)) actuators.attr("pop")(name);
    }
    names["actuators"] = actuators;
    py::list channels;
    for (const Channel& channel : observer.channels()) channels.append(channel.name);
    names["channels"] = channels;
    for (auto& [name, array] : Arrays()) {
      const py::object view = array->attr("view")();
      view.attr("flags").attr("writeable") = false;
      arrays[name] = view;
    }
    step_ = begin(names, arrays);
  }
  std::vector<std::pair<const char*, Numbers*>> Arrays() {
    return {{"qpos", &qpos_}, {"qvel", &qvel_}, {"act", &act_},
            {"xpos", &xpos_}, {"xmat", &xmat_}, {"channels", &channels_}};
  }

  static void Copy(const double* from, Numbers* to) {
    std::copy(from, from + to->size(), to->mutable_data());
  }
  void Fill(const vehicle::OwnView& view) {
    Copy(view.d->qpos, &qpos_);
    Copy(view.d->qvel, &qvel_);
    Copy(view.d->act, &act_);
    Copy(view.d->xpos, &xpos_);
    Copy(view.d->xmat, &xmat_);
    Copy(view.channels, &channels_);
  }
  static void Read(const py::object& answer, vehicle::OwnValues* values) {
    const auto [controls, wrenches] = answer.cast<std::pair<py::list, py::list>>();
    for (const py::handle item : controls) {
      values->controls.push_back(item.cast<std::pair<int, double>>());
    }
    for (const py::handle item : wrenches) {
      const auto [body, numbers] = item.cast<std::pair<int, py::tuple>>();
      vehicle::OwnValues::Wrench wrench{.body = body};
      for (size_t i = 0; i < 3; ++i) {
        wrench.force[i] = numbers[i].cast<double>();
        wrench.moment[i] = numbers[3 + i].cast<double>();
      }
      values->wrenches.push_back(wrench);
    }
  }

  py::gil_scoped_acquire thread_;
  std::shared_ptr<RaisedFault> fault_;
  Numbers qpos_, qvel_, act_, xpos_, xmat_, channels_;
  py::object step_;
  std::optional<py::gil_scoped_release> released_;
};

}  // namespace

void RaisedFault::Keep(std::exception_ptr fault) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!fault_) fault_ = std::move(fault);
}

void RaisedFault::Raise() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (fault_) std::rethrow_exception(fault_);
}

vehicle::OwnInputs BindOwnFunctions(const vehicle::Simulation& simulation, const py::object& begin,
                                    std::shared_ptr<RaisedFault> fault) {
  auto functions = std::make_shared<Functions>(simulation, begin, std::move(fault));
  return [functions](const vehicle::OwnView& view, vehicle::OwnValues* values) {
    return functions->Call(view, values);
  };
}

}  // namespace phs::python
