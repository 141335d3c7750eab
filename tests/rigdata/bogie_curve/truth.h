// What a measured run of the bogie is made of: a curve, a speed, what is always a little off the
// declared, and what is hidden.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "bogie_motion.h"
#include "sensors.h"

namespace bogie_curve {

// What can be hidden, and its number.
struct Hideable {
  const char* name;
  const char* text;
  void (*apply)(double value, struct Truth* truth);
};
const std::vector<Hideable>& HideableList();

struct Truth {
  std::string curve = "r550";
  CurveDesign design;
  BogieNumbers bogie;
  std::string phs = "bo_bo";  // the PHS model that it is near to, or "bo_bo_measured"
  SteeringNumbers steering = SteeringNumbers::Declared();
  std::string pair = "S1002";  // S1002 on UIC60, or "cone": a cone on a head of one arc
  double friction = 0.35;      // of wheel on rail
  uint64_t seed = 0;
  double seal_factor = 1, gas_factor = 1, oil_factor = 1;  // off the declared
  std::vector<std::pair<std::string, double>> hidden;
};

std::vector<std::string> CurveNames();
// Design and speed of a shipped scenario (curve_r250 …); throws std::invalid_argument.
Truth DeclaredTruth(const std::string& curve);
// Seals, gas and oil 5 to 15 % off the declared, the speed up to half a per cent.
void DrawOffDeclared(uint64_t seed, Truth* truth);
// Throws std::invalid_argument with the names that are known.
void Hide(const std::string& name, double value, Truth* truth);
BogieMotion MakeBogie(const Truth& truth, const TrackLine& track, const std::string& profiles);
std::string TruthJson(const Truth& truth, const std::string& command);

}  // namespace bogie_curve
