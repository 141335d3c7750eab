// Formulas at work: as forces, volumes, flows and readings (unlisted.h says over what each may be).
#pragma once

#include <string>

#include "effects/formula.h"
#include "hydraulics/extension.h"

namespace phs::effects {

Error RefuseEffect(const hydraulics::EffectParams& effect, const std::string& what,
                   const std::string& allowed);

/// Beside friction, on the piston.
void AddForceTo(int cylinder, const Formula& formula, hydraulics::Extension* extension);
/// Taken up by the target lines over their pressure.
Status AddVolume(const hydraulics::EffectParams& effect, const Formula& formula,
                 hydraulics::Extension* extension);
/// Out of the target lines, or from bore to rod of the target cylinders.
Status AddFlow(const hydraulics::EffectParams& effect, const Formula& formula,
               hydraulics::Extension* extension);
/// What the sensors of the targets show beyond the truth: of forces the load cell, of lengths the
/// piston, of pressures those of lines.
Status AddReading(const hydraulics::EffectParams& effect, const Formula& formula, FormulaUnit unit,
                  hydraulics::Extension* extension);

}  // namespace phs::effects
