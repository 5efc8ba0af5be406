// Computes error figures of two images, and the map of where they differ.
#include "Picture/ImageMetrics.h"

#include "Math/ToInteger.h"
#include "Picture/ImageFlip.h"
#include "Text/ConfigErrors.h"
#include "TileExecutor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace Drydock
{

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

bool IsSame(double A, double B)
{
	return A == B || (std::isnan(A) && std::isnan(B));
}

int GetNumChannels(const FImage& Image, int Wanted)
{
	return Wanted > 0 ? std::min(Wanted, Image.NumChannels) : Image.NumChannels;
}

void CheckComparable(const FImage& A, const FImage& B)
{
	if (A.Width != B.Width || A.Height != B.Height || A.NumChannels != B.NumChannels)
	{
		throw std::logic_error("images of different sizes are compared");
	}
}

/** Weights of SSIM's window along one axis; they sum to 1. */
std::vector<double> MakeWindow(int Size)
{
	constexpr double Sigma = 1.5;
	std::vector<double> Weights(static_cast<size_t>(Size));
	double Sum = 0.0;
	for (int Index = 0; Index < Size; ++Index)
	{
		const double Distance = Index - (Size - 1) / 2.0;
		Weights[static_cast<size_t>(Index)] = std::exp(-0.5 * Distance * Distance / (Sigma * Sigma));
		Sum += Weights[static_cast<size_t>(Index)];
	}
	for (double& Weight : Weights)
	{
		Weight /= Sum;
	}
	return Weights;
}

/** One number per pixel. */
struct FPlane
{
	int Width = 0;
	int Height = 0;
	std::vector<double> Values;
};

FPlane MakeLuminance(const FImage& Image, EImageEncoding Encoding)
{
	constexpr double Weights[3] = {0.2126, 0.7152, 0.0722};
	const auto Display = [&](double Value)
	{
		return Encoding == EImageEncoding::Linear ? EncodeDisplay(Value)
			   : std::isnan(Value)                ? 0.0
												  : std::clamp(Value, 0.0, 1.0);
	};
	FPlane Plane{Image.Width, Image.Height,
		std::vector<double>(static_cast<size_t>(Image.Width) * static_cast<size_t>(Image.Height))};
	constexpr int RowsPerTile = 32;
	ForEachTile(FKernelTile{0, 0, 0, Image.Height, 1, 1}, FIntPoint(RowsPerTile, 1),
		[&](const FKernelTile& Tile)
		{
			for (int Y = Tile.MinX; Y < Tile.MaxX; ++Y)
			{
				for (int X = 0; X < Image.Width; ++X)
				{
					double Value = 0.0;
					for (int Channel = 0; Channel < 3 && Image.NumChannels >= 3; ++Channel)
					{
						Value += Weights[Channel] * Display(Image.Get(X, Y, Channel));
					}
					Plane.Values[static_cast<size_t>(Y) * static_cast<size_t>(Image.Width) + static_cast<size_t>(X)] =
						Image.NumChannels >= 3 ? Value : Display(Image.Get(X, Y, 0));
				}
			}
		});
	return Plane;
}

FPlane Multiply(const FPlane& A, const FPlane& B)
{
	FPlane Product = A;
	std::transform(A.Values.begin(), A.Values.end(), B.Values.begin(), Product.Values.begin(), std::multiplies<>());
	return Product;
}

/** The window's mean at every place where it lies inside. */
FPlane Average(const FPlane& Plane)
{
	constexpr int WindowSize = 11;
	const std::vector<double> Row = MakeWindow(std::min(WindowSize, Plane.Width));
	const std::vector<double> Column = MakeWindow(std::min(WindowSize, Plane.Height));
	const int NumColumns = Plane.Width - static_cast<int>(Row.size()) + 1;
	const int NumRows = Plane.Height - static_cast<int>(Column.size()) + 1;
	FPlane Result{
		NumColumns, NumRows, std::vector<double>(static_cast<size_t>(NumColumns) * static_cast<size_t>(NumRows))};
	constexpr int RowsPerTile = 32;
	ForEachTile(FKernelTile{0, 0, 0, NumRows, 1, 1}, FIntPoint(RowsPerTile, 1),
		[&](const FKernelTile& Tile)
		{
			std::vector<double> Mean(static_cast<size_t>(Plane.Width)); // of a row's columns
			for (int Y = Tile.MinX; Y < Tile.MaxX; ++Y)
			{
				std::fill(Mean.begin(), Mean.end(), 0.0);
				for (size_t Tap = 0; Tap < Column.size(); ++Tap)
				{
					const double* Texel = &Plane.Values[static_cast<size_t>(Y + static_cast<int>(Tap)) * Mean.size()];
					for (size_t X = 0; X < Mean.size(); ++X)
					{
						Mean[X] += Column[Tap] * Texel[X];
					}
				}
				double* Out = &Result.Values[static_cast<size_t>(Y) * static_cast<size_t>(NumColumns)];
				for (size_t Tap = 0; Tap < Row.size(); ++Tap)
				{
					for (size_t X = 0; X < static_cast<size_t>(NumColumns); ++X)
					{
						Out[X] += Row[Tap] * Mean[X + Tap];
					}
				}
			}
		});
	return Result;
}

} // namespace

