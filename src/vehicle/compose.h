// From a scenario to a compiled MuJoCo model.
//
// A single bogie is its MJCF file as it stands. What the plugin needs and the file lacks is added
// in memory: the empty key "test" for the settled start, room in userdata. Tracks, profiles and PHS
// models that lie beside the file are found there. A file without <option timestep> gets 1 ms.
// Three more things are added where asked:
//   state carriers  a PHS model with more states than the file has activations (gas temperatures,
//                   clearances …) gets one force-free user actuator per further state;
//   locomotive      the bogie (frame, wheelsets, cylinders) is put twice, with names prefixed
//                   front_ and rear_, under the car body of bogie_xml/shared/locomotive_body.xml
//                   or the one that the bogie names: <text name="phs_car_body" data="…"/>. Any
//                   number of axles;
//   box springs     what the springs of one axle box have beyond the rest (box_springs.h).
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "vehicle/engine.h"
#include "vehicle/mjcf_document.h"
#include "vehicle/scenario.h"

namespace phs::vehicle {

/// A vehicle as MJCF in memory.
struct VehicleDocument {
  std::string path;      ///< of the bogie's file
  XmlPtr document;       ///< includes expanded
  bool changed = false;  ///< more than the file as it stands
};
/// Errors name the MJCF file, line and element.
Result<VehicleDocument> ComposeDocument(const Scenario& scenario);
/// The same compiled.
Result<ModelPtr> ComposeVehicle(const Scenario& scenario);

/// A bogie of bogie_xml that says what it is measured with: <text name="phs_yardstick" data="…"/>,
/// the conventional bogie with the same axles.
struct ComparedBogie {
  std::string name;
  std::string yardstick;
};
/// All that run as a single bogie (<text name="phs_vehicle" …/> asks for more); yardsticks first.
std::vector<ComparedBogie> ListComparedBogies();
/// The yardstick of one bogie, "" if it names none.
std::string YardstickOf(const std::string& bogie);

/// The track that a bogie file names, "" if it names none.
std::string TrackOf(const std::string& bogie);

/// The PHS model that a bogie file names for its first PHS, "" if it has none.
std::string PhsModelOf(const std::string& bogie);

}  // namespace phs::vehicle
