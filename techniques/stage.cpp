#include "techniques/stage.h"

#include <algorithm>
#include <glm/common.hpp>
#include <utility>

#include "raster/error.h"

namespace lode::techniques {
namespace {

/// Of a plate: the picture's corners in the order that Stage::plate takes them.
constexpr glm::vec2 kPlateUvs[4] = {{0.0f, 0.0f}, {0.0f, 1.0f}, {1.0f, 1.0f}, {1.0f, 0.0f}};

glm::dvec3 centre_of(const std::array<glm::dvec3, 4>& corners) {
  return 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
}

/// From positions around a centre.
glm::dmat4 world_from(const glm::dvec3& centre) {
  glm::dmat4 matrix(1.0);
  matrix[3] = glm::dvec4(centre, 1.0);
  return matrix;
}

raster::Shader cut_out_shader(std::uint16_t pixels) {
  return raster::material_shader({.cut_out = raster::CutOut{.cutoff = 0.5, .pixels = pixels}, .light = {}});
}

/// The least rectangle of an image that has all pixels where something is; its first pixel if nothing is.
raster::Rect covered_part(const raster::Image& image) {
  glm::ivec2 begin = image.size_px, end(0);
  for (int y = 0; y < image.size_px.y; ++y) {
    const std::size_t row = std::size_t(y) * std::size_t(image.size_px.x);
    const auto covered = [&](int x) {
      const std::size_t i = row + std::size_t(x);
      return image.depth[i] > 0.0f || image.rgba32f[i] != glm::vec4(0.0f);
    };
    int first = 0, last = image.size_px.x;
    while (first < last && !covered(first)) ++first;
    if (first == last) continue;
    while (!covered(last - 1)) --last;
    begin = glm::min(begin, glm::ivec2(first, y)), end = glm::max(end, glm::ivec2(last, y + 1));
  }
  if (end.x == 0) return {{0, 0}, {1, 1}};
  return {begin, end - begin};
}

}  // namespace

const char* name_of(Promise promise) {
  using enum Promise;
  switch (promise) {
    case exact:
      return "exact";
    case conservative_sampled:
      return "conservative, sampled";
    case conservative_continuous:
      return "conservative, continuous";
    default:
      return "approximate";
  }
}

Stage::Stage(const World& world, const raster::RenderOptions& options)
    : world_(world), options_(options), cutout_(cut_out_shader(kEveryPixel)), drawn_(world.objects().size(), 0) {
  options_.memory = &memory_;
  options_.per_draw = {};
  options_.on_tile = {};
}

void Stage::begin(const View& view) {
  view_ = view;
  std::fill(drawn_.begin(), drawn_.end(), std::uint8_t{0});
  stood_in_.clear();
  plates_.clear();
  plate_corners_.clear();
  reliefs_.clear();
  draws_.clear();
  released_.clear();
  work_ = {};
  times_.clear();
}

void Stage::object(ObjectId id) {
  if (std::exchange(drawn_.at(id), std::uint8_t{1}) != 0) return;
  ++work_.objects;
  work_.primitives += world_.objects()[id].n_primitives;
}

void Stage::stand_in(ObjectId id, std::span<const AlternateMesh* const> meshes) {
  const WorldObject& object = world_.objects()[id];
  if (meshes.size() != object.n_instances) {
    throw raster::Error(raster::ErrorKind::bad_input, "object %u: expected a mesh for each of %u instances, found %zu",
                        id, object.n_instances, meshes.size());
  }
  if (std::all_of(meshes.begin(), meshes.end(), [](const AlternateMesh* mesh) { return mesh == nullptr; })) {
    return this->object(id);
  }
  std::uint64_t n_primitives = 0;
  for (std::uint32_t k = 0; k < object.n_instances; ++k) {
    const std::uint32_t of = world_.scene().instances[object.first_instance + k].mesh;
    if (meshes[k] != nullptr && meshes[k]->of != of) {
      throw raster::Error(raster::ErrorKind::bad_input, "object %u: expected an alternate of mesh %u, found of %u", id,
                          of, meshes[k]->of);
    }
    n_primitives += (meshes[k] != nullptr ? meshes[k]->mesh : world_.scene().meshes[of]).n_primitives();
  }
  for (std::uint32_t k = 0; k < object.n_instances; ++k) stood_in_.push_back({object.first_instance + k, meshes[k]});
  ++work_.stand_ins;
  work_.stand_in_primitives += n_primitives;
}

void Stage::plate(ObjectId id, PictureId picture, const std::array<glm::dvec3, 4>& corners_world, PlateEdge edge,
                  std::uint16_t pixels) {
  const glm::dvec3 centre = centre_of(corners_world);
  plates_.push_back({id, &this->picture(picture), corners_world, edge, pixels});
  std::array<glm::vec3, 4>& corners = plate_corners_.emplace_back();
  for (std::size_t k = 0; k < 4; ++k) corners[k] = glm::vec3(corners_world[k] - centre);
  ++work_.plates;
}

void Stage::plate(ObjectId id, const std::array<glm::dvec3, 4>& corners_world, raster::Shader shader) {
  const glm::dvec3 centre = centre_of(corners_world);
  PictureRelief mesh;
  for (const glm::dvec3& corner : corners_world) mesh.positions.push_back(glm::vec3(corner - centre));
  mesh.uvs.assign(std::begin(kPlateUvs), std::end(kPlateUvs));
  mesh.indices = {0, 1, 2, 0, 2, 3};
  reliefs_.push_back({id, nullptr, centre, std::make_shared<const PictureRelief>(std::move(mesh)), PlateEdge::cutout,
                      kEveryPixel, std::move(shader)});
  ++work_.plates;
}

void Stage::relief(ObjectId id, PictureId picture, const glm::dvec3& centre_world,
                   std::shared_ptr<const PictureRelief> relief, PlateEdge edge, std::uint16_t pixels) {
  reliefs_.push_back({id, &this->picture(picture), centre_world, std::move(relief), edge, pixels, {}});
  ++work_.plates;
}

PictureId Stage::capture(std::span<const ObjectId> objects, const geometry::Camera& camera, glm::ivec2 size_px) {
  return capture(objects, {.camera = camera, .size_px = size_px}, {{0, 0}, size_px});
}

PictureId Stage::capture(std::span<const ObjectId> objects, const View& view, const raster::Rect& window_px,
                         const glm::vec4& background) {
  return keep(view, window_px, drawn_alone(objects, view, window_px, background), {{0, 0}, window_px.size_px});
}

PictureId Stage::capture_covered(std::span<const ObjectId> objects, const View& view, const raster::Rect& window_px) {
  const raster::Image image = drawn_alone(objects, view, window_px, glm::vec4(0.0f));
  return keep(view, window_px, image, covered_part(image));
}

raster::Image Stage::drawn_alone(std::span<const ObjectId> objects, const View& view, const raster::Rect& window_px,
                                 const glm::vec4& background) const {
  if (world_.color_space() == ColorSpace::raw) {
    throw raster::Error(raster::ErrorKind::bad_input,
                        "pictures of objects: expected linear colours (color space srgb), found raw ones");
  }
  const glm::dmat4 clip_from_world = geometry::clip_from_world(view.camera, view.size_px);
  std::vector<raster::Draw> draws;
  for (const ObjectId id : objects) {
    const WorldObject& object = world_.objects()[id];
    for (std::uint32_t k = 0; k < object.n_instances; ++k) {
      draws.push_back(world_.draws().draw(object.first_instance + k, clip_from_world));
    }
  }
  raster::Image image =
      raster::make_image(window_px.size_px, raster::ColorFormat::rgba32f, {.color = true, .depth = true, .ids = false});
  const raster::Rect viewport{-window_px.origin_px, view.size_px};
  raster::render({.draws = draws, .clear = background, .viewport = viewport, .scissor = {}}, image, options_);
  return image;
}

PictureId Stage::keep(const View& view, const raster::Rect& window_px, const raster::Image& image,
                      const raster::Rect& part_px) {
  auto captured = std::make_unique<CapturedPicture>();
  captured->camera = view.camera;
  captured->view_size_px = view.size_px, captured->origin_px = window_px.origin_px + part_px.origin_px;
  std::vector<glm::vec4> texels;
  const glm::ivec2 end_px = part_px.origin_px + part_px.size_px;
  for (int y = part_px.origin_px.y; y < end_px.y; ++y) {
    const auto row = std::ptrdiff_t(y) * image.size_px.x, first = row + part_px.origin_px.x, last = row + end_px.x;
    texels.insert(texels.end(), image.rgba32f.begin() + first, image.rgba32f.begin() + last);
    captured->depth.insert(captured->depth.end(), image.depth.begin() + first, image.depth.begin() + last);
  }
  captured->texture = raster::make_linear_texture(part_px.size_px, texels, raster::Mips::all);
  ++work_.captures;
  work_.captured_px += std::uint64_t(window_px.size_px.x) * std::uint64_t(window_px.size_px.y);
  pictures_.emplace(next_picture_, std::move(captured));
  return next_picture_++;
}

const CapturedPicture& Stage::picture(PictureId id) const {
  const auto found = pictures_.find(id);
  if (found == pictures_.end()) {
    throw raster::Error(raster::ErrorKind::bad_input, "picture %u: expected one that is captured and not released", id);
  }
  return *found->second;
}

void Stage::release(PictureId id) {
  const auto found = pictures_.find(id);
  if (found == pictures_.end()) return;
  released_.push_back(std::move(found->second));
  pictures_.erase(found);
}

std::uint64_t Stage::picture_bytes() const {
  std::uint64_t n = 0;
  for (const auto& [id, picture] : pictures_) {
    n += picture->depth.size() * sizeof(float);
    for (const raster::TextureLevel& level : picture->texture.levels) n += level.linear.size() * sizeof(glm::vec4);
  }
  return n;
}

std::span<const raster::Draw> Stage::draws() {
  const glm::dmat4 clip_from_world = geometry::clip_from_world(view_.camera, view_.size_px);
  draws_.clear();
  for (ObjectId id = 0; id < drawn_.size(); ++id) {
    if (drawn_[id] == 0) continue;
    const WorldObject& object = world_.objects()[id];
    for (std::uint32_t k = 0; k < object.n_instances; ++k) {
      draws_.push_back(world_.draws().draw(object.first_instance + k, clip_from_world));
    }
  }
  if (stood_in_.empty() && plates_.empty() && reliefs_.empty()) return draws_;
  for (const StoodIn& stood_in : stood_in_) draws_.push_back(stood_in_draw(stood_in, clip_from_world));
  for (std::size_t i = 0; i < plates_.size(); ++i) draws_.push_back(plate_draw(i, clip_from_world));
  for (const Relief& relief : reliefs_) draws_.push_back(relief_draw(relief, clip_from_world));
  std::stable_sort(draws_.begin(), draws_.end(),
                   [](const raster::Draw& a, const raster::Draw& b) { return *a.draw_id < *b.draw_id; });
  return draws_;
}

raster::Draw Stage::stood_in_draw(const StoodIn& stood_in, const glm::dmat4& clip_from_world) const {
  const SceneDraws& scene_draws = world_.draws();
  if (stood_in.mesh == nullptr) return scene_draws.draw(stood_in.instance, clip_from_world);
  raster::Draw draw = scene_draws.draw(stood_in.instance, *stood_in.mesh, clip_from_world);
  draw.primitive_id = kStandInPrimitive;
  return draw;
}

/// All but where it is.
raster::Draw Stage::picture_draw(ObjectId id, const CapturedPicture* picture, PlateEdge edge,
                                 std::uint16_t pixels) const {
  raster::Draw draw;
  draw.texture = picture != nullptr ? &picture->texture : nullptr;
  draw.sampler = {.filter = raster::Filter::trilinear, .wrap_u = raster::Wrap::border, .wrap_v = raster::Wrap::border};
  if (edge == PlateEdge::cutout) {
    draw.alpha_test = 0.5;
    draw.shader = pixels == kEveryPixel ? cutout_ : cut_out_shader(pixels);
  }
  if (edge == PlateEdge::blended) draw.blend = raster::Blend::over;
  draw.draw_id = world_.objects()[id].first_instance;
  draw.primitive_id = kStandInPrimitive;
  return draw;
}

raster::Draw Stage::plate_draw(std::size_t i, const glm::dmat4& clip_from_world) const {
  const ShownPlate& plate = plates_[i];
  raster::Draw draw = picture_draw(plate.object, plate.picture, plate.edge, plate.pixels);
  draw.topology = raster::Topology::quads;
  draw.vertices =
      raster::ObjectVertices{plate_corners_[i], clip_from_world * world_from(centre_of(plate.corners_world))};
  draw.uvs = kPlateUvs;
  return draw;
}

raster::Draw Stage::relief_draw(const Relief& relief, const glm::dmat4& clip_from_world) const {
  raster::Draw draw = picture_draw(relief.object, relief.picture, relief.edge, relief.pixels);
  if (relief.picture == nullptr) draw.shader = relief.shader;
  draw.topology = raster::Topology::triangles;
  draw.vertices = raster::ObjectVertices{relief.mesh->positions, clip_from_world * world_from(relief.centre_world)};
  draw.indices = relief.mesh->indices;
  draw.uvs = relief.mesh->uvs;
  return draw;
}

void Stage::add_time(std::string_view part, std::chrono::steady_clock::duration time) {
  const double ms = std::chrono::duration<double, std::milli>(time).count();
  const auto known = std::find_if(times_.begin(), times_.end(), [&](const PartTime& t) { return t.part == part; });
  if (known == times_.end()) {
    times_.push_back({part, ms});
  } else {
    known->ms += ms;
  }
}

}  // namespace lode::techniques
