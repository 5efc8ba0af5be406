// Error figures of a study, computed a second time. Everything here is plain loops in double from the definitions: the
// true Gaussian as a two-dimensional sum over all taps, three of the blurs as their papers and headers describe them,
// the widths matched by this file's own second moments, the figures. All of it works on the whole picture; the study's
// region, which lies away from the picture's borders, only says where blurs are compared. Shared with the program: the
// container FImage, and the reader of the scene file.
#include <gtest/gtest.h>

#include "Study/BlurAlgorithms.h"
#include "Study/StudyRun.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

using namespace Drydock;

namespace
{

const std::string Root = DRYDOCK_TEST_SOURCE_DIR "/";

constexpr int Width = 641;
constexpr int Height = 359;

/** Pixels from MinX, MinY up to but not MaxX, MaxY. */
struct FPart
{
	int MinX;
	int MinY;
	int MaxX;
	int MaxY;
};
constexpr FPart Whole = {0, 0, Width, Height};
constexpr FPart Region = {236, 196, 284, 236}; // the point is in it

const char* const GConfig = R"({"scene": {"file": "scenes/toon_character_641x359.exr"}, "study": {"axes": [
	{"name": "algorithm", "values":
		["Separable", "DualKawase", "Pyramid", "GaussianSum", "Kawase", "FFT"]},
	{"name": "sigma", "values": [2, 5]}, {"name": "input", "values": ["scene", "point"]}],
	"region": [236, 196, 284, 236], "repetitions": 1}})";

// Pictures ------------------------------------------------------------------------------------------------------------

/** Colour at X, Y, beyond the edge the edge's. */
double GetClamped(const FImage& Image, int X, int Y, int Channel)
{
	return Image.Get(std::clamp(X, 0, Image.Width - 1), std::clamp(Y, 0, Image.Height - 1), Channel);
}

FImage Make(int W, int H, const std::function<double(int X, int Y, int Channel)>& Value)
{
	FImage Image{W, H, 3, {}};
	for (int Y = 0; Y < H; ++Y)
	{
		for (int X = 0; X < W; ++X)
		{
			for (int Channel = 0; Channel < 3; ++Channel)
			{
				Image.Values.push_back(Value(X, Y, Channel));
			}
		}
	}
	return Image;
}

/** As the file has it. */
FImage LoadScene()
{
	FImageFile File(Root + "configs/scenes/toon_character_641x359.exr");
	const std::vector<std::vector<float>> Planes =
		File.Read({File.FindChannel("R"), File.FindChannel("G"), File.FindChannel("B")});
	return Make(Width, Height,
		[&](int X, int Y, int Channel)
		{
			const size_t Texel = static_cast<size_t>(Y * Width + X);
			return static_cast<double>(Planes[static_cast<size_t>(Channel)][Texel]);
		});
}

/** One texel at two fifths of the width and three of the height, so bright that a Gaussian's peak is 1. */
FImage MakePoint(double Sigma)
{
	return Make(Width, Height,
		[&](int X, int Y, int) { return X == 256 && Y == 215 ? 2.0 * std::numbers::pi * Sigma * Sigma : 0.0; });
}

FImage MakeInput(const std::string& Input, double Sigma)
{
	return Input == "scene" ? LoadScene() : MakePoint(Sigma);
}

/** Two-dimensional, weights by distance from 0 on along each axis, all taps; divided by their sum. Only in Part: 0
 * elsewhere. */
FImage Convolve(const FImage& Image, const std::vector<double>& Weights, const FPart& Part = Whole)
{
	const int Reach = static_cast<int>(Weights.size()) - 1;
	return Make(Image.Width, Image.Height,
		[&](int X, int Y, int Channel)
		{
			if (X < Part.MinX || X >= Part.MaxX || Y < Part.MinY || Y >= Part.MaxY)
			{
				return 0.0;
			}
			double Sum = 0.0;
			double Total = 0.0;
			for (int DY = -Reach; DY <= Reach; ++DY)
			{
				for (int DX = -Reach; DX <= Reach; ++DX)
				{
					const double Weight =
						Weights[static_cast<size_t>(std::abs(DX))] * Weights[static_cast<size_t>(std::abs(DY))];
					Sum += Weight * GetClamped(Image, X + DX, Y + DY, Channel);
					Total += Weight;
				}
			}
			return Sum / Total;
		});
}

std::vector<double> MakeGaussian(double Sigma, int Reach)
{
	std::vector<double> Weights;
	for (int Distance = 0; Distance <= Reach; ++Distance)
	{
		Weights.push_back(std::exp(-Distance * Distance / (2.0 * Sigma * Sigma)));
	}
	return Weights;
}

