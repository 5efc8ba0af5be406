// RED depth of field: circles by depth against the formula, the two layers, what must not change, hazards.
#include "PassTestUtils.h"

#include "Lens/REDDepthOfField.h"

using namespace Drydock;

using namespace PassTest;
using PassReference::FRect;
using PassReference::MaxDifference;

namespace
{

struct FDofRun
{
	FREDDepthOfFieldInputs Inputs;
	EArithmetic Arithmetic = EArithmetic::Float32;
	FIntPoint Padding = FIntPoint(0, 0);

	FDofRun()
	{
		Inputs.FocalDistance = 500.0f;
		Inputs.FocalRegion = 100.0f;
		Inputs.NearTransition = 200.0f;
		Inputs.FarTransition = 400.0f;
		Inputs.NearBlurSize = Inputs.FarBlurSize = 15.0f;
	}

	/** Depth: cm. */
	FImage Run(const FImage& Color, const std::function<double(int, int)>& Depth) const
	{
		const FRect Rect{Padding.X, Padding.Y, Padding.X + Color.Width, Padding.Y + Color.Height};
		const FIntPoint Extent(Color.Width + 2 * Padding.X, Color.Height + 2 * Padding.Y);
		FPassRun Pass(Color, Rect, Extent, Arithmetic, PF_A32B32G32R32F);
		// Reversed depth of a near plane at 10 cm: z = 10 / d.
		Pass.View.UniformParameters.InvDeviceZToWorldZTransform = FVector4f(0.0f, 0.0f, 0.1f, 0.0f);
		Pass.View.InitViewUniformBuffer(Extent);
		FSceneTextures SceneTextures;
		SceneTextures.Depth = Pass.AddInput(FImage::Make(Color.Width, Color.Height,
												[&](int X, int Y) {
													return FTexel{10 / Depth(X, Y), 0, 0, 0};
												}),
									  Rect, Extent, PF_R32_FLOAT, TEXT("Depth"))
								  .Texture;
		FREDDepthOfFieldInputs Dof = Inputs;
		Dof.SceneColor = Pass.Input;
		Dof.SceneTextures = CreateSceneTextureUniformBuffer(Pass.GraphBuilder, &SceneTextures);
		return Pass.Execute(AddREDDepthOfFieldPasses(Pass.GraphBuilder, Pass.View, Dof));
	}

	FImage Run(const FImage& Color, double Depth) const
	{
		return Run(Color, [=](int, int) { return Depth; });
	}
};

/** Fine stripes: any blur turns them grey. */
FImage Stripes(int Width, int Height)
{
	return FImage::Make(Width, Height,
		[](int X, int) {
			return FTexel{X % 2 ? 1.0 : 0.0, X % 2 ? 1.0 : 0.0, X % 2 ? 1.0 : 0.0, 1};
		});
}

/** How much of the stripes is left in the middle: 1 all, 0 grey. */
double Contrast(const FImage& Image)
{
	const int X = Image.Width / 2, Y = Image.Height / 2;
	return std::abs(Image.At(X, Y)[0] - Image.At(X + 1, Y)[0]);
}

double Saturate(double Value)
{
	return std::min(std::max(Value, 0.0), 1.0);
}

/** The article's loop over its table by distance, rows then columns, the last tap on the radius. */
FImage BlurAsPrinted(const FImage& Layer, double Radius)
{
	constexpr double Weights[] = {0.0044, 0.0540, 0.2420, 0.3990, 0.2420, 0.0540, 0.0044};
	FImage Result = Layer;
	for (const bool bRows : {true, false})
	{
		const FImage Source = Result;
		Result = FImage::Make(Layer.Width, Layer.Height,
			[&](int X, int Y)
			{
				FTexel Sum{0, 0, 0, 0};
				for (int Tap = -6; Tap <= 6; ++Tap)
				{
					const double Distance = Tap * Radius / 6;
					Sum = Sum + PassReference::SampleInRect(Source, {0, 0, Layer.Width, Layer.Height},
									X + 0.5 + (bRows ? Distance : 0), Y + 0.5 + (bRows ? 0 : Distance), false) *
									Weights[std::abs(Tap)];
				}
				return Sum;
			});
	}
	return Result;
}

/** A layer: the mean of 2x2 texels, in red times its weight, the weight itself in alpha; blurred. */
FImage BlurLayer(const FImage& Color, const std::function<double(int, int)>& Weight, double Radius, bool bAsPrinted)
{
	const FImage Layer = FImage::Make((Color.Width + 1) / 2, (Color.Height + 1) / 2,
		[&](int X, int Y)
		{
			FTexel Sum{0, 0, 0, 0};
			for (int Corner = 0; Corner < 4; ++Corner)
			{
				const int ColorX = std::min(2 * X + Corner % 2, Color.Width - 1);
				const int ColorY = std::min(2 * Y + Corner / 2, Color.Height - 1);
				const double Share = Weight(ColorX, ColorY) / 4;
				const FTexel Texel = Color.At(ColorX, ColorY);
				Sum = Sum + FTexel{Texel[0], Texel[1], Texel[2], 1} * Share;
			}
			return Sum;
		});
	return bAsPrinted ? BlurAsPrinted(Layer, Radius)
					  : PassReference::GaussianBlur(
							Layer, Radius, static_cast<int>(std::ceil(Radius)), PassReference::EAddress::Clamp);
}

/** The effect by its formula, in double. */
FImage Reference(const FImage& Color, const std::function<double(int, int)>& Depth, const FREDDepthOfFieldInputs& Dof)
{
	const auto Far = [&](int X, int Y)
	{
		return Saturate((Depth(X, Y) - Dof.FocalDistance - Dof.FocalRegion) / Dof.FarTransition);
	};
	const auto One = [](int, int)
	{
		return 1.0;
	};
	const int HalfWidth = (Color.Width + 1) / 2;
	const FImage FarLayer = BlurLayer(Color, Dof.bAsPrinted ? std::function<double(int, int)>(One) : Far,
		HalfWidth * static_cast<double>(Dof.FarBlurSize) / 200, Dof.bAsPrinted);
	const FImage NearLayer =
		BlurLayer(Color, One, HalfWidth * static_cast<double>(Dof.NearBlurSize) / 200, Dof.bAsPrinted);
	return FImage::Make(Color.Width, Color.Height,
		[&](int X, int Y)
		{
			const auto Sample = [&](const FImage& Layer)
			{
				const FTexel Texel = PassReference::SampleInRect(
					Layer, {0, 0, Layer.Width, Layer.Height}, (X + 0.5) / 2, (Y + 0.5) / 2, false);
				return Dof.bAsPrinted ? Texel : Texel[3] > 0 ? Texel * (1 / Texel[3]) : Color.At(X, Y);
			};
			const double FarMix = Far(X, Y);
			const double NearMix = Saturate((Dof.FocalDistance - Depth(X, Y)) / Dof.NearTransition);
			FTexel Result = Color.At(X, Y);
			Result = Result * (1 - FarMix) + Sample(FarLayer) * FarMix;
			Result = Result * (1 - NearMix) + Sample(NearLayer) * NearMix;
			Result[3] = Color.At(X, Y)[3];
			return Result;
		});
}

} // namespace

