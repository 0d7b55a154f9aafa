#pragma once
/// Where the fast pipeline's picture of a frame differs from the reference's; and the smallest part of the frame that
/// still shows it, as text to be typed into a test.

#include <cstdio>
#include <functional>
#include <string>

#include "both_pipelines.h"
#include "owned_frame.h"

namespace lode::raster::test {

/// Renders both ways; empty if the bytes are the same.
[[nodiscard]] inline std::string difference_of(const OwnedFrame& frame, const RenderOptions& fast_options) {
  Image fast = frame.image(), reference = frame.image();
  RenderOptions reference_options;
  reference_options.threads = 1, reference_options.pipeline = Pipeline::reference;
  frame.render(reference, reference_options);
  frame.render(fast, fast_options);
  return first_difference(fast, reference);
}

using Differs = std::function<bool(const OwnedFrame&)>;

/// Takes out draws one by one, then halves, quarters, … of each draw's primitives, as long as it still differs.
[[nodiscard]] inline OwnedFrame smallest_that(const Differs& differs, OwnedFrame frame) {
  for (std::size_t d = frame.draws.size(); d-- > 0;) {
    OwnedFrame without = frame;
    without.draws.erase(without.draws.begin() + std::ptrdiff_t(d));
    if (differs(without)) frame = without;
  }
  for (std::size_t d = 0; d < frame.draws.size(); ++d) {
    const std::size_t each = vertices_each(frame.draws[d]->draw.topology);
    for (std::size_t part = corner_count(*frame.draws[d]) / each; part > 0; part = part == 1 ? 0 : (part + 1) / 2) {
      for (std::size_t at = 0; at < corner_count(*frame.draws[d]);) {
        std::vector<std::uint32_t> corners;
        for (std::uint32_t c = 0; c < corner_count(*frame.draws[d]); ++c) {
          if (c < at || c >= at + part * each) corners.push_back(c);
        }
        OwnedFrame without = frame;
        without.draws[d] = with_corners(*frame.draws[d], corners);
        if (differs(without)) {
          frame = without;
        } else {
          at += part * each;
        }
      }
    }
  }
  return frame;
}

/// A draw's state and vertices, in the order drawn.
[[nodiscard]] inline std::string text_of(const OwnedDraw& d) {
  std::string all;
  const auto add = [&](const char* format, auto... values) {
    char line[400];
    std::snprintf(line, sizeof line, format, values...);
    all += line;
  };
  const Draw& s = d.draw;
  add("draw: topology %d, %s, clusters %d, cull %d, blend %d, depth test %d write %d, alpha test %g\n", int(s.topology),
      !d.clip.empty()     ? "clip"
      : !d.window.empty() ? "window"
                          : "object",
      int(d.clustered), int(s.cull), int(s.blend), int(s.depth_test), int(s.writes_depth()),
      s.alpha_test.value_or(-1.0));
  add("  texture %d, filter %d, wrap %d %d, shader %d, colors %d, normals %d, uvs %d, draw_id %d, primitive_id %d\n",
      int(s.texture != nullptr), int(s.sampler.filter), int(s.sampler.wrap_u), int(s.sampler.wrap_v),
      int(s.shader.function != nullptr), int(!d.colors.empty()), int(!d.normals.empty()), int(!d.uvs.empty()),
      s.draw_id ? int(*s.draw_id) : -1, s.primitive_id ? int(*s.primitive_id) : -1);
  if (s.color) add("  color %a %a %a %a\n", s.color->r, s.color->g, s.color->b, s.color->a);
  if (s.scissor) {
    const Rect& r = *s.scissor;
    add("  scissor at (%d, %d), %d x %d\n", r.origin_px.x, r.origin_px.y, r.size_px.x, r.size_px.y);
  }
  const glm::dmat4& m = d.clip_from_object;
  if (!d.object.empty() && m != glm::dmat4(1.0)) {
    for (int c = 0; c < 4; ++c) add("  matrix column {%a, %a, %a, %a}\n", m[c][0], m[c][1], m[c][2], m[c][3]);
  }
  const std::size_t n = std::min<std::size_t>(corner_count(d), 24);
  for (std::size_t c = 0; c < n; ++c) {
    const std::size_t v = d.indexed ? d.indices[c] : c;
    if (!d.object.empty()) add("  %zu {%a, %a, %a}", v, d.object[v].x, d.object[v].y, d.object[v].z);
    if (!d.clip.empty()) add("  %zu {%a, %a, %a, %a}", v, d.clip[v].x, d.clip[v].y, d.clip[v].z, d.clip[v].w);
    if (!d.window.empty()) add("  %zu {%a, %a, %a}", v, d.window[v].x, d.window[v].y, d.window[v].z);
    if (!d.colors.empty()) add(" color {%a, %a, %a, %a}", d.colors[v].r, d.colors[v].g, d.colors[v].b, d.colors[v].a);
    if (!d.uvs.empty()) add(" uv {%a, %a}", d.uvs[v].x, d.uvs[v].y);
    all += "\n";
  }
  if (n < corner_count(d)) add("  … %zu corners\n", corner_count(d));
  return all;
}

[[nodiscard]] inline std::string text_of(const OwnedFrame& frame) {
  char line[400];
  std::snprintf(line, sizeof line, "%d x %d, format %d, planes %d%d%d, sample (%d, %d) of %zu\n", frame.size_px.x,
                frame.size_px.y, int(frame.format), int(frame.planes.color), int(frame.planes.depth),
                int(frame.planes.ids), frame.samples_fx8[0].x, frame.samples_fx8[0].y, frame.samples_fx8.size());
  std::string all = line;
  const auto add_rect = [&](const char* what, const std::optional<Rect>& r) {
    if (!r) return;
    std::snprintf(line, sizeof line, "%s at (%d, %d), %d x %d\n", what, r->origin_px.x, r->origin_px.y, r->size_px.x,
                  r->size_px.y);
    all += line;
  };
  add_rect("viewport", frame.viewport), add_rect("scissor", frame.scissor);
  for (const auto& d : frame.draws) all += text_of(*d);
  return all;
}

/// Empty if the pipelines agree; else what differs in the smallest part of the frame.
[[nodiscard]] inline std::string bisected_difference(const OwnedFrame& frame, const RenderOptions& options) {
  const std::string whole = difference_of(frame, options);
  if (whole.empty()) return "";
  const OwnedFrame small =
      smallest_that([&](const OwnedFrame& f) { return !difference_of(f, options).empty(); }, frame);
  return whole + "in the smallest part that differs:\n" + difference_of(small, options) + text_of(small);
}

}  // namespace lode::raster::test
