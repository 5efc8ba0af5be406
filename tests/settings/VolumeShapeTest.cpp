// Distance to the shapes of bounded volumes. Expected values: by hand, and by brute force in long double.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "PostProcessVolumeHull.h"
#include "PostProcessVolumeShape.h"

#include <algorithm>
#include <cmath>

using namespace Drydock;

namespace
{

const FVector Origin(0.0, 0.0, 0.0);

struct FWide
{
	long double X = 0, Y = 0, Z = 0;
};

FWide Widen(const FVector& V)
{
	return {V.X, V.Y, V.Z};
}

FWide operator-(const FWide& A, const FWide& B)
{
	return {A.X - B.X, A.Y - B.Y, A.Z - B.Z};
}

long double Dot(const FWide& A, const FWide& B)
{
	return A.X * B.X + A.Y * B.Y + A.Z * B.Z;
}

long double Length(const FWide& A)
{
	return std::sqrt(Dot(A, A));
}

FWide Cross(const FWide& A, const FWide& B)
{
	return {A.Y * B.Z - A.Z * B.Y, A.Z * B.X - A.X * B.Z, A.X * B.Y - A.Y * B.X};
}

long double DistanceToSegment(const FWide& P, const FWide& A, const FWide& B)
{
	const FWide Along = B - A;
	const long double Size = Dot(Along, Along);
	const long double T = Size == 0 ? 0 : std::clamp(Dot(P - A, Along) / Size, 0.0L, 1.0L);
	return Length(P - FWide{A.X + T * Along.X, A.Y + T * Along.Y, A.Z + T * Along.Z});
}

/** Of the plane where P lies above the triangle, else of its sides. */
long double DistanceToTriangle(const FWide& P, const FWide& A, const FWide& B, const FWide& C)
{
	const FWide Normal = Cross(B - A, C - A);
	const bool bAbove = Dot(Cross(B - A, P - A), Normal) >= 0 && Dot(Cross(C - B, P - B), Normal) >= 0 &&
						Dot(Cross(A - C, P - C), Normal) >= 0;
	const long double Sides =
		std::min({DistanceToSegment(P, A, B), DistanceToSegment(P, B, C), DistanceToSegment(P, C, A)});
	return Dot(Normal, Normal) > 0 && bAbove ? std::min(Sides, std::fabs(Dot(P - A, Normal)) / Length(Normal)) : Sides;
}

bool IsInTetrahedron(const FWide& P, const FWide& A, const FWide& B, const FWide& C, const FWide& D)
{
	const auto Volume = [](const FWide& E, const FWide& F, const FWide& G, const FWide& H)
	{
		return Dot(Cross(F - E, G - E), H - E);
	};
	const long double Whole = Volume(A, B, C, D);
	return Whole != 0 && Volume(P, B, C, D) / Whole >= 0 && Volume(A, P, C, D) / Whole >= 0 &&
		   Volume(A, B, P, D) / Whole >= 0 && Volume(A, B, C, P) / Whole >= 0;
}

/** The hull is the union of all tetrahedra of its points (Caratheodory): inside one of them, or nearest to a triangle.
 */
double BruteForce(const std::vector<FVector>& Points, const FVector& Point)
{
	const FWide P = Widen(Point);
	std::vector<FWide> W;
	std::transform(Points.begin(), Points.end(), std::back_inserter(W), Widen);
	long double Least = std::numeric_limits<long double>::infinity();
	for (size_t A = 0; A < W.size(); ++A)
	{
		for (size_t B = 0; B <= A; ++B)
		{
			for (size_t C = 0; C <= B; ++C)
			{
				Least = std::min(Least, DistanceToTriangle(P, W[A], W[B], W[C]));
				for (size_t D = 0; D < C; ++D)
				{
					Least = IsInTetrahedron(P, W[A], W[B], W[C], W[D]) ? 0 : Least;
				}
			}
		}
	}
	return static_cast<double>(Least);
}

/** Whole numbers of a small grid: many points coincide, or share a line or plane. */
FVector GenerateGridPoint(int Size)
{
	return FVector(
		*rc::gen::inRange(-Size, Size + 1), *rc::gen::inRange(-Size, Size + 1), *rc::gen::inRange(-Size, Size + 1));
}

std::vector<FVector> GenerateGridPoints(int Size)
{
	std::vector<FVector> Points(static_cast<size_t>(*rc::gen::inRange(1, 9)));
	std::generate(Points.begin(), Points.end(), [&] { return GenerateGridPoint(Size); });
	return Points;
}

const std::vector<FVector> Cube = {FVector(-1, -1, -1), FVector(1, -1, -1), FVector(-1, 1, -1), FVector(1, 1, -1),
	FVector(-1, -1, 1), FVector(1, -1, 1), FVector(-1, 1, 1), FVector(1, 1, 1)};

} // namespace

