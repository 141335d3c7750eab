#include "rail/irregularity_psd.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/wide.h"

namespace phs::rail {
namespace {

struct GermanSpectrum {
  const char* name;
  double alignment, level, gauge;  // Aa, Av, Ag [m rad]
};
constexpr GermanSpectrum kGerman[] = {{"errib176_low", 2.119e-7, 4.032e-7, 5.32e-8},
                                      {"errib176_high", 6.125e-7, 1.08e-6, 1.032e-7}};
constexpr double kGermanWc = 0.8246;
constexpr double kGermanWr = 0.0206;
constexpr double kGermanWs = 0.4380;

struct AmericanSpectrum {
  const char* name;
  double level, alignment;  // Av, Aa [cm^2 rad/m]
  double ws;                // [rad/m]
};
constexpr AmericanSpectrum kAmerican[] = {
    {"fra_1", 1.2107, 3.3634, 0.6046}, {"fra_2", 1.0181, 1.2107, 0.9308},
    {"fra_3", 0.6816, 0.4128, 0.8520}, {"fra_4", 0.5376, 0.3027, 1.1312},
    {"fra_5", 0.2095, 0.0762, 0.8209}, {"fra_6", 0.0339, 0.0339, 0.4380}};
constexpr double kAmericanWc = 0.8245;
constexpr double kAmericanK = 0.25;
constexpr double kSquareCentimetre = 1e-4;  // [m^2]

double German(const GermanSpectrum& a, IrregularityChannel channel, double w) {
  const double w2 = w * w;
  const double wc2 = kGermanWc * kGermanWc;
  const double base = wc2 / ((w2 + kGermanWr * kGermanWr) * (w2 + wc2));
  const double high_pass = w2 / (w2 + kGermanWs * kGermanWs);
  switch (channel) {
    case kAlignment:
      return a.alignment * base;
    case kLevel:
      return a.level * base;
    case kCrossLevel:
      return 4 * a.level * base * high_pass;  // angle to height: (2b)^2/b^2
    case kGauge:
      return a.gauge * base * high_pass;
  }
  return 0;
}

double American(const AmericanSpectrum& a, IrregularityChannel channel, double w) {
  const double w2 = w * w;
  const double wc2 = kAmericanWc * kAmericanWc;
  const double k = kAmericanK * kSquareCentimetre;
  switch (channel) {
    case kAlignment:
      return k * a.alignment * wc2 / (w2 * (w2 + wc2));
    case kLevel:
      return k * a.level * wc2 / (w2 * (w2 + wc2));
    case kCrossLevel:
    case kGauge:
      return 4 * k * a.level * wc2 / ((w2 + wc2) * (w2 + a.ws * a.ws));
  }
  return 0;
}

// SplitMix64 (Steele, Lea, Flood 2014) as a counter-based generator: a number of its own for each
// (seed, channel, harmonic), uniform in [0, 1).
double UniformAt(std::uint64_t seed, std::uint64_t channel, std::uint64_t harmonic) {
  std::uint64_t z = seed * 0xD1342543DE82EF95u + (channel << 40) + harmonic;
  for (int round = 0; round < 2; ++round) {
    z += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    z ^= z >> 31;
  }
  return static_cast<double>(z >> 11) * 0x1p-53;
}

// Samples are summed in an order of their own: eight blocks of 64 side by side, so that eight samples
// of one row fill vectors of the processor.
constexpr size_t kBlock = 64;
constexpr size_t kSideBySide = 8;
constexpr size_t kTogether = kBlock * kSideBySide;
using Row = double[kSideBySide];

/// Where sample i stands.
size_t Woven(size_t i) {
  const size_t inside = i % kTogether;
  return i - inside + inside % kBlock * kSideBySide + inside / kBlock;
}

// Adds amplitude cos(w s_i + phase) at s_i = i step to woven samples, by rotation, started anew every
// 64 samples so that rounding does not build up.
PHS_WIDE void AddCosine(double amplitude, double w, double phase, double step,
                        std::vector<double>* woven) {
  const double c = std::cos(w * step);
  const double s = std::sin(w * step);
  for (size_t begin = 0; begin < woven->size(); begin += kTogether) {
    Row re, im;
    for (size_t b = 0; b < kSideBySide; ++b) {
      const double angle = w * step * static_cast<double>(begin + b * kBlock) + phase;
      re[b] = amplitude * std::cos(angle);
      im[b] = amplitude * std::sin(angle);
    }
    double* x = woven->data() + begin;
    for (size_t i = 0; i < kBlock; ++i, x += kSideBySide) {
      Row next;
      for (size_t b = 0; b < kSideBySide; ++b) {
        x[b] += re[b];
        next[b] = re[b] * c - im[b] * s;
        im[b] = re[b] * s + im[b] * c;
      }
      for (size_t b = 0; b < kSideBySide; ++b) re[b] = next[b];
    }
  }
}

}  // namespace

const std::vector<std::string>& PsdNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const auto& spectrum : kGerman) all.emplace_back(spectrum.name);
    for (const auto& spectrum : kAmerican) all.emplace_back(spectrum.name);
    return all;
  }();
  return names;
}

