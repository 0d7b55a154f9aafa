#pragma once
/// What a technique may do while it makes a frame. A stage gathers the draws of one frame after the other; whatever a
/// technique does on it is counted, and the parts of its work that it names are timed.
///
/// A frame's draws come out in the order of the scene's instances, in whatever order they went in, so that leaving out
/// what nobody sees moves no pixel: ties go to the lowest instance, and blended surfaces keep their order.

#include <array>
#include <chrono>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <map>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "raster/frame.h"
#include "raster/image.h"
#include "raster/render.h"
#include "techniques/dither.h"
#include "techniques/technique.h"
#include "techniques/world.h"

namespace lode::techniques {

/// The primitive of whatever is drawn in an object's place: its draw id is the instance's whose mesh another one stands
/// for, and the object's first instance for a picture of the object.
inline constexpr std::uint32_t kStandInPrimitive = 0xFFFFFFFEu;

using PictureId = std::uint32_t;

/// A picture that was taken of objects: premultiplied colour with mips, and the depth of its level 0.
struct CapturedPicture {
  geometry::Camera camera;
  glm::ivec2 view_size_px{0, 0};  ///< of the camera's whole picture
  glm::ivec2 origin_px{0, 0};     ///< where in it this one begins
  raster::Texture texture;        ///< linear
  std::vector<float> depth;       ///< [w · h] of the camera's depth range: 1 near, 0 where there is nothing
  [[nodiscard]] glm::ivec2 size_px() const { return texture.levels.front().size_px; }
  [[nodiscard]] raster::Rect window_px() const { return {origin_px, size_px()}; }
};

/// A picture's pixels as a mesh in the world.
struct PictureRelief {
  std::vector<glm::vec3> positions;    ///< [n] from a centre
  std::vector<glm::vec2> uvs;          ///< [n] in the picture: (0, 0) its upper left, (1, 1) its lower right
  std::vector<std::uint32_t> indices;  ///< [3 · triangles], each < n
};

/// How a plate's picture meets what is behind it.
enum class PlateEdge : std::uint8_t {
  cutout,  ///< opaque where its alpha is at least one half, with depth: order-free
  blended  ///< `over`, depth-tested, no depth written, in the order of the instances
};

/// A picture in an object's place, as Stage::plate took it. The picture is there as long as the frame is.
struct ShownPlate {
  ObjectId object;
  const CapturedPicture* picture;
  std::array<glm::dvec3, 4> corners_world;
  PlateEdge edge;
  std::uint16_t pixels = kEveryPixel;
};

/// What was done on the stage in one frame.
struct StageWork {
  std::uint64_t objects = 0;     ///< drawn as the scene has them
  std::uint64_t primitives = 0;  ///< theirs
  std::uint64_t stand_ins = 0;   ///< objects drawn from other meshes
  std::uint64_t stand_in_primitives = 0;
  std::uint64_t plates = 0;  ///< and reliefs
  std::uint64_t captures = 0;
  std::uint64_t captured_px = 0;
};

/// Milliseconds spent in a part of a technique's work in one frame.
struct PartTime {
  std::string_view part;
  double ms;
};

class Stage {
 public:
  /// `options`: how pictures are captured (threads, target, pipeline). The world must outlive the stage.
  explicit Stage(const World& world, const raster::RenderOptions& options = {});

  // ---- For techniques ----
  [[nodiscard]] const World& world() const { return world_; }
  [[nodiscard]] int threads() const { return options_.threads; }
  [[nodiscard]] const raster::RenderOptions& render_options() const { return options_; }

  /// The object itself. More than once is once.
  void object(ObjectId id);

  /// Other meshes in place of an object's own, each with the material of the one whose place it takes.
  ///   meshes   one for each of the object's instances, made by SceneDraws::alternate for the instance's mesh, kept as
  ///            long as the frame is; null where the instance is drawn as it is. All null: the object itself
  /// Throws raster::Error (bad_input: another number of meshes, or one made for another mesh).
  void stand_in(ObjectId id, std::span<const AlternateMesh* const> meshes);

  /// A picture in an object's place.
  ///   corners_world   upper left, lower left, lower right, upper right of the picture, in one plane
  ///   pixels          of each 4×4 that a cut-out may take (dither.h)
  /// Throws raster::Error (bad_input) if there is no such picture.
  void plate(ObjectId id, PictureId picture, const std::array<glm::dvec3, 4>& corners_world, PlateEdge edge,
             std::uint16_t pixels = kEveryPixel);

  /// A plate in an object's place whose colours come from a shader, premultiplied, by the uv that a picture there would
  /// have: (0, 0) its upper left, (1, 1) its lower right. Cut out where alpha is less than one half.
  void plate(ObjectId id, const std::array<glm::dvec3, 4>& corners_world, raster::Shader shader);

  /// A picture in an object's place that is no plate. Throws raster::Error (bad_input) if there is no such picture.
  void relief(ObjectId id, PictureId picture, const glm::dvec3& centre_world,
              std::shared_ptr<const PictureRelief> relief, PlateEdge edge, std::uint16_t pixels = kEveryPixel);

