// Resamples channels to the resolution of the scene textures.
#include "SceneFile/SceneResolution.h"

#include "Math/ToInteger.h"

#include <algorithm>
#include <cmath>

namespace Drydock
{

namespace
{

/** A percentage that is not exact in binary must not round one pixel too far up. */
int ScaleEdge(int Edge, double Percentage)
{
	return ToInteger<int>(std::ceil(Edge * Percentage / 100.0 - 1e-9));
}

} // namespace

FIntRect ScaleRect(const FIntRect& Rect, double Percentage)
{
	FIntRect Scaled(ScaleEdge(Rect.Min.X, Percentage), ScaleEdge(Rect.Min.Y, Percentage),
		ScaleEdge(Rect.Max.X, Percentage), ScaleEdge(Rect.Max.Y, Percentage));
	// A pixel before the edge, so that a rect stays inside of one that it lies in.
	Scaled.Min.X = std::max(std::min(Scaled.Min.X, Scaled.Max.X - 1), 0);
	Scaled.Min.Y = std::max(std::min(Scaled.Min.Y, Scaled.Max.Y - 1), 0);
	Scaled.Max.X = std::max(Scaled.Max.X, Scaled.Min.X + 1);
	Scaled.Max.Y = std::max(Scaled.Max.Y, Scaled.Min.Y + 1);
	return Scaled;
}

FCoverage MakeCoverage(int SourceSize, int TargetSize, int Index)
{
	// In units of 1 / TargetSize source pixels everything is a whole number.
	const long long Begin = static_cast<long long>(Index) * SourceSize;
	const long long End = Begin + SourceSize;
	FCoverage Coverage;
	Coverage.First = static_cast<int>(Begin / TargetSize);
	for (long long Pixel = Coverage.First; Pixel * TargetSize < End; ++Pixel)
	{
		const long long Covered = std::min(End, (Pixel + 1) * TargetSize) - std::max(Begin, Pixel * TargetSize);
		Coverage.Parts.push_back(static_cast<double>(Covered) / SourceSize);
	}
	return Coverage;
}

int FindCenterPixel(int SourceSize, int TargetSize, int Index)
{
	return static_cast<int>((2LL * Index + 1) * SourceSize / (2LL * TargetSize));
}

} // namespace Drydock
