// Shader classes, their registry and their permutations. Nothing is compiled here.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ShaderCompilation.h"
#include "ShaderTypes.h"

namespace
{

using FDefines = std::vector<std::pair<std::string, std::string>>;

FGlobalShaderMap* Map()
{
	return GetGlobalShaderMap(GMaxRHIFeatureLevel);
}

const FGlobalShaderType& TypeNamed(const std::string& Name)
{
	const FGlobalShaderType* Found = nullptr;
	Drydock::ForEachGlobalShader(
		[&](const FGlobalShaderType& Type) { Found = Name == Type.GetName() ? &Type : Found; });
	if (!Found)
	{
		throw std::runtime_error("no shader class " + Name);
	}
	return *Found;
}

FTestTintCS::FPermutationDomain WithView()
{
	FTestTintCS::FPermutationDomain Domain;
	Domain.Set<FTestTintCS::FUseViewDim>(true);
	return Domain;
}

} // namespace

TEST(ShaderType, CarriesWhatImplementSaid)
{
	const FShaderType& Type = FTestTintCS::GetStaticType();
	EXPECT_STREQ("FTestTintCS", Type.GetName());
	EXPECT_STREQ("/DrydockTest/Tint.usf", Type.GetShaderFilename());
	EXPECT_STREQ("TintCS", Type.GetFunctionName());
	EXPECT_EQ(SF_Compute, Type.GetFrequency());
	EXPECT_EQ(2, Type.GetPermutationCount());
}

TEST(ShaderType, ListsClassesOfAnonymousNamespaces)
{
	EXPECT_EQ(3, TypeNamed("FTestHiddenCS").GetPermutationCount());
}

TEST(ShaderType, ListsByName)
{
	std::vector<std::string> Names;
	Drydock::ForEachGlobalShader([&Names](const FGlobalShaderType& Type) { Names.push_back(Type.GetName()); });
	EXPECT_TRUE(std::is_sorted(Names.begin(), Names.end()));
	EXPECT_THAT(Names, testing::IsSupersetOf({"FTestHiddenCS", "FTestTintCS", "FTestVS", "TTestTemplatePS<true>"}));
}

TEST(ShaderType, TemplateInstancesAreClassesOfTheirOwn)
{
	EXPECT_EQ((FDefines{{"TWICE", "1"}}), TypeNamed("TTestTemplatePS<true>").GetCompilationEnvironment(0).GetDefines());
	EXPECT_EQ(
		(FDefines{{"TWICE", "0"}}), TypeNamed("TTestTemplatePS<false>").GetCompilationEnvironment(0).GetDefines());
}

TEST(ShaderType, DefinesAreThoseOfThePermutationThenOfTheClass)
{
	EXPECT_EQ((FDefines{{"USE_VIEW", "1"}, {"THREADGROUPSIZE_X", "8"}}),
		FTestTintCS::GetStaticType().GetCompilationEnvironment(1).GetDefines());
}

TEST(ShaderType, RefusedPermutationsAreListedAndCannotBeHad)
{
	const FGlobalShaderType& Type = TypeNamed("FTestHiddenCS");
	EXPECT_TRUE(Type.ShouldCompilePermutation(0));
	EXPECT_FALSE(Type.ShouldCompilePermutation(1));
	EXPECT_THROW(Type.FindOrCreateShader(1), Drydock::FCheckFailure);
}

TEST(ShaderType, PermutationsOutOfRangeAreAcheck)
{
	EXPECT_THROW(FTestTintCS::GetStaticType().FindOrCreateShader(2), Drydock::FCheckFailure);
}

TEST(ShaderMap, APermutationIsOneObject)
{
	const TShaderMapRef<FTestTintCS> A(Map(), WithView());
	const TShaderMapRef<FTestTintCS> B(Map(), 1);
	EXPECT_EQ(A.GetShader(), B.GetShader());
	EXPECT_EQ(1, A->GetPermutationId());
	EXPECT_NE(A.GetShader(), TShaderMapRef<FTestTintCS>(Map()).GetShader());
}

TEST(ShaderMap, EveryPlatformAndLevelIsTheSameMap)
{
	EXPECT_EQ(GetGlobalShaderMap(ERHIFeatureLevel::SM6), GetGlobalShaderMap(GMaxRHIShaderPlatform));
}

TEST(ShaderMap, ReachesConstantsOfTheClass)
{
	EXPECT_EQ(8, TShaderMapRef<FTestTintCS>(Map())->THREADGROUPSIZE_X);
}

