// Temporal antialiasing against a plain loop in double: random pictures, histories, movements and sizes; the mean that
// it converges to; hazards in the picture, the history and the velocity.
#include "MotionTestUtils.h"

#include "Screen/TemporalAA.h"

using namespace PassTest;
using Drydock::FTemporalAAInputs;
using Drydock::FTemporalAAOutputs;

namespace
{

FMotionAt Everywhere(const FMotion& Motion)
{
	return [=](int, int)
	{
		return Motion;
	};
}

struct FResult
{
	FImage Color;
	FImage History;
};

/** The pass with its inputs; the history is empty where there is none. */
struct FTemporalAARun
{
	EArithmetic Arithmetic = EArithmetic::Float32;
	FIntPoint Padding = FIntPoint(0, 0);
	FVector2D Jitter = FVector2D(0.0, 0.0);
	float PreExposure = 1.0f;
	float CurrentFrameWeight = 0.04f;
	float FilterSize = 1.0f;
	bool bCatmullRom = false;
	float ExposureScale = 1.0f;

	FResult Run(const FImage& Color, const FImage& History, const FMotionAt& Motion) const
	{
		const FRect Rect{Padding.X, Padding.Y, Padding.X + Color.Width, Padding.Y + Color.Height};
		const FIntPoint Extent(Color.Width + 2 * Padding.X, Color.Height + 2 * Padding.Y);
		FPassRun Pass(Color, Rect, Extent, Arithmetic, PF_A32B32G32R32F);
		Pass.View.PreExposure = PreExposure;
		Pass.View.TemporalJitterPixels = Jitter;
		Pass.View.UniformParameters.ClipToPrevClip = FMatrix44f::Identity;
		Pass.View.InitViewUniformBuffer(Extent);
		const FSceneTextures SceneTextures = AddMotion(Pass, Rect, Extent, Motion);
		FTemporalAAInputs Inputs;
		Inputs.SceneColor = Pass.Input;
		Inputs.SceneTextures = CreateSceneTextureUniformBuffer(Pass.GraphBuilder, &SceneTextures);
		if (History.Width > 0)
		{
			const FRect HistoryRect{3, 1, 3 + History.Width, 1 + History.Height};
			Inputs.History = Pass.AddInput(History, HistoryRect, FIntPoint(History.Width + 5, History.Height + 2),
				PF_A32B32G32R32F, TEXT("History"));
		}
		Inputs.CurrentFrameWeight = CurrentFrameWeight;
		Inputs.FilterSize = FilterSize;
		Inputs.bCatmullRom = bCatmullRom;
		Inputs.ExposureScale = ExposureScale;
		const FTemporalAAOutputs Outputs = AddTemporalAAPass(Pass.GraphBuilder, Pass.View, Inputs);
		TRefCountPtr<IPooledRenderTarget> Kept;
		Pass.GraphBuilder.QueueTextureExtraction(Outputs.History.Texture, &Kept);
		FResult Result;
		Result.Color = Pass.Execute(Outputs.SceneColor);
		const FIntRect& KeptRect = Outputs.History.ViewRect;
		Result.History = PassReference::Crop(
			ReadTexture(Kept->GetRHI()), {KeptRect.Min.X, KeptRect.Min.Y, KeptRect.Max.X, KeptRect.Max.Y});
		return Result;
	}

	FResult Run(const FImage& Color, const FImage& History = {}) const { return Run(Color, History, Everywhere({})); }
};

bool IsFinite(const FTexel& Color)
{
	return std::isfinite(Color[0]) && std::isfinite(Color[1]) && std::isfinite(Color[2]);
}

std::array<double, 3> ToYCoCg(const FTexel& C)
{
	return {(C[0] + 2 * C[1] + C[2]) / 4, (C[0] - C[2]) / 2, (2 * C[1] - C[0] - C[2]) / 4};
}

double Cubic(double Distance)
{
	const double D = std::abs(Distance);
	return D < 1 ? 1.5 * D * D * D - 2.5 * D * D + 1 : D < 2 ? -0.5 * D * D * D + 2.5 * D * D - 4 * D + 2 : 0.0;
}

/** The formulas of the header as a loop over one pixel. */
class FPlainTemporalAA
{
public:
	FPlainTemporalAA(
		const FTemporalAARun& InRun, const FImage& InColor, const FImage& InHistory, const FMotionAt& InMotion)
		: Run(InRun)
		, Color(InColor)
		, History(InHistory)
		, Motion(InMotion)
	{
	}

