#include "pictures.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace lode::pictures {

using namespace raster;

namespace {

// ---- Inputs -----------------------------------------------------------------------------------------------------

/// Random bits by (seed, counter): the finalizer of SplitMix64 (Steele et al., 2014).
std::uint64_t hashed_bits(std::uint64_t seed, std::uint64_t counter) {
  std::uint64_t z = (seed << 32) + counter * 0x9E3779B97F4A7C15u;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

/// A stream of them, for writing scenes down in order: one call an expression, since compilers differ in the order in
/// which they evaluate the arguments of a function.
class Random {
 public:
  explicit Random(std::uint64_t seed) : seed_(seed) {}
  int below(int n) { return static_cast<int>(hashed_bits(seed_, counter_++) % static_cast<std::uint64_t>(n)); }
  /// A multiple of 1/256 in [low, high).
  double grid(int low, int high) { return low + below((high - low) * 256) / 256.0; }
  float unit() { return static_cast<float>(below(1 << 16)) / 65536.0f; }
  glm::vec4 color8() {
    const int r = below(256), g = below(256), b = below(256);
    return {float(r), float(g), float(b), 255.0f};
  }

 private:
  std::uint64_t seed_;
  std::uint64_t counter_ = 0;
};

template <class T>
std::span<const T> keep(Picture& picture, std::vector<T> values) {
  auto owned = std::make_shared<const std::vector<T>>(std::move(values));
  picture.owned.push_back(owned);
  return *owned;
}

const Texture* keep(Picture& picture, Texture texture) {
  auto owned = std::make_shared<const Texture>(std::move(texture));
  picture.owned.push_back(owned);
  return owned.get();
}

/// A point of the unit circle without a sine: t in [0, 1) runs once around.
glm::dvec2 on_circle(double t) {
  const int quarter = static_cast<int>(t * 4.0);
  const double s = t * 4.0 - quarter;  // tan of half the angle goes from 0 to 1 over a quarter turn, roughly s
  const double d = 1.0 + s * s;
  const glm::dvec2 p{(1.0 - s * s) / d, 2.0 * s / d};
  const std::array<glm::dvec2, 4> turned{p, glm::dvec2{-p.y, p.x}, glm::dvec2{-p.x, -p.y}, glm::dvec2{p.y, -p.x}};
  return turned[static_cast<std::size_t>(quarter & 3)];
}

/// Straight-alpha texels: a chequerboard with a gradient and noise; alpha is 255 or, with holes, anything.
std::vector<glm::u8vec4> texels(glm::ivec2 size_px, bool holes, std::uint64_t seed) {
  Random random(seed);
  std::vector<glm::u8vec4> out;
  for (int y = 0; y < size_px.y; ++y) {
    for (int x = 0; x < size_px.x; ++x) {
      const int base = (((x >> 2) ^ (y >> 2)) & 1) != 0 ? 200 : 40;
      const int r = base + random.below(40), g = 255 * x / size_px.x, b = 255 * y / size_px.y;
      const int a = holes ? random.below(256) : 255;
      out.emplace_back(r, g, b, a);
    }
  }
  return out;
}

/// Perspective with the near plane at n and an infinite far plane, depth n/d; focal length f, unit aspect.
glm::dmat4 perspective(double f, double n) {
  glm::dmat4 m(0.0);
  m[0][0] = f;
  m[1][1] = f;
  m[3][2] = n;
  m[2][3] = -1.0;
  return m;
}

/// Orthographic: depth (far − d)/(far − near).
glm::dmat4 orthographic(double half_width, double near, double far) {
  glm::dmat4 m(1.0);
  m[0][0] = 1.0 / half_width;
  m[1][1] = 1.0 / half_width;
  m[2][2] = 1.0 / (far - near);
  m[3][2] = far / (far - near);
  return m;
}

// ---- Parts of scenes --------------------------------------------------------------------------------------------

Draw window_draw(Picture& picture, Topology topology, std::vector<glm::dvec3> positions_px) {
  Draw draw;
  draw.topology = topology;
  draw.vertices = WindowVertices{keep(picture, std::move(positions_px))};
  return draw;
}

std::vector<glm::dvec3> random_points(Random& random, int n, glm::ivec2 size_px, int margin_px) {
  std::vector<glm::dvec3> points;
  for (int i = 0; i < n; ++i) {
    const double x = random.grid(-margin_px, size_px.x + margin_px);
    const double y = random.grid(-margin_px, size_px.y + margin_px);
    points.emplace_back(x, y, random.unit());
  }
  return points;
}

std::vector<glm::vec4> random_colors(Random& random, std::size_t n, bool translucent = false) {
  std::vector<glm::vec4> colors;
  for (std::size_t i = 0; i < n; ++i) {
    glm::vec4 c = random.color8();
    if (translucent) c *= random.unit();  // premultiplied
    colors.push_back(c);
  }
  return colors;
}

/// A torus of n × m quads as indexed triangles, with normals and texture coordinates, in front of the eye at z = −4.
Draw torus(Picture& picture, int n, int m) {
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::vec2> uvs;
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; j <= m; ++j) {
      const glm::dvec2 a = on_circle(double(i % n) / n), b = on_circle(double(j % m) / m);
      const glm::dvec3 normal{a.x * b.x, a.y * b.x * 0.6 + b.y * 0.8, b.y * 0.6 - a.y * b.x * 0.8};
      const glm::dvec3 ring{a.x, a.y * 0.6, -a.y * 0.8};
      positions.push_back(glm::vec3(ring * 1.2 + normal * 0.5 + glm::dvec3(0.0, 0.0, -4.0)));
      normals.push_back(glm::vec3(normal));
      uvs.emplace_back(float(i) * 4.0f / float(n), float(j) * 2.0f / float(m));
    }
  }
  std::vector<std::uint32_t> indices;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < m; ++j) {
      const std::uint32_t a = std::uint32_t(i * (m + 1) + j), b = a + std::uint32_t(m) + 1;
      for (const std::uint32_t k : {a, b, b + 1, a, b + 1, a + 1}) indices.push_back(k);
    }
  }
  Draw draw;
  draw.vertices = ObjectVertices{keep(picture, std::move(positions)), perspective(2.0, 0.25)};
  draw.indices = keep(picture, std::move(indices));
  draw.normals = keep(picture, std::move(normals));
  draw.uvs = keep(picture, std::move(uvs));
  return draw;
}

