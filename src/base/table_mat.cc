#include <fmt/format.h>
#include <matio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
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
  for (double& value : values) {
    if (!(std::abs(value) <= kLargestReading)) value = std::numeric_limits<double>::quiet_NaN();
  }
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

/// Versions 5 and 7.3 begin with 128 bytes of text, version and byte order ("IM" or "MI"). What has
/// no such header matio would take for version 4, whose sizes cannot be checked before it
/// allocates.
bool HasHeader(const std::string& path) {
  std::array<char, 128> header{};
  std::ifstream file(path, std::ios::binary);
  if (!file.read(header.data(), header.size())) return false;
  const bool little = header[126] == 'I' && header[127] == 'M';
  const bool big = header[126] == 'M' && header[127] == 'I';
  const char version = little ? header[125] : header[124];
  return (little || big) && (version == 1 || version == 2);
}

/// Whether every element of a version 5 file, and every part of a matrix that is not compressed,
/// ends within what it is in: matio allocates by their lengths before it reads.
bool ElementsFit(const std::string& path, std::uintmax_t file_size) {
  constexpr std::uint32_t kMatrix = 14;
  constexpr std::uintmax_t kTag = 8;
  std::ifstream file(path, std::ios::binary);
  std::array<char, 128> header{};
  file.read(header.data(), header.size());
  const bool little = header[126] == 'I';
  if ((little ? header[125] : header[124]) != 1) return true;  // 7.3 is HDF5, which checks itself
  const auto word = [&]() {
    std::array<unsigned char, 4> b{};
    file.read(reinterpret_cast<char*>(b.data()), b.size());
    if (!little) std::reverse(b.begin(), b.end());
    return static_cast<std::uint32_t>(b[0] | b[1] << 8 | b[2] << 16) |
           static_cast<std::uint32_t>(b[3]) << 24;
  };
  const auto parts_fit = [&](std::uintmax_t at, std::uintmax_t end) {
    constexpr int kDimensions = 1;
    for (int part = 0; part < 3 && at + kTag <= end; ++part) {  // flags, dimensions, name
      file.seekg(static_cast<std::streamoff>(at));
      const std::uint32_t type = word();
      const bool in_tag = type >> 16 != 0;
      const std::uintmax_t bytes = in_tag ? 0 : (std::uintmax_t{word()} + 7) / 8 * 8;
      if (at + kTag + bytes > end) return false;
      at += kTag + bytes;
      if (part != kDimensions) continue;
      double values = 1;  // none takes less than a byte
      for (std::uintmax_t i = 0; i < bytes / 4; ++i) values *= std::max(word(), 1U);
      if (values > static_cast<double>(end - at)) return false;
    }
    return true;
  };
  for (std::uintmax_t at = header.size(); at + kTag <= file_size;) {
    file.seekg(static_cast<std::streamoff>(at));
    const std::uint32_t type = word();
    const std::uintmax_t end = at + kTag + word();
    if (end > file_size || (type == kMatrix && !parts_fit(at + kTag, end))) return false;
    at = end;
  }
  return true;
}

/// Whether a file of that many bytes can hold the variable: deflate shrinks at most 1032 times.
bool CanHold(const matvar_t& variable, std::uintmax_t file_size) {
  const double most = 1032.0 * static_cast<double>(file_size);
  double bytes = 1;
  for (int i = 0; i < variable.rank; ++i) bytes *= static_cast<double>(variable.dims[i]);
  return bytes <= most;
}

Result<std::vector<Found>> ReadVectors(const std::string& path) {
  const Error unreadable{path, "cannot be read", "a MATLAB file (v5 or v7.3)", ""};
  if (!HasHeader(path)) return unreadable;
  std::error_code ignored;
  const std::uintmax_t size = std::filesystem::file_size(path, ignored);
  if (!ElementsFit(path, size)) {
    return Error{path, "holds a variable that is longer than the file",
                 "a MATLAB file (v5 or v7.3)", "the file is damaged: save it again"};
  }
  Mat_LogInitFunc("phs", [](int, char*) {});  // we report in our own words
  const MatPtr file(Mat_Open(path.c_str(), MAT_ACC_RDONLY), &Mat_Close);
  if (file == nullptr) return unreadable;
  std::vector<Found> found;
  while (true) {
    const VarPtr variable(Mat_VarReadNextInfo(file.get()), &Mat_VarFree);
    if (variable == nullptr) break;
    if (!CanHold(*variable, size)) {
      return Error{path,
                   fmt::format("'{}' declares more values than the file can hold",
                               variable->name == nullptr ? "" : variable->name),
                   "", "the file is damaged: save it again"};
    }
    if (Mat_VarReadDataAll(file.get(), variable.get()) == 0) Add(*variable, "", &found);
  }
  return found;
}

}  // namespace

Result<Table> ReadMat(const std::string& path) {
  Result<std::vector<Found>> read = ReadVectors(path);
  if (!read.ok()) return read.error();
  std::vector<Found> found = std::move(read).value();
  Table table = ToTable(path, std::move(found));
  if (Status s = CheckLengths(table); !s.ok()) return s.error();
  for (size_t i = 0; i < table.columns[0].size(); ++i) {
    table.line.push_back(static_cast<int>(i) + 1);
  }
  return table;
}

}  // namespace phs
