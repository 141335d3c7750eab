#include "base/hdf5_series.h"

#include <hdf5.h>

#include <algorithm>

namespace phs {
namespace {

constexpr hsize_t kBlock = 1024;  ///< rows per chunk and per write

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

std::string ReadText(hid_t object, const std::string& name) {
  if (H5Aexists(object, name.c_str()) <= 0) return "";
  const Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), &H5Aclose);
  const Handle type(H5Aget_type(attribute), &H5Tclose);
  std::string value(H5Tget_size(type), '\0');
  if (H5Aread(attribute, type, value.data()) < 0) return "";
  value.resize(value.find('\0') == std::string::npos ? value.size() : value.find('\0'));
  return value;
}

}  // namespace

struct SeriesWriter::Impl {
  std::string path;
  Handle file{-1, &H5Fclose};
  std::vector<Handle> datasets;
  std::vector<std::vector<double>> buffer;  ///< [channel][row of the block]
  hsize_t buffered = 0;
  hsize_t written = 0;

  Error Fault() const {
    return {path, "cannot be written", "a place with room that can be written", ""};
  }

  Status Flush() {
    if (buffered == 0) return {};
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

Result<SeriesWriter> SeriesWriter::Create(const std::string& path, std::vector<Channel> channels) {
  SilenceHdf5();
  auto impl = std::make_unique<Impl>();
  impl->path = path;
  impl->file = Handle(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), &H5Fclose);
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
  // Order of creation is the order of the channels when read back; time stamps would make two equal
  // runs differ in bytes.
  H5Pset_obj_track_times(layout, false);
  int index = 0;
  for (const Channel& channel : channels) {
    Handle dataset(H5Dcreate2(group, channel.name.c_str(), H5T_NATIVE_DOUBLE, space, H5P_DEFAULT,
                              layout, H5P_DEFAULT),
                   &H5Dclose);
    if (!dataset.ok()) {
      return Error{path, "channel '" + channel.name + "' cannot be created", "each name once", ""};
    }
    WriteText(dataset, "unit", channel.unit);
    WriteText(dataset, "description", channel.description);
    WriteText(dataset, "index", std::to_string(index++));
    impl->datasets.push_back(std::move(dataset));
    impl->buffer.emplace_back(kBlock);
  }
  return SeriesWriter(std::move(impl));
}

Status SeriesWriter::Append(const double* row) {
  for (size_t i = 0; i < impl_->buffer.size(); ++i) impl_->buffer[i][impl_->buffered] = row[i];
  return ++impl_->buffered == kBlock ? impl_->Flush() : Status();
}

Status SeriesWriter::Note(const std::string& name, const std::string& value) {
  return WriteText(impl_->file, name, value) ? Status() : Status(impl_->Fault());
}

Status SeriesWriter::Close() {
  if (Status s = impl_->Flush(); !s.ok()) return s;
  bool closed = true;
  for (Handle& dataset : impl_->datasets) closed = dataset.Close() && closed;
  closed = impl_->file.Close() && closed;
  return closed ? Status() : Status(impl_->Fault());
}

int Series::Find(const std::string& name) const {
  for (size_t i = 0; i < channels.size(); ++i) {
    if (channels[i].name == name) return static_cast<int>(i);
  }
  return -1;
}

Result<Series> ReadSeries(const std::string& path) {
  SilenceHdf5();
  const Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), &H5Fclose);
  if (!file.ok()) return Error{path, "cannot be read", "an HDF5 time series", ""};
  const Handle group(H5Gopen2(file, "channels", H5P_DEFAULT), &H5Gclose);
  if (!group.ok()) return Error{path, "has no /channels", "a time series written by phs", ""};
  H5G_info_t info;
  H5Gget_info(group, &info);
  Series series;
  series.channels.resize(info.nlinks);
  series.columns.resize(info.nlinks);
  for (hsize_t i = 0; i < info.nlinks; ++i) {
    char name[512] = "";
    H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, i, name, sizeof name, H5P_DEFAULT);
    const Handle dataset(H5Dopen2(group, name, H5P_DEFAULT), &H5Dclose);
    const Handle space(H5Dget_space(dataset), &H5Sclose);
    std::vector<double> values(static_cast<size_t>(H5Sget_simple_extent_npoints(space)));
    if (!dataset.ok() ||
        H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0) {
      return Error{path, std::string("channel '") + name + "' cannot be read", "", ""};
    }
    const std::string order = ReadText(dataset, "index");
    const size_t at = order.empty() ? i : std::min<size_t>(std::stoul(order), info.nlinks - 1);
    series.channels[at] = {name, ReadText(dataset, "unit"), ReadText(dataset, "description")};
    series.columns[at] = std::move(values);
  }
  return series;
}

}  // namespace phs