/// A ground plane of two triangles that runs from behind the eye to far away: near clipping and the guard band.
Draw ground(Picture& picture, double clip_scale = 1.0) {
  Draw draw;
  const glm::dmat4 clip_from_object = perspective(1.5, 0.1);
  std::vector<glm::dvec4> clip;
  for (const glm::dvec3 p : {glm::dvec3{-300.0, -0.7, 2.0}, glm::dvec3{300.0, -0.7, 2.0}, glm::dvec3{300.0, -0.7, -400.0},
                             glm::dvec3{-300.0, -0.7, -400.0}}) {
    clip.push_back(clip_from_object * glm::dvec4(p, 1.0) * clip_scale);
  }
  draw.topology = Topology::quads;
  draw.vertices = ClipVertices{keep(picture, std::move(clip))};
  draw.uvs = keep(picture, std::vector<glm::vec2>{{-150.0f, 0.0f}, {150.0f, 0.0f}, {150.0f, 201.0f}, {-150.0f, 201.0f}});
  return draw;
}

/// A quad over [low, high] px, tilted in perspective (w from 1 to 4), with texture coordinates over [−0.75, 2.25]².
Draw tilted_quad(Picture& picture, glm::dvec2 low_px, glm::dvec2 high_px, glm::ivec2 size_px) {
  const auto clip = [&](double x_px, double y_px, double w) {
    return glm::dvec4{(x_px * 2.0 / size_px.x - 1.0) * w, (1.0 - y_px * 2.0 / size_px.y) * w, 0.5 * w, w};
  };
  Draw draw;
  draw.topology = Topology::quads;
  draw.vertices = ClipVertices{keep(picture, std::vector<glm::dvec4>{clip(low_px.x, low_px.y, 4.0), clip(low_px.x, high_px.y, 1.0),
                                                                     clip(high_px.x, high_px.y, 1.0), clip(high_px.x, low_px.y, 4.0)})};
  draw.uvs = keep(picture, std::vector<glm::vec2>{{-0.75f, -0.75f}, {-0.75f, 2.25f}, {2.25f, 2.25f}, {2.25f, -0.75f}});
  return draw;
}

