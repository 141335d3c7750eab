// Springs and dampers that MuJoCo itself puts on joints and along tendons: linkages between axles.
#pragma once

#include "plugin/element.h"

namespace phs::plugin {

Result<std::unique_ptr<const Elements>> FindJointElements(const mjModel* m,
                                                          const ElementKind& kind);
Result<std::unique_ptr<const Elements>> FindTendonElements(const mjModel* m,
                                                           const ElementKind& kind);

}  // namespace phs::plugin
