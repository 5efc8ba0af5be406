// The histogram of log2 luminance against its bucket maths, the mask, pre-exposure, rects and hazards.
#include "ExposureTestUtils.h"
#include "NativeTestUtils.h"

#include "Exposure/ExposureMetering.h"

#include <algorithm>
#include <numeric>

using namespace PassTest;

namespace
{

using FBuckets = std::array<double, Drydock::GHistogramSize>;

FBuckets Count(const FImage& Image, const FMetering& Metering = {})
{
	return FMeteringRun(Image, Metering).GetHistogram();
}

double SumOf(const FBuckets& Buckets)
{
	return std::accumulate(Buckets.begin(), Buckets.end(), 0.0);
}

/** A second computation: each texel's place between 0 and 63, its weight shared linearly. */
FBuckets Expected(const FImage& Image)
{
	FBuckets Buckets{};
	for (const FTexel& Texel : Image.Texels)
	{
		const double Luminance = std::max((Texel[0] + Texel[1] + Texel[2]) / 3, 1.0 / 256);
		const double Place = std::min(63.0, (std::log2(Luminance) + 8) / 12 * 63);
		for (int Bucket = 0; Bucket < 64; ++Bucket)
		{
			Buckets[Bucket] += std::max(0.0, 1 - std::abs(Place - Bucket)) / static_cast<double>(Image.Texels.size());
		}
	}
	Buckets[0] = 0;
	return Buckets;
}

} // namespace

TEST(PostProcessHistogram, ALuminanceAtABucketFillsItAlone)
{
	EXPECT_NEAR(1, Count(Grey(1.0 / 16))[21], 1e-5); // log2 -4 is a third of the range
	EXPECT_NEAR(1, Count(Grey(1))[42], 1e-5);
	EXPECT_NEAR(1, Count(Grey(16))[63], 1e-5);
}

TEST(PostProcessHistogram, BetweenTwoBucketsAPixelIsShared)
{
	const FBuckets Buckets = Count(Grey(BucketLuminance(30.25)));
	EXPECT_NEAR(0.75, Buckets[30], 1e-4);
	EXPECT_NEAR(0.25, Buckets[31], 1e-4);
}

TEST(PostProcessHistogram, ARampFillsAllBucketsButBlack)
{
	const FBuckets Buckets = Count(BucketRamp());
	EXPECT_EQ(0, Buckets[0]);
	for (int Bucket = 1; Bucket < 64; ++Bucket)
	{
		EXPECT_NEAR(1.0 / 64, Buckets[Bucket], 1e-5) << Bucket;
	}
}

TEST(PostProcessHistogram, NoiseOfOddSizesFollowsTheBucketMaths)
{
	for (const auto& [Width, Height] : {std::pair(65, 37), {1, 1}, {1, 50}, {33, 1}})
	{
		const FImage Image = FImage::Noise(Width, Height, 8);
		const FBuckets Buckets = Count(Image), Reference = Expected(Image);
		for (size_t Bucket = 0; Bucket < Buckets.size(); ++Bucket)
		{
			EXPECT_NEAR(Reference[Bucket], Buckets[Bucket], 1e-5) << Width << "x" << Height << " bucket " << Bucket;
		}
	}
}

