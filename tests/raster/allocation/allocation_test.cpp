// Allocation failure (C15): with every k-th allocation failing in turn, whatever allocates throws Error(out_of_memory),
// targets stay as they were, nothing leaks, and the next try is right. A program of its own, because it replaces
// operator new.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "raster/error.h"
#include "tests/raster/everything.h"
#include "tests/raster/random_meshes.h"

namespace {

/// While armed, allocation number `fails_at` (from 0) fails, and with `and_all_later` all after it. Atomic, because
/// workers allocate, too.
struct Failure {
  std::atomic<bool> armed{false};
  std::atomic<long> n{0};
  long fails_at = -1;
  bool and_all_later = false;
};
Failure failure;
std::atomic<long> n_alive{0};

bool fails_now() {
  if (!failure.armed.load()) return false;
  const long k = failure.n.fetch_add(1);
  return k == failure.fails_at || (failure.and_all_later && k > failure.fails_at);
}

void* allocate(std::size_t size, std::size_t alignment) {
  void* memory = fails_now() ? nullptr
                             : std::aligned_alloc(
                                   alignment, (std::max<std::size_t>(size, 1) + alignment - 1) / alignment * alignment);
  if (!memory) throw std::bad_alloc();
  ++n_alive;
  return memory;
}

void release(void* memory) noexcept {
  if (memory) --n_alive;
  std::free(memory);
}

}  // namespace

