// Finds the nearest point of a convex hull. Source: the paper named in the header.
#include "PostProcessVolumeHull.h"
#include "RangeTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace Drydock
{

namespace
{

// The nearest point is far smaller than the corners it is summed from where Point lies close to a large hull; what is
// lost there is won back beforehand.
using FReal = long double;

/** Relative to the farthest corner: distances below this are rounding. */
constexpr FReal RoundingError = 8.0 * std::numeric_limits<double>::epsilon();
/** Rounding of one step. */
constexpr FReal StepError = 8.0 * std::numeric_limits<FReal>::epsilon();

struct FWide
{
	FReal X = 0.0;
	FReal Y = 0.0;
	FReal Z = 0.0;

	FWide operator+(const FWide& B) const { return {X + B.X, Y + B.Y, Z + B.Z}; }
	FWide operator-(const FWide& B) const { return {X - B.X, Y - B.Y, Z - B.Z}; }
	FWide operator-() const { return {-X, -Y, -Z}; }
	FWide operator*(FReal Factor) const { return {X * Factor, Y * Factor, Z * Factor}; }
};

FReal Dot(const FWide& A, const FWide& B)
{
	return A.X * B.X + A.Y * B.Y + A.Z * B.Z;
}

FWide Cross(const FWide& A, const FWide& B)
{
	return {A.Y * B.Z - A.Z * B.Y, A.Z * B.X - A.X * B.Z, A.X * B.Y - A.Y * B.X};
}

/** At most four points of the hull, and the point of their own hull that is nearest to the origin. */
struct FSimplex
{
	std::array<FWide, 4> Points;
	int Num = 0;
	FWide Nearest;
	FReal DistanceSquared = std::numeric_limits<FReal>::infinity();
};

/** Weights of A, B, ... in the point nearest to the origin of the line, plane or space they span; false where that
 * point does not lie strictly inside them, or they span less than they should. */
bool FindWeights(const std::array<FWide, 4>& P, int Num, std::array<FReal, 4>& Weights)
{
	const FWide ToOrigin = -P[0];
	const FWide E1 = Num > 1 ? P[1] - P[0] : FWide();
	const FWide E2 = Num > 2 ? P[2] - P[0] : FWide();
	FReal Size = 1.0;
	Weights = {0.0, 0.0, 0.0, 0.0};
	switch (Num)
	{
	case 1:
		break;
	case 2:
		Size = Dot(E1, E1);
		Weights[1] = Dot(ToOrigin, E1);
		break;
	case 3:
	{
		const FWide Normal = Cross(E1, E2);
		Size = Dot(Normal, Normal);
		Weights[1] = Dot(Cross(ToOrigin, E2), Normal);
		Weights[2] = Dot(Cross(E1, ToOrigin), Normal);
		break;
	}
	default:
	{
		const FWide E3 = P[3] - P[0];
		Size = Dot(E1, Cross(E2, E3));
		Weights[1] = Dot(ToOrigin, Cross(E2, E3));
		Weights[2] = Dot(E1, Cross(ToOrigin, E3));
		Weights[3] = Dot(E1, Cross(E2, ToOrigin));
		break;
	}
	}
	if (Size == 0.0)
	{
		return false;
	}
	Weights[0] = 1.0;
	for (size_t Index = 1; Index < static_cast<size_t>(Num); ++Index)
	{
		Weights[Index] /= Size;
		Weights[0] -= Weights[Index];
	}
	return std::all_of(Weights.begin(), Weights.begin() + Num, [](FReal Weight) { return Weight > 0.0; });
}

/** The point of those weights; exactly the origin for four corners around it. A plane's normal has the right direction
 * even where the point is near the origin and a sum of corners would be all rounding. */
FWide FindNearest(const FSimplex& Simplex, const std::array<FReal, 4>& Weights)
{
	const std::array<FWide, 4>& P = Simplex.Points;
	if (Simplex.Num == 3)
	{
		const FWide Normal = Cross(P[1] - P[0], P[2] - P[0]);
		return Normal * (Dot(P[0], Normal) / Dot(Normal, Normal));
	}
	FWide Nearest;
	for (size_t Index = 0; Simplex.Num < 4 && Index < static_cast<size_t>(Simplex.Num); ++Index)
	{
		Nearest = Nearest + P[Index] * Weights[Index];
	}
	return Nearest;
}

/** Reduces the simplex to the corners that carry its nearest point. */
FSimplex Reduce(const FSimplex& Simplex)
{
	FSimplex Best;
	for (int Wanted = 1; Wanted <= Simplex.Num; ++Wanted)
	{
		for (unsigned Subset = 1; Subset < (1u << Simplex.Num); ++Subset)
		{
			FSimplex Part;
			for (int Index = 0; Index < Simplex.Num; ++Index)
			{
				if (Subset & (1u << Index))
				{
					Part.Points[static_cast<size_t>(Part.Num++)] = Simplex.Points[static_cast<size_t>(Index)];
				}
			}
			std::array<FReal, 4> Weights;
			if (Part.Num != Wanted || !FindWeights(Part.Points, Part.Num, Weights))
			{
				continue;
			}
			Part.Nearest = FindNearest(Part, Weights);
			Part.DistanceSquared = Dot(Part.Nearest, Part.Nearest);
			if (Part.DistanceSquared < Best.DistanceSquared)
			{
				Best = Part;
			}
		}
	}
	return Best;
}

/** The corner that lies farthest against Direction. */
const FWide& FindSupport(const std::vector<FWide>& Corners, const FWide& Direction)
{
	const FWide* Found = &Corners.front();
	FReal Least = Dot(*Found, Direction);
	for (const FWide& Corner : Corners)
	{
		const FReal Along = Dot(Corner, Direction);
		if (Along < Least)
		{
			Least = Along;
			Found = &Corner;
		}
	}
	return *Found;
}

/** Distance of the origin; corners of a size around 1. */
FReal FindDistance(const std::vector<FWide>& Corners)
{
	FSimplex Simplex;
	Simplex.Points[0] = Corners.front();
	Simplex.Num = 1;
	Simplex = Reduce(Simplex);
	const size_t MaxSteps = 64 + 8 * Corners.size(); // ends long before, but for rounding that goes in circles
	for (size_t Step = 0; Step < MaxSteps; ++Step)
	{
		const FWide& Support = FindSupport(Corners, Simplex.Nearest);
		const FReal Gap = Simplex.DistanceSquared - Dot(Simplex.Nearest, Support);
		if (Gap <= StepError * std::sqrt(Simplex.DistanceSquared) || Simplex.Num == 4)
		{
			break; // no corner lies beyond the plane through the nearest point, or the origin is inside
		}
		FSimplex Grown = Simplex;
		Grown.Points[static_cast<size_t>(Grown.Num++)] = Support;
		Grown = Reduce(Grown);
		if (!(Grown.DistanceSquared < Simplex.DistanceSquared))
		{
			// The corners lie too close to a line or plane for their weights. The nearest point is itself a point of
			// the hull: go on from there.
			Grown.Points = {Simplex.Nearest, Support};
			Grown.Num = 2;
			Grown = Reduce(Grown);
			if (!(Grown.DistanceSquared < Simplex.DistanceSquared))
			{
				break;
			}
		}
		Simplex = Grown;
	}
	return std::sqrt(Simplex.DistanceSquared);
}

} // namespace

double GetDistanceToHull(const std::vector<FVector>& Corners, const FVector& Point)
{
	double Scale = 0.0;
	for (const FVector& Corner : Corners)
	{
		const FVector Offset = Corner - Point;
		Scale = std::max({Scale, std::fabs(Offset.X), std::fabs(Offset.Y), std::fabs(Offset.Z)});
	}
	if (Corners.empty() || Scale == 0.0)
	{
		return Corners.empty() ? std::numeric_limits<double>::infinity() : 0.0;
	}
	const FWide WidePoint = {Point.X, Point.Y, Point.Z};
	auto Offsets = ToVector<FWide>(Corners,
		[&](const FVector& Corner) {
			return (FWide{Corner.X, Corner.Y, Corner.Z} - WidePoint) * (FReal(1.0) / Scale);
		});
	const FReal Distance = FindDistance(Offsets);
	return Distance <= RoundingError ? 0.0 : static_cast<double>(Distance * Scale);
}

} // namespace Drydock
