// Shapes of bogie_xml/view put into a vehicle's document.
#pragma once

#include <tinyxml2.h>

#include <string>

#include "base/result.h"
#include "view/mesh.h"

namespace phs::view {

/// Geom groups: what the physics' file draws itself, shapes, parts of the car body.
inline constexpr int kPhysicsGroup = 0;
inline constexpr int kHiddenGroup = 5;
inline constexpr int kBodyGroup = 2;

/// Adds bodies' geoms and sites, tendons, assets and defaults of FOLDER/view/NAME.xml; false if
/// there is no such file. What the physics' file draws itself is put into the hidden group then.
/// Errors name the file and the body that the vehicle has not.
Result<bool> AddShapes(const std::string& bogie_path, tinyxml2::XMLElement* root);

/// A mesh asset with these vertices and faces.
void AddMesh(const std::string& name, const Mesh& mesh, tinyxml2::XMLElement* root);

/// Number of spatial tendons whose name begins so (behind a bogie's prefix).
int CountTendons(const std::string& kind, const tinyxml2::XMLElement* root);

}  // namespace phs::view
