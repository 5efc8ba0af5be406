// Pairs triangles to rectangles, cuts others into rows of pixels, and fits planes to their TEXCOORDs, in double.
#include "VertexRectangles.h"

#include "Math/ToInteger.h"

#include <algorithm>
#include <cmath>

namespace Drydock
{

namespace
{

/** TEXCOORDs are floats, computed with a rounding or two: how far, in parts of the largest, a corner may lie off the
 * plane of the others. */
constexpr double GPlaneTolerance = 1.0 / (1 << 18);

/** The most rows of pixels of a draw. Each row is drawn by itself, and all of them are held meanwhile. */
constexpr size_t GMaxRows = 1 << 18;

/** A vertex on its way to the pixels. */
struct FCorner
{
	double X = 0; // pixels, in steps of 1/256
	double Y = 0;
	const FVertexOutput* Vertex = nullptr;
};

double Snap(double Pixels)
{
	return std::floor(Pixels * 256 + 0.5) / 256;
}

double GetTwiceTheArea(const FCorner* Triangle)
{
	return (Triangle[1].X - Triangle[0].X) * (Triangle[2].Y - Triangle[0].Y) -
		   (Triangle[2].X - Triangle[0].X) * (Triangle[1].Y - Triangle[0].Y);
}

/** First pixel whose centre lies at or after an edge: the top-left rule, for left and right edges alike. */
int32 GetFirstPixel(double Edge)
{
	return ToInteger<int32>(std::ceil(Edge - 0.5));
}

class FFinder
{
public:
	FFinder(const std::vector<FVertexOutput>& InVertices, const FIntRect& InViewport, const FIntRect& InBounds,
		int32_t InNumTexCoords, uint32_t InIntegers, const std::vector<std::string>& InNamed)
		: Vertices(InVertices)
		, Viewport(InViewport)
		, Bounds(InBounds)
		, NumTexCoords(InNumTexCoords)
		, Integers(InIntegers)
		, Named(InNamed)
	{
	}

	FDrawnRectangles Run()
	{
		if (!PlaceCorners())
		{
			return std::move(Result);
		}
		for (size_t First = 0; First + 3 <= Corners.size() && Result.Fault.empty();)
		{
			const FCorner* const Triangle = &Corners[First];
			if (GetTwiceTheArea(Triangle) == 0)
			{
				First += 3;
			}
			else if (First + 6 <= Corners.size() && AddRectangle(Triangle))
			{
				First += 6;
			}
			else
			{
				AddTriangle(Triangle);
				First += 3;
			}
		}
		return std::move(Result);
	}

private:
	/** From clip space to pixels. */
	bool PlaceCorners()
	{
		for (const FVertexOutput& Vertex : Vertices)
		{
			const float* const P = Vertex.Position;
			const auto IsFinite = [](float Value)
			{
				return std::isfinite(Value);
			};
			if (!std::all_of(P, P + 4, IsFinite) || P[3] <= 0)
			{
				Result.Fault = "SV_POSITION is not finite, or its w is not above 0";
			}
			else if (P[3] != Vertices[0].Position[3])
			{
				Result.Fault = "SV_POSITION has another w at each vertex: it is seen in perspective";
			}
			else if (P[2] < 0 || P[2] > P[3])
			{
				Result.Fault = "the z of SV_POSITION lies outside 0..w, which is clipped away";
			}
			for (int32 Index = 0; Index < NumTexCoords; ++Index)
			{
				const double* const First = Vertices[0].TexCoords[Index];
				if ((Integers >> Index & 1) && !std::equal(First, First + 4, Vertex.TexCoords[Index]))
				{
					Result.Fault =
						"the integers of " + GetInterpolantName(Index, Named) + " are not the same at all vertices";
				}
			}
			if (!Result.Fault.empty())
			{
				return false;
			}
			const double W = P[3];
			Corners.push_back({Snap(Viewport.Min.X + (P[0] / W * 0.5 + 0.5) * Viewport.Width()),
				Snap(Viewport.Min.Y + (0.5 - P[1] / W * 0.5) * Viewport.Height()), &Vertex});
		}
		return true;
	}