	/** Colour without pre-exposure, and the number of frames. */
	FTexel Compute(int X, int Y) const
	{
		if (!IsFinite(GetColor(X, Y)))
		{
			return {0, 0, 0, 0};
		}
		std::array<double, 3> Sum{};
		double Weights = 0;
		std::array<double, 3> Low = ToYCoCg(GetColor(X, Y)), High = Low, CrossLow = Low, CrossHigh = Low;
		for (int DY = -1; DY <= 1; ++DY)
		{
			for (int DX = -1; DX <= 1; ++DX)
			{
				const FTexel Neighbour = GetColor(X + DX, Y + DY);
				if (!IsFinite(Neighbour))
				{
					continue;
				}
				const auto C = ToYCoCg(Neighbour);
				const double Weight = GetFilterWeight(DX, DY) * (Run.bCatmullRom ? 1.0 : GetLumaWeight(C[0]));
				Weights += Weight;
				for (int Channel = 0; Channel < 3; ++Channel)
				{
					Sum[Channel] += C[Channel] * Weight;
					Low[Channel] = std::min(Low[Channel], C[Channel]);
					High[Channel] = std::max(High[Channel], C[Channel]);
					if (DX == 0 || DY == 0)
					{
						CrossLow[Channel] = std::min(CrossLow[Channel], C[Channel]);
						CrossHigh[Channel] = std::max(CrossHigh[Channel], C[Channel]);
					}
				}
			}
		}
		std::array<double, 3> Now{};
		for (int Channel = 0; Channel < 3; ++Channel)
		{
			Now[Channel] = std::clamp(Sum[Channel] / Weights, Low[Channel], High[Channel]);
		}
		const FTexel Before = GetHistory(X, Y);
		std::array<double, 3> Mixed = Now;
		if (Before[3] > 0)
		{
			auto H = ToYCoCg(Before);
			for (int Channel = 0; Channel < 3; ++Channel)
			{
				H[Channel] = std::clamp(
					H[Channel], (Low[Channel] + CrossLow[Channel]) / 2, (High[Channel] + CrossHigh[Channel]) / 2);
			}
			const double Share = std::max(1 / (Before[3] + 1), double(Run.CurrentFrameWeight));
			const double A = (1 - Share) * GetLumaWeight(H[0]);
			const double B = Share * GetLumaWeight(Now[0]);
			for (int Channel = 0; Channel < 3; ++Channel)
			{
				Mixed[Channel] = (H[Channel] * A + Now[Channel] * B) / (A + B);
			}
		}
		return {Mixed[0] + Mixed[1] - Mixed[2], Mixed[0] + Mixed[2], Mixed[0] - Mixed[1] - Mixed[2], Before[3] + 1};
	}

private:
	FTexel GetColor(int X, int Y) const
	{
		return Color.At(std::clamp(X, 0, Color.Width - 1), std::clamp(Y, 0, Color.Height - 1)) *
			   (1.0 / double(Run.PreExposure));
	}

	double GetLumaWeight(double Luma) const { return 1 / (1 + std::max(0.0, Luma * double(Run.ExposureScale))); }

	/** Not normalised: the means divide by their sum. */
	double GetFilterWeight(int DX, int DY) const
	{
		const double X = DX - Run.Jitter.X, Y = DY - Run.Jitter.Y;
		if (Run.bCatmullRom)
		{
			return Cubic(X) * Cubic(Y);
		}
		if (Run.FilterSize == 0.0f)
		{
			return DX == 0 && DY == 0 ? 1.0 : 0.0;
		}
		const double Sigma = 0.47 * double(Run.FilterSize);
		return std::exp(-(X * X + Y * Y) / (2 * Sigma * Sigma));
	}

