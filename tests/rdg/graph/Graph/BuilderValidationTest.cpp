// What the builder itself refuses: arguments, order of calls, undeclared accesses. Mistakes are thrown together by
// Execute; what would touch wrong memory is thrown at once.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "GraphTestBuilder.h"
#include "RenderGraphUtils.h"

#include <algorithm>

using namespace Drydock;
using testing::HasSubstr;
using testing::Not;

namespace
{

/** The code that Function throws; 0: none. */
template<typename TFunction>
int GetThrownCode(TFunction Function)
{
	try
	{
		Function();
	}
	catch (const FError& Error)
	{
		EXPECT_EQ(ExitUsage, Error.GetExitCode());
		return Error.GetDiagnostics()[0].Code;
	}
	return 0;
}

FRHICommandListImmediate& GetList()
{
	return FRHICommandListExecutor::GetImmediateCommandList();
}

} // namespace

// The builder's life ------------------------------------------------------------------------------------------------

TEST(BuilderValidationDeathTest, DestroyedWithoutExecuteTerminates)
{
	GTEST_FLAG_SET(death_test_style, "threadsafe"); // the library has threads of its own
	EXPECT_DEATH({ FRDGBuilder GraphBuilder(GetList(), RDG_EVENT_NAME("Forgotten")); }, "DD2002.*Forgotten.*Execute");
}

TEST(BuilderValidation, ASecondBuilderIsRefusedAtOnce)
{
	FGraphTest First;
	EXPECT_EQ(RDGErrorSecondBuilder, GetThrownCode([] { FRDGBuilder Second(GetList()); }));
}

TEST(BuilderValidation, ABuilderAfterAnotherIsFine)
{
	{
		FGraphTest First;
		First.Run();
	}
	FGraphTest Second;
	EXPECT_EQ("", Second.RunForErrors());
}

TEST(BuilderValidation, ExecuteTwiceIsRefused)
{
	FGraphTest Graph;
	Graph.Run();
	EXPECT_EQ(RDGErrorExecutedTwice, GetThrownCode([&] { Graph.Run(); }));
}

TEST(BuilderValidation, NothingIsDeclaredAfterExecute)
{
	FGraphTest Graph;
	Graph.External("X");
	Graph.Run();
	EXPECT_EQ(RDGErrorAfterExecute, GetThrownCode([&] { Graph.Texture("Y"); }));
	EXPECT_EQ(RDGErrorAfterExecute, GetThrownCode([&] { Graph.External("Z"); }));
	EXPECT_EQ(RDGErrorAfterExecute, GetThrownCode([&] { Graph.Pass("A"); }));
	EXPECT_EQ(RDGErrorAfterExecute, GetThrownCode([&] { Graph.Extract("X"); }));
	EXPECT_EQ(RDGErrorAfterExecute, GetThrownCode([&] { Graph.Builder->CreateUAV(Graph.Textures["X"]); }));
	EXPECT_EQ(RDGErrorAfterExecute, GetThrownCode([&] { Graph.Builder->Compile(); }));
}

TEST(BuilderValidation, AnExceptionThroughTheBuilderDoesNotTerminate)
{
	EXPECT_THROW(
		{
			FRDGBuilder GraphBuilder(GetList());
			throw std::runtime_error("on the way");
		},
		std::runtime_error);
}

TEST(BuilderValidation, DiscardEndsAGraphWithoutRunningIt)
{
	FGraphTest Graph;
	Graph.Pass("A").Writes("X");
	Graph.Extract("X");
	Graph.Builder->Discard();
	Graph.End();
	EXPECT_EQ("", Graph.Log);
}

// Arguments ---------------------------------------------------------------------------------------------------------

TEST(BuilderValidation, ATextureNeedsAName)
{
	FGraphTest Graph;
	Graph.Builder->CreateTexture(FGraphTest::MakeDesc(), nullptr);
	EXPECT_EQ("2005", Graph.RunForErrors());
}

