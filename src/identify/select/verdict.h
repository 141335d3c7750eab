// What an identification says in one word, and why.
//
//   sufficient      nothing is missing: what the declared model leaves is its noise
//   explained       the accepted effects take most of what it leaves
//   not_described   something is there that neither has; also data that contradict themselves
//   undecidable     two effects explain as much: the record does not tell which
// "Noise": of the mean square of the worst channel over that of sensor noise and uncertain input,
// no more than 1 is beyond the noise and follows what the rig did (motion_share.h), so that
// whatever the model lacks is no larger than the noise itself. What does not follow is noise with a
// colour, unless it comes and goes: that is something beside the rig. Both windows are judged: what
// stands out in the estimation window alone is missing in the model all the same.
// "Most": more than half of the mean square beyond the noise.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace phs::identify {

/// Mean square beyond the noise, over it, that a model may lack and suffice.
inline constexpr double kAsLargeAsNoise = 1;

/// What a channel leaves on a window.
struct ChannelLeft {
  std::string channel;
  double before = 1, after = 1;  ///< rms over noise: declared model as fitted, corrected model
  double of_sigma = 0;           ///< rms over the channel's own standard deviation, corrected
  /// Mean square over that of the noise, corrected, of the part that follows what the rig did.
  double following = std::numeric_limits<double>::infinity();
  bool comes_and_goes = false;  ///< what is left is not there all the time (motion_share.h)
  bool quiet_at_rest = false;   ///< IsQuietAtRest (motion_share.h)
  /// Of what stands on two levels (motion_share.h), over the noise, and how often it jumps; 0: it
  /// does not.
  double levels_apart = 0;
  int jumps = 0;
  double swings_Hz = 0;  ///< about which most of what is left lies, of no motion (motion_share.h)
  std::string window = "validation";
};

/// The channels of the validation window, and of the estimation window those that lack more than
/// noise there.
std::vector<ChannelLeft> BothWindows(std::vector<ChannelLeft> validation,
                                     const std::vector<ChannelLeft>& estimation);

/// An accepted effect and those that explain as much.
struct NamedEffect {
  std::string name;
  std::vector<std::string> rivals = {};
  std::vector<std::string> special_case_of = {};  ///< what contains it, not told from it
  std::string own_form = {};             ///< a formula for what its law leaves of it (own_form.h)
  std::vector<std::string> at_end = {};  ///< its numbers at the end of their plausible range
};

/// A declared number after its fit.
struct FittedNumber {
  std::string name;
  double declared = 0, fitted = 0;
  bool at_end = false;  ///< of the range that it was allowed, and told
  bool told = true;     ///< its interval does not hold what is declared
};

/// A candidate that was refused for amounts at the end of what is plausible alone.
struct BeyondRange {
  std::string effect;
  std::vector<std::string> amounts;  ///< with their values
  std::string channel;               ///< that it mends most
  double share = 0;                  ///< of what this shows beyond its noise
};

struct VerdictFacts {
  std::vector<ChannelLeft> channels;
  std::vector<NamedEffect> effects;
  std::vector<FittedNumber> numbers;
  /// Of the data, not mended: a turned sign, swapped columns; of the model found: a formula that
  /// drives where it must dissipate.
  std::vector<std::string> faults;
  bool tried = true;  ///< any effect
  /// What would have explained most of what is left.
  std::optional<BeyondRange> beyond = {};
  std::vector<std::string> questions = {};  ///< of the data, said where no fault says more
};

struct Verdict {
  std::string word;                  ///< as above
  std::vector<std::string> reasons;  ///< short sentences
};

Verdict Judge(const VerdictFacts& facts);

/// For people: "explained by backlash", "not described by this model".
std::string VerdictSentence(const Verdict& verdict, const VerdictFacts& facts);

}  // namespace phs::identify
