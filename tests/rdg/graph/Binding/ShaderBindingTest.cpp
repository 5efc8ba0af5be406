// Matching a shader's reflection with a parameter struct, and packing by the plan that comes out. The reflections are
// written by hand: no shader is compiled here. A little past 500 lines: the cases share one parameter struct.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "RHIResources.h"
#include "RHIStaticStates.h"
#include "ShaderBinding.h"
#include "ShaderBindingPlan.h"
#include "UniformBufferStructs.h"
#include "rdg/graph/Shader/ShaderParameterStructs.h"

#include <fstream>

namespace
{

using namespace Drydock;
using testing::AllOf;
using testing::HasSubstr;

BEGIN_SHADER_PARAMETER_STRUCT(FBloomParameters, )
	SHADER_PARAMETER(float, ToonIntensty)
	SHADER_PARAMETER(FVector3f, Tint)
	SHADER_PARAMETER(float, Threshold)
	SHADER_PARAMETER(uint32, bEnabled)
	SHADER_PARAMETER(FIntRect, Rect)
	SHADER_PARAMETER(FMatrix44f, Transform)
	SHADER_PARAMETER_ARRAY(FVector4f, Weights, [4])
	SHADER_PARAMETER_SCALAR_ARRAY(float, Offsets, [7])
	SHADER_PARAMETER_STRUCT(FTestInput, Input)
	SHADER_PARAMETER_STRUCT_REF(FTestViewUniforms, View)
	SHADER_PARAMETER_UAV(RWTexture2D<float4>, Output)
	SHADER_PARAMETER_SRV(StructuredBuffer<float4>, Table)
	SHADER_PARAMETER_UAV(RWStructuredBuffer<uint>, Counts)
END_SHADER_PARAMETER_STRUCT()

const FShaderParametersMetadata& Metadata()
{
	return *FBloomParameters::FTypeInfo::GetStructMetadata();
}

FShaderConstant Constant(
	const std::string& Name, EShaderScalar Scalar, int32_t Columns, uint32_t Offset, int32_t NumElements = 0)
{
	FShaderConstant Result;
	Result.Name = Name;
	Result.Scalar = Scalar;
	Result.Columns = Columns;
	Result.NumElements = NumElements;
	Result.Offset = Offset;
	Result.ArrayStride = NumElements ? 16 : 0;
	Result.bUsed = true;
	Result.Where = "/Engine/Private/PostProcessBloom.usf:9";
	return Result;
}

FShaderReflection Loose(std::vector<FShaderConstant> Constants, uint32_t Size = 256)
{
	FShaderReflection Reflection;
	Reflection.ConstantBuffers = {{"$Global", Size}};
	Reflection.Constants = std::move(Constants);
	return Reflection;
}

FShaderResource Resource(const std::string& Name, EShaderDimension Dimension = EShaderDimension::Texture2D)
{
	FShaderResource Result;
	Result.Name = Name;
	Result.Dimension = Dimension;
	Result.Where = "/Project/X.usf:4";
	return Result;
}

FShaderReflection Texture(const std::string& Name, EShaderDimension Dimension = EShaderDimension::Texture2D)
{
	FShaderReflection Reflection;
	Reflection.Textures = {Resource(Name, Dimension)};
	return Reflection;
}

std::string MessageOf(const FShaderReflection& Reflection)
{
	const std::vector<FDiagnostic> Diagnostics = MatchShaderParameters("FBloomSetupPS", Reflection, Metadata());
	return Diagnostics.size() == 1 ? Diagnostics[0].Message : std::to_string(Diagnostics.size()) + " messages";
}

FBoundShader Bind(const FShaderReflection& Reflection, const FBloomParameters& Parameters)
{
	std::vector<FDiagnostic> Diagnostics;
	const FShaderBindingPlan Plan = MakeShaderBindingPlan("FBloomSetupPS", Reflection, Metadata(), Diagnostics);
	EXPECT_TRUE(Diagnostics.empty());
	FBoundShader Bound;
	FollowShaderBindingPlan(Plan, Reflection, &Parameters, Bound);
	return Bound;
}

float FloatAt(const FBoundShader& Bound, uint32_t Offset, size_t Buffer = 0)
{
	return *reinterpret_cast<const float*>(Bound.ConstantBuffers[Buffer] + Offset);
}

int32 IntAt(const FBoundShader& Bound, uint32_t Offset)
{
	return *reinterpret_cast<const int32*>(Bound.ConstantBuffers[0] + Offset);
}

TRefCountPtr<FRHITexture> MakeTexture(FIntPoint Extent, EPixelFormat Format = PF_A32B32G32R32F)
{
	return new FRHITexture(
		FRHITextureDesc::Create2D(Extent, Format, FClearValueBinding::None, TexCreate_ShaderResource | TexCreate_UAV),
		TEXT("Test"));
}

} // namespace

