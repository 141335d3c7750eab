// The parts of the module phs._phs; module.cc puts them together. What Python sees is the package
// phs/, which calls these.
#pragma once

#include <pybind11/pybind11.h>

namespace phs::python {

void BindCurve(pybind11::module_* module);
void BindContact(pybind11::module_* module);
void BindAnalyses(pybind11::module_* module);
void BindRigs(pybind11::module_* module);
void BindSweep(pybind11::module_* module);

}  // namespace phs::python
