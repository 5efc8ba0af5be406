// Distances to boxes, spheres, capsules and convex bodies, where they stand and as they are turned.
#include "PostProcessVolumeShape.h"

#include "Math/ToInteger.h"
#include "PostProcessVolumeHull.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace Drydock
{

namespace
{

/** Sine and cosine, exact at right angles, so that a box turned by 90 degrees has its faces where they belong. */
struct FSineCosine
{
	double Sine = 0.0;
	double Cosine = 1.0;

	explicit FSineCosine(double Degrees)
	{
		const double Turn = std::fmod(Degrees, 360.0);
		if (std::fmod(Turn, 90.0) != 0.0)
		{
			Sine = std::sin(FMath::DegreesToRadians(Turn));
			Cosine = std::cos(FMath::DegreesToRadians(Turn));
			return;
		}
		constexpr double Sines[] = {0.0, 1.0, 0.0, -1.0};
		const int Quarter = (ToInteger<int>(Turn / 90.0) + 4) % 4;
		Sine = Sines[Quarter];
		Cosine = Sines[(Quarter + 1) % 4];
	}
};

} // namespace

FVolumeShape FVolumeShape::MakeBox(const FVector& Center, const FVector& Extent, const FRotator& Rotation)
{
	FVolumeShape Shape;
	Shape.Type = EVolumeShape::Box;
	Shape.Center = Center;
	Shape.Extent = Extent;
	Shape.SetRotation(Rotation);
	return Shape;
}

FVolumeShape FVolumeShape::MakeSphere(const FVector& Center, double Radius)
{
	FVolumeShape Shape;
	Shape.Type = EVolumeShape::Sphere;
	Shape.Center = Center;
	Shape.Radius = Radius;
	return Shape;
}

FVolumeShape FVolumeShape::MakeCapsule(
	const FVector& Center, double Radius, double HalfHeight, const FRotator& Rotation)
{
	FVolumeShape Shape = MakeSphere(Center, Radius);
	Shape.Type = EVolumeShape::Capsule;
	Shape.Extent.Z = std::max(HalfHeight - Radius, 0.0);
	Shape.SetRotation(Rotation);
	return Shape;
}

FVolumeShape FVolumeShape::MakeConvex(std::vector<FVector> Points)
{
	FVolumeShape Shape;
	Shape.Type = EVolumeShape::Convex;
	Shape.Points = std::move(Points);
	return Shape;
}

void FVolumeShape::SetRotation(const FRotator& Rotation)
{
	const FSineCosine P(Rotation.Pitch);
	const FSineCosine Y(Rotation.Yaw);
	const FSineCosine R(Rotation.Roll);
	Axes[0] = FVector(P.Cosine * Y.Cosine, P.Cosine * Y.Sine, P.Sine);
	Axes[1] = FVector(R.Sine * P.Sine * Y.Cosine - R.Cosine * Y.Sine, R.Sine * P.Sine * Y.Sine + R.Cosine * Y.Cosine,
		-R.Sine * P.Cosine);
	Axes[2] = FVector(-(R.Cosine * P.Sine * Y.Cosine + R.Sine * Y.Sine), Y.Cosine * R.Sine - R.Cosine * P.Sine * Y.Sine,
		R.Cosine * P.Cosine);
}

double FVolumeShape::GetDistance(const FVector& Point) const
{
	if (Type == EVolumeShape::Convex)
	{
		return GetDistanceToHull(Points, Point);
	}
	// Box, sphere and capsule are one: a box with a round border.
	const FVector Offset = Point - Center;
	double Outside[3];
	double Scale = Radius;
	for (int Axis = 0; Axis < 3; ++Axis)
	{
		const double Along = std::fabs(Offset.X * Axes[Axis].X + Offset.Y * Axes[Axis].Y + Offset.Z * Axes[Axis].Z);
		Outside[Axis] = std::max(Along - Extent[Axis], 0.0);
		Scale = std::max(Scale, Along);
	}
	const double Distance = std::hypot(Outside[0], Outside[1], Outside[2]) - Radius;
	return Distance <= 4.0 * std::numeric_limits<double>::epsilon() * Scale ? 0.0 : Distance;
}

} // namespace Drydock
