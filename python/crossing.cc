#include "python/crossing.h"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/numbers.h"

namespace phs::python {

void Raise(const Error& error) {
  const py::object type = py::module_::import("phs._errors").attr("Error");
  const py::object value = type(error.where, error.what, error.allowed, error.mend);
  PyErr_SetObject(type.ptr(), value.ptr());
  throw py::error_already_set();
}

py::dict ToPython(const Table& table) {
  py::dict columns;
  for (int i = 0; i < table.num_columns(); ++i) {
    const size_t at = static_cast<size_t>(i);
    const std::vector<double>& numbers = table.columns[at];
    const bool has_text = at < table.text.size() && !table.text[at].empty();
    const bool text = has_text && std::any_of(numbers.begin(), numbers.end(),
                                              [](double x) { return std::isnan(x); });
    if (text) {
      columns[py::str(table.names[at])] = py::cast(table.text[at]);
    } else {
      columns[py::str(table.names[at])] =
          py::array_t<double>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
    }
  }
  return columns;
}

namespace {

/// One column: numbers, or texts where they are no numbers.
void AddColumn(const py::handle& values, Table* table) {
  std::vector<double> numbers;
  std::vector<std::string> texts;
  for (const py::handle cell : py::reinterpret_borrow<py::object>(values)) {
    if (py::isinstance<py::str>(cell)) {
      texts.push_back(cell.cast<std::string>());
      numbers.push_back(ParseNumber(texts.back()).value_or(std::nan("")));
    } else {
      numbers.push_back(py::float_(py::reinterpret_borrow<py::object>(cell)));
      texts.push_back(Shortest(numbers.back()));
    }
  }
  table->columns.push_back(std::move(numbers));
  table->text.push_back(std::move(texts));
}

}  // namespace

Table FromPython(const py::dict& columns, const std::string& source) {
  Table table;
  table.source = source;
  for (const auto& [name, values] : columns) {
    table.names.push_back(py::str(name));
    AddColumn(values, &table);
    const size_t rows = table.columns.back().size();
    if (rows != table.columns[0].size()) {
      Raise({source + ": " + table.names.back(), std::to_string(rows) + " values",
             std::to_string(table.columns[0].size()) + ", as " + table.names[0] + " has", ""});
    }
  }
  for (int row = 0; row < table.num_rows(); ++row) table.line.push_back(row + 1);
  return table;
}

OriginNotes NotesOf(const std::string& call, const std::string& given_folder) {
  return OriginNotes("phs " PHS_VERSION " in Python", call, given_folder);
}

void LongWork::Look() {
  const py::gil_scoped_acquire held;
  if (fault_) return;
  try {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    if (!progress_.is_none()) progress_(share_.load());
  } catch (...) {
    fault_ = std::current_exception();
    stopped_ = true;
  }
}

}  // namespace phs::python
