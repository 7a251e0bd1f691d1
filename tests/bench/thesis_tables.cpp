#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "lib/penetration/turned_axes.h"
#include "tests/bench/penetration/cell_search.h"
#include "tests/bench/thesis_scenes.h"

// Prints tables 6.a, 6.b and 6.c of the thesis beside the values of 2001, the fit of its time formula (5.4),
// and the haptic measure: the 99.9th percentile on a standing part of a million triangles.

namespace gouge::bench {
namespace {

/// Processor time of this thread: what else the machine does is not counted.
double now_us() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e6 * static_cast<double>(time.tv_sec) + 1e-3 * static_cast<double>(time.tv_nsec);
}

struct Sample {
  double time_us = 0;
  PenetrationCounters counters;
  std::size_t inside = 0;
};

/// Every pose once to warm up, then `rounds` times; the rotation changes with every query.
template <class Finder>
std::vector<Sample> measure(Finder& finder, const std::vector<RigidTransform>& poses, int rounds) {
  for (const RigidTransform& pose : poses) finder.find(pose);
  std::vector<Sample> samples;
  for (int r = 0; r < rounds; ++r) {
    for (const RigidTransform& pose : poses) {
      const double start = now_us();
      const PenetrationResult& result = finder.find(pose);
      samples.push_back({now_us() - start, result.counters, result.contacts.size()});
    }
  }
  return samples;
}

template <class Value>
auto share(const std::vector<Sample>& samples, double part, Value value) {
  std::vector<decltype(value(samples[0]))> all;
  for (const Sample& s : samples) all.push_back(value(s));
  std::sort(all.begin(), all.end());
  return all[std::min(all.size() - 1, static_cast<std::size_t>(part * static_cast<double>(all.size())))];
}

double time_share(const std::vector<Sample>& samples, double part) {
  return share(samples, part, [](const Sample& s) { return s.time_us; });
}

PointBody moving_body(std::size_t width, bool is_cost_weighed, const DirectionSet& directions) {
  PointBodyOptions options;
  options.directions = directions;
  options.width = width;
  options.is_cost_weighed = is_cost_weighed;
  return build_point_body(make_moving_points(), options);
}

DepthBody standing_body(std::size_t width, IndexedMesh mesh, std::size_t leaf_triangles = 1) {
  DepthBodyOptions options;
  options.depth_mm = kSceneDepth_mm;
  options.width = width;
  options.leaf_triangles = leaf_triangles;
  return build_depth_body(Surface(std::move(mesh)), options);
}

enum class BroadPhase { cells, trees };

void print_6a(const CellBody& cells, const PointBody& points, BroadPhase broad) {
  const DepthBody& body = cells.body;
  const double thesis_ms[3][2] = {{10, 14}, {6, 9}, {3, 4}};
  std::printf("Table 6.a  by %s: %zu triangles, %zu points, k = 26, leaves of 1 triangle and at most %zu points\n",
              broad == BroadPhase::trees ? "trees" : "cells", body.mesh().triangles.size(), points.points.size(),
              points.options.leaf_points);
  std::printf("%-16s %-10s %-12s | %-10s %-22s %-10s\n", "", "points", "2001 (ms)", "points", "now, us: 5%  50%  95%",
              "2001/now");
  std::size_t line = 0;
  for (const PoseRange& range : table_6a_ranges()) {
    const auto poses = find_poses(body, points, range, 200);
    CellSearch by_cells(cells, points);
    PenetrationFinder by_trees(body, points);
    const auto samples = broad == BroadPhase::cells ? measure(by_cells, poses, 50) : measure(by_trees, poses, 50);
    const auto inside = [](const Sample& s) { return s.inside; };
    const double middle = time_share(samples, 0.5);
    std::printf("%-16s %3zu-%-6zu %4.0f-%-7.0f | %3zu-%-6zu %8.2f %6.2f %6.2f  %.0f\n", range.name, range.least,
                range.most, thesis_ms[line][0], thesis_ms[line][1], share(samples, 0, inside),
                share(samples, 1, inside), time_share(samples, 0.05), middle, time_share(samples, 0.95),
                500 * (thesis_ms[line][0] + thesis_ms[line][1]) / middle);
    ++line;
  }
}

void print_6b() {
  const std::size_t ks[4] = {6, 14, 18, 26};
  const double thesis_us[4][2] = {{55, 70}, {110, 130}, {135, 165}, {200, 220}};
  std::printf("\nTable 6.b  one volume from one orientation to another\n%-4s %-12s | %-9s %-8s\n", "k", "2001 (us)",
              "corners", "now (us)");
  for (std::size_t i = 0; i < 4; ++i) {
    const DirectionSet directions = cube_directions(ks[i]);
    const PointBody points = moving_body(2, true, directions);
    TurnedAxes axes(directions);
    std::vector<float> intervals(2 * points.tree.stride);
    constexpr int kRounds = 20000;
    double kept = 0;
    const double start = now_us();
    for (int r = 0; r < kRounds; ++r) {
      axes.turn(Eigen::AngleAxisd(1e-4 * r, Vec3::UnitX()).toRotationMatrix());
      axes.bound(points.corners.data(), points.corner_first[1], intervals.data());
      kept += static_cast<double>(intervals[0]);
    }
    const double each = (now_us() - start) / kRounds;
    std::printf("%-4zu %3.0f-%-8.0f | %-9u %.3f%s\n", ks[i], thesis_us[i][0], thesis_us[i][1], points.corner_count[0],
                each, kept > 1e300 ? "!" : "");
  }
}

void print_6c() {
  const char* thesis[3] = {"~860  29-32", "~700  25-28", "~400  12-15"};
  std::printf("\nTable 6.c  corners transformed, levels needed (moving + standing), overlap tests, time\n");
  std::printf("%-16s %-12s", "", "2001");
  for (const char* tree : {"2-tree", "4-tree", "8-tree"}) std::printf(" | %-26s", tree);
  for (const bool is_weighed : {false, true}) {
    std::printf("\n%s\n", is_weighed ? "a volume costs no more than its content (6.1.1)" : "a volume for every node");
    std::size_t line = 0;
    for (const PoseRange& range : table_6a_ranges()) {
      std::printf("%-16s %-12s", range.name, thesis[line++]);
      for (const std::size_t width : {2U, 4U, 8U}) {
        const DepthBody body = standing_body(width, make_standing_body());
        const PointBody points = moving_body(width, is_weighed, body.options.directions);
        PenetrationFinder finder(body, points);
        const auto samples = measure(finder, find_poses(body, points, range, 100), 5);
        const auto corners = share(samples, 0.5, [](const Sample& s) { return s.counters.corners_transformed; });
        const auto levels =
            share(samples, 0.5, [](const Sample& s) { return s.counters.static_level + s.counters.moving_level; });
        const auto pairs = share(samples, 0.5, [](const Sample& s) { return s.counters.volume_pairs; });
        std::printf(" | %4llu %3u %6llu %7.2f us", static_cast<unsigned long long>(corners), levels,
                    static_cast<unsigned long long>(pairs), time_share(samples, 0.5));
      }
      std::printf("\n");
    }
  }
}

/// Least squares of T = Nb tb + Nn tn + t0 over all scenes (thesis 5.4), Nn being the pairs whose distance is
/// computed. The correction's part grows with them and cannot be distinguished from tn.
void print_fit(const DepthBody& body, const PointBody& points) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double mean = 0, count = 0, square = 0;
  std::vector<std::pair<Eigen::Vector3d, double>> rows;
  for (const PoseRange& range : table_6a_ranges()) {
    PenetrationFinder finder(body, points);
    for (const Sample& s : measure(finder, find_poses(body, points, range, 200), 5)) {
      rows.emplace_back(
          Eigen::Vector3d(static_cast<double>(s.counters.volume_pairs), static_cast<double>(s.counters.exact_pairs), 1),
          s.time_us);
    }
  }
  for (const auto& [row, time] : rows) {
    normal += row * row.transpose();
    right += time * row;
    mean += time;
    count += 1;
  }
  const Eigen::Vector3d fit = normal.ldlt().solve(right);
  mean /= count;
  double miss = 0;
  for (const auto& [row, time] : rows) {
    miss += (time - row.dot(fit)) * (time - row.dot(fit));
    square += (time - mean) * (time - mean);
  }
  std::printf(
      "\nT = Nb tb + Nn tn + t0: tb = %.1f ns a volume pair, tn = %.1f ns a distance (with all that leads to it), t0 = "
      "%.2f us; explains %.0f %% of the variance\n",
      1e3 * fit[0], 1e3 * fit[1], fit[2], 100 * (1 - miss / square));
}

