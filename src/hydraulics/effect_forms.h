// How an effect is looked for in data: which of its numbers are freed together, from where a fit
// begins, what else its form may take on, where it may stand. Part of the effect's row; a search
// (src/identify) knows no effect by name.
//
// A fit begins from a grid: `count` values of each free number from `from` to `to`, by equal
// factors (by equal steps where one of the ends is not positive), each with each. On a rig and in a
// bogie numbers are in SI, inside the plausible range of the parameter. On a bench parts differ by
// powers of ten: numbers are in sizes of the declared part and its record, chosen by their unit
// (N: level of friction, m: half the way, s: duration …, src/identify/models/element_candidates.h).
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "hydraulics/phs_params.h"

namespace phs::hydraulics {

/// How the starts of a number go with those of the numbers before it.
enum class Walk {
  kEach,       ///< each with each
  kInStep,     ///< as the one before: its k-th with the k-th of that one
  kEitherWay,  ///< each with each; distances, to either side, from where it does nothing
};

/// A number that is freed, and its starts.
struct FormNumber {
  std::string name;
  double from = 0, to = 0;
  int count = 1;  ///< 1: `from` alone
  Walk walk = Walk::kEach;
  /// Bounds; not given: the plausible range. Of a number whose range begins at zero and whose
  /// starts are positive: from 1/300 of the smallest start.
  double low = NAN, high = NAN;
  bool in_si = false;  ///< on a bench: in SI too
};

/// Where an effect of several cylinders or lines is tried.
enum class Places {
  kAll,    ///< in all alike; of cylinders, also alone in the one whose load cell is worst explained
  kEach,   ///< in all alike, and in each alone
  kAlone,  ///< in each alone
};

struct EffectForm {
  std::vector<FormNumber> free = {};
  /// Numbers held at other than their default values.
  std::vector<std::pair<std::string, double>> held = {};
  Places places = Places::kAll;
  /// The first so many free numbers are its amounts: one of them must be there.
  int amounts = 1;
  /// On a bench: it needs these channels (p_Pa, temperature_K) or these free numbers of the part.
  std::vector<std::string> needs = {};
  /// On a bench: not where the part has one of these free already, which say the same. On a bogie:
  /// not at a line that has one of these free by itself.
  std::vector<std::string> beside = {};
  bool of_static_friction = false;  ///< on a bench: of a part whose friction has no state
};

/// Further numbers, freed together on top of a form while the record asks for them.
struct FormOption {
  std::vector<FormNumber> free;
  std::string with = {};     ///< only beside this number
  std::string without = {};  ///< not beside this number
  /// It tells sides apart (rod from bore): not where one place or side alone is meant.
  bool of_sides = false;
};

/// A number of the declared lines that is freed on a table of settled steps.
struct SettledNumber {
  std::string key;           ///< of LineParams, "accumulator_precharge_Pa"
  bool of_rod_line = false;  ///< of that line alone
  double of_gas_volume = 0;  ///< begins, where the model declares 0, at this share of it
};

/// Over what a law acts: a formula of this unit ("N", "m3", "m3_per_s", "m", "Pa") over no other
/// variables (symbols of effects/formula.h) is a form of it. No unit: no formula is.
struct LawOver {
  const char* unit = "";
  const char* variables = "";
  bool begins = false;  ///< the law itself begins at a value: so may a formula that stands for it
  bool always_begins = false;  ///< and must: a formula that begins nowhere is no form of it
};

/// All that a search needs to know of an effect. No forms: it is not looked for there.
struct EffectSearch {
  std::vector<EffectForm> rig = {}, bench = {}, bogie = {};
  std::vector<FormOption> options = {};  ///< on a rig
  std::vector<SettledNumber> steps = {};
  /// What the model declares of the first number: there the effect does nothing, and distances
  /// (Walk::kEitherWay) are shares of it. Null: nothing; then the parameter's default.
  double (*declared)(const PhsParams& params) = nullptr;
  /// Effects that are special cases of it: the larger one stands only where it explains more.
  std::vector<std::string> contains = {};
  LawOver over = {};
};

}  // namespace phs::hydraulics
