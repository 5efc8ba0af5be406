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
		bool bCovers = true;
		for (const FPoint& P : {FPoint{0.5, 0.5}, FPoint{63.5, 0.5}, FPoint{0.5, 47.5}, FPoint{63.5, 47.5}})
		{
			for (const double Share : GetShares(P[0], P[1]))
			{
				bCovers = bCovers && Share > 0;
			}
		}
		const FDrawnRectangles Drawn = FindDrawnRectangles(Vertices, GViewport, GViewport, 1);
		ASSERT_EQ(bCovers, Drawn.Fault.empty()) << Drawn.Fault;
		if (!bCovers)
		{
			continue;
		}
		++NumCovering;
		ASSERT_EQ(GViewport, Drawn.Rectangles.at(0).Rect);
		for (const FPoint& P : {FPoint{0.5, 0.5}, FPoint{63.5, 0.5}, FPoint{20.5, 30.5}, FPoint{63.5, 47.5}})
		{
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
				ASSERT_NEAR(Expected, Interpolate(Drawn.Rectangles[0].Interpolants[0], Part, P[0], P[1]), Tolerance);
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
	Changed.resize(3); // half a rectangle that does not cover the viewport
	EXPECT_TRUE(Has(FaultOf(Changed), "neither halves of rectangles"));
	Changed = Vertices;
	Changed[5] = At(GViewport, 1, 10);
	EXPECT_TRUE(Has(FaultOf(Changed), "neither halves of rectangles")) << "a corner beside its place";
	std::copy(Vertices.begin(), Vertices.begin() + 3, Changed.begin() + 3);
	EXPECT_TRUE(Has(FaultOf(Changed), "neither halves of rectangles")) << "one half twice";
	Changed = Vertices;
	Changed[2].Position[3] = 2;
	EXPECT_TRUE(Has(FaultOf(Changed), "perspective"));
	Changed = Vertices;
	Changed[1].Position[0] = std::numeric_limits<float>::quiet_NaN();
	EXPECT_TRUE(Has(FaultOf(Changed), "not finite"));
	Changed = Vertices;
	Changed[4].Position[2] = 1.5f;
	EXPECT_TRUE(Has(FaultOf(Changed), "0..w"));
	Changed = Vertices;
	Changed[5].TexCoords[1][3] = 1;
	EXPECT_EQ("", FaultOf(Changed, 1)) << "nobody reads it";
	EXPECT_TRUE(Has(FaultOf(Changed, 2), "TEXCOORD1 does not run evenly"));
}
