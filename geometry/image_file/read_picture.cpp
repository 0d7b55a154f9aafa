#include "geometry/image_file/read_picture.h"

#include <algorithm>
#include <new>
#include <utility>

#include "geometry/error.h"
#include "geometry/image_file/bare_picture.h"
#include "geometry/image_file/decode_jpeg.h"
#include "geometry/image_file/decode_png.h"
#include "geometry/input_file.h"

namespace lode::geometry {

Picture decode_picture(std::span<const std::byte> bytes, std::string name, MemoryBudget& budget) {
  const bool png = is_png(bytes);
  if (!png && !is_jpeg(bytes)) throw Error(ErrorKind::bad_input, name + ": expected a PNG or JPEG picture");
  budget.take(bytes.size(), name);  // for the bare copy
  const BarePicture bare = png ? bare_png(bytes, name) : bare_jpeg(bytes, name);

  Picture picture;
  picture.size_px = bare.size_px;
  const std::size_t n = std::size_t(bare.size_px.x) * std::size_t(bare.size_px.y);
  budget.take(n * sizeof(glm::u8vec4) + bare.decoder_bytes, name);
  try {
    picture.texels.resize(n);
    if (png) {
      decode_png(bare, name, picture.texels);
    } else {
      decode_jpeg(bare, name, picture.texels);
    }
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::machine, name + ": no memory for a picture of " + std::to_string(bare.size_px.x) + " x " +
                                        std::to_string(bare.size_px.y) + " px");
  }
  budget.give_back(bytes.size() + bare.decoder_bytes);

  picture.name = std::move(name);
  picture.has_alpha =
      std::any_of(picture.texels.begin(), picture.texels.end(), [](glm::u8vec4 t) { return t.a != 255; });
  return picture;
}

Picture read_picture(const std::string& path) {
  const FileBytes file = read_whole_file(path);
  MemoryBudget budget;
  budget.add_file(file.n);
  return decode_picture(file.span(), path, budget);
}

}  // namespace lode::geometry