TEST(REDDepthOfField, WholeEffectEqualsItsFormulaInDouble)
{
	const auto Depth = [](int X, int Y)
	{
		return 200.0 + 17 * X + 5 * Y; // before, in and behind the focus
	};
	for (const auto& [Width, Height] : {std::pair(64, 32), {63, 31}})
	{
		for (const bool bAsPrinted : {false, true})
		{
			FDofRun Run;
			Run.Arithmetic = EArithmetic::Exact;
			Run.Inputs.NearBlurSize = 9.0f;
			Run.Inputs.bAsPrinted = bAsPrinted;
			const FImage Image = FImage::Noise(Width, Height, 4.0);
			EXPECT_LE(MaxDifference(Reference(Image, Depth, Run.Inputs), Run.Run(Image, Depth), 4), 1e-4)
				<< Width << "x" << Height << (bAsPrinted ? " as printed" : "");
		}
	}
}

TEST(REDDepthOfField, PlaneInFocusIsUnchangedBitForBit)
{
	const FImage Image = FImage::Noise(33, 17, 8.0);
	for (const double Depth : {500.1, 550.0, 599.9}) // the depth buffer rounds
	{
		EXPECT_EQ(Image.Texels, FDofRun().Run(Image, Depth).Texels) << Depth;
	}
}

TEST(REDDepthOfField, NoFocalDistanceBuildsNothing)
{
	const FImage Image = FImage::Noise(9, 5);
	for (const float Distance : {0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN()})
	{
		FDofRun Run;
		Run.Inputs.FocalDistance = Distance;
		EXPECT_EQ(Image.Texels, Run.Run(Image, 5000).Texels);
	}
}

TEST(REDDepthOfField, FarMixGrowsLinearlyOverTheTransition)
{
	// far = (d - 600) / 400; the stripes' contrast falls with it, since the half-size mean of two stripes is grey.
	for (const double Far : {0.25, 0.5, 1.0})
	{
		EXPECT_NEAR(1 - Far, Contrast(FDofRun().Run(Stripes(64, 32), 600 + 400 * Far)), 1e-3) << Far;
	}
	EXPECT_NEAR(0, Contrast(FDofRun().Run(Stripes(64, 32), 5000)), 1e-5);
}

TEST(REDDepthOfField, NearMixGrowsLinearlyOverTheTransition)
{
	for (const double Near : {0.25, 0.5, 1.0})
	{
		EXPECT_NEAR(1 - Near, Contrast(FDofRun().Run(Stripes(64, 32), 500 - 200 * Near)), 1e-3) << Near;
	}
}

