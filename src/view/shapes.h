// Meshes of one vehicle on its track, made from the profiles that it runs on.
#pragma once

#include <Eigen/Dense>
#include <vector>

#include "rail/track.h"
#include "rail/wheel_rail.h"
#include "view/mesh.h"

namespace phs::view {

/// A wheel about its axle (y), its tape circle at y = 0, outer face towards +y: tread and flange as
/// the profile has them, web and hub as a common solid wheel's (not of any standard).
Mesh WheelMesh(const rail::WheelRail& wheel_rail);
/// The same mirrored in y.
Mesh Mirrored(const Mesh& mesh);

/// Section of the rail in (y to the left, z up) about the profile's origin, as a left rail: the
/// head as the profile has it, web and foot of a 60 kg/m rail below (172 mm high).
Section RailSection(const rail::WheelRail& wheel_rail);
/// Outline of the wheel in the plane of the axle, (y outward, z down) from the profile's origin:
/// what is cut when the wheel is looked at along the rail.
std::vector<Eigen::Vector2d> WheelOutline(const rail::WheelRail& wheel_rail);

/// Distance of wheel and rail profiles' origins from the middle [m]; near the gauge where numbers
/// stand for the profiles.
double WheelPosition(const rail::WheelRail& wheel_rail);
double RailPosition(const rail::WheelRail& wheel_rail);

/// Where meshes along the track stand: places before and after the vehicle, denser near it [m].
std::vector<double> TrackStations();

/// A rail along the true alignment with cant, widening and irregularities, from places about `s`;
/// `origin` is what stands at zero in the picture.
Mesh RailMesh(const Section& section, const rail::Track& track, const rail::WheelRail& wheel_rail,
              rail::Side side, double s, const Eigen::Vector3d& origin);
/// Section of the ballast below, (y to the left, z up) about the middle of the track.
Section BallastSection(const rail::Track& track);
/// Swept along the track about `s`.
Mesh BallastMesh(const rail::Track& track, double s, const Eigen::Vector3d& origin);

inline constexpr double kRailHeight = 0.172;   ///< [m]
inline constexpr double kSleeperTop = -0.182;  ///< below the rail top, pad between [m]

/// Sleepers, boxes [m]: half their length along the track and half their height.
inline constexpr double kSleeperSpacing = 0.65;
inline constexpr double kSleeperHalfWidth = 0.125;
inline constexpr double kSleeperHalfHeight = 0.10;
inline double SleeperHalfLength(const rail::Track& track) { return 0.5 * track.gauge() + 0.58; }

inline Eigen::Vector3d ToEigen(const rail::Vec3& v) { return {v[0], v[1], v[2]}; }

}  // namespace phs::view
