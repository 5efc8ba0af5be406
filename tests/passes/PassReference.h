// Independent double computations of what the passes do, written from their formulas: sampling, downsampling, bloom
// setup, the Gaussian blur as a direct sum, the film curve from published primaries. Shares no code with the passes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

namespace PassReference
{

using FTexel = std::array<double, 4>;

inline FTexel operator+(const FTexel& A, const FTexel& B)
{
	return {A[0] + B[0], A[1] + B[1], A[2] + B[2], A[3] + B[3]};
}
inline FTexel operator*(const FTexel& A, double S)
{
	return {A[0] * S, A[1] * S, A[2] * S, A[3] * S};
}

/** Row-major RGBA. */
struct FImage
{
	int Width = 0;
	int Height = 0;
	std::vector<FTexel> Texels;

	FImage() = default;
	FImage(int InWidth, int InHeight, const FTexel& Color = {0, 0, 0, 0})
		: Width(InWidth)
		, Height(InHeight)
		, Texels(static_cast<size_t>(InWidth) * InHeight, Color)
	{
	}

	FTexel& At(int X, int Y) { return Texels[static_cast<size_t>(Y) * Width + X]; }
	const FTexel& At(int X, int Y) const { return Texels[static_cast<size_t>(Y) * Width + X]; }

	static FImage Make(int Width, int Height, const std::function<FTexel(int, int)>& Color)
	{
		FImage Image(Width, Height);
		for (int Y = 0; Y < Height; ++Y)
		{
			for (int X = 0; X < Width; ++X)
			{
				Image.At(X, Y) = Color(X, Y);
			}
		}
		return Image;
	}

	/** Multiples of 1/64 in 0..Range, alpha 1: exact in every float format. */
	static FImage Noise(int Width, int Height, double Range = 1.0, unsigned Seed = 1)
	{
		std::mt19937 Random(Seed);
		std::uniform_int_distribution<int> Step(0, 64);
		return Make(Width, Height,
			[&](int, int) {
				return FTexel{Step(Random) * Range / 64, Step(Random) * Range / 64, Step(Random) * Range / 64, 1};
			});
	}
};

/** Half-open. */
struct FRect
{
	int MinX, MinY, MaxX, MaxY;

