#include <matio.h>

#include <memory>

#include "base/table.h"

namespace phs {
namespace {

using MatPtr = std::unique_ptr<mat_t, int (*)(mat_t*)>;
using VarPtr = std::unique_ptr<matvar_t, void (*)(matvar_t*)>;

template <typename T>
std::vector<double> Values(const matvar_t& variable, size_t count) {
  const T* data = static_cast<const T*>(variable.data);
  return {data, data + count};
}

/// Numbers of a real numeric vector; empty for anything else.
std::vector<double> VectorOf(const matvar_t& variable) {
  if (variable.isComplex || variable.data == nullptr || variable.rank != 2) return {};
  const size_t count = variable.dims[0] * variable.dims[1];
  if (count == 0 || (variable.dims[0] != 1 && variable.dims[1] != 1)) return {};
  switch (variable.data_type) {
    case MAT_T_DOUBLE:
      return Values<double>(variable, count);
    case MAT_T_SINGLE:
      return Values<float>(variable, count);
    case MAT_T_INT8:
      return Values<int8_t>(variable, count);
    case MAT_T_UINT8:
      return Values<uint8_t>(variable, count);
    case MAT_T_INT16:
      return Values<int16_t>(variable, count);
    case MAT_T_UINT16:
      return Values<uint16_t>(variable, count);
    case MAT_T_INT32:
      return Values<int32_t>(variable, count);
    case MAT_T_UINT32:
      return Values<uint32_t>(variable, count);
    default:
      return {};
  }
}

/// Adds a variable, or the fields of a struct; scalars are no channels.
void Add(const matvar_t& variable, Table* table) {
  if (variable.class_type == MAT_C_STRUCT) {
    const unsigned count = Mat_VarGetNumberOfFields(const_cast<matvar_t*>(&variable));
    for (unsigned i = 0; i < count; ++i) {
      const matvar_t* field = Mat_VarGetStructFieldByIndex(const_cast<matvar_t*>(&variable), i, 0);
      if (field != nullptr) Add(*field, table);
    }
    return;
  }
  std::vector<double> values = VectorOf(variable);
  if (values.size() < 2 || variable.name == nullptr) return;
  table->names.emplace_back(variable.name);
  table->columns.push_back(std::move(values));
  table->text.emplace_back();
}

}  // namespace

Result<Table> ReadMat(const std::string& path) {
  const MatPtr file(Mat_Open(path.c_str(), MAT_ACC_RDONLY), &Mat_Close);
  if (file == nullptr) return Error{path, "cannot be read", "a MATLAB file (v5 or v7.3)", ""};
  Table table;
  table.source = path;
  while (true) {
    const VarPtr variable(Mat_VarReadNext(file.get()), &Mat_VarFree);
    if (variable == nullptr) break;
    Add(*variable, &table);
  }
  if (table.columns.empty()) return Error{path, "holds no numeric vectors", "one per channel", ""};
  for (size_t i = 1; i < table.columns.size(); ++i) {
    if (table.columns[i].size() != table.columns[0].size()) {
      return Error{path,
                   "'" + table.names[i] + "' has " + std::to_string(table.columns[i].size()) +
                       " values, '" + table.names[0] + "' " +
                       std::to_string(table.columns[0].size()),
                   "channels of equal length", ""};
    }
  }
  for (size_t i = 0; i < table.columns[0].size(); ++i) {
    table.line.push_back(static_cast<int>(i) + 1);
  }
  return table;
}

}  // namespace phs
