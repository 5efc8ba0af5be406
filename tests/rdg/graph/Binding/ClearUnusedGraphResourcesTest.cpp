// A pass depends on what its shader reads, not on what its parameter struct could hold. The resources here are
// addresses that nobody follows.
#include <gtest/gtest.h>

#include <cstdlib>

#include "ShaderTypes.h"

namespace
{

template<typename T>
T* Fake(uintptr_t Address)
{
	return reinterpret_cast<T*>(Address);
}

/** A pass's struct around the shader's. */
BEGIN_SHADER_PARAMETER_STRUCT(FPassParameters, )
	SHADER_PARAMETER_STRUCT_INCLUDE(FTestGraphCS::FParameters, Shader)
	RENDER_TARGET_BINDING_SLOTS()
END_SHADER_PARAMETER_STRUCT()

class FClearUnused : public testing::Test
{
protected:
	static void SetUpTestSuite()
	{
		setenv("DRYDOCK_CACHE_DIR", DRYDOCK_TEST_BINARY_DIR "/test-shader-cache", 0);
		AddShaderSourceDirectoryMapping(
			TEXT("/DrydockTest"), FString(DRYDOCK_TEST_SOURCE_DIR "/tests/rdg/graph/Binding/Shaders"));
	}

	FClearUnused()
	{
		Parameters.InputTexture = Fake<FRDGTexture>(0x1000);
		Parameters.UnusedTexture = Fake<FRDGTexture>(0x2000);
		Parameters.UnusedView = Fake<FRDGTextureSRV>(0x3000);
		Parameters.OutputTexture = Fake<FRDGTextureUAV>(0x4000);
		Parameters.UnusedBuffer = Fake<FRDGBufferSRV>(0x5000);
		Parameters.Scene = Fake<TRDGUniformBuffer<FTestSceneUniforms>>(0x6000);
		Parameters.UnusedRHITexture = Fake<FRHITexture>(0x7000);
		Parameters.CopySource = Fake<FRDGTexture>(0x8000);
	}

	static TShaderMapRef<FTestGraphCS> Shader(bool bUseScene)
	{
		return TShaderMapRef<FTestGraphCS>(GetGlobalShaderMap(GMaxRHIFeatureLevel), bUseScene ? 1 : 0);
	}

	FTestGraphCS::FParameters Parameters;
};

} // namespace

TEST_F(FClearUnused, WhatTheShaderReadsStays)
{
	ClearUnusedGraphResources(Shader(false), &Parameters);
	EXPECT_EQ(Fake<FRDGTexture>(0x1000), Parameters.InputTexture);
	EXPECT_EQ(Fake<FRDGTextureUAV>(0x4000), Parameters.OutputTexture);
}

TEST_F(FClearUnused, WhatItDoesNotReadGoes)
{
	ClearUnusedGraphResources(Shader(false), &Parameters);
	EXPECT_EQ(nullptr, Parameters.UnusedTexture);
	EXPECT_EQ(nullptr, Parameters.UnusedView);
	EXPECT_EQ(nullptr, Parameters.UnusedBuffer);
}

TEST_F(FClearUnused, UniformBuffersGoUnlessThePermutationReadsThem)
{
	FTestGraphCS::FParameters Reading = Parameters;
	ClearUnusedGraphResources(Shader(false), &Parameters);
	ClearUnusedGraphResources(Shader(true), &Reading);
	EXPECT_FALSE(Parameters.Scene.IsValid());
	EXPECT_TRUE(Reading.Scene.IsValid());
}

TEST_F(FClearUnused, RenderTargetsStay)
{
	FPassParameters Pass;
	Pass.Shader = Parameters;
	Pass.RenderTargets[0] = FRenderTargetBinding(Fake<FRDGTexture>(0x9000), ERenderTargetLoadAction::ELoad);
	ClearUnusedGraphResources(Shader(false), FPassParameters::FTypeInfo::GetStructMetadata(), &Pass);
	EXPECT_EQ(Fake<FRDGTexture>(0x9000), Pass.RenderTargets[0].GetTexture());
	EXPECT_EQ(nullptr, Pass.Shader.UnusedTexture);
}

TEST_F(FClearUnused, AccessesAndForeignTexturesStay)
{
	ClearUnusedGraphResources(Shader(false), &Parameters);
	EXPECT_EQ(Fake<FRDGTexture>(0x8000), Parameters.CopySource.GetTexture());
	EXPECT_EQ(Fake<FRHITexture>(0x7000), Parameters.UnusedRHITexture);
}

TEST_F(FClearUnused, ExcludedResourcesStay)
{
	ClearUnusedGraphResources(Shader(false), &Parameters, {Fake<FRDGResource>(0x2000)});
	EXPECT_EQ(Fake<FRDGTexture>(0x2000), Parameters.UnusedTexture);
	EXPECT_EQ(nullptr, Parameters.UnusedView);
}

TEST_F(FClearUnused, OfTwoShadersEitherMayRead)
{
	ClearUnusedGraphResources(Shader(false), Shader(true), &Parameters);
	EXPECT_TRUE(Parameters.Scene.IsValid());
	EXPECT_EQ(nullptr, Parameters.UnusedTexture);
}

TEST_F(FClearUnused, WhatAVertexShaderReadsStays)
{
	const TShaderMapRef<FTestVS> VertexShader(GetGlobalShaderMap(GMaxRHIFeatureLevel));
	ClearUnusedGraphResources(VertexShader, Shader(false), &Parameters);
	EXPECT_EQ(Fake<FRDGTexture>(0x2000), Parameters.UnusedTexture);
	EXPECT_EQ(Fake<FRDGTexture>(0x1000), Parameters.InputTexture);
	EXPECT_EQ(nullptr, Parameters.UnusedView);
}
