// A vehicle as a model to be looked at: the physics' MJCF as it stands, the fixed shapes of
// bogie_xml/view/NAME.xml put into its bodies, meshes of its wheels and its track. Made in memory
// and for pictures alone: nothing is simulated with it, and no callback is attached to it.
//
// Shapes stand beside the bogie's file: FOLDER/NAME.xml is looked at with FOLDER/view/NAME.xml.
// There, bodies are named as in the bogie and hold geoms and sites; tendons between sites say what
// is drawn between moving parts, by their name: spring:…, damper:…, rod:… (draw_elements.h).
#pragma once

#include <array>
#include <memory>
#include <string>

#include "plugin/binding.h"
#include "vehicle/engine.h"
#include "vehicle/scenario.h"
#include "view/mesh.h"

namespace phs::view {

/// Meshes of a view model, in the order of their ids after those of the file.
enum class MeshSlot { kWheelLeft, kWheelRight, kRailLeft, kRailRight, kBallast, kCoils, kCount };

class ViewModel {
 public:
  /// Errors name the file and the element.
  static Result<ViewModel> Create(const vehicle::Scenario& scenario);

  mjModel* model() const { return model_.get(); }
  const plugin::Binding& binding() const { return *binding_; }
  const Section& rail_section() const { return rail_section_; }
  int MeshId(MeshSlot slot) const { return first_mesh_ + static_cast<int>(slot); }
  /// Fills a mesh anew; it must have the numbers of vertices and faces that it was made with.
  void SetMesh(MeshSlot slot, const Mesh& mesh);
  /// True once after the mesh was filled anew.
  bool TakeChanged(MeshSlot slot);
  /// True if shapes beside the physics were found.
  bool has_shapes() const { return has_shapes_; }

 private:
  vehicle::ModelPtr model_;
  std::unique_ptr<plugin::Binding> binding_;
  Section rail_section_;
  int first_mesh_ = 0;
  bool has_shapes_ = false;
  std::array<bool, static_cast<size_t>(MeshSlot::kCount)> changed_{};
};

/// Turns of a drawn coil spring.
inline constexpr double kCoilTurns = 6.5;

}  // namespace phs::view