TEST(BuilderValidation, ABufferNeedsAName)
{
	FGraphTest Graph;
	Graph.Builder->CreateBuffer(FRDGBufferDesc::CreateStructuredDesc(4, 4), nullptr);
	EXPECT_EQ("2005", Graph.RunForErrors());
}

TEST(BuilderValidation, ANullExternalTextureIsRefusedAtOnce)
{
	FGraphTest Graph;
	EXPECT_EQ(RDGErrorNullArgument, GetThrownCode([&] { Graph.Builder->RegisterExternalTexture(nullptr); }));
}

TEST(BuilderValidation, ANullExternalBufferIsRefusedAtOnce)
{
	FGraphTest Graph;
	EXPECT_EQ(RDGErrorNullArgument, GetThrownCode([&] { Graph.Builder->RegisterExternalBuffer(nullptr); }));
}

TEST(BuilderValidation, TryRegisterOfNullIsNull)
{
	FGraphTest Graph;
	EXPECT_EQ(nullptr, TryRegisterExternalTexture(*Graph.Builder, nullptr));
}

TEST(BuilderValidation, NullParametersAreRefusedAtOnce)
{
	FGraphTest Graph;
	const FGraphTestParameters* Null = nullptr;
	EXPECT_EQ(RDGErrorNullArgument,
		GetThrownCode([&]
			{ Graph.Builder->AddPass(RDG_EVENT_NAME("A"), Null, ERDGPassFlags::Compute, [](FRHICommandList&) {}); }));
}

TEST(BuilderValidation, AViewOfNullIsRefusedAtOnce)
{
	FGraphTest Graph;
	EXPECT_EQ(RDGErrorNullArgument, GetThrownCode([&] { Graph.Builder->CreateSRV(FRDGTextureRef()); }));
	EXPECT_EQ(RDGErrorNullArgument, GetThrownCode([&] { Graph.Builder->CreateUAV(FRDGTextureRef()); }));
	EXPECT_EQ(RDGErrorNullArgument, GetThrownCode([&] { Graph.Builder->CreateUAV(FRDGBufferRef(), PF_R32_FLOAT); }));
}

TEST(BuilderValidation, AnImpossibleTextureIsRefusedAtOnce)
{
	FGraphTest Graph;
	FRDGTextureDesc Desc = FGraphTest::MakeDesc();
	Desc.Extent = FIntPoint(0, 4);
	EXPECT_EQ(RDGErrorInvalidDescription, GetThrownCode([&] { Graph.Builder->CreateTexture(Desc, TEXT("X")); }));
}

TEST(BuilderValidation, PresentableTexturesAreNotCreated)
{
	FGraphTest Graph;
	FRDGTextureDesc Desc = FGraphTest::MakeDesc();
	Desc.Flags |= TexCreate_Presentable;
	Graph.Texture("X", Desc);
	EXPECT_EQ("2008", Graph.RunForErrors());
}

TEST(BuilderValidation, AMultisampledTextureHasNoUAV)
{
	FGraphTest Graph;
	FRDGTextureDesc Desc = FGraphTest::MakeDesc();
	Desc.NumSamples = 4;
	Graph.Texture("X", Desc);
	EXPECT_EQ("2008", Graph.RunForErrors());
}

TEST(BuilderValidation, SkipTrackingIsForRegisteredTextures)
{
	FGraphTest Graph;
	Graph.Builder->CreateTexture(FGraphTest::MakeDesc(), TEXT("X"), ERDGTextureFlags::SkipTracking);
	EXPECT_EQ("2008", Graph.RunForErrors());
}

TEST(BuilderValidation, ABufferHasBytes)
{
	FGraphTest Graph;
	Graph.Builder->CreateBuffer(FRDGBufferDesc::CreateStructuredDesc(4, 0), TEXT("X"));
	EXPECT_EQ("2007", Graph.RunForErrors());
}

