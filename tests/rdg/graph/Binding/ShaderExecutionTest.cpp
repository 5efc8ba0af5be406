// From a shader class to pixels: compiling, binding, running, forgetting, native kernels. Slow parts are shared.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "NativeKernels.h"
#include "PipelineStateCache.h"
#include "RHICommandList.h"
#include "RHIResources.h"
#include "ShaderBinding.h"
#include "ShaderCompilation.h"
#include "ShaderDirectories.h"
#include "ShaderTypes.h"

namespace
{

using namespace Drydock;
using testing::HasSubstr;

void RunNativeTint(const FNativeKernelArgs& Args, const FKernelTile&)
{
	const FTestTintCS::FParameters& Parameters = GetNativeParameters<FTestTintCS>(Args);
	float* const Texel = reinterpret_cast<float*>(Args.FindRWTexture("OutputTexture")->Mips[0].Data);
	Texel[0] = Parameters.Tint.X + 100.0f;
	Texel[1] = Args.FindTexture("UnusedTexture") == nullptr ? 1.0f : 0.0f;
}

class FShaderExecution : public testing::Test
{
protected:
	static void SetUpTestSuite()
	{
		setenv("DRYDOCK_CACHE_DIR", DRYDOCK_TEST_BINARY_DIR "/test-shader-cache", 0);
		AddShaderSourceDirectoryMapping(
			TEXT("/DrydockTest"), FString(DRYDOCK_TEST_SOURCE_DIR "/tests/rdg/graph/Binding/Shaders"));
	}

	FShaderExecution()
	{
		const ETextureCreateFlags Flags = TexCreate_ShaderResource | TexCreate_UAV;
		Input = new FRHITexture(
			FRHITextureDesc::Create2D(FIntPoint(5, 3), PF_A32B32G32R32F, FClearValueBinding::None, Flags),
			TEXT("Input"));
		Output = new FRHITexture(
			FRHITextureDesc::Create2D(FIntPoint(5, 3), PF_A32B32G32R32F, FClearValueBinding::None, Flags),
			TEXT("Output"));
		OutputView = new FRHIUnorderedAccessView(Output, FRHITextureUAVCreateInfo(0));
		Input->WriteTexel(4, 2, FLinearColor(1.0f, 2.0f, 3.0f, 4.0f));
		Output->EnsureMemory();
		Parameters.Tint = FVector4f(2.0f, 2.0f, 2.0f, 2.0f);
		Parameters.Transform = FMatrix44f::Identity;
		Parameters.InputTexture = Input;
		Parameters.OutputTexture = OutputView;
	}

	static TShaderMapRef<FTestTintCS> Tint(bool bUseView)
	{
		return TShaderMapRef<FTestTintCS>(GetGlobalShaderMap(GMaxRHIFeatureLevel), bUseView ? 1 : 0);
	}

	static std::string TintText() { return GetShaderFingerprint(Tint(false)); }

	void Run(bool bUseView)
	{
		FBoundShader Bound;
		BindShaderParameters(Tint(bUseView), &Parameters, Bound);
		Bound.Run(Bound.GetArgs(), FKernelTile{0, 0, 0, 8, 8, 1});
	}

	FTestTintCS::FParameters Parameters;
	TRefCountPtr<FRHITexture> Input;
	TRefCountPtr<FRHITexture> Output;
	TRefCountPtr<FRHIUnorderedAccessView> OutputView;
};

} // namespace

TEST_F(FShaderExecution, ReflectionListsWhatIsReadOnly)
{
	const std::shared_ptr<const FShaderReflection> Reflection = GetShaderReflection(Tint(false));
	ASSERT_EQ(1u, Reflection->Textures.size());
	EXPECT_EQ("InputTexture", Reflection->Textures[0].Name);
	EXPECT_EQ(8, Reflection->GroupSize[0]);
}

TEST_F(FShaderExecution, RunsWithItsParameters)
{
	Run(false);
	EXPECT_EQ(FLinearColor(2.0f, 4.0f, 6.0f, 8.0f), Output->ReadTexel(4, 2));
	EXPECT_EQ(FLinearColor(0.0f, 0.0f, 0.0f, 0.0f), Output->ReadTexel(0, 0));
}

TEST_F(FShaderExecution, CommandListsDispatchWhatWasSet)
{
	FRHICommandListImmediate& RHICmdList = FRHICommandListExecutor::GetImmediateCommandList();
	const TShaderMapRef<FTestTintCS> Shader = Tint(false);
	SetComputePipelineState(RHICmdList, Shader.GetComputeShader());
	SetShaderParameters(RHICmdList, Shader, Shader.GetComputeShader(), Parameters);
	RHICmdList.DispatchComputeShader(1, 1, 1);
	UnsetShaderUAVs(RHICmdList, Shader, Shader.GetComputeShader());
	EXPECT_EQ(FLinearColor(2.0f, 4.0f, 6.0f, 8.0f), Output->ReadTexel(4, 2));
}