std::vector<glm::ivec2> sample_pattern(int n) {  // ((k + ½)/n, bitreverse(k)/n + 1/(2n)), n a power of two up to 128
  std::vector<glm::ivec2> samples;
  for (int k = 0; k < n; ++k) {
    int reversed = 0;
    for (int bit = 1, from = n >> 1; from > 0; bit <<= 1, from >>= 1) reversed |= (k & bit) != 0 ? from : 0;
    samples.emplace_back((2 * k + 1) * 128 / n, (2 * reversed + 1) * 128 / n);
  }
  return samples;
}

// ---- The pictures -----------------------------------------------------------------------------------------------

Picture window_triangles() {
  Picture p{.name = "window_triangles", .size_px = {150, 131}, .clear = {9.0f, 17.0f, 33.0f, 255.0f}};
  Random random(1);
  Draw fans = window_draw(p, Topology::triangles, random_points(random, 300, p.size_px, 40));
  fans.colors = keep(p, random_colors(random, 300));
  Draw culled = window_draw(p, Topology::triangles, random_points(random, 90, p.size_px, 10));
  culled.cull = Cull::back;
  culled.color = {255.0f, 255.0f, 0.0f, 255.0f};
  Draw front = window_draw(p, Topology::triangles, random_points(random, 90, p.size_px, 10));
  front.cull = Cull::front;
  front.color = {0.0f, 255.0f, 255.0f, 255.0f};
  p.draws = {fans, culled, front};
  return p;
}

Picture lit_torus() {
  Picture p{.name = "lit_torus", .size_px = {140, 120}, .clear = {40.0f, 44.0f, 52.0f, 255.0f}};
  Draw mesh = torus(p, 48, 24);
  mesh.cull = Cull::back;
  mesh.color = {230.0f, 140.0f, 60.0f, 255.0f};
  mesh.shader = lambert_shader({.to_light = {0.6f, 0.64f, 0.48f}, .ambient = 0.2f});
  Draw inside = torus(p, 12, 9);
  inside.cull = Cull::front;
  inside.shader = lambert_shader({.to_light = {-0.6f, 0.64f, 0.48f}, .ambient = 0.1f, .two_sided = true});
  p.draws = {mesh, inside};
  return p;
}

Picture textured_torus_linear() {
  Picture p{.name = "textured_torus_linear", .size_px = {140, 120}, .format = ColorFormat::rgba32f};
  p.clear = {0.1f, 0.1f, 0.12f, 1.0f};
  Draw mesh = torus(p, 40, 20);
  mesh.color = glm::vec4(1.0f);
  mesh.texture = keep(p, make_srgb_texture({32, 16}, texels({32, 16}, false, 3), Mips::all));
  mesh.sampler = {.filter = Filter::trilinear};
  p.draws = {mesh};
  return p;
}

Picture clipped_ground() {
  Picture p{.name = "clipped_ground", .size_px = {160, 100}, .clear = {120.0f, 160.0f, 220.0f, 255.0f}};
  Draw plane = ground(p);
  plane.texture = keep(p, make_raw_texture({64, 64}, texels({64, 64}, false, 4), Mips::all));
  plane.sampler = {.filter = Filter::anisotropic, .max_anisotropy = 8};
  p.draws = {plane};
  return p;
}

Picture clipped_triangles() {
  Picture p{.name = "clipped_triangles", .size_px = {120, 120}};
  Random random(5);
  std::vector<glm::dvec4> clip;
  for (int i = 0; i < 600; ++i) {  // w from −1 to 3, z beyond both planes, x and y up to a thousand times w
    const double w = random.grid(-1, 3), scale = random.below(8) == 0 ? 4000.0 : 2.0;
    const double x = random.grid(-1, 1) * scale, y = random.grid(-1, 1) * scale;
    clip.emplace_back(x, y, w * random.grid(-1, 2), w);
  }
  Draw draw;
  draw.vertices = ClipVertices{keep(p, std::move(clip))};
  draw.colors = keep(p, random_colors(random, 600));
  draw.cull = Cull::back;
  p.draws = {draw};
  return p;
}

