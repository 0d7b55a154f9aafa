#include "techniques/scene_draws.h"

#include <algorithm>
#include <utility>

#include "raster/error.h"
#include "techniques/scene_shader.h"

namespace lode::techniques {
namespace {

using geometry::AlphaMode;

/// A straight-alpha colour of 0…1 premultiplied, in the target's unit; opaque counts alpha as 1.
glm::vec4 premultiplied(const glm::vec4& c, bool opaque, ColorSpace space) {
  const float a = opaque ? 1.0f : c.a;
  const glm::vec4 result(c.r * a, c.g * a, c.b * a, a);
  if (space == ColorSpace::srgb) return result;
  return glm::vec4(255.0 * glm::dvec4(result));  // in double, so that k/255 becomes k again
}

raster::Topology topology(geometry::MeshKind kind) {
  switch (kind) {
    case geometry::MeshKind::lines:
      return raster::Topology::lines;
    case geometry::MeshKind::points:
      return raster::Topology::points;
    default:
      return raster::Topology::triangles;
  }
}

raster::Wrap wrap(geometry::TextureWrap wrap) {
  using enum raster::Wrap;
  return wrap == geometry::TextureWrap::repeat ? repeat : (wrap == geometry::TextureWrap::mirror ? mirror : clamp);
}

raster::Sampler sampler(const geometry::TextureUse& use) {
  using enum raster::Filter;
  const bool is_nearest = use.filter == geometry::TextureFilter::nearest;
  return {.filter = is_nearest ? nearest : (use.filter == geometry::TextureFilter::bilinear ? bilinear : trilinear),
          .wrap_u = wrap(use.wrap_u),
          .wrap_v = wrap(use.wrap_v)};
}

/// Whether a masked material cuts nothing out: opaque then, and drawn faster.
bool cuts_nothing_out(const geometry::Material& material, const geometry::Mesh& mesh) {
  const bool textured = material.color_texture && !mesh.uvs.empty();
  return !textured && material.color.a == 1.0f && material.alpha_cutoff <= 1.0f &&
         std::all_of(mesh.colors.begin(), mesh.colors.end(), [](const glm::vec4& c) { return c.a == 1.0f; });
}

raster::Texture make_texture(const geometry::Picture& picture, bool opaque, raster::Mips mips, ColorSpace space) {
  std::vector<glm::u8vec4> solid;
  if (opaque) {
    solid = picture.texels;
    for (glm::u8vec4& texel : solid) texel.a = 255;
  }
  const std::span<const glm::u8vec4> texels = opaque ? solid : picture.texels;
  try {
    return space == ColorSpace::raw ? raster::make_raw_texture(picture.size_px, texels, mips)
                                    : raster::make_srgb_texture(picture.size_px, texels, mips);
  } catch (const raster::Error& error) {
    throw raster::Error(error.kind(), "picture %.100s: %s", picture.name.c_str(), error.what());
  }
}

/// Throws raster::Error (bad_input) unless the mesh can be drawn in place of one of that kind.
void check_alternate(const geometry::Mesh& mesh, geometry::MeshKind kind, bool textured) {
  const std::size_t n = mesh.positions.size();
  const auto fits = [&](std::size_t size) { return size == 0 || size == n; };
  const bool whole = fits(mesh.normals.size()) && fits(mesh.uvs.size()) && fits(mesh.colors.size()) &&
                     mesh.indices.size() % geometry::corners_per_primitive(mesh.kind) == 0 &&
                     std::all_of(mesh.indices.begin(), mesh.indices.end(), [&](std::uint32_t i) { return i < n; });
  if (mesh.kind != kind) {
    throw raster::Error(raster::ErrorKind::bad_input, "an alternate mesh: expected primitives of the mesh's own kind");
  }
  if (!whole) {
    throw raster::Error(raster::ErrorKind::bad_input,
                        "an alternate mesh: expected whole primitives of its vertices, and attributes of them all");
  }
  if (textured && mesh.uvs.empty() && n > 0) {
    throw raster::Error(raster::ErrorKind::bad_input, "an alternate mesh: expected texture coordinates, found none");
  }
}

}  // namespace

raster::ColorFormat color_format(ColorSpace space) {
  return space == ColorSpace::raw ? raster::ColorFormat::rgba8 : raster::ColorFormat::rgba32f;
}

SceneDraws::SceneDraws(const geometry::Scene& scene, const Params& params) : scene_(scene), params_(params) {
  surfaces_.resize(scene.meshes.size());
  draws_.reserve(scene.instances.size());
  for (const geometry::Instance& instance : scene.instances) {
    std::unique_ptr<const Surface>& surface = surfaces_[instance.mesh];
    if (!surface) surface = make_surface(scene.meshes[instance.mesh]);
    draws_.push_back(instance_draw(instance));
  }
}

void SceneDraws::cut_clusters(int threads) {
  clusters_.clear();
  clusters_.resize(surfaces_.size());
  for (std::size_t i = 0; i < draws_.size(); ++i) {
    raster::Draw& draw = draws_[i];
    if (draw.topology != raster::Topology::triangles) continue;
    std::unique_ptr<const raster::Clusters>& clusters = clusters_[scene_.instances[i].mesh];
    if (!clusters) {
      const auto& positions = std::get<raster::ObjectVertices>(draw.vertices).positions;
      clusters = std::make_unique<const raster::Clusters>(raster::make_clusters(positions, draw.indices, threads));
    }
    draw.clusters = clusters.get();
  }
}

std::vector<raster::Draw> SceneDraws::draws(const geometry::Camera& camera, glm::ivec2 size_px) const {
  const glm::dmat4 clip_from_world = geometry::clip_from_world(camera, size_px);
  std::vector<raster::Draw> draws = draws_;
  for (std::size_t i = 0; i < draws.size(); ++i) {
    std::get<raster::ObjectVertices>(draws[i].vertices).clip_from_object =
        clip_from_world * scene_.instances[i].world_from_object;
  }
  return draws;
}

raster::Draw SceneDraws::draw(std::uint32_t instance, const glm::dmat4& clip_from_world) const {
  raster::Draw draw = draws_[instance];
  std::get<raster::ObjectVertices>(draw.vertices).clip_from_object =
      clip_from_world * scene_.instances[instance].world_from_object;
  draw.draw_id = instance;
  return draw;
}

AlternateMesh SceneDraws::alternate(std::uint32_t of, geometry::Mesh mesh) const {
  const Surface& surface = *surfaces_.at(of);
  check_alternate(mesh, scene_.meshes[of].kind, surface.draw.texture != nullptr);
  AlternateMesh alternate{.of = of, .mesh = std::move(mesh), .colors = {}, .clusters = {}};
  if (surface.lit && alternate.mesh.normals.empty() && alternate.mesh.kind == geometry::MeshKind::triangles) {
    alternate.mesh = geometry::with_flat_normals(alternate.mesh);
  }
  alternate.colors = converted_colors(alternate.mesh, surface.material.alpha_mode == AlphaMode::opaque);
  if (!clusters_.empty() && clusters_[of]) {
    alternate.clusters = raster::make_clusters(alternate.mesh.positions, alternate.mesh.indices, 1);
  }
  return alternate;
}

raster::Draw SceneDraws::draw(std::uint32_t instance, const AlternateMesh& alternate,
                              const glm::dmat4& clip_from_world) const {
  const Surface& surface = *surfaces_[alternate.of];
  raster::Draw draw = this->draw(instance, clip_from_world);
  std::get<raster::ObjectVertices>(draw.vertices).positions = alternate.mesh.positions;
  draw.indices = alternate.mesh.indices;
  draw.clusters = alternate.clusters ? &*alternate.clusters : nullptr;
  if (surface.lit) draw.normals = alternate.mesh.normals;
  draw.colors = alternate.colors.empty() ? alternate.mesh.colors : alternate.colors;
  if (draw.texture != nullptr) draw.uvs = alternate.mesh.uvs;
  return draw;
}

std::unique_ptr<const SceneDraws::Surface> SceneDraws::make_surface(const geometry::Mesh& scene_mesh) {
  auto surface = std::make_unique<Surface>();
  if (scene_mesh.material) surface->material = scene_.materials[*scene_mesh.material];
  AlphaMode& alpha_mode = surface->material.alpha_mode;
  if (alpha_mode == AlphaMode::mask && cuts_nothing_out(surface->material, scene_mesh)) alpha_mode = AlphaMode::opaque;
  surface->lit =
      params_.shading == Shading::lambert || (params_.shading == Shading::material && !surface->material.unlit);
  if (surface->lit && scene_mesh.normals.empty()) {
    if (scene_mesh.kind == geometry::MeshKind::triangles) {
      surface->flat = std::make_unique<const geometry::Mesh>(geometry::with_flat_normals(scene_mesh));
    } else {
      surface->lit = false;
    }
  }
  const geometry::Mesh& mesh = surface->flat ? *surface->flat : scene_mesh;

  raster::Draw& draw = surface->draw;
  draw.topology = topology(mesh.kind);
  draw.vertices = raster::ObjectVertices{mesh.positions, glm::dmat4(1.0)};
  draw.indices = mesh.indices;
  if (surface->lit) draw.normals = mesh.normals;
  set_color(mesh, *surface);
  set_texture(mesh, *surface);
  if (surface->material.alpha_mode == AlphaMode::mask) draw.alpha_test = 0.5;  // the shader's alpha is 0 or 1
  if (surface->material.alpha_mode == AlphaMode::blend) draw.blend = raster::Blend::over;
  return surface;
}

/// White factors are left out: the renderer then multiplies nothing.
void SceneDraws::set_color(const geometry::Mesh& mesh, Surface& surface) const {
  const bool opaque = surface.material.alpha_mode == AlphaMode::opaque;
  const glm::vec4 white = premultiplied(glm::vec4(1.0f), true, params_.color_space);
  const glm::vec4 color = premultiplied(surface.material.color, opaque, params_.color_space);
  if (color != white) surface.draw.color = color;

  surface.colors = converted_colors(mesh, opaque);
  surface.draw.colors = surface.colors.empty() ? mesh.colors : surface.colors;
}

/// The mesh's colours as the target wants them; none where they are that already.
std::vector<glm::vec4> SceneDraws::converted_colors(const geometry::Mesh& mesh, bool opaque) const {
  const auto converted = [&](const glm::vec4& c) { return premultiplied(c, opaque, params_.color_space); };
  if (std::all_of(mesh.colors.begin(), mesh.colors.end(), [&](const glm::vec4& c) { return converted(c) == c; })) {
    return {};
  }
  std::vector<glm::vec4> colors;
  colors.reserve(mesh.colors.size());
  for (const glm::vec4& c : mesh.colors) colors.push_back(converted(c));
  return colors;
}

/// A mesh without texture coordinates has no texture.
void SceneDraws::set_texture(const geometry::Mesh& mesh, Surface& surface) {
  if (!surface.material.color_texture || mesh.uvs.empty()) return;
  const geometry::TextureUse& use = *surface.material.color_texture;
  surface.draw.texture = texture(use, surface.material.alpha_mode == AlphaMode::opaque);
  surface.draw.sampler = sampler(use);
  surface.draw.uvs = mesh.uvs;
}

const raster::Texture* SceneDraws::texture(const geometry::TextureUse& use, bool opaque) {
  const geometry::Picture& picture = scene_.pictures[use.picture];
  const bool alpha_counts_as_full = opaque && picture.has_alpha;
  const bool mips = use.filter == geometry::TextureFilter::trilinear;
  std::unique_ptr<const raster::Texture>& texture = textures_[{use.picture, alpha_counts_as_full, mips}];
  if (!texture) {
    texture = std::make_unique<const raster::Texture>(make_texture(
        picture, alpha_counts_as_full, mips ? raster::Mips::all : raster::Mips::none, params_.color_space));
  }
  return texture.get();
}

raster::Draw SceneDraws::instance_draw(const geometry::Instance& instance) const {
  const Surface& surface = *surfaces_[instance.mesh];
  const geometry::Material& material = surface.material;
  const bool mirrored = geometry::mirrors(instance.world_from_object);
  raster::Draw draw = surface.draw;
  if (!material.double_sided && draw.topology == raster::Topology::triangles) {
    draw.cull = mirrored ? raster::Cull::front : raster::Cull::back;
  }
  SceneSurface shaded;
  shaded.lit = surface.lit;
  if (surface.lit) shaded.world_from_normal = world_from_normal(instance.world_from_object);
  shaded.front_is_clockwise = mirrored;
  shaded.double_sided = material.double_sided;
  if (material.alpha_mode == AlphaMode::mask) shaded.alpha_cutoff = material.alpha_cutoff;
  shaded.full = params_.color_space == ColorSpace::raw ? 255.0f : 1.0f;
  draw.shader = scene_shader(shaded);
  return draw;
}

}  // namespace lode::techniques
