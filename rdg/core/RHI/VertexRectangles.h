// Finds what a draw's vertices cover: triangles of clip-space positions become rectangles of pixels, their TEXCOORDs
// functions of the pixel. Plain geometry, no state. Source of the rules: Direct3D 11 functional specification,
// "Rasterization" (viewport, snapping to 1/256 pixel, the top-left rule by pixel centres).
#pragma once

#include "Math/IntRect.h"
#include "VertexProgram.h"

#include <cstdint>
#include <string>
#include <vector>

namespace Drydock
{

/** Pixels and what a pixel shader finds there. */
struct FDrawnRectangle
{
	FIntRect Rect; // within the bounds
	std::vector<FKernelInterpolant> Interpolants;
};

struct FDrawnRectangles
{
	std::vector<FDrawnRectangle> Rectangles; // in the order of the triangles
	std::string Fault;                       // why the triangles are not drawn; empty: they are
};

/** Vertices: three for each triangle. Viewport: pixels that clip space -1..1 spans, y down; Bounds: pixels that may be
 * drawn. Two triangles that follow each other and make an axis-aligned rectangle over which the TEXCOORDs run evenly
 * are one rectangle. Any other triangle is rows of pixels. Triangles without area are left out. NumTexCoords:
 * interpolants of each rectangle. Integers: bit n where interpolant n is of integers, which must be the same at all
 * vertices. Named: FShaderReflection::NamedInterpolants of the pixel shader, for faults. */
DRYDOCK_API FDrawnRectangles FindDrawnRectangles(const std::vector<FVertexOutput>& Vertices, const FIntRect& Viewport,
	const FIntRect& Bounds, int32_t NumTexCoords, uint32_t Integers = 0, const std::vector<std::string>& Named = {});

} // namespace Drydock
