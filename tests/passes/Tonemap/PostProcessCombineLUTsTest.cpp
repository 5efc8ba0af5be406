// Colour grading against a second computation in double, and the combined table against the maths that fills it.
#include "TonemapTestUtils.h"

#include "DocFigures.h"
#include "ToneReference.h"

#include "Screen/TextureAssets.h"

#include <numeric>

using namespace TonemapTest;
using PassReference::MaxDifference;
using PassTest::Infinity;
using PassTest::NaN;

namespace
{

using FSettings = FFinalPostProcessSettings;

FTexel Encode(const ToneReference::FVec& Linear)
{
	return {ToneReference::EncodeSrgb(Linear[0]), ToneReference::EncodeSrgb(Linear[1]),
		ToneReference::EncodeSrgb(Linear[2]), 0};
}

/** The picture after grading by ranges, then the default film. */
FImage ExpectGraded(const FImage& Image, const std::array<ToneReference::FGrade, 3>& Grades)
{
	return FImage::Make(Image.Width, Image.Height,
		[&](int X, int Y)
		{
			const FTexel& C = Image.At(X, Y);
			const ToneReference::FVec Color = {C[0], C[1], C[2]};
			const ToneReference::FVec AP1 =
				ToneReference::ExpandGamut(ToneReference::Mul(ToneReference::Matrices().Rec709ToAP1, Color), 1);
			return Encode(ToneReference::FilmFromAP1(ToneReference::CorrectAll(AP1, Grades), {}));
		});
}

/** Something in every range. */
void Grade(FSettings& Settings)
{
	Settings.ColorSaturation = FVector4(1.25, 1, 1, 1);
	Settings.ColorSaturationShadows = FVector4(1, 1, 1, 0.5);
	Settings.ColorContrastMidtones = FVector4(1, 1.25, 1, 1);
	Settings.ColorGammaMidtones = FVector4(1, 1, 1.5, 1);
	Settings.ColorGainHighlights = FVector4(1, 0.75, 1, 1);
	Settings.ColorOffsetShadows = FVector4(0, 0, 0.015625, 0.03125);
}

constexpr std::array<ToneReference::FGrade, 3> Grades = {{
	{{0.625, 0.5, 0.5}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {0.03125, 0.03125, 0.046875}},
	{{1.25, 1, 1}, {1, 1.25, 1}, {1, 1, 1.5}, {1, 1, 1}, {0, 0, 0}},
	{{1.25, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 0.75, 1}, {0, 0, 0}},
}};

/** How far the table is from the film curve in double, both cut to what a display shows. */
struct FTableErrors
{
	std::vector<double> LargestChannel; // of each texel
	double Largest = 0;
	double Mean = 0; // of all channels
	double ShareAboveOneHundredth = 0;

