// Pictures of flat polygons that are known exactly: what a point shows, and the mean colour of a pixel by area. A
// sequence of them has an exact truth at any sub-pixel offset.
#pragma once

#include "CoreMinimal.h"

#include <vector>

namespace Drydock
{

/** A place and a turn in the picture: pixels, x right, y down; radians, from x towards y. */
struct FPose
{
	FVector2D Center = FVector2D(0.0, 0.0);
	double Angle = 0.0;
};

/** A convex polygon of one colour that faces the camera. */
struct FAnalyticShape
{
	std::vector<FVector2D> Corners; // about its own centre, in order; three at least
	FPose Pose;
	FPose PoseBefore; // in the frame before
	FLinearColor Color = FLinearColor(0.0f, 0.0f, 0.0f, 1.0f);
	double Depth = 1.0; // metres, above 0
	int ShadingModel = 1;
	float CustomMask = 0.0f;
};

/** The scene of one frame. */
struct FAnalyticFrame
{
	FIntPoint Size = FIntPoint(1, 1);   // pixels
	FAnalyticShape Background;          // everywhere; its corners and poses are of no account
	std::vector<FAnalyticShape> Shapes; // from the front to the back
};

/** Pixels from where the shape's point at Point was in the frame before. */
DRYDOCK_API FVector2D GetMovement(const FAnalyticShape& Shape, FVector2D Point);

/** A frame whose shapes are placed: made once, and asked for every pixel. */
class DRYDOCK_API FAnalyticPicture
{
public:
	/** The frame must outlive it. */
	explicit FAnalyticPicture(const FAnalyticFrame& InFrame);

	/** The first shape that holds a point of the picture, or the background. */
	const FAnalyticShape& FindShape(FVector2D Point) const;

	/** The mean colour of the pixel whose upper left corner is (X, Y): each shape by the area that is seen of it. */
	FLinearColor ComputeMean(int X, int Y) const;

private:
	/** Corners in the picture, in the order in which their inner side counts above 0; and the box around them. */
	struct FPlaced
	{
		std::vector<FVector2D> Corners;
		FVector2D Min;
		FVector2D Max;
	};

	const FAnalyticFrame& Frame;
	std::vector<FPlaced> Placed; // by shape
};

} // namespace Drydock