TEST(VolumeBox, InsideAndOnTheFaceIsZero)
{
	const FVolumeShape Box = FVolumeShape::MakeBox(FVector(10, 20, 30), FVector(1, 2, 3));
	EXPECT_EQ(0.0, Box.GetDistance(FVector(10, 20, 30)));
	EXPECT_EQ(0.0, Box.GetDistance(FVector(11, 22, 33)));
}

TEST(VolumeBox, BesideAFaceItIsTheWayToTheFace)
{
	// 15 - (10 + 1)
	EXPECT_EQ(4.0, FVolumeShape::MakeBox(FVector(10, 0, 0), FVector(1, 2, 3)).GetDistance(FVector(15, 1, -2)));
}

TEST(VolumeBox, BesideACornerItIsTheDiagonal)
{
	// 2, 3 and 6 beyond the corner (1, 1, 1): sqrt(4 + 9 + 36)
	EXPECT_EQ(7.0, FVolumeShape::MakeBox(Origin, FVector(1, 1, 1)).GetDistance(FVector(3, -4, 7)));
}

TEST(VolumeBox, TurnedByARightAngleItsSidesSwapExactly)
{
	// Yaw 90: forward X becomes Y, so the long side lies along Y.
	const FVolumeShape Box = FVolumeShape::MakeBox(Origin, FVector(10, 1, 1), FRotator(0, 90, 0));
	EXPECT_EQ(4.0, Box.GetDistance(FVector(5, 0, 0)));
	EXPECT_EQ(0.0, Box.GetDistance(FVector(0, 10, 0)));
}

TEST(VolumeBox, TurnedByHalfARightAngleItsEdgePointsAtX)
{
	// Corner of a 2 x 2 square turned by 45 degrees: sqrt(2) from its centre.
	const FVolumeShape Box = FVolumeShape::MakeBox(Origin, FVector(1, 1, 1), FRotator(0, 45, 0));
	EXPECT_NEAR(3.0 - std::sqrt(2.0), Box.GetDistance(FVector(3, 0, 0)), 1e-15);
}

TEST(VolumeBox, PositivePitchLiftsItsNose)
{
	// Pitch 90: forward X becomes up Z.
	const FVolumeShape Box = FVolumeShape::MakeBox(Origin, FVector(10, 1, 1), FRotator(90, 0, 0));
	EXPECT_EQ(0.0, Box.GetDistance(FVector(0, 0, 10)));
	EXPECT_EQ(9.0, Box.GetDistance(FVector(10, 0, 0)));
}

TEST(VolumeBox, PitchOfThirtyDegreesIsUpwards)
{
	// Forward is (cos 30, 0, sin 30): the end of the long side lies above the ground, its mirror image below does not.
	const FVolumeShape Box = FVolumeShape::MakeBox(Origin, FVector(10, 1, 0.125), FRotator(30, 0, 0));
	EXPECT_NEAR(0.0, Box.GetDistance(FVector(8.66, 0, 5.0)), 1e-9);
	EXPECT_GT(Box.GetDistance(FVector(8.66, 0, -5.0)), 5.0);
}

TEST(VolumeBox, YawTurnsFromForwardToRight)
{
	// Left-handed: yaw 30 turns X towards Y.
	const FVolumeShape Box = FVolumeShape::MakeBox(Origin, FVector(10, 0.125, 1), FRotator(0, 30, 0));
	EXPECT_NEAR(0.0, Box.GetDistance(FVector(8.66, 5.0, 0)), 1e-9);
}

