#pragma once
/// How far each method's picture of a view is from the true picture, beside how far it is from the picture of
/// everything. A picture of one sample a pixel has an error of its own: edges have steps, and what is smaller than a
/// pixel is there or not. Only what a method adds to that error is its doing.

#include <string_view>

#include "experiments/harness/culling_case.h"

namespace lode::experiments {

/// Adds to the rows of the case's results that belong to one of its views, for each method:
///   flip_true, psnr_true_db      against the true picture (true_picture.h): mean of FLIP's errors, and PSNR in dB
///   flip_whole, psnr_whole_db    against the picture of everything; no PSNR of pictures that are the same to the byte
/// All over the sky, of bytes as a screen shows them. Deterministic.
///   i        the view: index in the case's cameras
///   look     of the world's scene (look_hash_of)
///   methods  those of the case, prepared on `world`
void add_true_errors(const CullingCase& one, std::size_t i, const techniques::World& world, std::string_view look,
                     std::span<PreparedMethod* const> methods, const KeptResults& kept,
                     const raster::RenderOptions& options, CaseResult& result);

}  // namespace lode::experiments
