// What the macros record, and the flat view that HLSL has of it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ShaderParameterStructs.h"

namespace
{

using testing::ElementsAre;
using testing::HasSubstr;

const FShaderParametersMetadata& Everything()
{
	return *FTestEverything::FTypeInfo::GetStructMetadata();
}

const FShaderParametersMetadata::FMember& Member(const TCHAR* Name)
{
	const FShaderParametersMetadata::FMember* Found = Everything().FindMemberByName(Name);
	if (!Found)
	{
		throw std::runtime_error(std::string("no member ") + Name);
	}
	return *Found;
}

const Drydock::FHlslMember& Flat(const std::string& Name, const FShaderParametersMetadata& Metadata = Everything())
{
	for (const Drydock::FHlslMember& Candidate : Metadata.GetHlslMembers())
	{
		if (Candidate.Name == Name)
		{
			return Candidate;
		}
	}
	throw std::runtime_error("no flat member " + Name);
}

std::vector<std::string> FlatNames(const FShaderParametersMetadata& Metadata)
{
	std::vector<std::string> Names;
	for (const Drydock::FHlslMember& Candidate : Metadata.GetHlslMembers())
	{
		Names.push_back(Candidate.Name);
	}
	return Names;
}

/** A shader's struct is nested and may sit in any class; its section leaves what follows public. */
class FOwner
{
public:
	BEGIN_SHADER_PARAMETER_STRUCT(FParameters, )
		SHADER_PARAMETER_RDG_TEXTURE(Texture2D, InputTexture)
		RENDER_TARGET_BINDING_SLOTS()
		SHADER_PARAMETER(float, Threshold)
	END_SHADER_PARAMETER_STRUCT()
};

BEGIN_SHADER_PARAMETER_STRUCT(FEmpty, )
END_SHADER_PARAMETER_STRUCT()

} // namespace

TEST(ShaderParameterMetadata, NamesFileAndLineOfTheStruct)
{
	EXPECT_STREQ("FTestEverything", Everything().GetStructTypeName());
	EXPECT_THAT(Everything().GetFileName(), testing::EndsWith("ShaderParameterStructs.h"));
	EXPECT_EQ(nullptr, Everything().GetShaderVariableName());
	EXPECT_EQ(FShaderParametersMetadata::EUseCase::ShaderParameterStruct, Everything().GetUseCase());
}

TEST(ShaderParameterMetadata, MembersComeInTheOrderOfDeclaration)
{
	const TArray<FShaderParametersMetadata::FMember>& Members =
		FOwner::FParameters::FTypeInfo::GetStructMetadata()->GetMembers();
	ASSERT_EQ(3, Members.Num());
	EXPECT_STREQ("InputTexture", Members[0].GetName());
	EXPECT_STREQ("RenderTargets", Members[1].GetName());
	EXPECT_STREQ("Threshold", Members[2].GetName());
}

TEST(ShaderParameterMetadata, LinesIncreaseFromMemberToMember)
{
	EXPECT_EQ(Member(TEXT("Scalar")).GetFileLine() + 1, Member(TEXT("Precise")).GetFileLine());
	EXPECT_LT(Everything().GetFileLine(), Member(TEXT("Scalar")).GetFileLine());
}

TEST(ShaderParameterMetadata, EmptyStructHasNoMembers)
{
	EXPECT_EQ(0, FEmpty::FTypeInfo::GetStructMetadata()->GetMembers().Num());
}

TEST(ShaderParameterMetadata, AsksTheSameObjectEveryTime)
{
	EXPECT_EQ(FTestLayout::FTypeInfo::GetStructMetadata(), FTestLayout::FTypeInfo::GetStructMetadata());
}

TEST(ShaderParameterMetadata, BaseTypesAreTheEngines)
{
	const std::pair<const TCHAR*, EUniformBufferBaseType> Expected[] = {{TEXT("Scalar"), UBMT_FLOAT32},
		{TEXT("Scalars"), UBMT_INT32}, {TEXT("Texture"), UBMT_TEXTURE}, {TEXT("View"), UBMT_SRV},
		{TEXT("WriteView"), UBMT_UAV}, {TEXT("Sampler"), UBMT_SAMPLER}, {TEXT("GraphTexture"), UBMT_RDG_TEXTURE},
		{TEXT("GraphTextureView"), UBMT_RDG_TEXTURE_SRV}, {TEXT("GraphTarget"), UBMT_RDG_TEXTURE_UAV},
		{TEXT("GraphBuffer"), UBMT_RDG_BUFFER_SRV}, {TEXT("GraphBufferTarget"), UBMT_RDG_BUFFER_UAV},
		{TEXT("Input"), UBMT_NESTED_STRUCT}, {TEXT("Levels"), UBMT_NESTED_STRUCT},
		{TEXT("Included"), UBMT_INCLUDED_STRUCT}, {TEXT("View0"), UBMT_REFERENCED_STRUCT},
		{TEXT("Scene"), UBMT_RDG_UNIFORM_BUFFER}, {TEXT("CopySource"), UBMT_RDG_TEXTURE_ACCESS},
		{TEXT("AnyTexture"), UBMT_RDG_TEXTURE_ACCESS}, {TEXT("ManyTextures"), UBMT_RDG_TEXTURE_ACCESS_ARRAY},
		{TEXT("IndirectArgs"), UBMT_RDG_BUFFER_ACCESS}, {TEXT("ManyBuffers"), UBMT_RDG_BUFFER_ACCESS_ARRAY},
		{TEXT("RenderTargets"), UBMT_RENDER_TARGET_BINDING_SLOTS}};
	for (const auto& [Name, BaseType] : Expected)
	{
		EXPECT_STREQ(Drydock::GetBaseTypeName(BaseType), Drydock::GetBaseTypeName(Member(Name).GetBaseType())) << Name;
	}
}