TEST(ShaderMatching, AFittingShaderHasNoMessage)
{
	EXPECT_EQ("0 messages", MessageOf(Loose({Constant("Tint", EShaderScalar::Float, 3, 0),
								Constant("Threshold", EShaderScalar::Float, 1, 12)})));
}

TEST(ShaderMatching, MissingMemberNamesBothSidesAndTheNearestName)
{
	EXPECT_EQ("FBloomSetupPS: 'ToonIntensity' (float) is read by /Engine/Private/PostProcessBloom.usf:9 but "
			  "FBloomParameters has no such member; "
			  "did you mean 'ToonIntensty'?",
		MessageOf(Loose({Constant("ToonIntensity", EShaderScalar::Float, 1, 0)})));
}

TEST(ShaderMatching, FarNamesAreNotSuggested)
{
	EXPECT_EQ("FBloomSetupPS: 'Zq' (float2) is read by /Engine/Private/PostProcessBloom.usf:9 but FBloomParameters has "
			  "no such member",
		MessageOf(Loose({Constant("Zq", EShaderScalar::Float, 2, 0)})));
}

TEST(ShaderMatching, OtherShapeNamesBothTypesAndTheLineInCpp)
{
	const std::string Message = MessageOf(Loose({Constant("Tint", EShaderScalar::Float, 4, 0)}));
	EXPECT_THAT(Message, HasSubstr("'Tint' is float4 where it is read by /Engine/Private/PostProcessBloom.usf:9, but "
								   "float3 in FBloomParameters"));
	EXPECT_THAT(Message,
		HasSubstr("ShaderBindingTest.cpp:" + std::to_string(Metadata().FindMemberByName(TEXT("Tint"))->GetFileLine())));
}

TEST(ShaderMatching, FloatAndIntegerDoNotMatch)
{
	EXPECT_THAT(
		MessageOf(Loose({Constant("Threshold", EShaderScalar::Int, 1, 0)})), HasSubstr("'Threshold' is int where"));
	EXPECT_THAT(MessageOf(Loose({Constant("Rect", EShaderScalar::Float, 4, 0)})), HasSubstr("but int4 in"));
}

TEST(ShaderMatching, SignednessOfIntegersIsFree)
{
	EXPECT_EQ("0 messages", MessageOf(Loose({Constant("Rect", EShaderScalar::Uint, 4, 0),
								Constant("bEnabled", EShaderScalar::Int, 1, 16)})));
}

TEST(ShaderMatching, HlslMayReadAnUnsignedIntegerAsBool)
{
	EXPECT_EQ("0 messages", MessageOf(Loose({Constant("bEnabled", EShaderScalar::Bool, 1, 0)})));
}

TEST(ShaderMatching, ShorterArraysInHlslFit)
{
	EXPECT_EQ("0 messages", MessageOf(Loose({Constant("Weights", EShaderScalar::Float, 4, 0, 3)})));
}

TEST(ShaderMatching, LongerArraysInHlslDoNot)
{
	EXPECT_THAT(MessageOf(Loose({Constant("Weights", EShaderScalar::Float, 4, 0, 5)})),
		HasSubstr("'Weights' has 5 elements where it is read by /Engine/Private/PostProcessBloom.usf:9, but only 4 in "
				  "FBloomParameters"));
}

