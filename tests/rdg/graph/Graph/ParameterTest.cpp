// What a pass's parameter struct tells the graph: which resources, how, which subresources.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "GraphTestBuilder.h"
#include "RHIStaticStates.h"

using namespace Drydock;

namespace
{

BEGIN_GLOBAL_SHADER_PARAMETER_STRUCT(FGraphTestUniforms, )
	SHADER_PARAMETER(float, Scale)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, SceneColor)
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, SceneDepth)
END_GLOBAL_SHADER_PARAMETER_STRUCT()

IMPLEMENT_GLOBAL_SHADER_PARAMETER_STRUCT(FGraphTestUniforms, "GraphTestUniforms");

BEGIN_SHADER_PARAMETER_STRUCT(FNestedParameters, )
	SHADER_PARAMETER_RDG_TEXTURE(Texture2D, Texture)
	SHADER_PARAMETER_SAMPLER(SamplerState, Sampler)
END_SHADER_PARAMETER_STRUCT()

BEGIN_SHADER_PARAMETER_STRUCT(FManyParameters, )
	SHADER_PARAMETER(FVector2f, Size)
	SHADER_PARAMETER_STRUCT(FNestedParameters, Input)
	SHADER_PARAMETER_STRUCT_INCLUDE(FNestedParameters, Included)
	SHADER_PARAMETER_STRUCT_ARRAY(FNestedParameters, Levels, [2])
	SHADER_PARAMETER_RDG_TEXTURE_SRV(Texture2D, View)
	SHADER_PARAMETER_RDG_TEXTURE_UAV(RWTexture2D<float>, Output)
	SHADER_PARAMETER_RDG_BUFFER_SRV(StructuredBuffer<float>, BufferView)
	SHADER_PARAMETER_RDG_BUFFER_UAV(RWStructuredBuffer<float>, BufferOutput)
	SHADER_PARAMETER_RDG_UNIFORM_BUFFER(FGraphTestUniforms, Uniforms)
	SHADER_PARAMETER_UAV(RWTexture2D<float>, OutsideOutput)
	RDG_TEXTURE_ACCESS(CopySource, ERHIAccess::CopySrc)
END_SHADER_PARAMETER_STRUCT()

/** A graph with one pass of FManyParameters. */
class FManyGraph : public FGraphTest
{
public:
	FManyGraph()
		: Parameters(Builder->AllocParameters<FManyParameters>())
	{
	}

	/** "Parameter:Access" of each use of the compiled pass. */
	std::string GetUses(ERDGPassFlags Flags = ERDGPassFlags::Compute)
	{
		Builder->AddPass(
			RDG_EVENT_NAME("Many"), Parameters, Flags | ERDGPassFlags::NeverCull, [](FRHIComputeCommandList&) {});
		Compiled = Builder->Compile();
		std::string Text;
		for (const FRDGUse& Use : Compiled.FindPass("Many")->Uses)
		{
			Text += (Text.empty() ? "" : " ") + Use.Parameter + ":" + *GetRHIAccessName(Use.Access);
		}
		return Text;
	}

	FManyParameters* Parameters;
	FRDGCompiledGraph Compiled;
};

} // namespace

TEST(Parameter, NullMembersAreSkipped)
{
	FManyGraph Graph;
	EXPECT_EQ("", Graph.GetUses());
}

TEST(Parameter, NestedIncludedAndArrayStructsAreWalked)
{
	FManyGraph Graph;
	Graph.Parameters->Input.Texture = Graph.External("A");
	Graph.Parameters->Included.Texture = Graph.External("B");
	Graph.Parameters->Levels[1].Texture = Graph.External("C");
	EXPECT_EQ("Input.Texture:SRVCompute Included.Texture:SRVCompute Levels[1].Texture:SRVCompute", Graph.GetUses());
}

TEST(Parameter, AUAVIsAWriteOfItsMip)
{
	FManyGraph Graph;
	Graph.Parameters->Output = Graph.Builder->CreateUAV(FRDGTextureUAVDesc(Graph.Texture("X", 3), 1));
	EXPECT_EQ("Output:UAVCompute", Graph.GetUses());
	EXPECT_EQ(1, Graph.Compiled.Passes[1].Uses[0].FirstMip);
	EXPECT_EQ(1, Graph.Compiled.Passes[1].Uses[0].NumMips);
}

TEST(Parameter, AnSRVIsAReadOfItsMips)
{
	FManyGraph Graph;
	FRDGTextureRef X = Graph.Texture("X", 3);
	FRDGTextureSRVDesc Desc(X);
	Desc.MipLevel = 1;
	Desc.NumMipLevels = 2;
	Graph.Parameters->View = Graph.Builder->CreateSRV(Desc);
	testing::internal::CaptureStderr();
	Graph.GetUses();
	testing::internal::GetCapturedStderr(); // X was never written
	EXPECT_EQ(1, Graph.Compiled.Passes[1].Uses[0].FirstMip);
	EXPECT_EQ(2, Graph.Compiled.Passes[1].Uses[0].NumMips);
}

