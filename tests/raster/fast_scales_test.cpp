// Objects whose coordinates are huge or tiny, in worlds that are the opposite: what the fast pipeline concludes of
// whole clusters must not rest on numbers that have overflowed or lost their digits.
#include <gtest/gtest.h>

#include "fast_difference.h"
#include "random_meshes.h"

namespace lode::raster::test {
namespace {

/// An eighth of a ball of 8 × 8 quadrilaterals, so that it is a cluster whose triangles all may face away; outside in
/// or inside out.
OwnedDraw eighth_of_ball(double radius, std::uint32_t eighth, bool inside_out) {
  OwnedDraw draw;
  for (int k = 0; k < 81; ++k) {
    const double up = kPi * (k / 9) / 8.0, around = 2.0 * kPi * (k % 9) / 8.0;
    draw.object.push_back(
        glm::vec3(radius * glm::dvec3(std::sin(up) * std::cos(around), std::cos(up), std::sin(up) * std::sin(around))));
  }
  for (std::uint32_t c = 0; c < 8; ++c) {
    const std::uint32_t a = (eighth / 4 * 4 + c / 2) * 9 + eighth % 4 * 2 + c % 2, b = a + 1, below = a + 9;
    for (const std::uint32_t v : {a, b, below, b, below + 1, below}) draw.indices.push_back(v);
    if (!inside_out) continue;
    std::swap(draw.indices[draw.indices.size() - 6], draw.indices[draw.indices.size() - 5]);
    std::swap(draw.indices[draw.indices.size() - 3], draw.indices[draw.indices.size() - 2]);
  }
  draw.indexed = draw.clustered = true;
  draw.draw.cull = Cull::back;
  return draw;
}

/// Seen from a distance in radii of the world, through a lens that shows just the ball.
glm::dmat4 clip_from_ball(double world_radius, double object_radius, double turn_rad, double distance) {
  glm::dmat4 world_from_object(world_radius / object_radius), lens(distance);
  world_from_object[3][3] = lens[2][2] = lens[3][3] = 1.0;
  const double eye = distance * world_radius;
  return lens *
         perspective_from({eye * std::sin(turn_rad), 0.3 * world_radius, eye * std::cos(turn_rad)}, turn_rad,
                          0.1 * world_radius) *
         world_from_object;
}

TEST(FastScales, AreThoseOfTheReferenceFromTheSmallestToTheLargest) {
  for (const double object : {1e-36, 1.0, 1e27, 1e38}) {
    for (const double world : {1e-38, 1e-36, 1e-34, 1e-30, 1.0, 1e30}) {
      for (int view = 0; view < 6; ++view) {
        OwnedFrame frame;
        frame.size_px = {60, 60};
        for (std::uint32_t part = 0; part < 16; ++part) {
          auto draw = std::make_shared<OwnedDraw>(eighth_of_ball(object, part / 2, part % 2 != 0));
          draw->clip_from_object = clip_from_ball(world, object, 0.2 + 1.1 * view, view % 2 == 0 ? 20.0 : 1.5);
          draw->bind();
          frame.draws.push_back(draw);
        }
        Image image = frame.image();
        const FrameStats stats = frame.render(image, {.threads = 1});
        EXPECT_GT(stats.fragments_covered, 500u) << object << " in " << world << ", view " << view;
        EXPECT_EQ(difference_of(frame, {.threads = 1}), "") << object << " in " << world << ", view " << view;
      }
    }
  }
}

// A cluster's least normal is kept as a float: where it is larger than any, it is not infinite (infinity would face
// away whatever the rounding of the determinant), and where it is smaller than most, it is not rounded up.
TEST(FastScales, OfNormalsAreNeverAboveTheTruth) {
  for (const double size : {1e-23, 1e-22, 1.0, 1e19, 1e27, 1e30}) {
    const auto s = float(size);
    const std::vector<glm::vec3> p = {{0, 0, 0}, {s, 0, 0}, {0, s, 0}};
    const Clusters clusters = make_clusters(p, std::nullopt);
    const double truth = double(s) * double(s);
    EXPECT_LE(double(clusters.groups[0].least_normal[0]), truth) << size;
    EXPECT_TRUE(std::isfinite(clusters.groups[0].least_normal[0])) << size;
  }
}

}  // namespace
}  // namespace lode::raster::test
