#include "raster/clusters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "raster/parallel.h"

namespace lode::raster {
namespace {

constexpr int kBins = 16;
constexpr std::size_t kParallelBelow = 1 << 15;  // triangles of a subtree that is one task

struct Box {
  glm::vec3 low{std::numeric_limits<float>::infinity()}, high{-std::numeric_limits<float>::infinity()};
  void add(const glm::vec3& p) { low = glm::min(low, p), high = glm::max(high, p); }
  void add(const Box& b) { low = glm::min(low, b.low), high = glm::max(high, b.high); }
  [[nodiscard]] float half_area() const {
    const glm::vec3 d = high - low;
    return d.x * d.y + d.y * d.z + d.z * d.x;
  }
};

Box everything() {
  Box box;
  std::swap(box.low, box.high);
  return box;
}

bool finite(const glm::vec3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

/// A triangle on its way into the tree.
struct Item {
  Box box;
  std::uint32_t primitive;
  [[nodiscard]] glm::vec3 centre() const { return 0.5f * box.low + 0.5f * box.high; }
};

class Builder {
 public:
  Builder(std::span<const glm::vec3> positions, std::optional<std::span<const std::uint32_t>> indices)
      : positions_(positions), indices_(indices) {}

  [[nodiscard]] std::uint32_t vertex(std::size_t corner) const {
    return indices_ ? (*indices_)[corner] : std::uint32_t(corner);
  }
  [[nodiscard]] std::size_t n_triangles() const { return (indices_ ? indices_->size() : positions_.size()) / 3; }

  Clusters build(int threads) {
    const std::size_t n = n_triangles();
    items_.resize(n);
    const int workers = worker_count(threads);
    const std::size_t n_chunks = (n + 65535) / 65536;
    parallel_for(n_chunks, workers, [&](std::size_t c, int) {
      for (std::size_t t = c * 65536; t < std::min(n, (c + 1) * 65536); ++t) {
        items_[t].primitive = std::uint32_t(t);
        for (std::size_t k = 0; k < 3; ++k) {
          const glm::vec3& p = positions_[vertex(3 * t + k)];
          if (finite(p)) {
            items_[t].box.add(p);
          } else {
            items_[t].box = everything();  // never skipped, never taken for unclipped
            break;
          }
        }
      }
    });
    // The upper part of the tree, down to ranges that are a task each; then the tasks; then their trees are put in
    // place.
    std::vector<Range> tasks;
    Clusters all;
    if (n > 0) {
      all.nodes.emplace_back();
      split_upper(all, 0, {0, n}, tasks);
    }
    std::vector<Clusters> parts(tasks.size());
    parallel_for(tasks.size(), workers, [&](std::size_t i, int) {
      parts[i].nodes.emplace_back();
      split(parts[i], 0, tasks[i]);
    });
    for (std::size_t i = 0; i < parts.size(); ++i) append(all, tasks[i].node, parts[i]);
    all.corners.resize(all.corners.size() + 1);  // three bytes are read as four
    all.n_positions = positions_.size();
    all.n_primitives = n;
    return all;
  }

 private:
  struct Range {
    std::size_t first, end;
    std::uint32_t node = 0;
  };

  Box box_of(const Range& r) const {
    Box box;
    for (std::size_t i = r.first; i < r.end; ++i) box.add(items_[i].box);
    return box;
  }

  static void set_box(ClusterNode& node, const Box& box) { node.low = box.low, node.high = box.high; }

  void split_upper(Clusters& out, std::uint32_t node, Range r, std::vector<Range>& tasks) {
    set_box(out.nodes[node], box_of(r));
    if (r.end - r.first <= kParallelBelow) {
      r.node = node;
      tasks.push_back(r);
      return;
    }
    const std::size_t middle = partition(r);
    const auto first = std::uint32_t(out.nodes.size());
    out.nodes[node].first = first;
    out.nodes.resize(first + 2);
    split_upper(out, first, {r.first, middle}, tasks);
    split_upper(out, first + 1, {middle, r.end}, tasks);
  }

  void split(Clusters& out, std::uint32_t node, Range r) {
    set_box(out.nodes[node], box_of(r));
    if (r.end - r.first <= std::size_t(kMaxClusterTriangles) && add_cluster(out, node, r)) return;
    const std::size_t middle = partition(r);
    const auto first = std::uint32_t(out.nodes.size());
    out.nodes[node].first = first;
    out.nodes.resize(first + 2);
    split(out, first, {r.first, middle});
    split(out, first + 1, {middle, r.end});
  }

  /// Where the binned surface area heuristic splits the range, which it reorders; the middle where it has no opinion.
  std::size_t partition(const Range& r) {
    Box centres;
    for (std::size_t i = r.first; i < r.end; ++i) centres.add(items_[i].centre());
    const glm::vec3 extent = centres.high - centres.low;
    float best_cost = std::numeric_limits<float>::infinity();
    int best_axis = -1, best_bin = 0;
    for (int axis = 0; axis < 3; ++axis) {
      if (!(extent[axis] > 0.0f) || !std::isfinite(extent[axis])) continue;
      std::array<Box, kBins> boxes;
      std::array<std::size_t, kBins> counts{};
      for (std::size_t i = r.first; i < r.end; ++i) {
        const int b = bin_of(items_[i], axis, centres);
        boxes[std::size_t(b)].add(items_[i].box);
        ++counts[std::size_t(b)];
      }
      std::array<float, kBins> right_cost{};
      Box right;
      std::size_t n_right = 0;
      for (int b = kBins - 1; b > 0; --b) {
        right.add(boxes[std::size_t(b)]);
        n_right += counts[std::size_t(b)];
        right_cost[std::size_t(b)] = n_right == 0 ? 0.0f : right.half_area() * float(n_right);
      }
      Box left;
      std::size_t n_left = 0;
      for (int b = 0; b + 1 < kBins; ++b) {
        left.add(boxes[std::size_t(b)]);
        n_left += counts[std::size_t(b)];
        if (n_left == 0 || n_left == r.end - r.first) continue;
        const float cost = left.half_area() * float(n_left) + right_cost[std::size_t(b) + 1];
        if (cost < best_cost) best_cost = cost, best_axis = axis, best_bin = b;
      }
    }
    const auto begin = items_.begin() + std::ptrdiff_t(r.first), end = items_.begin() + std::ptrdiff_t(r.end);
    if (best_axis < 0) return r.first + (r.end - r.first) / 2;
    const auto middle = std::stable_partition(
        begin, end, [&](const Item& item) { return bin_of(item, best_axis, centres) <= best_bin; });
    return std::size_t(middle - items_.begin());
  }

  static int bin_of(const Item& item, int axis, const Box& centres) {
    const float scale = float(kBins) / (centres.high[axis] - centres.low[axis]);
    const float bin = (item.centre()[axis] - centres.low[axis]) * scale;
    return bin >= float(kBins) ? kBins - 1 : (bin > 0.0f ? int(bin) : 0);  // NaN is 0
  }

  /// Makes the range a cluster under the node, if it has not too many vertices.
  bool add_cluster(Clusters& out, std::uint32_t node, const Range& r) {
    std::array<std::uint32_t, 3 * kMaxClusterTriangles> wanted, unique;
    const std::size_t n = r.end - r.first;
    for (std::size_t t = 0; t < n; ++t) {
      for (std::size_t k = 0; k < 3; ++k)
        wanted[3 * t + k] = vertex(3 * std::size_t(items_[r.first + t].primitive) + k);
    }
    std::copy_n(wanted.begin(), 3 * n, unique.begin());
    std::sort(unique.begin(), unique.begin() + std::ptrdiff_t(3 * n));
    const auto unique_end = std::unique(unique.begin(), unique.begin() + std::ptrdiff_t(3 * n));
    const auto n_vertices = std::size_t(unique_end - unique.begin());
    if (n_vertices > std::size_t(kMaxClusterVertices)) return false;

    Cluster cluster;
    cluster.first_vertex = std::uint32_t(out.vertices.size());
    cluster.first_triangle = std::uint32_t(out.primitives.size());
    cluster.n_vertices = std::uint16_t(n_vertices);
    cluster.n_triangles = std::uint16_t(n);
    const std::size_t padded = (n_vertices + kClusterPadding - 1) / kClusterPadding * kClusterPadding;
    for (std::size_t i = 0; i < padded; ++i) {
      const std::uint32_t v = unique[std::min(i, n_vertices - 1)];
      out.vertices.push_back(v);
      out.x.push_back(positions_[v].x), out.y.push_back(positions_[v].y), out.z.push_back(positions_[v].z);
    }
    for (std::size_t k = 0; k < 3 * n; ++k) {
      out.corners.push_back(std::uint8_t(std::lower_bound(unique.begin(), unique_end, wanted[k]) - unique.begin()));
    }
    for (std::size_t t = 0; t < n; ++t) out.primitives.push_back(items_[r.first + t].primitive);
    set_cone(cluster, {wanted.data(), 3 * n});
    out.nodes[node].leaf = true;
    out.nodes[node].first = std::uint32_t(out.clusters.size());
    out.clusters.push_back(cluster);
    return true;
  }

  /// The mean normal and the farthest from it. A triangle without area faces nowhere and does not count.
  void set_cone(Cluster& cluster, std::span<const std::uint32_t> corners) const {
    std::array<glm::dvec3, kMaxClusterTriangles> normals;
    std::size_t n = 0;
    glm::dvec3 sum(0.0);
    for (std::size_t k = 0; k < corners.size(); k += 3) {
      const glm::dvec3 a(positions_[corners[k]]), b(positions_[corners[k + 1]]), c(positions_[corners[k + 2]]);
      const glm::dvec3 normal = glm::cross(b - a, c - a);
      const double length = std::sqrt(glm::dot(normal, normal));
      if (!(length > 0.0)) continue;
      normals[n++] = normal / length;
      sum += normals[n - 1];
    }
    const double length = std::sqrt(glm::dot(sum, sum));
    if (!(length > 0.0) || !std::isfinite(length)) return;
    cluster.cone_axis = glm::vec3(sum / length);
    double least = 1.0;
    for (std::size_t i = 0; i < n; ++i) least = std::min(least, glm::dot(normals[i], glm::dvec3(cluster.cone_axis)));
    cluster.cone_cos = float(least) - 1e-5f;  // rounded down, whatever rounding there was
  }

  /// Puts a task's tree where its root stands; its other nodes, clusters and vertices go to the ends.
  static void append(Clusters& all, std::uint32_t root, const Clusters& part) {
    const auto node_base = std::uint32_t(all.nodes.size()) - 1;  // the part's node 0 is the root here
    const auto cluster_base = std::uint32_t(all.clusters.size());
    for (std::size_t i = 0; i < part.nodes.size(); ++i) {
      ClusterNode node = part.nodes[i];
      node.first += node.leaf ? cluster_base : node_base;
      if (i == 0) {
        all.nodes[root] = node;
      } else {
        all.nodes.push_back(node);
      }
    }
    for (Cluster cluster : part.clusters) {
      cluster.first_vertex += std::uint32_t(all.vertices.size());
      cluster.first_triangle += std::uint32_t(all.primitives.size());
      all.clusters.push_back(cluster);
    }
    const auto extend = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    extend(all.x, part.x), extend(all.y, part.y), extend(all.z, part.z);
    extend(all.vertices, part.vertices);
    extend(all.corners, part.corners);
    extend(all.primitives, part.primitives);
  }

  std::span<const glm::vec3> positions_;
  std::optional<std::span<const std::uint32_t>> indices_;
  std::vector<Item> items_;
};

}  // namespace

Clusters make_clusters(std::span<const glm::vec3> positions, std::optional<std::span<const std::uint32_t>> indices,
                       int threads) {
  return Builder(positions, indices).build(threads);
}

}  // namespace lode::raster