TEST(Parameter, ATextureIsAReadOfAllItsMips)
{
	FManyGraph Graph;
	Graph.Pass("A").Writes("X");
	Graph.Parameters->Input.Texture = Graph.Texture("X");
	Graph.GetUses();
	EXPECT_EQ(FRDGSubresources(), static_cast<const FRDGSubresources&>(Graph.Compiled.FindPass("Many")->Uses[0]));
}

TEST(Parameter, AStencilViewIsAReadOfPlaneOne)
{
	FManyGraph Graph;
	FRDGTextureRef Depth =
		Graph.Texture("D", FRDGTextureDesc::Create2D(FIntPoint(4, 4), PF_DepthStencil, FClearValueBinding::DepthFar,
							   TexCreate_DepthStencilTargetable | TexCreate_ShaderResource));
	Graph.Parameters->View = Graph.Builder->CreateSRV(FRDGTextureSRVDesc::CreateWithPixelFormat(Depth, PF_X24_G8));
	Graph.Parameters->Input.Texture = Depth;
	testing::internal::CaptureStderr();
	Graph.GetUses();
	testing::internal::GetCapturedStderr(); // D was never written
	EXPECT_EQ(0, Graph.Compiled.Passes[1].Uses[0].Plane);
	EXPECT_EQ(1, Graph.Compiled.Passes[1].Uses[0].NumPlanes);
	EXPECT_EQ(1, Graph.Compiled.Passes[1].Uses[1].Plane);
}

TEST(Parameter, BufferViewsAreUses)
{
	FManyGraph Graph;
	const uint32 Data[4] = {};
	FRDGBufferRef In = Graph.Builder->CreateBuffer(FRDGBufferDesc::CreateStructuredDesc(4, 4), TEXT("In"));
	FRDGBufferRef Out = Graph.Builder->CreateBuffer(FRDGBufferDesc::CreateStructuredDesc(4, 4), TEXT("Out"));
	Graph.Builder->QueueBufferUpload(In, Data, sizeof(Data));
	Graph.Parameters->BufferView = Graph.Builder->CreateSRV(In);
	Graph.Parameters->BufferOutput = Graph.Builder->CreateUAV(Out);
	EXPECT_EQ("BufferView:SRVCompute BufferOutput:UAVCompute", Graph.GetUses());
}

TEST(Parameter, TheTexturesOfAUniformBufferAreReads)
{
	FManyGraph Graph;
	auto* Uniforms = Graph.Builder->AllocParameters<FGraphTestUniforms>();
	Uniforms->SceneColor = Graph.External("Color");
	Graph.Parameters->Uniforms = Graph.Builder->CreateUniformBuffer(Uniforms);
	EXPECT_EQ("Uniforms->SceneColor:SRVCompute", Graph.GetUses());
}

TEST(Parameter, WhatThePassWritesIsNotAReadThroughItsUniformBuffer)
{
	FManyGraph Graph;
	auto* Uniforms = Graph.Builder->AllocParameters<FGraphTestUniforms>();
	Uniforms->SceneColor = Graph.External("Color");
	Uniforms->SceneDepth = Graph.External("Depth");
	Graph.Parameters->Uniforms = Graph.Builder->CreateUniformBuffer(Uniforms);
	Graph.Parameters->Output = Graph.Builder->CreateUAV(Uniforms->SceneColor);
	EXPECT_EQ("Output:UAVCompute Uniforms->SceneDepth:SRVCompute", Graph.GetUses());
}

TEST(Parameter, AUniformBufferShowsItsStruct)
{
	FManyGraph Graph;
	auto* Uniforms = Graph.Builder->AllocParameters<FGraphTestUniforms>();
	Uniforms->Scale = 3;
	TRDGUniformBufferRef<FGraphTestUniforms> Buffer = Graph.Builder->CreateUniformBuffer(Uniforms);
	EXPECT_EQ(3.0f, (*Buffer)->Scale);
	EXPECT_EQ(3.0f, Buffer->GetParameters()->Scale);
	EXPECT_EQ(3.0f, Buffer->GetContents()->Scale);
}

TEST(Parameter, ConvertingAUniformBufferConvertsItsTextures)
{
	FManyGraph Graph;
	auto* Uniforms = Graph.Builder->AllocParameters<FGraphTestUniforms>();
	Uniforms->SceneColor = Graph.Texture("Color");
	EXPECT_NE(nullptr, Graph.Builder->ConvertToExternalUniformBuffer(Graph.Builder->CreateUniformBuffer(Uniforms)));
	EXPECT_TRUE(Graph.Texture("Color")->IsExternal());
}

