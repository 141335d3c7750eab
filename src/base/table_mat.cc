#include <fmt/format.h>
#include <matio.h>

#include <map>
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
  const bool numeric = variable.class_type >= MAT_C_DOUBLE && variable.class_type <= MAT_C_UINT64;
  if (!numeric || variable.isComplex || variable.data == nullptr || variable.rank != 2) return {};
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
    case MAT_T_INT64:
      return Values<int64_t>(variable, count);
    case MAT_T_UINT64:
      return Values<uint64_t>(variable, count);
    default:
      return {};
  }
}

/// A channel found in the file.
struct Found {
  std::string parent;  ///< "struct." of a field, else empty
  std::string name;
  std::vector<double> values;
};

/// Adds a variable, or the fields of a struct (`parent` is its name); scalars are no channels.
void Add(const matvar_t& variable, const std::string& parent, std::vector<Found>* found) {
  if (variable.name == nullptr) return;
  if (variable.class_type == MAT_C_STRUCT) {
    matvar_t* all = const_cast<matvar_t*>(&variable);  // matio's readers are not const
    const unsigned count = Mat_VarGetNumberOfFields(all);
    for (unsigned i = 0; i < count; ++i) {
      const matvar_t* field = Mat_VarGetStructFieldByIndex(all, i, 0);
      if (field != nullptr) Add(*field, parent + variable.name + ".", found);
    }
    return;
  }
  std::vector<double> values = VectorOf(variable);
  if (values.size() >= 2) found->push_back({parent, variable.name, std::move(values)});
}

/// A field's own name where it is the only one of that name, else with the name of its struct.
Table ToTable(const std::string& path, std::vector<Found> found) {
  std::map<std::string, int> count;
  for (const Found& one : found) ++count[one.name];
  Table table;
  table.source = path;
  for (Found& one : found) {
    table.names.push_back(count[one.name] > 1 ? one.parent + one.name : one.name);
    table.columns.push_back(std::move(one.values));
    table.text.emplace_back();
  }
  return table;
}

/// Every channel as long as the first.
Status CheckLengths(const Table& table) {
  if (table.columns.empty()) {
    return Error{table.source, "holds no numeric vectors", "one per channel", ""};
  }
  const size_t rows = table.columns[0].size();
  for (size_t i = 1; i < table.columns.size(); ++i) {
    if (table.columns[i].size() == rows) continue;
    return Error{table.source,
                 fmt::format("'{}' has {} values, '{}' {}", table.names[i], table.columns[i].size(),
                             table.names[0], rows),
                 "channels of equal length", ""};
  }
  return {};
}

}  // namespace

Result<Table> ReadMat(const std::string& path) {
  Mat_LogInitFunc("phs", [](int, char*) {});  // we report in our own words
  const MatPtr file(Mat_Open(path.c_str(), MAT_ACC_RDONLY), &Mat_Close);
  if (file == nullptr) return Error{path, "cannot be read", "a MATLAB file (v5 or v7.3)", ""};
  std::vector<Found> found;
  while (true) {
    const VarPtr variable(Mat_VarReadNext(file.get()), &Mat_VarFree);
    if (variable == nullptr) break;
    Add(*variable, "", &found);
  }
  Table table = ToTable(path, std::move(found));
  if (Status s = CheckLengths(table); !s.ok()) return s.error();
  for (size_t i = 0; i < table.columns[0].size(); ++i) {
    table.line.push_back(static_cast<int>(i) + 1);
  }
  return table;
}

}  // namespace phs
