#include "vehicle/engine.h"

#include <algorithm>
#include <mutex>

namespace phs::vehicle {
namespace {

void OnError(const char* message) { throw EngineError(message); }
void OnWarning(const char*) {}

}  // namespace

void InstallEngineHandlers() {
  // The engine's handlers are global, and every thread that makes a vehicle comes here.
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  if (mju_user_error != &OnError) mju_user_error = &OnError;
  if (mju_user_warning != &OnWarning) mju_user_warning = &OnWarning;
}

Result<ModelPtr> LoadMjcf(const std::string& path) {
  InstallEngineHandlers();
  char message[1000] = "";
  try {
    ModelPtr model(mj_loadXML(path.c_str(), nullptr, message, sizeof message));
    if (model != nullptr) return model;
  } catch (const EngineError& e) {
    return Error{path, e.what(), "", ""};
  }
  std::string text = message;
  std::replace(text.begin(), text.end(), '\n', ' ');
  return Error{path, text, "an MJCF model of MuJoCo 2.2.2", ""};
}

std::string EngineWarning(const mjData* d) {
  for (int i = 0; i < mjNWARNING; ++i) {
    // Memory statistics of contacts and constraints do not concern a model without either.
    if (i == mjWARN_CONTACTFULL || i == mjWARN_CNSTRFULL) continue;
    if (d->warning[i].number > 0) return mju_warningText(i, d->warning[i].lastinfo);
  }
  return "";
}

}  // namespace phs::vehicle