TEST(ShaderParameterMetadata, BaseTypeNumbersKeepTheEnginesOrder)
{
	EXPECT_EQ(0, UBMT_INVALID);
	EXPECT_EQ(4, UBMT_FLOAT32);
	EXPECT_EQ(9, UBMT_RDG_TEXTURE);
	EXPECT_EQ(18, UBMT_RDG_UNIFORM_BUFFER);
	EXPECT_EQ(22, UBMT_RENDER_TARGET_BINDING_SLOTS);
}

TEST(ShaderParameterMetadata, ShapesOfNumbers)
{
	EXPECT_EQ(1u, Member(TEXT("Precise")).GetNumRows());
	EXPECT_EQ(3u, Member(TEXT("Precise")).GetNumColumns());
	EXPECT_EQ(0u, Member(TEXT("Precise")).GetNumElements());
	EXPECT_EQ(EShaderPrecisionModifier::Half, Member(TEXT("Precise")).GetPrecision());
	EXPECT_EQ(4u, Member(TEXT("Vectors")).GetNumElements());
	EXPECT_EQ(2u, Member(TEXT("Scalars")).GetNumElements());
	EXPECT_EQ(4u, Flat("ScreenToWorld", *FTestViewUniforms::FTypeInfo::GetStructMetadata()).NumRows);
}

TEST(ShaderParameterMetadata, ResourcesKeepTheTypeTextOfTheMacro)
{
	EXPECT_STREQ("Texture2D<float4>", Member(TEXT("GraphTexture")).GetShaderType());
	EXPECT_STREQ("RWStructuredBuffer<float4>", Member(TEXT("GraphBufferTarget")).GetShaderType());
}

TEST(ShaderParameterMetadata, GeneratesHlslTypes)
{
	FString Type;
	Member(TEXT("Vectors")).GenerateShaderParameterType(Type);
	EXPECT_STREQ("float4[4]", *Type);
	Member(TEXT("Scalar")).GenerateShaderParameterType(Type);
	EXPECT_STREQ("float", *Type);
}

TEST(ShaderParameterMetadata, NestedStructsCarryTheirOwnMetadata)
{
	EXPECT_EQ(FTestInput::FTypeInfo::GetStructMetadata(), Member(TEXT("Input")).GetStructMetadata());
	EXPECT_EQ(FTestViewUniforms::FTypeInfo::GetStructMetadata(), Member(TEXT("View0")).GetStructMetadata());
	EXPECT_EQ(nullptr, Member(TEXT("Scalar")).GetStructMetadata());
}

TEST(ShaderParameterMetadata, UnknownMemberIsNull)
{
	EXPECT_EQ(nullptr, Everything().FindMemberByName(TEXT("scalar")));
}

TEST(HlslMembers, NestedStructsPrefixTheirMembers)
{
	EXPECT_THAT(FlatNames(*FTestInput::FTypeInfo::GetStructMetadata()),
		ElementsAre("Viewport_Extent", "Viewport_ExtentInverse", "Viewport_ViewportMin", "Texture", "Sampler"));
}

TEST(HlslMembers, NestingTwiceGivesTwoPrefixes)
{
	EXPECT_EQ("Input.Viewport.Extent", Flat("Input_Viewport_Extent").CodeName);
	EXPECT_EQ(offsetof(FTestEverything, Input) + offsetof(FTestInput, Texture), Flat("Input_Texture").Offset);
}

TEST(HlslMembers, IncludedStructsHaveNoPrefix)
{
	EXPECT_EQ("Included.ExtentInverse", Flat("ExtentInverse").CodeName);
	EXPECT_EQ(offsetof(FTestEverything, Included) + 8, Flat("ExtentInverse").Offset);
}

