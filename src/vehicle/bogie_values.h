// Values of a bogie's MJCF file set by the name of their element: what a sweep varies.
//
//   key     ELEMENT.ATTRIBUTE. ELEMENT: the name of an element (joint, tendon, site, text …) or of a
//           default class, whose elements are meant then; `*` stands for any letters: "coupling_*".
//           ATTRIBUTE: one that the element states, or a key in the data of a text
//           ("damper:yaw_left.relief_N").
//   value   as the file would have it ("6.3e6", "1.7 0.8 0"), or "x2": every number of the file's
//           own value times 2.
//
// A value that the element takes from its class stands with the class: guidance_yaw.stiffness, not
// lead_yaw.stiffness.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/result.h"

namespace phs::vehicle {

/// Key and value.
using BogieValues = std::vector<std::pair<std::string, std::string>>;

/// A bogie as a file of its own: includes expanded, values set.
struct VariedBogie {
  std::string name;           ///< of the bogie, without folder and ending
  std::string text;           ///< MJCF
  std::string car_body;       ///< MJCF of its car body if that was changed, else ""
  std::string car_body_file;  ///< the name under which `text` looks for it beside itself
};

/// Elements are looked for in the bogie's file and in that of the car body it names. Errors: no such
/// element, or none of them states the attribute.
Result<VariedBogie> VaryBogie(const std::string& bogie, const BogieValues& values);

}  // namespace phs::vehicle
