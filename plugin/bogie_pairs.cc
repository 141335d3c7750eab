#include "plugin/bogie_pairs.h"

namespace phs::plugin {

std::vector<BogiePair> FindBogies(const Binding& binding) {
  const auto index_of = [&](const std::string& name) {
    for (size_t i = 0; i < binding.wheelsets().size(); ++i) {
      if (binding.wheelsets()[i].name == name) return static_cast<int>(i);
    }
    return -1;
  };
  std::vector<BogiePair> bogies;
  for (size_t i = 0; i < binding.wheelsets().size(); ++i) {
    const std::string& name = binding.wheelsets()[i].name;
    if (name.size() < 4 || name.compare(name.size() - 4, 4, "lead") != 0) continue;
    const std::string prefix = name.substr(0, name.size() - 4);
    const int trail = index_of(prefix + "trail");
    if (trail >= 0) bogies.push_back({prefix, static_cast<int>(i), trail});
  }
  return bogies;
}

}  // namespace phs::plugin
