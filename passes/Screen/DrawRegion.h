// Confines a full-screen pass to the part that a mask's pixels can reach. Pixels outside are copied or left as they
// are. All rects count from the corner of the view's rect until they are drawn.
#pragma once

#include "CoreMinimal.h"
#include "Math/ToInteger.h"

#include <cmath>

namespace Drydock
{

/** Larger by so many texels on each side. */
inline FIntRect GrowRect(const FIntRect& Rect, int32 X, int32 Y)
{
	return FIntRect(Rect.Min.X - X, Rect.Min.Y - Y, Rect.Max.X + X, Rect.Max.Y + Y);
}

/** Scales a rect from a picture of size From to the same picture at size To, rounded outwards. */
inline FIntRect ScaleRectOutward(const FIntRect& Rect, FIntPoint From, FIntPoint To)
{
	const auto Down = [](int32 Value, int32 FromSide, int32 ToSide)
	{
		return ToInteger<int32>(std::floor(static_cast<double>(Value) * ToSide / FromSide));
	};
	const auto Up = [](int32 Value, int32 FromSide, int32 ToSide)
	{
		return ToInteger<int32>(std::ceil(static_cast<double>(Value) * ToSide / FromSide));
	};
	return FIntRect(Down(Rect.Min.X, From.X, To.X), Down(Rect.Min.Y, From.Y, To.Y), Up(Rect.Max.X, From.X, To.X),
		Up(Rect.Max.Y, From.Y, To.Y));
}

/** Moves a rect into the texture that holds the view in ViewRect, and cuts it to ViewRect. */
inline FIntRect PlaceRect(const FIntRect& Rect, const FIntRect& ViewRect)
{
	FIntRect Placed = Rect + ViewRect.Min;
	Placed.Clip(ViewRect);
	return Placed;
}

} // namespace Drydock