double EncodeDisplay(double Linear)
{
	const double Clamped = Linear > 0.0 ? std::min(Linear, 1.0) : 0.0;
	return Clamped <= 0.0031308 ? 12.92 * Clamped : 1.055 * std::pow(Clamped, 1.0 / 2.4) - 0.055;
}

double ComputeSsim(const FImage& A, const FImage& B, EImageEncoding Encoding)
{
	CheckComparable(A, B);
	if (A.Width < 1 || A.Height < 1)
	{
		return 1.0;
	}
	constexpr double C1 = 0.01 * 0.01;
	constexpr double C2 = 0.03 * 0.03;
	const FPlane PlaneA = MakeLuminance(A, Encoding);
	const FPlane PlaneB = MakeLuminance(B, Encoding);
	const FPlane MeanA = Average(PlaneA);
	const FPlane MeanB = Average(PlaneB);
	const FPlane SquareA = Average(Multiply(PlaneA, PlaneA));
	const FPlane SquareB = Average(Multiply(PlaneB, PlaneB));
	const FPlane Product = Average(Multiply(PlaneA, PlaneB));
	double Sum = 0.0;
	for (size_t Index = 0; Index < MeanA.Values.size(); ++Index)
	{
		const double MuA = MeanA.Values[Index];
		const double MuB = MeanB.Values[Index];
		const double VarianceA = SquareA.Values[Index] - MuA * MuA;
		const double VarianceB = SquareB.Values[Index] - MuB * MuB;
		const double Covariance = Product.Values[Index] - MuA * MuB;
		Sum += (2.0 * MuA * MuB + C1) * (2.0 * Covariance + C2) /
			   ((MuA * MuA + MuB * MuB + C1) * (VarianceA + VarianceB + C2));
	}
	return Sum / static_cast<double>(MeanA.Values.size());
}

FImageError CompareImages(const FImage& A, const FImage& B, const FImageErrorOptions& Options)
{
	CheckComparable(A, B);
	const int NumChannels = GetNumChannels(A, Options.NumChannels);
	FImageError Error;
	double Squares = 0.0;
	double ReferenceSquares = 0.0;
	for (int Y = 0; Y < A.Height; ++Y)
	{
		// Row by row, so that small errors are not lost in a long sum.
		double RowSquares = 0.0;
		double RowReferenceSquares = 0.0;
		for (int X = 0; X < A.Width; ++X)
		{
			for (int Channel = 0; Channel < NumChannels; ++Channel)
			{
				const double ValueA = A.Get(X, Y, Channel);
				const double ValueB = B.Get(X, Y, Channel);
				const bool bFinite = std::isfinite(ValueA) && std::isfinite(ValueB);
				if (!bFinite && IsSame(ValueA, ValueB))
				{
					continue;
				}
				Error.NumNonFinite += bFinite ? 0 : 1;
				const double Difference = bFinite ? std::abs(ValueA - ValueB) : Infinity;
				if (Difference > Error.Max)
				{
					Error.Max = Difference;
					Error.MaxX = X;
					Error.MaxY = Y;
					Error.MaxChannel = Channel;
					Error.MaxA = ValueA;
					Error.MaxB = ValueB;
				}
				RowSquares += Difference * Difference;
				if (std::isfinite(ValueB))
				{
					RowReferenceSquares += ValueB * ValueB;
					Error.Peak = std::max(Error.Peak, ValueB);
				}
			}
		}
		Squares += RowSquares;
		ReferenceSquares += RowReferenceSquares;
	}
	const double NumValues = static_cast<double>(A.Width) * A.Height * NumChannels;
	Error.Rms = NumValues > 0.0 ? std::sqrt(Squares / NumValues) : 0.0;
	Error.Relative = Squares == 0.0 ? 0.0 : std::sqrt(Squares / ReferenceSquares);
	Error.Psnr = Error.Rms == 0.0 ? Infinity : 20.0 * std::log10(Error.Peak / Error.Rms);
	Error.Ssim = Options.bPerceived ? ComputeSsim(A, B, Options.Encoding) : 1.0;
	Error.Flip = Options.bPerceived && Error.Max > 0.0 ? GetMeanFlip(ComputeFlip(A, B, Options.Encoding)) : 0.0;
	return Error;
}

const std::vector<std::string>& GetMetricNames()
{
	static const std::vector<std::string> Names = {"max", "rms", "relative", "psnr", "ssim", "flip"};
	return Names;
}