// The library's nothrow forms call these, a sanitizer's do not. Not inlined: GCC takes an inlined free of what an operator new returned
// for a mistake.
[[gnu::noinline]] void* operator new(std::size_t size) { return allocate(size, alignof(std::max_align_t)); }
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate(size, std::size_t(alignment));
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  try {
    return allocate(size, alignof(std::max_align_t));
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { release(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { release(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept { release(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }

namespace lode::raster::test {
namespace {

enum class Outcome { done, out_of_memory, other };

/// Runs `work` with allocation k failing. What it allocated and did not give back is counted in `leaked`.
template <class Work>
Outcome run_with_failure(long k, bool and_all_later, Work work, long* leaked = nullptr) {
  const long before = n_alive.load();
  Outcome outcome = Outcome::done;
  failure.fails_at = k;
  failure.and_all_later = and_all_later;
  failure.n = 0;
  failure.armed = true;
  try {
    work();
  } catch (const Error& error) {
    outcome = error.kind() == ErrorKind::out_of_memory && std::strncmp(error.what(), "out of memory for ", 18) == 0 &&
                      std::strchr(error.what(), '\n') == nullptr
                  ? Outcome::out_of_memory
                  : Outcome::other;
  } catch (...) {
    outcome = Outcome::other;
  }
  failure.armed = false;
  if (leaked) *leaked = n_alive.load() - before;
  return outcome;
}

/// `make` with each allocation failing, until it succeeds. Returns how many could fail.
template <class Make>
long failures_of(Make make) {
  for (const bool and_all_later : {true, false}) {
    for (long k = 0;; ++k) {
      long leaked = 0;
      const Outcome outcome = run_with_failure(
          k, and_all_later, [&] { (void)make(); }, &leaked);
      EXPECT_EQ(leaked, 0) << "allocation " << k;
      if (outcome == Outcome::done && !and_all_later) return k;
      if (outcome == Outcome::done) break;
      EXPECT_EQ(outcome, Outcome::out_of_memory) << "allocation " << k;
      if (outcome != Outcome::out_of_memory) return k;
    }
  }
  return 0;
}

TEST(AllocationFailure, OfAnImageIsOutOfMemory) {
  // Colour, depth and ids.
  EXPECT_EQ(failures_of([] { return make_image({7, 5}, ColorFormat::rgba8); }), 3);
  EXPECT_EQ(failures_of([] { return make_image({7, 5}, ColorFormat::rgba32f); }), 3);
}

TEST(AllocationFailure, OfATextureIsOutOfMemory) {
  const std::vector<glm::u8vec4> bytes(5 * 4);
  const std::vector<glm::vec4> floats(5 * 4);
  // At least the list of levels and three planes: 5×4, 2×2, 1×1.
  EXPECT_GE(failures_of([&] { return make_raw_texture({5, 4}, bytes, Mips::all); }), 4);
  EXPECT_GE(failures_of([&] { return make_srgb_texture({5, 4}, bytes, Mips::all); }), 4);
  EXPECT_GE(failures_of([&] { return make_linear_texture({5, 4}, floats, Mips::all); }), 4);
}

TEST(AllocationFailure, NamesTheSizeThatWasAskedFor) {
  failure.fails_at = 0;
  failure.n = 0;
  failure.armed = true;
  std::string message;
  try {
    (void)make_image({7, 5}, ColorFormat::rgba8);
  } catch (const Error& error) {
    failure.armed = false;
    message = error.what();
  }
  failure.armed = false;
  EXPECT_EQ(message, "out of memory for an image of 7 x 5 pixels");
}

/// An image with something in it, so that any write shows.
void fill(Image& image) {
  for (glm::u8vec4& pixel : image.rgba8) pixel = {1, 2, 3, 4};
  for (glm::vec4& pixel : image.rgba32f) pixel = {5, 6, 7, 8};
  for (float& depth : image.depth) depth = 0.125f;
  for (Ids& ids : image.ids) ids = {9, 10};
}

enum class PerDraw : std::uint8_t { counted, not_counted };  ///< counted: by the reference pipeline, whatever is asked for

/// Renders with each allocation failing in turn, until none fails.
void expect_renders_whole_or_not_at_all(SmallScene& scene, const RenderOptions& options, bool and_all_later,
                                        PerDraw per_draw_counts = PerDraw::counted) {
  scene.render(options);
  const Image right = scene.image;
  Image untouched = right;
  fill(untouched);
  std::vector<DrawStats> per_draw(scene.draws.size());
  RenderOptions with_stats = options;
  if (per_draw_counts == PerDraw::counted) with_stats.per_draw = per_draw;
  int n_failed = 0;
  for (long k = 0;; ++k) {
    ASSERT_LT(k, 100'000);
    fill(scene.image);
    per_draw.assign(per_draw.size(), {77, 78});
    long leaked = 0;
    const Outcome outcome = run_with_failure(
        k, and_all_later, [&] { raster::render(scene.frame, scene.image, with_stats); }, &leaked);
    ASSERT_NE(outcome, Outcome::other) << "allocation " << k;
    ASSERT_TRUE(leaked == 0 || options.threads > 1) << "allocation " << k << ": " << leaked;  // TBB keeps some
    if (outcome == Outcome::done) {
      ASSERT_TRUE(same_bytes(scene.image, right)) << "allocation " << k;
      if (failure.n.load() <= k) break;  // none failed: all of them have by now
      continue;                          // one failed and was not needed, such as a thread's
    }
    ++n_failed;
    ASSERT_TRUE(same_bytes(scene.image, untouched)) << "allocation " << k;
    for (const DrawStats& stats : per_draw) ASSERT_EQ(stats.covered, 77u) << "allocation " << k;
    raster::render(scene.frame, scene.image, with_stats);
    ASSERT_TRUE(same_bytes(scene.image, right)) << "after allocation " << k;
  }
  EXPECT_GT(n_failed, 10);
  std::printf("[ MEASURED ] %d threads: %d allocations failed\n", options.threads, n_failed);
}

TEST(AllocationFailure, OfAFrameLeavesTheTargetsAloneAndTheNextFrameIsRight) {
  for (const ColorFormat format : {ColorFormat::rgba8, ColorFormat::rgba32f}) {
    SmallScene scene({40, 24}, format);
    add_everything(scene);
    for (const bool and_all_later : {false, true}) {
      expect_renders_whole_or_not_at_all(scene, {.threads = 1, .tile_size_px = 16}, and_all_later);
    }
  }
}

TEST(AllocationFailure, OfASupersampledFrameLeavesTheTargetAlone) {
  SmallScene scene({40, 24}, ColorFormat::rgba8, {.color = true, .depth = false, .ids = false});
  add_everything(scene);
  const glm::ivec2 samples[] = {{64, 64}, {192, 192}};
  scene.frame.samples_fx8 = samples;
  expect_renders_whole_or_not_at_all(scene, {.threads = 1, .tile_size_px = 16}, false);
}

TEST(AllocationFailure, OnTwoThreadsLeavesTheTargetsAloneAndTheNextFrameIsRight) {
  SmallScene scene({40, 24});
  add_everything(scene);
  for (const bool and_all_later : {false, true}) {
    expect_renders_whole_or_not_at_all(scene, {.threads = 2, .tile_size_px = 16}, and_all_later);
  }
}

/// Two balls and a grid as clusters, one of them across the near plane, with vertex colours and without.
void add_clusters(SmallScene& scene, const Clusters& ball, const OwnedDraw& ball_mesh) {
  for (const double distance : {3.0, 1.05, 5.0}) {
    Draw& draw = scene.object(Topology::triangles, ball_mesh.object, perspective_from({0.3, 0.2, distance}, 0.1, 0.1));
    draw.indices = scene.keep(ball_mesh.indices);
    draw.clusters = &ball;
    if (distance != 3.0) draw.colors = scene.keep(std::vector<glm::vec4>(ball_mesh.object.size(), {200, 10, 90, 255}));
  }
  scene.draws[1].cull = Cull::back;
}

struct Ball {
  OwnedDraw mesh;
  Clusters clusters;
  Ball() {
    add_ball(30, 20, mesh);
    clusters = make_clusters(mesh.object, mesh.indices, 1);
  }
};

TEST(AllocationFailure, OfAFastFrameLeavesTheTargetsAloneAndTheNextFrameIsRight) {
  const Ball ball;
  for (const int threads : {1, 2}) {
    SmallScene scene({140, 40});
    add_everything(scene);
    add_clusters(scene, ball.clusters, ball.mesh);
    for (const bool and_all_later : {false, true}) {
      expect_renders_whole_or_not_at_all(scene, {.threads = threads}, and_all_later, PerDraw::not_counted);
    }
  }
}

TEST(AllocationFailure, OfAFrameInAKeptMemoryLeavesThatMemoryUsable) {
  const Ball ball;
  SmallScene scene({140, 40});
  add_everything(scene);
  add_clusters(scene, ball.clusters, ball.mesh);
  scene.render();
  const Image right = scene.image;
  for (long k = 0;; ++k) {
    FrameMemory memory;
    const RenderOptions options{.threads = 1, .memory = &memory};
    const Outcome outcome = run_with_failure(k, false, [&] { render(scene.frame, scene.image, options); });
    ASSERT_NE(outcome, Outcome::other) << "allocation " << k;
    render(scene.frame, scene.image, options);
    ASSERT_TRUE(same_bytes(scene.image, right)) << "after allocation " << k;
    if (outcome == Outcome::done) break;
  }
}

#ifdef LODESTONE_THREADS_ALLOCATE
constexpr int kMostThreadsWithoutAllocation = 1;
#else
constexpr int kMostThreadsWithoutAllocation = 2;
#endif

void expect_no_allocation_from_the_third_frame_on(SmallScene& scene) {
  scene.frame.draws = scene.draws;
  for (int threads = 1; threads <= kMostThreadsWithoutAllocation; ++threads) {
    FrameMemory memory;
    const RenderOptions options{.threads = threads, .memory = &memory};
    for (int warm_up = 0; warm_up < 2; ++warm_up) raster::render(scene.frame, scene.image, options);
    const Outcome outcome = run_with_failure(-1, false, [&] { raster::render(scene.frame, scene.image, options); });
    EXPECT_EQ(outcome, Outcome::done);
    EXPECT_EQ(failure.n.load(), 0) << threads << " threads";
  }
}

TEST(FrameMemory, AllocatesNothingFromTheThirdFrameOnForClusters) {
  const Ball ball;
  SmallScene scene({300, 300});
  for (const double distance : {3.0, 2.5, 6.0, 12.0, 0.9}) {  // from the last the near plane cuts
    const glm::dmat4 camera = perspective_from({0.3, 0.2, distance}, 0.1, 0.1);
    Draw& draw = scene.object(Topology::triangles, ball.mesh.object, camera);
    draw.indices = ball.mesh.indices;
    draw.clusters = &ball.clusters;
    if (distance == 2.5) draw.cull = Cull::back;
    if (distance < 5.0) draw.colors = scene.keep(std::vector<glm::vec4>(ball.mesh.object.size(), {200, 10, 90, 255}));
  }
  expect_no_allocation_from_the_third_frame_on(scene);
  FrameMemory memory;
  EXPECT_GT(raster::render(scene.frame, scene.image, {.memory = &memory}).primitives_clipped, 0u);
}

TEST(FrameMemory, AllocatesNothingFromTheThirdFrameOnForPieces) {
  for (const ColorFormat format : {ColorFormat::rgba8, ColorFormat::rgba32f}) {
    SmallScene scene({40, 24}, format);
    add_everything(scene);
    expect_no_allocation_from_the_third_frame_on(scene);
  }
}

}  // namespace
}  // namespace lode::raster::test
