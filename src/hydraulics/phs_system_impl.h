// What a PhsSystem holds, for its own files.
#pragma once

#include "hydraulics/compiled_phs.h"
#include "hydraulics/phs_system.h"

namespace phs::hydraulics {

struct PhsSystem::Impl : CompiledPhs {};

}  // namespace phs::hydraulics
