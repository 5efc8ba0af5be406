// Holds the strokes of every letter, drawn for drydock, and paints them into pictures.
#include "Picture/StrokeText.h"

#include "Math/ToInteger.h"
#include "RangeTools.h"

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

/** Width and strokes of a letter in units, y upwards from the baseline. M x y: go there; L x y ...: draw lines; A cx cy
 * rx ry from to: draw on along an arc, degrees counterclockwise from the right; N the same, as a new stroke. */
struct FGlyphText
{
	double Width;
	const char* Strokes;
};

/** From blank to tilde. */
constexpr FGlyphText GlyphTexts[] = {
	{1.6, ""},
	{0.6, "M .3 7 L .3 2.2 M .3 0 L .3 .1"},
	{2.2, "M .3 7 L .3 5 M 1.9 7 L 1.9 5"},
	{5.4, "M 1.4 0 L 2.2 7 M 3.6 0 L 4.4 7 M .4 4.7 L 5.2 4.7 M .2 2.3 L 5 2.3"},
	{4.3, "N 2.2 5.2 1.9 1.8 30 270 A 2.2 1.7 2.1 1.7 90 -150 M 2.2 8 L 2.2 -1"},
	{6.0, "N 1.2 5.5 1.2 1.5 0 360 N 4.8 1.5 1.2 1.5 0 360 M 4.9 7 L 1.1 0"},
	{5.2, "M 5.2 0 L 1.3 4.8 A 2.3 5.7 1.2 1.3 205 -30 L 1 3.4 A 2 1.8 2 1.8 120 300 L 4.9 3.2"},
	{0.6, "M .3 7 L .3 5"},
	{1.8, "N 3 2.75 3 5 115 245"},
	{1.8, "N -1.2 2.75 3 5 65 -65"},
	{3.2, "M 1.6 6.8 L 1.6 3.8 M .3 6.1 L 2.9 4.5 M .3 4.5 L 2.9 6.1"},
	{4.0, "M 2 1 L 2 5 M 0 3 L 4 3"},
	{0.8, "M .6 .2 L 0 -1.3"},
	{2.6, "M 0 2.7 L 2.6 2.7"},
	{0.6, "M .3 0 L .3 .1"},
	{2.8, "M 0 -1 L 2.8 7.5"},
	{4.4, "N 2.2 3.5 2.2 3.5 0 360"},
	{4.4, "M .9 5.5 L 2.5 7 2.5 0"},
	{4.4, "N 2.2 4.9 2.1 2.1 165 -25 L .1 0 4.4 0"},
	{4.4, "N 2.1 5.2 1.9 1.8 150 -90 A 2.1 1.7 2.2 1.7 90 -150"},
	{4.4, "M 3.4 0 L 3.4 7 0 2 4.5 2"},
	{4.4, "M 4 7 L .8 7 .5 3.9 A 2.1 2.25 2.2 2.25 130 -150"},
	{4.4, "N 3 3.4 2.9 3.6 75 180 L .1 2.2 N 2.2 2.2 2.1 2.2 0 360"},
	{4.4, "M 0 7 L 4.4 7 1.5 0"},
	{4.4, "N 2.2 5.25 1.8 1.75 0 360 N 2.2 1.75 2.15 1.75 0 360"},
	{4.4, "N 2.2 4.8 2.1 2.2 0 360 N 1.4 3.6 2.9 3.6 -105 0 L 4.3 4.8"},
	{0.6, "M .3 0 L .3 .1 M .3 4.2 L .3 4.3"},
	{0.9, "M .7 4.2 L .7 4.3 M .6 .2 L 0 -1.3"},
	{3.6, "M 3.6 5.4 L 0 3 3.6 .6"},
	{3.8, "M 0 4 L 3.8 4 M 0 2 L 3.8 2"},
	{3.6, "M 0 5.4 L 3.6 3 0 .6"},
	{3.8, "N 1.9 5.2 1.9 1.8 165 -60 L 1.9 2.9 1.9 2.2 M 1.9 0 L 1.9 .1"},
	{7.0, "N 3.5 3 1.5 1.7 0 360 M 5 4.7 L 5 2 A 6 2 1 1 180 360 L 7 3 A 3.5 3 3.5 3.8 0 300"},
	{5.0, "M 0 0 L 2.5 7 5 0 M .9 2.4 L 4.1 2.4"},
	{4.5, "M 0 0 L 0 7 2.4 7 A 2.4 5.3 1.7 1.7 90 -90 L 0 3.6 M 2.4 3.6 L 2.7 3.6 A 2.7 1.8 1.8 1.8 90 -90 L 0 0"},
	{4.9, "N 2.9 3.5 2.9 3.5 50 310"},
	{4.8, "M 0 0 L 0 7 1.8 7 A 1.8 3.5 3 3.5 90 -90 L 0 0"},
	{4.0, "M 4 7 L 0 7 0 0 4 0 M 0 3.6 L 3.5 3.6"},
	{3.9, "M 4 7 L 0 7 0 0 M 0 3.5 L 3.4 3.5"},
	{5.3, "N 2.9 3.5 2.9 3.5 50 325 L 5.3 3.2 3.2 3.2"},
	{4.8, "M 0 0 L 0 7 M 4.8 0 L 4.8 7 M 0 3.6 L 4.8 3.6"},
	{0.6, "M .3 0 L .3 7"},
	{3.0, "M 2.9 7 L 2.9 1.8 A 1.3 1.8 1.6 1.8 0 -150"},
	{4.5, "M 0 0 L 0 7 M 4.4 7 L 0 2.7 M 1.4 4 L 4.6 0"},
	{3.8, "M 0 7 L 0 0 3.7 0"},
	{5.8, "M 0 0 L 0 7 2.9 1.6 5.8 7 5.8 0"},
	{4.8, "M 0 0 L 0 7 4.8 0 4.8 7"},
	{6.0, "N 3 3.5 3 3.5 0 360"},
	{4.3, "M 0 0 L 0 7 2.4 7 A 2.4 5.1 1.9 1.9 90 -90 L 0 3.2"},
	{6.0, "N 3 3.5 3 3.5 0 360 M 3.6 1.8 L 5.6 -.4"},
	{4.5, "M 0 0 L 0 7 2.4 7 A 2.4 5.1 1.9 1.9 90 -90 L 0 3.2 M 2.3 3.2 L 4.5 0"},
	{4.3, "N 2.2 5.2 1.9 1.8 30 270 A 2.2 1.7 2.1 1.7 90 -150"},
	{4.8, "M 0 7 L 4.8 7 M 2.4 7 L 2.4 0"},
	{4.6, "M 0 7 L 0 2.3 A 2.3 2.3 2.3 2.3 180 360 L 4.6 7"},
	{5.0, "M 0 7 L 2.5 0 5 7"},
	{7.2, "M 0 7 L 1.8 0 3.6 6 5.4 0 7.2 7"},
	{4.6, "M 0 7 L 4.6 0 M 4.6 7 L 0 0"},
	{4.8, "M 0 7 L 2.4 3.4 4.8 7 M 2.4 3.4 L 2.4 0"},
	{4.5, "M 0 7 L 4.4 7 0 0 4.5 0"},
	{1.5, "M 1.4 7.4 L 0 7.4 0 -1.2 1.4 -1.2"},
	{2.8, "M 0 7.5 L 2.8 -1"},
	{1.5, "M 0 7.4 L 1.4 7.4 1.4 -1.2 0 -1.2"},
	{3.4, "M 0 4.6 L 1.7 7 3.4 4.6"},
	{4.0, "M 0 -1.2 L 4 -1.2"},
	{1.0, "M 0 7 L 1 6"},
	{4.0, "N 2 2.5 2 2.5 0 360 M 4 5 L 4 0"},
	{4.0, "M 0 7.4 L 0 0 N 2 2.5 2 2.5 0 360"},
	{3.6, "N 2.1 2.5 2.1 2.5 48 312"},
	{4.0, "N 2 2.5 2 2.5 0 360 M 4 7.4 L 4 0"},
	{4.0, "M 0 2.6 L 4 2.6 A 2 2.5 2 2.5 0 315"},
	{2.4, "N 2.3 6 1.3 1.4 75 180 L 1 0 M 0 4.8 L 2.4 4.8"},
	{4.0, "N 2 2.5 2 2.5 0 360 M 4 5 L 4 -.2 A 2.1 -.2 1.9 1.8 0 -145"},
	{3.6, "M 0 7.4 L 0 0 M 0 3 A 1.8 3.2 1.8 1.8 180 0 L 3.6 0"},
	{0.6, "M .3 5 L .3 0 M .3 6.9 L .3 7"},
	{1.4, "M 1.1 5 L 1.1 -.6 A 0 -.6 1.1 1.3 0 -80 M 1.1 6.9 L 1.1 7"},
	{3.5, "M 0 7.4 L 0 0 M 3.4 5 L 0 1.9 M 1.1 2.9 L 3.6 0"},
	{0.6, "M .3 7.4 L .3 0"},
	{5.8, "M 0 5 L 0 0 M 0 3.4 A 1.45 3.5 1.45 1.5 180 0 L 2.9 0 M 2.9 3.4 A 4.35 3.5 1.45 1.5 180 0 L 5.8 0"},
	{3.6, "M 0 5 L 0 0 M 0 3 A 1.8 3.2 1.8 1.8 180 0 L 3.6 0"},
	{4.2, "N 2.1 2.5 2.1 2.5 0 360"},
	{4.0, "M 0 5 L 0 -2 N 2 2.5 2 2.5 0 360"},
	{4.0, "M 4 5 L 4 -2 N 2 2.5 2 2.5 0 360"},
	{2.4, "M 0 5 L 0 0 M 0 2.8 A 2 3 2 2 180 75"},
	{3.3, "N 1.65 3.75 1.45 1.25 35 270 A 1.65 1.25 1.6 1.25 90 -150"},
	{2.4, "M 1 6.6 L 1 1.3 A 2.2 1.3 1.2 1.3 180 285 M 0 4.8 L 2.4 4.8"},
	{3.6, "M 0 5 L 0 1.8 A 1.8 1.8 1.8 1.8 180 360 M 3.6 5 L 3.6 0"},
	{3.8, "M 0 5 L 1.9 0 3.8 5"},
	{5.6, "M 0 5 L 1.4 0 2.8 4.4 4.2 0 5.6 5"},
	{3.4, "M 0 5 L 3.4 0 M 3.4 5 L 0 0"},
	{3.8, "M 0 5 L 1.95 0 M 3.8 5 L 1.2 -2"},
	{3.4, "M 0 5 L 3.3 5 0 0 3.4 0"},
	{2.0, "N 2 6 .9 1.3 90 180 L 1.1 4.4 .2 3 1.1 1.6 1.1 0 A 2 0 .9 1.2 180 270"},
	{0.6, "M .3 7.6 L .3 -1.6"},
	{2.0, "N 0 6 .9 1.3 90 0 L .9 4.4 1.8 3 .9 1.6 .9 0 A 0 0 .9 1.2 0 -90"},
	{4.0, "N 1 2.6 1 .8 180 0 A 3 2.6 1 .8 180 360"},
};
constexpr char FirstLetter = ' ';
constexpr size_t NumLetters = sizeof(GlyphTexts) / sizeof(GlyphTexts[0]);
static_assert(NumLetters == '~' - FirstLetter + 1);

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

FGlyph ParseGlyph(const FGlyphText& Source)
{
	FGlyph Glyph{Source.Width, {}};
	std::istringstream Text(Source.Strokes);
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
	static const std::vector<FGlyph> Glyphs = []
	{
		return ToVector<FGlyph>(GlyphTexts, [&](const FGlyphText& Text) { return ParseGlyph(Text); });
	}();
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