Picture lines() {
  Picture p{.name = "lines", .size_px = {130, 110}, .clear = {0.0f, 0.0f, 0.0f, 255.0f}};
  Random random(6);
  Draw segments = window_draw(p, Topology::lines, random_points(random, 80, p.size_px, 30));
  segments.colors = keep(p, random_colors(random, 80));
  Draw stippled = window_draw(p, Topology::lines, random_points(random, 30, p.size_px, 30));
  stippled.stipple = Stipple{0x3333, 1};
  Draw strip = window_draw(p, Topology::line_strip, random_points(random, 40, p.size_px, 5));
  strip.stipple = Stipple{0xF0A5, 3};
  strip.color = {255.0f, 64.0f, 64.0f, 255.0f};
  std::vector<glm::vec3> in_space;
  for (int i = 0; i < 40; ++i) {
    const float x = random.unit() * 6.0f - 3.0f, y = random.unit() * 6.0f - 3.0f;
    in_space.emplace_back(x, y, 1.0f - random.unit() * 6.0f);
  }
  Draw clipped;
  clipped.topology = Topology::line_strip;
  clipped.vertices = ObjectVertices{keep(p, std::move(in_space)), perspective(1.5, 0.1)};
  clipped.colors = keep(p, random_colors(random, 40));
  clipped.stipple = Stipple{0x0FFF, 2};
  p.draws = {segments, stippled, strip, clipped};
  return p;
}

Picture points_and_discs() {
  Picture p{.name = "points_and_discs", .size_px = {128, 96}};
  Random random(7);
  const Texture* texture = keep(p, make_raw_texture({8, 8}, texels({8, 8}, true, 7), Mips::all));
  for (int i = 0; i < 8; ++i) {
    Draw points = window_draw(p, Topology::points, random_points(random, 12, p.size_px, 6));
    points.point_size_px = static_cast<float>(random.grid(0, 14));
    points.color = random.color8();
    if (i % 3 == 0) points.texture = texture;
    p.draws.push_back(points);
  }
  Draw discs = window_draw(p, Topology::discs, random_points(random, 60, p.size_px, 10));
  std::vector<float> radii;
  for (int i = 0; i < 60; ++i) radii.push_back(static_cast<float>(random.grid(-1, 12)));
  discs.radii = keep(p, std::move(radii));
  discs.colors = keep(p, random_colors(random, 60));
  discs.texture = texture;
  discs.sampler = {.filter = Filter::nearest};
  p.draws.push_back(discs);
  std::vector<glm::dvec4> clip;
  for (int i = 0; i < 20; ++i) {
    const double x = random.grid(-3, 3), y = random.grid(-3, 3);
    clip.emplace_back(x, y, random.unit(), 2.0);
  }
  Draw clip_points;
  clip_points.topology = Topology::points;
  clip_points.vertices = ClipVertices{keep(p, std::move(clip))};
  clip_points.point_size_px = 2.5f;
  p.draws.push_back(clip_points);
  return p;
}

Picture surfels() {
  Picture p{.name = "surfels", .size_px = {140, 120}, .clear = {12.0f, 12.0f, 12.0f, 255.0f}};
  Random random(8);
  std::vector<glm::vec3> centres, normals;
  std::vector<float> radii;
  std::vector<glm::vec4> colors;
  for (int i = 0; i < 40; ++i) {
    for (int j = 0; j < 20; ++j) {
      const glm::dvec2 a = on_circle(i / 40.0), b = on_circle(j / 20.0);
      const glm::dvec3 normal{a.x * b.x, b.y, a.y * b.x};
      centres.push_back(glm::vec3(glm::dvec3{a.x, 0.0, a.y} * 1.1 + normal * 0.5 + glm::dvec3{0.0, 0.2, -3.5}));
      normals.push_back(glm::vec3(normal * 3.0));
      radii.push_back(j % 7 == 0 ? 0.0f : 0.12f);
      colors.push_back(random.color8());
    }
  }
  centres.emplace_back(0.0f, -0.3f, 0.5f);  // reaches from behind the eye far into the picture
  normals.emplace_back(0.0f, 1.0f, 0.05f);
  radii.push_back(30.0f);
  colors.emplace_back(60.0f, 70.0f, 60.0f, 255.0f);
  Draw draw;
  draw.topology = Topology::surfels;
  draw.vertices = ObjectVertices{keep(p, std::move(centres)), perspective(1.6, 0.1)};
  draw.normals = keep(p, std::move(normals));
  draw.radii = keep(p, std::move(radii));
  draw.colors = keep(p, std::move(colors));
  draw.shader = lambert_shader({.to_light = {0.0f, 0.6f, 0.8f}, .ambient = 0.3f, .two_sided = true});
  p.draws = {draw};
  return p;
}

