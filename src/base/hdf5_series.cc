#include "base/hdf5_series.h"

#include <hdf5.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include "base/numbers.h"
#include "base/result_dir.h"
#include "base/words.h"

namespace phs {
namespace {

constexpr hsize_t kBlock = 1024;        ///< rows per chunk and per write
constexpr size_t kImageStep = 1 << 20;  ///< bytes by which the file in memory grows

/// Owns one HDF5 identifier.
class Handle {
 public:
  Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Handle() { Close(); }
  operator hid_t() const { return id_; }  // NOLINT(google-explicit-constructor)
  bool ok() const { return id_ >= 0; }
  bool Close() { return id_ < 0 || close_(std::exchange(id_, -1)) >= 0; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// HDF5 prints its error stack by default; we report in our own words.
void SilenceHdf5() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

bool WriteText(hid_t object, const std::string& name, const std::string& value) {
  const Handle type(H5Tcopy(H5T_C_S1), &H5Tclose);
  H5Tset_size(type, std::max<size_t>(value.size(), 1));
  H5Tset_cset(type, H5T_CSET_UTF8);
  const Handle space(H5Screate(H5S_SCALAR), &H5Sclose);
  const Handle attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
                         &H5Aclose);
  return attribute.ok() && H5Awrite(attribute, type, value.empty() ? "" : value.c_str()) >= 0;
}

/// A text attribute of fixed length, as WriteText makes them; empty for anything else.
std::string ReadText(hid_t object, const std::string& name) {
  if (H5Aexists(object, name.c_str()) <= 0) return "";
  const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), &H5Aclose);
  const Handle type(H5Aget_type(attribute), &H5Tclose);
  const Handle space(H5Aget_space(attribute), &H5Sclose);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) > 0 ||
      H5Sget_simple_extent_npoints(space) != 1) {
    return "";
  }
  std::string value(H5Tget_size(type), '\0');
  if (H5Aread(attribute, type, value.data()) < 0) return "";
  value.resize(value.find('\0') == std::string::npos ? value.size() : value.find('\0'));
  return value;
}

/// The folder of `path` takes new files.
Status CheckWritable(const std::string& path) {
  const std::filesystem::path parent = std::filesystem::path(path).parent_path();
  if (access(parent.empty() ? "." : parent.c_str(), W_OK) == 0) return {};
  return Error{path, "cannot be written (" + std::generic_category().message(errno) + ")",
               "a place with room that can be written", ""};
}

}  // namespace

struct SeriesWriter::Impl {
  std::string path;
  Handle file{-1, &H5Fclose};  ///< in memory only
  std::vector<Handle> datasets;
  std::vector<std::vector<double>> buffer;  ///< [channel][row of the block]
  hsize_t buffered = 0;
  hsize_t written = 0;
  bool failed = false;

  Error Fault() {
    failed = true;
    return {path, "cannot be written (HDF5 fails)", "a place with room that can be written", ""};
  }

  Status Flush() {
    if (failed) return Fault();
    if (buffered == 0) return {};
    SilenceHdf5();  // the writer may have moved to another thread
    const hsize_t total = written + buffered;
    const Handle memory(H5Screate_simple(1, &buffered, nullptr), &H5Sclose);
    for (size_t i = 0; i < datasets.size(); ++i) {
      if (H5Dset_extent(datasets[i], &total) < 0) return Fault();
      const Handle space(H5Dget_space(datasets[i]), &H5Sclose);
      H5Sselect_hyperslab(space, H5S_SELECT_SET, &written, nullptr, &buffered, nullptr);
      if (H5Dwrite(datasets[i], H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, buffer[i].data()) <
          0) {
        return Fault();
      }
    }
    written = total;
    buffered = 0;
    return {};
  }
};

SeriesWriter::SeriesWriter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
SeriesWriter::SeriesWriter(SeriesWriter&&) noexcept = default;
SeriesWriter& SeriesWriter::operator=(SeriesWriter&&) noexcept = default;
SeriesWriter::~SeriesWriter() = default;

Result<SeriesWriter> SeriesWriter::Create(const std::string& path,
                                          const std::vector<Channel>& channels) {
  SilenceHdf5();
  auto impl = std::make_unique<Impl>();
  impl->path = path;
  // Ends before a long run what would fail after it.
  if (Status s = CheckWritable(path); !s.ok()) return s.error();
  const Handle access(H5Pcreate(H5P_FILE_ACCESS), &H5Pclose);
  H5Pset_fapl_core(access, kImageStep, false);
  impl->file = Handle(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access), &H5Fclose);
  if (!impl->file.ok()) return impl->Fault();
  const Handle group(H5Gcreate2(impl->file, "channels", H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                     &H5Gclose);
  const hsize_t none = 0;
  const hsize_t unlimited = H5S_UNLIMITED;
  const Handle space(H5Screate_simple(1, &none, &unlimited), &H5Sclose);
  const Handle layout(H5Pcreate(H5P_DATASET_CREATE), &H5Pclose);
  H5Pset_chunk(layout, 1, &kBlock);
  H5Pset_shuffle(layout);
  H5Pset_deflate(layout, 3);
  // Time stamps would make two equal runs differ in bytes.
  H5Pset_obj_track_times(layout, false);
  int index = 0;  // /channels lists by name
  for (const Channel& channel : channels) {
    Handle dataset(H5Dcreate2(group, channel.name.c_str(), H5T_NATIVE_DOUBLE, space, H5P_DEFAULT,
                              layout, H5P_DEFAULT),
                   &H5Dclose);
    if (!dataset.ok()) {
      return Error{path, "channel '" + channel.name + "' cannot be created", "each name once", ""};
    }
    if (!WriteText(dataset, "unit", channel.unit) ||
        !WriteText(dataset, "description", channel.description) ||
        !WriteText(dataset, "index", std::to_string(index++))) {
      return impl->Fault();
    }
    impl->datasets.push_back(std::move(dataset));
    impl->buffer.emplace_back(kBlock);
  }
  return SeriesWriter(std::move(impl));
}

