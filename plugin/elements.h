// The table of kinds of elements between bodies (element.h).
#pragma once

#include <span>
#include <string_view>

#include "base/result.h"
#include "plugin/element.h"

namespace phs::plugin {

std::span<const ElementKind> ElementKinds();

/// True if a tuple of this name declares an element of any kind.
bool DeclaresElement(std::string_view tuple) noexcept;
Result<ElementList> FindElements(const mjModel* m);

}  // namespace phs::plugin