/// Every filter (rows) with every wrap mode (columns).
Picture filters(std::string name, ColorFormat format, bool linear) {
  Picture p{.name = std::move(name), .size_px = {160, 160}, .format = format};
  const std::vector<glm::u8vec4> source = texels({13, 9}, true, 9);
  const Texture* texture = keep(p, linear ? make_srgb_texture({13, 9}, source, Mips::all) : make_raw_texture({13, 9}, source, Mips::all));
  const float full = format == ColorFormat::rgba8 ? 255.0f : 1.0f;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) {
      const glm::dvec2 low{column * 40.0 + 1.5, row * 40.0 + 1.25};
      Draw quad = tilted_quad(p, low, low + 37.0, p.size_px);
      quad.color = glm::vec4(full);
      quad.texture = texture;
      quad.sampler = {.filter = Filter(row), .wrap_u = Wrap(column), .wrap_v = Wrap((column + row) % 4), .max_anisotropy = 2 + 4 * column};
      quad.sampler.border = glm::vec4(0.0f, 1.0f, 0.0f, 1.0f) * (linear ? 1.0f : 255.0f);
      p.draws.push_back(quad);
    }
  }
  return p;
}

Picture alpha_tested() {
  Picture p{.name = "alpha_tested", .clear = {30.0f, 60.0f, 90.0f, 255.0f}};
  const Texture* texture = keep(p, make_raw_texture({16, 16}, texels({16, 16}, true, 10), Mips::all));
  for (int i = 0; i < 6; ++i) {
    Draw quad = tilted_quad(p, {4.0 + 11.0 * i, 6.0 + 7.0 * i}, {34.0 + 11.0 * i, 36.0 + 7.0 * i}, p.size_px);
    quad.texture = texture;
    quad.sampler = {.filter = i % 2 == 0 ? Filter::bilinear : Filter::trilinear, .wrap_u = Wrap::mirror, .wrap_v = Wrap::clamp};
    quad.alpha_test = 0.25f + 0.1f * static_cast<float>(i);
    if (i == 4) quad.blend = Blend::over;
    p.draws.push_back(quad);
  }
  return p;
}

/// Translucent layers over opaque ones: over, add, no blending without depth writes, depth writes with blending.
Picture blended(std::string name, ColorFormat format) {
  Picture p{.name = std::move(name), .size_px = {100, 90}, .format = format};
  const float full = format == ColorFormat::rgba8 ? 255.0f : 1.0f;
  p.clear = glm::vec4(0.2f, 0.3f, 0.4f, 0.5f) * full;
  Random random(11);
  for (int i = 0; i < 12; ++i) {
    Draw draw = window_draw(p, Topology::triangles, random_points(random, 30, p.size_px, 20));
    std::vector<glm::vec4> colors = random_colors(random, 30, i > 1);
    for (glm::vec4& c : colors) c *= full / 255.0f;
    draw.colors = keep(p, std::move(colors));
    draw.blend = i < 2 ? Blend::none : i % 3 == 0 ? Blend::add : Blend::over;
    if (i == 7) draw.blend = Blend::none;
    if (i == 7 || i == 9) draw.depth_write = i == 9;
    if (i == 8 || i == 10) draw.depth_test = false;
    p.draws.push_back(draw);
  }
  return p;
}

Picture not_numbers_blended() {
  Picture p{.name = "not_numbers_blended", .format = ColorFormat::rgba32f};
  const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
  const std::array<glm::vec4, 6> colors{glm::vec4{nan, 0.5f, -0.0f, 0.5f}, glm::vec4{inf, -inf, 0.0f, 1.0f},
                                        glm::vec4{1e38f, 1e-45f, -1e-45f, 0.25f}, glm::vec4{-nan, -0.0f, 3e38f, inf},
                                        glm::vec4{0.5f, 0.25f, 0.125f, nan}, glm::vec4{-1.0f, 2.0f, 0.1f, 0.7f}};
  Random random(12);
  for (int i = 0; i < 18; ++i) {
    Draw draw = window_draw(p, Topology::triangles, random_points(random, 9, p.size_px, 20));
    draw.color = colors[static_cast<std::size_t>(i) % colors.size()];
    draw.blend = i < 4 ? Blend::none : i % 2 == 0 ? Blend::over : Blend::add;
    p.draws.push_back(draw);
  }
  return p;
}

