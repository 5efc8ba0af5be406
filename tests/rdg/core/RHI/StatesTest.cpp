// Static states and samplers reach the kernel as they were written.
#include "CommonRenderResources.h"
#include "RHITestHelpers.h"

using namespace Drydock;
using namespace Drydock::Tests;

TEST(Sampler, DefaultOfAStaticStateIsPointAndClamp)
{
	const FKernelSampler Sampler = TStaticSamplerState<>::GetRHI()->GetKernelSampler();
	EXPECT_EQ(EKernelFilter::Point, Sampler.Filter);
	EXPECT_EQ(EKernelAddress::Clamp, Sampler.AddressU);
	EXPECT_EQ(EKernelAddress::Clamp, Sampler.AddressV);
	EXPECT_EQ(EKernelAddress::Clamp, Sampler.AddressW);
	EXPECT_EQ(0.0f, Sampler.Border[3]);
}

TEST(Sampler, DefaultOfAnInitializerIsPointAndWrap)
{
	const FKernelSampler Sampler = RHICreateSamplerState(FSamplerStateInitializerRHI())->GetKernelSampler();
	EXPECT_EQ(EKernelFilter::Point, Sampler.Filter);
	EXPECT_EQ(EKernelAddress::Wrap, Sampler.AddressU);
	EXPECT_EQ(EKernelAddress::Wrap, Sampler.AddressW);
}

TEST(Sampler, ArgumentsReachTheKernel)
{
	const FKernelSampler Sampler =
		TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Mirror, AM_Border, 1>::GetRHI()->GetKernelSampler();
	EXPECT_EQ(EKernelFilter::Bilinear, Sampler.Filter);
	EXPECT_EQ(EKernelAddress::Clamp, Sampler.AddressU);
	EXPECT_EQ(EKernelAddress::Mirror, Sampler.AddressV);
	EXPECT_EQ(EKernelAddress::Border, Sampler.AddressW);
	EXPECT_EQ(1.0f, Sampler.MipBias);
}

TEST(Sampler, TheSameArgumentsAreTheSameObject)
{
	FRHISamplerState* const First = TStaticSamplerState<SF_Point, AM_Clamp>::GetRHI();
	FRHISamplerState* const Second = TStaticSamplerState<SF_Point, AM_Clamp>::GetRHI();
	FRHISamplerState* const Other = TStaticSamplerState<SF_Point, AM_Mirror>::GetRHI();
	EXPECT_EQ(First, Second);
	EXPECT_NE(First, Other);
}

TEST(Sampler, BorderColourIsArgb)
{
	const FKernelSampler Sampler =
		TStaticSamplerState<SF_Point, AM_Border, AM_Border, AM_Border, 0, 1, 0x40ff8000>::GetRHI()->GetKernelSampler();
	EXPECT_EQ(1.0f, Sampler.Border[0]);
	EXPECT_EQ(128 / 255.0f, Sampler.Border[1]);
	EXPECT_EQ(0.0f, Sampler.Border[2]);
	EXPECT_EQ(64 / 255.0f, Sampler.Border[3]);
}

TEST(Sampler, AnisotropicFiltersBecomePointAndTrilinear)
{
	EXPECT_EQ(EKernelFilter::Trilinear, TStaticSamplerState<SF_AnisotropicLinear>::GetRHI()->GetKernelSampler().Filter);
	EXPECT_EQ(EKernelFilter::Point, TStaticSamplerState<SF_AnisotropicPoint>::GetRHI()->GetKernelSampler().Filter);
}

TEST(Sampler, SampleBitsAreReadWhenTheKernelIsBound)
{
	FRHISamplerState* const Sampler = TStaticSamplerState<SF_Bilinear>::GetRHI();
	EXPECT_EQ(8, Sampler->GetKernelSampler().SampleBits);
	const FScopedCVar SampleBits(TEXT("r.Drydock.SampleBits"), 0);
	EXPECT_EQ(0, Sampler->GetKernelSampler().SampleBits);
}

TEST(Sampler, ComparesWhereItsStateSaysSo)
{
	FSamplerStateInitializerRHI Initializer;
	EXPECT_EQ(EKernelCompare::Never, RHICreateSamplerState(Initializer)->GetKernelSampler().Compare);
	Initializer.SamplerComparisonFunction = SCF_Less;
	EXPECT_EQ(EKernelCompare::Less, RHICreateSamplerState(Initializer)->GetKernelSampler().Compare);
}

