#include "experiments/truth/check_picture.h"

#include <algorithm>
#include <cstdio>
#include <optional>

#include "experiments/truth/blockers.h"
#include "experiments/truth/triangle_table.h"
#include "raster/parallel.h"

namespace lode::experiments::truth {
namespace {

constexpr raster::Ids kNothing{raster::kNoId, raster::kNoId};

std::string name_of(raster::Ids ids) {
  if (ids == kNothing) return "nothing";
  return "draw " + std::to_string(ids.draw) + " primitive " + std::to_string(ids.primitive);
}

std::string text_of(const char* format, double a, double b, double c) {
  char text[160];
  std::snprintf(text, sizeof text, format, a, b, c);
  return text;
}

/// What is known of a pixel once its own two triangles have been judged.
struct PixelJudgement {
  Verdict verdict = Verdict::same;  ///< of a pixel that differs: the explanation, should the answer be possible
  std::string why;                  ///< not empty: the answer is not possible
};

/// Why the triangle cannot have given this depth here; empty if it can.
std::string objection(const std::optional<Judgement>& judgement, raster::Ids ids, float depth) {
  if (!judgement) return "there is no " + name_of(ids);
  if (judgement->coverage == Coverage::out) return name_of(ids) + " does not cover it in any placement";
  if (judgement->depth.contains(depth)) return {};
  return name_of(ids) +
         text_of(" has depths %.9g to %.9g there, not %.9g", judgement->depth.low, judgement->depth.high, depth);
}

/// Of a possible answer (see the header): the first explanation that holds.
Verdict explanation(const std::optional<Judgement>& raster, const std::optional<Judgement>& rays) {
  const auto doubts = [&](Doubt doubt) { return (raster && raster->doubt == doubt) || (rays && rays->doubt == doubt); };
  if (doubts(Doubt::outline)) return Verdict::edge;
  const bool both = raster && rays && raster->coverage != Coverage::out && rays->coverage != Coverage::out;
  if (both && raster->depth.overlaps(rays->depth)) return Verdict::depth_tie;
  return doubts(Doubt::cut) ? Verdict::range : Verdict::embree;
}

class Checker {
 public:
  Checker(const PicturePair& pair, int threads) : pair_(pair), threads_(threads), table_(pair.draws, pair.size_px) {}

  PictureCheck run(const std::function<void()>& on_step) {
    const std::size_t n = std::size_t(pair_.size_px.x) * std::size_t(pair_.size_px.y);
    check_.verdicts.assign(n, Verdict::same);
    why_.resize(std::size_t(pair_.size_px.y));
    judge_rows(on_step);
    block(on_step);
    count();
    return std::move(check_);
  }

 private:
  struct Objection {
    int x = 0;
    std::string why;
  };

  std::size_t at(glm::ivec2 px) const { return std::size_t(px.y) * std::size_t(pair_.size_px.x) + std::size_t(px.x); }

  void judge_rows(const std::function<void()>& on_step) {
    const int n_workers = raster::worker_count(threads_);
    std::vector<PreparedCache> caches(static_cast<std::size_t>(n_workers), PreparedCache(table_));
    raster::parallel_for(std::size_t(pair_.size_px.y), n_workers, [&](std::size_t y, int worker) {
      for (int x = 0; x < pair_.size_px.x; ++x) {
        const glm::ivec2 px(x, int(y));
        PixelJudgement pixel = judge_pixel(px, caches[std::size_t(worker)]);
        if (!pixel.why.empty()) {
          why_[y].push_back({x, std::move(pixel.why)});
          pixel.verdict = Verdict::unexplained;
        }
        check_.verdicts[at(px)] = pixel.verdict;
      }
      if (on_step) on_step();
    });
  }