	/** Both triangles as one rectangle; false where they make none, or where a TEXCOORD has another plane in each.
	 */
	bool AddRectangle(const FCorner* Six)
	{
		double Left = Six[0].X, Right = Six[0].X, Top = Six[0].Y, Bottom = Six[0].Y;
		for (int32 i = 1; i < 6; ++i)
		{
			Left = std::min(Left, Six[i].X);
			Right = std::max(Right, Six[i].X);
			Top = std::min(Top, Six[i].Y);
			Bottom = std::max(Bottom, Six[i].Y);
		}
		const FCorner* ByPlace[4] = {}; // left top, right top, left bottom, right bottom
		int32 Missing[2] = {0 + 1 + 2 + 3, 0 + 1 + 2 + 3};
		for (int32 i = 0; i < 6; ++i)
		{
			const bool bOnCorner = (Six[i].X == Left || Six[i].X == Right) && (Six[i].Y == Top || Six[i].Y == Bottom);
			const int32 Place = (Six[i].X == Right ? 1 : 0) + (Six[i].Y == Bottom ? 2 : 0);
			if (!bOnCorner)
			{
				return false;
			}
			ByPlace[Place] = &Six[i];
			Missing[i / 3] -= Place;
		}
		// Halves of the rectangle lack opposite corners.
		if (GetTwiceTheArea(Six) == 0 || GetTwiceTheArea(Six + 3) == 0 || Missing[0] + Missing[1] != 3)
		{
			return false;
		}
		const FCorner Plane[3] = {*ByPlace[0], *ByPlace[1], *ByPlace[2]};
		std::vector<FKernelInterpolant> Interpolants = FitPlanes(Plane);
		if (IsBent(Six, Interpolants))
		{
			return false;
		}
		const FIntRect Rect(GetFirstPixel(Left), GetFirstPixel(Top), GetFirstPixel(Right), GetFirstPixel(Bottom));
		Add(Rect, std::move(Interpolants));
		return true;
	}

	/** Whether a vertex lies off the plane of a TEXCOORD. */
	bool IsBent(const FCorner* Six, const std::vector<FKernelInterpolant>& Interpolants) const
	{
		for (int32 Index = 0; Index < NumTexCoords; ++Index)
		{
			for (int32 Part = 0; Part < 4; ++Part)
			{
				const FKernelInterpolant& In = Interpolants[size_t(Index)];
				double Largest = 0;
				double Worst = 0;
				for (int32 i = 0; i < 6; ++i)
				{
					const double Value = Six[i].Vertex->TexCoords[Index][Part];
					const double Fitted = In.Base[Part] + In.DX[Part] * Six[i].X + In.DY[Part] * Six[i].Y;
					Largest = std::max(Largest, std::abs(Value));
					Worst = std::max(Worst, std::abs(Value - Fitted));
				}
				if (Worst > GPlaneTolerance * Largest)
				{
					return true;
				}
			}
		}
		return false;
	}

	/** Whether a pixel's centre is inside, or on an upper or left edge. Exact: corners are whole 256ths. */
	static bool IsInside(const FCorner* Triangle, double Turn, int32 PixelX, int32 PixelY)
	{
		const double X = PixelX + 0.5;
		const double Y = PixelY + 0.5;
		for (int32 i = 0; i < 3; ++i)
		{
			const FCorner& A = Triangle[i];
			const FCorner& B = Triangle[(i + 1) % 3];
			const double EdgeX = (B.X - A.X) * Turn;
			const double EdgeY = (B.Y - A.Y) * Turn;
			const double Inside = EdgeX * (Y - A.Y) - (X - A.X) * EdgeY;
			const bool bTopOrLeft = EdgeY < 0 || (EdgeY == 0 && EdgeX > 0);
			if (Inside < 0 || (Inside == 0 && !bTopOrLeft))
			{
				return false;
			}
		}
		return true;
	}

	/** The pixels of a row that a triangle covers: they lie side by side. */
	std::pair<int32, int32> FindSpan(const FCorner* Triangle, double Turn, int32 Row) const
	{
		double Left = Bounds.Max.X;
		double Right = Bounds.Min.X;
		for (int32 i = 0; i < 3; ++i)
		{
			const FCorner& A = Triangle[i];
			const FCorner& B = Triangle[(i + 1) % 3];
			const double Part = (Row + 0.5 - A.Y) / (B.Y - A.Y);
			if (Part >= 0 && Part <= 1) // not of a level edge
			{
				Left = std::min(Left, A.X + Part * (B.X - A.X));
				Right = std::max(Right, A.X + Part * (B.X - A.X));
			}
		}
		int32 Begin = std::max(Bounds.Min.X, GetFirstPixel(Left) - 1);
		int32 End = std::min(Bounds.Max.X, GetFirstPixel(Right) + 1);
		while (Begin < End && !IsInside(Triangle, Turn, Begin, Row))
		{
			++Begin;
		}
		while (Begin < End && !IsInside(Triangle, Turn, End - 1, Row))
		{
			--End;
		}
		return {Begin, End};
	}