	FTexel GetHistory(int X, int Y) const
	{
		if (History.Width == 0)
		{
			return {0, 0, 0, 0};
		}
		FMotion Front = Motion(X, Y);
		for (const auto& [DX, DY] : {std::pair(-1, -1), std::pair(1, -1), std::pair(-1, 1), std::pair(1, 1)})
		{
			const FMotion Other =
				Motion(std::clamp(X + DX, 0, Color.Width - 1), std::clamp(Y + DY, 0, Color.Height - 1));
			Front = Other.Depth < Front.Depth ? Other : Front;
		}
		const double PX = (X + 0.5 - Front.X) * History.Width / Color.Width;
		const double PY = (Y + 0.5 - Front.Y) * History.Height / Color.Height;
		if (!(PX >= 0 && PY >= 0 && PX <= History.Width && PY <= History.Height))
		{
			return {0, 0, 0, 0};
		}
		const int BaseX = int(std::floor(PX - 0.5)), BaseY = int(std::floor(PY - 0.5));
		const bool bOnTexel = PX - 0.5 == BaseX && PY - 0.5 == BaseY;
		FTexel Sum{0, 0, 0, 0};
		double Weights = 0;
		for (int TY = BaseY - 1; TY <= BaseY + 2; ++TY)
		{
			for (int TX = BaseX - 1; TX <= BaseX + 2; ++TX)
			{
				const bool bCorner = (TX == BaseX - 1 || TX == BaseX + 2) && (TY == BaseY - 1 || TY == BaseY + 2);
				const double Weight =
					bOnTexel ? (TX == BaseX && TY == BaseY ? 1.0 : 0.0) : Cubic(PX - 0.5 - TX) * Cubic(PY - 0.5 - TY);
				if (!bCorner && (Weight != 0.0 || !bOnTexel))
				{
					Sum = Sum + Load(TX, TY) * Weight;
					Weights += Weight;
				}
			}
		}
		FTexel Result = Sum * (1 / Weights);
		Result[3] = Load(int(std::floor(PX)), int(std::floor(PY)))[3];
		return IsFinite(Result) && Result[3] > 0 ? Result : FTexel{0, 0, 0, 0};
	}

	const FTexel& Load(int X, int Y) const
	{
		return History.At(std::clamp(X, 0, History.Width - 1), std::clamp(Y, 0, History.Height - 1));
	}

	const FTemporalAARun& Run;
	const FImage& Color;
	const FImage& History;
	const FMotionAt& Motion;
};

/** The largest difference to the plain loop, relative to the colour or to 1. */
double MaxError(const FTemporalAARun& Run, const FImage& Color, const FImage& History, const FMotionAt& Motion)
{
	const FResult Result = Run.Run(Color, History, Motion);
	const FPlainTemporalAA Plain(Run, Color, History, Motion);
	double Largest = 0.0;
	for (int Y = 0; Y < Color.Height; ++Y)
	{
		for (int X = 0; X < Color.Width; ++X)
		{
			const FTexel Expected = Plain.Compute(X, Y);
			for (int Channel = 0; Channel < 4; ++Channel)
			{
				const double Scale = std::max(1.0, std::abs(Expected[Channel]));
				Largest = std::max(Largest, std::abs(Expected[Channel] - Result.History.At(X, Y)[Channel]) / Scale);
				const double Shown = Channel == 3 ? Color.At(X, Y)[3] : Expected[Channel] * double(Run.PreExposure);
				Largest = std::max(Largest, std::abs(Shown - Result.Color.At(X, Y)[Channel]) / Scale);
			}
		}
	}
	return Largest;
}

FImage MakeHistory(int Width, int Height, unsigned Seed, double Frames = 5)
{
	FImage History = FImage::Noise(Width, Height, 4.0, Seed);
	for (FTexel& Texel : History.Texels)
	{
		Texel[3] = Frames;
	}
	return History;
}

FTexel Grey(double Value)
{
	return {Value, Value, Value, 1};
}

} // namespace

TEST(TemporalAA, AgreesWithAPlainLoopInDouble)
{
	std::mt19937 Random(42);
	std::uniform_real_distribution<double> Signed(-1.0, 1.0);
	const std::pair<int, int> Sizes[] = {{1, 1}, {2, 1}, {1, 7}, {5, 3}, {33, 19}, {64, 36}};
	double Largest[2] = {};
	for (const auto& [Width, Height] : Sizes)
	{
		for (int Case = 0; Case < 8; ++Case)
		{
			FTemporalAARun Run;
			Run.Arithmetic = Case % 2 == 0 ? EArithmetic::Float32 : EArithmetic::Double;
			Run.Padding = FIntPoint(Case % 3, Case % 4);
			Run.Jitter = FVector2D(0.5 * Signed(Random), 0.5 * Signed(Random));
			Run.PreExposure = Case % 3 == 0 ? 1.0f : 0.37f;
			Run.CurrentFrameWeight = Case == 5 ? 0.5f : 0.04f;
			Run.FilterSize = Case == 6 ? 0.0f : 1.0f + 0.5f * float(Signed(Random));
			Run.bCatmullRom = Case == 7;
			Run.ExposureScale = Case == 3 ? 8.0f : 1.0f;
			const bool bOtherSize = Case == 4;
			const FImage Color = FImage::Noise(Width, Height, 4.0, Case + 10 * Width);
			const FImage History =
				MakeHistory(bOtherSize ? Width + 3 : Width, bOtherSize ? Height + 1 : Height, Case + 1);
			// Two layers: one moves by parts of a pixel, the other by more than the picture may hold.
			// The G-buffer holds movements of less than the picture's size.
			const double Limit = 0.9 * std::min(Width, Height);
			const double Near = std::clamp(2.0 * Signed(Random), -Limit, Limit);
			const double Far = std::clamp(3.0 * Signed(Random), -Limit, Limit);
			const FMotionAt Motion = [=, Width = Width](int X, int)
			{
				return X < Width / 2 ? FMotion{Near, 0.25 * Near, 300.0} : FMotion{Far, -0.5 * Far, 900.0};
			};
			const double Error = MaxError(Run, Color, History, Motion);
			Largest[Case % 2] = std::max(Largest[Case % 2], Error);
			EXPECT_LT(Error, Case % 2 == 0 ? 2e-5 : 1e-6) << Width << "x" << Height << ", case " << Case;
		}
	}
	RecordProperty("largest_error_float", std::to_string(Largest[0]));
	RecordProperty("largest_error_double", std::to_string(Largest[1]));
}

