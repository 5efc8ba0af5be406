// Reads the strokes of every letter and paints them into pictures.
#include "Picture/StrokeText.h"

#include "Math/ToInteger.h"
#include "Misc/AssertionMacros.h"
#include "RangeTools.h"
#include "TextTools.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

namespace Drydock
{

namespace
{

constexpr double CapUnits = 7.0;     // a capital letter is this high, a small one 5, letters reach 2 below
constexpr double GapUnits = 1.6;     // between two letters
constexpr double StrokeUnits = 0.95; // width of the pen
constexpr double DescentUnits = 2.5;
constexpr double AscentUnits = 8.0;

constexpr const char* GlyphTexts =
#include "StrokeText.txt"
	;
constexpr char FirstLetter = ' ';
constexpr size_t NumLetters = '~' - FirstLetter + 1;

struct FPoint
{
	double X;
	double Y;
};

using FStroke = std::vector<FPoint>;

struct FGlyph
{
	double Width = 0.0;
	std::vector<FStroke> Strokes;
};

void AddArc(FStroke& Stroke, std::istringstream& Text)
{
	constexpr double DegreesToRadians = 3.14159265358979323846 / 180.0;
	constexpr double StepDegrees = 15.0;
	double CenterX, CenterY, RadiusX, RadiusY, From, To;
	Text >> CenterX >> CenterY >> RadiusX >> RadiusY >> From >> To;
	const int NumSteps = ToInteger<int>(std::ceil(std::abs(To - From) / StepDegrees));
	for (int Step = 0; Step <= NumSteps; ++Step)
	{
		const double Angle = (From + (To - From) * Step / NumSteps) * DegreesToRadians;
		Stroke.push_back({CenterX + RadiusX * std::cos(Angle), CenterY + RadiusY * std::sin(Angle)});
	}
}

FGlyph ParseGlyph(const std::vector<std::string>& Row)
{
	FGlyph Glyph;
	std::istringstream Text(Row[0]);
	Text >> Glyph.Width;
	for (char Command = 0; Text >> Command;)
	{
		if (Command == 'M' || Command == 'N')
		{
			Glyph.Strokes.emplace_back();
		}
		if (Command == 'A' || Command == 'N')
		{
			AddArc(Glyph.Strokes.back(), Text);
			continue;
		}
		for (FPoint Point{}; Text >> Point.X >> Point.Y;)
		{
			Glyph.Strokes.back().push_back(Point);
		}
		Text.clear(); // a letter where a number might have been
	}
	return Glyph;
}

const FGlyph& GetGlyph(char Letter)
{
	static const std::vector<FGlyph> Glyphs = ToVector<FGlyph>(SplitRows(GlyphTexts), ParseGlyph);
	check(Glyphs.size() == NumLetters);
	return Glyphs[static_cast<size_t>(Letter - FirstLetter)];
}

/** Replaces each character that has no glyph by '?'. */
std::string ToAscii(const std::string& Text)
{
	std::string Ascii;
	for (const char Character : Text)
	{
		const unsigned char Byte = static_cast<unsigned char>(Character);
		if ((Byte & 0xC0) != 0x80) // not within a sequence of UTF-8
		{
			Ascii += Byte >= ' ' && Byte <= '~' ? Character : '?';
		}
	}
	return Ascii;
}

double GetDistance(const FPoint& Point, const FPoint& A, const FPoint& B)
{
	const double X = B.X - A.X, Y = B.Y - A.Y;
	const double Square = X * X + Y * Y;
	const double Along =
		Square > 0.0 ? std::clamp(((Point.X - A.X) * X + (Point.Y - A.Y) * Y) / Square, 0.0, 1.0) : 0.0;
	return std::hypot(Point.X - A.X - Along * X, Point.Y - A.Y - Along * Y);
}

double GetDistance(const FPoint& Point, const FGlyph& Glyph)
{
	double Distance = HUGE_VAL;
	for (const FStroke& Stroke : Glyph.Strokes)
	{
		for (size_t Index = 0; Index + 1 < Stroke.size(); ++Index)
		{
			Distance = std::min(Distance, GetDistance(Point, Stroke[Index], Stroke[Index + 1]));
		}
	}
	return Distance;
}

void DrawGlyph(FImage& Picture, double Left, double Baseline, const FGlyph& Glyph, double Unit, const FTextColor& Color)
{
	const int MinX = std::max(0, ToInteger<int>(std::floor(Left - Unit)));
	const int MaxX = std::min(Picture.Width, ToInteger<int>(std::ceil(Left + (Glyph.Width + 1.0) * Unit)));
	const int MinY = std::max(0, ToInteger<int>(std::floor(Baseline - AscentUnits * Unit)));
	const int MaxY = std::min(Picture.Height, ToInteger<int>(std::ceil(Baseline + DescentUnits * Unit)));
	const double HalfPen = 0.5 * std::max(StrokeUnits * Unit, 1.0);
	for (int Y = MinY; Y < MaxY; ++Y)
	{
		for (int X = MinX; X < MaxX; ++X)
		{
			const FPoint Point{(X + 0.5 - Left) / Unit, (Baseline - Y - 0.5) / Unit};
			const double Coverage = std::clamp(HalfPen + 0.5 - GetDistance(Point, Glyph) * Unit, 0.0, 1.0);
			double* const Pixel =
				&Picture.Values[(static_cast<size_t>(Y) * static_cast<size_t>(Picture.Width) + static_cast<size_t>(X)) *
								3];
			for (size_t Channel = 0; Channel < 3; ++Channel)
			{
				Pixel[Channel] += (Color[Channel] - Pixel[Channel]) * Coverage;
			}
		}
	}
}

} // namespace

double GetStrokeTextWidth(const std::string& Text, double CapHeight)
{
	double Units = 0.0;
	for (const char Letter : ToAscii(Text))
	{
		Units += (Units > 0.0 ? GapUnits : 0.0) + GetGlyph(Letter).Width;
	}
	return Units * CapHeight / CapUnits;
}

void DrawStrokeText(
	FImage& Picture, double X, double Baseline, const std::string& Text, double CapHeight, const FTextColor& Color)
{
	const double Unit = CapHeight / CapUnits;
	for (const char Letter : ToAscii(Text))
	{
		const FGlyph& Glyph = GetGlyph(Letter);
		DrawGlyph(Picture, X, Baseline, Glyph, Unit, Color);
		X += (Glyph.Width + GapUnits) * Unit;
	}
}

std::string FitStrokeText(const std::string& Text, double CapHeight, double Width)
{
	std::string Fitting = ToAscii(Text);
	if (GetStrokeTextWidth(Fitting, CapHeight) <= Width)
	{
		return Fitting;
	}
	while (!Fitting.empty() && GetStrokeTextWidth(Fitting + "...", CapHeight) > Width)
	{
		Fitting.pop_back();
	}
	return GetStrokeTextWidth(Fitting + "...", CapHeight) <= Width ? Fitting + "..." : "";
}

} // namespace Drydock