Picture scissored() {
  Picture p{.name = "scissored", .size_px = {111, 77}, .clear = {80.0f, 0.0f, 80.0f, 255.0f}};
  p.viewport = Rect{{-20, 15}, {150, 70}};
  p.scissor = Rect{{7, 5}, {90, 60}};
  Random random(13);
  const std::array<Rect, 5> scissors{Rect{{0, 0}, {50, 50}}, Rect{{40, 20}, {1000000000, 33}}, Rect{{-2000000000, 30}, {2000000090, 9}},
                                     Rect{{60, 60}, {0, 10}}, Rect{{65, 3}, {1, 70}}};
  for (const Rect& scissor : scissors) {
    std::vector<glm::dvec4> clip;
    for (int i = 0; i < 60; ++i) {
      const double x = random.grid(-1, 1), y = random.grid(-1, 1);
      clip.emplace_back(x, y, random.unit(), 1.0);
    }
    Draw draw;
    draw.vertices = ClipVertices{keep(p, std::move(clip))};
    draw.colors = keep(p, random_colors(random, 60));
    draw.scissor = scissor;
    p.draws.push_back(draw);
  }
  return p;
}

/// Coplanar, coincident and mirrored copies under ids of their own: only the order of keys decides.
Picture ties() {
  Picture p{.name = "ties", .size_px = {90, 90}};
  Random random(14);
  std::vector<glm::dvec3> corners = random_points(random, 60, p.size_px, 10);
  for (glm::dvec3& corner : corners) corner.z = 0.5;
  for (int i = 0; i < 5; ++i) {
    Draw draw = window_draw(p, Topology::triangles, corners);
    draw.colors = keep(p, random_colors(random, 60));
    if (i == 1) draw.draw_id = 7;
    if (i == 3) draw.draw_id = 0;
    if (i == 3) draw.primitive_id = 0xFFFFFFFE;
    if (i == 4) draw.depth_write = false;
    p.draws.push_back(draw);
    std::swap(corners[std::size_t(i) * 3], corners[std::size_t(i) * 3 + 1]);
    for (std::size_t k = 0; k < 12; ++k) corners[k].z = 0.25 + 0.125 * i;
  }
  Draw zero = window_draw(p, Topology::triangles, {{0.0, 0.0, 0.0}, {0.0, 90.0, 0.0}, {90.0, 0.0, 0.0}});
  zero.color = {1.0f, 2.0f, 3.0f, 4.0f};
  p.draws.push_back(zero);
  return p;
}

/// What no caller should pass but some do: every vertex has a defined fate.
Picture hostile_vertices() {
  Picture p{.name = "hostile_vertices", .size_px = {80, 80}};
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInf = std::numeric_limits<float>::infinity();
  constexpr std::array<float, 12> kValues{0.0f, -0.0f, 1e-45f, -1e-40f, 1.0f, -1.0f, 0.3f, 1e30f, -3.4e38f, kInf, -kInf, kNan};
  Random random(15);
  const auto any = [&] { return random.below(3) == 0 ? kValues[std::size_t(random.below(12))] : random.unit() * 3.0f - 1.5f; };
  for (const Topology topology : {Topology::triangles, Topology::lines, Topology::points, Topology::surfels}) {
    std::vector<glm::vec3> positions, normals;
    std::vector<float> radii;
    for (int i = 0; i < 120; ++i) {
      const float x = any(), y = any(), z = any();
      positions.emplace_back(x, y, z - 1.0f);
      const float nx = any(), ny = any(), nz = any();
      normals.emplace_back(nx, ny, nz);
      radii.push_back(any() * 0.3f);
    }
    Draw draw;
    draw.topology = topology;
    draw.vertices = ObjectVertices{keep(p, std::move(positions)), perspective(1.0, 0.1)};
    draw.normals = keep(p, std::move(normals));
    draw.radii = keep(p, std::move(radii));
    draw.colors = keep(p, random_colors(random, 120));
    draw.point_size_px = 3.0f;
    p.draws.push_back(draw);
  }
  return p;
}