TEST(VolumeBox, RollTurnsItsRightSideDown)
{
	// Engine: positive roll lowers the right side, right = (0, cos, -sin).
	const FVolumeShape Box = FVolumeShape::MakeBox(Origin, FVector(1, 10, 0.125), FRotator(0, 0, 30));
	EXPECT_NEAR(0.0, Box.GetDistance(FVector(0, 8.66, -5.0)), 1e-9);
}

TEST(VolumeBox, WholeTurnsChangeNothing)
{
	const FVolumeShape Box = FVolumeShape::MakeBox(Origin, FVector(10, 1, 1), FRotator(0, -270, 360));
	EXPECT_EQ(0.0, Box.GetDistance(FVector(0, 10, 1)));
}

TEST(VolumeBox, WithoutSizeItIsAPoint)
{
	EXPECT_EQ(5.0, FVolumeShape::MakeBox(Origin, Origin).GetDistance(FVector(0, 3, 4)));
}

TEST(VolumeBox, HugeCoordinatesDoNotOverflow)
{
	EXPECT_DOUBLE_EQ(5e200, FVolumeShape::MakeBox(Origin, Origin).GetDistance(FVector(3e200, 4e200, 0)));
}

RC_GTEST_PROP(VolumeBox, RotatedIsTheSameAsTheHullOfItsCorners, ())
{
	const FVector Center = GenerateGridPoint(20);
	const FVector Extent(*rc::gen::inRange(0, 10), *rc::gen::inRange(0, 10), *rc::gen::inRange(0, 10));
	const FRotator Rotation(*rc::gen::inRange(-90, 91), *rc::gen::inRange(-180, 181), *rc::gen::inRange(-180, 181));
	std::vector<FVector> Corners;
	for (const FVector& Corner : Cube)
	{
		Corners.push_back(Center + Rotation.RotateVector(Corner * Extent));
	}
	const FVector Point = GenerateGridPoint(40);
	RC_ASSERT(std::fabs(FVolumeShape::MakeBox(Center, Extent, Rotation).GetDistance(Point) -
						GetDistanceToHull(Corners, Point)) < 1e-12);
}

TEST(VolumeSphere, InsideIsZeroOutsideTheWayToItsSkin)
{
	const FVolumeShape Sphere = FVolumeShape::MakeSphere(FVector(1, 0, 0), 5.0);
	EXPECT_EQ(0.0, Sphere.GetDistance(FVector(1, 3, 4)));
	EXPECT_EQ(8.0, Sphere.GetDistance(FVector(1, 5, 12)));
}

TEST(VolumeSphere, RadiusZeroIsAPoint)
{
	EXPECT_EQ(13.0, FVolumeShape::MakeSphere(Origin, 0.0).GetDistance(FVector(0, 5, 12)));
}

TEST(VolumeCapsule, BesideItsSegmentItIsACylinder)
{
	// Half height 10 with caps of radius 3: the segment runs from -7 to 7.
	const FVolumeShape Capsule = FVolumeShape::MakeCapsule(Origin, 3.0, 10.0);
	EXPECT_EQ(2.0, Capsule.GetDistance(FVector(5, 0, 7)));
	EXPECT_EQ(0.0, Capsule.GetDistance(FVector(0, 3, -7)));
}

TEST(VolumeCapsule, AboveItsSegmentItIsASphere)
{
	const FVolumeShape Capsule = FVolumeShape::MakeCapsule(Origin, 3.0, 10.0);
	EXPECT_EQ(0.0, Capsule.GetDistance(FVector(0, 0, 10)));
	// From (0, 0, 7): 3, 4 away, less the radius.
	EXPECT_EQ(2.0, Capsule.GetDistance(FVector(3, 0, 11)));
}

TEST(VolumeCapsule, ShorterThanItsRadiusItIsASphere)
{
	const FVolumeShape Capsule = FVolumeShape::MakeCapsule(Origin, 3.0, 1.0);
	EXPECT_EQ(0.0, Capsule.GetDistance(FVector(0, 0, 3)));
	EXPECT_EQ(1.0, Capsule.GetDistance(FVector(0, 0, 4)));
}

