// phs numbers: every number of a PHS model by the name that scenarios, sweeps and manifests use.
#include <fmt/format.h>

#include <memory>

#include "cli/verb_table.h"
#include "phs_model/phs_model.h"

namespace phs::cli {

void AddNumbers(CLI::App* verb, Action* action) {
  auto model = std::make_shared<std::string>();
  verb->add_option("model", *model, "PHS model: a name or a YAML file")->required();
  verb->callback([=] {
    *action = [=]() -> int {
      const auto params = phs_model::FindPhsParams(*model);
      if (!params.ok()) return BadInput(params.error());
      for (const auto& info : phs_model::ListAllParameters(params.value())) {
        fmt::print("{} = {:g} {}\n", info.name, info.value, info.unit);
      }
      return kDone;
    };
  });
}

}  // namespace phs::cli
