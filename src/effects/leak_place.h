// Where and how oil is lost past a seal, beside the pressure that drives it (hydraulics/pipe.h).
//   at a place: q times f(x) = (1 + tanh((x - x_1)/w))/2, x [m] from the static place: a scored
//     length of the bore or rod, a port that the piston uncovers; w < 0: below x_1; w = 0: everywhere
//   a film: q = h_out v in extension, -h_in |v| in retraction: what the rod carries out and does not
//     bring back. h [m2]: girth times thickness of the film that is left (0.1 m times 1 um, 1e-7). It
//     does the work of its flow against the pressure, a force h p, which is left out (1 N).
// Of a line with several cylinders the piston is that of the first.
#pragma once

#include <memory>

#include "hydraulics/extension.h"

namespace phs::effects {

/// `law` where the piston stands beyond `from` [m]; itself where `edge` [m] is 0.
std::unique_ptr<hydraulics::FlowLaw> AtPlace(std::unique_ptr<hydraulics::FlowLaw> law, double from,
                                             double edge);

/// The first cylinder that has this line, -1: none.
int CylinderOf(const hydraulics::PhsParams& params, int line);

class FilmFlow final : public hydraulics::FlowLaw {
 public:
  FilmFlow(double out_m2, double in_m2) : out_m2_(out_m2), in_m2_(in_m2) {}
  double Flow(const hydraulics::FlowPlace& at, double dp, double* slope) const noexcept override;

 private:
  double out_m2_, in_m2_;
};

}  // namespace phs::effects