TEST(ShaderMatching, AnArrayIsNotAVector)
{
	EXPECT_THAT(MessageOf(Loose({Constant("Weights", EShaderScalar::Float, 4, 0)})), HasSubstr("is float4 where"));
}

TEST(ShaderMatching, UnreadConstantsAreNotAskedFor)
{
	FShaderConstant Unread = Constant("Nowhere", EShaderScalar::Float, 1, 0);
	Unread.bUsed = false;
	EXPECT_EQ("0 messages", MessageOf(Loose({Unread})));
}

TEST(ShaderMatching, MissingTextureNamesItsType)
{
	EXPECT_EQ("FBloomSetupPS: 'Input_Textur' (Texture2D) is read by /Project/X.usf:4 but FBloomParameters has no such "
			  "member; "
			  "did you mean 'Input_Texture'?",
		MessageOf(Texture("Input_Textur")));
}

TEST(ShaderMatching, TextureDimensionsMustAgree)
{
	EXPECT_THAT(MessageOf(Texture("Input_Texture", EShaderDimension::Texture3D)),
		HasSubstr("'Input_Texture' is Texture3D where"));
}

TEST(ShaderMatching, AWritableViewIsNoTexture)
{
	EXPECT_THAT(MessageOf(Texture("Output")), HasSubstr("but RWTexture2D<float4> (UBMT_UAV) in FBloomParameters"));
}

TEST(ShaderMatching, TemplateArgumentsOfTheTypeTextAreFree)
{
	FShaderReflection Reflection;
	Reflection.RWTextures = {Resource("Output")};
	EXPECT_EQ("0 messages", MessageOf(Reflection));
}

TEST(ShaderMatching, AllMistakesAreReported)
{
	FShaderReflection Reflection =
		Loose({Constant("A1", EShaderScalar::Float, 1, 0), Constant("Tint", EShaderScalar::Int, 3, 16)});
	Reflection.Textures = {Resource("Input_Texture"), Resource("B1")};
	EXPECT_EQ("3 messages", MessageOf(Reflection));
}

TEST(ShaderMatching, UniformBufferMembersAreFoundUnderTheHlslName)
{
	FShaderReflection Reflection = Loose({Constant("TestView_PreExposure", EShaderScalar::Float, 1, 0)});
	Reflection.ConstantBuffers[0].Name = "TestView";
	EXPECT_EQ("0 messages", MessageOf(Reflection));
}

TEST(ShaderMatching, AnUnreferencedUniformBufferIsNamed)
{
	FShaderReflection Reflection = Loose({Constant("Other_Value", EShaderScalar::Float, 1, 0)});
	Reflection.ConstantBuffers[0].Name = "Other";
	EXPECT_EQ("FBloomSetupPS: 'Other_Value' of uniform buffer 'Other' is read by "
			  "/Engine/Private/PostProcessBloom.usf:9, but FBloomParameters has no "
			  "SHADER_PARAMETER_STRUCT_REF or SHADER_PARAMETER_RDG_UNIFORM_BUFFER of that buffer; it has those of "
			  "TestView",
		MessageOf(Reflection));
}