TEST(BlendState, DefaultReplaces)
{
	const FBlendStateInitializerRHI::FRenderTarget& Target = TStaticBlendState<>::GetRHI()->GetTarget(0);
	EXPECT_FALSE(Target.IsBlending());
	EXPECT_EQ(CW_RGBA, Target.ColorWriteMask);
}

TEST(BlendState, AdditiveReadsItsTarget)
{
	FRHIBlendState* const State = TStaticBlendState<CW_RGB, BO_Add, BF_One, BF_One>::GetRHI();
	EXPECT_TRUE(State->GetTarget(0).IsBlending());
	EXPECT_EQ(BF_One, State->GetTarget(0).ColorDestBlend);
	EXPECT_EQ(CW_RGB, State->GetTarget(0).ColorWriteMask);
}

TEST(BlendState, OneStateServesAllTargetsUnlessTheyDiffer)
{
	FRHIBlendState* const Shared = TStaticBlendState<CW_RED>::GetRHI();
	FRHIBlendState* const Masks = TStaticBlendStateWriteMask<CW_RED, CW_NONE>::GetRHI();
	EXPECT_EQ(CW_RED, Shared->GetTarget(3).ColorWriteMask);
	EXPECT_EQ(CW_NONE, Masks->GetTarget(1).ColorWriteMask);
	EXPECT_EQ(CW_RGBA, Masks->GetTarget(2).ColorWriteMask);
}

TEST(DepthStencilState, TheDefaultTestsAndWritesTheScreenOneDoesNot)
{
	FRHIDepthStencilState* const Default = TStaticDepthStencilState<>::GetRHI();
	FRHIDepthStencilState* const Screen = TStaticDepthStencilState<false, CF_Always>::GetRHI();
	EXPECT_TRUE(Default->IsTesting());
	EXPECT_EQ(CF_GreaterEqual, Default->GetInitializer().DepthTest);
	EXPECT_FALSE(Screen->IsTesting());
}

TEST(DepthStencilState, AStencilTestCounts)
{
	FRHIDepthStencilState* const State = TStaticDepthStencilState<false, CF_Always, true, CF_Equal>::GetRHI();
	EXPECT_TRUE(State->IsTesting());
	EXPECT_EQ(CF_Equal, State->GetInitializer().FrontFaceStencilTest);
}

TEST(PlainTextures, AreOneTexelOfTheirColour)
{
	EXPECT_EQ(FLinearColor(1, 1, 1, 1), GWhiteTexture->TextureRHI->ReadTexel(0, 0));
	EXPECT_EQ(FLinearColor(0, 0, 0, 1), GBlackTexture->TextureRHI->ReadTexel(0, 0));
	EXPECT_EQ(FLinearColor(0, 0, 0, 0), GTransparentBlackTexture->TextureRHI->ReadTexel(0, 0));
	FTexture* const White = GWhiteTexture;
	EXPECT_EQ(1u, White->GetSizeX());
}

TEST(VertexDeclarations, ExistForPipelineStates)
{
	FGraphicsPipelineStateInitializer Initializer;
	Initializer.BoundShaderState.VertexDeclarationRHI = GFilterVertexDeclaration.VertexDeclarationRHI;
	EXPECT_NE(nullptr, Initializer.BoundShaderState.VertexDeclarationRHI);
}

TEST(RasterizerState, OfModesAtRunTimeIsTheStaticOne)
{
	EXPECT_EQ((TStaticRasterizerState<FM_Solid, CM_CW, false, true>::GetRHI()),
		GetStaticRasterizerState<true>(FM_Solid, CM_CW));
	EXPECT_EQ((TStaticRasterizerState<FM_Wireframe, CM_None, false, false>::GetRHI()),
		GetStaticRasterizerState<false>(FM_Wireframe, CM_None));
	EXPECT_EQ((TStaticRasterizerState<FM_Point, CM_CCW, false, true>::GetRHI()),
		GetStaticRasterizerState<true>(FM_Point, CM_CCW));
}