	explicit FTableErrors(const FImage& Image)
	{
		const FImage Table = Tonemap(Image, {.Arithmetic = EArithmetic::Native, .bLUT = true});
		for (size_t Index = 0; Index < Image.Texels.size(); ++Index)
		{
			const FTexel& Color = Image.Texels[Index];
			const FTexel Exact = Encode(ToneReference::Tonemap({Color[0], Color[1], Color[2]}));
			double Worst = 0;
			for (int Channel = 0; Channel < 3; ++Channel)
			{
				const double Error =
					std::abs(std::clamp(Exact[Channel], 0.0, 1.0) - std::clamp(Table.Texels[Index][Channel], 0.0, 1.0));
				Worst = std::max(Worst, Error);
				Mean += Error / (3.0 * static_cast<double>(Image.Texels.size()));
			}
			LargestChannel.push_back(Worst);
			Largest = std::max(Largest, Worst);
			ShareAboveOneHundredth += Worst > 0.01 ? 1.0 / static_cast<double>(Image.Texels.size()) : 0;
		}
	}
};

/** The worst colour, and its error, that steps by chance reach from the 32 worst of Image without leaving 2^-8..2^5. */
std::pair<FTexel, double> ClimbFromTheWorst(const FImage& Image, const FTableErrors& Errors, std::mt19937& Random)
{
	constexpr int NumClimbers = 32, NumSteps = 128, NumRounds = 24;
	std::vector<size_t> Order(Image.Texels.size());
	std::iota(Order.begin(), Order.end(), 0);
	std::partial_sort(Order.begin(), Order.begin() + NumClimbers, Order.end(),
		[&](size_t A, size_t B) { return Errors.LargestChannel[A] > Errors.LargestChannel[B]; });
	FImage Climbers = FImage::Make(1, NumClimbers, [&](int, int Y) { return Image.Texels[Order[Y]]; });
	std::normal_distribution<double> Normal;
	double Largest = 0;
	FTexel Worst{};
	for (double Stops = 0.5, Round = 0; Round < NumRounds; ++Round, Stops *= 0.75)
	{
		const FImage Steps = FImage::Make(NumSteps, NumClimbers,
			[&](int X, int Y)
			{
				FTexel Color = Climbers.At(0, Y);
				for (int Channel = 0; Channel < 3 && X > 0; ++Channel)
				{
					const double Log = std::clamp(std::log2(Color[Channel]) + Stops * Normal(Random), -8.0, 5.0);
					Color[Channel] = static_cast<double>(static_cast<float>(std::exp2(Log)));
				}
				return Color;
			});
		const FTableErrors Found(Steps);
		for (int Y = 0; Y < NumClimbers; ++Y)
		{
			const auto Row = Found.LargestChannel.begin() + Y * NumSteps;
			const auto Best = std::max_element(Row, Row + NumSteps);
			Climbers.Texels[Y] = Steps.At(static_cast<int>(Best - Row), Y);
			if (*Best > Largest)
			{
				Largest = *Best;
				Worst = Climbers.Texels[Y];
			}
		}
	}
	return {Worst, Largest};
}

class ColorCorrection : public testing::TestWithParam<EArithmetic>
{
};

/** A 256 x 16 table that maps each of its 16^3 colours. */
FTextureRHIRef MakeTable(const std::function<ToneReference::FVec(ToneReference::FVec)>& Map)
{
	std::vector<FLinearColor> Colors;
	for (int Y = 0; Y < 16; ++Y)
	{
		for (int X = 0; X < 256; ++X)
		{
			const ToneReference::FVec Code = Map({(X % 16) / 15.0, Y / 15.0, (X / 16) / 15.0});
			const auto Linear = [](double Value)
			{
				return static_cast<float>(ToneReference::DecodeSrgb(Value));
			};
			Colors.push_back(FLinearColor(Linear(Code[0]), Linear(Code[1]), Linear(Code[2]), 1.0f));
		}
	}
	return Drydock::MakePictureTexture(FIntPoint(256, 16), Colors, "Table");
}

UTexture2D GTable;

void UseTable(FSettings& Settings, float Weight)
{
	Linear(Settings);
	GTable.SetFName(FName("Table"));
	Settings.ContributingLUTs.Reset();
	Settings.ContributingLUTs.Add({nullptr, 1.0f - Weight});
	Settings.ContributingLUTs.Add({&GTable, Weight});
}

FTonemapRun UseTableRun(float Weight)
{
	return {
		.Settings = [Weight](FSettings& Settings) { UseTable(Settings, Weight); }, .Arithmetic = EArithmetic::Exact};
}

} // namespace

TEST_P(ColorCorrection, FollowsTheFormulas)
{
	const FImage Image = MakeSwatches();
	// Float: powers and the toe's slope amplify relative errors of 2^-22.
	EXPECT_LE(MaxDifference(ExpectGraded(Image, Grades), Tonemap(Image, {.Settings = Grade, .Arithmetic = GetParam()})),
		GetParam() == EArithmetic::Double ? 1e-6 : 2e-5);
}

INSTANTIATE_TEST_SUITE_P(
	Arithmetic, ColorCorrection, testing::ValuesIn(PassTest::SnappedArithmetic), PassTest::FArithmeticName());