void print_haptic() {
  const double start = now_us();
  const DepthBody body = standing_body(8, make_standing_body(708, 708), 8);
  const CellBody cells(body);
  std::printf(
      "\nHaptic rate: %zu triangles, 8 a leaf (built in %.1f s), %zu points\n%-16s %-9s us: 50%%  99%%  99.9%%  "
      "worst\n",
      body.mesh().triangles.size(), (now_us() - start) / 1e6, make_moving_points().size(), "", "queries");
  const PointBody points = moving_body(2, true, body.options.directions);
  for (const PoseRange& range : table_6a_ranges()) {
    CellSearch finder(cells, points);
    const auto samples = measure(finder, find_poses(body, points, range, 200), 50);
    std::printf("%-16s %-9zu %8.1f %8.1f %8.1f %8.1f\n", range.name, samples.size(), time_share(samples, 0.5),
                time_share(samples, 0.99), time_share(samples, 0.999), time_share(samples, 1));
  }
}

}  // namespace
}  // namespace gouge::bench

int main(int count, char** words) {
  using namespace gouge;
  const std::string only = count > 1 ? words[1] : "";
  const DepthBody body = bench::standing_body(8, bench::make_standing_body());
  const PointBody points = bench::moving_body(2, true, body.options.directions);
  if (only.empty() || only == "6a") {
    const CellBody cells(body);
    bench::print_6a(cells, points, bench::BroadPhase::cells);
    bench::print_6a(cells, points, bench::BroadPhase::trees);
  }
  if (only.empty() || only == "6b") bench::print_6b();
  if (only.empty() || only == "6c") bench::print_6c();
  if (only.empty() || only == "fit") bench::print_fit(body, points);
  if (only.empty() || only == "haptic") bench::print_haptic();
  return 0;
}
