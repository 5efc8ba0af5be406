// Finds points in convex polygons, and cuts pixels along their edges.
#include "Scenes/AnalyticScene.h"

#include <algorithm>
#include <cmath>

namespace Drydock
{

namespace
{

using FPolygon = std::vector<FVector2D>;

FVector2D Turn(FVector2D Point, double Angle)
{
	const double Cos = std::cos(Angle);
	const double Sin = std::sin(Angle);
	return FVector2D(Point.X * Cos - Point.Y * Sin, Point.X * Sin + Point.Y * Cos);
}

/** Twice the area, above 0 where corners turn from x towards y. */
double GetSignedDoubleArea(const FPolygon& Polygon)
{
	double Sum = 0.0;
	for (size_t Index = 0; Index < Polygon.size(); ++Index)
	{
		const FVector2D& A = Polygon[Index];
		const FVector2D& B = Polygon[(Index + 1) % Polygon.size()];
		Sum += A.X * B.Y - B.X * A.Y;
	}
	return Sum;
}

/** How far Point is on the inner side of the edge from A to B; not scaled. */
double GetSide(FVector2D A, FVector2D B, FVector2D Point)
{
	return (B.X - A.X) * (Point.Y - A.Y) - (B.Y - A.Y) * (Point.X - A.X);
}

/** The part of a convex polygon on one side of an edge: the inner for Sign 1, the outer for -1. */
FPolygon CutAlong(const FPolygon& Polygon, FVector2D A, FVector2D B, double Sign)
{
	FPolygon Part;
	for (size_t Index = 0; Index < Polygon.size(); ++Index)
	{
		const FVector2D& From = Polygon[Index];
		const FVector2D& To = Polygon[(Index + 1) % Polygon.size()];
		const double SideFrom = Sign * GetSide(A, B, From);
		const double SideTo = Sign * GetSide(A, B, To);
		if (SideFrom >= 0.0)
		{
			Part.push_back(From);
		}
		if ((SideFrom > 0.0 && SideTo < 0.0) || (SideFrom < 0.0 && SideTo > 0.0))
		{
			Part.push_back(From + (To - From) * (SideFrom / (SideFrom - SideTo)));
		}
	}
	return Part;
}

bool IsEmpty(const FPolygon& Polygon)
{
	return Polygon.size() < 3 || std::abs(GetSignedDoubleArea(Polygon)) < 1e-15;
}

} // namespace

FAnalyticPicture::FAnalyticPicture(const FAnalyticFrame& InFrame)
	: Frame(InFrame)
{
	for (const FAnalyticShape& Shape : Frame.Shapes)
	{
		FPlaced& Own = Placed.emplace_back();
		Own.Min = Own.Max = Turn(Shape.Corners.front(), Shape.Pose.Angle) + Shape.Pose.Center;
		for (const FVector2D& Corner : Shape.Corners)
		{
			const FVector2D Place = Turn(Corner, Shape.Pose.Angle) + Shape.Pose.Center;
			Own.Corners.push_back(Place);
			Own.Min = FVector2D(std::min(Own.Min.X, Place.X), std::min(Own.Min.Y, Place.Y));
			Own.Max = FVector2D(std::max(Own.Max.X, Place.X), std::max(Own.Max.Y, Place.Y));
		}
		if (GetSignedDoubleArea(Own.Corners) < 0.0)
		{
			std::reverse(Own.Corners.begin(), Own.Corners.end());
		}
	}
}

const FAnalyticShape& FAnalyticPicture::FindShape(FVector2D Point) const
{
	for (size_t Index = 0; Index < Placed.size(); ++Index)
	{
		const FPlaced& Own = Placed[Index];
		bool bInside = Point.X >= Own.Min.X && Point.X <= Own.Max.X && Point.Y >= Own.Min.Y && Point.Y <= Own.Max.Y;
		for (size_t Edge = 0; Edge < Own.Corners.size() && bInside; ++Edge)
		{
			bInside = GetSide(Own.Corners[Edge], Own.Corners[(Edge + 1) % Own.Corners.size()], Point) >= 0.0;
		}
		if (bInside)
		{
			return Frame.Shapes[Index];
		}
	}
	return Frame.Background;
}

FVector2D GetMovement(const FAnalyticShape& Shape, FVector2D Point)
{
	const FVector2D Own = Point - Shape.Pose.Center;
	const FVector2D Before = Turn(Own, Shape.PoseBefore.Angle - Shape.Pose.Angle) + Shape.PoseBefore.Center;
	return Point - Before;
}

FLinearColor FAnalyticPicture::ComputeMean(int X, int Y) const
{
	const FVector2D Corner(X, Y);
	std::vector<FPolygon> Open = {
		{Corner, Corner + FVector2D(1, 0), Corner + FVector2D(1, 1), Corner + FVector2D(0, 1)}};
	double Mean[3] = {};
	const auto AddArea = [&](const FAnalyticShape& Shape, const FPolygon& Part)
	{
		const double Area = 0.5 * std::abs(GetSignedDoubleArea(Part));
		Mean[0] += Area * static_cast<double>(Shape.Color.R);
		Mean[1] += Area * static_cast<double>(Shape.Color.G);
		Mean[2] += Area * static_cast<double>(Shape.Color.B);
	};
	for (size_t Shape = 0; Shape < Placed.size(); ++Shape)
	{
		const FPlaced& Own = Placed[Shape];
		if (Own.Min.X >= X + 1 || Own.Max.X <= X || Own.Min.Y >= Y + 1 || Own.Max.Y <= Y)
		{
			continue;
		}
		const FPolygon& Edges = Own.Corners;
		std::vector<FPolygon> Left;
		for (FPolygon& Piece : Open)
		{
			// The part outside of an edge stays open; the rest goes on to the next edge.
			for (size_t Index = 0; Index < Edges.size() && !IsEmpty(Piece); ++Index)
			{
				const FVector2D& A = Edges[Index];
				const FVector2D& B = Edges[(Index + 1) % Edges.size()];
				FPolygon Outside = CutAlong(Piece, A, B, -1.0);
				if (!IsEmpty(Outside))
				{
					Left.push_back(std::move(Outside));
				}
				Piece = CutAlong(Piece, A, B, 1.0);
			}
			if (!IsEmpty(Piece))
			{
				AddArea(Frame.Shapes[Shape], Piece);
			}
		}
		Open = std::move(Left);
		if (Open.empty())
		{
			break;
		}
	}
	for (const FPolygon& Piece : Open)
	{
		AddArea(Frame.Background, Piece);
	}
	return FLinearColor(static_cast<float>(Mean[0]), static_cast<float>(Mean[1]), static_cast<float>(Mean[2]), 1.0f);
}

} // namespace Drydock