TEST(VolumeCapsule, RollLaysItDown)
{
	// Roll 90: up Z becomes right Y.
	const FVolumeShape Capsule = FVolumeShape::MakeCapsule(Origin, 3.0, 10.0, FRotator(0, 0, 90));
	EXPECT_EQ(0.0, Capsule.GetDistance(FVector(0, 10, 0)));
	EXPECT_EQ(1.0, Capsule.GetDistance(FVector(0, 0, 4)));
}

TEST(VolumeConvex, OnePointIsItself)
{
	EXPECT_EQ(13.0, FVolumeShape::MakeConvex({FVector(1, 0, 0)}).GetDistance(FVector(1, 5, 12)));
	EXPECT_EQ(0.0, FVolumeShape::MakeConvex({FVector(1, 0, 0)}).GetDistance(FVector(1, 0, 0)));
}

TEST(VolumeConvex, TwoPointsAreTheirSegment)
{
	const FVolumeShape Segment = FVolumeShape::MakeConvex({FVector(0, 0, 0), FVector(10, 0, 0)});
	EXPECT_DOUBLE_EQ(5.0, Segment.GetDistance(FVector(4, 3, 4)));
	EXPECT_DOUBLE_EQ(5.0, Segment.GetDistance(FVector(14, 3, 0)));
	EXPECT_EQ(0.0, Segment.GetDistance(FVector(7, 0, 0)));
}

TEST(VolumeConvex, ThreePointsAreTheirTriangle)
{
	const FVolumeShape Triangle = FVolumeShape::MakeConvex({FVector(0, 0, 0), FVector(10, 0, 0), FVector(0, 10, 0)});
	EXPECT_DOUBLE_EQ(7.0, Triangle.GetDistance(FVector(2, 2, -7)));
	EXPECT_EQ(0.0, Triangle.GetDistance(FVector(3, 4, 0)));
	// Nearest to the long side x + y = 10: (8 + 8 - 10) / sqrt 2.
	EXPECT_DOUBLE_EQ(6.0 / std::sqrt(2.0), Triangle.GetDistance(FVector(8, 8, 0)));
}

TEST(VolumeConvex, PointsOfOnePlaneAreTheirPolygon)
{
	const FVolumeShape Square = FVolumeShape::MakeConvex(
		{FVector(0, 0, 5), FVector(4, 0, 5), FVector(4, 4, 5), FVector(0, 4, 5), FVector(2, 2, 5)});
	EXPECT_EQ(0.0, Square.GetDistance(FVector(1, 3, 5)));
	EXPECT_DOUBLE_EQ(5.0, Square.GetDistance(FVector(1, 3, 0)));
	EXPECT_DOUBLE_EQ(5.0, Square.GetDistance(FVector(7, 8, 5)));
}

TEST(VolumeConvex, PointsOfOneLineAreTheirLongestSegment)
{
	const FVolumeShape Line =
		FVolumeShape::MakeConvex({FVector(1, 1, 1), FVector(5, 5, 5), FVector(2, 2, 2), FVector(3, 3, 3)});
	EXPECT_NEAR(0.0, Line.GetDistance(FVector(4, 4, 4)), 1e-14);
	EXPECT_DOUBLE_EQ(std::sqrt(12.0), Line.GetDistance(FVector(7, 7, 7)));
}

TEST(VolumeConvex, CubeOfCornersIsTheBox)
{
	const FVolumeShape Convex = FVolumeShape::MakeConvex(Cube);
	EXPECT_EQ(0.0, Convex.GetDistance(Origin));
	EXPECT_EQ(0.0, Convex.GetDistance(FVector(1, 1, 1)));
	EXPECT_DOUBLE_EQ(2.0, Convex.GetDistance(FVector(0.5, -3, 0.25)));
	EXPECT_DOUBLE_EQ(7.0, Convex.GetDistance(FVector(3, -4, 7)));
}

TEST(VolumeConvex, PointsInsideAddNothing)
{
	std::vector<FVector> Points = Cube;
	Points.insert(Points.begin(), {Origin, FVector(0.5, 0.5, 0.5), Origin});
	EXPECT_DOUBLE_EQ(2.0, FVolumeShape::MakeConvex(Points).GetDistance(FVector(0.5, -3, 0.25)));
}

TEST(VolumeConvex, RepeatedPointsAreOne)
{
	EXPECT_DOUBLE_EQ(
		5.0, FVolumeShape::MakeConvex(std::vector<FVector>(9, FVector(1, 1, 1))).GetDistance(FVector(1, 4, 5)));
}

