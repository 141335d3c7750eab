// Owning handles for MuJoCo's objects, and its errors as C++ values: by default MuJoCo 2.2.2
// prints, waits for Enter and exits on an error, and writes warnings to a log file.
#pragma once

#include <mujoco/mujoco.h>

#include <memory>
#include <stdexcept>
#include <string>

#include "base/result.h"

namespace phs::vehicle {

struct ModelDeleter {
  void operator()(mjModel* m) const { mj_deleteModel(m); }
};
struct DataDeleter {
  void operator()(mjData* d) const { mj_deleteData(d); }
};
using ModelPtr = std::unique_ptr<mjModel, ModelDeleter>;
using DataPtr = std::unique_ptr<mjData, DataDeleter>;

/// Thrown out of MuJoCo by its error handler.
struct EngineError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Installs handlers: errors throw EngineError, warnings are silent (they are read from
/// mjData::warning). Idempotent; call before the first MuJoCo call.
void InstallEngineHandlers();

/// Loads MJCF text as if it were the file `path` (includes are relative to its folder).
Result<ModelPtr> LoadMjcf(const std::string& path);

/// Name of the first kind of warning in `d`, or "" if there is none.
std::string EngineWarning(const mjData* d);

}  // namespace phs::vehicle
