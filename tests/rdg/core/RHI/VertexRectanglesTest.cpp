// Which pixels triangles cover and what their TEXCOORDs are there, against plain loops over pixels: edges by Direct3D's
// rule, values by areas of the triangles that a point cuts off.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "VertexRectangles.h"

using namespace Drydock;

namespace
{

using FPoint = std::array<double, 2>;

/** At a position in pixels of the viewport, y down. */
FVertexOutput At(const FIntRect& Viewport, double X, double Y, std::array<float, 4> TexCoord = {})
{
	FVertexOutput Vertex;
	Vertex.Position[0] = static_cast<float>((X - Viewport.Min.X) / Viewport.Width() * 2 - 1);
	Vertex.Position[1] = static_cast<float>(1 - (Y - Viewport.Min.Y) / Viewport.Height() * 2);
	Vertex.Position[3] = 1;
	std::copy(TexCoord.begin(), TexCoord.end(), Vertex.TexCoords[0]);
	return Vertex;
}

/** Two triangles, cut along one of the diagonals; each corner's TEXCOORD0.x is 1 + 2 x + 3 y. */
std::vector<FVertexOutput> MakeRectangle(
	const FIntRect& Viewport, double Left, double Top, double Right, double Bottom, bool bFalling = true)
{
	const auto Corner = [&](double X, double Y)
	{
		return At(Viewport, X, Y, {static_cast<float>(1 + 2 * X + 3 * Y)});
	};
	const FVertexOutput A = Corner(Left, Top), B = Corner(Right, Top), C = Corner(Left, Bottom),
						D = Corner(Right, Bottom);
	return bFalling ? std::vector{A, B, D, A, D, C} : std::vector{C, B, A, B, D, C};
}

double Interpolate(const FKernelInterpolant& In, int32 Part, double X, double Y)
{
	return In.Base[Part] + In.DX[Part] * X + In.DY[Part] * Y;
}

double Cross(const FPoint& A, const FPoint& B, const FPoint& P)
{
	return (B[0] - A[0]) * (P[1] - A[1]) - (B[1] - A[1]) * (P[0] - A[0]);
}

/** A position as a graphics card has it. */
FPoint Snap(const FIntRect& Viewport, const FVertexOutput& Vertex)
{
	const double X = Viewport.Min.X + (Vertex.Position[0] + 1.0) / 2 * Viewport.Width();
	const double Y = Viewport.Min.Y + (1.0 - Vertex.Position[1]) / 2 * Viewport.Height();
	return {std::floor(X * 256 + 0.5) / 256, std::floor(Y * 256 + 0.5) / 256};
}

const FIntRect GViewport(0, 0, 64, 48);

std::string FaultOf(const std::vector<FVertexOutput>& Vertices, int32 NumTexCoords = 1)
{
	const FDrawnRectangles Drawn = FindDrawnRectangles(Vertices, GViewport, GViewport, NumTexCoords);
	EXPECT_EQ(Drawn.Fault.empty(), !Drawn.Rectangles.empty());
	return Drawn.Fault;
}

} // namespace

TEST(VertexRectangles, CoverThePixelsWhoseCentresLieInside)
{
	std::mt19937 Random(17);
	for (int32 Round = 0; Round < 400; ++Round)
	{
		const auto Draw = [&Random](int32 Low, int32 High)
		{
			return std::uniform_int_distribution<int32>(Low, High)(Random);
		};
		const FIntPoint Min(Draw(-20, 40), Draw(-20, 40));
		const FIntRect Viewport(Min, Min + FIntPoint(Draw(1, 97), Draw(1, 61)));
		const FIntRect Bounds(Draw(0, 5), Draw(0, 5), Draw(20, 70), Draw(20, 70));
		// In eighths, so that many edges run through centres.
		const double Left = Draw(-100, 500) / 8.0, Top = Draw(-100, 500) / 8.0;
		const double Right = Left + Draw(1, 400) / 8.0, Bottom = Top + Draw(1, 400) / 8.0;
		const FDrawnRectangles Drawn =
			FindDrawnRectangles(MakeRectangle(Viewport, Left, Top, Right, Bottom, Round % 2 == 0), Viewport, Bounds, 1);
		ASSERT_EQ("", Drawn.Fault);
		ASSERT_LE(Drawn.Rectangles.size(), 1u);
		for (int32 Y = -5; Y < 75; ++Y)
		{
			for (int32 X = -5; X < 75; ++X)
			{
				const bool bBounds = X >= Bounds.Min.X && X < Bounds.Max.X && Y >= Bounds.Min.Y && Y < Bounds.Max.Y;
				const bool bInside = X + 0.5 >= Left && X + 0.5 < Right && Y + 0.5 >= Top && Y + 0.5 < Bottom;
				const bool bDrawn = !Drawn.Rectangles.empty() && X >= Drawn.Rectangles[0].Rect.Min.X &&
									X < Drawn.Rectangles[0].Rect.Max.X && Y >= Drawn.Rectangles[0].Rect.Min.Y &&
									Y < Drawn.Rectangles[0].Rect.Max.Y;
				ASSERT_EQ(bBounds && bInside, bDrawn) << X << ", " << Y << " in round " << Round;
			}
		}
	}
}