double CalcPsd(const std::string& psd, IrregularityChannel channel, double w) {
  for (const auto& spectrum : kGerman) {
    if (psd == spectrum.name) return German(spectrum, channel, w);
  }
  for (const auto& spectrum : kAmerican) {
    if (psd == spectrum.name) return American(spectrum, channel, w);
  }
  PHS_CHECK(!"psd is one of PsdNames()");
  return 0;
}

double FinestWavelength(double speed_m_s) {
  constexpr double kBand_Hz = 20;
  constexpr double kUsual_m_s = 80 / 3.6;
  return std::clamp((speed_m_s > 0 ? speed_m_s : kUsual_m_s) / kBand_Hz, 0.5, 3.0);
}

namespace {

/// Samples and waves of one channel.
struct Grid {
  double intervals, step;  ///< of the way [1, m]
  double low, dw;          ///< least angular wave number, their distance [rad/m]
  double waves;
};

Grid WaveGridOf(const IrregularityPsdParams& params) {
  const double range = params.end_s - params.begin_s;
  const bool goes_on =
      params.finest_wavelength > 0 && params.finest_wavelength < params.shortest_wavelength;
  const double finest_wave = goes_on ? params.finest_wavelength : params.shortest_wavelength;
  const double step_wanted = finest_wave / 12;
  Grid g{};
  g.intervals = std::max(4.0, std::ceil(range / step_wanted));
  g.step = range / g.intervals;
  g.low = 2 * std::numbers::pi / params.longest_wavelength;
  const double high = 2 * std::numbers::pi / params.shortest_wavelength;
  const double finest = std::numbers::pi / range;
  const double harmonics = std::max(64.0, std::ceil((high - g.low) / finest));
  g.dw = (high - g.low) / harmonics;
  const double further = (2 * std::numbers::pi / finest_wave - high) / g.dw;
  g.waves = harmonics + std::max(0.0, std::floor(further + 1e-9));
  return g;
}

}  // namespace

double IrregularityWork(const IrregularityPsdParams& params) {
  const Grid g = WaveGridOf(params);
  return g.intervals * g.waves;
}

IrregularitySamples GenerateIrregularity(const IrregularityPsdParams& params) {
  PHS_CHECK(params.end_s > params.begin_s && params.shortest_wavelength > 0);
  PHS_CHECK(params.longest_wavelength > params.shortest_wavelength);
  const Grid g = WaveGridOf(params);
  const auto intervals = static_cast<size_t>(g.intervals);
  const auto waves = static_cast<size_t>(g.waves);
  IrregularitySamples samples;
  for (size_t i = 0; i <= intervals; ++i) {
    samples.s.push_back(params.begin_s + g.step * static_cast<double>(i));
  }
  for (int c = 0; c < kNumIrregularityChannels; ++c) {
    std::vector<double> woven((intervals / kTogether + 1) * kTogether, 0.0);
    for (size_t k = 0; k < waves; ++k) {
      const double w = g.low + (static_cast<double>(k) + 0.5) * g.dw;
      const double density = CalcPsd(params.psd, static_cast<IrregularityChannel>(c), w);
      const double phase =
          2 * std::numbers::pi * UniformAt(params.seed, static_cast<std::uint64_t>(c), k);
      AddCosine(params.scale * std::sqrt(2 * density * g.dw), w, phase, g.step, &woven);
    }
    std::vector<double>& x = samples.channel[c];
    for (size_t i = 0; i <= intervals; ++i) x.push_back(woven[Woven(i)]);
  }
  return samples;
}

}  // namespace phs::rail