double GetVariance(const std::vector<double>& Weights)
{
	double Sum = Weights[0];
	double Square = 0.0;
	for (size_t Distance = 1; Distance < Weights.size(); ++Distance)
	{
		Sum += 2.0 * Weights[Distance];
		Square += 2.0 * static_cast<double>(Distance * Distance) * Weights[Distance];
	}
	return Square / Sum;
}

/** Where a growing function reaches Wanted. */
double Bisect(double Low, double High, double Wanted, const std::function<double(double)>& Function)
{
	for (int Step = 0; Step < 80; ++Step)
	{
		const double Middle = (Low + High) / 2.0;
		(Function(Middle) < Wanted ? Low : High) = Middle;
	}
	return Low;
}

FImage BlurExactly(const FImage& Image, double Sigma, const FPart& Part)
{
	// Beyond 9 deviations a weight is below 3e-18 of the middle one.
	return Convolve(Image, MakeGaussian(Sigma, static_cast<int>(9.0 * Sigma)), Part);
}

// The blurs -----------------------------------------------------------------------------------------------------------

/** Cut at so many deviations, the exponent's deviation chosen so that what is left has the wanted variance. */
FImage BlurSeparable(const FImage& Image, double Sigma, const FPart& Part = Whole, double Deviations = 3.0)
{
	const int Reach = std::max(1, static_cast<int>(std::ceil(Deviations * Sigma)));
	const double Exponent = Bisect(
		0.1, 4.0 * Sigma, Sigma * Sigma, [&](double Candidate) { return GetVariance(MakeGaussian(Candidate, Reach)); });
	return Convolve(Image, MakeGaussian(Exponent, Reach), Part);
}

/** Halved by [1 3 3 1] / 8, blurred, doubled by the same kernel: 3 parts of the nearer texel and 1 of the next. The two
 * passes have the variance 3/2, which the low picture's blur lacks. That begins two texels before the image and ends
 * where all is the edge texel. */
FImage BlurPyramid(const FImage& Image, double Sigma)
{
	constexpr double Kernel[4] = {0.125, 0.375, 0.375, 0.125};
	constexpr int Margin = 2;
	const FImage Low = Make((Image.Width + 1) / 2 + Margin + 1, (Image.Height + 1) / 2 + Margin + 1,
		[&](int X, int Y, int Channel)
		{
			double Sum = 0.0;
			for (int DY = 0; DY < 4; ++DY)
			{
				for (int DX = 0; DX < 4; ++DX)
				{
					Sum += Kernel[DX] * Kernel[DY] *
						   GetClamped(Image, 2 * (X - Margin) - 1 + DX, 2 * (Y - Margin) - 1 + DY, Channel);
				}
			}
			return Sum;
		});
	const FImage Blurred = BlurSeparable(Low, std::sqrt(Sigma * Sigma - 1.5) / 2.0, Whole, 4.0);
	return Make(Image.Width, Image.Height,
		[&](int X, int Y, int Channel)
		{
			const int NearX = X / 2 + Margin;
			const int NearY = Y / 2 + Margin;
			const int NextX = X % 2 == 0 ? NearX - 1 : NearX + 1;
			const int NextY = Y % 2 == 0 ? NearY - 1 : NearY + 1;
			return (9.0 * GetClamped(Blurred, NearX, NearY, Channel) +
					   3.0 * GetClamped(Blurred, NextX, NearY, Channel) +
					   3.0 * GetClamped(Blurred, NearX, NextY, Channel) + GetClamped(Blurred, NextX, NextY, Channel)) /
				   16.0;
		});
}

/** Bilinear, at a place in texels from the corner; no further out than half a texel inside. */
double Sample(const FImage& Image, double X, double Y, int Channel)
{
	const double U = std::clamp(X, 0.5, Image.Width - 0.5) - 0.5;
	const double V = std::clamp(Y, 0.5, Image.Height - 0.5) - 0.5;
	const int Column = static_cast<int>(U);
	const int Row = static_cast<int>(V);
	const auto Mix = [&](int AtRow)
	{
		return GetClamped(Image, Column, AtRow, Channel) * (1.0 - (U - Column)) +
			   GetClamped(Image, Column + 1, AtRow, Channel) * (U - Column);
	};
	return Mix(Row) * (1.0 - (V - Row)) + Mix(Row + 1) * (V - Row);
}

struct FTap
{
	double X;
	double Y;
	double Weight;
};

/** The tables as Bjorge's slides print them, for distances in texels of what is read: down 4, 1 1 1 1; up 1 1 1 1 along
 * the axes and 2 2 2 2 between. */
std::vector<FTap> MakeDownTaps(double Diagonal)
{
	const double D = Diagonal;
	return {{0, 0, 4.0 / 8}, {-D, -D, 1.0 / 8}, {D, D, 1.0 / 8}, {D, -D, 1.0 / 8}, {-D, D, 1.0 / 8}};
}

