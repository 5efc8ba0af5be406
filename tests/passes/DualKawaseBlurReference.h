// The dual Kawase blur a second time, in double, as a direct sum over taps; and impulse responses measured. Shares no
// code with the passes. Source: formulas of Bjorge, SIGGRAPH 2015.
#pragma once

#include "PassReference.h"

#include <cmath>
#include <functional>
#include <vector>

namespace DualKawaseReference
{

using namespace PassReference;

/** Taps lie on the sampler's grid. */
inline double ToGrid(double Texels)
{
	return std::round(Texels * 256) / 256;
}

struct FTap
{
	double X, Y, Weight;
};

inline FImage Average(const FImage& In, int Width, int Height, double InPerOut, const std::vector<FTap>& Taps)
{
	const FRect Whole{0, 0, In.Width, In.Height};
	double Sum = 0;
	for (const FTap& Tap : Taps)
	{
		Sum += Tap.Weight;
	}
	return FImage::Make(Width, Height,
		[&](int X, int Y)
		{
			FTexel Color{0, 0, 0, 0};
			for (const FTap& Tap : Taps)
			{
				Color =
					Color + SampleInRect(In, Whole, (X + 0.5) * InPerOut + Tap.X, (Y + 0.5) * InPerOut + Tap.Y, false) *
								(Tap.Weight / Sum);
			}
			return Color;
		});
}

/** Five taps; output pixel x lies at texel coordinate 2x + 1. */
inline FImage Down(const FImage& In, double Offset)
{
	const double D = ToGrid(Offset);
	return Average(
		In, CeilHalf(In.Width), CeilHalf(In.Height), 2, {{0, 0, 4}, {-D, -D, 1}, {D, -D, 1}, {-D, D, 1}, {D, D, 1}});
}

/** Eight taps; output pixel x lies at texel coordinate (x + 1/2) / 2. */
inline FImage Up(const FImage& In, int Width, int Height, double Offset)
{
	const double A = ToGrid(Offset), D = ToGrid(Offset / 2);
	return Average(In, Width, Height, 0.5,
		{{-A, 0, 1}, {A, 0, 1}, {0, -A, 1}, {0, A, 1}, {-D, -D, 2}, {D, -D, 2}, {-D, D, 2}, {D, D, 2}});
}

inline FImage Blur(const FImage& Image, int Levels, double Offset)
{
	if (Levels == 0)
	{
		return Image;
	}
	return Up(Blur(Down(Image, Offset), Levels - 1, Offset), Image.Width, Image.Height, Offset);
}

/** Sums over pixels of weight, and of weight times distance (x and y) and squared distance (x and y) from a point. */
struct FMoments
{
	double Sum = 0, X = 0, Y = 0, XX = 0, YY = 0;

	FMoments& operator+=(const FMoments& Other)
	{
		Sum += Other.Sum;
		X += Other.X;
		Y += Other.Y;
		XX += Other.XX;
		YY += Other.YY;
		return *this;
	}
};

inline FMoments GetMoments(const FImage& Image, int AtX, int AtY)
{
	FMoments Moments;
	for (int Y = 0; Y < Image.Height; ++Y)
	{
		for (int X = 0; X < Image.Width; ++X)
		{
			const double Weight = Image.At(X, Y)[0], DX = X - AtX, DY = Y - AtY;
			Moments += {Weight, Weight * DX, Weight * DY, Weight * DX * DX, Weight * DY * DY};
		}
	}
	return Moments;
}

inline FImage Impulse(int Width, int Height, int X, int Y, double Value = 1)
{
	FImage Image(Width, Height);
	Image.At(X, Y) = {Value, Value, Value, Value};
	return Image;
}

/** Moments of the responses to all impulses of a block of Size x Size positions in the middle of an image. */
inline FMoments MeasureBlock(int Width, int Height, int Size, const std::function<FImage(const FImage&)>& Blur)
{
	FMoments Moments;
	for (int Y = Height / 2; Y < Height / 2 + Size; ++Y)
	{
		for (int X = Width / 2; X < Width / 2 + Size; ++X)
		{
			Moments += GetMoments(Blur(Impulse(Width, Height, X, Y)), X, Y);
		}
	}
	return Moments;
}

} // namespace DualKawaseReference
