// What the validation says of declared graphs, rule by rule, on hand-made descriptions.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "GraphDescriptionBuilder.h"
#include "RenderGraphValidate.h"

using namespace Drydock;
using testing::HasSubstr;

namespace
{

std::string GetCodes(const std::vector<FDiagnostic>& Diagnostics)
{
	std::string Codes;
	for (const FDiagnostic& Diagnostic : Diagnostics)
	{
		Codes += (Codes.empty() ? "" : " ") + std::to_string(Diagnostic.Code);
	}
	return Codes;
}

std::string Errors(const FDescribedGraph& Graph)
{
	return GetCodes(ValidateGraph(Graph.Get(), false).Errors);
}
std::string Ensures(const FDescribedGraph& Graph)
{
	return GetCodes(ValidateGraph(Graph.Get(), false).Ensures);
}
std::string Warnings(const FDescribedGraph& Graph, bool bDebug = false)
{
	return GetCodes(ValidateGraph(Graph.Get(), bDebug).Warnings);
}

/** One pass that writes X with these flags. */
std::string ErrorsOfFlags(ERDGPassFlags Flags)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")}, Flags);
	return Errors(Graph);
}

} // namespace

TEST(Validate, AGoodGraphIsGood)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	Graph.RasterPass("B", "Y", ERenderTargetLoadAction::EClear, {{"X", ERHIAccess::SRVGraphics}});
	Graph.Pass("Note", {}, ERDGPassFlags::None).bHasParameters = false;
	EXPECT_EQ("", Errors(Graph) + Ensures(Graph) + Warnings(Graph));
}

TEST(Validate, ParametersNeedAWorkFlag)
{
	EXPECT_EQ("2020 2024", ErrorsOfFlags(ERDGPassFlags::None));
}
TEST(Validate, NeverCullIsNoWorkFlag)
{
	EXPECT_EQ("2020 2024", ErrorsOfFlags(ERDGPassFlags::NeverCull));
}
TEST(Validate, ComputeExcludesAsyncCompute)
{
	EXPECT_EQ("2020", ErrorsOfFlags(ERDGPassFlags::Compute | ERDGPassFlags::AsyncCompute));
}
TEST(Validate, SkipRenderPassNeedsRaster)
{
	EXPECT_EQ("2020", ErrorsOfFlags(ERDGPassFlags::Compute | ERDGPassFlags::SkipRenderPass));
}
TEST(Validate, NeverMergeNeedsRaster)
{
	EXPECT_EQ("2020", ErrorsOfFlags(ERDGPassFlags::Compute | ERDGPassFlags::NeverMerge));
}

TEST(Validate, RasterExcludesAsyncCompute)
{
	FDescribedGraph Graph;
	Graph.RasterPass("A", "X").Flags |= ERDGPassFlags::AsyncCompute;
	Graph.Resource("X").bExternal = true;
	EXPECT_EQ("2020", Errors(Graph));
}

TEST(Validate, WithoutParametersThereIsNoWorkFlag)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {}, ERDGPassFlags::Compute).bHasParameters = false;
	EXPECT_EQ("2020", Errors(Graph));
}

TEST(Validate, APassWithoutOutputWouldAlwaysBeCulled)
{
	FDescribedGraph Graph;
	Graph.Resource("X").bExternal = true;
	Graph.Pass("A", {Read("X")});
	EXPECT_EQ("2021", Errors(Graph));
}

TEST(Validate, NeverCullOrAnOutputOutsideExcusesIt)
{
	FDescribedGraph Graph;
	Graph.Resource("X").bExternal = true;
	Graph.Pass("A", {Read("X")}, ERDGPassFlags::Compute | ERDGPassFlags::NeverCull);
	Graph.Pass("B", {Read("X")}).bHasExternalOutputs = true;
	EXPECT_EQ("", Errors(Graph));
}

TEST(Validate, ARasterPassNeedsTargetSlots)
{
	FDescribedGraph Graph;
	Graph.RasterPass("A", "X", ERenderTargetLoadAction::EClear).bHasTargetSlots = false;
	EXPECT_EQ("2022", Errors(Graph));
}

TEST(Validate, SkipRenderPassNeedsNoTargetSlots)
{
	FDescribedGraph Graph;
	FRDGPassDescription& Pass = Graph.RasterPass("A", "X", ERenderTargetLoadAction::EClear);
	Pass.bHasTargetSlots = false;
	Pass.Flags |= ERDGPassFlags::SkipRenderPass;
	EXPECT_EQ("", Errors(Graph));
}

TEST(Validate, TargetSlotsAreForRasterPasses)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")}).bHasTargetSlots = true;
	EXPECT_EQ("2022", Errors(Graph));
}

TEST(Validate, TargetsMustBePacked)
{
	FDescribedGraph Graph;
	FRDGPassDescription& Pass = Graph.RasterPass("A", "X", ERenderTargetLoadAction::EClear);
	Pass.Targets.Colors.insert(Pass.Targets.Colors.begin(), FRDGTarget());
	EXPECT_EQ("2023", Errors(Graph));
}