TEST(PostProcessHistogram, RowsOfAnyFormatCountAsTexelsReadOneByOne)
{
	std::mt19937 Random(31);
	for (int Case = 0; Case < 24; ++Case)
	{
		const FPlace Place = DrawPlace(Random);
		const FIntRect Rect(Place.Rect.MinX, Place.Rect.MinY, Place.Rect.MaxX, Place.Rect.MaxY);
		const FTextureRHIRef Texture = new FRHITexture(
			FRDGTextureDesc::Create2D(Place.Extent, Place.Format, FClearValueBinding::None, TexCreate_ShaderResource),
			TEXT("Input"));
		for (int Y = 0; Y < Rect.Height(); ++Y)
		{
			for (int X = 0; X < Rect.Width(); ++X)
			{
				const FTexel& Texel = Place.Image.At(X, Y);
				Texture->WriteTexelDouble(
					Rect.Min.X + X, Rect.Min.Y + Y, FVector4(Texel[0], Texel[1], Texel[2], Texel[3]));
			}
		}
		FViewInfo View(nullptr, Rect, Place.Extent);
		View.PreExposure = Case % 2 == 0 ? 1.0f : 0.5f;
		const FEyeAdaptationParameters Parameters = GetEyeAdaptationParameters(View, AEM_Histogram, false);
		// Texel by texel, as they are stored.
		FBuckets Reference{};
		for (int Y = Place.Rect.MinY; Y < Place.Rect.MaxY; ++Y)
		{
			for (int X = Place.Rect.MinX; X < Place.Rect.MaxX; ++X)
			{
				const FVector4 Color = Texture->ReadTexelDouble(X, Y);
				const double Mean = (Color.X + Color.Y + Color.Z) / 3;
				if (std::isnan(Mean))
				{
					continue;
				}
				const double Luminance = std::max(
					std::clamp(Mean, 0.0, 65536.0) / double(View.PreExposure), double(Parameters.LuminanceMin));
				const double At = 63 * std::clamp(std::log2(Luminance) * double(Parameters.HistogramScale) +
													  double(Parameters.HistogramBias),
										   0.0, 1.0);
				for (int Bucket = 0; Bucket < 64; ++Bucket)
				{
					Reference[size_t(Bucket)] +=
						std::max(0.0, 1 - std::abs(At - Bucket)) / Place.Rect.Width() / Place.Rect.Height();
				}
			}
		}
		Reference[0] *= double(Parameters.BlackHistogramBucketInfluence);
		FBuckets Counted[2];
		for (int Threads = 1; Threads <= 2; ++Threads)
		{
			const FScopedConsoleVariable Scope(TEXT("r.Drydock.Threads"), static_cast<float>(Threads));
			FRDGBuilder GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList(), RDG_EVENT_NAME("Histogram"));
			const FScreenPassTexture Input(
				GraphBuilder.RegisterExternalTexture(CreateRenderTarget(Texture, TEXT("Input"))), Rect);
			TRefCountPtr<IPooledRenderTarget> Result;
			GraphBuilder.QueueTextureExtraction(AddHistogramPass(GraphBuilder, View, Parameters, Input), &Result);
			GraphBuilder.Execute();
			Counted[Threads - 1] = Drydock::ReadHistogram(*Result->GetRHI());
		}
		EXPECT_EQ(Counted[0], Counted[1]) << Describe(Place);
		for (size_t Bucket = 0; Bucket < Reference.size(); ++Bucket)
		{
			EXPECT_NEAR(Reference[Bucket], Counted[0][Bucket], 1e-6) << Describe(Place) << ", bucket " << Bucket;
		}
	}
}

TEST(PostProcessHistogram, LuminanceIsTheMeanOfTheChannels)
{
	EXPECT_NEAR(1, Count(FImage(1, 1, {3, 0, 0, 1}))[42], 1e-5);
	EXPECT_NEAR(1, Count(FImage(1, 1, {0, 1, 2, 1}))[42], 1e-5);
}

TEST(PostProcessHistogram, BlackCountsAsTheVariableSays)
{
	EXPECT_EQ(0, SumOf(Count(Grey(0))));
	const FScopedConsoleVariable Influence(TEXT("r.EyeAdaptation.BlackHistogramBucketInfluence"), 0.5f);
	EXPECT_NEAR(0.5, Count(Grey(0))[0], 1e-6);
}

TEST(PostProcessHistogram, NaNIsLeftOutNegativesAreBlackInfinityIsBright)
{
	const FScopedConsoleVariable Influence(TEXT("r.EyeAdaptation.BlackHistogramBucketInfluence"), 1.0f);
	const FImage Image = FImage::Make(4, 1,
		[](int X, int)
		{
			const double Values[] = {NaN, -Infinity, -3, Infinity};
			return FTexel{Values[X], Values[X], Values[X], 1};
		});
	const FBuckets Buckets = Count(Image);
	EXPECT_NEAR(0.5, Buckets[0], 1e-6);
	EXPECT_NEAR(0.25, Buckets[63], 1e-6);
	EXPECT_NEAR(0.75, SumOf(Buckets), 1e-6);
}

