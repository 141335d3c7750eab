#include "view/view_model.h"

#include <algorithm>
#include <array>
#include <utility>

#include "base/check.h"
#include "vehicle/compose.h"
#include "view/shapes.h"
#include "view/view_shapes.h"

namespace phs::view {
namespace {

using tinyxml2::XMLElement;

constexpr std::array<const char*, static_cast<size_t>(MeshSlot::kCount)> kMeshNames = {
    "view_wheel_left", "view_wheel_right", "view_rail_left",
    "view_rail_right", "view_ballast",     "view_coils"};

plugin::AttachOptions OptionsOf(const vehicle::Scenario& scenario) {
  plugin::AttachOptions options;
  options.track = scenario.track;
  options.wheel_profile = scenario.wheel;
  options.rail_profile = scenario.rail;
  options.creep_law = "linear";  // no creep force is asked for
  options.friction = scenario.friction;
  options.speed_m_s = scenario.speed_m_s;
  options.track_errors = scenario.track_errors;
  options.wear = scenario.wear;
  return options;
}

/// So many coils beside each other: the numbers of vertices that the springs' mesh is filled with.
Mesh RowOfCoils(int count) {
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    mesh.Append(Coil({1.0 * i, 0, 0}, {1.0 * i, 0, 0.3}, 0.1, 0.02, kCoilTurns));
  }
  return mesh;
}

/// All meshes as they stand at the start of the track.
std::vector<Mesh> MakeMeshes(const plugin::Binding& binding, const Section& rail_section,
                             int springs) {
  const rail::WheelRail& wheel_rail = binding.wheel_rail();
  const rail::Track& track = binding.track();
  const Eigen::Vector3d origin = ToEigen(track.FrameAt(0).origin);
  const Mesh wheel = WheelMesh(wheel_rail);
  return {wheel,
          Mirrored(wheel),
          RailMesh(rail_section, track, wheel_rail, rail::Side::kLeft, 0, origin),
          RailMesh(rail_section, track, wheel_rail, rail::Side::kRight, 0, origin),
          BallastMesh(track, 0, origin),
          RowOfCoils(std::max(1, springs))};
}

/// Sky, ground and light.
void AddSurroundings(XMLElement* root) {
  static constexpr char kText[] = R"(<mujoco>
  <visual>
    <global offwidth="3840" offheight="2160" fovy="35"/>
    <quality shadowsize="2048" offsamples="4" numslices="20" numstacks="6"/>
    <map znear="0.01" zfar="60" shadowclip="1.6" shadowscale="0.5" haze="0.35"
         fogstart="8" fogend="28"/>
    <rgba haze="0.86 0.89 0.92 1" fog="0.86 0.89 0.92 1"/>
    <headlight ambient="0.40 0.40 0.42" diffuse="0.34 0.34 0.34" specular="0.12 0.12 0.12"/>
  </visual>
  <asset>
    <texture name="view_sky" type="skybox" builtin="gradient" rgb1="0.62 0.74 0.87"
             rgb2="0.90 0.93 0.95" width="256" height="1536"/>
  </asset>
  <worldbody>
    <light name="view_sun" directional="true" castshadow="true" pos="-3 -5 9" dir="0.3 0.5 -0.9"
           ambient="0 0 0" diffuse="0.62 0.60 0.56" specular="0.25 0.25 0.25"/>
  </worldbody>
</mujoco>)";
  tinyxml2::XMLDocument document;
  document.Parse(kText);
  for (const XMLElement* section = document.RootElement()->FirstChildElement(); section != nullptr;
       section = section->NextSiblingElement()) {
    root->InsertEndChild(section->DeepClone(root->GetDocument()));
  }
}