TEST(ShaderMatching, TheFramesOwnBufferIsReadWithAWarning)
{
	const FShaderParametersMetadata& Struct = *FTestInput::FTypeInfo::GetStructMetadata();
	FShaderReflection Reflection = Loose({Constant("TestView_PreExposure", EShaderScalar::Float, 1, 16)}, 32);
	Reflection.ConstantBuffers[0].Name = "TestView";
	std::vector<FDiagnostic> Diagnostics = MatchShaderParameters("FBloomSetupPS", Reflection, Struct);
	ASSERT_EQ(1u, Diagnostics.size());
	EXPECT_EQ(ESeverity::Error, Diagnostics[0].Severity);

	FTestViewUniforms View = {};
	View.PreExposure = 0.375f;
	const FFrameUniformBufferScope Scope(FTestViewUniforms::FTypeInfo::GetStructMetadata(), &View);
	Diagnostics = MatchShaderParameters("FBloomSetupPS", Reflection, Struct);
	ASSERT_EQ(1u, Diagnostics.size());
	EXPECT_EQ(MissingUniformBuffer, Diagnostics[0].Code);
	EXPECT_EQ(ESeverity::Warning, Diagnostics[0].Severity);
	EXPECT_THAT(Diagnostics[0].Message, HasSubstr("'TestView_PreExposure' of uniform buffer 'TestView' is read by"));
	EXPECT_THAT(Diagnostics[0].Message, HasSubstr("; the shader reads the frame's own."));

	const FTestInput Input = {};
	std::vector<FDiagnostic> Ignored;
	const FShaderBindingPlan Plan = MakeShaderBindingPlan("FBloomSetupPS", Reflection, Struct, Ignored);
	FBoundShader Bound;
	FollowShaderBindingPlan(Plan, Reflection, &Input, Bound);
	EXPECT_EQ(0.375f, FloatAt(Bound, 16));

	// A struct that refers to the buffer has its own.
	EXPECT_EQ("0 messages", MessageOf(Reflection));
}

TEST(ShaderMatching, AStructThatIsMissingIsOneMessage)
{
	FShaderReflection Reflection = Loose({Constant("Inptu_Extent", EShaderScalar::Float, 2, 0),
		Constant("Inptu_UVViewportMin", EShaderScalar::Float, 2, 8),
		Constant("Lonely_One", EShaderScalar::Float, 1, 16)});
	Reflection.Textures = {Resource("Inptu_Texture")};
	const std::vector<FDiagnostic> Diagnostics = MatchShaderParameters("FBloomSetupPS", Reflection, Metadata());
	ASSERT_EQ(2u, Diagnostics.size());
	EXPECT_EQ(
		"FBloomSetupPS: 'Inptu_Extent' (float2) is read by /Engine/Private/PostProcessBloom.usf:9, and 2 others "
		"'Inptu_...', but FBloomParameters has none of them, and no SHADER_PARAMETER_STRUCT 'Inptu'; did you mean "
		"'Input'?",
		Diagnostics[0].Message);
	EXPECT_THAT(Diagnostics[1].Message, HasSubstr("'Lonely_One' (float) is read by"));
	Reflection = Loose(
		{Constant("Input_Nothing", EShaderScalar::Float, 2, 0), Constant("Input_None", EShaderScalar::Float, 2, 8)});
	EXPECT_EQ("2 messages", MessageOf(Reflection)) << "of a struct that is there";
}

TEST(ShaderMatching, WidthsMustAgree)
{
	EXPECT_THAT(MessageOf(Loose({Constant("Threshold", EShaderScalar::Double, 1, 0)})),
		AllOf(HasSubstr("'Threshold' is double where it is read by"), HasSubstr("but float in FBloomParameters"),
			HasSubstr("; parameters have 32 bits")));
	EXPECT_THAT(MessageOf(Loose({Constant("bEnabled", EShaderScalar::Ulong, 1, 0)})), HasSubstr("is uint64_t where"));
	EXPECT_THAT(MessageOf(Loose({Constant("Tint", EShaderScalar::Half, 3, 0)})), HasSubstr("is float16_t3 where"));
	FShaderReflection Reflection;
	Reflection.Buffers = {Resource("Table", EShaderDimension::StructuredBuffer)};
	EXPECT_EQ("0 messages", MessageOf(Reflection));
	Reflection.Buffers[0].Scalar = EShaderScalar::Half;
	EXPECT_THAT(
		MessageOf(Reflection), HasSubstr("'Table' has elements of float16_t, of 16 bits, where it is read by "
										 "/Project/X.usf:4, but is StructuredBuffer<float4> in FBloomParameters"));
	Reflection.Buffers.clear();
	Reflection.RWBuffers = {Resource("Counts", EShaderDimension::StructuredBuffer)};
	EXPECT_EQ("0 messages", MessageOf(Reflection));
	Reflection.RWBuffers[0].Scalar = EShaderScalar::Ulong;
	EXPECT_THAT(MessageOf(Reflection), HasSubstr("of uint64_t, of 64 bits"));
}

