#include "plugin/elements.h"

#include <algorithm>

#include "plugin/engine_elements.h"
#include "plugin/site_damper.h"

namespace phs::plugin {
namespace {

constexpr ElementKind kKinds[] = {
    {"joint", "spring and damper of a joint", {}, &FindJointElements},
    {"tendon", "spring and damper along a tendon", {}, &FindTendonElements},
    {"damper", "hydraulic damper with relief valve between two sites", kSiteDamperKeys,
     &FindSiteDampers},
};

}  // namespace

std::span<const ElementKind> ElementKinds() { return kKinds; }

bool DeclaresElement(std::string_view tuple) noexcept {
  const std::string_view name = tuple.substr(0, tuple.find(':'));
  return name.size() < tuple.size() &&
         std::any_of(std::begin(kKinds), std::end(kKinds), [&](const ElementKind& kind) {
           return !kind.keys.empty() && name == kind.name;
         });
}

Result<ElementList> FindElements(const mjModel* m) {
  ElementList list;
  for (const ElementKind& kind : kKinds) {
    auto found = kind.find(m, kind);
    if (!found.ok()) return found.error();
    if (found.value() != nullptr) list.push_back(std::move(found).value());
  }
  return list;
}

}  // namespace phs::plugin
