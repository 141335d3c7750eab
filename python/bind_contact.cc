// phs.contact: the job of `phs contact`.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include "jobs/contact_job.h"
#include "python/bindings.h"
#include "python/crossing.h"
#include "rail/creep_law.h"

namespace phs::python {
namespace {

/// The pair from {name: value}; what is not there stays open.
jobs::ContactPair ReadPair(const py::dict& given) {
  jobs::ContactPair pair;
  const auto read = [&](const char* name, auto* value) {
    using Value = std::remove_reference_t<decltype(*value)>;
    if (given.contains(name)) *value = given[name].cast<Value>();
  };
  read("wheel", &pair.wheel);
  read("rail", &pair.rail);
  read("gauge_m", &pair.gauge_m);
  read("gauge_height_m", &pair.gauge_height_m);
  read("cant_rad", &pair.cant_rad);
  read("flange_back_distance_m", &pair.flange_back_distance_m);
  read("flange_back_position_m", &pair.flange_back_position_m);
  read("radius_m", &pair.radius_m);
  read("mu", &pair.mu);
  read("shear_modulus_Pa", &pair.shear_modulus_Pa);
  read("poisson_ratio", &pair.poisson_ratio);
  return pair;
}

/// A name stays, columns become a table.
jobs::Cases ReadCases(const py::object& cases, const char* source) {
  if (py::isinstance<py::dict>(cases)) return FromPython(cases, source);
  return cases.cast<std::string>();
}

py::dict Patches(const py::object& cases, const std::string& method) {
  const jobs::Cases table = ReadCases(cases, "cases");
  return ToPython(Take(LongWork(py::none()).Do([&](const jobs::Watch&) {
    return jobs::CalcPatches(table, method);
  })));
}

py::dict Wheelset(const py::object& cases, const py::dict& pair, const std::string& side,
                  const std::string& method) {
  const jobs::Cases table = ReadCases(cases, "wheelset");
  const jobs::ContactPair given = ReadPair(pair);
  return ToPython(Take(LongWork(py::none()).Do([&](const jobs::Watch&) {
                    return jobs::CalcWheelset(table, given, side, method);
                  })).patches);
}

/// (table over the lateral position, amplitudes [m], equivalent conicities)
py::tuple ContactFunctions(const py::dict& pair, double reach_m, double step_m, double load_N) {
  const jobs::FunctionsRequest request = {
      .pair = ReadPair(pair), .reach_m = reach_m, .step_m = step_m, .load_N = load_N};
  const auto done = Take(
      LongWork(py::none()).Do([&](const jobs::Watch&) { return jobs::CalcFunctions(request); }));
  std::vector<double> amplitudes, conicities;
  for (const rail::Conicity& c : done.functions.conicity) {
    amplitudes.push_back(c.amplitude);
    conicities.push_back(c.value);
  }
  const auto array = [](const std::vector<double>& v) {
    return py::array_t<double>(static_cast<py::ssize_t>(v.size()), v.data());
  };
  return py::make_tuple(ToPython(jobs::FunctionsTable(done.functions)), array(amplitudes),
                        array(conicities));
}

}  // namespace

void BindContact(py::module_* module) {
  module->def("contact_patches", &Patches);
  module->def("contact_wheelset", &Wheelset);
  module->def("contact_functions", &ContactFunctions);
  module->def("creep_laws", &rail::CreepLawNames);
}

}  // namespace phs::python