TEST(BuilderValidation, AUAVNeedsTheFlag)
{
	FGraphTest Graph;
	FRDGTextureDesc Desc = FGraphTest::MakeDesc();
	Desc.Flags = TexCreate_ShaderResource;
	Graph.Builder->CreateUAV(Graph.Texture("X", Desc));
	EXPECT_EQ("2009", Graph.RunForErrors());
}

TEST(BuilderValidation, AUAVOfAMipThatIsNotThereIsRefusedAtOnce)
{
	FGraphTest Graph;
	EXPECT_EQ(
		RDGErrorView, GetThrownCode([&] { Graph.Builder->CreateUAV(FRDGTextureUAVDesc(Graph.Texture("X", 2), 2)); }));
}

TEST(BuilderValidation, AnSRVOfAMipThatIsNotThereIsRefusedAtOnce)
{
	FGraphTest Graph;
	EXPECT_EQ(RDGErrorView,
		GetThrownCode(
			[&] { Graph.Builder->CreateSRV(FRDGTextureSRVDesc::CreateForMipLevel(Graph.Texture("X", 2), 2)); }));
}

TEST(BuilderValidation, ARenderTargetMipThatIsNotThereIsRefusedAtOnce)
{
	FGraphTest Graph;
	auto* Parameters = Graph.Builder->AllocParameters<FGraphTestRasterParameters>();
	Parameters->RenderTargets[0] = FRenderTargetBinding(Graph.Texture("X"), ERenderTargetLoadAction::EClear, 1);
	EXPECT_EQ(RDGErrorRenderTargets, GetThrownCode(
										 [&] {
											 Graph.Builder->AddPass(RDG_EVENT_NAME("A"), Parameters,
												 ERDGPassFlags::Raster, [](FRHICommandList&) {});
										 }));
}

TEST(BuilderValidation, ExtractionNeedsAProducerBefore)
{
	FGraphTest Graph;
	Graph.Extract("X");
	Graph.Pass("A").Writes("X");
	EXPECT_EQ("2010", Graph.RunForErrors());
}

TEST(BuilderValidation, ExtractionToNullIsRefusedAtOnce)
{
	FGraphTest Graph;
	Graph.Pass("A").Writes("X");
	EXPECT_EQ(RDGErrorNullArgument,
		GetThrownCode([&] { Graph.Builder->QueueTextureExtraction(Graph.Texture("X"), nullptr); }));
}

TEST(BuilderValidation, OneUploadPerBuffer)
{
	FGraphTest Graph;
	const uint32 Data[4] = {};
	FRDGBufferRef Buffer = Graph.Builder->CreateBuffer(FRDGBufferDesc::CreateStructuredDesc(4, 4), TEXT("X"));
	Graph.Builder->QueueBufferUpload(Buffer, Data, sizeof(Data));
	Graph.Builder->QueueBufferUpload(Buffer, Data, sizeof(Data));
	EXPECT_EQ("2011", Graph.RunForErrors());
}

TEST(BuilderValidation, AnUploadThatDoesNotFitIsRefusedAtOnce)
{
	FGraphTest Graph;
	const uint32 Data[5] = {};
	FRDGBufferRef Buffer = Graph.Builder->CreateBuffer(FRDGBufferDesc::CreateStructuredDesc(4, 4), TEXT("X"));
	EXPECT_EQ(RDGErrorUpload, GetThrownCode([&] { Graph.Builder->QueueBufferUpload(Buffer, Data, sizeof(Data)); }));
}

TEST(BuilderValidation, AccessFinalIsForWhatLeavesTheGraph)
{
	FGraphTest Graph;
	Graph.Builder->SetTextureAccessFinal(Graph.Texture("X"), ERHIAccess::CopySrc);
	EXPECT_EQ("2012", Graph.RunForErrors());
}

TEST(BuilderValidation, AResourceOfAnotherGraphIsRefusedAtOnce)
{
	FRDGTextureRef Old = nullptr;
	{
		FGraphTest First;
		Old = First.Texture("Old");
	}
	FGraphTest Second;
	// Nothing is created in the second graph, so no pointer of its own can equal the old one.
	EXPECT_EQ(RDGErrorForeignResource, GetThrownCode([&] { Second.Builder->CreateUAV(FRDGTextureUAVDesc(Old)); }));
}