TEST(TemporalAA, TheFirstFrameIsFilteredOnly)
{
	FTemporalAARun Run;
	Run.FilterSize = 0.0f;
	const FImage Color = FImage::Noise(17, 9, 4.0);
	const FResult Result = Run.Run(Color);
	for (size_t Index = 0; Index < Color.Texels.size(); ++Index)
	{
		for (int Channel = 0; Channel < 3; ++Channel)
		{
			EXPECT_NEAR(Color.Texels[Index][Channel], Result.Color.Texels[Index][Channel], 1e-6);
		}
		EXPECT_EQ(1.0, Result.History.Texels[Index][3]);
	}
}

TEST(TemporalAA, AStillPictureConvergesToTheWeighedMeanOfItsFrames)
{
	// The middle pixel's cross holds 0 and 8 in every frame, so nothing is clamped.
	constexpr int NumFrames = 20;
	FTemporalAARun Run;
	Run.FilterSize = 0.0f;
	FImage History;
	const auto Value = [](int X, int Y, int Frame)
	{
		return X == 4 && Y == 4 ? double((Frame * 5) % 8) : Y % 2 == 0 ? 0.0 : 8.0;
	};
	double Sum = 0.0, Weights = 0.0;
	for (int Frame = 0; Frame < NumFrames; ++Frame)
	{
		const FImage Color = FImage::Make(9, 9, [&](int X, int Y) { return Grey(Value(X, Y, Frame)); });
		const double Own = Value(4, 4, Frame), Weight = 1 / (1 + Own);
		Sum += Own * Weight;
		Weights += Weight;
		History = Run.Run(Color, History).History;
		EXPECT_NEAR(Sum / Weights, History.At(4, 4)[0], 1e-5) << Frame;
		EXPECT_EQ(Frame + 1.0, History.At(4, 4)[3]);
	}
}

TEST(TemporalAA, AnUncoveredPixelShowsNoGhost)
{
	// The history holds a bright thing that has gone; the pixel's surroundings are dark.
	FTemporalAARun Run;
	const FImage History = FImage::Make(15, 15, [](int, int) { return FTexel{100, 100, 100, 20}; });
	const FImage Color = FImage::Make(15, 15, [](int, int) { return Grey(0.25); });
	EXPECT_NEAR(0.25, Run.Run(Color, History).Color.At(7, 7)[0], 1e-6);
}

TEST(TemporalAA, WhatCameFromOutsideHasNoHistory)
{
	FTemporalAARun Run;
	const FImage History = MakeHistory(16, 8, 3);
	const FResult Result = Run.Run(FImage::Noise(16, 8, 1.0), History, Everywhere({20.0, 0.0, 500.0}));
	for (const FTexel& Texel : Result.History.Texels)
	{
		EXPECT_EQ(1.0, Texel[3]);
	}
}

TEST(TemporalAA, AColourThatIsNotFiniteLeavesWithItsFrame)
{
	for (const double Bad : {NaN, Infinity, -Infinity})
	{
		FTemporalAARun Run;
		FImage Color(9, 9, Grey(0.5));
		Color.At(4, 4)[1] = Bad;
		const FResult First = Run.Run(Color, FImage(9, 9, {0.5, 0.5, 0.5, 3}));
		EXPECT_FALSE(IsFinite(First.Color.At(4, 4)));
		EXPECT_EQ(0.0, First.History.At(4, 4)[3]);
		for (int Index = 0; Index < 81; ++Index)
		{
			EXPECT_TRUE(IsFinite(First.History.Texels[Index])) << Index;
			EXPECT_TRUE(Index == 40 || IsFinite(First.Color.Texels[Index])) << Index;
		}
		const FResult Second = Run.Run(FImage(9, 9, Grey(0.5)), First.History);
		EXPECT_NEAR(0.5, Second.Color.At(4, 4)[0], 1e-6);
		EXPECT_EQ(1.0, Second.History.At(4, 4)[3]);
	}
}