TEST(Validate, AResolveTargetNeedsATarget)
{
	FDescribedGraph Graph;
	FRDGPassDescription& Pass = Graph.RasterPass("A", "X", ERenderTargetLoadAction::EClear);
	FRDGTarget Resolve;
	Resolve.ResolveResource = 0;
	Pass.Targets.Colors.push_back(Resolve);
	EXPECT_EQ("2023", Errors(Graph));
	EXPECT_THAT(ValidateGraph(Graph.Get(), false).Errors[0].Message, HasSubstr("resolve target"));
}

TEST(Validate, ADepthTargetNeedsItsFlag)
{
	FDescribedGraph Graph;
	FRDGPassDescription& Pass = Graph.RasterPass("A", "X", ERenderTargetLoadAction::EClear);
	Pass.Targets.DepthStencil = Graph.GetIndex("D");
	EXPECT_EQ("2023", Errors(Graph));
	Graph.Resource("D").TextureFlags |= TexCreate_DepthStencilTargetable;
	EXPECT_EQ("", Errors(Graph));
}

TEST(Validate, ADepthTargetHasOneMip)
{
	FDescribedGraph Graph;
	Graph.RasterPass("A", "X", ERenderTargetLoadAction::EClear).Targets.DepthStencil = 1;
	Graph.Resource("D").TextureFlags |= TexCreate_DepthStencilTargetable;
	Graph.Resource("D").NumMips = 2;
	EXPECT_EQ("2023", Errors(Graph));
}

TEST(Validate, ATargetWithoutRenderTargetableIsAnEnsure)
{
	FDescribedGraph Graph;
	Graph.RasterPass("A", "X", ERenderTargetLoadAction::EClear);
	Graph.Resource("X").TextureFlags = TexCreate_ShaderResource;
	EXPECT_EQ("", Errors(Graph));
	EXPECT_EQ("2041", Ensures(Graph));
}

TEST(Validate, AReadOfWhatWasNeverWrittenIsAnEnsure)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Read("X"), Write("Y")});
	EXPECT_EQ("", Errors(Graph));
	EXPECT_EQ("2040", Ensures(Graph));
}

TEST(Validate, AWriterThatComesLaterDoesNotCount)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Read("X"), Write("Y")});
	Graph.Pass("B", {Write("X")});
	EXPECT_EQ("2040", Ensures(Graph));
}

TEST(Validate, ExternalAndUploadedResourcesAreWritten)
{
	FDescribedGraph Graph;
	Graph.Resource("X").bExternal = true;
	Graph.Resource("U").bUploaded = true;
	Graph.Pass("A", {Read("X"), Read("U"), Write("Y")});
	EXPECT_EQ("", Ensures(Graph));
}

TEST(Validate, LoadingATargetThatWasNeverWrittenIsAnEnsure)
{
	FDescribedGraph Graph;
	Graph.RasterPass("A", "X", ERenderTargetLoadAction::ELoad);
	EXPECT_EQ("2040", Ensures(Graph));
}

TEST(Validate, ClearingItIsNot)
{
	FDescribedGraph Graph;
	Graph.RasterPass("A", "X", ERenderTargetLoadAction::EClear);
	EXPECT_EQ("", Ensures(Graph));
}

TEST(Validate, ACopyAccessNeedsTheCopyFlag)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {{"X", ERHIAccess::CopyDest}});
	EXPECT_EQ("2024", Errors(Graph));
}

TEST(Validate, AGraphicsAccessNeedsTheRasterFlag)
{
	FDescribedGraph Graph;
	Graph.Resource("X").bExternal = true;
	Graph.Pass("A", {{"X", ERHIAccess::SRVGraphics}, Write("Y")});
	EXPECT_EQ("2024", Errors(Graph));
}

TEST(Validate, AnAccessForBothKindsSuitsEither)
{
	FDescribedGraph Graph;
	Graph.Resource("X").bExternal = true;
	Graph.Pass("A", {{"X", ERHIAccess::SRVMask}, Write("Y")});
	EXPECT_EQ("", Errors(Graph));
}

TEST(Validate, ReadingAndWritingOneSubresourceIsAHazard)
{
	FDescribedGraph Graph;
	Graph.Resource("X").bExternal = true;
	Graph.Pass("A", {Read("X"), Write("X")});
	EXPECT_EQ("2025", Errors(Graph));
	EXPECT_THAT(ValidateGraph(Graph.Get(), false).Errors[0].Message, HasSubstr("SRVCompute"));
	EXPECT_THAT(ValidateGraph(Graph.Get(), false).Errors[0].Message, HasSubstr("UAVCompute"));
}

