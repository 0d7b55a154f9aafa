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
constexpr float kStackedShare = 0.4f;            // of the common box's area, in the mean
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

/// A node of the binary tree: children are nodes `first` and `first + 1`, or `first` is a cluster.
struct Node {
  Box box;
  std::uint32_t first = 0;
  bool leaf = false;
};

/// Directions about an axis.
struct Cone {
  glm::vec3 axis{0.0f, 0.0f, 1.0f};
  float cos = -1.0f;  ///< ≤ 0: no use
  float least_normal = 0.0f;
};

/// A part of the binary tree with what its leaves hold.
struct Part {
  std::vector<Node> nodes;
  std::vector<Cone> cones;  ///< [clusters]
  Clusters out;
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
    Part all;
    if (n > 0) {
      all.nodes.emplace_back();
      split_upper(all, 0, {0, n}, tasks);
    }
    std::vector<Part> parts(tasks.size());
    parallel_for(tasks.size(), workers, [&](std::size_t i, int) {
      parts[i].nodes.emplace_back();
      split(parts[i], 0, tasks[i]);
    });
    for (std::size_t i = 0; i < parts.size(); ++i) append(all, tasks[i].node, parts[i]);
    if (n > 0) fold(all);
    all.out.corners.resize(all.out.corners.size() + 1);  // three bytes are read as four
    all.out.n_positions = positions_.size();
    all.out.n_primitives = n;
    return std::move(all.out);
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