TEST(TemporalAA, AHistoryThatIsNotFiniteCountsAsNone)
{
	for (const double Bad : {NaN, Infinity, -Infinity})
	{
		for (const int Channel : {0, 3})
		{
			FTemporalAARun Run;
			FImage History = MakeHistory(9, 9, 4);
			History.At(4, 4)[Channel] = Bad;
			for (const FMotion& Motion : {FMotion{}, FMotion{0.4, 0.3}})
			{
				const FResult Result = Run.Run(FImage(9, 9, Grey(0.5)), History, Everywhere(Motion));
				for (int Index = 0; Index < 81; ++Index)
				{
					EXPECT_NEAR(0.5, Result.Color.Texels[Index][0], 1e-6) << Bad << " " << Index;
					EXPECT_TRUE(IsFinite(Result.History.Texels[Index]));
					EXPECT_GE(Result.History.Texels[Index][3], 1.0);
				}
			}
		}
	}
}

TEST(TemporalAA, InfiniteVelocitiesCountAsFromOutsideAndNaNAsNotStored)
{
	for (const double Bad : {NaN, Infinity, -Infinity, 1e30})
	{
		FTemporalAARun Run;
		const FMotionAt Motion = [=](int X, int Y)
		{
			return X == 4 && Y == 4 ? FMotion{Bad, 0.0, 100.0} : FMotion{};
		};
		const FResult Result = Run.Run(FImage(9, 9, Grey(0.5)), FImage(9, 9, {0.5, 0.5, 0.5, 3}), Motion);
		EXPECT_EQ(Bad > 0.0 ? 1.0 : 4.0, Result.History.At(4, 4)[3]); // below 0 the encoding has nothing
		EXPECT_EQ(4.0, Result.History.At(1, 1)[3]);
		EXPECT_NEAR(0.5, Result.Color.At(4, 4)[0], 1e-6);
	}
}

TEST(TemporalAA, ExtremesOfHalfFloatsAndNegativeLightPass)
{
	for (const double Value : {65504.0, -3.0, 1e30, -1e30, 1e-40, 0.0})
	{
		FTemporalAARun Run;
		const FImage Color(5, 5, Grey(Value));
		FImage History;
		for (int Frame = 0; Frame < 3; ++Frame)
		{
			const FResult Result = Run.Run(Color, History);
			History = Result.History;
			EXPECT_NEAR(Value, Result.Color.At(2, 2)[0], std::max(1e-5 * std::abs(Value), 1e-38)) << Value;
		}
	}
}

TEST(TemporalAA, ThePreExposureDoesNotReachTheHistory)
{
	// Powers of two: the same bits.
	FTemporalAARun One, Other;
	Other.PreExposure = 0.125f;
	const FImage Color = FImage::Noise(21, 13, 4.0);
	FImage Stored = Color;
	for (FTexel& Texel : Stored.Texels)
	{
		Texel = {Texel[0] / 8, Texel[1] / 8, Texel[2] / 8, Texel[3]};
	}
	const FImage History = MakeHistory(21, 13, 8);
	const FResult Expected = One.Run(Color, History), Actual = Other.Run(Stored, History);
	EXPECT_EQ(Expected.History.Texels, Actual.History.Texels);
}

TEST(TemporalAA, WeightsFollowTheJitter)
{
	const auto Weights = Drydock::MakeTemporalAAWeights(FVector2D(0.5, 0.0), 1.0f, false);
	// The picture is moved right by half a pixel: the middle pixel and its right neighbour are as near.
	EXPECT_FLOAT_EQ(Weights[4], Weights[5]);
	EXPECT_GT(Weights[4], Weights[3]);
	EXPECT_FLOAT_EQ(1.0f, Drydock::MakeTemporalAAWeights(FVector2D(0.3, -0.2), 0.0f, false)[4]);
	for (const bool bCatmullRom : {false, true})
	{
		float Sum = 0.0f;
		for (const float Weight : Drydock::MakeTemporalAAWeights(FVector2D(0.3, -0.2), 1.0f, bCatmullRom))
		{
			Sum += Weight;
		}
		EXPECT_NEAR(1.0f, Sum, 1e-6f);
	}
}