TEST(REDDepthOfField, TransitionOfNoLengthIsAStep)
{
	FDofRun Run;
	Run.Inputs.NearTransition = Run.Inputs.FarTransition = 0.0f;
	EXPECT_EQ(1, Contrast(Run.Run(Stripes(64, 32), 600)));
	EXPECT_NEAR(0, Contrast(Run.Run(Stripes(64, 32), 601)), 1e-5);
	EXPECT_NEAR(0, Contrast(Run.Run(Stripes(64, 32), 499)), 1e-5);
}

TEST(REDDepthOfField, ConstantPictureStaysConstantAtEveryDepth)
{
	const FImage Image(31, 19, {0.75, 0.5, 3, 1});
	const FImage Result = FDofRun().Run(Image, [](int X, int Y) { return 50.0 + 60 * X + 11 * Y; });
	EXPECT_LE(MaxDifference(Image, Result, 4), 1e-5);
}

TEST(REDDepthOfField, AsPrintedTheBlurQuadruplesTheLight)
{
	// The weights by distance sum to 0.0044 + 2 * (0.9998 - 0.0044), once for the rows and once for the columns.
	const double Gain = 1.9952 * 1.9952;
	FDofRun Run;
	Run.Inputs.bAsPrinted = true;
	const FImage Image(31, 19, {0.75, 0.5, 3, 1});
	for (const double Depth : {100.0, 5000.0})
	{
		EXPECT_NEAR(0.5 * Gain, Run.Run(Image, Depth).At(7, 9)[1], 1e-5) << Depth;
	}
	EXPECT_EQ(Image.Texels, Run.Run(Image, 550).Texels);
}

TEST(REDDepthOfField, FarLayerDoesNotGatherWhatIsInFocus)
{
	// A bright half in focus before a dark far half.
	const FImage Image = FImage::Make(64, 32,
		[](int X, int) {
			return X < 32 ? FTexel{8, 8, 8, 1} : FTexel{0, 0, 0, 1};
		});
	const auto Depth = [](int X, int)
	{
		return X < 32 ? 550.0 : 5000.0;
	};
	FDofRun Run;
	EXPECT_EQ(0, Run.Run(Image, Depth).At(33, 16)[0]);
	Run.Inputs.bAsPrinted = true;
	EXPECT_GT(Run.Run(Image, Depth).At(33, 16)[0], 0.1);
}

TEST(REDDepthOfField, FarLightSpreadsWithinTheFarLayer)
{
	FImage Image(64, 32, {0, 0, 0, 1});
	Image.At(32, 16) = {64, 64, 64, 1};
	const FImage Result = FDofRun().Run(Image, 5000);
	EXPECT_LT(Result.At(32, 16)[0], 16); // the mean of four texels at most
	EXPECT_GT(Result.At(35, 16)[0], 0.01);
}

TEST(REDDepthOfField, BlurGrowsWithItsSize)
{
	FImage Image(64, 32, {0, 0, 0, 1});
	Image.At(32, 16) = {64, 64, 64, 1};
	FDofRun Narrow, Wide;
	Narrow.Inputs.FarBlurSize = 8.0f;
	Wide.Inputs.FarBlurSize = 30.0f;
	EXPECT_GT(Narrow.Run(Image, 5000).At(32, 16)[0], Wide.Run(Image, 5000).At(32, 16)[0]);
}

TEST(REDDepthOfField, OffsetRectEqualsTheCroppedPicture)
{
	const FImage Image = FImage::Noise(32, 16, 4.0);
	const auto Depth = [](int X, int)
	{
		return 300.0 + 30 * X;
	};
	FDofRun Run;
	const FImage Cropped = Run.Run(Image, Depth);
	Run.Padding = FIntPoint(7, 3);
	EXPECT_LE(MaxDifference(Cropped, Run.Run(Image, Depth), 4), 1e-5);
}

TEST(REDDepthOfField, SmallestSizes)
{
	for (const auto& [Width, Height] : {std::pair(1, 1), {1, 5}, {2, 1}, {7, 3}})
	{
		const FImage Image(Width, Height, {0.5, 0.5, 0.5, 1});
		EXPECT_LE(MaxDifference(Image, FDofRun().Run(Image, 5000), 4), 1e-6) << Width << "x" << Height;
	}
}

TEST(REDDepthOfField, InfiniteLightInFocusDoesNotReachTheFarLayer)
{
	FImage Image(64, 32, {0.25, 0.25, 0.25, 1});
	Image.At(10, 16) = {Infinity, Infinity, Infinity, 1};
	const FImage Result = FDofRun().Run(Image, [](int X, int) { return X < 32 ? 550.0 : 5000.0; });
	EXPECT_NEAR(0.25, Result.At(40, 16)[0], 1e-5);
	EXPECT_EQ(Infinity, Result.At(10, 16)[0]);
}

TEST(REDDepthOfField, SkyIsFar)
{
	EXPECT_NEAR(0, Contrast(FDofRun().Run(Stripes(64, 32), 6550400)), 1e-5);
}

TEST(REDDepthOfField, DefaultSettingsHaveNoFocus)
{
	EXPECT_EQ(0.0f, FREDDepthOfFieldInputs::FromSettings(FFinalPostProcessSettings(), {}).FocalDistance);
}
