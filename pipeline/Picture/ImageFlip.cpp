// Computes FLIP: colours filtered as the eye does and compared, edges and points compared, and both put together.
#include "Picture/ImageFlip.h"

#include "Math/ToInteger.h"
#include "TileExecutor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace Drydock
{

namespace
{

using FColor = std::array<double, 3>;
using FValues = std::vector<double>;

/** From linear sRGB to XYZ, D65. Source: IEC 61966-2-1, to more digits. */
constexpr std::array<FColor, 3> ToXyzRows = {{{0.4123907993, 0.3575843394, 0.1804807884},
	{0.2126390059, 0.7151686788, 0.0721923154}, {0.0193308187, 0.1191947798, 0.9505321522}}};
constexpr std::array<FColor, 3> FromXyzRows = {{{3.2409699419, -1.5373831776, -0.4986107603},
	{-0.9692436363, 1.8759675015, 0.0415550574}, {0.0556300797, -0.2039769589, 1.0569715142}}};

FColor Multiply(const std::array<FColor, 3>& Rows, const FColor& Color)
{
	FColor Result;
	for (size_t Row = 0; Row < 3; ++Row)
	{
		Result[Row] = Rows[Row][0] * Color[0] + Rows[Row][1] * Color[1] + Rows[Row][2] * Color[2];
	}
	return Result;
}

/** XYZ for 1 of the white. */
FColor ToRelativeXyz(const FColor& Linear)
{
	static const FColor White = Multiply(ToXyzRows, {1.0, 1.0, 1.0});
	const FColor Xyz = Multiply(ToXyzRows, Linear);
	return {Xyz[0] / White[0], Xyz[1] / White[1], Xyz[2] / White[2]};
}

/** The opponent space YCxCz, whose axes are those of CIELab without the cube root. */
FColor ToOpponent(const FColor& Linear)
{
	const FColor Xyz = ToRelativeXyz(Linear);
	return {116.0 * Xyz[1] - 16.0, 500.0 * (Xyz[0] - Xyz[1]), 200.0 * (Xyz[1] - Xyz[2])};
}

FColor FromOpponent(const FColor& Opponent)
{
	static const FColor White = Multiply(ToXyzRows, {1.0, 1.0, 1.0});
	const double Y = (Opponent[0] + 16.0) / 116.0;
	return Multiply(
		FromXyzRows, {(Y + Opponent[1] / 500.0) * White[0], Y * White[1], (Y - Opponent[2] / 200.0) * White[2]});
}

/** CIELab whose colours fade where it is dark (Hunt's effect). */
FColor ToHuntLab(const FColor& Linear)
{
	const auto Root = [](double Value)
	{
		constexpr double Delta = 6.0 / 29.0;
		return Value > Delta * Delta * Delta ? std::cbrt(Value) : Value / (3.0 * Delta * Delta) + 4.0 / 29.0;
	};
	const FColor Xyz = ToRelativeXyz(Linear);
	const double X = Root(Xyz[0]), Y = Root(Xyz[1]), Z = Root(Xyz[2]);
	const double Light = 116.0 * Y - 16.0;
	return {Light, 0.01 * Light * 500.0 * (X - Y), 0.01 * Light * 200.0 * (Y - Z)};
}

/** Distance of large colour differences: lightness and chroma apart (HyAB). */
double GetDistance(const FColor& A, const FColor& B)
{
	return std::abs(A[0] - B[0]) + std::hypot(A[1] - B[1], A[2] - B[2]);
}

struct FSize
{
	int Width;
	int Height;
};

/** Calls Function(Y) for each row, on all cores. */
template<typename TFunction>
void ForEachRow(FSize Size, const TFunction& Function)
{
	constexpr int RowsPerTile = 16;
	ForEachTile(FKernelTile{0, 0, 0, Size.Height, 1, 1}, FIntPoint(RowsPerTile, 1),
		[&](const FKernelTile& Tile)
		{
			for (int Y = Tile.MinX; Y < Tile.MaxX; ++Y)
			{
				Function(Y);
			}
		});
}

size_t GetIndex(FSize Size, int X, int Y)
{
	return static_cast<size_t>(Y) * static_cast<size_t>(Size.Width) + static_cast<size_t>(X);
}

/** Weights along x, then along y; the border is repeated. */
FValues Filter(const FValues& Values, FSize Size, const FValues& AlongX, const FValues& AlongY)
{
	const int Radius = static_cast<int>(AlongX.size() / 2);
	FValues Rows(Values.size());
	FValues Result(Values.size());
	const auto Sum = [&](const FValues& From, const FValues& Weights, const auto& GetPlace)
	{
		double Value = 0.0;
		for (int Tap = -Radius; Tap <= Radius; ++Tap)
		{
			Value += Weights[static_cast<size_t>(Tap + Radius)] * From[GetPlace(Tap)];
		}
		return Value;
	};
	ForEachRow(Size,
		[&](int Y)
		{
			for (int X = 0; X < Size.Width; ++X)
			{
				Rows[GetIndex(Size, X, Y)] = Sum(
					Values, AlongX, [&](int Tap) { return GetIndex(Size, std::clamp(X + Tap, 0, Size.Width - 1), Y); });
			}
		});
	ForEachRow(Size,
		[&](int Y)
		{
			for (int X = 0; X < Size.Width; ++X)
			{
				Result[GetIndex(Size, X, Y)] = Sum(
					Rows, AlongY, [&](int Tap) { return GetIndex(Size, X, std::clamp(Y + Tap, 0, Size.Height - 1)); });
			}
		});
	return Result;
}

FValues MakeWeights(int Radius, const auto& GetWeight)
{
	FValues Weights;
	for (int Tap = -Radius; Tap <= Radius; ++Tap)
	{
		Weights.push_back(GetWeight(static_cast<double>(Tap)));
	}
	return Weights;
}

/** Scales the positive weights so that they sum to 1, and the negative ones to -1. */
FValues Normalise(FValues Weights)
{
	double Positive = 0.0, Negative = 0.0;
	for (const double Weight : Weights)
	{
		(Weight > 0.0 ? Positive : Negative) += std::abs(Weight);
	}
	for (double& Weight : Weights)
	{
		Weight /= Weight > 0.0 ? Positive : Weight < 0.0 ? Negative : 1.0;
	}
	return Weights;
}

/** A term of the eye's contrast sensitivity as a Gaussian over degrees. Source: the paper's table 1. */
struct FSensitivity
{
	size_t Channel;
	double A;
	double B;
};

constexpr std::array<FSensitivity, 4> Sensitivities = {
	{{0, 1.0, 0.0047}, {1, 1.0, 0.0053}, {2, 34.1, 0.04}, {2, 13.5, 0.025}}};
constexpr double Pi = 3.14159265358979323846;

using FPlanes = std::array<FValues, 3>;

/** The colours as the eye resolves them, from YCxCz to the Lab that differences are taken in. */
std::vector<FColor> FilterColors(const FPlanes& Opponent, FSize Size)
{
	const int Radius = ToCount(std::ceil(3.0 * std::sqrt(0.04 / (2.0 * Pi * Pi)) * FlipPixelsPerDegree), 1, 1000);
	FPlanes Filtered;
	std::array<double, 3> Sums = {};
	for (const FSensitivity& Term : Sensitivities)
	{
		const FValues Weights = MakeWeights(Radius,
			[&](double Tap)
			{
				const double Degrees = Tap / FlipPixelsPerDegree;
				return std::exp(-Pi * Pi * Degrees * Degrees / Term.B);
			});
		double Sum = 0.0;
		for (const double Weight : Weights)
		{
			Sum += Weight;
		}
		const double Scale = Term.A * std::sqrt(Pi / Term.B);
		Sums[Term.Channel] += Scale * Sum * Sum;
		const FValues Part = Filter(Opponent[Term.Channel], Size, Weights, Weights);
		FValues& Whole = Filtered[Term.Channel];
		Whole.resize(Part.size());
		for (size_t Index = 0; Index < Part.size(); ++Index)
		{
			Whole[Index] += Scale * Part[Index];
		}
	}
	std::vector<FColor> Colors(Opponent[0].size());
	ForEachRow(Size,
		[&](int Y)
		{
			for (int X = 0; X < Size.Width; ++X)
			{
				const size_t Index = GetIndex(Size, X, Y);
				FColor Linear = FromOpponent(
					{Filtered[0][Index] / Sums[0], Filtered[1][Index] / Sums[1], Filtered[2][Index] / Sums[2]});
				for (double& Value : Linear)
				{
					Value = std::clamp(Value, 0.0, 1.0);
				}
				Colors[Index] = ToHuntLab(Linear);
			}
		});
	return Colors;
}

/** How strong edges (first derivative of a Gaussian) or points (second derivative) are at each pixel. */
FValues DetectFeatures(const FValues& Light, FSize Size, bool bPoints)
{
	const double Sigma = 0.5 * 0.082 * FlipPixelsPerDegree;
	const int Radius = ToCount(std::ceil(3.0 * Sigma), 1, 1000);
	const auto Gauss = [&](double Tap)
	{
		return std::exp(-Tap * Tap / (2.0 * Sigma * Sigma));
	};
	const FValues Smooth = Normalise(MakeWeights(Radius, Gauss));
	const FValues Derived = Normalise(MakeWeights(
		Radius, [&](double Tap) { return (bPoints ? Tap * Tap / (Sigma * Sigma) - 1.0 : -Tap) * Gauss(Tap); }));
	FValues Strength = Filter(Light, Size, Derived, Smooth);
	const FValues AlongY = Filter(Light, Size, Smooth, Derived);
	for (size_t Index = 0; Index < Strength.size(); ++Index)
	{
		Strength[Index] = std::hypot(Strength[Index], AlongY[Index]);
	}
	return Strength;
}

/** A picture on its way through both pipelines. */
struct FSeen
{
	std::vector<FColor> Colors;
	FValues Edges;
	FValues Points;
};

FSeen See(const FImage& Image, EImageEncoding Encoding)
{
	const FSize Size{Image.Width, Image.Height};
	const size_t NumPixels = static_cast<size_t>(Image.Width) * static_cast<size_t>(Image.Height);
	FPlanes Opponent = {FValues(NumPixels), FValues(NumPixels), FValues(NumPixels)};
	FValues Light(NumPixels);
	ForEachRow(Size,
		[&](int Y)
		{
			for (int X = 0; X < Size.Width; ++X)
			{
				FColor Linear;
				for (int Channel = 0; Channel < 3; ++Channel)
				{
					const double Value = Image.Get(X, Y, Image.NumChannels >= 3 ? Channel : 0);
					const double Clamped = Value > 0.0 ? std::min(Value, 1.0) : 0.0;
					Linear[static_cast<size_t>(Channel)] = Encoding == EImageEncoding::Linear ? Clamped
														   : Clamped <= 0.04045
															   ? Clamped / 12.92
															   : std::pow((Clamped + 0.055) / 1.055, 2.4);
				}
				const FColor Color = ToOpponent(Linear);
				const size_t Index = GetIndex(Size, X, Y);
				for (size_t Channel = 0; Channel < 3; ++Channel)
				{
					Opponent[Channel][Index] = Color[Channel];
				}
				Light[Index] = (Color[0] + 16.0) / 116.0;
			}
		});
	return {FilterColors(Opponent, Size), DetectFeatures(Light, Size, false), DetectFeatures(Light, Size, true)};
}

/** Small differences take most of 0..1: up to 0.4 of the largest becomes up to 0.95. */
double Redistribute(double Distance)
{
	constexpr double Exponent = 0.7;
	static const double Largest =
		std::pow(GetDistance(ToHuntLab({0.0, 1.0, 0.0}), ToHuntLab({0.0, 0.0, 1.0})), Exponent);
	constexpr double Part = 0.4;
	constexpr double PartBecomes = 0.95;
	const double Error = std::pow(Distance, Exponent);
	const double Bend = Part * Largest;
	return Error < Bend ? Error * PartBecomes / Bend
						: PartBecomes + (Error - Bend) / (Largest - Bend) * (1.0 - PartBecomes);
}

} // namespace

std::vector<double> ComputeFlip(const FImage& A, const FImage& B, EImageEncoding Encoding)
{
	if (A.Width != B.Width || A.Height != B.Height || A.NumChannels != B.NumChannels)
	{
		throw std::logic_error("images of different sizes are compared");
	}
	std::vector<double> Flip(static_cast<size_t>(A.Width) * static_cast<size_t>(A.Height));
	if (Flip.empty())
	{
		return Flip;
	}
	const FSeen SeenA = See(A, Encoding);
	const FSeen SeenB = See(B, Encoding);
	const FSize Size{A.Width, A.Height};
	ForEachRow(Size,
		[&](int Y)
		{
			for (int X = 0; X < Size.Width; ++X)
			{
				const size_t Index = GetIndex(Size, X, Y);
				const double OfColor = Redistribute(GetDistance(SeenA.Colors[Index], SeenB.Colors[Index]));
				const double Feature = std::max(std::abs(SeenA.Edges[Index] - SeenB.Edges[Index]),
					std::abs(SeenA.Points[Index] - SeenB.Points[Index]));
				Flip[Index] = std::pow(OfColor, 1.0 - std::sqrt(Feature / std::sqrt(2.0)));
			}
		});
	return Flip;
}

double GetMeanFlip(const std::vector<double>& Flip)
{
	double Sum = 0.0;
	for (const double Value : Flip)
	{
		Sum += Value;
	}
	return Flip.empty() ? 0.0 : Sum / static_cast<double>(Flip.size());
}

} // namespace Drydock