/// Discs that stand for wheels in a file without shapes would lie in the wheels drawn.
void HideDiscs(const plugin::Binding& binding, mjModel* m) {
  const double least = 0.5 * binding.wheel_rail().params().wheel_radius;
  for (const plugin::WheelsetBinding& w : binding.wheelsets()) {
    for (int g = m->body_geomadr[w.body]; g < m->body_geomadr[w.body] + m->body_geomnum[w.body];
         ++g) {
      const bool disc = m->geom_type[g] == mjGEOM_CYLINDER && m->geom_size[3 * g] > least;
      if (disc) m->geom_group[g] = kHiddenGroup;
    }
  }
}

}  // namespace

Result<ViewModel> ViewModel::Create(const vehicle::Scenario& scenario) {
  auto composed = vehicle::ComposeDocument(scenario);
  if (!composed.ok()) return composed.error();
  vehicle::VehicleDocument& vehicle = composed.value();
  XMLElement* root = vehicle.document->RootElement();
  // Tracks and profiles are known from the bare model; the meshes made of them make the second one.
  auto bare = vehicle::CompileMjcf(*vehicle.document, vehicle.path);
  if (!bare.ok()) return bare.error();
  auto binding = plugin::Binding::Create(bare.value().get(), OptionsOf(scenario));
  if (!binding.ok()) return binding.error();
  if (!binding.value()->has_rail()) {
    return Error{vehicle.path, "names no wheelset", "a vehicle on rails", "see plugin/README.md"};
  }
  ViewModel view;
  auto shapes = AddShapes(vehicle.path, root);
  if (!shapes.ok()) return shapes.error();
  view.has_shapes_ = shapes.value();
  AddSurroundings(root);
  view.rail_section_ = RailSection(binding.value()->wheel_rail());
  const std::vector<Mesh> meshes =
      MakeMeshes(*binding.value(), view.rail_section_, CountTendons("spring", root));
  for (size_t i = 0; i < meshes.size(); ++i) AddMesh(kMeshNames[i], meshes[i], root);
  auto model = vehicle::CompileMjcf(*vehicle.document, vehicle.path + " with its shapes");
  if (!model.ok()) return model.error();
  view.model_ = std::move(model).value();
  view.model_->opt.jacobian = mjJAC_DENSE;  // pose.cc reads slopes of tendons as full rows
  auto bound = plugin::Binding::Create(view.model_.get(), OptionsOf(scenario));
  if (!bound.ok()) return bound.error();
  view.binding_ = std::move(bound).value();
  HideDiscs(*view.binding_, view.model_.get());
  view.first_mesh_ = mj_name2id(view.model_.get(), mjOBJ_MESH, kMeshNames[0]);
  for (size_t i = 0; i < meshes.size(); ++i) view.SetMesh(static_cast<MeshSlot>(i), meshes[i]);
  return view;
}

void ViewModel::SetMesh(MeshSlot slot, const Mesh& mesh) {
  changed_[static_cast<size_t>(slot)] = true;
  const int id = MeshId(slot);
  mjModel* m = model_.get();
  PHS_CHECK(m->mesh_vertnum[id] == static_cast<int>(mesh.vertex.size()));
  PHS_CHECK(m->mesh_facenum[id] == static_cast<int>(mesh.face.size()));
  float* vertex = m->mesh_vert + 3 * m->mesh_vertadr[id];
  float* normal = m->mesh_normal + 3 * m->mesh_vertadr[id];
  for (size_t i = 0; i < mesh.vertex.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      vertex[3 * i + static_cast<size_t>(k)] = mesh.vertex[i][k];
      normal[3 * i + static_cast<size_t>(k)] = mesh.normal[i][k];
    }
  }
  int* face = m->mesh_face + 3 * m->mesh_faceadr[id];
  for (size_t i = 0; i < mesh.face.size(); ++i) {
    std::copy(mesh.face[i].begin(), mesh.face[i].end(), face + 3 * i);
  }
}

bool ViewModel::TakeChanged(MeshSlot slot) {
  return std::exchange(changed_[static_cast<size_t>(slot)], false);
}

}  // namespace phs::view