double GetMetric(const FImageError& Error, const std::string& Metric)
{
	return Metric == "max"        ? Error.Max
		   : Metric == "rms"      ? Error.Rms
		   : Metric == "relative" ? Error.Relative
		   : Metric == "psnr"     ? Error.Psnr
		   : Metric == "ssim"     ? Error.Ssim
		   : Metric == "flip"     ? Error.Flip
								  : std::numeric_limits<double>::quiet_NaN();
}

bool IsHigherBetter(const std::string& Metric)
{
	return Metric == "psnr" || Metric == "ssim";
}

void GetHeatColor(double Heat, double OutColor[3])
{
	// Black, violet, red, orange, pale yellow: brightness grows all the way, so it reads in grey too.
	static constexpr std::array<std::array<double, 3>, 6> Stops = {{{0.0, 0.0, 0.02}, {0.23, 0.06, 0.44},
		{0.57, 0.15, 0.50}, {0.88, 0.30, 0.31}, {0.99, 0.62, 0.25}, {0.99, 0.97, 0.75}}};
	const double Place = (Heat > 0.0 ? std::min(Heat, 1.0) : 0.0) * static_cast<double>(Stops.size() - 1);
	const size_t Index = static_cast<size_t>(ToIndex(Place, static_cast<int32_t>(Stops.size()) - 1));
	const double Part = Place - static_cast<double>(Index);
	for (size_t Channel = 0; Channel < 3; ++Channel)
	{
		OutColor[Channel] = Stops[Index][Channel] + (Stops[Index + 1][Channel] - Stops[Index][Channel]) * Part;
	}
}

FImage MakeFlipMap(const FImage& A, const FImage& B, EImageEncoding Encoding)
{
	FImage Map{A.Width, A.Height, 3, {}};
	for (const double Value : ComputeFlip(A, B, Encoding))
	{
		double Color[3];
		GetHeatColor(Value, Color);
		Map.Values.insert(Map.Values.end(), Color, Color + 3);
	}
	return Map;
}

FImage MakeHeatMap(const FImage& A, const FImage& B, double Full, int NumChannels)
{
	CheckComparable(A, B);
	constexpr double Decades = 4.0;
	const int Compared = GetNumChannels(A, NumChannels);
	FImage Map{A.Width, A.Height, 3, {}};
	Map.Values.reserve(static_cast<size_t>(A.Width) * static_cast<size_t>(A.Height) * 3);
	for (int Y = 0; Y < A.Height; ++Y)
	{
		for (int X = 0; X < A.Width; ++X)
		{
			double Worst = 0.0;
			for (int Channel = 0; Channel < Compared; ++Channel)
			{
				const double ValueA = A.Get(X, Y, Channel);
				const double ValueB = B.Get(X, Y, Channel);
				const double Difference = std::abs(ValueA - ValueB);
				Worst = IsSame(ValueA, ValueB)      ? Worst
						: std::isfinite(Difference) ? std::max(Worst, Difference)
													: Infinity;
			}
			double Color[3] = {0.0, 1.0, 1.0};
			if (std::isfinite(Worst))
			{
				GetHeatColor(Worst > 0.0 && Full > 0.0 ? 1.0 + std::log10(Worst / Full) / Decades : 0.0, Color);
			}
			Map.Values.insert(Map.Values.end(), Color, Color + 3);
		}
	}
	return Map;
}

FComparedImage ReadComparedImage(const std::string& Path)
{
	FImageFile File(Path);
	FComparedImage Result;
	Result.Channels = File.GetChannels();
	std::vector<int> Indices(Result.Channels.size());
	std::iota(Indices.begin(), Indices.end(), 0);
	const std::vector<std::vector<float>> Planes = File.Read(Indices);
	const bool bOwnDisplay = File.GetAttribute("drydock:encoding") == "sRGB";
	Result.Encoding = File.IsEncoded() || bOwnDisplay ? EImageEncoding::Display : EImageEncoding::Linear;
	Result.Window = File.GetWindow();
	Result.Image = {File.GetWidth(), File.GetHeight(), static_cast<int>(Planes.size()), {}};
	Result.Image.Values.reserve(Planes[0].size() * Planes.size());
	for (size_t Pixel = 0; Pixel < Planes[0].size(); ++Pixel)
	{
		for (size_t Channel = 0; Channel < Planes.size(); ++Channel)
		{
			// The reader has decoded the colours of encoded files.
			const double Value = static_cast<double>(Planes[Channel][Pixel]);
			const bool bEncode = File.IsEncoded() && Result.Channels[Channel] != "A";
			Result.Image.Values.push_back(bEncode ? EncodeDisplay(Value) : Value);
		}
	}
	return Result;
}

} // namespace Drydock
