#include "rail/creep_law.h"
#include "rail/linear_creep.h"
#include "rail/polach.h"
#include "rail/simplified_theory.h"

namespace phs::rail {

const std::vector<CreepLawRow>& CreepLaws() {
  static const std::vector<CreepLawRow> rows = {
      LinearCreepRow(),
      FastsimRow(),
      PolachRow(),
      KalkerTableRow(),
  };
  return rows;
}

}  // namespace phs::rail