  PixelJudgement judge_pixel(glm::ivec2 px, PreparedCache& cache) const {
    const raster::Ids ours = pair_.raster_ids[at(px)], rays = pair_.ray_ids[at(px)];
    const float depth = pair_.raster_depth[at(px)];
    const glm::dvec2 sample = glm::dvec2(px) + 0.5;
    if (ours == rays) {
      if (ours == kNothing) return {Verdict::same, depth == 0.0f ? "" : text_of("nothing has depth %.9g", depth, 0, 0)};
      const PreparedTriangle* const t = cache.find(ours);
      if (t && judge_coverage(*t, sample).coverage != Coverage::out && surely_has_depth(*t, sample, depth)) return {};
      return {Verdict::same, objection(judgement_of(ours, sample, cache), ours, depth)};
    }
    const std::optional<Judgement> of_ours = judgement_of(ours, sample, cache);
    const std::optional<Judgement> of_rays = judgement_of(rays, sample, cache);
    PixelJudgement pixel{explanation(of_ours, of_rays), {}};
    if (ours != kNothing) pixel.why = objection(of_ours, ours, depth);
    return pixel;
  }

  static std::optional<Judgement> judgement_of(raster::Ids ids, glm::dvec2 sample, PreparedCache& cache) {
    const PreparedTriangle* const t = cache.find(ids);
    if (!t) return std::nullopt;
    return judge(*t, sample);
  }

  /// Explained so far, but what must have won there is another triangle.
  void block(const std::function<void()>& on_step) {
    std::vector<Answer> answers;
    for (int y = 0; y < pair_.size_px.y; ++y) {
      for (int x = 0; x < pair_.size_px.x; ++x) {
        const std::size_t i = at({x, y});
        const Verdict verdict = check_.verdicts[i];
        if (verdict == Verdict::same || verdict == Verdict::unexplained) continue;
        answers.push_back({{x, y}, pair_.raster_ids[i], pair_.raster_depth[i]});
      }
    }
    const std::vector<raster::Ids> blockers = find_blockers(table_, pair_.size_px, answers, threads_, on_step);
    for (std::size_t k = 0; k < answers.size(); ++k) {
      const glm::ivec2 px = answers[k].px;
      if (blockers[k] == kNothing) {
        if (check_.verdicts[at(px)] == Verdict::edge && on_edge_line(px)) ++check_.on_edge_line;
        continue;
      }
      check_.verdicts[at(px)] = Verdict::unexplained;
      why_[std::size_t(px.y)].push_back(
          {px.x, name_of(blockers[k]) + " covers it in every placement" +
                     (answers[k].ids == kNothing
                          ? ""
                          : text_of(", nearer than %.9g or the same with lower ids", answers[k].depth, 0, 0))});
    }
  }

  bool on_edge_line(glm::ivec2 px) const {
    for (const raster::Ids ids : {pair_.raster_ids[at(px)], pair_.ray_ids[at(px)]}) {
      const std::optional<SourceTriangle> source = table_.find(ids);
      if (source && exact_sample(*source, pair_.size_px, glm::dvec2(px) + 0.5).on_outline) return true;
    }
    return false;
  }

  void count() {
    for (const Verdict verdict : check_.verdicts) ++check_.pixels[std::size_t(verdict)];
    for (int y = 0; y < pair_.size_px.y; ++y) {
      std::vector<Objection>& row = why_[std::size_t(y)];
      std::sort(row.begin(), row.end(), [](const Objection& a, const Objection& b) { return a.x < b.x; });
      for (Objection& o : row) {
        if (check_.examples.size() == kMaxExamples) return;
        const std::size_t i = at({o.x, y});
        check_.examples.push_back(
            {{o.x, y}, pair_.raster_ids[i], pair_.ray_ids[i], pair_.raster_depth[i], std::move(o.why)});
      }
    }
  }

  const PicturePair& pair_;
  int threads_;
  TriangleTable table_;
  PictureCheck check_;
  std::vector<std::vector<Objection>> why_;  ///< [rows]
};

}  // namespace

const char* verdict_name(Verdict verdict) {
  constexpr const char* kNames[kVerdicts] = {"same", "edge", "depth_tie", "range", "embree", "unexplained"};
  return kNames[std::size_t(verdict)];
}

std::uint64_t PictureCheck::different() const {
  std::uint64_t n = 0;
  for (std::size_t v = 1; v < kVerdicts; ++v) n += pixels[v];
  return n;
}

std::size_t check_steps(const PicturePair& pair) {
  return std::size_t(pair.size_px.y) + blocker_steps(TriangleTable(pair.draws, pair.size_px));
}

PictureCheck check_picture(const PicturePair& pair, int threads, const std::function<void()>& on_step) {
  return Checker(pair, threads).run(on_step);
}

}  // namespace lode::experiments::truth
