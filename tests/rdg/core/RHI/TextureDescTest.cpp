// Texture descriptions are made, compared and checked.
#include "RHITestHelpers.h"

using namespace Drydock::Tests;

TEST(ClearValue, DefaultIsTransparentBlack)
{
	EXPECT_EQ(FClearValueBinding::Transparent, FClearValueBinding());
	EXPECT_EQ(EClearBinding::EColorBound, FClearValueBinding().ColorBinding);
}

TEST(ClearValue, ConstantsHoldWhatTheyAreNamed)
{
	EXPECT_EQ(FLinearColor(0, 0, 0, 1), FClearValueBinding::Black.GetClearColor());
	EXPECT_EQ(FLinearColor(1, 1, 1, 1), FClearValueBinding::White.GetClearColor());
	EXPECT_EQ(EClearBinding::ENoneBound, FClearValueBinding::None.ColorBinding);
	EXPECT_EQ(1.0f, FClearValueBinding::DepthNear.Value.DSValue.Depth);
	EXPECT_EQ(0.0f, FClearValueBinding::DepthFar.Value.DSValue.Depth);
}

TEST(ClearValue, ComparisonLooksAtWhatIsBound)
{
	EXPECT_NE(FClearValueBinding::Black, FClearValueBinding::Transparent);
	EXPECT_NE(FClearValueBinding::DepthZero, FClearValueBinding(0.0f, 1u));
	EXPECT_EQ(FClearValueBinding::DepthZero, FClearValueBinding::DepthFar);
}

TEST(TextureDesc, DefaultIsOneTexelOfNoFormat)
{
	EXPECT_EQ(FIntPoint(1, 1), FRHITextureDesc().Extent);
	EXPECT_FALSE(FRHITextureDesc().IsValid());
}

TEST(TextureDesc, Create3DHasDepth)
{
	const FRHITextureDesc Desc =
		FRHITextureDesc::Create3D(FIntVector(32, 16, 8), PF_FloatRGBA, FClearValueBinding::Black, TexCreate_UAV);
	EXPECT_TRUE(Desc.IsTexture3D());
	EXPECT_EQ(FIntVector(32, 16, 8), Desc.GetSize());
	EXPECT_TRUE(Desc.IsValid());
}

TEST(TextureDesc, ACubeHasSixSlicesPerLayer)
{
	EXPECT_EQ(
		6, FRHITextureDesc::CreateCube(8, PF_FloatRGBA, FClearValueBinding::Black, TexCreate_None).GetNumSlices());
	EXPECT_EQ(18,
		FRHITextureDesc::CreateCubeArray(8, PF_FloatRGBA, FClearValueBinding::Black, TexCreate_None, 3).GetNumSlices());
}

TEST(TextureDesc, ResetMakesAnInputAnOutput)
{
	FRHITextureDesc Desc = FRHITextureDesc::Create2D(FIntPoint(4, 4), PF_FloatRGBA, FClearValueBinding::Black,
		TexCreate_UAV | TexCreate_ShaderResource | TexCreate_Memoryless, 1, 4);
	Desc.Reset();
	EXPECT_EQ(1, Desc.NumSamples);
	EXPECT_EQ(TexCreate_ShaderResource | TexCreate_RenderTargetable, Desc.Flags);
}

TEST(TextureDesc, EveryMemberCountsInComparison)
{
	const FRHITextureDesc A = Make2D(FIntPoint(8, 4), PF_FloatRGBA);
	FRHITextureDesc B = A;
	EXPECT_EQ(A, B);
	EXPECT_EQ(GetTypeHash(A), GetTypeHash(B));
	B.ClearValue = FClearValueBinding::White;
	EXPECT_NE(A, B);
	B = A;
	B.Extent.Y = 5;
	EXPECT_NE(A, B);
}

TEST(TextureDesc, AChainMayEndAtOneTexelButNotBelow)
{
	EXPECT_TRUE(Make2D(FIntPoint(8, 5), PF_FloatRGBA, 4).IsValid());
	EXPECT_FALSE(Make2D(FIntPoint(8, 5), PF_FloatRGBA, 5).IsValid());
}

TEST(TextureDesc, InvalidShapesSayWhy)
{
	FString Reason;
	EXPECT_FALSE(Make2D(FIntPoint(0, 4), PF_FloatRGBA).IsValid(&Reason));
	EXPECT_TRUE(Reason.Contains(TEXT("extent")));
	EXPECT_FALSE(Make2D(FIntPoint(20000, 4), PF_FloatRGBA).IsValid(&Reason));
	EXPECT_TRUE(Reason.Contains(TEXT("16384")));
	EXPECT_FALSE(Make2D(FIntPoint(4, 4), PF_X24_G8).IsValid(&Reason));
	EXPECT_TRUE(Reason.Contains(TEXT("format")));
}

TEST(TextureDesc, OnlyArraysHaveSlicesAndOnly3DHasDepth)
{
	FRHITextureDesc Desc = Make2D(FIntPoint(4, 4), PF_FloatRGBA);
	Desc.ArraySize = 2;
	EXPECT_FALSE(Desc.IsValid());
	Desc.ArraySize = 1;
	Desc.Depth = 2;
	EXPECT_FALSE(Desc.IsValid());
}

TEST(TextureDesc, CreateDescChains)
{
	const FRHITextureCreateDesc Desc = FRHITextureCreateDesc::Create2D(TEXT("Chained"), 8, 4, PF_R16F)
										   .SetNumMips(2)
										   .AddFlags(TexCreate_UAV)
										   .AddFlags(TexCreate_SRGB);
	EXPECT_STREQ("Chained", Desc.DebugName);
	EXPECT_EQ(FIntPoint(8, 4), Desc.Extent);
	EXPECT_EQ(2, Desc.NumMips);
	EXPECT_EQ(TexCreate_UAV | TexCreate_SRGB, Desc.Flags);
}

TEST(Access, NamesListTheBits)
{
	EXPECT_STREQ("Unknown", *GetRHIAccessName(ERHIAccess::Unknown));
	EXPECT_STREQ("SRVCompute|SRVGraphics", *GetRHIAccessName(ERHIAccess::SRVMask));
	EXPECT_STREQ("ShadingRateSource", *GetRHIAccessName(ERHIAccess::ShadingRateSource));
}

TEST(Access, ReadAndWriteTogetherIsInvalid)
{
	EXPECT_TRUE(IsValidAccess(ERHIAccess::SRVMask | ERHIAccess::CopySrc));
	EXPECT_TRUE(IsValidAccess(ERHIAccess::UAVCompute));
	EXPECT_FALSE(IsValidAccess(ERHIAccess::SRVCompute | ERHIAccess::UAVCompute));
	EXPECT_FALSE(IsValidAccess(ERHIAccess::RTV | ERHIAccess::UAVGraphics));
}