std::vector<FTap> MakeUpTaps(double Axis, double Diagonal)
{
	const double A = Axis;
	const double D = Diagonal;
	return {{-A, 0, 1.0 / 12}, {A, 0, 1.0 / 12}, {0, -A, 1.0 / 12}, {0, A, 1.0 / 12}, {-D, D, 2.0 / 12},
		{D, D, 2.0 / 12}, {D, -D, 2.0 / 12}, {-D, -D, 2.0 / 12}};
}

FImage ApplyTaps(const FImage& Image, int W, int H, double TexelsPerPixel, const std::vector<FTap>& Taps)
{
	return Make(W, H,
		[&](int X, int Y, int Channel)
		{
			double Sum = 0.0;
			for (const FTap& Tap : Taps)
			{
				Sum += Tap.Weight *
					   Sample(Image, (X + 0.5) * TexelsPerPixel + Tap.X, (Y + 0.5) * TexelsPerPixel + Tap.Y, Channel);
			}
			return Sum;
		});
}

/** Distances in 1/256 texel, which is as fine as a sampler tells apart. */
FImage ApplyDualKawase(const FImage& Image, int Levels, int Whole, int Half)
{
	if (Levels == 0)
	{
		return Image;
	}
	const FImage Low =
		ApplyTaps(Image, (Image.Width + 1) / 2, (Image.Height + 1) / 2, 2.0, MakeDownTaps(Whole / 256.0));
	return ApplyTaps(ApplyDualKawase(Low, Levels - 1, Whole, Half), Image.Width, Image.Height, 0.5,
		MakeUpTaps(Whole / 256.0, Half / 256.0));
}

/** Of points at all places of a coarsest texel, along rows; other columns are as bright. */
double MeasureDualKawase(int Levels, int Whole, int Half)
{
	constexpr int Length = 96;
	constexpr int Middle = 48;
	double Variance = 0.0;
	const int NumPlaces = 1 << Levels;
	for (int Place = 0; Place < NumPlaces; ++Place)
	{
		const FImage Line = Make(Length, NumPlaces, [&](int X, int, int) { return X == Middle + Place ? 1.0 : 0.0; });
		const FImage Response = ApplyDualKawase(Line, Levels, Whole, Half);
		for (int X = 0; X < Length; ++X)
		{
			const double Distance = X - Middle - Place;
			Variance += Distance * Distance * Response.Get(X, 0, 0) / NumPlaces;
		}
	}
	return Variance;
}

/** One level below a standard deviation of 3, two above; the distances of taps whose measured width is nearest. */
FImage BlurDualKawase(const FImage& Image, double Sigma)
{
	const int Levels = Sigma < 3.0 ? 1 : 2;
	const double Reached = Bisect(0.0, 512.0, Sigma * Sigma,
		[&](double Whole) { return MeasureDualKawase(Levels, static_cast<int>(Whole), static_cast<int>(Whole) / 2); });
	int BestWhole = 0;
	int BestHalf = 0;
	double Best = HUGE_VAL;
	for (int Whole = static_cast<int>(Reached) - 2; Whole <= static_cast<int>(Reached) + 3; ++Whole)
	{
		// An odd distance has two halves.
		for (int Half = Whole / 2; Half <= (Whole + 1) / 2; ++Half)
		{
			const double Error = std::abs(std::sqrt(MeasureDualKawase(Levels, Whole, Half)) - Sigma);
			if (Error < Best)
			{
				Best = Error;
				BestWhole = Whole;
				BestHalf = Half;
			}
		}
	}
	return ApplyDualKawase(Image, Levels, BestWhole, BestHalf);
}

// Figures -------------------------------------------------------------------------------------------------------------

struct FFigures
{
	double Max = 0.0;
	double Rms = 0.0;
	double Relative = 0.0;
};

/** Over the colours of Part. */
FFigures Compare(const FImage& Blurred, const FImage& Exact, const FPart& Part)
{
	FFigures Figures;
	double Squares = 0.0;
	double ExactSquares = 0.0;
	for (int Y = Part.MinY; Y < Part.MaxY; ++Y)
	{
		for (int X = Part.MinX; X < Part.MaxX; ++X)
		{
			for (int Channel = 0; Channel < 3; ++Channel)
			{
				const double Difference = Blurred.Get(X, Y, Channel) - Exact.Get(X, Y, Channel);
				Figures.Max = std::max(Figures.Max, std::abs(Difference));
				Squares += Difference * Difference;
				ExactSquares += Exact.Get(X, Y, Channel) * Exact.Get(X, Y, Channel);
			}
		}
	}
	Figures.Rms = std::sqrt(Squares / (3.0 * (Part.MaxX - Part.MinX) * (Part.MaxY - Part.MinY)));
	Figures.Relative = std::sqrt(Squares / ExactSquares);
	return Figures;
}