TEST(VertexRectangles, TexCoordsOfATriangleAreThoseOfTheAreasThatAPointCutsOff)
{
	std::mt19937 Random(18);
	std::uniform_real_distribution<double> Far(-400, 400);
	std::uniform_real_distribution<float> Values(-3, 3);
	int32 NumCovering = 0;
	for (int32 Round = 0; Round < 4000; ++Round)
	{
		std::vector<FVertexOutput> Vertices;
		std::vector<FPoint> Corners;
		for (int32 i = 0; i < 3; ++i)
		{
			Vertices.push_back(At(
				GViewport, Far(Random), Far(Random), {Values(Random), Values(Random), Values(Random), Values(Random)}));
			Corners.push_back(Snap(GViewport, Vertices.back()));
		}
		const double Whole = Cross(Corners[0], Corners[1], Corners[2]);
		const auto GetShares = [&](double X, double Y) -> std::array<double, 3>
		{
			const FPoint P = {X, Y};
			return {Cross(Corners[1], Corners[2], P) / Whole, Cross(Corners[2], Corners[0], P) / Whole,
				Cross(Corners[0], Corners[1], P) / Whole};
		};
		const FDrawnRectangles Drawn = FindDrawnRectangles(Vertices, GViewport, GViewport, 1);
		ASSERT_EQ("", Drawn.Fault);
		if (Drawn.Rectangles.empty())
		{
			continue;
		}
		++NumCovering;
		for (const FDrawnRectangle& Rectangle : Drawn.Rectangles)
		{
			const FPoint P = {Rectangle.Rect.Max.X - 0.5, Rectangle.Rect.Min.Y + 0.5};
			const std::array<double, 3> Shares = GetShares(P[0], P[1]);
			for (int32 Part = 0; Part < 4; ++Part)
			{
				double Expected = 0;
				for (size_t i = 0; i < 3; ++i)
				{
					Expected += Shares[i] * Vertices[i].TexCoords[0][Part];
				}
				// Both ways round a few times at the size of the plane's base, whose slope grows with thin triangles.
				const double Tolerance = 1e-12 * (1 + 1e5 / std::abs(Whole));
				ASSERT_NEAR(Expected, Interpolate(Rectangle.Interpolants[0], Part, P[0], P[1]), Tolerance);
			}
		}
	}
	EXPECT_GT(NumCovering, 50);
}

TEST(VertexRectangles, TexCoordsRunEvenlyOverARectangle)
{
	const FIntRect Viewport(3, 5, 100, 66);
	const FDrawnRectangles Drawn = FindDrawnRectangles(MakeRectangle(Viewport, 10, 6, 47, 59), Viewport, Viewport, 1);
	ASSERT_EQ(1u, Drawn.Rectangles.size()) << Drawn.Fault;
	EXPECT_EQ(FIntRect(10, 6, 47, 59), Drawn.Rectangles[0].Rect);
	for (double Y = 6.5; Y < 59; ++Y)
	{
		for (double X = 10.5; X < 47; ++X)
		{
			ASSERT_NEAR(1 + 2 * X + 3 * Y, Interpolate(Drawn.Rectangles[0].Interpolants[0], 0, X, Y), 1e-9);
		}
	}
}

TEST(VertexRectangles, WhatIsTheSameEverywhereStaysSo)
{
	std::vector<FVertexOutput> Vertices = MakeRectangle(GViewport, 0, 0, 64, 48);
	constexpr float Infinity = std::numeric_limits<float>::infinity();
	for (FVertexOutput& Vertex : Vertices)
	{
		Vertex.TexCoords[0][1] = 0.1f;
		Vertex.TexCoords[0][2] = Infinity;
	}
	const FDrawnRectangles Drawn = FindDrawnRectangles(Vertices, GViewport, GViewport, 1);
	ASSERT_EQ(1u, Drawn.Rectangles.size());
	EXPECT_EQ(double(0.1f), Interpolate(Drawn.Rectangles[0].Interpolants[0], 1, 17.5, 3.5));
	EXPECT_EQ(double(Infinity), Interpolate(Drawn.Rectangles[0].Interpolants[0], 2, 17.5, 3.5));
}

TEST(VertexRectangles, PairsAreDrawnInTheirOrderAndWhatHasNoAreaIsLeftOut)
{
	std::vector<FVertexOutput> Vertices = MakeRectangle(GViewport, 0, 0, 10, 10);
	const FVertexOutput Corner = At(GViewport, 5, 5);
	Vertices.insert(Vertices.end(), {Corner, Corner, Corner});
	const std::vector<FVertexOutput> Second = MakeRectangle(GViewport, 4, 4, 20, 20, false);
	Vertices.insert(Vertices.end(), Second.begin(), Second.end());
	const FDrawnRectangles Drawn = FindDrawnRectangles(Vertices, GViewport, GViewport, 1);
	ASSERT_EQ(2u, Drawn.Rectangles.size()) << Drawn.Fault;
	EXPECT_EQ(FIntRect(0, 0, 10, 10), Drawn.Rectangles[0].Rect);
	EXPECT_EQ(FIntRect(4, 4, 20, 20), Drawn.Rectangles[1].Rect);
}