TEST(Validate, ReadingAndRenderingOneSubresourceIsAWarningAndStrictlyAnError)
{
	FDescribedGraph Graph;
	Graph.Resource("X").bExternal = true;
	Graph.RasterPass("A", "X", ERenderTargetLoadAction::ELoad, {{"X", ERHIAccess::SRVGraphics}});
	EXPECT_EQ("", Errors(Graph));
	EXPECT_EQ("2054", Warnings(Graph, false));
	const FDiagnostic Warning = ValidateGraph(Graph.Get(), false).Warnings[0];
	EXPECT_THAT(Warning.Message, HasSubstr("undefined"));
	EXPECT_THAT(Warning.Where, HasSubstr("resource X"));
	EXPECT_EQ("2025", GetCodes(ValidateGraph(Graph.Get(), false, true).Errors));
	EXPECT_EQ("", GetCodes(ValidateGraph(Graph.Get(), false, true).Warnings));
}

TEST(Validate, OneMipReadAnotherWrittenIsNone)
{
	FDescribedGraph Graph;
	Graph.Resource("X").bExternal = true;
	Graph.Resource("X").NumMips = 2;
	Graph.Pass("A", {ReadMip("X", 0), WriteMip("X", 1)});
	EXPECT_EQ("", Errors(Graph));
}

TEST(Validate, TwoReadsOfOneSubresourceAreNone)
{
	FDescribedGraph Graph;
	Graph.Resource("X").bExternal = true;
	Graph.Pass("A", {Read("X"), {"X", ERHIAccess::CopySrc}, Write("Y")}, ERDGPassFlags::Compute | ERDGPassFlags::Copy);
	EXPECT_EQ("", Errors(Graph));
}

TEST(Validate, SkipTrackingIsReadOnly)
{
	FDescribedGraph Graph;
	Graph.Resource("X").bExternal = true;
	Graph.Resource("X").bSkipTracking = true;
	Graph.Pass("A", {Write("X")});
	EXPECT_EQ("2026", Errors(Graph));
}

TEST(Validate, SamplingATextureThatIsOnlyAUAVIsAWarning)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	Graph.Pass("B", {Read("X"), Write("Y")});
	Graph.Resource("X").TextureFlags = TexCreate_UAV;
	EXPECT_EQ("", Errors(Graph));
	EXPECT_EQ("2050", Warnings(Graph));
}

TEST(Validate, TexturesThatLackOneFlagAreOneWarningOfEachOwner)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X"), Write("Y"), Write("Z")});
	Graph.Pass("B", {Read("X"), Read("Y"), Write("V")});
	Graph.Pass("C", {Read("X"), Read("Z"), Write("W")});
	Graph.Pass("D", {Read("Z")}).Owner = "Other";
	for (const char* Name : {"X", "Y", "Z"})
	{
		Graph.Resource(Name).TextureFlags = TexCreate_UAV;
	}
	const std::vector<FDiagnostic> Found = ValidateGraph(Graph.Get(), false).Warnings;
	ASSERT_EQ("2050 2050", GetCodes(Found));
	EXPECT_EQ("pass B, parameter XParameter, resource X", Found[0].Where);
	EXPECT_EQ("the texture is read by a shader but was created without TexCreate_ShaderResource; 2 more lack it: Y, Z",
		Found[0].Message);
	EXPECT_EQ("Other, pass D, parameter ZParameter, resource Z", Found[1].Where);
	EXPECT_EQ("the texture is read by a shader but was created without TexCreate_ShaderResource", Found[1].Message);
}

TEST(Validate, AnUnusedOutputIsAWarningOfDebuggingOnly)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	Graph.Resource("X").TextureFlags = TexCreate_UAV;
	EXPECT_EQ("", Warnings(Graph));
	EXPECT_EQ("2051", Warnings(Graph, true));
	Graph.Resource("X").bSkipUnusedWarning = true;
	EXPECT_EQ("", Warnings(Graph, true));
}

TEST(Validate, AnUnusedFlagIsAWarningOfDebuggingOnly)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")});
	Graph.Pass("B", {Read("X"), {"Y", ERHIAccess::UAVCompute}});
	Graph.Resource("Y").bExtracted = true;
	Graph.Resource("Y").TextureFlags = TexCreate_UAV;
	EXPECT_EQ("2052", Warnings(Graph, true)); // X is RenderTargetable
}

TEST(Validate, EverythingIsCollected)
{
	FDescribedGraph Graph;
	Graph.Pass("A", {Write("X")}, ERDGPassFlags::Compute | ERDGPassFlags::AsyncCompute);
	Graph.Pass("B", {Read("X"), Write("X")});
	Graph.Pass("C", {Read("X")});
	EXPECT_EQ("2020 2025 2021", Errors(Graph));
}

TEST(Validate, AMessageNamesPassParameterResourceAndLine)
{
	FDescribedGraph Graph;
	Graph.Pass("Blur", {Read("Scene"), Write("Y")});
	const FDiagnostic Diagnostic = ValidateGraph(Graph.Get(), false).Ensures[0];
	EXPECT_EQ("pass Blur, parameter SceneParameter, resource Scene", Diagnostic.Where);
	EXPECT_EQ("Test.cpp", Diagnostic.File);
	EXPECT_EQ(101, Diagnostic.Line);
}