TEST(ShaderMatching, ThePageQuotesWhatIsPrinted)
{
	std::ifstream File(DRYDOCK_TEST_SOURCE_DIR "/docs/shaders.md");
	std::string Page;
	for (std::string Word; File >> Word;)
	{
		Page += (Page.empty() ? "" : " ") + Word;
	}
	EXPECT_THAT(Page, HasSubstr(MessageOf(Loose({Constant("ToonIntensity", EShaderScalar::Float, 1, 0)}))));
	FShaderReflection Reflection = Loose({Constant("Other_Value", EShaderScalar::Float, 1, 0)});
	Reflection.ConstantBuffers[0].Name = "Other";
	EXPECT_THAT(Page, HasSubstr(MessageOf(Reflection)));
	EXPECT_THAT(
		Page, HasSubstr(MessageOf(Loose({Constant("Inptu_Extent", EShaderScalar::Float, 2, 0),
				  Constant("Inptu_A", EShaderScalar::Float, 2, 8), Constant("Inptu_B", EShaderScalar::Float, 2, 8)}))));
}

TEST(ShaderBinding, ConstantsGoWhereTheShaderWantsThem)
{
	FBloomParameters Parameters;
	Parameters.Tint = FVector3f(0.25f, 0.5f, 0.75f);
	Parameters.Threshold = -1.0f;
	Parameters.Rect = FIntRect(1, 2, 30, 40);
	const FBoundShader Bound =
		Bind(Loose({Constant("Threshold", EShaderScalar::Float, 1, 4), Constant("Tint", EShaderScalar::Float, 3, 16),
					   Constant("Rect", EShaderScalar::Uint, 4, 32)},
				 48),
			Parameters);
	EXPECT_EQ(-1.0f, FloatAt(Bound, 4));
	EXPECT_EQ(0.25f, FloatAt(Bound, 16));
	EXPECT_EQ(0.75f, FloatAt(Bound, 24));
	EXPECT_EQ(1, IntAt(Bound, 32));
	EXPECT_EQ(40, IntAt(Bound, 44));
}

TEST(ShaderBinding, BytesNobodyFillsAreZero)
{
	FBloomParameters Parameters;
	Parameters.Threshold = 5.0f;
	const FBoundShader Bound = Bind(Loose({Constant("Threshold", EShaderScalar::Float, 1, 8)}, 16), Parameters);
	EXPECT_EQ(0, IntAt(Bound, 0));
	EXPECT_EQ(0, IntAt(Bound, 12));
}

TEST(ShaderBinding, ArraysCopyElementByElement)
{
	FBloomParameters Parameters;
	Parameters.Weights[2] = FVector4f(1.0f, 2.0f, 3.0f, 4.0f);
	const FBoundShader Bound = Bind(Loose({Constant("Weights", EShaderScalar::Float, 4, 64, 3)}, 112), Parameters);
	EXPECT_EQ(1.0f, FloatAt(Bound, 64 + 32));
	EXPECT_EQ(4.0f, FloatAt(Bound, 64 + 32 + 12));
}

TEST(ShaderBinding, ScalarArraysCopyByRegisters)
{
	FBloomParameters Parameters;
	GET_SCALAR_ARRAY_ELEMENT(Parameters.Offsets, 6) = 0.5f;
	const FBoundShader Bound = Bind(Loose({Constant("Offsets", EShaderScalar::Float, 4, 0, 2)}, 32), Parameters);
	EXPECT_EQ(0.5f, FloatAt(Bound, 6 * 4));
}

TEST(ShaderBinding, RowMajorMatricesCopyAsTheyLie)
{
	FBloomParameters Parameters;
	Parameters.Transform.M[1][2] = 7.0f;
	FShaderConstant Matrix = Constant("Transform", EShaderScalar::Float, 4, 0);
	Matrix.Rows = 4;
	Matrix.MatrixStride = 16;
	Matrix.bRowMajor = true;
	EXPECT_EQ(7.0f, FloatAt(Bind(Loose({Matrix}, 64), Parameters), 1 * 16 + 2 * 4));
}