TEST(ColorGrading, WithoutSaturationAllIsGrey)
{
	const FImage Result = Tonemap(MakeSwatches(), {.Settings = [](FSettings& Settings)
													  {
														  Linear(Settings);
														  Settings.ColorSaturation.W = 0;
													  }});
	for (const FTexel& Texel : Result.Texels)
	{
		EXPECT_NEAR(Texel[0], Texel[1], 2e-5 * Texel[0]);
		EXPECT_NEAR(Texel[0], Texel[2], 2e-5 * Texel[0]);
	}
}

TEST(ColorGrading, WhiteBalanceScalesWhiteByItsLight)
{
	// The picture takes on 3000 K: (0.4369, 0.4041), CIE 15 black body. Y is kept.
	const ToneReference::FVec XYZ = {0.4369 / 0.4041, 1, (1 - 0.4369 - 0.4041) / 0.4041};
	const ToneReference::FVec White = ToneReference::Mul(ToneReference::Inverse(ToneReference::Matrices().Rec709), XYZ);
	const FTexel Result = TonemapPixel({0.25, 0.25, 0.25, 1}, {.Settings = [](FSettings& Settings)
																  {
																	  Linear(Settings);
																	  Settings.WhiteTemp = 3000;
																	  Settings.TemperatureType = TEMP_ColorTemperature;
																  }});
	for (int Channel = 0; Channel < 3; ++Channel)
	{
		EXPECT_NEAR(0.25 * White[Channel], ToneReference::DecodeSrgb(Result[Channel]), 2e-3);
	}
}

TEST(ColorGrading, HazardsGiveColoursOfTheDisplay)
{
	const auto Wild = [](FSettings& Settings)
	{
		Settings.ColorContrast = FVector4(0, 0, 0, 0);
		Settings.ColorGammaShadows = FVector4(0, 0, 0, 0);
		Settings.ColorOffset.W = -1;
		Settings.ColorCorrectionShadowsMax = 0;
		Settings.ColorCorrectionHighlightsMin = 1;
		Settings.WhiteTemp = 1;
	};
	for (const bool bLUT : {false, true})
	{
		for (const FTexel& Color :
			{FTexel{0, 0, 0, 1}, {NaN, 1, -1, 1}, {Infinity, Infinity, Infinity, 1}, {65504, 0, 0, 1}})
		{
			const FTexel Result = TonemapPixel(Color, {.Settings = Wild, .bLUT = bLUT});
			for (int Channel = 0; Channel < 3; ++Channel)
			{
				EXPECT_TRUE(Result[Channel] >= 0 && Result[Channel] < 1.2) << Color[0] << " table " << bLUT;
			}
		}
	}
}

TEST(CombinedTable, HoldsTheMathsAtItsTexels)
{
	// Texel (r, g, b) is the colour at r / 31 of the positions: LogToLin(r / 31) - LogToLin(0).
	PassTest::FPassRun Run(FImage(1, 1), EArithmetic::Float32, PF_A32B32G32R32F);
	const FScreenPassTexture Table(AddCombineLUTPass(Run.GraphBuilder, Run.View));
	const FImage Result = Run.Execute(Table);
	ASSERT_EQ(1024, Result.Width);
	ASSERT_EQ(32, Result.Height);
	const auto Value = [](int Index)
	{
		const auto LogToLin = [](double Log)
		{
			return 0.18 * std::exp2((Log - 444.0 / 1023) * 14);
		};
		return LogToLin(Index / 31.0) - LogToLin(0);
	};
	for (const auto& [R, G, B] :
		{std::array{0, 0, 0}, std::array{31, 0, 5}, std::array{12, 13, 14}, std::array{31, 31, 31}})
	{
		const FTexel Expected = Encode(ToneReference::Tonemap({Value(R), Value(G), Value(B)}));
		for (int Channel = 0; Channel < 3; ++Channel)
		{
			EXPECT_NEAR(Expected[Channel] / 1.05, Result.At(B * 32 + R, G)[Channel], 1e-5) << R << " " << G << " " << B;
		}
	}
}

