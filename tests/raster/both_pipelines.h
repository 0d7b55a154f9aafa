#pragma once
/// One frame by both pipelines. What a test claims of a picture, it claims of either: render_by_both() gives the
/// reference's picture to the test, and expects the fast one's to be the same bytes.

#include <gtest/gtest.h>

#include <cstdio>
#include <cstring>
#include <string>

#include "raster/render.h"

namespace lode::raster::test {

/// The first pixel in which two pictures differ, both values; empty if they are the same.
[[nodiscard]] inline std::string first_difference(const Image& fast, const Image& reference) {
  const auto compare = [&](const char* plane, const auto& a, const auto& b, auto print) -> std::string {
    if (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0) return "";
    std::size_t n = 0, first = 0;
    for (std::size_t i = a.size(); i-- > 0;) {
      if (std::memcmp(&a[i], &b[i], sizeof a[i]) != 0) ++n, first = i;
    }
    const auto width = std::size_t(fast.size_px.x);
    return std::string(plane) + ": " + std::to_string(n) + " pixels, first (" + std::to_string(first % width) + ", " +
           std::to_string(first / width) + "): fast " + print(a[first]) + ", reference " + print(b[first]) + "\n";
  };
  const auto text = [](const char* format, auto... values) {
    char line[256];
    std::snprintf(line, sizeof line, format, values...);
    return std::string(line);
  };
  const auto bytes = [&](const glm::u8vec4& c) { return text("(%d, %d, %d, %d)", c.r, c.g, c.b, c.a); };
  const auto floats = [&](const glm::vec4& c) { return text("(%a, %a, %a, %a)", c.r, c.g, c.b, c.a); };
  const auto ids = [&](const Ids& i) { return text("draw %d primitive %d", int(i.draw), int(i.primitive)); };
  return compare("ids", fast.ids, reference.ids, ids) +
         compare("depth", fast.depth, reference.depth, [&](float d) { return text("%a", d); }) +
         compare("rgba8", fast.rgba8, reference.rgba8, bytes) +
         compare("rgba32f", fast.rgba32f, reference.rgba32f, floats);
}

/// What either pipeline counts alike in draws without clusters: all but tiles, whose size is another one, and hidden
/// samples, which the fast pipeline may leave out block by block, and which it does not shade for an alpha test.
[[nodiscard]] inline std::string common_counters(const FrameStats& stats, bool tests_alpha) {
  const std::uint64_t in_front =
      stats.fragments_covered - stats.fragments_depth_failed - stats.fragments_alpha_failed;
  std::string text = "fragments in front " + std::to_string(in_front) + "\n";
  for_each_counter(stats, [&](const std::string& name, std::uint64_t n) {
    const bool hidden =
        name == "fragments_covered" || name == "fragments_depth_failed" ||
        (tests_alpha && (name == "fragments_shaded" || name == "fragments_alpha_failed" || name == "texels_read"));
    const bool common = name.starts_with("draws_") || name.starts_with("primitives_") || name == "pieces" ||
                        name.starts_with("fragments_") || name == "texels_read";
    if (common && !hidden && n != 0) text += name + " " + std::to_string(n) + "\n";
  });
  return text;
}

/// Returns the fast pipeline's counters. If the options ask for the reference, or for statistics by draw, which the
/// reference counts whatever they ask for, it draws alone. One memory for all frames of a thread: with one for each, a
/// sanitizer takes ten times as long to hand out the memory as the test to draw.
inline FrameStats render_by_both(const Frame& frame, Image& image, RenderOptions options = {.threads = 1}) {
  if (options.pipeline == Pipeline::reference || !options.per_draw.empty()) return render(frame, image, options);
  thread_local FrameMemory memory;
  if (!options.memory) options.memory = &memory;
  Image fast = image;
  const FrameStats fast_stats = render(frame, fast, options);
  options.pipeline = Pipeline::reference;
  const FrameStats stats = render(frame, image, options);
  EXPECT_EQ(first_difference(fast, image), "");
  if (fast_stats.boxes_tested == 0) {
    bool tests_alpha = false;
    for (const Draw& draw : frame.draws) tests_alpha |= draw.order_free() && draw.alpha_test.has_value();
    EXPECT_EQ(common_counters(fast_stats, tests_alpha), common_counters(stats, tests_alpha)) << "fast, reference";
  }
  return fast_stats;
}

}  // namespace lode::raster::test
