#include "geometry/viewpoints.h"

#include <glm/vector_relational.hpp>
#include <string>

#include "geometry/camera_path.h"
#include "geometry/error.h"
#include "geometry/random.h"
#include "geometry/trigonometry.h"

namespace lode::geometry {
namespace {

constexpr double kClearance = 0.2;
constexpr std::uint32_t kPurpose = 0x76706f69;  // of the random numbers: "vpoi"

bool inside(const Bounds& box, const glm::dvec3& p, double margin) {
  return glm::all(glm::greaterThan(p, box.low - margin)) && glm::all(glm::lessThan(p, box.high + margin));
}

double volume(const Bounds& box) {
  const glm::dvec3 extent = box.high - box.low;
  return extent.x * extent.y * extent.z;
}

/// A place in one of the boxes, uniform over all of them.
struct Place {
  std::size_t box;
  glm::dvec3 p;
};
Place random_place(const std::vector<Bounds>& boxes, double total, Random& random) {
  double left = random.uniform() * total;
  std::size_t k = 0;
  while (k + 1 < boxes.size() && left >= volume(boxes[k])) left -= volume(boxes[k++]);
  const double x = random.uniform(), y = random.uniform(), z = random.uniform();
  return {k, boxes[k].low + (boxes[k].high - boxes[k].low) * glm::dvec3(x, y, z)};
}

bool is_free(const Place& place, const std::vector<Bounds>& free_space, const std::vector<Bounds>& objects) {
  const Bounds& room = free_space[place.box];
  for (const Bounds& object : objects) {
    const bool around = inside(object, room.low, 1e-9) && inside(object, room.high, 1e-9);
    if (!around && inside(object, place.p, kClearance)) return false;
  }
  return true;
}

}  // namespace

std::vector<Camera> random_viewpoints(const Scene& scene, std::uint64_t seed, int n) {
  const auto fail = [&](const std::string& message) {
    throw Error(ErrorKind::bad_input, scene.name + ": random viewpoints: " + message);
  };
  if (scene.free_space.empty()) fail("expected a scene that says where its free space is, found none");
  std::vector<Bounds> objects;
  for (const SceneObject& object : objects_of(scene)) objects.push_back(object_bounds(scene, object));
  double total = 0.0;
  for (const Bounds& box : scene.free_space) total += volume(box);

  std::vector<Camera> cameras;
  for (int k = 0; k < n; ++k) {
    Random random(seed, kPurpose, std::uint64_t(k));
    Place place = random_place(scene.free_space, total, random);
    for (int tries = 1; !is_free(place, scene.free_space, objects); ++tries) {
      if (tries == 1000) fail("expected free space, found none in 1000 tries");
      place = random_place(scene.free_space, total, random);
    }
    const SinCos yaw = sin_cos(random.uniform(0.0, 2.0 * kPi));
    const double rise = random.uniform(-0.25, 0.25);  // tan 14° = 0.249
    Camera camera = walking_camera();
    look_at(camera, place.p, place.p + glm::dvec3(yaw.sin, rise, yaw.cos));
    cameras.push_back(camera);
  }
  return cameras;
}

}  // namespace lode::geometry