TEST(PostProcessHistogram, NoRangeOfTheSettingsCountsOutsideOfItsBuckets)
{
	const FScopedConsoleVariable Influence(TEXT("r.EyeAdaptation.BlackHistogramBucketInfluence"), 1.0f);
	const float Infinite = static_cast<float>(Infinity), NoNumber = static_cast<float>(NaN);
	const float Ends[] = {
		0.0f, -1.0f, 1.0f, 1e-40f, 1e9f, -1e9f, 1e20f, 1e38f, -1e38f, 3e38f, Infinite, -Infinite, NoNumber};
	for (const float Low : Ends)
	{
		for (const float High : Ends)
		{
			FMetering Metering;
			Metering.Settings = [&](FFinalPostProcessSettings& Settings)
			{
				Settings.HistogramLogMin = Low;
				Settings.HistogramLogMax = High;
			};
			const FImage Image = FImage::Make(4, 2, [](int X, int Y) { return Grey(X * 1000.0 * Y).At(0, 0); });
			const FBuckets Buckets = Count(Image, Metering);
			EXPECT_NEAR(1.0, SumOf(Buckets), 1e-6) << Low << " .. " << High;
			EXPECT_TRUE(std::all_of(Buckets.begin(), Buckets.end(), [](double Bucket) { return Bucket >= 0.0; }));
		}
	}
}

TEST(PostProcessHistogram, ASharedLuminanceIsAlwaysBetweenTwoBuckets)
{
	const double Numbers[] = {0, -1, 0.5, 1, 1e-310, 1e300, -1e300, Infinity, -Infinity, NaN};
	for (const double LogLuminance : Numbers)
	{
		for (const double Scale : Numbers)
		{
			for (const double Bias : Numbers)
			{
				const Drydock::FBucketShare Share = Drydock::ShareBetweenBuckets(LogLuminance, Scale, Bias, 64);
				EXPECT_TRUE(Share.First >= 0 && Share.First <= 62);
				EXPECT_TRUE(Share.FirstWeight >= 0.0 && Share.FirstWeight <= 1.0);
				EXPECT_NEAR(1.0, Share.FirstWeight + Share.SecondWeight, 1e-15);
			}
		}
	}
}

TEST(PostProcessHistogram, PreExposureIsTakenOut)
{
	FMetering Metering;
	Metering.PreExposure = 0.125f;
	EXPECT_NEAR(1, Count(Grey(0.125), Metering)[42], 1e-5);
}

TEST(PostProcessHistogram, CountsTheRectOnly)
{
	FMeteringRun Run(Grey(1, 5, 3), {3, 2, 8, 5}, FIntPoint(16, 9), {});
	EXPECT_NEAR(1, Run.GetHistogram()[42], 1e-5);
}

TEST(PostProcessHistogram, TheMaskWeighsPixels)
{
	const FImage Image = FImage::Make(4, 1, [](int X, int) { return X < 2 ? FTexel{1, 1, 1, 1} : FTexel{4, 4, 4, 1}; });
	FMetering Metering;
	Metering.Mask = FImage::Make(4, 1, [](int X, int) { return FTexel{X < 2 ? 1.0 : 0.25, 0, 0, 0}; });
	const FBuckets Buckets = Count(Image, Metering);
	EXPECT_NEAR(0.5, Buckets[42], 1e-5);
	EXPECT_NEAR(0.125, Buckets[52] + Buckets[53], 1e-5); // log2 2 lies at 52.5
}

TEST(PostProcessHistogram, AMaskOfAnotherSizeIsStretchedOverTheView)
{
	FMetering Metering;
	Metering.Mask = FImage::Make(2, 1, [](int X, int) { return FTexel{X == 0 ? 1.0 : 0.0, 0, 0, 0}; });
	// Pixel centres 1/8, 3/8, 5/8, 7/8 of two texels: 1, 0.75, 0.25, 0.
	EXPECT_NEAR(0.5, SumOf(Count(Grey(1, 4, 1), Metering)), 1e-5);
}

TEST(PostProcessHistogram, TheRangeIsAtLeastOneStop)
{
	FMetering Metering;
	Metering.Settings = [](FFinalPostProcessSettings& Settings)
	{
		Settings.HistogramLogMin = 3;
		Settings.HistogramLogMax = 1;
	};
	EXPECT_NEAR(1, Count(Grey(2), Metering)[63], 1e-5); // 0 to 1
	EXPECT_NEAR(1, SumOf(Count(Grey(std::sqrt(2.0)), Metering)), 1e-5);
}