TEST_F(FShaderExecution, ABatchOfParametersIsSetAsOne)
{
	FRHICommandListImmediate& RHICmdList = FRHICommandListExecutor::GetImmediateCommandList();
	const TShaderMapRef<FTestTintCS> Shader = Tint(false);
	SetComputePipelineState(RHICmdList, Shader.GetComputeShader());
	FRHIBatchedShaderParameters& Batch = RHICmdList.GetScratchShaderParameters();
	EXPECT_FALSE(Batch.HasParameters());
	SetShaderParameters(Batch, Shader, Parameters);
	EXPECT_TRUE(Batch.HasParameters());
	RHICmdList.SetBatchedShaderParameters(Shader.GetComputeShader(), Batch);
	EXPECT_FALSE(Batch.HasParameters());
	RHICmdList.DispatchComputeShader(1, 1, 1);
	EXPECT_EQ(FLinearColor(2.0f, 4.0f, 6.0f, 8.0f), Output->ReadTexel(4, 2));
}

TEST_F(FShaderExecution, AnUpdatedUniformBufferLeavesTheOneBefore)
{
	FTestViewUniforms View;
	View.PreExposure = 0.5f;
	TUniformBufferRef<FTestViewUniforms> Buffer =
		TUniformBufferRef<FTestViewUniforms>::CreateUniformBufferImmediate(View, UniformBuffer_MultiFrame);
	const TUniformBufferRef<FTestViewUniforms> Before = Buffer;
	View.PreExposure = 4.0f;
	Buffer.UpdateUniformBufferImmediate(FRHICommandListExecutor::GetImmediateCommandList(), View);
	EXPECT_EQ(0.5f, static_cast<const FTestViewUniforms*>(Before->GetContents())->PreExposure);
	EXPECT_EQ(4.0f, static_cast<const FTestViewUniforms*>(Buffer->GetContents())->PreExposure);
}

TEST_F(FShaderExecution, MatricesMultiplyFromTheRightAsInTheEngine)
{
	Parameters.Transform.M[0][1] = 10.0f; // row vector times matrix: y gains 10 x
	Run(false);
	EXPECT_EQ(FLinearColor(2.0f, 4.0f + 20.0f, 6.0f, 8.0f), Output->ReadTexel(4, 2));
}

TEST_F(FShaderExecution, ReadsUniformBuffersByTheirHlslName)
{
	FTestViewUniforms View;
	View.PreExposure = 0.5f;
	View.Planes[1] = FVector4f(0.0f, 1.0f, 0.0f, 0.0f);
	Parameters.View =
		TUniformBufferRef<FTestViewUniforms>::CreateUniformBufferImmediate(View, UniformBuffer_SingleFrame);
	Run(true);
	EXPECT_EQ(FLinearColor(2.5f, 5.5f, 6.5f, 8.5f), Output->ReadTexel(4, 2));
}

TEST_F(FShaderExecution, ValidationNamesShaderStructAndMember)
{
	Parameters.InputTexture = nullptr;
	try
	{
		ValidateShaderParameters(Tint(false), Parameters);
		FAIL() << "no message";
	}
	catch (const FError& Error)
	{
		EXPECT_EQ(ExitUsage, Error.GetExitCode());
		ASSERT_EQ(1u, Error.GetDiagnostics().size());
		EXPECT_EQ(2015, Error.GetDiagnostics()[0].Code);
		EXPECT_THAT(Error.what(),
			HasSubstr("FTestTintCS's required shader parameter FParameters::InputTexture was not set. (declared at "));
		EXPECT_THAT(Error.what(), HasSubstr("ShaderTypes.h:"));
	}
}

TEST_F(FShaderExecution, ValidationLeavesUnreadResourcesAlone)
{
	EXPECT_NO_THROW(ValidateShaderParameters(Tint(false), Parameters));
}

TEST_F(FShaderExecution, ValidationMissesAUniformBuffer)
{
	EXPECT_THROW(ValidateShaderParameters(Tint(true), Parameters), FError);
}

TEST_F(FShaderExecution, MismatchThrowsTheMessageWithTheUsfLine)
{
	const TShaderMapRef<FTestMisspelledPS> Shader(GetGlobalShaderMap(GMaxRHIFeatureLevel));
	const FTestMisspelledPS::FParameters Misspelled;
	try
	{
		ValidateShaderParameters(Shader, Misspelled);
		FAIL() << "no error";
	}
	catch (const FError& Error)
	{
		ASSERT_EQ(1u, Error.GetDiagnostics().size());
		EXPECT_EQ(6101, Error.GetDiagnostics()[0].Code);
		EXPECT_EQ(ExitUsage, Error.GetExitCode());
		EXPECT_THAT(Error.GetDiagnostics()[0].Message,
			HasSubstr("FTestMisspelledPS: 'ToonIntensity' (float) is read by "
					  "/DrydockTest/Misspelled.usf:6 but FParameters has no such member; did you mean 'ToonIntensty'? "
					  "(entry MisspelledPS)"));
	}
}

