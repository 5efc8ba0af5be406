// Cubes in passes of the graph: written as arrays of faces, sampled as cubes; what is no cube where one is read, and a
// sampler that compares nothing, are one message each.
#include <gtest/gtest.h>

#include <cstdlib>

#include "Diagnostics.h"
#include "RHIStaticStates.h"
#include "RenderGraphBuilder.h"
#include "RenderGraphUtils.h"
#include "RenderTargetPool.h"
#include "ShaderTypes.h"

namespace
{

constexpr ETextureCreateFlags Flags = TexCreate_UAV | TexCreate_ShaderResource;

class FShaderCubesInGraph : public testing::Test
{
protected:
	static void SetUpTestSuite()
	{
		setenv("DRYDOCK_CACHE_DIR", DRYDOCK_TEST_BINARY_DIR "/test-shader-cache", 0);
		AddShaderSourceDirectoryMapping(
			TEXT("/DrydockTest"), FString(DRYDOCK_TEST_SOURCE_DIR "/tests/rdg/graph/Binding/Shaders"));
	}

	static FRDGTextureRef MakeFaces(FRDGBuilder& GraphBuilder, const FRDGTextureDesc& Desc, const TCHAR* Name)
	{
		const FRDGTextureRef Texture = GraphBuilder.CreateTexture(Desc, Name);
		auto* const Parameters = GraphBuilder.AllocParameters<FTestCubeFacesCS::FParameters>();
		Parameters->OutputFaces = GraphBuilder.CreateUAV(Texture);
		FComputeShaderUtils::AddPass(GraphBuilder, RDG_EVENT_NAME("Faces of %s", Name),
			TShaderMapRef<FTestCubeFacesCS>(GetGlobalShaderMap(GMaxRHIFeatureLevel)), Parameters,
			FIntVector(1, 1, Desc.GetNumSlices()));
		return Texture;
	}

	/** Change: of the parameters before the pass is added. */
	template<typename F>
	static TRefCountPtr<IPooledRenderTarget> Run(F Change)
	{
		FRDGBuilder GraphBuilder(FRHICommandListExecutor::GetImmediateCommandList());
		auto* const Parameters = GraphBuilder.AllocParameters<FTestCubeSamplesCS::FParameters>();
		Parameters->Sky = MakeFaces(GraphBuilder,
			FRDGTextureDesc::CreateCube(4, PF_A32B32G32R32F, FClearValueBinding::None, Flags), TEXT("Sky"));
		Parameters->Skies = MakeFaces(GraphBuilder,
			FRDGTextureDesc::CreateCubeArray(4, PF_A32B32G32R32F, FClearValueBinding::None, Flags, 2), TEXT("Skies"));
		Parameters->Faces = GraphBuilder.CreateSRV(Parameters->Sky);
		Parameters->Depth = GraphBuilder.CreateTexture(
			FRDGTextureDesc::Create2D(FIntPoint(2, 2), PF_R32_FLOAT, FClearValueBinding::None, Flags), TEXT("Depth"));
		AddClearUAVPass(GraphBuilder, GraphBuilder.CreateUAV(Parameters->Depth), FVector4f(0.75f, 0, 0, 0));
		Parameters->SkySampler = TStaticSamplerState<SF_Bilinear>::GetRHI();
		Parameters->DepthSampler =
			TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Clamp, AM_Clamp, 0, 1, 0, SCF_Less>::GetRHI();
		const FRDGTextureRef Output = GraphBuilder.CreateTexture(
			FRDGTextureDesc::Create2D(FIntPoint(4, 1), PF_A32B32G32R32F, FClearValueBinding::None, Flags),
			TEXT("Output"));
		Parameters->OutputTexture = GraphBuilder.CreateUAV(Output);
		Change(*Parameters);
		FComputeShaderUtils::AddPass(GraphBuilder, RDG_EVENT_NAME("Samples"),
			TShaderMapRef<FTestCubeSamplesCS>(GetGlobalShaderMap(GMaxRHIFeatureLevel)), Parameters,
			FIntVector(1, 1, 1));
		TRefCountPtr<IPooledRenderTarget> Result;
		GraphBuilder.QueueTextureExtraction(Output, &Result);
		GraphBuilder.Execute();
		return Result;
	}

	template<typename F>
	static std::string ErrorOf(F Change)
	{
		try
		{
			Run(Change);
		}
		catch (const Drydock::FError& Error)
		{
			return Error.what();
		}
		return {};
	}
};

} // namespace

TEST_F(FShaderCubesInGraph, FacesAreWrittenAsSlicesAndSampledAsACube)
{
	const TRefCountPtr<IPooledRenderTarget> Result = Run([](auto&) {});
	FRHITexture& Texture = *Result->GetRHI();
	// v is 0.375: texels 1 and 2 ... 1.5 - 0.5 = row 1. Left column of +X (slice 0), right column of +Z (slice 4).
	EXPECT_EQ(FLinearColor(2, 1.5f, 1, 1), Texture.ReadTexel(0, 0));
	EXPECT_EQ(FLinearColor(9, 1.5f, 1.5f, 1), Texture.ReadTexel(1, 0));
	EXPECT_EQ(FLinearColor(3, 1, 2, 1), Texture.ReadTexel(2, 0));
	EXPECT_EQ(1.0f, Texture.ReadTexel(3, 0).R);
}

TEST_F(FShaderCubesInGraph, WhatIsNoCubeIsNamed)
{
	const std::string Error =
		ErrorOf([](FTestCubeSamplesCS::FParameters& Parameters) { Parameters.Sky = Parameters.Depth; });
	EXPECT_NE(std::string::npos, Error.find("'Sky' is read by /DrydockTest/Cubes.usf:")) << Error;
	EXPECT_NE(std::string::npos, Error.find("as a TextureCube, and the texture Depth is none")) << Error;
	const std::string Other =
		ErrorOf([](FTestCubeSamplesCS::FParameters& Parameters) { Parameters.Depth = Parameters.Sky; });
	EXPECT_NE(std::string::npos, Other.find("as no cube, and the texture Sky is one")) << Other;
}

TEST_F(FShaderCubesInGraph, ASamplerThatComparesNothingIsNamed)
{
	const std::string Error = ErrorOf(
		[](FTestCubeSamplesCS::FParameters& Parameters) { Parameters.DepthSampler = TStaticSamplerState<>::GetRHI(); });
	EXPECT_NE(std::string::npos, Error.find("'DepthSampler' is read by")) << Error;
	EXPECT_NE(std::string::npos, Error.find("has no SamplerComparisonFunction (SCF_Less)")) << Error;
}
