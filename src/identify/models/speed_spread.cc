#include "identify/models/speed_spread.h"

#include <cmath>

namespace phs::identify::search {

Status SpreadOverSpeed(const std::function<Status(double deviations, Channels* out)>& run,
                       Channels* u) {
  // Nodes: roots of He_5 = x (x^4 - 10 x^2 + 15). Weights off the middle, each twice, from the second
  // and the fourth moment of a standard normal number: 2 (w1 x1^2 + w2 x2^2) = 1, 2 (w1 x1^4 +
  // w2 x2^4) = 3.
  const double root = std::sqrt(10.0), near2 = 5 - root, far2 = 5 + root;
  const double near_weight = (far2 - 3) / (2 * near2 * (far2 - near2));
  const double far_weight = (3 - near2) / (2 * far2 * (far2 - near2));
  struct Node {
    double at, weight;
  };
  const Node nodes[] = {{std::sqrt(near2), near_weight},
                        {-std::sqrt(near2), near_weight},
                        {std::sqrt(far2), far_weight},
                        {-std::sqrt(far2), far_weight}};
  Channels plain;
  if (Status s = run(0, &plain); !s.ok()) return s;
  u->clear();
  for (const auto& channel : plain) u->emplace_back(channel.size(), 0.0);
  for (const Node& node : nodes) {
    Channels there;
    if (Status s = run(node.at, &there); !s.ok()) return s;
    for (size_t c = 0; c < plain.size(); ++c) {
      for (size_t i = 0; i < plain[c].size(); ++i) {
        (*u)[c][i] += node.weight * std::pow(there[c][i] - plain[c][i], 2);
      }
    }
  }
  for (auto& channel : *u) {
    for (double& square : channel) square = std::sqrt(square);
  }
  return {};
}

}  // namespace phs::identify::search
