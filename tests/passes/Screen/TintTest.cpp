// The tint: which pixels it multiplies, what it leaves alone, hazards, and the pass by its name.
#include "FactoryTestUtils.h"

#include "Screen/Tint.h"

using namespace PassTest;
using namespace Drydock;

namespace
{

/** The area of every tint here: columns from 1/4 to 3/4, rows from 1/2 on. */
const FVector4f Area(0.25f, 0.5f, 0.75f, 1.0f);

/** The contract in double: colour times Color where the centre is inside the area. */
FImage Expected(const FImage& Image, const FTexel& Color)
{
	return FImage::Make(Image.Width, Image.Height,
		[&](int X, int Y)
		{
			const double U = (X + 0.5) / Image.Width, V = (Y + 0.5) / Image.Height;
			const bool bInside = U >= 0.25 && U < 0.75 && V >= 0.5 && V < 1.0;
			const FTexel Texel = Image.At(X, Y);
			return bInside ? FTexel{Texel[0] * Color[0], Texel[1] * Color[1], Texel[2] * Color[2], Texel[3]} : Texel;
		});
}

FScreenPassTexture Add(FPassRun& Run)
{
	FTintInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.Color = FLinearColor(2.0f, 0.5f, -1.0f, 8.0f); // alpha is not used
	Inputs.Area = Area;
	return AddTintPass(Run.GraphBuilder, Run.View, Inputs);
}

} // namespace

TEST(Tint, MultipliesThePixelsWhoseCentreIsInTheArea)
{
	for (const auto& [Width, Height] : {std::pair(8, 4), {7, 5}, {1, 1}, {2, 3}})
	{
		const FImage Image = FImage::Noise(Width, Height);
		FPassRun Run(Image, EArithmetic::Float32, PF_A32B32G32R32F);
		EXPECT_EQ(Expected(Image, {2, 0.5, -1}).Texels, Run.Execute(Add(Run)).Texels) << Width << "x" << Height;
	}
}

TEST(Tint, AnOffsetRectIsThePictureByItself)
{
	const FImage Image = FImage::Noise(12, 6);
	FPassRun Run(Image, {5, 3, 17, 9}, FIntPoint(24, 16), EArithmetic::Float32, PF_A32B32G32R32F);
	const FScreenPassTexture Output = Add(Run);
	EXPECT_EQ(FIntRect(5, 3, 17, 9), Output.ViewRect);
	EXPECT_EQ(Expected(Image, {2, 0.5, -1}).Texels, Run.Execute(Output).Texels);
}

TEST(Tint, NaNAndInfinityPassOn)
{
	FPassRun Run(FImage(2, 2, {NaN, Infinity, 0, 0.25}), EArithmetic::Float32, PF_A32B32G32R32F);
	FTintInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.Color = FLinearColor(0.0f, 0.0f, 0.0f, 0.0f);
	const FTexel Texel = Run.Execute(AddTintPass(Run.GraphBuilder, Run.View, Inputs)).At(1, 0);
	EXPECT_TRUE(std::isnan(Texel[0]));
	EXPECT_TRUE(std::isnan(Texel[1])); // infinity times 0
	EXPECT_EQ(0.0, Texel[2]);
	EXPECT_EQ(0.25, Texel[3]);
}

TEST(Tint, WritesTheTargetThatItIsGiven)
{
	const FImage Image = FImage::Noise(8, 4);
	FPassRun Run(Image, EArithmetic::Float32, PF_A32B32G32R32F);
	FTintInputs Inputs;
	Inputs.SceneColor = Run.Input;
	Inputs.Color = FLinearColor(2.0f, 0.5f, -1.0f, 1.0f);
	Inputs.Area = Area;
	Inputs.OverrideOutput = FScreenPassRenderTarget::CreateFromInput(
		Run.GraphBuilder, Run.Input, ERenderTargetLoadAction::ENoAction, TEXT("Given"));
	const FScreenPassTexture Output = AddTintPass(Run.GraphBuilder, Run.View, Inputs);
	EXPECT_EQ(Inputs.OverrideOutput.Texture, Output.Texture);
	EXPECT_EQ(Expected(Image, {2, 0.5, -1}).Texels, Run.Execute(Output).Texels);
}

TEST(Tint, ThePassOfThatNameTakesColourAndEdges)
{
	const FImage Image = FImage::Noise(8, 4);
	const FImage Result = RunFactory("Tint", Image,
		{{"Color", FLinearColor(2.0f, 0.5f, -1.0f, 1.0f)}, {"Left", 0.25}, {"Right", 0.75}, {"Top", 0.5}});
	EXPECT_EQ(Expected(Image, {2, 0.5, -1}).Texels, Result.Texels);
}