/** What docs/tonemapper.md and PostProcessCombineLUTs.h say of the table's error. */
TEST(CombinedTable, ErrorAgainstTheMathsOfEachPixel)
{
	std::mt19937 Random(1);
	std::uniform_real_distribution<double> Stops(-8, 5);
	const FImage Greys = FImage::Make(256, 64,
		[&](int, int)
		{
			const double Value = static_cast<double>(static_cast<float>(std::exp2(Stops(Random))));
			return FTexel{Value, Value, Value, 1};
		});
	const FImage Colors = FImage::Make(512, 256,
		[&](int, int)
		{
			const auto Channel = [&]
			{
				return static_cast<double>(static_cast<float>(std::exp2(Stops(Random))));
			};
			const double R = Channel(), G = Channel(), B = Channel();
			return FTexel{R, G, B, 1};
		});
	const FTableErrors OfGreys(Greys), OfColors(Colors);
	const auto [Worst, LargestNearby] = ClimbFromTheWorst(Colors, OfColors, Random);

	const DocFigures::FPage Page(DRYDOCK_TEST_SOURCE_DIR, "tonemapper.md");
	DocFigures::ExpectWritten(Page.After("over greys"), OfGreys.Largest, "largest of greys");
	DocFigures::ExpectWritten(Page.After("over greys 0.0020 at most and"), OfGreys.Mean, "mean of greys");
	DocFigures::ExpectWritten(Page.After("over all colours"), LargestNearby, "largest of all");
	DocFigures::ExpectWritten(Page.After("over all colours 0.096 at most and"), OfColors.Mean, "mean of all");
	DocFigures::ExpectWritten(Page.After("above 0.01 in"), 100 * OfColors.ShareAboveOneHundredth, "percent above 0.01");
	DocFigures::ExpectWritten(Page.After("the most at red"), Worst[0], "red of the worst");
	DocFigures::ExpectWritten(Page.After("the most at red 0.0039, green"), Worst[1], "green of the worst");
	DocFigures::ExpectWritten(Page.After("the most at red 0.0039, green 1.20, blue"), Worst[2], "blue of the worst");
	EXPECT_LE(OfColors.Largest, LargestNearby);
	EXPECT_GT(OfColors.Largest, 0.08) << "a search far above what chance finds is a search of something else";
}

/** Above the display's range a float target of the table ends at 1.05, and the maths goes on. */
TEST(CombinedTable, EndsAboveWhite)
{
	const FTexel Red = {5.87, 0.0039, 0.0039, 1};
	const DocFigures::FPage Page(DRYDOCK_TEST_SOURCE_DIR, "tonemapper.md");
	DocFigures::ExpectWritten(Page.After("the table ends at"),
		TonemapPixel(Red, {.Arithmetic = EArithmetic::Native, .bLUT = true})[0], "table");
	DocFigures::ExpectWritten(
		Page.After("the maths gives up to"), Encode(ToneReference::Tonemap({Red[0], Red[1], Red[2]}))[0], "maths");
}

TEST(CombinedTable, NeutralGradingAndNoCurveIsTheIdentityWithinAStep)
{
	// A linear ramp through an sRGB curve that the table bends into 31 pieces: 14 / 31 stops each. The chord of
	// x^(1/2.4) over h stops lies (h ln 2 / 2.4)^2 / 8 = 0.0021 of the value off at most; then a step of 1.05 / 1023.
	const FImage Ramp = FImage::Make(256, 1,
		[](int X, int)
		{
			const double Value = (X + 0.5) / 256;
			return FTexel{Value, Value, Value, 1};
		});
	const FImage Result = Tonemap(Ramp, {.Settings = Linear, .Arithmetic = EArithmetic::Native, .bLUT = true});
	for (int X = 0; X < 256; ++X)
	{
		const double Expected = ToneReference::EncodeSrgb((X + 0.5) / 256);
		EXPECT_NEAR(Expected, Result.At(X, 0)[1], 1.05 / 1023 + 0.0025 * Expected) << X;
	}
}

