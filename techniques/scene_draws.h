#pragma once
/// A scene as draws for the rasterizer: what every technique and every picture starts from. Draw k is instance k of the
/// scene, and its primitives are those of the instance's mesh, so that the ids of a picture mean the scene's input.
///
/// Colours in the srgb space are linear, premultiplied floats: textures are decoded, factors and vertex colours taken
/// as they are. In the raw space all are 8-bit code values, taken, filtered and blended as they are (factors and vertex
/// colours times 255). In both, texels are premultiplied before mips and filtering.
///
/// Alpha modes (glTF 2.0, sec. 3.9.4). opaque: alpha is 1, the texels' too. mask: alpha-tested at the cutoff, and what
/// passes is opaque. blend: `over`, depth-tested and not written, in the scene's order after all opaque and masked
/// draws. One-sided materials show counter-clockwise triangles (clockwise ones where the instance mirrors), others both
/// sides.

#include <cstdint>
#include <glm/vec2.hpp>
#include <map>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "geometry/scene.h"
#include "raster/frame.h"
#include "raster/image.h"

namespace lode::techniques {

/// material: lit (scene_shader.h) unless the material is unlit; lambert: all lit; unlit: none. What has no normals is
/// unlit, but for triangles, which get flat ones.
enum class Shading : std::uint8_t { material, lambert, unlit };
enum class ColorSpace : std::uint8_t { srgb, raw };

/// The target's format that a colour space draws into: rgba32f for srgb, rgba8 for raw.
[[nodiscard]] raster::ColorFormat color_format(ColorSpace space);

/// A mesh that is drawn in place of one of the scene's, with that mesh's material, as SceneDraws::alternate made it.
struct AlternateMesh {
  std::uint32_t of = 0;                      ///< the scene's mesh
  geometry::Mesh mesh;                       ///< with flat normals where it is lit and had none
  std::vector<glm::vec4> colors;             ///< premultiplied, in the target's unit, where they differ from the mesh's
  std::optional<raster::Clusters> clusters;  ///< where the scene's meshes have them
};

class SceneDraws {
 public:
  struct Params {
    Shading shading = Shading::material;
    ColorSpace color_space = ColorSpace::srgb;
  };

  /// Makes textures, colours and shaders, once per scene. The scene must outlive this unchanged: its positions are
  /// borrowed. Throws raster::Error (out_of_memory; bad_input, naming a picture that is too large).
  SceneDraws(const geometry::Scene& scene, const Params& params);

  /// Cuts every mesh of triangles into clusters, once per scene, for the fast pipeline: draws made from here on have
  /// them, and those of one mesh share them. Not while draws that were made before are in use.
  void cut_clusters(int threads = 0);

  /// One draw an instance, as the camera sees it. They borrow from this and from the scene. O(instances).
  [[nodiscard]] std::vector<raster::Draw> draws(const geometry::Camera& camera, glm::ivec2 size_px) const;

  /// The draw of one instance, with its index as the draw's id.
  [[nodiscard]] raster::Draw draw(std::uint32_t instance, const glm::dmat4& clip_from_world) const;

  /// Makes a mesh ready to be drawn in place of mesh `of`, which has an instance. Thread-safe.
  /// Throws raster::Error (bad_input: other primitives than mesh `of`'s, a vertex or corner without all of the mesh's
  /// attributes, no texture coordinates where the material's texture needs them).
  [[nodiscard]] AlternateMesh alternate(std::uint32_t of, geometry::Mesh mesh) const;

  /// The draw of an instance of alternate.of that shows the alternate mesh. It borrows from that, too.
  [[nodiscard]] raster::Draw draw(std::uint32_t instance, const AlternateMesh& alternate,
                                  const glm::dmat4& clip_from_world) const;

  [[nodiscard]] const geometry::Scene& scene() const { return scene_; }

 private:
  /// A mesh with its material, as far as all its instances share it.
  struct Surface {
    raster::Draw draw;  ///< all but the matrix, the facing and the shader
    geometry::Material material;
    bool lit = false;
    std::unique_ptr<const geometry::Mesh> flat;  ///< with flat normals, where the scene's mesh has none
    std::vector<glm::vec4> colors;  ///< premultiplied, in the target's unit, where they differ from the mesh's
  };
  /// Picture, whether its alpha counts as 255, whether it has mips.
  using TextureKey = std::tuple<std::uint32_t, bool, bool>;

  [[nodiscard]] std::unique_ptr<const Surface> make_surface(const geometry::Mesh& mesh);
  void set_color(const geometry::Mesh& mesh, Surface& surface) const;
  [[nodiscard]] std::vector<glm::vec4> converted_colors(const geometry::Mesh& mesh, bool opaque) const;
  void set_texture(const geometry::Mesh& mesh, Surface& surface);
  const raster::Texture* texture(const geometry::TextureUse& use, bool opaque);
  [[nodiscard]] raster::Draw instance_draw(const geometry::Instance& instance) const;

  const geometry::Scene& scene_;
  Params params_;
  std::map<TextureKey, std::unique_ptr<const raster::Texture>> textures_;
  std::vector<std::unique_ptr<const Surface>> surfaces_;           ///< [meshes]; null where no instance has the mesh
  std::vector<std::unique_ptr<const raster::Clusters>> clusters_;  ///< [meshes]; null where there are none
  std::vector<raster::Draw> draws_;                                ///< [instances], all but the matrix
};

}  // namespace lode::techniques
