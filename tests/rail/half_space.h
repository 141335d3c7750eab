// Normal contact of two elastic half-spaces of the same material, by elements of constant pressure:
// an answer to the question of contact that knows neither Hertz nor strips.
//
// u_i = sum_j A_ij p_j, A by Love (1929) with 1/(pi E*) = (1 - nu)/(pi G); p >= 0, separation
// u + gap - approach >= 0, their product 0, sum p = load: conjugate gradients of Polonsky and Keer
// (Wear 231, 1999). Symmetric in x (rolling direction): only x > 0 is stored.
#pragma once

#include <cmath>
#include <functional>
#include <vector>

namespace phs::rail {

class HalfSpace {
 public:
  /// Elements of dx times dy on |x| < nx dx, |y - centre| < ny dy/2 [m].
  HalfSpace(int nx, int ny, double dx, double dy, double centre, double compliance)
      : nx_(nx), ny_(ny), dx_(dx), dy_(dy), centre_(centre) {
    for (int i = 0; i < 2 * nx; ++i) {
      for (int j = 0; j < ny; ++j) kernel_.push_back(compliance * Love(i * dx, j * dy));
    }
  }

  /// `gap(x, y)` of the undeformed bodies but for a constant [m]; load [N].
  void Solve(const std::function<double(double, double)>& gap, double load) {
    const size_t n = static_cast<size_t>(nx_ * ny_);
    const double area = dx_ * dy_;
    std::vector<double> apart(n), g(n), t(n, 0), r(n);
    for (size_t k = 0; k < n; ++k) apart[k] = gap(X(k), Y(k));
    pressure_.assign(n, load / (2 * area * static_cast<double>(n)));
    double before = 1;
    bool restart = true;
    for (int iteration = 0; iteration < 1000; ++iteration) {
      Multiply(pressure_, &g);
      double mean = 0;
      double count = 0;
      for (size_t k = 0; k < n; ++k) {
        g[k] += apart[k];
        if (pressure_[k] > 0) mean += g[k], ++count;
      }
      mean /= count;
      double square = 0;
      for (size_t k = 0; k < n; ++k) {
        g[k] -= mean;
        if (pressure_[k] > 0) square += g[k] * g[k];
      }
      for (size_t k = 0; k < n; ++k) {
        t[k] = pressure_[k] > 0 ? g[k] + (restart ? 0 : square / before * t[k]) : 0;
      }
      before = square;
      if (std::sqrt(square / count) < 1e-10) break;
      Multiply(t, &r);
      double shift = 0;
      for (size_t k = 0; k < n; ++k) shift += t[k] == 0 ? 0 : r[k] / count;
      double above = 0;
      double below = 0;
      for (size_t k = 0; k < n; ++k) {
        if (pressure_[k] <= 0) continue;
        above += g[k] * t[k];
        below += (r[k] - shift) * t[k];
      }
      const double step = above / below;
      double sum = 0;
      restart = false;
      for (size_t k = 0; k < n; ++k) {
        if (pressure_[k] > 0) pressure_[k] = std::fmax(0, pressure_[k] - step * t[k]);
      }
      for (size_t k = 0; k < n; ++k) {
        if (pressure_[k] == 0 && g[k] < 0) {
          pressure_[k] = -step * g[k];
          restart = true;
        }
        sum += 2 * area * pressure_[k];
      }
      for (double& p : pressure_) p *= load / sum;
    }
  }

  /// Mean of f(y) weighted with the pressure.
  double Mean(const std::function<double(double)>& f) const {
    double above = 0;
    double below = 0;
    for (size_t k = 0; k < pressure_.size(); ++k) {
      above += pressure_[k] * f(Y(k));
      below += pressure_[k];
    }
    return above / below;
  }
  double Peak() const {
    double peak = 0;
    for (const double p : pressure_) peak = std::fmax(peak, p);
    return peak;
  }

 private:
  double X(size_t k) const {
    return (static_cast<double>(k / static_cast<size_t>(ny_)) + 0.5) * dx_;
  }
  double Y(size_t k) const {
    return centre_ + (static_cast<double>(k % static_cast<size_t>(ny_)) + 0.5 - 0.5 * ny_) * dy_;
  }
  /// Displacement at (x, y) under unit pressure on an element at the origin, times pi E*.
  double Love(double x, double y) const {
    const auto f = [](double a, double b) { return a * std::asinh(b / std::abs(a)); };
    const double x1 = x + dx_ / 2, x0 = x - dx_ / 2, y1 = y + dy_ / 2, y0 = y - dy_ / 2;
    return f(x1, y1) - f(x1, y0) - f(x0, y1) + f(x0, y0) + f(y1, x1) - f(y1, x0) - f(y0, x1) +
           f(y0, x0);
  }
  double Kernel(int i, int j) const { return kernel_[static_cast<size_t>(i * ny_ + std::abs(j))]; }
  void Multiply(const std::vector<double>& p, std::vector<double>* u) const {
    for (int i = 0; i < nx_; ++i) {
      for (int j = 0; j < ny_; ++j) {
        double sum = 0;
        for (int k = 0; k < nx_; ++k) {
          for (int l = 0; l < ny_; ++l) {
            const double at = p[static_cast<size_t>(k * ny_ + l)];
            if (at != 0) sum += at * (Kernel(std::abs(i - k), j - l) + Kernel(i + k + 1, j - l));
          }
        }
        (*u)[static_cast<size_t>(i * ny_ + j)] = sum;
      }
    }
  }

  int nx_, ny_;
  double dx_, dy_, centre_;
  std::vector<double> kernel_;
  std::vector<double> pressure_;
};

}  // namespace phs::rail