TEST(ShaderMap, GivesTheHandleOfItsFrequencyOnly)
{
	const TShaderMapRef<FTestTintCS> Compute(Map());
	EXPECT_NE(nullptr, Compute.GetComputeShader());
	EXPECT_EQ(nullptr, Compute.GetPixelShader());
	EXPECT_NE(nullptr, TShaderMapRef<FTestMisspelledPS>(Map()).GetPixelShader());
	EXPECT_NE(nullptr, TShaderMapRef<FTestVS>(Map()).GetVertexShader());
}

TEST(ShaderMap, ConvertsToTheBaseClass)
{
	const TShaderRef<FShader> Shader = TShaderMapRef<FTestTintCS>(Map());
	EXPECT_STREQ("FTestTintCS", Shader.GetType()->GetName());
	EXPECT_EQ(FTestTintCS::FParameters::FTypeInfo::GetStructMetadata(), Shader.GetRootParametersMetadata());
}

TEST(ShaderRef, DefaultIsInvalid)
{
	EXPECT_FALSE(TShaderRef<FTestTintCS>().IsValid());
	EXPECT_EQ(nullptr, TShaderRef<FTestTintCS>().GetComputeShader());
}

TEST(ShaderCompileRequest, NamesFileEntryStageAndDefines)
{
	const TShaderMapRef<FTestTintCS> Shader(Map());
	const Drydock::FShaderCompileRequest Request =
		Drydock::MakeShaderCompileRequest(Shader, Shader.GetRootParametersMetadata());
	EXPECT_EQ("/DrydockTest/Tint.usf", Request.VirtualPath);
	EXPECT_EQ("TintCS", Request.EntryPoint);
	EXPECT_EQ(Drydock::EShaderStage::Compute, Request.Stage);
	EXPECT_EQ((FDefines{{"USE_VIEW", "0"}, {"THREADGROUPSIZE_X", "8"}}), Request.Defines);
}

TEST(ShaderCompileRequest, DeclaresTheUniformBuffersOfTheStruct)
{
	const TShaderMapRef<FTestTintCS> Shader(Map());
	const Drydock::FShaderCompileRequest Request =
		Drydock::MakeShaderCompileRequest(Shader, Shader.GetRootParametersMetadata());
	ASSERT_FALSE(Request.UniformBuffers.empty());
	const Drydock::FShaderUniformBuffer& Buffer = Request.UniformBuffers[0];
	EXPECT_EQ("TestView", Buffer.Name);
	EXPECT_THAT(
		Buffer.Members, testing::ElementsAre("ScreenToWorld", "PreExposure", "Planes", "SharedSampler", "Noise"));
	EXPECT_EQ("cbuffer TestView\n{\n\tfloat4x4 TestView_ScreenToWorld;\n\tfloat "
			  "TestView_PreExposure;\n\tfloat4 TestView_Planes[3];\n};\n"
			  "SamplerState TestView_SharedSampler;\nTexture2D TestView_Noise;\n",
		Buffer.Declaration);
}

TEST(ShaderCompileRequest, PrecisionAndWidthAreConsoleVariables)
{
	IConsoleVariable* const Precision = IConsoleManager::Get().FindConsoleVariable(TEXT("r.Drydock.Precision"));
	IConsoleVariable* const LaneWidth = IConsoleManager::Get().FindConsoleVariable(TEXT("r.Drydock.LaneWidth"));
	Precision->Set(1);
	LaneWidth->Set(8);
	const Drydock::FLaneConfig Double = Drydock::GetShaderLaneConfig();
	Precision->Set(0);
	const Drydock::FLaneConfig Float = Drydock::GetShaderLaneConfig();
	LaneWidth->Set(0);
	EXPECT_TRUE(Double.bDouble);
	EXPECT_EQ(4, Double.Lanes);
	EXPECT_FALSE(Float.bDouble);
	EXPECT_EQ(8, Float.Lanes);
	EXPECT_EQ(0, Drydock::GetShaderLaneConfig().Lanes);
}

TEST(ShaderCompileRequest, VertexShadersAreAStageOfTheirOwn)
{
	const TShaderMapRef<FTestVS> Shader(Map());
	const Drydock::FShaderCompileRequest Request = Drydock::MakeShaderCompileRequest(Shader, nullptr);
	EXPECT_EQ(Drydock::EShaderStage::Vertex, Request.Stage);
	EXPECT_EQ("MainVS", Request.EntryPoint);
}
