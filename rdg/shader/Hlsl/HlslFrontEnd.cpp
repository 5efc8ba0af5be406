// Runs the phases of the front end in a row; what each finds wrong becomes one error.
#include "HlslFrontEnd.h"

#include "HlslEmitter.h"
#include "HlslParser.h"
#include "HlslPartialStores.h"

#include <algorithm>

namespace Drydock::Hlsl
{

namespace
{

constexpr const char* FrontEndRealHalf = "__HLSL_ENABLE_16_BIT";

void ThrowFrontEndErrors(std::vector<FDiagnostic> Errors)
{
	if (!Errors.empty())
	{
		throw FError(std::move(Errors), ExitUsage);
	}
}

FAnalysis AnalyseRequest(const FTree& Tree, const FShaderCompileRequest& Request)
{
	FAnalysisOptions Options;
	Options.EntryPoint = Request.EntryPoint;
	Options.Stage = Request.Stage == EShaderStage::Pixel    ? EStage::Pixel
					: Request.Stage == EShaderStage::Vertex ? EStage::Vertex
															: EStage::Compute;
	Options.bRealHalf = std::ranges::any_of(
		Request.Defines, [](const auto& Define) { return Define.first == FrontEndRealHalf && Define.second != "0"; });
	Options.VirtualPath = Request.VirtualPath;
	Options.bAllLoose = true;
	for (const FShaderUniformBuffer& Buffer : Request.UniformBuffers)
	{
		Options.UniformBuffers.emplace_back(Buffer.Name, Buffer.Members);
	}
	return Analyse(Tree, Options);
}

} // namespace

std::vector<uint32_t> Compile(const std::string& Text, const FShaderCompileRequest& Request)
{
	std::vector<FDiagnostic> Errors;
	const FTree Tree = Parse(Text, Request.VirtualPath, Errors);
	ThrowFrontEndErrors(std::move(Errors));

	const FAnalysis Analysis = AnalyseRequest(Tree, Request);
	ThrowFrontEndErrors(Analysis.Errors);

	const FEmission Emission = Emit(*Analysis.Program);
	if (!Emission.Error.empty())
	{
		throw FError({MakeError(Tree.Files, Emission.Place, Emission.Error)}, ExitUsage);
	}
	if (Request.bKeepFunctions)
	{
		return Emission.Words;
	}
	std::string Fault;
	std::vector<uint32_t> Words = Optimise(Emission.Words, Fault);
	if (!Fault.empty())
	{
		FDiagnostic Error{
			ESeverity::Error, 6010, Fault, Request.VirtualPath, 0, 0, "entry point " + Request.EntryPoint};
		ThrowFrontEndErrors({Error});
	}
	return Words;
}

std::vector<FDiagnostic> FindWarnings(const std::string& Text, const FShaderCompileRequest& Request)
{
	std::vector<FDiagnostic> Errors;
	const FTree Tree = Parse(Text, Request.VirtualPath, Errors);
	const FAnalysis Analysis = Errors.empty() ? AnalyseRequest(Tree, Request) : FAnalysis();
	return Analysis.Program ? Analysis.Warnings : std::vector<FDiagnostic>();
}

std::vector<std::pair<std::string, int>> FindPartialStores(
	const std::string& Text, const FShaderCompileRequest& Request)
{
	std::vector<FDiagnostic> Errors;
	const FTree Tree = Parse(Text, Request.VirtualPath, Errors);
	const FAnalysis Analysis = Errors.empty() ? AnalyseRequest(Tree, Request) : FAnalysis();
	std::vector<std::pair<std::string, int>> Result;
	for (const FPlace& Place : Analysis.Program ? ListPartialStores(*Analysis.Program) : std::vector<FPlace>())
	{
		Result.emplace_back(Tree.Files[Place.File], Place.Line);
	}
	return Result;
}

} // namespace Drydock::Hlsl