Picture orthographic_with_own_shader() {
  Picture p{.name = "orthographic_with_own_shader", .size_px = {120, 100}, .format = ColorFormat::rgba32f};
  Draw mesh = torus(p, 30, 15);
  std::get<ObjectVertices>(mesh.vertices).clip_from_object = orthographic(2.0, 1.0, 7.0);
  mesh.color = glm::vec4(1.0f);
  mesh.shader = pixel_shader([](const Pixel& pixel) {
    const float stripes = ((pixel.x_px >> 2) ^ (pixel.y_px >> 2)) & 1 ? 1.0f : 0.5f;
    const glm::vec3 n = pixel.normal * 0.5f + 0.5f;
    return glm::vec4(n * stripes * (pixel.front_facing ? 1.0f : 0.25f), 1.0f) + glm::vec4(pixel.uv, pixel.depth, 0.0f) * 0.125f;
  });
  p.draws = {mesh};
  return p;
}

Picture supersampled(std::string name, ColorFormat format, int n_samples) {
  Picture p{.name = std::move(name), .size_px = {72, 60}, .format = format};
  const float full = format == ColorFormat::rgba8 ? 255.0f : 1.0f;
  p.clear = glm::vec4(0.1f, 0.2f, 0.3f, 1.0f) * full;
  p.samples_fx8 = sample_pattern(n_samples);
  Draw mesh = torus(p, 24, 12);
  mesh.color = glm::vec4(0.9f, 0.5f, 0.2f, 1.0f) * full;
  mesh.shader = lambert_shader({.to_light = {0.6f, 0.64f, 0.48f}});
  Random random(16);
  Draw segments = window_draw(p, Topology::lines, random_points(random, 16, p.size_px, 5));
  segments.color = glm::vec4(full);
  Draw glass = window_draw(p, Topology::triangles, random_points(random, 12, p.size_px, 5));
  glass.color = glm::vec4(0.0f, 0.25f, 0.25f, 0.5f) * full;
  glass.blend = Blend::over;
  p.draws = {mesh, segments, glass};
  return p;
}

/// Larger than the largest tile in both directions, and no multiple of any.
Picture many_tiles() {
  Picture p{.name = "many_tiles", .size_px = {331, 277}, .clear = {255.0f, 255.0f, 255.0f, 255.0f}};
  Random random(17);
  Draw slivers = window_draw(p, Topology::triangles, random_points(random, 180, p.size_px, 300));
  slivers.colors = keep(p, random_colors(random, 180));
  Draw mesh = torus(p, 96, 48);
  mesh.color = {90.0f, 200.0f, 120.0f, 255.0f};
  mesh.shader = lambert_shader({});
  Draw glass = window_draw(p, Topology::triangles, random_points(random, 30, p.size_px, 100));
  glass.colors = keep(p, random_colors(random, 30, true));
  glass.blend = Blend::over;
  p.draws = {slivers, mesh, glass};
  return p;
}

}  // namespace

std::vector<Picture> all_pictures() {
  std::vector<Picture> all;
  all.push_back(window_triangles());
  all.push_back(lit_torus());
  all.push_back(textured_torus_linear());
  all.push_back(clipped_ground());
  all.push_back(clipped_triangles());
  all.push_back(lines());
  all.push_back(points_and_discs());
  all.push_back(surfels());
  all.push_back(filters("filters_raw", ColorFormat::rgba8, false));
  all.push_back(filters("filters_linear", ColorFormat::rgba32f, true));
  all.push_back(filters("filters_raw_in_float", ColorFormat::rgba32f, false));
  all.push_back(alpha_tested());
  all.push_back(blended("blended_bytes", ColorFormat::rgba8));
  all.push_back(blended("blended_floats", ColorFormat::rgba32f));
  all.push_back(not_numbers_blended());
  all.push_back(scissored());
  all.push_back(ties());
  all.push_back(hostile_vertices());
  all.push_back(orthographic_with_own_shader());
  all.push_back(supersampled("supersampled_bytes", ColorFormat::rgba8, 8));
  all.push_back(supersampled("supersampled_floats", ColorFormat::rgba32f, 16));
  all.push_back(many_tiles());
  return all;
}

}  // namespace lode::pictures
