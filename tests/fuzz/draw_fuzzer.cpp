// libFuzzer target of the draw interface: bytes become a frame with any topology, state and number in it. Whatever they
// are, the render ends, with a picture or with one Error; the picture is the same for other threads and tiles; after an
// Error the image is as it was. Run: scripts/test --only fuzz, or the program itself with libFuzzer's options.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "raster/error.h"
#include "raster/render.h"

namespace {

using namespace lode::raster;

/// Reads the input from the front; zeros when it is used up.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t n) : data_(data), n_(n) {}

  std::uint8_t byte() { return at_ < n_ ? data_[at_++] : std::uint8_t(0); }
  int below(int n) { return byte() % n; }
  bool coin() { return (byte() & 1) != 0; }
  bool seldom() { return byte() % 32 == 31; }
  template <class T>
  T raw() {
    std::array<unsigned char, sizeof(T)> bytes;
    for (unsigned char& b : bytes) b = byte();
    T value;
    std::memcpy(&value, bytes.data(), sizeof value);
    return value;
  }

  /// A number of one of many kinds: small integers, grid points, the hostile ones, any bits at all.
  double number() {
    static constexpr double kHostile[] = {
        0.0, -0.0, 1.0, -1.0, 0.5, 1e-3, 0x1p-149, -0x1p-149, 0x1p-126, 0x1p-1074, 3.4028234663852886e38, -3.4028234663852886e38,
        1e30, -1e30, 1e300, 65536.0, 32768.0, -32768.0, 32767.998046875, 8388608.0, 0.001953125, 255.0, 256.0, 1e-20,
        std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()};
    switch (byte() % 8) {
      case 0: return kHostile[below(int(std::size(kHostile)))];
      case 1: return raw<float>();
      case 2: return raw<std::int16_t>() / 256.0;
      case 3: return raw<std::int16_t>();
      case 4: return raw<std::uint16_t>() / 65536.0;
      case 5: return raw<std::int8_t>() / 64.0;
      default: return raw<std::uint8_t>() / 4.0;  // most often: a place in the picture
    }
  }
  float real() {
    const double value = number();
    return std::abs(value) > double(std::numeric_limits<float>::max()) ? std::copysign(std::numeric_limits<float>::infinity(), float(value > 0) - 0.5f)
                                                                       : float(value);
  }
  int integer() {
    static constexpr int kHostile[] = {std::numeric_limits<int>::min(), std::numeric_limits<int>::max(), -1, 0, 1, 16384, 32768, 65536, 65537,
                                       -65536, -65537, 1 << 30};
    switch (byte() % 16) {
      case 0: return kHostile[below(int(std::size(kHostile)))];
      case 1: return raw<std::int32_t>();
      default: return raw<std::int8_t>();
    }
  }

 private:
  const std::uint8_t* data_;
  std::size_t n_;
  std::size_t at_ = 0;
};

/// Everything that a frame borrows.
struct Scene {
  struct Item {
    std::vector<glm::vec3> object;
    std::vector<glm::dvec4> clip;
    std::vector<glm::dvec3> window;
    std::vector<std::uint32_t> indices;
    std::vector<glm::vec4> colors;
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> uvs;
    std::vector<float> radii;
    Texture texture;
  };
  std::vector<Item> items;
  std::vector<Draw> draws;
  std::vector<glm::ivec2> samples;
  Frame frame;
  ColorFormat format = ColorFormat::rgba8;
  glm::ivec2 size_px{0, 0};
  Planes planes;
};

glm::vec4 color(Bytes& in) {
  const float r = in.real(), g = in.real(), b = in.real(), a = in.real();
  return {r, g, b, a};
}

Rect rect(Bytes& in) {
  const int x = in.integer(), y = in.integer(), w = in.integer(), h = in.integer();
  return {{x, y}, in.seldom() ? glm::ivec2{w, h} : glm::ivec2{std::abs(w % 100), std::abs(h % 100)}};
}