TEST(ShaderBinding, ColumnMajorMatricesAreTransposed)
{
	FBloomParameters Parameters;
	Parameters.Transform.M[1][2] = 7.0f;
	FShaderConstant Matrix = Constant("Transform", EShaderScalar::Float, 4, 0);
	Matrix.Rows = 4;
	Matrix.MatrixStride = 16;
	EXPECT_EQ(7.0f, FloatAt(Bind(Loose({Matrix}, 64), Parameters), 2 * 16 + 1 * 4));
}

TEST(ShaderBinding, NestedMembersAreReached)
{
	FBloomParameters Parameters;
	Parameters.Input.Viewport.ExtentInverse = FVector2f(0.5f, 0.125f);
	const FBoundShader Bound =
		Bind(Loose({Constant("Input_Viewport_ExtentInverse", EShaderScalar::Float, 2, 0)}, 16), Parameters);
	EXPECT_EQ(0.125f, FloatAt(Bound, 4));
}

TEST(ShaderBinding, UniformBuffersAreReadWhenTheyWereMade)
{
	FTestViewUniforms View;
	View.PreExposure = 4.0f;
	FBloomParameters Parameters;
	Parameters.View =
		TUniformBufferRef<FTestViewUniforms>::CreateUniformBufferImmediate(View, UniformBuffer_SingleFrame);
	View.PreExposure = 9.0f;
	FShaderReflection Reflection = Loose({Constant("TestView_PreExposure", EShaderScalar::Float, 1, 0)}, 16);
	Reflection.ConstantBuffers[0].Name = "TestView";
	EXPECT_EQ(4.0f, FloatAt(Bind(Reflection, Parameters), 0));
}

TEST(ShaderBinding, ANullUniformBufferThatIsReadIsAMessage)
{
	FShaderReflection Reflection = Loose({Constant("TestView_PreExposure", EShaderScalar::Float, 1, 0)}, 16);
	Reflection.ConstantBuffers[0].Name = "TestView";
	EXPECT_THROW(Bind(Reflection, FBloomParameters()), FError);
}

TEST(ShaderBinding, TexturesGiveTheirViews)
{
	const TRefCountPtr<FRHITexture> Made = MakeTexture(FIntPoint(17, 9));
	FBloomParameters Parameters;
	Parameters.Input.Texture = Made;
	const FBoundShader Bound = Bind(Texture("Input_Texture"), Parameters);
	ASSERT_EQ(1u, Bound.Textures.size());
	EXPECT_EQ(17, Bound.Textures[0].Mips[0].SizeX);
	EXPECT_EQ(9, Bound.Textures[0].Mips[0].SizeY);
	EXPECT_EQ(ETexelStorage::RGBA32_FLOAT, Bound.Textures[0].Storage);
}

TEST(ShaderBinding, ANullTextureThatIsReadIsAMessageThatNamesIt)
{
	try
	{
		Bind(Texture("Input_Texture"), FBloomParameters());
		FAIL() << "no message";
	}
	catch (const FError& Error)
	{
		EXPECT_EQ(ExitUsage, Error.GetExitCode());
		EXPECT_THAT(Error.what(), HasSubstr("DD2015 at parameter Input.Texture"));
	}
}

TEST(ShaderBinding, SamplersGiveTheirState)
{
	FBloomParameters Parameters;
	Parameters.Input.Sampler = TStaticSamplerState<SF_Bilinear, AM_Clamp, AM_Mirror, AM_Border>::GetRHI();
	FShaderReflection Reflection;
	Reflection.Samplers = {Resource("Input_Sampler")};
	const FBoundShader Bound = Bind(Reflection, Parameters);
	EXPECT_EQ(EKernelFilter::Bilinear, Bound.Samplers[0].Filter);
	EXPECT_EQ(EKernelAddress::Clamp, Bound.Samplers[0].AddressU);
	EXPECT_EQ(EKernelAddress::Mirror, Bound.Samplers[0].AddressV);
}