TEST(BuilderValidation, AProducerComesBeforeItsConsumer)
{
	FGraphTest Graph;
	FRDGPassRef A = nullptr;
	FRDGPassRef B = nullptr;
	Graph.Pass("A").Writes("X").Into(A);
	Graph.Pass("B").Writes("Y").Into(B);
	Graph.Builder->AddPassDependency(B, A);
	EXPECT_EQ("2027", Graph.RunForErrors());
}

TEST(BuilderValidation, AScopeThatWasNotOpenedIsNotClosed)
{
	FGraphTest Graph;
	EXPECT_EQ(RDGErrorScope, GetThrownCode([&] { Graph.Builder->EndEventScope(); }));
}

// Execution ---------------------------------------------------------------------------------------------------------

TEST(BuilderValidation, GetRHIOutsideAPassIsACheck)
{
	FGraphTest Graph;
	EXPECT_EQ(RDGErrorUndeclaredAccess, GetThrownCode([&] { Graph.Texture("X")->GetRHI(); }));
}

TEST(BuilderValidation, GetRHIOfAnExternalTextureOutsideAPassIsACheckToo)
{
	FGraphTest Graph;
	EXPECT_EQ(RDGErrorUndeclaredAccess, GetThrownCode([&] { Graph.External("X")->GetRHI(); }));
}

TEST(BuilderValidation, GetRHIInAPassThatDoesNotDeclareTheResourceIsACheck)
{
	FGraphTest Graph;
	FRDGTextureRef Other = Graph.External("Other");
	Graph.Pass("A").Writes("X").Does([Other](FRHICommandListImmediate&) { Other->GetRHI(); });
	Graph.Extract("X");
	EXPECT_EQ("2030", Graph.RunForErrors());
}

TEST(BuilderValidation, GetRHIAfterThePassIsACheck)
{
	FGraphTest Graph;
	Graph.Pass("A").Writes("X");
	Graph.Extract("X");
	Graph.Run();
	EXPECT_EQ(RDGErrorUndeclaredAccess, GetThrownCode([&] { Graph.Textures["X"]->GetRHI(); }));
}

TEST(BuilderValidation, MistakesOfBuilderAndGraphAreThrownTogether)
{
	FGraphTest Graph;
	Graph.Builder->CreateTexture(FGraphTest::MakeDesc(), nullptr);
	Graph.Pass("A").Writes("X").Reads("X");
	Graph.Pass("B").Reads("X");
	EXPECT_EQ("2005 2025 2021", Graph.RunForErrors());
}

TEST(BuilderValidation, NothingRunsWhenThereAreMistakes)
{
	FGraphTest Graph;
	Graph.Pass("A").Writes("X");
	Graph.Pass("B").Reads("X");
	Graph.Extract("X");
	Graph.RunForErrors();
	EXPECT_EQ("", Graph.Log);
}

TEST(BuilderValidation, MistakesAreThrownWithTheLineOfAddPass)
{
	FGraphTest Graph;
	auto* Parameters = Graph.Builder->AllocParameters<FGraphTestParameters>();
	const int Line = __LINE__ + 1;
	Graph.Builder->AddPass(RDG_EVENT_NAME("Idle %d", 7), Parameters, ERDGPassFlags::Compute, [](FRHICommandList&) {});
	testing::internal::CaptureStderr();
	try
	{
		Graph.Run();
		FAIL() << "no message";
	}
	catch (const FError& Error)
	{
		const std::string Text = Error.what();
		EXPECT_THAT(Text, HasSubstr("BuilderValidationTest.cpp:" + std::to_string(Line)));
		EXPECT_THAT(Text, HasSubstr("error DD2021 at pass Idle 7"));
	}
	EXPECT_EQ("", testing::internal::GetCapturedStderr()) << "whoever catches it prints it";
}

