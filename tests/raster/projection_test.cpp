// Exactly-once (C3, C4) through projection, near and far clip and guard band, on a few scenes of each kind;
// projection_stress.cpp has the large counts.

#include <gtest/gtest.h>

#include "signed_coverage.h"

namespace lode::raster {
namespace {

using namespace test;

struct Seen {
  std::uint64_t n_inside = 0, n_clipped = 0, n_turned = 0;
};

Seen expect_exact(std::uint64_t seed, int n_scenes, Scene (*make)(HashedNumbers&, int)) {
  Seen seen;
  for (int i = 0; i < n_scenes; ++i) {
    HashedNumbers random(seed + std::uint64_t(i));
    const Scene scene = make(random, 1 << (2 + random.below(9)));
    const SceneResult r = check_scene(scene);
    EXPECT_EQ(r.n_wrong, 0u) << "seed " << seed + std::uint64_t(i) << ", " << r.first_wrong;
    seen.n_inside += r.n_inside;
    seen.n_clipped += r.coverage.n_clipped;
    seen.n_turned += r.coverage.n_turned;
  }
  return seen;
}

TEST(ProjectedSheet, IsCoveredExactlyOnceAcrossNearFarAndGuardBand) {
  const Seen seen = expect_exact(100, 150, random_sheet_scene);
  EXPECT_GT(seen.n_inside, 100'000u);
  EXPECT_GT(seen.n_clipped, 1000u);
  EXPECT_GT(seen.n_turned, 0u);
}

TEST(ProjectedMesh, ClosedIsCoveredAsOftenFromTheFrontAsFromTheBackUnlessCut) {
  const Seen seen = expect_exact(2000, 150, random_closed_scene);
  EXPECT_GT(seen.n_inside, 50'000u);
  EXPECT_GT(seen.n_clipped, 100u);
}

// The camera's near plane lies wholly outside the mesh: nothing is cut, so not even the borders are left out.
TEST(ProjectedMesh, ClosedAndUncutHasASignedCountOfZeroAtEverySample) {
  HashedNumbers random(50);
  for (int i = 0; i < 40; ++i) {
    Scene scene = random_closed_scene(random, 600);
    const glm::dvec3 eye = random_direction(random) * 4.0;
    scene.clip_from_object = random_clip_from_object(random, eye, glm::dvec3(0.0), 1.0, INFINITY, scene.size_px);
    const Draw draw = draw_of(scene);
    const SignedCoverage coverage = signed_coverage(frame_of(draw), scene.size_px);
    ASSERT_EQ(coverage.n_clipped, 0u);
    EXPECT_EQ(std::count(coverage.sum.begin(), coverage.sum.end(), 0), std::ptrdiff_t(coverage.sum.size()))
        << scene.name;
    EXPECT_GT(*std::max_element(coverage.count.begin(), coverage.count.end()), 1);
  }
}

TEST(ProjectedMesh, ClosedAroundTheCameraLeavesNoBackgroundPixel) {
  HashedNumbers random(60);
  for (int i = 0; i < 40; ++i) {
    Scene scene{"cube or star", {}, {}, {random.between(40, 120), random.between(40, 120)}};
    const int n = random.between(1, 12);
    scene.mesh = random.below(2) == 0 ? cube_mesh(random, n, 0.3 / n) : star_mesh(random, 2 * n + 4, n + 4, 0.3);
    const glm::dvec3 eye = random_direction(random) * 0.2;
    const double near = log_uniform(random, 1e-6, 1e-2);
    scene.clip_from_object =
        random_clip_from_object(random, eye, eye + random_direction(random), near, INFINITY, scene.size_px);
    const Draw draw = draw_of(scene);
    const SignedCoverage coverage = signed_coverage(frame_of(draw), scene.size_px);
    EXPECT_EQ(std::count(coverage.sum.begin(), coverage.sum.end(), -1), std::ptrdiff_t(coverage.sum.size()));
    Image image = make_image(scene.size_px, ColorFormat::rgba8, {.color = false, .depth = true, .ids = true});
    render_by_both(frame_of(draw), image);
    EXPECT_EQ(std::count(image.ids.begin(), image.ids.end(), Ids{kNoId, kNoId}), 0);
  }
}

TEST(ProjectedSheet, SeenFromOneSideIsCoveredOncePerSampleByRender) {
  HashedNumbers random(70);
  int n_compared = 0;
  for (int i = 0; i < 60; ++i) {
    const Scene scene = random_sheet_scene(random, 300);
    Draw draw = draw_of(scene);
    const SignedCoverage coverage = signed_coverage(frame_of(draw), scene.size_px);
    draw.color = glm::vec4(1.0f);
    draw.blend = Blend::add;
    draw.depth_test = false;
    Image image = make_image(scene.size_px, ColorFormat::rgba32f, {.color = true, .depth = false, .ids = false});
    render_by_both(frame_of(draw), image, workers_and_tiles(0, 16));
    for (std::size_t k = 0; k < image.rgba32f.size(); ++k) ASSERT_EQ(image.rgba32f[k].r, float(coverage.count[k]));
    if (coverage.n_front != 0 && coverage.n_back != 0) continue;  // the snap turned some: those count double
    n_compared += int(std::count(coverage.count.begin(), coverage.count.end(), 1));
    EXPECT_LE(*std::max_element(coverage.count.begin(), coverage.count.end()), 1);
  }
  EXPECT_GT(n_compared, 10'000);
}

// Snapped facing; the unsnapped sign is triangle_test.cpp's.
TEST(ProjectedSheet, CullingKeepsPiecesOfOneSideOnlyAndAddsNone) {
  HashedNumbers random(80);
  for (int i = 0; i < 60; ++i) {
    const Scene scene = random_sheet_scene(random, 300);
    Draw draw = draw_of(scene);
    const SignedCoverage all = signed_coverage(frame_of(draw), scene.size_px);
    draw.cull = Cull::back;
    const SignedCoverage front = signed_coverage(frame_of(draw), scene.size_px);
    draw.cull = Cull::front;
    const SignedCoverage back = signed_coverage(frame_of(draw), scene.size_px);
    EXPECT_EQ(front.n_back, 0u);
    EXPECT_EQ(back.n_front, 0u);
    if (all.n_back == 0) {
      EXPECT_EQ(front.count, all.count);
    }
    if (all.n_front == 0) {
      EXPECT_EQ(back.count, all.count);
    }
    for (std::size_t k = 0; k < all.count.size(); ++k) ASSERT_LE(front.count[k] + back.count[k], all.count[k]);
  }
}

// ---- Polygons that the snap crosses over.

/// A triangle about a sub-pixel wide, from in front of the near plane to behind it; at times past the guard band, too.
std::array<glm::dvec4, 3> random_thin_triangle(HashedNumbers& random) {
  const double w_a = 0.5 + random.unit(), w_c = random.below(2) == 0 ? -random.unit() : 0.25 * random.unit();
  const double reach = random.below(3) == 0 ? 3000.0 : 2.0;
  const auto anywhere = [&](double r) { return r * (2.0 * random.unit() - 1.0); };
  const glm::dvec4 a{anywhere(1.0), anywhere(1.0), 0.25, w_a};
  const glm::dvec4 c{anywhere(reach), anywhere(reach), 0.25, w_c};
  const glm::dvec4 b =
      a + glm::dvec4{anywhere(1e-4), anywhere(1e-4), 0.0, anywhere(1e-4)};  // 64 px: 1e-4 is 0.8/256 px
  return {a, b, c};
}

// The oracle: the winding number of the snapped outline, exactly, at sample positions all along the outline.
TEST(TurnedPieces, ASampleIsCoveredOnceWhereTheOutlineWindsAroundItWithTheWindingsSign) {
  HashedNumbers random(90);
  constexpr glm::ivec2 kSize_px{64, 64};
  constexpr glm::ivec2 kAnySamples[] = {{0, 0},
                                        {255, 255}};  // with several, pieces reach over all positions in a pixel
  const reference::Viewport viewport = reference::make_viewport({{0, 0}, kSize_px});
  int n_turned = 0, n_inside = 0, n_against = 0;
  for (int i = 0; i < 6000; ++i) {
    std::array<glm::dvec4, 3> corners = random_thin_triangle(random);
    const Draw draw = triangles_of(ClipVertices{corners});
    Frame frame = frame_of(draw);
    frame.samples_fx8 = kAnySamples;
    const reference::Assembly assembly = reference::assemble(frame, kSize_px, 1);
    const bool turned = std::any_of(assembly.pieces.begin(), assembly.pieces.end(), [](const reference::Piece& piece) {
      const auto& t = std::get<reference::Triangle>(piece.shape);
      return t.polygon && t.polygon->has_turned_piece;
    });
    if (!turned) continue;
    ++n_turned;
    const reference::ClipPolygon cut = reference::clip_triangle(viewport, corners);
    std::vector<glm::ivec2> outline;
    for (int k = 0; k < cut.n; ++k) {
      outline.push_back(reference::window_vertex(viewport, cut.vertices[std::size_t(k)].position).p_fx8);
    }
    for (int k = 0; k < 200; ++k) {
      const glm::dvec2 from(outline[std::size_t(k) % outline.size()]), to(outline[std::size_t(k + 1) % outline.size()]);
      const glm::dvec2 on_edge = glm::mix(from, to, random.unit() * random.unit());
      const glm::ivec2 p = glm::ivec2(glm::round(on_edge)) + glm::ivec2{random.between(-1, 1), random.between(-1, 1)};
      const glm::ivec2 pixel{p.x >> 8, p.y >> 8};
      const int winding = winding_number(outline, p);  // clockwise: seen from the back
      int front = 0, back = 0;
      for (const reference::Piece& piece : assembly.pieces) {
        if (reference::intersect(piece.bounds_px, {pixel, pixel + 1}).empty()) continue;
        reference::for_each_covered(std::get<reference::Triangle>(piece.shape), {pixel, pixel + 1}, p - 256 * pixel,
                                    [&](glm::ivec2) { ++(piece.front_facing ? front : back); });
      }
      if (pixel.x < 0 || pixel.y < 0 || pixel.x >= kSize_px.x || pixel.y >= kSize_px.y) continue;
      ASSERT_LE(std::abs(winding), 1);
      ASSERT_LE(front + back, 1) << "triangle " << i;
      ASSERT_EQ(front - back, -winding) << "triangle " << i << " at " << p.x << ", " << p.y;
      n_inside += winding != 0;
      n_against +=
          winding != 0 && (winding > 0) == (reference::doubled_area_fx16(outline[0], outline[1], outline[2]) < 0);
    }
  }
  EXPECT_GT(n_turned, 200);
  EXPECT_GT(n_inside, 1000);
  EXPECT_GT(n_against, 20);
}

// Seen from v0 the others lie at 0°, 60°, 30° and 90° (clockwise): +(0…60), −(60…30), +(30…90). At 45° all three
// pieces overlap, the outline winds around once: the first positive piece covers the sample, alone.
TEST(TurnedPieces, WhereSeveralOverlapTheFirstOfTheWindingsSignCoversTheSample) {
  for (const int mirror : {1, -1}) {
    reference::ClippedPolygon polygon;
    polygon.has_turned_piece = true;
    for (const glm::ivec2 p :
         {glm::ivec2(0, 0), glm::ivec2(1000, 0), glm::ivec2(500, 866), glm::ivec2(866, 500), glm::ivec2(0, 1000)}) {
      polygon.vertices.push_back({{mirror * p.x, p.y}, 0.5, 1.0});
    }
    const auto owner = [&](glm::ivec2 p) {
      int n = 0, first = -1;
      for (int piece = 0; piece < 3; ++piece) {
        if (!reference::owns_sample(polygon, piece, {mirror * p.x, p.y})) continue;
        ++n;
        first = piece;
      }
      return n > 1 ? -2 : first;
    };
    EXPECT_EQ(owner({290, 78}), 0);   // 15°: the first alone
    EXPECT_EQ(owner({212, 212}), 0);  // 45°: +1 −1 +1
    EXPECT_EQ(owner({78, 290}), 2);   // 75°: the last alone
    EXPECT_EQ(owner({-200, 200}), -1);
  }
}

/// A fan whose slices are thinner than a sub-pixel where the near plane cuts them.
TEST(TurnedPieces, AFanOfSlicesThinnerThanASubPixelIsCoveredExactlyOnce) {
  HashedNumbers random(91);
  std::uint64_t n_turned = 0, n_inside = 0;
  for (int i = 0; i < 3; ++i) {
    Scene scene{"thin fan", fan_sheet(60'000, {0.0f, 0.27f}, {4.0f, 4.0f}), {}, {96, 64}};
    const double near = 0.28 + 0.05 * random.unit();  // the fan's centre lies just behind it
    scene.clip_from_object =
        clip_from_view(1.2, 1.5, near, INFINITY) *
        glm::lookAt(glm::dvec3(0.0, 0.0, 0.1), glm::dvec3(0.01 * random.unit(), 1.0, 0.1), {0.7, 0.0, 1.0});
    const SceneResult r = check_scene(scene);
    EXPECT_EQ(r.n_wrong, 0u) << r.first_wrong;
    n_turned += r.coverage.n_turned;
    n_inside += r.n_inside;
  }
  EXPECT_GT(n_turned, 1000u);
  EXPECT_GT(n_inside, 3000u);
}

}  // namespace
}  // namespace lode::raster
