#pragma once
/// Micro benchmarks of the rasterizer, from a sample up to a frame. Times are of one machine; what the work was is in
/// the counters: items_per_second are what the benchmark's comment counts.

namespace lode::bench {

/// Filters, blending and sRGB, one sample at a time, as the reference pipeline does them.
void register_samples();
/// The fast pipeline's kernels for each instruction set that this processor has, and cutting a mesh into clusters.
void register_kernels();
void register_shading();
/// Frames of both pipelines: clear, triangles of one size, filters, layers, and the determinism pictures.
void register_frames();

}  // namespace lode::bench