  /// Draws the objects alone, at once, on nothing, and keeps the picture until it is released.
  ///   size_px   1…16384 a side
  /// Throws raster::Error (bad_input: the size, or a world whose colours are raw; out_of_memory).
  [[nodiscard]] PictureId capture(std::span<const ObjectId> objects, const geometry::Camera& camera,
                                  glm::ivec2 size_px);
  /// The same of a part of a view's picture, sample by sample what `view` shows of the objects there.
  ///   window_px    in the view's picture; may reach beyond it; 1…16384 a side
  ///   background   premultiplied, where there is nothing
  [[nodiscard]] PictureId capture(std::span<const ObjectId> objects, const View& view, const raster::Rect& window_px,
                                  const glm::vec4& background = glm::vec4(0.0f));
  /// The same of as much of the window as shows anything: the least rectangle, or a pixel if nothing is there.
  [[nodiscard]] PictureId capture_covered(std::span<const ObjectId> objects, const View& view,
                                          const raster::Rect& window_px);
  [[nodiscard]] const CapturedPicture& picture(PictureId id) const;
  /// The frame being made may still show it; it goes when the next one begins.
  void release(PictureId id);
  [[nodiscard]] std::uint64_t picture_bytes() const;  ///< of all pictures that are kept

  /// Times a part of the frame's work, as long as what it returns lives. The name must be a literal; the same name
  /// adds up.
  class PartTimer {
   public:
    PartTimer(Stage& stage, std::string_view part) : stage_(stage), part_(part) {}
    ~PartTimer() { stage_.add_time(part_, std::chrono::steady_clock::now() - began_); }
    PartTimer(const PartTimer&) = delete;
    PartTimer& operator=(const PartTimer&) = delete;

   private:
    Stage& stage_;
    std::string_view part_;
    std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
  };
  [[nodiscard]] PartTimer time(std::string_view part) { return {*this, part}; }

  // ---- For those who run techniques ----
  /// Forgets the last frame's draws, work and times.
  void begin(const View& view);
  /// The frame's draws so far; valid until the next call of anything here.
  [[nodiscard]] std::span<const raster::Draw> draws();
  [[nodiscard]] bool drawn(ObjectId id) const { return drawn_[id] != 0; }  ///< as itself
  [[nodiscard]] std::span<const ShownPlate> plates() const { return plates_; }
  [[nodiscard]] const StageWork& work() const { return work_; }
  [[nodiscard]] std::span<const PartTime> times() const { return times_; }

 private:
  /// An instance of an object that is drawn from other meshes; null: as the scene has it.
  struct StoodIn {
    std::uint32_t instance;
    const AlternateMesh* mesh;
  };
  struct Relief {
    ObjectId object;
    const CapturedPicture* picture;
    glm::dvec3 centre_world;
    std::shared_ptr<const PictureRelief> mesh;
    PlateEdge edge;
    std::uint16_t pixels;
    raster::Shader shader;  ///< of a plate without a picture, whose pointer is null
  };
  [[nodiscard]] raster::Image drawn_alone(std::span<const ObjectId> objects, const View& view,
                                          const raster::Rect& window_px, const glm::vec4& background) const;
  /// A part of an image of the window.
  [[nodiscard]] PictureId keep(const View& view, const raster::Rect& window_px, const raster::Image& image,
                               const raster::Rect& part_px);
  void add_time(std::string_view part, std::chrono::steady_clock::duration time);
  [[nodiscard]] raster::Draw picture_draw(ObjectId id, const CapturedPicture* picture, PlateEdge edge,
                                          std::uint16_t pixels) const;
  [[nodiscard]] raster::Draw stood_in_draw(const StoodIn& stood_in, const glm::dmat4& clip_from_world) const;
  [[nodiscard]] raster::Draw plate_draw(std::size_t plate, const glm::dmat4& clip_from_world) const;
  [[nodiscard]] raster::Draw relief_draw(const Relief& relief, const glm::dmat4& clip_from_world) const;

  const World& world_;
  raster::RenderOptions options_;
  raster::FrameMemory memory_;  ///< of captures
  raster::Shader cutout_;
  View view_;
  std::vector<std::uint8_t> drawn_;  ///< [objects]
  std::vector<StoodIn> stood_in_;    ///< in the order in which they came
  std::vector<ShownPlate> plates_;   ///< in the order in which they came
  std::vector<std::array<glm::vec3, 4>> plate_corners_;  ///< [plates] from the mean of their corners
  std::vector<Relief> reliefs_;
  std::vector<raster::Draw> draws_;
  std::map<PictureId, std::unique_ptr<CapturedPicture>> pictures_;
  std::vector<std::unique_ptr<CapturedPicture>> released_;  ///< in this frame
  PictureId next_picture_ = 0;
  StageWork work_;
  std::vector<PartTime> times_;
};

}  // namespace lode::techniques
