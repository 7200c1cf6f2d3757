// How far a picture may be from its golden, by renderer.
#pragma once

#include <string_view>

namespace golden {

struct Tolerance {
    int channel = 0;   ///< Largest difference of a byte that is none.
    double share = 0;  ///< Of pixels that may differ by more.
};

/// `renderer`: as OpenGL names itself.
[[nodiscard]] inline Tolerance tolerance(std::string_view renderer) {
    // The goldens' own renderer. Its shaders are compiled for the machine's vector unit: fused or separate products,
    // and powers, sines and arc tangents by polynomials, move a color by one step at most before and one after the
    // mean of samples. A sample that lies within such an error of an edge goes to either side: with 4 samples in 96 x
    // 96 pixels and some 2000 pixels along edges, 0.3 % leaves room for 27.
    if (renderer.find("llvmpipe") != std::string_view::npos) {
        return {2, 0.003};
    }
    // Other rasterizers place vertices on their own grid of 1/256 pixel. A sample of a pixel on an edge changes sides
    // with a probability of about 1/256 per edge and sample, so that of 2000 pixels with 4 samples some 30 to 60
    // differ; a sketch's thresholds of grain double that.
    return {4, 0.015};
}

}  // namespace golden