  void split_upper(Part& out, std::uint32_t node, Range r, std::vector<Range>& tasks) {
    out.nodes[node].box = box_of(r);
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

  void split(Part& out, std::uint32_t node, Range r) {
    out.nodes[node].box = box_of(r);
    const std::size_t n = r.end - r.first;
    if (n <= std::size_t(kMaxClusterTriangles) && (n == 1 || !stacked(out.nodes[node].box, r)) &&
        add_cluster(out, node, r)) {
      return;
    }
    const std::size_t middle = partition(r);
    const auto first = std::uint32_t(out.nodes.size());
    out.nodes[node].first = first;
    out.nodes.resize(first + 2);
    split(out, first, {r.first, middle});
    split(out, first + 1, {middle, r.end});
  }

  /// Triangles that are nearly as large as their common box: apart, they can be drawn front to back.
  [[nodiscard]] bool stacked(const Box& box, const Range& r) const {
    float sum = 0.0f;
    for (std::size_t i = r.first; i < r.end; ++i) sum += items_[i].box.half_area();
    return sum > kStackedShare * box.half_area() * float(r.end - r.first);
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
  bool add_cluster(Part& part, std::uint32_t node, const Range& r) {
    Clusters& out = part.out;
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
    part.cones.push_back(cone_of({wanted.data(), 3 * n}));
    part.nodes[node].leaf = true;
    part.nodes[node].first = std::uint32_t(out.clusters.size());
    out.clusters.push_back(cluster);
    return true;
  }

  /// The greatest float that is not above x ≥ 0.
  static float float_below(double x) {
    const auto nearest = float(std::min(x, double(std::numeric_limits<float>::max())));
    return double(nearest) > x ? std::nextafter(nearest, 0.0f) : nearest;
  }

  /// The mean normal and the farthest from it. A triangle two of whose corners are the same never has a sample, and
  /// does not count; one whose corners lie on a line may get one from rounding, and faces anywhere.
  [[nodiscard]] Cone cone_of(std::span<const std::uint32_t> corners) const {
    std::array<glm::dvec3, kMaxClusterTriangles> normals;
    std::size_t n = 0;
    glm::dvec3 sum(0.0);
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < corners.size(); k += 3) {
      const glm::dvec3 a(positions_[corners[k]]), b(positions_[corners[k + 1]]), c(positions_[corners[k + 2]]);
      if (a == b || b == c || c == a) continue;
      const glm::dvec3 normal = glm::cross(b - a, c - a);
      const double length = std::sqrt(glm::dot(normal, normal));
      if (!(length > 0.0) || !std::isfinite(length)) return {};
      shortest = std::min(shortest, length);
      normals[n++] = normal / length;
      sum += normals[n - 1];
    }
    const double length = std::sqrt(glm::dot(sum, sum));
    if (!(length > 0.0)) return {};
    Cone cone{glm::vec3(sum / length), 1.0f, float_below(0.999 * shortest)};
    double least = 1.0;
    for (std::size_t i = 0; i < n; ++i) least = std::min(least, glm::dot(normals[i], glm::dvec3(cone.axis)));
    cone.cos = float(least) - 1e-5f;  // rounded down, whatever rounding there was
    return cone;
  }

  /// Puts a task's tree where its root stands; its other nodes, clusters and vertices go to the ends.
  static void append(Part& all, std::uint32_t root, const Part& part) {
    const auto node_base = std::uint32_t(all.nodes.size()) - 1;  // the part's node 0 is the root here
    const auto cluster_base = std::uint32_t(all.out.clusters.size());
    for (std::size_t i = 0; i < part.nodes.size(); ++i) {
      Node node = part.nodes[i];
      node.first += node.leaf ? cluster_base : node_base;
      if (i == 0) {
        all.nodes[root] = node;
      } else {
        all.nodes.push_back(node);
      }
    }
    for (Cluster cluster : part.out.clusters) {
      cluster.first_vertex += std::uint32_t(all.out.vertices.size());
      cluster.first_triangle += std::uint32_t(all.out.primitives.size());
      all.out.clusters.push_back(cluster);
    }
    const auto extend = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    extend(all.cones, part.cones);
    extend(all.out.x, part.out.x), extend(all.out.y, part.out.y), extend(all.out.z, part.out.z);
    extend(all.out.vertices, part.out.vertices);
    extend(all.out.corners, part.out.corners);
    extend(all.out.primitives, part.out.primitives);
  }

  /// Folds the binary tree into groups: from a root, the largest box is opened until there are sixteen.
  static void fold(Part& part) {
    Clusters& out = part.out;
    out.low = part.nodes[0].box.low, out.high = part.nodes[0].box.high;
    std::vector<std::uint32_t> roots = {0};  // of the groups, in their order
    out.groups.emplace_back();
    for (std::size_t g = 0; g < roots.size(); ++g) {
      std::vector<std::uint32_t> open = {roots[g]};
      while (open.size() < std::size_t(ClusterGroup::kMost)) {
        const auto largest = std::max_element(open.begin(), open.end(), [&](std::uint32_t a, std::uint32_t b) {
          return openable(part.nodes[a]) < openable(part.nodes[b]);
        });
        const Node& node = part.nodes[*largest];
        if (node.leaf) break;
        *largest = node.first;
        open.push_back(node.first + 1);
      }
      ClusterGroup group{};
      for (const std::uint32_t n : open) {
        const Node& node = part.nodes[n];
        const Cone cone = node.leaf ? part.cones[node.first] : Cone{};
        for (int axis = 0; axis < 3; ++axis) {
          group.low[axis][group.n] = node.box.low[axis], group.high[axis][group.n] = node.box.high[axis];
          group.cone_axis[axis][group.n] = cone.axis[axis];
        }
        group.cone_cos[group.n] = cone.cos;
        group.least_normal[group.n] = cone.least_normal;
        group.child[group.n++] = node.leaf ? ClusterGroup::kIsCluster | node.first : std::uint32_t(roots.size());
        if (!node.leaf) roots.push_back(n);
      }
      out.groups.resize(roots.size());
      out.groups[g] = group;
    }
  }
  /// Which node to open first: inner ones by area, leaves never.
  static float openable(const Node& node) {
    const float area = node.box.half_area();
    return node.leaf ? -1.0f : (std::isfinite(area) ? area : std::numeric_limits<float>::max());
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
