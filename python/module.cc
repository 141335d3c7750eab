// The compiled half of the Python package: phs._phs.
#include <pybind11/stl.h>

#include "base/data_path.h"
#include "python/bindings.h"
#include "python/crossing.h"

PYBIND11_MODULE(_phs, module) {
  module.doc() = "The libraries of PHS on MuJoCo; use the package phs.";
  module.attr("version") = PHS_VERSION;
  module.def("find_data", [](const std::string& kind, const std::string& folder,
                             const std::string& name, const std::vector<std::string>& extensions) {
    return phs::python::Take(phs::FindData(kind, folder, name, extensions));
  });
  phs::python::BindCurve(&module);
  phs::python::BindContact(&module);
  phs::python::BindAnalyses(&module);
  phs::python::BindRigs(&module);
  phs::python::BindSweep(&module);
}