TEST(Parameter, AnAccessIsWhatTheMacroSays)
{
	FManyGraph Graph;
	Graph.Parameters->CopySource = Graph.External("A");
	EXPECT_EQ("CopySource:CopySrc", Graph.GetUses(ERDGPassFlags::Copy));
}

TEST(Parameter, ReadsFollowThePassFlags)
{
	FManyGraph Graph;
	Graph.Parameters->Input.Texture = Graph.External("A");
	EXPECT_EQ("Input.Texture:SRVCompute|CopySrc", Graph.GetUses(ERDGPassFlags::Compute | ERDGPassFlags::Copy));
}

TEST(Parameter, RenderTargetsAreWritesOfTheirMipAndSlice)
{
	FGraphTest Graph;
	FRDGTextureRef Array =
		Graph.Texture("X", FRDGTextureDesc::Create2DArray(FIntPoint(4, 4), PF_R32_FLOAT, FClearValueBinding::Black,
							   TexCreate_RenderTargetable | TexCreate_ShaderResource, 3, 2));
	auto* Parameters = Graph.Builder->AllocParameters<FGraphTestRasterParameters>();
	Parameters->RenderTargets[0] = FRenderTargetBinding(Array, ERenderTargetLoadAction::EClear, 1, 2);
	Graph.Builder->AddPass(RDG_EVENT_NAME("A"), Parameters, ERDGPassFlags::Raster, [](FRHICommandList&) {});
	const FRDGUse Use = Graph.Builder->Compile().FindPass("A")->Uses.at(0);
	EXPECT_EQ("RenderTargets[0]", Use.Parameter);
	EXPECT_EQ(1, Use.FirstMip);
	EXPECT_EQ(2, Use.Slice);
	EXPECT_EQ(1, Use.NumSlices);
	EXPECT_EQ(ERHIAccess::RTV, Use.Access);
}

TEST(Parameter, DepthAndStencilTargetsAreUsesByPlane)
{
	FGraphTest Graph;
	Graph.Texture("D", FRDGTextureDesc::Create2D(FIntPoint(4, 4), PF_DepthStencil, FClearValueBinding::DepthFar,
						   TexCreate_DepthStencilTargetable | TexCreate_ShaderResource));
	Graph.Pass("A")
		.RendersDepth("D", FExclusiveDepthStencil::DepthWrite_StencilRead)
		.AddFlags(ERDGPassFlags::NeverCull);
	testing::internal::CaptureStderr();
	const std::vector<FRDGUse> Uses = Graph.Builder->Compile().FindPass("A")->Uses;
	testing::internal::GetCapturedStderr(); // the stencil was never written
	ASSERT_EQ(2u, Uses.size());
	EXPECT_EQ(ERHIAccess::DSVWrite, Uses[0].Access);
	EXPECT_EQ(0, Uses[0].Plane);
	EXPECT_EQ(ERHIAccess::DSVRead, Uses[1].Access);
	EXPECT_EQ(1, Uses[1].Plane);
}

TEST(Parameter, AViewOutsideTheGraphIsAnOutput)
{
	FManyGraph Graph;
	const TRefCountPtr<FRHITexture> Outside(new FRHITexture(FGraphTest::MakeDesc(), TEXT("Outside")));
	const TRefCountPtr<FRHIUnorderedAccessView> View(new FRHIUnorderedAccessView(Outside, FRHITextureUAVCreateInfo()));
	Graph.Parameters->OutsideOutput = View;
	bool bRan = false;
	Graph.Builder->AddPass(RDG_EVENT_NAME("A"), Graph.Parameters, ERDGPassFlags::Compute,
		[&bRan](FRHIComputeCommandList&) { bRan = true; });
	Graph.Run();
	EXPECT_TRUE(bRan);
}

TEST(Parameter, AStructMayServeSeveralPasses)
{
	FGraphTest Graph;
	auto* Parameters = Graph.Builder->AllocParameters<FGraphTestParameters>();
	Parameters->UAVs[0] = Graph.Builder->CreateUAV(Graph.Texture("X"));
	int32 NumRuns = 0;
	for (int32 Index = 0; Index < 2; ++Index)
	{
		Graph.Builder->AddPass(RDG_EVENT_NAME("A%d", Index), Parameters, ERDGPassFlags::Compute,
			[&](FRHIComputeCommandList&) { ++NumRuns; });
	}
	Graph.Extract("X");
	Graph.Run();
	EXPECT_EQ(2, NumRuns);
}