Texture texture(Bytes& in, ColorFormat format) {
  const glm::ivec2 size{1 + in.below(9), 1 + in.below(9)};
  std::vector<glm::u8vec4> texels;
  for (int i = 0; i < size.x * size.y; ++i) {
    const std::uint8_t a = in.byte();
    texels.emplace_back(a, a * 7, a * 31, i % 3 == 0 ? 255 : a * 13);
  }
  const Mips mips = in.coin() ? Mips::all : Mips::none;
  Texture made = format == ColorFormat::rgba32f && in.coin() ? make_srgb_texture(size, texels, mips) : make_raw_texture(size, texels, mips);
  if (in.seldom()) made.levels.pop_back();
  if (in.seldom() && !made.levels.empty()) made.levels[0].size_px.x = in.integer();
  return made;
}

/// Positions, in one of the three spaces, and what belongs to each of them.
void add_vertices(Bytes& in, Scene::Item& item, Draw& draw, std::size_t n) {
  const int space = draw.topology == Topology::surfels && !in.seldom() ? 0 : in.below(3);
  for (std::size_t i = 0; i < n; ++i) {
    const double x = in.number(), y = in.number(), z = in.number();
    if (space == 0) item.object.push_back(glm::vec3(in.real(), float(std::min(std::abs(x), 1e30)), float(std::min(std::abs(y), 1e30))));
    if (space == 1) item.clip.emplace_back(x, y, z, in.number());
    if (space == 2) item.window.emplace_back(x, y, z);
  }
  if (space == 0) {
    ObjectVertices vertices{item.object, glm::dmat4(1.0)};
    const int kind = in.below(4);
    if (kind == 1) {  // perspective, looking along +y
      vertices.clip_from_object = glm::dmat4(0.0);
      vertices.clip_from_object[0][0] = 1.5;
      vertices.clip_from_object[2][1] = 1.5;
      vertices.clip_from_object[3][2] = in.number();
      vertices.clip_from_object[1][3] = 1.0;
    } else if (kind == 2) {
      for (int c = 0; c < 4; ++c) {
        for (int r = 0; r < 4; ++r) vertices.clip_from_object[c][r] = in.number();
      }
    }
    draw.vertices = vertices;
  }
  if (space == 1) draw.vertices = ClipVertices{item.clip};
  if (space == 2) draw.vertices = WindowVertices{item.window};

  const auto length = [&] { return in.seldom() ? n + 1 : n; };
  if (in.coin()) {
    for (std::size_t i = 0, m = length(); i < m; ++i) item.colors.push_back(color(in));
  }
  if (draw.topology == Topology::surfels || in.coin()) {
    for (std::size_t i = 0, m = length(); i < m; ++i) {
      const float x = in.real(), y = in.real(), z = in.real();
      item.normals.emplace_back(x, y, z);
    }
  }
  if (in.coin()) {
    for (std::size_t i = 0, m = length(); i < m; ++i) {
      const float u = in.real(), v = in.real();
      item.uvs.emplace_back(u, v);
    }
  }
  if (draw.topology == Topology::discs || draw.topology == Topology::surfels || in.seldom()) {
    for (std::size_t i = 0, m = length(); i < m; ++i) item.radii.push_back(in.real());
  }
  draw.colors = item.colors;
  draw.normals = item.normals;
  draw.uvs = item.uvs;
  draw.radii = item.radii;
}