TEST_F(FShaderExecution, NativeKernelStandsInUnlessSwitchedOff)
{
	const FNativeKernelRegistrar Registrar(FTestTintCS::GetStaticType(), &RunNativeTint, TintText().c_str());
	IConsoleVariable* const Switch = IConsoleManager::Get().FindConsoleVariable(TEXT("r.Drydock.NativeKernels"));
	Run(false);
	EXPECT_EQ(FLinearColor(102.0f, 1.0f, 0.0f, 0.0f), Output->ReadTexel(0, 0));
	Switch->Set(0);
	Run(false);
	Switch->Set(1);
	EXPECT_EQ(FLinearColor(0.0f, 0.0f, 0.0f, 0.0f), Output->ReadTexel(0, 0));
}

TEST_F(FShaderExecution, NativeKernelsGoWithTheirRegistrar)
{
	{
		const FNativeKernelRegistrar Registrar(FTestTintCS::GetStaticType(), &RunNativeTint, TintText().c_str());
		EXPECT_EQ(ENativeChoice::Native, FindNativeKernel(Tint(false)));
	}
	EXPECT_EQ(ENativeChoice::Shader, FindNativeKernel(Tint(false)));
}

TEST_F(FShaderExecution, NativeKernelLeavesAnotherTextToTheShader)
{
	const FNativeKernelRegistrar Registrar(FTestTintCS::GetStaticType(), &RunNativeTint, "0123456789abcdef");
	Run(false);
	EXPECT_EQ(FLinearColor(0.0f, 0.0f, 0.0f, 0.0f), Output->ReadTexel(0, 0));
	EXPECT_EQ(ENativeChoice::Edited, FindNativeKernel(Tint(false)));
	const FScopedNativeKernelsForAnyText AnyText;
	Run(false);
	EXPECT_EQ(FLinearColor(102.0f, 1.0f, 0.0f, 0.0f), Output->ReadTexel(0, 0));
	ASSERT_EQ(1u, AnyText.GetStoodIn().size());
	EXPECT_EQ(TintText(), AnyText.GetStoodIn()[0].Fingerprint);
}

TEST_F(FShaderExecution, DoublePrecisionRunsTheUsf)
{
	const FNativeKernelRegistrar Registrar(FTestTintCS::GetStaticType(), &RunNativeTint, TintText().c_str());
	IConsoleVariable* const Precision = IConsoleManager::Get().FindConsoleVariable(TEXT("r.Drydock.Precision"));
	Precision->Set(1);
	Run(false);
	Precision->Set(0);
	EXPECT_EQ(FLinearColor(2.0f, 4.0f, 6.0f, 8.0f), Output->ReadTexel(4, 2));
}

TEST_F(FShaderExecution, APermutationIsCompiledOnce)
{
	EXPECT_EQ(GetCompiledShader(Tint(false)), GetCompiledShader(Tint(false)));
	EXPECT_NE(GetCompiledShader(Tint(false)), GetCompiledShader(Tint(true)));
}

TEST_F(FShaderExecution, WarmingGoesOnAfterAFailureAndReportsIt)
{
	const TShaderMapRef<FTestBrokenCS> Broken(GetGlobalShaderMap(GMaxRHIFeatureLevel));
	try
	{
		WarmShaders({Broken, Tint(false), Tint(true)}, 2);
		FAIL() << "no error";
	}
	catch (const FError& Error)
	{
		ASSERT_FALSE(Error.GetDiagnostics().empty());
		EXPECT_EQ("/DrydockTest/Broken.usf", Error.GetDiagnostics()[0].File);
		EXPECT_EQ(7, Error.GetDiagnostics()[0].Line);
		const std::string& Message = Error.GetDiagnostics()[0].Message; // the line of source stands below
		EXPECT_TRUE(Message.substr(0, Message.find('\n')).ends_with(" (compiled for FTestBrokenCS, entry BrokenCS)"));
	}
	EXPECT_NE(nullptr, GetCompiledShader(Tint(true))->Run);
}

TEST_F(FShaderExecution, ShadersOfOtherFilesAreKept)
{
	const std::shared_ptr<const FCompiledShader> Before = GetCompiledShader(Tint(false));
	ForgetShadersOf({FindShaderFile("/DrydockTest/Graph.usf")});
	EXPECT_EQ(Before, GetCompiledShader(Tint(false)));
	const std::filesystem::path File = FindShaderFile("/DrydockTest/Tint.usf");
	ForgetShadersOf({(File.parent_path() / "." / File.filename()).string()}); // another name of the same file
	EXPECT_NE(Before, GetCompiledShader(Tint(false)));
	EXPECT_EQ(Before->Key, GetCompiledShader(Tint(false))->Key);
}

TEST_F(FShaderExecution, ForgottenShadersAreReadAgain)
{
	const std::shared_ptr<const FCompiledShader> Before = GetCompiledShader(Tint(false));
	ForgetShaders();
	EXPECT_NE(Before, GetCompiledShader(Tint(false)));
	EXPECT_EQ(Before->Key, GetCompiledShader(Tint(false))->Key);
}