TEST(VertexRectangles, WhatIsNoneIsSaid)
{
	const auto Has = [](const std::string& Text, const char* Part)
	{
		return Text.find(Part) != std::string::npos;
	};
	std::vector<FVertexOutput> Vertices = MakeRectangle(GViewport, 0, 0, 10, 10);
	EXPECT_EQ("", FaultOf(Vertices));
	std::vector<FVertexOutput> Changed = Vertices;
	Changed[2].Position[3] = 2;
	EXPECT_TRUE(Has(FaultOf(Changed), "perspective"));
	Changed = Vertices;
	Changed[1].Position[0] = std::numeric_limits<float>::quiet_NaN();
	EXPECT_TRUE(Has(FaultOf(Changed), "not finite"));
	Changed = Vertices;
	Changed[4].Position[2] = 1.5f;
	EXPECT_TRUE(Has(FaultOf(Changed), "0..w"));
}

// A fan of triangles with a common corner: each pixel whose centre is inside exactly once, those on common edges, too.
// Edges by Direct3D's rule: a centre on an edge belongs to the triangle of which the edge is an upper or left one.
TEST(VertexRectangles, TrianglesOfAMeshCoverEachPixelOnce)
{
	std::mt19937 Random(19);
	const auto Draw = [&Random](int32 Low, int32 High)
	{
		return std::uniform_int_distribution<int32>(Low, High)(Random) / 2.0; // halves: many edges run through centres
	};
	for (int32 Round = 0; Round < 300; ++Round)
	{
		const FPoint Middle = {Draw(20, 100), Draw(20, 80)};
		const FPoint Ring[] = {{0, 0}, {Draw(0, 128), 0}, {64, 0}, {64, Draw(0, 96)}, {64, 48}, {Draw(0, 128), 48},
			{0, 48}, {0, Draw(0, 96)}};
		std::vector<FVertexOutput> Vertices;
		for (size_t i = 0; i < 8; ++i)
		{
			for (const FPoint& P : {Middle, Ring[i], Ring[(i + 1) % 8]})
			{
				Vertices.push_back(At(GViewport, P[0], P[1], {static_cast<float>(1 + 2 * P[0] + 3 * P[1])}));
			}
		}
		std::vector<int> Covered(64 * 48);
		const FDrawnRectangles Drawn = FindDrawnRectangles(Vertices, GViewport, GViewport, 1);
		ASSERT_EQ("", Drawn.Fault);
		for (const FDrawnRectangle& Rectangle : Drawn.Rectangles)
		{
			for (int32 Y = Rectangle.Rect.Min.Y; Y < Rectangle.Rect.Max.Y; ++Y)
			{
				for (int32 X = Rectangle.Rect.Min.X; X < Rectangle.Rect.Max.X; ++X)
				{
					++Covered.at(static_cast<size_t>(Y * 64 + X));
					ASSERT_NEAR(1 + 2 * (X + 0.5) + 3 * (Y + 0.5),
						Interpolate(Rectangle.Interpolants[0], 0, X + 0.5, Y + 0.5), 1e-9);
				}
			}
		}
		ASSERT_EQ(std::vector<int>(64 * 48, 1), Covered) << "round " << Round;
	}
}

// A half of a rectangle, pixel by pixel: (0, 0), (8, 0), (0, 8) holds the centres with x + y < 8; on the long edge,
// which is a right one, none.
TEST(VertexRectangles, ATriangleEndsAtItsEdges)
{
	const std::vector<FVertexOutput> Vertices = {At(GViewport, 0, 0), At(GViewport, 8, 0), At(GViewport, 0, 8)};
	const FDrawnRectangles Drawn = FindDrawnRectangles(Vertices, GViewport, GViewport, 0);
	ASSERT_EQ(7u, Drawn.Rectangles.size());
	for (int32 Row = 0; Row < 7; ++Row)
	{
		EXPECT_EQ(FIntRect(0, Row, 7 - Row, Row + 1), Drawn.Rectangles[static_cast<size_t>(Row)].Rect);
	}
}

// Where the corners of a rectangle lie on no plane, each half has its own.
TEST(VertexRectangles, ABentRectangleIsTwoTriangles)
{
	std::vector<FVertexOutput> Vertices = MakeRectangle(GViewport, 0, 0, 10, 10);
	Vertices[5].TexCoords[1][3] = 1;
	EXPECT_EQ(1u, FindDrawnRectangles(Vertices, GViewport, GViewport, 1).Rectangles.size()) << "nobody reads it";
	const FDrawnRectangles Drawn = FindDrawnRectangles(Vertices, GViewport, GViewport, 2);
	ASSERT_EQ(19u, Drawn.Rectangles.size()); // the centres on the diagonal are the first one's
	EXPECT_EQ(0, Interpolate(Drawn.Rectangles.front().Interpolants[1], 3, 9.5, 0.5));
	EXPECT_NEAR(0.9, Interpolate(Drawn.Rectangles.back().Interpolants[1], 3, 0.5, 9.5), 1e-12);
}
