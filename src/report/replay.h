// A run to be seen again in a page: places of all parts of the bogies at instants along the track,
// the track, and how the leading wheels lie on their rails. Made by src/film; here it only becomes
// what the page's script draws. Nothing in it is an equation: the script interpolates places.
//
// Frames: world as the track's; vehicle frame L, origin on the centre line under the vehicle's
// middle, x along the track in plan, z upright. Instants are evenly spaced over the leading
// wheelset's arc length, the abscissa of the plots.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace phs::report {

class ReportPage;
struct CurvingResults;

/// One number per instant, or a single one that stays; NaN = none just then.
using Course = std::vector<double>;

struct ReplayMesh {
  std::vector<std::array<float, 3>> vertex;
  std::vector<std::array<float, 3>> normal;  ///< unit
  std::vector<std::array<int, 3>> face;
  bool operator==(const ReplayMesh&) const = default;
};

/// One shape. Bars (cylinder, capsule, arrow, coil) stand between two points, x y z of each; solids (box,
/// ball, mesh) have an origin and a quaternion w x y z.
struct ReplayPart {
  std::string kind;
  int mesh = -1;               ///< of a mesh, or of a coil one long along z
  bool mirrored = false;       ///< the mesh with y turned round
  std::array<double, 3> size;  ///< radius of a bar; half lengths of a box or ball
  int colour = 0;              ///< into Replay::colours
  double alpha = 1;
  int body = -1;  ///< that carries it: `place` is then one for all looks, in the body's axes
  std::vector<std::vector<Course>> place;  ///< [look][6 or 7], in L where no body carries it
};

/// Where a leading wheel lies on its rail: axes of the rail profile, y outward (to the field
/// side), z down [m].
struct ReplayWheel {
  std::string name;                 ///< "left wheel"
  Course offset_y, offset_z, roll;  ///< wheel profile's origin and turn against the rail's
  struct Patch {
    Course y, z, angle;     ///< place on the rail; slope of the surface [rad]
    Course a, b;            ///< semi-axes along and across [m]
    Course pressure, load;  ///< greatest [Pa], normal force [N]
    Course share;           ///< of it that counts, below 1 while two patches grow into one
  };
  std::vector<Patch> patches;
};

struct ReplayBogie {
  std::string name;  ///< as the results call it
  std::string title;
  double last_s = 0;                                       ///< where its run ended [m]
  Course middle_s;                                         ///< of the vehicle's middle [m]
  std::vector<std::vector<std::array<Course, 7>>> bodies;  ///< [look][body], in L
  std::vector<ReplayPart> parts;
  std::vector<std::string> caption_names;
  std::vector<std::vector<std::string>> captions;  ///< [line][instant]
  std::vector<std::array<double, 2>> wheel_outline, rail_outline;
  std::vector<ReplayWheel> wheels;  ///< empty where numbers stand for the profiles
};

struct ReplayView {
  std::string name, text;
  double azimuth_deg = 0, elevation_deg = 0,
         distance_m = 0;           ///< as view/camera.h, against the track
  std::array<double, 3> target{};  ///< in L
};

struct Replay {
  std::string missing;  ///< why there is none; then all else is empty
  double begin_s = 0, end_s = 0;
  Course time;  ///< of the first bogie at each instant [s]
  std::vector<std::string> looks;
  std::vector<std::array<Course, 3>> colours;  ///< red, green, blue 0 … 1
  std::vector<ReplayMesh> meshes;
  std::vector<ReplayView> views;
  std::vector<ReplayBogie> bogies;

  /// The track at even spacing: centre of the rail top plane, directions to the left and up, and of
  /// each rail's origin the place to the left and up, 13 numbers a station.
  double stations_begin_s = 0, stations_step_m = 0;
  std::vector<float> stations;
  int rail_mesh = -1, bed_mesh = -1;                     ///< one long along x
  std::array<double, 3> sleeper{};                       ///< half lengths
  double sleeper_height = 0;                             ///< of its middle
  std::array<std::array<double, 3>, 3> track_colours{};  ///< rail, sleeper, bed

  double pressure_low_Pa = 0, pressure_high_Pa = 0;  ///< ends of the colours; equal without lines
  std::vector<std::array<double, 3>> pressure_colours;
  std::string arrows;  ///< what the arrows stand for
};

/// The replay of the run in a result folder (src/film).
using MakeReplay = std::function<Replay(const std::string& dir)>;

/// JSON of the page's script (web/replay.js).
std::string ReplayJson(const Replay& replay);
/// The section of the curving report, or why it is missing.
void AddReplay(const Replay& replay, const CurvingResults& results, ReportPage* page);

}  // namespace phs::report