TEST(ShaderBinding, SlotsFollowTheReflection)
{
	const TRefCountPtr<FRHITexture> Texture = MakeTexture(FIntPoint(4, 4));
	const TRefCountPtr<FRHITexture> Noise = MakeTexture(FIntPoint(64, 32));
	FTestViewUniforms View;
	View.Noise = Noise;
	FBloomParameters Parameters;
	Parameters.Input.Texture = Texture;
	Parameters.View =
		TUniformBufferRef<FTestViewUniforms>::CreateUniformBufferImmediate(View, UniformBuffer_SingleFrame);
	FShaderReflection Reflection;
	Reflection.Textures = {Resource("TestView_Noise"), Resource("Input_Texture")};
	const FBoundShader Bound = Bind(Reflection, Parameters);
	EXPECT_EQ(64, Bound.Textures[0].Mips[0].SizeX);
	EXPECT_EQ(4, Bound.Textures[1].Mips[0].SizeX);
}

TEST(ShaderBinding, WritableTexturesAndBuffersGiveTheirViews)
{
	const TRefCountPtr<FRHITexture> Texture = MakeTexture(FIntPoint(8, 2));
	const TRefCountPtr<FRHIUnorderedAccessView> Output =
		new FRHIUnorderedAccessView(Texture, FRHITextureUAVCreateInfo(0));
	const TRefCountPtr<FRHIBuffer> Buffer = new FRHIBuffer(FRHIBufferDesc(64, 16, BUF_StructuredBuffer), TEXT("Table"));
	const TRefCountPtr<FRHIShaderResourceView> Table = new FRHIShaderResourceView(Buffer, FRHIBufferSRVCreateInfo());
	FBloomParameters Parameters;
	Parameters.Output = Output;
	Parameters.Table = Table;
	FShaderReflection Reflection;
	Reflection.RWTextures = {Resource("Output")};
	Reflection.Buffers = {Resource("Table", EShaderDimension::StructuredBuffer)};
	const FBoundShader Bound = Bind(Reflection, Parameters);
	EXPECT_EQ(8, Bound.RWTextures[0].Mips[0].SizeX);
	EXPECT_EQ(64u, Bound.Buffers[0].SizeInBytes);
	EXPECT_EQ(16u, Bound.Buffers[0].Stride);
}

TEST(ShaderBinding, ArgumentsPointIntoTheBoundShaderAfterAMove)
{
	FBloomParameters Parameters;
	Parameters.Threshold = 3.0f;
	FBoundShader Bound = Bind(Loose({Constant("Threshold", EShaderScalar::Float, 1, 0)}, 16), Parameters);
	const FBoundShader Moved = std::move(Bound);
	EXPECT_EQ(3.0f, *reinterpret_cast<const float*>(Moved.GetArgs().ConstantBuffers[0]));
}

TEST(ShaderBinding, StaticSamplersNeedNoMember)
{
	FShaderReflection Reflection;
	Reflection.Samplers = {Resource("GlobalBilinearClampedSampler"), Resource("GlobalPointWrappedSampler")};
	const FBoundShader Bound = Bind(Reflection, FBloomParameters());
	EXPECT_EQ(EKernelFilter::Bilinear, Bound.Samplers[0].Filter);
	EXPECT_EQ(EKernelAddress::Clamp, Bound.Samplers[0].AddressV);
	EXPECT_EQ(EKernelFilter::Point, Bound.Samplers[1].Filter);
	EXPECT_EQ(EKernelAddress::Wrap, Bound.Samplers[1].AddressU);
}

TEST(ShaderMatching, OtherSamplersDo)
{
	FShaderReflection Reflection;
	Reflection.Samplers = {Resource("GlobalSampler")};
	EXPECT_THAT(MessageOf(Reflection),
		HasSubstr(
			"'GlobalSampler' (SamplerState) is read by /Project/X.usf:4 but FBloomParameters has no such member"));
}