	int Width() const { return MaxX - MinX; }
	int Height() const { return MaxY - MinY; }
};

enum class EAddress
{
	Clamp,
	Border,
	Mirror
};

/** D3D bilinear: texel centres at +0.5, coordinates in texels. Snapped: to the nearest 1/256 first. */
inline FTexel SampleBilinear(const FImage& Image, double X, double Y, EAddress Address, bool bSnap)
{
	if (bSnap)
	{
		X = std::floor(X * 256 + 0.5) / 256;
		Y = std::floor(Y * 256 + 0.5) / 256;
	}
	X -= 0.5;
	Y -= 0.5;
	const double FloorX = std::floor(X), FloorY = std::floor(Y);
	const double FractionX = X - FloorX, FractionY = Y - FloorY;

	const auto Resolve = [Address](int Index, int Size) -> int
	{
		switch (Address)
		{
		case EAddress::Clamp:
			return std::clamp(Index, 0, Size - 1);
		case EAddress::Border:
			return Index < 0 || Index >= Size ? -1 : Index;
		default:
			const int Period = ((Index % (2 * Size)) + 2 * Size) % (2 * Size);
			return Period < Size ? Period : 2 * Size - 1 - Period;
		}
	};
	const auto Fetch = [&](int TexelX, int TexelY) -> FTexel
	{
		TexelX = Resolve(TexelX, Image.Width);
		TexelY = Resolve(TexelY, Image.Height);
		return TexelX < 0 || TexelY < 0 ? FTexel{0, 0, 0, 0} : Image.At(TexelX, TexelY);
	};

	FTexel Sum{0, 0, 0, 0};
	for (int Corner = 0; Corner < 4; ++Corner)
	{
		const int Right = Corner & 1, Down = Corner >> 1;
		const double Weight = (Right ? FractionX : 1 - FractionX) * (Down ? FractionY : 1 - FractionY);
		if (Weight != 0)
		{
			Sum = Sum + Fetch(static_cast<int>(FloorX) + Right, static_cast<int>(FloorY) + Down) * Weight;
		}
	}
	return Sum;
}

/** Bilinear with the coordinate kept half a texel inside Rect. */
inline FTexel SampleInRect(const FImage& Image, const FRect& Rect, double X, double Y, bool bSnap)
{
	X = std::clamp(X, Rect.MinX + 0.5, Rect.MaxX - 0.5);
	Y = std::clamp(Y, Rect.MinY + 0.5, Rect.MaxY - 0.5);
	return SampleBilinear(Image, X, Y, EAddress::Clamp, bSnap);
}

inline int CeilHalf(int Value)
{
	return (Value + 1) / 2;
}

inline FImage Crop(const FImage& Image, const FRect& Rect)
{
	return FImage::Make(
		Rect.Width(), Rect.Height(), [&](int X, int Y) { return Image.At(Rect.MinX + X, Rect.MinY + Y); });
}

/** The rect's content at half size: one tap, or four at one texel with negatives cut off. */
inline FImage Downsample(const FImage& Image, const FRect& In, const FRect& Out, bool bHighQuality, bool bSnap)
{
	return FImage::Make(Out.Width(), Out.Height(),
		[&](int X, int Y)
		{
			const double U = In.MinX + (X + 0.5) * In.Width() / Out.Width();
			const double V = In.MinY + (Y + 0.5) * In.Height() / Out.Height();
			if (!bHighQuality)
			{
				return SampleInRect(Image, In, U, V, bSnap);
			}
			FTexel Sum{0, 0, 0, 0};
			for (int Corner = 0; Corner < 4; ++Corner)
			{
				Sum = Sum + SampleInRect(Image, In, U + (Corner & 1 ? 1 : -1), V + (Corner & 2 ? 1 : -1), bSnap) * 0.25;
			}
			return FTexel{std::max(0.0, Sum[0]), std::max(0.0, Sum[1]), std::max(0.0, Sum[2]), Sum[3]};
		});
}

inline double Luminance(const FTexel& Color)
{
	return 0.3 * Color[0] + 0.59 * Color[1] + 0.11 * Color[2];
}

/** Threshold -1: none. */
inline FTexel BloomSetup(const FTexel& Color, double Threshold, double ExposureScale, double PreExposure)
{
	FTexel Linear{};
	for (int Channel = 0; Channel < 3; ++Channel)
	{
		Linear[Channel] = std::min(Color[Channel] / PreExposure, 65536.0);
	}
	const double Amount =
		Threshold > -1 ? std::clamp((Luminance(Linear) * ExposureScale - Threshold) / 2, 0.0, 1.0) : 1.0;
	return {Linear[0] * Amount * PreExposure, Linear[1] * Amount * PreExposure, Linear[2] * Amount * PreExposure, 0};
}

/** Weights of the texels -Reach .. Reach, summing to 1. */
inline std::vector<double> GaussianWeights(double Radius, int Reach)
{
	std::vector<double> Weights;
	double Sum = 0;
	for (int X = -Reach; X <= Reach; ++X)
	{
		Weights.push_back(std::exp(-16.7 * X * X / (Radius * Radius)));
		Sum += Weights.back();
	}
	for (double& Weight : Weights)
	{
		Weight /= Sum;
	}
	return Weights;
}

/** The blur of a whole image as a direct sum over texels: first rows, then columns. */
inline FImage GaussianBlur(const FImage& Image, double Radius, int Reach, EAddress Address)
{
	const std::vector<double> Weights = GaussianWeights(Radius, Reach);
	const auto Pass = [&](const FImage& In, int StepX, int StepY)
	{
		return FImage::Make(In.Width, In.Height,
			[&](int X, int Y)
			{
				FTexel Sum{0, 0, 0, 0};
				for (int Tap = -Reach; Tap <= Reach; ++Tap)
				{
					Sum = Sum + SampleBilinear(In, X + 0.5 + Tap * StepX, Y + 0.5 + Tap * StepY, Address, false) *
									Weights[Tap + Reach];
				}
				return Sum;
			});
	};
	return Pass(Pass(Image, 1, 0), 0, 1);
}

/** The same where the rows are blurred at half width: taps in pairs of texels from -Reach up, between which the
 * half-width positions fall, then columns at full width from the bilinearly stretched rows. */
inline FImage FastGaussianBlur(const FImage& Image, double Radius, int Reach, EAddress Address)
{
	const std::vector<double> Weights = GaussianWeights(Radius, Reach);
	const int HalfWidth = CeilHalf(Image.Width);
	const FImage Rows = FImage::Make(HalfWidth, Image.Height,
		[&](int X, int Y)
		{
			FTexel Sum{0, 0, 0, 0};
			for (int Tap = -Reach; Tap <= Reach; Tap += 2)
			{
				const double First = Weights[Tap + Reach], Second = Tap == Reach ? 0.0 : Weights[Tap + 1 + Reach];
				const double Offset = Tap + Second / (First + Second);
				Sum =
					Sum + SampleBilinear(Image, (X + 0.5) * Image.Width / HalfWidth + Offset, Y + 0.5, Address, false) *
							  (First + Second);
			}
			return Sum;
		});
	return FImage::Make(Image.Width, Image.Height,
		[&](int X, int Y)
		{
			FTexel Sum{0, 0, 0, 0};
			for (int Tap = -Reach; Tap <= Reach; ++Tap)
			{
				Sum = Sum + SampleBilinear(Rows, (X + 0.5) * HalfWidth / Image.Width, Y + 0.5 + Tap, Address, false) *
								Weights[Tap + Reach];
			}
			return Sum;
		});
}

inline double SumOf(const FImage& Image, int Channel)
{
	double Sum = 0;
	for (const FTexel& Texel : Image.Texels)
	{
		Sum += Texel[Channel];
	}
	return Sum;
}

/** Largest |A - B| over texels and colour channels; infinity when sizes differ or one is not a number. */
inline double MaxDifference(const FImage& A, const FImage& B, int Channels = 3)
{
	if (A.Width != B.Width || A.Height != B.Height)
	{
		return HUGE_VAL;
	}
	double Largest = 0;
	for (size_t Index = 0; Index < A.Texels.size(); ++Index)
	{
		for (int Channel = 0; Channel < Channels; ++Channel)
		{
			const double Difference = std::abs(A.Texels[Index][Channel] - B.Texels[Index][Channel]);
			Largest = Difference <= Largest ? Largest : (std::isnan(Difference) ? HUGE_VAL : Difference);
		}
	}
	return Largest;
}

} // namespace PassReference
