// Shapes of bounded volumes, and how far a point is from them. In the engine a brush has a shape.
#pragma once

#include "CoreMinimal.h"

#include <vector>

namespace Drydock
{

enum class EVolumeShape : uint8
{
	Box,
	Sphere,
	Capsule,
	Convex,
};

/** A solid in the engine's world: cm, left-handed, Z up; rotations turn about the centre. A new object is a box without
 * size at the origin. */
class DRYDOCK_API FVolumeShape
{
public:
	FVolumeShape() = default;

	/** Extent: half sizes, 0 and more. */
	static FVolumeShape MakeBox(
		const FVector& Center, const FVector& Extent, const FRotator& Rotation = FRotator(0.0, 0.0, 0.0));
	static FVolumeShape MakeSphere(const FVector& Center, double Radius);
	/** Upright where it is not rotated. HalfHeight: caps included; below Radius it is a sphere, as in the engine. */
	static FVolumeShape MakeCapsule(
		const FVector& Center, double Radius, double HalfHeight, const FRotator& Rotation = FRotator(0.0, 0.0, 0.0));
	/** The hull of the points; any number above 0, in any position. */
	static FVolumeShape MakeConvex(std::vector<FVector> Points);

	EVolumeShape GetType() const { return Type; }

	/** Distance to the nearest point of the solid, cm: 0 inside, exact but for rounding; a distance below rounding is
	 * 0. */
	double GetDistance(const FVector& Point) const;

private:
	void SetRotation(const FRotator& Rotation);

	EVolumeShape Type = EVolumeShape::Box;
	FVector Center = FVector(0.0, 0.0, 0.0);
	FVector Axes[3] = {FVector(1.0, 0.0, 0.0), FVector(0.0, 1.0, 0.0), FVector(0.0, 0.0, 1.0)}; // forward, right, up
	FVector Extent = FVector(0.0, 0.0, 0.0); // capsule: of the segment inside
	double Radius = 0.0;
	std::vector<FVector> Points;
};

} // namespace Drydock
