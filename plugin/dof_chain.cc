#include "plugin/dof_chain.h"

#include <algorithm>

namespace phs::plugin {

std::vector<int> DofChain(const mjModel* m, int body) {
  std::vector<int> dofs;
  for (int b = body; b > 0; b = m->body_parentid[b]) {
    for (int k = 0; k < m->body_dofnum[b]; ++k) dofs.push_back(m->body_dofadr[b] + k);
  }
  std::sort(dofs.begin(), dofs.end());
  return dofs;
}

}  // namespace phs::plugin
