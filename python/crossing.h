// How values, errors and long work cross the border between Python and the libraries.
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <functional>
#include <future>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "base/origin.h"
#include "base/result.h"
#include "base/table.h"
#include "jobs/watch.h"

namespace phs::python {

namespace py = pybind11;
using Json = nlohmann::ordered_json;

/// Raises phs.Error with the parts of `error`. With the GIL.
[[noreturn]] void Raise(const Error& error);

template <typename T>
T Take(Result<T> result) {
  if (!result.ok()) Raise(result.error());
  return std::move(result).value();
}
inline void Take(const Status& status) {
  if (!status.ok()) Raise(status.error());
}

/// A table as {name: array}; a column with a cell that is no number is a list of texts.
py::dict ToPython(const Table& table);
/// A table from {name: numbers or texts}; `source` is for messages.
Table FromPython(const py::dict& columns, const std::string& source);

/// Notes of where a result comes from, while they live: the call as it stood in Python, and the
/// folder of the files that were made from its dicts.
OriginNotes NotesOf(const std::string& call, const std::string& given_folder);

/// Does `work(watch)` on a thread of its own with the GIL released; meanwhile Ctrl-C is heard and
/// `progress` (None or a function of the share done) is called. Either's exception stops the work
/// and is raised when it has ended.
class LongWork {
 public:
  explicit LongWork(py::object progress) : progress_(std::move(progress)) {}

  template <typename Work>
  auto Do(const Work& work) -> decltype(work(std::declval<const jobs::Watch&>())) {
    const jobs::Watch watch{.progress =
                                [this](double share) {
                                  share_ = share;
                                  return true;
                                },
                            .stopped = [this] { return stopped_.load(); }};
    auto done = [&] {
      const py::gil_scoped_release released;
      const OriginShare share;
      auto future = std::async(std::launch::async, [&] {
        const OriginShare::Part part(share);
        return work(watch);
      });
      while (future.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready) Look();
      return future.get();
    }();
    if (fault_) std::rethrow_exception(fault_);
    return done;
  }

 private:
  /// Signals and progress; takes the GIL.
  void Look();

  py::object progress_;
  std::atomic<double> share_{0};
  std::atomic<bool> stopped_{false};
  std::exception_ptr fault_;
};

}  // namespace phs::python
