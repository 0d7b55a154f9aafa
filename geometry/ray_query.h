#pragma once
/// Rays against triangles: the one door to Embree (3 or 4), in its robust mode. Triangles are transformed in double and
/// rounded to float once, in a query space that the caller chooses: its origin should lie near what is looked at, so
/// that geometry far from the world's origin loses nothing.
///
/// The answers are Embree's: near an edge, or where two triangles are within a float's rounding of each other, they
/// may differ from exact ones and from processor to processor. No query leaves a trace in the caller's floating-point
/// state: it runs in the default one (Embree's worker threads may set FTZ and DAZ), and puts the caller's back.

#include <cstdint>
#include <functional>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace lode::geometry {

/// Which side of a triangle no ray meets. Front: counter-clockwise as seen from the ray's origin, in query space.
enum class RayCull : std::uint8_t { none, back, front };

/// One mesh in one place; borrowed while the scene is built.
struct RayInstance {
  std::span<const glm::vec3> positions;    ///< [n], object space; beyond ±10^18 in query space unseen
  std::span<const std::uint32_t> indices;  ///< [3 · triangles], each < n
  glm::dmat4 query_from_object{1.0};       ///< affine
  RayCull cull = RayCull::none;
  std::uint32_t mask = 1;  ///< a ray meets it if the two masks share a bit
};

/// Points origin + t·direction with t_near ≤ t ≤ t_far; direction of any length. t_near ≥ 0, coordinates within ±10^18:
/// a ray that is none of that, or whose t_far is below t_near, hits nothing.
struct Ray {
  glm::vec3 origin{0.0f};
  glm::vec3 direction{0.0f, 0.0f, -1.0f};
  float t_near = 0.0f;
  float t_far = std::numeric_limits<float>::infinity();
  std::uint32_t mask = 0xFFFFFFFFu;
};

/// Where a ray meets a triangle: the point (1 − u − v)·a + u·b + v·c of its corners.
struct RayHit {
  std::uint32_t instance = 0;
  std::uint32_t primitive = 0;  ///< triangle of the instance
  float t = 0.0f;
  float u = 0.0f;
  float v = 0.0f;
};

class RayScene {
 public:
  /// Builds the tree over all instances, on all processors (Embree limits threads for the whole process or not at all).
  /// `progress`, if given, is called with 0…1 from time to time, from any thread, one call at a time.
  /// Throws Error (machine) if Embree fails or runs out of memory.
  explicit RayScene(std::span<const RayInstance> instances, const std::function<void(double)>& progress = {});
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  /// The nearest hit; nothing where there is none. Of several at the same t any one. Thread-safe, as all queries are.
  [[nodiscard]] std::optional<RayHit> nearest(const Ray& ray) const;

  /// Every hit, into `hits`: by t, then instance, then primitive.
  void all(const Ray& ray, std::vector<RayHit>& hits) const;

  /// Whether there is any hit.
  [[nodiscard]] bool occluded(const Ray& ray) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

}  // namespace lode::geometry