	/** A triangle alone: rows of pixels, those of one place and width together. */
	void AddTriangle(const FCorner* Triangle)
	{
		const double Turn = GetTwiceTheArea(Triangle) > 0 ? 1 : -1; // clockwise on the screen, or not
		const auto [Top, Bottom] = std::minmax({Triangle[0].Y, Triangle[1].Y, Triangle[2].Y});
		const int32 End = std::min(Bounds.Max.Y, GetFirstPixel(Bottom) + 1);
		const std::vector<FKernelInterpolant> Planes = FitPlanes(Triangle);
		FIntRect Rect;
		for (int32 Row = std::max(Bounds.Min.Y, GetFirstPixel(Top)); Row < End; ++Row)
		{
			const auto [Left, Right] = FindSpan(Triangle, Turn, Row);
			if (Rect.Max.Y != Row || Rect.Min.X != Left || Rect.Max.X != Right)
			{
				Add(Rect, Planes);
				Rect = FIntRect(Left, Row, Right, Row);
			}
			Rect.Max.Y = Row + 1;
		}
		Add(Rect, Planes);
		if (Result.Rectangles.size() > GMaxRows)
		{
			Result.Fault = "its triangles cover more than " + std::to_string(GMaxRows) + " rows of pixels";
		}
	}

	std::vector<FKernelInterpolant> FitPlanes(const FCorner* Three) const
	{
		const double Area = GetTwiceTheArea(Three);
		const double X1 = Three[1].X - Three[0].X, Y1 = Three[1].Y - Three[0].Y;
		const double X2 = Three[2].X - Three[0].X, Y2 = Three[2].Y - Three[0].Y;
		std::vector<FKernelInterpolant> Planes(static_cast<size_t>(NumTexCoords), FKernelInterpolant{});
		for (int32 Index = 0; Index < NumTexCoords; ++Index)
		{
			for (int32 Part = 0; Part < 4; ++Part)
			{
				const double V0 = Three[0].Vertex->TexCoords[Index][Part];
				const double V1 = Three[1].Vertex->TexCoords[Index][Part];
				const double V2 = Three[2].Vertex->TexCoords[Index][Part];
				FKernelInterpolant& Plane = Planes[size_t(Index)];
				// A value that is the same everywhere stays the same, infinities too.
				const bool bConstant = V0 == V1 && V0 == V2;
				Plane.DX[Part] = bConstant ? 0 : ((V1 - V0) * Y2 - (V2 - V0) * Y1) / Area;
				Plane.DY[Part] = bConstant ? 0 : ((V2 - V0) * X1 - (V1 - V0) * X2) / Area;
				Plane.Base[Part] = bConstant ? V0 : V0 - Plane.DX[Part] * Three[0].X - Plane.DY[Part] * Three[0].Y;
			}
		}
		return Planes;
	}

	void Add(const FIntRect& Rect, std::vector<FKernelInterpolant> Interpolants)
	{
		const FIntRect Clipped(std::max(Rect.Min.X, Bounds.Min.X), std::max(Rect.Min.Y, Bounds.Min.Y),
			std::min(Rect.Max.X, Bounds.Max.X), std::min(Rect.Max.Y, Bounds.Max.Y));
		if (Clipped.Min.X < Clipped.Max.X && Clipped.Min.Y < Clipped.Max.Y)
		{
			Result.Rectangles.push_back({Clipped, std::move(Interpolants)});
		}
	}

	const std::vector<FVertexOutput>& Vertices;
	const FIntRect Viewport;
	const FIntRect Bounds;
	const int32 NumTexCoords;
	const uint32 Integers;
	const std::vector<std::string>& Named;
	std::vector<FCorner> Corners;
	FDrawnRectangles Result;
};

} // namespace

FDrawnRectangles FindDrawnRectangles(const std::vector<FVertexOutput>& Vertices, const FIntRect& Viewport,
	const FIntRect& Bounds, int32_t NumTexCoords, uint32_t Integers, const std::vector<std::string>& Named)
{
	return FFinder(Vertices, Viewport, Bounds, NumTexCoords, Integers, Named).Run();
}

} // namespace Drydock
