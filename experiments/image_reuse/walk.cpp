#include "experiments/image_reuse/walk.h"

#include <algorithm>

#include "experiments/display_bytes.h"
#include "experiments/harness/sky.h"
#include "experiments/image_reuse/displacement.h"
#include "experiments/metrics/flip/flip.h"
#include "experiments/metrics/pixel_difference.h"
#include "experiments/metrics/popping.h"
#include "experiments/metrics/structural_similarity.h"

namespace lode::experiments {
namespace {

using Bytes = std::vector<glm::u8vec4>;

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
}

class WalkRunner {
 public:
  WalkRunner(const Walk& walk, const techniques::World& world, std::span<PreparedMethod* const> methods, int threads)
      : walk_(walk), world_(world), methods_(methods), threads_(threads) {
    image_ = raster::make_image(walk.size_px, techniques::color_format(world.color_space()),
                                {.color = true, .depth = true, .ids = false});
  }

  /// What does not depend on the machine. Also warms up.
  void add_results(const std::function<void()>& on_step, CaseResult& result) {
    cut();
    std::vector<Bytes> before(methods_.size()), now(methods_.size());
    const std::size_t steady_from = steady_begin();
    for (std::size_t i = 0; i < walk_.cameras.size(); ++i) {
      const bool steady = i >= steady_from && i < steady_from + std::size_t(walk_.n_steady);
      const bool compared = walk_.error_every > 0 && i % std::size_t(walk_.error_every) == first_compared();
      const techniques::View view = view_at(i);
      for (std::size_t m = 0; m < methods_.size(); ++m) {
        PreparedMethod& method = *methods_[m];
        static_cast<void>(method.draw(view, image_, kSky));
        Row row = work_row(i, method);
        if (steady || compared) now[m] = display_bytes(image_.rgba32f);
        if (compared) add_errors(now[0], now[m], method, view, row);
        if (steady && i > steady_from) add_popping({before[m], now[m], before[0], now[0]}, row);
        result.results.push_back(std::move(row));
      }
      std::swap(before, now);
      on_step();
    }
  }

  void add_times(const std::function<void()>& on_step, CaseResult& result) {
    struct Timed {
      std::vector<double> technique, render, frame;  // [passes]
    };
    std::vector<Timed> timed(walk_.cameras.size() * methods_.size());
    for (int pass = 0; pass < walk_.n_passes; ++pass) {
      cut();
      for (std::size_t i = 0; i < walk_.cameras.size(); ++i) {
        const techniques::View view = view_at(i);
        for (std::size_t k = 0; k < methods_.size(); ++k) {
          const std::size_t m = (k + i + std::size_t(pass)) % methods_.size();
          const PreparedMethod::Times t = methods_[m]->draw(view, image_, kSky);
          Timed& to = timed[i * methods_.size() + m];
          to.technique.push_back(t.technique_ms), to.render.push_back(t.render_ms), to.frame.push_back(t.frame_ms());
        }
        on_step();
      }
    }
    for (std::size_t i = 0; i < walk_.cameras.size() && walk_.n_passes > 0; ++i) {
      for (std::size_t m = 0; m < methods_.size(); ++m) {
        const Timed& t = timed[i * methods_.size() + m];
        Row row = named_row(i, *methods_[m]);
        row.add("technique_ms", median(t.technique)).add("render_ms", median(t.render));
        row.add("frame_ms", median(t.frame));
        result.times.push_back(std::move(row));
      }
    }
  }

 private:
  void cut() {
    for (PreparedMethod* method : methods_) method->cut();
  }

  [[nodiscard]] techniques::View view_at(std::size_t i) const {
    return {.camera = walk_.cameras[i], .size_px = walk_.size_px, .background = kSky};
  }

  [[nodiscard]] std::size_t steady_begin() const {
    const std::size_t n = walk_.cameras.size(), steady = std::size_t(walk_.n_steady);
    return n > steady ? (n - steady) / 2 : 0;
  }

  /// Not the first frame, in which all pictures are new.
  [[nodiscard]] std::size_t first_compared() const { return std::size_t(walk_.error_every) / 2; }

  [[nodiscard]] Row named_row(std::size_t i, const PreparedMethod& method) const {
    Row row;
    row.add("scene", walk_.scene).add("path", walk_.path).add("frame", std::int64_t(walk_.frames[i]));
    row.add("method", method.method().name);
    return row;
  }

  [[nodiscard]] Row work_row(std::size_t i, const PreparedMethod& method) const {
    Row row = named_row(i, method);
    for (const techniques::Counter& counter : method.counters()) row.add(counter.name, std::int64_t(counter.value));
    const techniques::StageWork& work = method.stage().work();
    row.add("plates", std::int64_t(work.plates)).add("captures", std::int64_t(work.captures));
    row.add("captured_px", std::int64_t(work.captured_px)).add("objects", std::int64_t(work.objects));
    row.add("primitives", std::int64_t(work.primitives));
    row.add("triangles_in", std::int64_t(method.work().triangles_in));
    row.add("fragments_shaded", std::int64_t(method.work().fragments_shaded));
    row.add("texels_read", std::int64_t(method.work().texels_read));
    return row;
  }

  void add_errors(const Bytes& reference, const Bytes& shown, const PreparedMethod& method,
                  const techniques::View& view, Row& row) const {
    const Displacement moved = displacement(world_, method.stage(), view);
    if (moved.n > 0) row.add("displacement_px", moved.mean_px()).add("displacement_max_px", moved.max_px);
    const PicturePair pair{walk_.size_px, reference, shown};
    const bool same = reference == shown;
    row.add("flip", same ? 0.0 : mean_error(flip_map(pair, {.threads = threads_}).errors));
    if (const auto db = psnr(pixel_difference(pair))) row.add("psnr_db", *db);
    if (const auto similarity = same ? 1.0 : ssim(pair)) row.add("ssim", *similarity);
  }

  static void add_popping(const FramePairs& frames, Row& row) {
    const Popping pop = popping(frames);
    row.add("pop", pop.mean).add("pop_p99", pop.p99);
  }

  const Walk& walk_;
  const techniques::World& world_;
  std::span<PreparedMethod* const> methods_;
  int threads_;
  raster::Image image_;
};

}  // namespace

CaseResult run_walk(const Walk& walk, const techniques::World& world, std::span<PreparedMethod* const> methods,
                    int threads, const std::function<void()>& on_step) {
  CaseResult result;
  WalkRunner runner(walk, world, methods, threads);
  runner.add_results(on_step, result);
  runner.add_times(on_step, result);
  return result;
}

}  // namespace lode::experiments
