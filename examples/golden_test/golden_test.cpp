// Draws one triangle with a shader of its own and compares the picture with a golden, bit for bit.
#include <cstdio>

#include "raster/golden.h"
#include "raster/render.h"

using namespace lode::raster;

int main(int n_arguments, char** arguments) {
  const char* const golden = n_arguments > 1 ? arguments[1] : "golden.pam";
  const glm::dvec3 corners_px[] = {{4.0, 4.0, 0.5}, {12.0, 60.0, 0.5}, {60.0, 20.0, 0.5}};
  Draw draw;
  draw.vertices = WindowVertices{corners_px};
  draw.color = {255.0f, 180.0f, 60.0f, 255.0f};
  draw.shader = pixel_shader([](const Pixel& p) {  // a chequerboard of 8 pixels
    const bool dark = ((p.x_px >> 3) ^ (p.y_px >> 3)) & 1;
    return p.color * (dark ? glm::vec4(0.25f, 0.25f, 0.25f, 1.0f) : glm::vec4(1.0f));
  });

  Image image = make_image({64, 64}, ColorFormat::rgba8);
  render(Frame{.draws = {&draw, 1}, .clear = {20.0f, 24.0f, 32.0f, 255.0f}}, image);

  const std::string difference = compare_golden(image, golden);
  std::fputs(difference.empty() ? "the picture is the golden\n" : difference.c_str(), stdout);
  return difference.empty() ? 0 : 1;
}