void add_draw(Bytes& in, Scene& scene) {
  constexpr std::size_t kPerPrimitive[] = {3, 4, 2, 1, 1, 1, 1};
  Scene::Item& item = scene.items.emplace_back();
  Draw draw;
  draw.topology = Topology(in.below(7));
  const std::size_t n_vertices = kPerPrimitive[std::size_t(draw.topology)] * std::size_t(in.below(6)) + (in.seldom() ? 1 : 0);
  if (in.coin()) {
    const std::size_t n_positions = std::size_t(1 + in.below(12));
    for (std::size_t i = 0; i < n_vertices; ++i) {
      item.indices.push_back(in.seldom() ? in.raw<std::uint32_t>() : std::uint32_t(in.byte() % n_positions));
    }
    draw.indices = item.indices;
    add_vertices(in, item, draw, n_positions);
  } else {
    add_vertices(in, item, draw, n_vertices);
  }

  draw.point_size_px = in.real();
  if (in.coin()) draw.color = color(in);
  if (in.coin()) {
    item.texture = texture(in, scene.format);
    draw.texture = &item.texture;
    draw.sampler.filter = Filter(in.below(4));
    draw.sampler.wrap_u = Wrap(in.below(4));
    draw.sampler.wrap_v = Wrap(in.below(4));
    draw.sampler.max_anisotropy = in.seldom() ? in.integer() : 1 + in.below(16);
    if (in.coin()) draw.sampler.border = color(in);
  }
  if (in.seldom()) draw.shader = lambert_shader({.to_light = glm::vec3(color(in)), .ambient = in.real(), .two_sided = in.coin()});

  draw.cull = Cull(in.below(3));
  draw.blend = Blend(in.below(3));
  draw.depth_test = !in.seldom();
  if (in.seldom()) draw.depth_write = in.coin();
  if (in.coin()) draw.alpha_test = in.real();
  if (in.coin()) draw.scissor = rect(in);
  if (in.coin()) draw.stipple = Stipple{in.raw<std::uint16_t>(), in.seldom() ? in.integer() : 1 + in.below(256)};
  if (in.seldom()) draw.draw_id = in.raw<std::uint32_t>();
  if (in.seldom()) draw.primitive_id = in.raw<std::uint32_t>();
  scene.draws.push_back(draw);
}

void make_scene(Bytes& in, Scene& scene) {
  scene.format = in.coin() ? ColorFormat::rgba32f : ColorFormat::rgba8;
  scene.size_px = {in.below(65), in.below(65)};
  scene.samples = {{128, 128}};
  if (in.seldom()) {
    scene.samples.clear();
    for (int i = 0, n = in.below(5); i < n; ++i) {
      const int x = in.seldom() ? in.integer() : in.below(256), y = in.below(256);
      scene.samples.emplace_back(x, y);
    }
  }
  const bool one = scene.samples.size() == 1 || in.seldom();
  scene.planes = {.color = !in.seldom(), .depth = one, .ids = one && !in.seldom()};
  scene.frame.clear = color(in);
  if (in.seldom()) scene.frame.viewport = rect(in);
  if (in.seldom()) scene.frame.scissor = rect(in);
  const int n_draws = 1 + in.below(6);
  scene.items.reserve(std::size_t(n_draws));  // draws point into it
  for (int i = 0; i < n_draws; ++i) add_draw(in, scene);
  scene.frame.draws = scene.draws;
  scene.frame.samples_fx8 = scene.samples;
}

/// An image that shows whether it has been written to.
Image patterned_image(const Scene& scene) {
  Image image = make_image(scene.size_px, scene.format, scene.planes);
  for (glm::u8vec4& c : image.rgba8) c = {1, 2, 3, 4};
  for (glm::vec4& c : image.rgba32f) c = {1.0f, 2.0f, 3.0f, 4.0f};
  for (float& z : image.depth) z = 0.75f;
  for (Ids& ids : image.ids) ids = {5, 6};
  return image;
}

template <class T>
bool same_bytes(const PixelPlane<T>& a, const PixelPlane<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}
bool same_bytes(const Image& a, const Image& b) {
  return same_bytes(a.rgba8, b.rgba8) && same_bytes(a.rgba32f, b.rgba32f) && same_bytes(a.depth, b.depth) && same_bytes(a.ids, b.ids);
}

struct Result {
  Image image;
  std::string error;  // empty: drawn
};

Result draw(const Scene& scene, int threads, int tile_size_px) {
  Result result{patterned_image(scene), {}};
  RenderOptions options;
  options.threads = threads;
  options.tile_size_px = tile_size_px;
  try {
    render(scene.frame, result.image, options);
  } catch (const Error& error) {
    result.error = error.what();
  }
  return result;
}

[[noreturn]] void broken(const char* claim) {
  std::fprintf(stderr, "draw_fuzzer: %s\n", claim);
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t n) {
  Bytes in(data, n);
  Scene scene;
  make_scene(in, scene);
  const Result one = draw(scene, 1, 64);
  const Result other = draw(scene, 3, 8);
  if (one.error != other.error) broken("another number of threads, another error");
  if (!same_bytes(one.image, other.image)) broken("another number of threads or tile size, another picture");
  if (!one.error.empty() && !same_bytes(one.image, patterned_image(scene))) broken("an error, and the image is not as it was");
  return 0;
}
