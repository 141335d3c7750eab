// A model from the product's own folders or from text, attached for one test.
#pragma once

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <cstdio>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>

#include "phs_places.h"
#include "plugin/registry.h"
#include "plugin/settle.h"
#include "tests/base/scratch_dir.h"

namespace phs::plugin {

/// Any warning or error of MuJoCo fails the test.
class EngineGuard {
 public:
  EngineGuard() {
    mju_user_error = [](const char* text) { throw std::runtime_error(text); };
    mju_user_warning = [](const char* text) { ADD_FAILURE() << "MuJoCo warning: " << text; };
  }
  ~EngineGuard() {
    mju_user_error = nullptr;
    mju_user_warning = nullptr;
  }
};

struct DeleteModel {
  void operator()(mjModel* m) const {
    Detach(m);
    mj_deleteModel(m);
  }
};
struct DeleteData {
  void operator()(mjData* d) const { mj_deleteData(d); }
};
using ModelPtr = std::unique_ptr<mjModel, DeleteModel>;
using DataPtr = std::unique_ptr<mjData, DeleteData>;

inline std::string BogiePath(const std::string& name) {
  return std::string(PHS_SOURCE_DIR) + "/bogie_xml/" + name + ".xml";
}

inline ModelPtr LoadFile(const std::string& path) {
  char error[1000] = "";
  ModelPtr m(mj_loadXML(path.c_str(), nullptr, error, sizeof error));
  EXPECT_NE(m, nullptr) << error;
  return m;
}

inline ModelPtr LoadText(const std::string& xml) {
  const std::string path = ScratchFile("model.xml");
  std::ofstream(path) << xml;
  ModelPtr m = LoadFile(path);
  std::remove(path.c_str());
  return m;
}

}  // namespace phs::plugin