TEST(VolumeConvex, WithoutPointsItIsNowhere)
{
	EXPECT_TRUE(std::isinf(FVolumeShape::MakeConvex({}).GetDistance(Origin)));
}

TEST(VolumeConvex, FarFromTheOriginItKeepsItsDigits)
{
	std::vector<FVector> Points = Cube;
	for (FVector& Point : Points)
	{
		Point = Point + FVector(1e9, -1e9, 1e9);
	}
	EXPECT_DOUBLE_EQ(2.0, FVolumeShape::MakeConvex(Points).GetDistance(FVector(1e9, -1e9 - 3, 1e9)));
}

TEST(VolumeConvex, ThinSliverIsMeasuredToItsFace)
{
	// A plate 2e6 wide and 1e-6 thick, looked at from 1 above its middle.
	std::vector<FVector> Points;
	for (const FVector& Corner : Cube)
	{
		Points.push_back(Corner * FVector(1e6, 1e6, 5e-7));
	}
	EXPECT_NEAR(1.0 - 5e-7, FVolumeShape::MakeConvex(Points).GetDistance(FVector(3, 7, 1)), 1e-9);
}

RC_GTEST_PROP(VolumeConvex, AgreesWithBruteForceWherePointsCoincide, ())
{
	const std::vector<FVector> Points = GenerateGridPoints(2);
	const FVector Point = GenerateGridPoint(4);
	RC_ASSERT(std::fabs(GetDistanceToHull(Points, Point) - BruteForce(Points, Point)) < 1e-13);
}

RC_GTEST_PROP(VolumeConvex, AgreesWithBruteForceInGeneralPosition, ())
{
	const std::vector<FVector> Points = GenerateGridPoints(100000);
	const FVector Point = GenerateGridPoint(150000);
	RC_ASSERT(std::fabs(GetDistanceToHull(Points, Point) - BruteForce(Points, Point)) < 1e-9);
}

RC_GTEST_PROP(VolumeConvex, AgreesWithBruteForceInThinLayers, ())
{
	std::vector<FVector> Points = GenerateGridPoints(1000);
	for (FVector& Point : Points)
	{
		Point.Z *= 1e-6;
	}
	const FVector Point = GenerateGridPoint(1000) * FVector(1, 1, 0.125);
	RC_ASSERT(std::fabs(GetDistanceToHull(Points, Point) - BruteForce(Points, Point)) < 1e-10);
}

RC_GTEST_PROP(VolumeConvex, OrderOfThePointsDoesNotMatter, ())
{
	std::vector<FVector> Points = GenerateGridPoints(50);
	const FVector Point = GenerateGridPoint(100);
	const double Distance = GetDistanceToHull(Points, Point);
	std::reverse(Points.begin(), Points.end());
	RC_ASSERT(std::fabs(Distance - GetDistanceToHull(Points, Point)) < 1e-12);
}

RC_GTEST_PROP(VolumeConvex, ItsOwnPointsAreInside, ())
{
	const std::vector<FVector> Points = GenerateGridPoints(1000);
	RC_ASSERT(GetDistanceToHull(Points, *rc::gen::elementOf(Points)) == 0.0);
}

RC_GTEST_PROP(VolumeShapes, DistanceGrowsByAtMostTheWay, ())
{
	const FRotator Rotation(*rc::gen::inRange(-90, 91), *rc::gen::inRange(-180, 181), 0);
	const std::vector<FVolumeShape> Shapes = {FVolumeShape::MakeBox(Origin, FVector(3, 4, 5), Rotation),
		FVolumeShape::MakeSphere(Origin, 4.0), FVolumeShape::MakeCapsule(Origin, 2.0, 6.0, Rotation),
		FVolumeShape::MakeConvex(GenerateGridPoints(6))};
	const FVector A = GenerateGridPoint(30);
	const FVector B = GenerateGridPoint(30);
	for (const FVolumeShape& Shape : Shapes)
	{
		RC_ASSERT(std::fabs(Shape.GetDistance(A) - Shape.GetDistance(B)) <= (A - B).Size() + 1e-12);
	}
}