TEST(CombinedTable, BlackStaysBlack)
{
	EXPECT_EQ((FTexel{0, 0, 0, 0}), TonemapPixel({0, 0, 0, 1}, {.Arithmetic = EArithmetic::Native, .bLUT = true}));
}

TEST(CombinedTable, ValuesAboveItsRangeAreItsLast)
{
	EXPECT_EQ(TonemapPixel({44, 44, 44, 1}, {.bLUT = true}), TonemapPixel({Infinity, 1e4, 60000, 1}, {.bLUT = true}));
}

TEST(CombinedTable, ALargerOneIsNearer)
{
	const FImage Image = MakeSwatches(), Exact = Tonemap(Image);
	const double Small = MaxDifference(Exact, Tonemap(Image, {.bLUT = true}));
	const PassTest::FScopedConsoleVariable Size(TEXT("r.LUT.Size"), 64);
	EXPECT_LT(MaxDifference(Exact, Tonemap(Image, {.bLUT = true})), 0.5 * Small);
}

TEST(CombinedTable, ComputeAndPixelShaderGiveTheSameBits)
{
	const FImage Image = MakeSwatches();
	EXPECT_EQ(Tonemap(Image, {.Settings = Grade, .bLUT = true}).Texels,
		Tonemap(Image, {.Settings = Grade, .bLUT = true, .bCompute = true}).Texels);
}

TEST(LegacyTable, IsAppliedToTheEncodedColourByItsWeight)
{
	const Drydock::FScopedTextureLoader Loader(
		[](const std::string&) {
			return MakeTable([](ToneReference::FVec C) { return ToneReference::FVec{C[2], C[0], C[1]}; });
		});
	const FTexel Color{0.125, 0.25, 0.5, 1};
	const FTexel Whole = TonemapPixel(Color, UseTableRun(1));
	const FTexel Plain = Encode({0.125, 0.25, 0.5});
	EXPECT_NEAR(Plain[2], Whole[0], 1e-5);
	EXPECT_NEAR(Plain[0], Whole[1], 1e-5);
	const FTexel Quarter = TonemapPixel(Color, UseTableRun(0.25f));
	EXPECT_NEAR(0.75 * Plain[0] + 0.25 * Plain[2], Quarter[0], 1e-5);
}

TEST(LegacyTable, IsInterpolatedBetweenItsColours)
{
	// A table is exact at multiples of 1/15 only: squares, halfway between 7/15 and 8/15.
	const Drydock::FScopedTextureLoader Loader(
		[](const std::string&) {
			return MakeTable([](ToneReference::FVec C) { return ToneReference::FVec{C[0] * C[0], C[1], C[2] * C[2]}; });
		});
	const double Code = 7.5 / 15, Value = ToneReference::DecodeSrgb(Code);
	const FTexel Result = TonemapPixel({Value, Value, Value, 1}, UseTableRun(1));
	EXPECT_NEAR((49.0 + 64.0) / 2 / 225, Result[0], 1e-4);
	EXPECT_NEAR((49.0 + 64.0) / 2 / 225, Result[2], 1e-4);
	EXPECT_NEAR(Code, Result[1], 1e-4);
}

TEST(LegacyTable, WithoutPixelsIsNeutral)
{
	const FTexel Result = TonemapPixel({0.5, 0.5, 0.5, 1}, UseTableRun(1));
	EXPECT_NEAR(ToneReference::EncodeSrgb(0.5), Result[0], 1e-6);
}

TEST(Fade, ScalesThenCovers)
{
	const FTexel Result =
		TonemapPixel({0.5, 0.5, 0.5, 1}, {.Settings = Linear,
											 .View = [](FViewInfo& View)
											 {
												 View.ColorScale = FLinearColor(0.5f, 1.0f, 1.0f, 1.0f);
												 View.OverlayColor = FLinearColor(1.0f, 0.0f, 0.0f, 0.25f);
											 }});
	EXPECT_NEAR(ToneReference::EncodeSrgb(0.75 * 0.25 + 0.25), Result[0], 1e-5);
	EXPECT_NEAR(ToneReference::EncodeSrgb(0.75 * 0.5), Result[1], 1e-5);
}
