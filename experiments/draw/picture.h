#pragma once
/// A picture of `lodestone draw`: what its JSON says, checked, owned, and in the renderer's units.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "raster/frame.h"
#include "raster/texture.h"

namespace lode::experiments {

/// Positions in the space they were given in: px, clip space, or (surfels) world space.
using PicturePositions = std::variant<std::vector<glm::dvec3>, std::vector<glm::dvec4>, std::vector<glm::vec3>>;

/// One draw and the arrays that it borrows.
struct PictureDraw {
  raster::Draw state;  ///< everything but vertices, arrays and texture, which `bound_draws` sets
  PicturePositions positions;
  glm::dmat4 clip_from_world{1.0};  ///< of surfels
  std::vector<glm::vec4> colors;    ///< as raster::Draw has them: per vertex, or empty
  std::vector<glm::vec3> normals;
  std::vector<glm::vec2> uvs;
  std::vector<float> radii;
  std::unique_ptr<raster::Texture> texture;
};

struct Picture {
  glm::ivec2 size_px{0, 0};
  glm::vec4 clear{0.0f, 0.0f, 0.0f, 255.0f};
  std::optional<raster::Rect> scissor;
  std::vector<glm::ivec2> samples_fx8;  ///< positions in a pixel
  std::vector<PictureDraw> draws;
};

/// The renderer's draws, borrowing from the picture, which must outlive them unchanged.
[[nodiscard]] std::vector<raster::Draw> bound_draws(const Picture& picture);

}  // namespace lode::experiments