TEST(BuilderValidation, AnEnsurePrintsAndGoesOn)
{
	FGraphTest Graph;
	Graph.Pass("A").Reads("Never").Writes("X");
	Graph.Extract("X");
	testing::internal::CaptureStderr();
	EXPECT_EQ("A", Graph.Run());
	EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("never written"));
}

TEST(BuilderValidation, TenThousandEnsuresOfOneKindAreSixLines)
{
	FGraphTest Graph;
	for (int Pass = 0; Pass < 10'000; ++Pass)
	{
		Graph.Pass("A").Reads("Never" + std::to_string(Pass)).Writes("X").Does([](FRHICommandListImmediate&) {});
	}
	Graph.Extract("X");
	testing::internal::CaptureStderr();
	Graph.Run();
	const std::string Log = testing::internal::GetCapturedStderr();
	EXPECT_THAT(Log, HasSubstr("Never4"));
	EXPECT_THAT(Log, Not(HasSubstr("Never5")));
	EXPECT_THAT(Log, HasSubstr("and 9995 more like it (DD2040)"));
}

TEST(BuilderValidation, TenThousandWrongPassesAreSixLinesAndAllThere)
{
	FGraphTest Graph;
	auto* Parameters = Graph.Builder->AllocParameters<FGraphTestParameters>();
	for (int Pass = 0; Pass < 10'000; ++Pass)
	{
		Graph.Builder->AddPass(
			RDG_EVENT_NAME("Idle %d", Pass), Parameters, ERDGPassFlags::Compute, [](FRHICommandList&) {});
	}
	try
	{
		Graph.Run();
		FAIL() << "no message";
	}
	catch (const FError& Error)
	{
		EXPECT_EQ(10'000u, Error.GetDiagnostics().size());
		const std::string Text = Error.what();
		EXPECT_EQ(5, std::count(Text.begin(), Text.end(), '\n'));
		EXPECT_THAT(Text, HasSubstr("error DD1025: and 9995 more like it (DD2021)"));
	}
}

TEST(BuilderValidation, SwitchedOffMistakesPass)
{
	const FScopedConsoleVariable Off(TEXT("r.RDG.Validation"), 0);
	FGraphTest Graph;
	Graph.External("X");
	Graph.Pass("A").Reads("X").AddFlags(ERDGPassFlags::SkipRenderPass);
	Graph.Texture("X");
	EXPECT_EQ("", Graph.RunForErrors());
}

TEST(BuilderValidation, SamplingATextureThatIsOnlyAUAVRuns)
{
	FGraphTest Graph;
	FRDGTextureDesc Desc = FGraphTest::MakeDesc();
	Desc.Flags = TexCreate_UAV;
	Graph.Texture("X", Desc);
	Graph.Pass("A").Writes("X").Value(3);
	Graph.Pass("B").Reads("X").Writes("Y");
	Graph.Extract("Y");
	testing::internal::CaptureStderr();
	Graph.Run();
	EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("warning DD2050"));
	EXPECT_EQ(4.0f, Graph.Pixel("Y"));
}

TEST(BuilderValidation, ExternalAccessModeReportsOtherAccesses)
{
	FGraphTest Graph;
	Graph.External("X");
	Graph.Builder->UseExternalAccessMode(Graph.Texture("X"), ERHIAccess::SRVMask);
	Graph.Pass("A").Writes("X");
	testing::internal::CaptureStderr();
	Graph.Run();
	EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("external access mode"));
}

TEST(BuilderValidation, UnusedParametersAreWarnedAboutWhenDebugging)
{
	const FScopedConsoleVariable Debug(TEXT("r.RDG.Debug"), 2);
	FGraphTest Graph;
	Graph.External("In");
	Graph.Pass("A").Reads("In").Writes("X").Does([](FRHICommandListImmediate&) {});
	Graph.Extract("X");
	testing::internal::CaptureStderr();
	Graph.Run();
	EXPECT_THAT(testing::internal::GetCapturedStderr(),
		HasSubstr("2 of 2 resources of the pass were not actually used: In, X"));
}