const FStudyResult& GetStudy()
{
	static const FStudyResult Result = []
	{
		FRunOptions Options;
		Options.ConfigFile = Root + "configs/test_study.json";
		Options.ConfigText = GConfig;
		return RunStudy(Options);
	}();
	return Result;
}

struct FCase
{
	double Sigma;
	std::string Input;
};

class StudyFigures : public testing::TestWithParam<FCase>
{
protected:
	/** What the study reports of an algorithm. */
	const FStudyVariant& GetReported(const std::string& Algorithm) const
	{
		const std::string Job = "sigma " + std::to_string(static_cast<int>(GetParam().Sigma)) + ", " + GetParam().Input;
		for (const FStudyVariant& Variant : GetStudy().Variants)
		{
			if (Variant.Label == Algorithm && GetStudy().Jobs[Variant.Case].Case.Label == Job)
			{
				EXPECT_TRUE(Variant.bRan) << Variant.Excluded;
				return Variant;
			}
		}
		throw std::logic_error("no such variant");
	}

	void ExpectReported(const std::string& Algorithm, const FImage& Blurred, double Tolerance) const
	{
		const FFigures Figures = Compare(Blurred, Exact, Region);
		const FImageError& Reported = GetReported(Algorithm).Error;
		EXPECT_NEAR(1.0, Reported.Rms / Figures.Rms, Tolerance) << Algorithm << " " << Figures.Rms;
		EXPECT_NEAR(1.0, Reported.Relative / Figures.Relative, Tolerance) << Algorithm;
		EXPECT_NEAR(1.0, Reported.Max / Figures.Max, Tolerance) << Algorithm;
	}

	const FImage Input = MakeInput(GetParam().Input, GetParam().Sigma);
	const FImage Exact = BlurExactly(Input, GetParam().Sigma, Region);
};

} // namespace

INSTANTIATE_TEST_SUITE_P(All, StudyFigures,
	testing::Values(FCase{2.0, "scene"}, FCase{2.0, "point"}, FCase{5.0, "scene"}, FCase{5.0, "point"}),
	[](const auto& Info) { return Info.param.Input + std::to_string(static_cast<int>(Info.param.Sigma)); });

/** Blurs and reference both from here. The program's are in float, of 1e-7 of the picture; the errors are 5e-4 of it
 * and more. Seen: figures agree to 1.3e-4 (Separable's largest difference), most to 1e-6. */
TEST_P(StudyFigures, OfBlursWrittenOutHere)
{
	constexpr double OfFloat = 1e-3;
	ExpectReported("Separable", BlurSeparable(Input, GetParam().Sigma, Region), OfFloat);
	ExpectReported("Pyramid", BlurPyramid(Input, GetParam().Sigma), OfFloat);
	ExpectReported("DualKawase", BlurDualKawase(Input, GetParam().Sigma), OfFloat);
}

/** The second figure is that of the whole picture, where dual Kawase repeats coarse texels along the borders. */
TEST(StudyFiguresWithBorder, AreOfTheWholePicture)
{
	constexpr double Sigma = 2.0;
	const FImage Input = LoadScene();
	const FFigures Figures = Compare(BlurDualKawase(Input, Sigma), BlurExactly(Input, Sigma, Whole), Whole);
	for (const FStudyVariant& Variant : GetStudy().Variants)
	{
		if (Variant.Label == "DualKawase" && GetStudy().Jobs[Variant.Case].Case.Label == "sigma 2, scene")
		{
			EXPECT_NEAR(1.0, Variant.RelativeWithBorder / Figures.Relative, 1e-3);
			EXPECT_NE(Variant.Error.Relative, Variant.RelativeWithBorder);
		}
	}
	EXPECT_EQ(Width, GetStudy().Width);
	EXPECT_EQ(Height, GetStudy().Height);
}

/** The blurs are the program's, the reference and the figures are from here. */
TEST_P(StudyFigures, AgainstTheDirectConvolution)
{
	FImage Image{Width, Height, 4, {}};
	for (int Y = 0; Y < Height; ++Y)
	{
		for (int X = 0; X < Width; ++X)
		{
			Image.Values.insert(Image.Values.end(), {Input.Get(X, Y, 0), Input.Get(X, Y, 1), Input.Get(X, Y, 2), 1.0});
		}
	}
	for (const char* Algorithm : {"GaussianSum", "Kawase"})
	{
		ExpectReported(Algorithm, FBlur(Algorithm, GetParam().Sigma).Run(Image).Image, 1e-9);
	}
}
