// Circle, sphere and cylinder by Ceres: FIT ELEMENT FILE RUNS cx cy cz dx dy dz radius.
// Answers with the median seconds (building the problem included) and the numbers found.
#include <ceres/ceres.h>
#include <glog/logging.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <vector>

struct Ball {
  const double* p;
  template <typename T>
  bool operator()(const T* x, T* r) const {
    T a = p[0] - x[0], b = p[1] - x[1], c = p[2] - x[2];
    r[0] = sqrt(a * a + b * b + c * c) - x[3];
    return true;
  }
};

struct Circle {
  const double* p;
  template <typename T>
  bool operator()(const T* x, T* r) const {
    T a = p[0] - x[0], b = p[1] - x[1];
    r[0] = sqrt(a * a + b * b) - x[2];
    return true;
  }
};

// the axis (x0 + a e1 + b e2, d0 + u e1 + v e2) in a frame about the start
struct Frame {
  double c[3], d[3], e[3], f[3];
};

struct Tube {
  const double* p;
  const Frame* s;
  template <typename T>
  bool operator()(const T* x, T* r) const {
    T w[3], d[3], t(0.0), l(0.0), q(0.0);
    for (int i = 0; i < 3; i++) {
      w[i] = p[i] - s->c[i] - x[0] * s->e[i] - x[1] * s->f[i];
      d[i] = s->d[i] + x[2] * s->e[i] + x[3] * s->f[i];
      t += w[i] * d[i];
      l += d[i] * d[i];
      q += w[i] * w[i];
    }
    r[0] = sqrt(q - t * t / l) - x[4];
    return true;
  }
};

int main(int argc, char** argv) {
  google::InitGoogleLogging(argv[0]);
  if (argc != 11) return 2;
  const bool circle = !strcmp(argv[1], "circle2d"), sphere = !strcmp(argv[1], "sphere");
  double start[7];
  for (int i = 0; i < 7; i++) start[i] = atof(argv[4 + i]);
  const int width = circle ? 2 : 3;
  std::ifstream file(argv[2], std::ios::binary | std::ios::ate);
  std::vector<double> points(file.tellg() / sizeof(double));
  file.seekg(0);
  file.read(reinterpret_cast<char*>(points.data()), points.size() * sizeof(double));
  const size_t count = points.size() / width;

  Frame frame;
  const double l = std::sqrt(start[3] * start[3] + start[4] * start[4] + start[5] * start[5]);
  for (int i = 0; i < 3; i++) frame.c[i] = start[i], frame.d[i] = start[3 + i] / l;
  const double* d = frame.d;
  const double across = std::sqrt(d[1] * d[1] + d[2] * d[2]);
  const double e[3] = {0, d[2] / across, -d[1] / across};
  const double f[3] = {d[1] * e[2] - d[2] * e[1], d[2] * e[0] - d[0] * e[2], d[0] * e[1] - d[1] * e[0]};
  std::copy(e, e + 3, frame.e), std::copy(f, f + 3, frame.f);

  std::vector<double> times;
  double x[5];
  for (int run = 0; run < atoi(argv[3]); run++) {
    const auto begin = std::chrono::steady_clock::now();
    if (circle) x[0] = start[0], x[1] = start[1], x[2] = start[6];
    else if (sphere) x[0] = start[0], x[1] = start[1], x[2] = start[2], x[3] = start[6];
    else x[0] = x[1] = x[2] = x[3] = 0, x[4] = start[6];
    ceres::Problem problem;
    for (size_t i = 0; i < count; i++) {
      const double* p = &points[width * i];
      ceres::CostFunction* cost;
      if (circle) cost = new ceres::AutoDiffCostFunction<Circle, 1, 3>(new Circle{p});
      else if (sphere) cost = new ceres::AutoDiffCostFunction<Ball, 1, 4>(new Ball{p});
      else cost = new ceres::AutoDiffCostFunction<Tube, 1, 5>(new Tube{p, &frame});
      problem.AddResidualBlock(cost, nullptr, x);
    }
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
    options.num_threads = 1;
    options.logging_type = ceres::SILENT;
    options.function_tolerance = 1e-15;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    if (!summary.IsSolutionUsable()) return 1;
    times.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  std::sort(times.begin(), times.end());
  printf("%.9g", times[times.size() / 2]);
  if (circle) printf(" %.15g %.15g %.15g\n", x[0], x[1], x[2]);
  else if (sphere) printf(" %.15g %.15g %.15g %.15g\n", x[0], x[1], x[2], x[3]);
  else {
    double axis[3], n = std::sqrt(1 + x[2] * x[2] + x[3] * x[3]);
    for (int i = 0; i < 3; i++) axis[i] = (d[i] + x[2] * e[i] + x[3] * f[i]) / n;
    printf(" %.15g %.15g %.15g %.15g\n", axis[0], axis[1], axis[2], x[4]);
  }
}