Status SeriesWriter::Append(const double* row) {
  if (impl_->failed) return impl_->Fault();
  for (size_t i = 0; i < impl_->buffer.size(); ++i) impl_->buffer[i][impl_->buffered] = row[i];
  return ++impl_->buffered == kBlock ? impl_->Flush() : Status();
}

Status SeriesWriter::Note(const std::string& name, const std::string& value) {
  if (impl_->failed || !WriteText(impl_->file, name, value)) return impl_->Fault();
  return {};
}

Status SeriesWriter::Close() {
  if (Status s = impl_->Flush(); !s.ok()) return s;
  impl_->datasets.clear();
  if (!impl_->file.ok() || H5Fflush(impl_->file, H5F_SCOPE_LOCAL) < 0) return impl_->Fault();
  const ssize_t size = H5Fget_file_image(impl_->file, nullptr, 0);
  if (size <= 0) return impl_->Fault();
  std::string image(static_cast<size_t>(size), '\0');
  if (H5Fget_file_image(impl_->file, image.data(), image.size()) != size) return impl_->Fault();
  if (!impl_->file.Close()) return impl_->Fault();
  return WriteFileAtomically(impl_->path, image);
}

int Series::Find(const std::string& name) const {
  for (size_t i = 0; i < channels.size(); ++i) {
    if (channels[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

namespace {

/// One dataset of /channels.
struct ReadChannel {
  double order = 0;
  Channel channel;
  std::vector<double> values;
};

Result<ReadChannel> ReadOne(hid_t group, const std::string& name, const std::string& path) {
  const Error fault{path, "channel " + Quoted(name) + " cannot be read", "a list of numbers", ""};
  const Handle dataset(H5Dopen2(group, name.c_str(), H5P_DEFAULT), &H5Dclose);
  if (!dataset.ok()) return fault;
  const Handle space(H5Dget_space(dataset), &H5Sclose);
  if (H5Sget_simple_extent_ndims(space) != 1) return fault;
  hsize_t count = 0;
  H5Sget_simple_extent_dims(space, &count, nullptr);
  // A broken file may claim any length: no more than deflate could have packed into the file.
  const hsize_t stored = H5Dget_storage_size(dataset);
  constexpr hsize_t kMostPacked = 1100;
  if (count * sizeof(double) > (stored + kBlock) * kMostPacked) return fault;
  ReadChannel one;
  one.values.resize(count);
  if (H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, one.values.data()) < 0) {
    return fault;
  }
  one.channel = {name, ReadText(dataset, "unit"), ReadText(dataset, "description")};
  one.order = ParseNumber(ReadText(dataset, "index")).value_or(0);
  return one;
}

/// The name of link `i` of a group.
std::string LinkName(hid_t group, hsize_t i) {
  const ssize_t size =
      H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, i, nullptr, 0, H5P_DEFAULT);
  std::string name(size > 0 ? static_cast<size_t>(size) : 0, '\0');
  H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, i, name.data(), name.size() + 1,
                     H5P_DEFAULT);
  return name;
}

herr_t ReadNote(hid_t file, const char* name, const H5A_info_t*, void* notes) {
  (*static_cast<std::map<std::string, std::string>*>(notes))[name] = ReadText(file, name);
  return 0;
}

}  // namespace

Result<Series> ReadSeries(const std::string& path) {
  SilenceHdf5();
  const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), &H5Fclose);
  if (!file.ok()) return Error{path, "cannot be read", "an HDF5 time series", "check the path"};
  const Handle group(H5Gopen2(file, "channels", H5P_DEFAULT), &H5Gclose);
  if (!group.ok()) return Error{path, "has no /channels", "a time series written by phs", ""};
  H5G_info_t info{};
  H5Gget_info(group, &info);
  std::vector<ReadChannel> read;
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    auto one = ReadOne(group, LinkName(group, i), path);
    if (!one.ok()) return one.error();
    if (!read.empty() && one.value().values.size() != read[0].values.size()) {
      return Error{path, "channel " + Quoted(one.value().channel.name) + " has another length",
                   "channels of equal length", ""};
    }
    read.push_back(std::move(one).value());
  }
  std::stable_sort(read.begin(), read.end(),
                   [](const ReadChannel& a, const ReadChannel& b) { return a.order < b.order; });
  Series series;
  for (ReadChannel& one : read) {
    series.channels.push_back(std::move(one.channel));
    series.columns.push_back(std::move(one.values));
  }
  H5Aiterate2(file, H5_INDEX_NAME, H5_ITER_INC, nullptr, &ReadNote, &series.notes);
  return series;
}

}  // namespace phs
