// Pictures of a hemisphere of directions, mixed (techniques/octahedral_impostors/README.md).
#include "techniques/octahedral_impostors/octahedral_impostors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "techniques/octahedral_impostors/hemi_octahedron.h"
#include "techniques/parallel_picture.h"
#include "tests/techniques/impostor_scenes.h"
#include "tests/techniques/technique_pictures.h"

namespace lode::tests {
namespace {

using techniques::direction_from_octahedral;
using techniques::grid_direction;
using techniques::grid_triangle;
using techniques::GridTriangle;
using techniques::octahedral_from_direction;
using techniques::OctahedralImpostors;
using techniques::View;
using techniques::ViewBlend;
using techniques::World;

constexpr techniques::FarRule kAnywhere{.radii = 0.0, .distance = 0.0};

/// The weight of every node of the grid, those of the triangle and 0 for the others.
std::map<std::pair<int, int>, double> weights(const glm::dvec3& direction, int n) {
  const GridTriangle triangle = grid_triangle(direction, n);
  std::map<std::pair<int, int>, double> of_node;
  for (std::size_t k = 0; k < 3; ++k) of_node[{triangle.nodes[k].x, triangle.nodes[k].y}] += triangle.weights[k];
  return of_node;
}

glm::dvec3 random_direction(std::uint64_t element) {
  geometry::Random random(11, 0, element);
  const double x = random.uniform(-1.0, 1.0), y = random.uniform(0.0, 1.0);
  return {x, y, random.uniform(-1.0, 1.0)};
}

/// By hand: up is the middle; +x = (1, 0) of the diamond is turned to (1, 1), +z = (0, 1) to (1, −1); halfway up
/// between up and +x the diamond has (½, 0), the square (½, ½).
TEST(HemiOctahedron, HasUpInTheMiddleAndTheHorizonAroundIt) {
  EXPECT_EQ(octahedral_from_direction({0, 3, 0}), glm::dvec2(0, 0));
  EXPECT_EQ(octahedral_from_direction({2, 0, 0}), glm::dvec2(1, 1));
  EXPECT_EQ(octahedral_from_direction({-2, 0, 0}), glm::dvec2(-1, -1));
  EXPECT_EQ(octahedral_from_direction({0, 0, 5}), glm::dvec2(1, -1));
  EXPECT_EQ(octahedral_from_direction({0, 0, -5}), glm::dvec2(-1, 1));
  EXPECT_EQ(octahedral_from_direction({1, 1, 0}), glm::dvec2(0.5, 0.5));
  EXPECT_EQ(octahedral_from_direction({1, 0, 1}), glm::dvec2(1, 0));
}

/// What is below the horizon is seen as from the horizon above it; where none is above it, as from above.
TEST(HemiOctahedron, TakesWhatIsBelowTheHorizonToTheHorizon) {
  EXPECT_EQ(octahedral_from_direction({3, -4, -1}), octahedral_from_direction({3, 0, -1}));
  EXPECT_EQ(octahedral_from_direction({0, -1, 0}), glm::dvec2(0, 0));
  EXPECT_EQ(octahedral_from_direction({0, 0, 0}), glm::dvec2(0, 0));
  EXPECT_EQ(direction_from_octahedral({3, -7}), direction_from_octahedral({1, -1}));
}

TEST(HemiOctahedron, ComesBackFromThereToTheSameDirection) {
  for (std::uint64_t k = 0; k < 10000; ++k) {
    const glm::dvec3 direction = glm::normalize(random_direction(k));
    const glm::dvec2 point = octahedral_from_direction(direction);
    EXPECT_LE(std::max(std::abs(point.x), std::abs(point.y)), 1.0);
    // A few roundings of numbers of at most 1, over lengths of at least 1/√3.
    ASSERT_LE(glm::distance(direction_from_octahedral(point), direction), 1e-15) << k;
  }
}

TEST(OctahedralGrid, GivesANodesOwnDirectionToThatNodeAlone) {
  for (const int n : {2, 3, 6, 7, 12, 32}) {
    for (int y = 0; y < n; ++y) {
      for (int x = 0; x < n; ++x) {
        const glm::dvec3 direction = grid_direction({x, y}, n);
        EXPECT_NEAR(glm::length(direction), 1.0, 1e-15);
        EXPECT_GE(direction.y, 0.0);
        EXPECT_EQ(direction.y == 0.0, x == 0 || y == 0 || x == n - 1 || y == n - 1);  // the horizon
        EXPECT_EQ((weights(direction, n)[{x, y}]), 1.0) << x << ' ' << y << " of " << n;
        EXPECT_EQ((weights(7.0 * direction, n)[{x, y}]), 1.0);
      }
    }
  }
  EXPECT_EQ(grid_direction({2, 2}, 5), glm::dvec3(0, 1, 0));  // odd grids have straight up
}

TEST(OctahedralGrid, HasWeightsThatSumToOneOnNodesThatAreThere) {
  for (const int n : {2, 3, 6, 32}) {
    for (std::uint64_t k = 0; k < 10000; ++k) {
      const GridTriangle triangle = grid_triangle(random_direction(k), n);
      ASSERT_EQ(triangle.weights[0] + triangle.weights[1] + triangle.weights[2], 1.0);
      for (std::size_t i = 0; i < 3; ++i) {
        ASSERT_GE(triangle.weights[i], 0.0);
        ASSERT_GE(std::min(triangle.nodes[i].x, triangle.nodes[i].y), 0);
        ASSERT_LT(std::max(triangle.nodes[i].x, triangle.nodes[i].y), n);
      }
    }
  }
}

/// Along 30 straight paths, every other one partly below the horizon. With s = |x| + |z| + max(y, 0) ≥ 0.4 on all of
/// them, x/s and z/s change by at most (1 + √3)/s per unit of the vector, a coordinate of the square by twice as much,
/// less than 14, a position by (n − 1)/2 of that, and a weight by at most the two coordinates together.
TEST(OctahedralGrid, HasWeightsThatVaryContinuously) {
  constexpr double kStep = 1e-3;
  for (const int n : {2, 6, 7}) {
    const double bound = 14.0 * (n - 1) * kStep + 0x1p-18;  // and what positions are rounded by
    for (std::uint64_t k = 0; k < 30; ++k) {
      const glm::dvec3 from = glm::normalize(random_direction(2 * k)), to = glm::normalize(random_direction(2 * k + 1));
      if (glm::dot(from, to) < -0.5) continue;  // the chord stays at least ½ from the origin
      const glm::dvec3 lower(0.0, 0.2 * double(k % 2), 0.0);
      const auto at = [&](double s) { return weights(glm::normalize(from + s * (to - from)) - lower, n); };
      auto before = at(0.0);
      for (double s = 0.25 * kStep; s < 1.0; s += 0.25 * kStep) {  // √3 · ¼ / ½ of a step, at most
        auto now = at(s);
        for (const auto& [node, weight] : std::map(now)) ASSERT_LE(std::abs(weight - before[node]), bound) << k;
        for (const auto& [node, weight] : std::map(before)) ASSERT_LE(std::abs(weight - now[node]), bound) << k;
        before = now;
      }
    }
  }
}

/// A parallel view along a node's direction, a pixel a texel, `distance` from the box's centre.
View along(const World& world, const glm::dvec3& direction, int texels) {
  const auto picture = techniques::parallel_picture(world.objects()[0].bounds, direction, texels);
  View view{.camera = picture->camera, .size_px = picture->size_px};
  view.camera.eye += 100.0 * view.camera.back;
  view.camera.near = 1.0, view.camera.far = 200.0;
  return view;
}

TEST(OctahedralImpostors, FromABakedDirectionInParallelHaveEveryPixelOfTheObject) {
  const geometry::Scene scene = lopsided_object();
  const World world(scene, {}, false);
  for (const ViewBlend blend : {ViewBlend::three, ViewBlend::nearest}) {
    for (const bool parallax : {false, true}) {
      Showing shown(world, OctahedralImpostors(
                               {.grid = 5, .texels = 60, .blend = blend, .parallax = parallax, .far = kAnywhere}));
      Showing plain(world, techniques::Plain{});
      for (int k = 0; k < 25; ++k) {
        const View view = along(world, grid_direction({k % 5, k / 5}, 5), 60);
        const TechniquePicture plates = shown.picture(view), whole = plain.picture(view);
        ASSERT_EQ(plates.count("shown"), 1u);
        EXPECT_EQ(plates.count("blended"), 1u);
        EXPECT_EQ(n_different(plates.image, whole.image), 0) << k << ' ' << parallax;
        EXPECT_EQ(ids_seen(plates.image), 1u);
      }
    }
  }
}

/// In perspective, at distance D along a baked direction, a point (a, b) beside the centre and z before it is seen at
/// f·(a, b)/(D − z). The plate is the plane through the centre, where it is shown at f·(a, b)/D; one step of parallax
/// reads it where it is, as far as its surface has the height z where the ray meets that plane.
TEST(OctahedralImpostors, FromABakedDirectionMoveAPointAsFarAsItsDistanceFromThePlateTells) {
  const geometry::Scene scene = lopsided_object();
  const World world(scene, {}, false);
  const double kDistance = 60.0, kFocal_px = 650.0;
  const geometry::Bounds& box = world.objects()[0].bounds;
  for (const bool parallax : {false, true}) {
    Showing shown(world, OctahedralImpostors({.grid = 5, .texels = 512, .parallax = parallax, .far = kAnywhere}));
    Showing plain(world, techniques::Plain{});
    for (const glm::ivec2 node : {glm::ivec2(4, 0), glm::ivec2(4, 1), glm::ivec2(3, 1), glm::ivec2(2, 2)}) {
      View view{.camera = {}, .size_px = {640, 480}};
      view.camera.tan_half_fov_y = 240.0 / kFocal_px;
      geometry::look_at(view.camera, box.centre() + kDistance * grid_direction(node, 5), box.centre());
      const auto now = knob_px(shown.picture(view).image), truly = knob_px(plain.picture(view).image);
      ASSERT_TRUE(now && truly);
      const glm::dvec3 knob = kKnob - box.centre();
      const glm::dvec2 beside(glm::dot(knob, view.camera.right), -glm::dot(knob, view.camera.up));
      const glm::dvec2 on_plate = kFocal_px * beside / kDistance;
      // Of a few pixels the middle; with parallax, those of the knob's rim are read beside it.
      EXPECT_LE(glm::length(*now - (parallax ? *truly : on_plate + glm::dvec2(319.5, 239.5))), 1.0)
          << node.x << ' ' << node.y << ' ' << parallax;
    }
  }
}

double squared_error(const raster::Image& a, const raster::Image& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.rgba32f.size(); ++i) {
    const glm::vec4 d = a.rgba32f[i] - b.rgba32f[i];
    sum += double(glm::dot(d, d));
  }
  return sum;
}

/// Between the grid's directions, over a walk around the object.
TEST(OctahedralImpostors, AreCloserToTheObjectWithParallaxAndOnAFinerGrid) {
  const geometry::Scene scene = lopsided_object();
  const World world(scene, {}, false);
  Showing plain(world, techniques::Plain{});
  const auto error = [&](int grid, ViewBlend blend, bool parallax) {
    Showing shown(world, OctahedralImpostors(
                             {.grid = grid, .texels = 128, .blend = blend, .parallax = parallax, .far = kAnywhere}));
    double sum = 0.0;
    for (int k = 0; k < 24; ++k) {
      const View view = view_from(around(15.0 * k + 4.0, 40.0, 2.0 + k), {0.0, 3.0, 0.0});
      sum += squared_error(shown.picture(view).image, plain.picture(view).image);
    }
    return sum;
  };
  const double with = error(10, ViewBlend::three, true);
  EXPECT_LT(with, error(10, ViewBlend::three, false));
  EXPECT_LT(error(10, ViewBlend::nearest, true), error(10, ViewBlend::nearest, false));
  EXPECT_LT(with, error(6, ViewBlend::three, true));
}

/// Every number of threads, and both pipelines, give the same bytes.
TEST(OctahedralImpostors, ShadeTheSameOnAnyNumberOfThreadsAndByBothPipelines) {
  const geometry::Scene scene = row_of_balls();
  const World world(scene, {}, false);
  const View view = view_from(around(37.0, 60.0, 20.0));
  std::vector<raster::Image> images;
  for (const int threads : {1, 2, 5}) {
    for (const raster::Pipeline pipeline : {raster::Pipeline::fast, raster::Pipeline::reference}) {
      const raster::RenderOptions options{.threads = threads, .pipeline = pipeline};
      techniques::Stage stage(world, options);
      OctahedralImpostors technique({.texels = 32});
      technique.prepare(stage);
      stage.begin(view);
      static_cast<void>(technique.draw(view, stage));
      raster::Image& image = images.emplace_back(raster::make_image(view.size_px, raster::ColorFormat::rgba32f));
      raster::render({.draws = stage.draws(), .clear = {}, .viewport = {}, .scissor = {}}, image, options);
      EXPECT_EQ(raster::test::first_difference(image, images[0]), "") << threads;
    }
  }
  EXPECT_EQ(ids_seen(images[0]), 5u);
}

TEST(OctahedralImpostors, LeaveWhatFindsNoRoomAsItIs) {
  const geometry::Scene scene = row_of_balls();
  const World world(scene, {}, false);
  const View view = view_from(around(0.0, 60.0));
  Showing all(world, OctahedralImpostors({.grid = 3, .texels = 16}));
  const std::uint64_t each = all.picture(view).count("picture_bytes") / 5;
  Showing two(world, OctahedralImpostors({.grid = 3, .texels = 16, .most_bytes = 2 * each}));
  const TechniquePicture picture = two.picture(view);
  EXPECT_EQ(picture.count("shown"), 2u);
  EXPECT_EQ(picture.count("unfit"), 3u);
  EXPECT_EQ(picture.count("picture_bytes"), 2 * each);
}

TEST(OctahedralImpostors, CountEveryByteOfTheirPictures) {
  const geometry::Scene scene = row_of_balls();
  const World world(scene, {}, false);
  for (const int texels : {1, 7, 32}) {
    techniques::Stage stage(world);
    OctahedralImpostors technique({.grid = 3, .texels = texels});
    technique.prepare(stage);
    const View view = view_from(around(0.0, 60.0));
    stage.begin(view);
    const techniques::Counters counters = technique.draw(view, stage);
    EXPECT_EQ(std::string(counters.back().name), "picture_bytes");
    EXPECT_EQ(counters.back().value, stage.picture_bytes()) << texels;
    EXPECT_EQ(stage.work().captures, 0u);  // all were taken before
    EXPECT_GE(counters.back().value, 5u * 9u * std::uint64_t(texels * texels) * 20u / 2u);
  }
}

TEST(OctahedralImpostors, ShowSomethingOfEveryObjectWithOneTexel) {
  const geometry::Scene scene = row_of_balls();
  const World world(scene, {}, false);
  Showing shown(world, OctahedralImpostors({.grid = 2, .texels = 1}));
  const TechniquePicture picture = shown.picture(view_from(around(0.0, 60.0)));
  EXPECT_EQ(picture.count("shown"), 5u);
  EXPECT_EQ(ids_seen(picture.image), 5u);
}

/// A ball looks alike from everywhere, but for a texel, 1/36 of its radius, at the rim.
TEST(OctahedralImpostors, ShowObjectsFromStraightAboveAndFromALittleBelow) {
  const geometry::Scene scene = row_of_balls();
  const World world(scene, {}, false);
  Showing shown(world, OctahedralImpostors());
  Showing plain(world, techniques::Plain{});
  for (const glm::dvec3& eye :
       {glm::dvec3(0, 70, 0), glm::dvec3(30, 60, 10), glm::dvec3(0, 0, 70), glm::dvec3(0, -15, 60)}) {
    const View view = view_from(eye);
    const TechniquePicture plates = shown.picture(view), whole = plain.picture(view);
    EXPECT_EQ(plates.count("shown"), 5u);
    int n_whole = 0, n_other = 0;
    for (std::size_t i = 0; i < whole.image.ids.size(); ++i) {
      n_whole += whole.image.ids[i].draw != raster::kNoId ? 1 : 0;
      n_other += whole.image.ids[i].draw != plates.image.ids[i].draw ? 1 : 0;
    }
    EXPECT_LE(n_other, n_whole / 10) << eye.y;
  }
}

/// No picture was taken from there.
TEST(OctahedralImpostors, DrawWhatIsSeenFromFarBelow) {
  const geometry::Scene scene = row_of_balls();
  const World world(scene, {}, false);
  Showing shown(world, OctahedralImpostors({.grid = 3, .texels = 16}));
  Showing plain(world, techniques::Plain{});
  for (const glm::dvec3& eye : {glm::dvec3(0, -70, 0), glm::dvec3(10, -50, 40)}) {
    const TechniquePicture picture = shown.picture(view_from(eye));
    EXPECT_EQ(picture.count("unfit"), 5u);
    EXPECT_EQ(difference_from_plain(picture, plain.picture(view_from(eye))), "");
  }
}

TEST(OctahedralImpostors, DrawWhatIsNearOrWhateverNoPictureWouldDoFor) {
  const geometry::Scene balls = row_of_balls(), scene = awkward_objects();
  const World of_balls(balls, {}, false), world(scene, {}, false);
  Showing near(of_balls, OctahedralImpostors({.grid = 2, .texels = 8, .far = {.radii = 0.0, .distance = 62.0}}));
  const TechniquePicture picture = near.picture(view_from({0.0, 0.0, 60.0}));
  EXPECT_EQ(picture.count("near"), 3u);
  EXPECT_EQ(picture.drawn, (std::vector<bool>{false, true, true, true, false}));
  Showing shown(world, OctahedralImpostors({.grid = 3, .texels = 16, .far = kAnywhere}));
  Showing plain(world, techniques::Plain{});
  for (const glm::dvec3& eye : {glm::dvec3(0, 0, 0), glm::dvec3(0, 0, 20), glm::dvec3(400, 3, -400)}) {
    for (const glm::dvec3& target :
         {eye + glm::dvec3(0, 0, -1), eye + glm::dvec3(1, 2, 3), eye + glm::dvec3(0, 1, 0)}) {
      const View view = view_from(eye, target);
      const TechniquePicture all = shown.picture(view);
      EXPECT_EQ(difference_from_plain(all, plain.picture(view)), "");
      EXPECT_EQ(all.count("shown"), 0u);
      EXPECT_EQ(all.count("unfit"), all.count("objects_in_view"));
    }
  }
}

TEST(OctahedralImpostors, TakeLinearColoursOnly) {
  const geometry::Scene scene = row_of_balls();
  const World world(scene, kRawUnlit, false);
  techniques::Stage stage(world);
  EXPECT_THROW(OctahedralImpostors().prepare(stage), raster::Error);
}

}  // namespace
}  // namespace lode::tests
