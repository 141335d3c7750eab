// Elements that a model declares in its <custom> section:
//
//   <tuple name="damper:yaw_left"><element objtype="site" objname="on_frame"/>
//     <element objtype="site" objname="on_body"/></tuple>
//   <text name="damper:yaw_left" data="damping_Ns_per_m=2e5 relief_N=9e3"/>
#pragma once

#include <map>
#include <string>
#include <vector>

#include "plugin/element.h"

namespace phs::plugin {

struct DeclaredElement {
  std::string kind;
  std::string name;  ///< without its kind
  std::vector<int> sites;
  std::map<std::string, double> numbers;  ///< every key of its kind
};

/// Those of one kind, each between `num_sites` different sites. Errors: another number of sites; no
/// text, or one without its tuple; a key that is unknown, missing, no number or out of range.
Result<std::vector<DeclaredElement>> ReadDeclared(const mjModel* m, const ElementKind& kind,
                                                  size_t num_sites);

}  // namespace phs::plugin
