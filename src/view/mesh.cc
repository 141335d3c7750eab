#include "view/mesh.h"

#include <cmath>

#include "base/check.h"

namespace phs::view {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// A corner of a section as it is drawn: twice where the outline has an edge.
struct Corner {
  size_t point;
  Vector2d normal;
};

/// Two corners per edge of the outline: the faces of an edge share no vertex with the next one.
std::vector<Corner> CornersOf(const Section& section) {
  const size_t n = section.point.size();
  std::vector<Vector2d> edge(n);
  for (size_t i = 0; i < n; ++i) {
    const Vector2d along = section.point[(i + 1) % n] - section.point[i];
    edge[i] = Vector2d(along.y(), -along.x()).normalized();  // outward of an anticlockwise outline
  }
  const auto blend = [&](const Vector2d& own, const Vector2d& other) -> Vector2d {
    if (own.dot(other) < std::cos(section.edge_angle)) return own;
    return (own + other).normalized();
  };
  std::vector<Corner> corners;
  for (size_t i = 0; i < n; ++i) {
    corners.push_back({i, blend(edge[i], edge[(i + n - 1) % n])});
    corners.push_back({(i + 1) % n, blend(edge[i], edge[(i + 1) % n])});
  }
  return corners;
}

Vector3d Place(const Station& station, const Vector2d& p) {
  return station.origin + station.first * p.x() + station.second * p.y();
}

void AddQuad(int a, int b, int c, int d, Mesh* mesh) {
  mesh->face.push_back({a, b, c});
  mesh->face.push_back({a, c, d});
}

/// A flat end as a fan about the outline's middle: for outlines that can be seen whole from there.
void AddEnd(const Section& section, const Station& station, const Vector3d& normal, bool forward,
            Mesh* mesh) {
  const int first = static_cast<int>(mesh->vertex.size());
  Vector2d middle = Vector2d::Zero();
  for (const Vector2d& p : section.point) middle += p / static_cast<double>(section.point.size());
  mesh->vertex.push_back(Place(station, middle).cast<float>());
  for (const Vector2d& p : section.point) {
    mesh->vertex.push_back(Place(station, p).cast<float>());
  }
  const int n = static_cast<int>(section.point.size());
  for (int i = 0; i <= n; ++i) mesh->normal.push_back(normal.cast<float>());
  for (int i = 0; i < n; ++i) {
    const int here = first + 1 + i;
    const int next = first + 1 + (i + 1) % n;
    if (forward) {
      mesh->face.push_back({first, here, next});
    } else {
      mesh->face.push_back({first, next, here});
    }
  }
}

}  // namespace

void Mesh::Append(const Mesh& other) {
  const int shift = static_cast<int>(vertex.size());
  vertex.insert(vertex.end(), other.vertex.begin(), other.vertex.end());
  normal.insert(normal.end(), other.normal.begin(), other.normal.end());
  for (const auto& f : other.face) face.push_back({f[0] + shift, f[1] + shift, f[2] + shift});
}

Mesh Sweep(const Section& section, const std::vector<Station>& stations) {
  PHS_CHECK(section.point.size() >= 3 && stations.size() >= 2);
  const std::vector<Corner> corners = CornersOf(section);
  const int per_station = static_cast<int>(corners.size());
  Mesh mesh;
  for (const Station& station : stations) {
    for (const Corner& corner : corners) {
      mesh.vertex.push_back(Place(station, section.point[corner.point]).cast<float>());
      const Vector3d normal =
          station.first * corner.normal.x() + station.second * corner.normal.y();
      mesh.normal.push_back(normal.normalized().cast<float>());
    }
  }
  for (int k = 0; k + 1 < static_cast<int>(stations.size()); ++k) {
    for (int i = 0; i < per_station; i += 2) {
      const int a = k * per_station + i;
      AddQuad(a, a + 1, a + 1 + per_station, a + per_station, &mesh);
    }
  }
  const auto forward = [](const Station& s) { return s.first.cross(s.second).normalized(); };
  AddEnd(section, stations.front(), -forward(stations.front()), false, &mesh);
  AddEnd(section, stations.back(), forward(stations.back()), true, &mesh);
  return mesh;
}

Mesh Revolve(const Section& section, int segments) {
  const std::vector<Corner> corners = CornersOf(section);
  const int per_station = static_cast<int>(corners.size());
  Mesh mesh;
  for (int k = 0; k <= segments; ++k) {
    const double angle = 2 * M_PI * k / segments;
    const Vector3d radial(std::cos(angle), 0, std::sin(angle));
    for (const Corner& corner : corners) {
      const Vector2d& p = section.point[corner.point];
      mesh.vertex.push_back((Vector3d(0, p.x(), 0) + radial * p.y()).cast<float>());
      const Vector3d normal = Vector3d(0, corner.normal.x(), 0) + radial * corner.normal.y();
      mesh.normal.push_back(normal.cast<float>());
    }
  }
  for (int k = 0; k < segments; ++k) {
    for (int i = 0; i < per_station; i += 2) {
      const int a = k * per_station + i;
      // y x radial points along the growing angle's reverse, so the order is that of Sweep turned.
      AddQuad(a, a + per_station, a + 1 + per_station, a + 1, &mesh);
    }
  }
  return mesh;
}

Mesh Coil(const Vector3d& a, const Vector3d& b, double radius, double wire, double turns) {
  constexpr int kPerTurn = 16;
  constexpr int kRound = 6;
  const Vector3d axis = (b - a).normalized();
  const Vector3d u = axis.unitOrthogonal();
  const Vector3d v = axis.cross(u);
  const int steps = static_cast<int>(turns * kPerTurn);
  std::vector<Station> stations;
  for (int i = 0; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    const double angle = 2 * M_PI * turns * share;
    const Vector3d out = u * std::cos(angle) + v * std::sin(angle);
    const Vector3d around = v * std::cos(angle) - u * std::sin(angle);
    const Vector3d along = (around * (2 * M_PI * turns * radius) + (b - a)).normalized();
    stations.push_back({a + (b - a) * share + out * radius, out, along.cross(out)});
  }
  Section ring;
  ring.edge_angle = 1.5;
  for (int i = 0; i < kRound; ++i) {
    const double angle = 2 * M_PI * i / kRound;
    ring.point.push_back(wire * Vector2d(std::cos(angle), std::sin(angle)));
  }
  return Sweep(ring, stations);
}

}  // namespace phs::view