TEST(HlslMembers, StructArraysAreNumbered)
{
	EXPECT_EQ("Levels[1].ViewportMin", Flat("Levels_1_ViewportMin").CodeName);
	EXPECT_EQ(offsetof(FTestEverything, Levels) + sizeof(FTestViewport) + 16, Flat("Levels_1_ViewportMin").Offset);
}

TEST(HlslMembers, ResourceArraysAreNumbered)
{
	EXPECT_EQ("GraphTextures[2]", Flat("GraphTextures_2").CodeName);
	EXPECT_EQ(offsetof(FTestEverything, GraphTextures) + 16, Flat("GraphTextures_2").Offset);
	EXPECT_EQ(0u, Flat("GraphTextures_2").NumElements);
}

TEST(HlslMembers, NumericArraysStayArrays)
{
	EXPECT_EQ(4u, Flat("Vectors").NumElements);
	EXPECT_EQ("float4", Flat("Vectors").Type);
	EXPECT_EQ("int4", Flat("Scalars").Type);
}

TEST(HlslMembers, UniformBuffersStayOneEntryWithTheirStruct)
{
	EXPECT_TRUE(Flat("View0").IsUniformBuffer());
	EXPECT_STREQ("TestView", Flat("View0").Struct->GetShaderVariableName());
	EXPECT_STREQ("TestSceneStruct", Flat("Scene").Struct->GetShaderVariableName());
}

TEST(HlslMembers, CodeNamesAreFoundByOffset)
{
	EXPECT_STREQ("Input.Texture",
		*Everything().GetFullMemberCodeName(offsetof(FTestEverything, Input) + offsetof(FTestInput, Texture)));
	EXPECT_STREQ("", *Everything().GetFullMemberCodeName(1));
}

TEST(UniformBufferStruct, IsFoundByItsHlslName)
{
	EXPECT_EQ(FTestViewUniforms::FTypeInfo::GetStructMetadata(), Drydock::FindUniformBufferStruct("TestView"));
	EXPECT_EQ(nullptr, Drydock::FindUniformBufferStruct("Tstview"));
}

TEST(UniformBufferStruct, KnowsItsStaticSlot)
{
	EXPECT_STREQ("TestScene", FTestSceneUniforms::FTypeInfo::GetStructMetadata()->GetStaticSlotName());
	EXPECT_FALSE(FTestViewUniforms::FTypeInfo::GetStructMetadata()->HasStaticSlot());
}

TEST(RenderTargetBindingSlots, CountUpToTheFirstGap)
{
	FOwner::FParameters Parameters;
	FRDGTexture* const Texture = reinterpret_cast<FRDGTexture*>(0x1000); // never touched
	EXPECT_EQ(0u, Parameters.RenderTargets.GetActiveCount());
	Parameters.RenderTargets[0] = FRenderTargetBinding(Texture, ERenderTargetLoadAction::EClear, 2);
	Parameters.RenderTargets[2] = FRenderTargetBinding(Texture, ERenderTargetLoadAction::ELoad);
	EXPECT_EQ(1u, Parameters.RenderTargets.GetActiveCount());
	EXPECT_EQ(Texture, Parameters.RenderTargets[0].GetTexture());
	EXPECT_EQ(ERenderTargetLoadAction::EClear, Parameters.RenderTargets[0].GetLoadAction());
	EXPECT_EQ(2, Parameters.RenderTargets[0].GetMipIndex());
	EXPECT_EQ(-1, Parameters.RenderTargets[0].GetArraySlice());
}

TEST(RenderTargetBindingSlots, NinthSlotIsACheck)
{
	FOwner::FParameters Parameters;
	EXPECT_THROW(Parameters.RenderTargets[8], Drydock::FCheckFailure);
}

TEST(ResourceAccess, CarriesTextureAndAccess)
{
	FTestEverything Parameters;
	FRDGTexture* const Texture = reinterpret_cast<FRDGTexture*>(0x1000); // never touched
	Parameters.CopySource = Texture;
	EXPECT_EQ(Texture, Parameters.CopySource.GetTexture());
	EXPECT_EQ(ERHIAccess::CopySrc, Parameters.CopySource.GetAccess());
	Parameters.AnyTexture = FRDGTextureAccess(Texture, ERHIAccess::CopyDest);
	EXPECT_EQ(ERHIAccess::CopyDest, Parameters.AnyTexture.GetAccess());
	EXPECT_EQ(ERHIAccess::IndirectArgs, Parameters.IndirectArgs.GetAccess());
}

TEST(ResourceAccess, ArraysGrow)
{
	FTestEverything Parameters;
	Parameters.ManyTextures.Add(FRDGTextureAccess(nullptr, ERHIAccess::SRVCompute));
	EXPECT_EQ(1, Parameters.ManyTextures.Num());
	EXPECT_EQ(ERHIAccess::SRVCompute, Parameters.ManyTextures[0].GetAccess());
}
