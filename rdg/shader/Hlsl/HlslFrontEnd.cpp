// Runs the phases of the front end in a row; what each finds wrong becomes one error.
#include "HlslFrontEnd.h"

#include "HlslEmitter.h"
#include "HlslParser.h"

#include <algorithm>

namespace Drydock::Hlsl
{

namespace
{

constexpr const char* FrontEndRealHalf = "__HLSL_ENABLE_16_BIT";
constexpr const char* FrontEndVersion = "__HLSL_VERSION";

void ThrowFrontEndErrors(std::vector<FDiagnostic> Errors)
{
	if (!Errors.empty())
	{
		throw FError(std::move(Errors), ExitUsage);
	}
}

} // namespace

FAnalysis Read(const std::string& Text, const FShaderCompileRequest& Request)
{
	std::vector<FDiagnostic> Errors;
	const auto Tree = std::make_shared<const FTree>(Parse(Text, Request.VirtualPath, Errors));
	ThrowFrontEndErrors(std::move(Errors));

	FAnalysisOptions Options;
	Options.EntryPoint = Request.EntryPoint;
	Options.Stage = Request.Stage == EShaderStage::Pixel    ? EStage::Pixel
					: Request.Stage == EShaderStage::Vertex ? EStage::Vertex
															: EStage::Compute;
	for (const auto& [Name, Value] : Request.Defines)
	{
		Options.bRealHalf = Options.bRealHalf || (Name == FrontEndRealHalf && Value != "0");
		Options.bFxcRules = Options.bFxcRules || (Name == FxcRulesDefine && Value != "0");
		Options.bFloatLiterals = Options.bFloatLiterals || (Name == FrontEndVersion && Value > "2021");
	}
	Options.VirtualPath = Request.VirtualPath;
	Options.bAllLoose = true;
	for (const FShaderUniformBuffer& Buffer : Request.UniformBuffers)
	{
		Options.UniformBuffers.emplace_back(Buffer.Name, Buffer.Members);
	}
	FAnalysis Analysis = Analyse(*Tree, Options);
	ThrowFrontEndErrors(std::move(Analysis.Errors));
	Analysis.Tree = Tree;
	return Analysis;
}

std::vector<uint32_t> Compile(const std::string& Text, const FShaderCompileRequest& Request)
{
	const FAnalysis Analysis = Read(Text, Request);
	const FEmission Emission = Emit(*Analysis.Program);
	if (!Emission.Error.empty())
	{
		throw FError({MakeError(Analysis.Program->Files, Emission.Place, Emission.Error)}, ExitUsage);
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

} // namespace Drydock::Hlsl
