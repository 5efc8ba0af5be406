// What the tests of the analysis share: small compute shaders, and the program that comes of one as text.
#pragma once

#include "ProgramPrinter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace Drydock::Hlsl
{

/** What a text comes to: the program, or the messages. */
struct FAnalysedText
{
	std::string Program;
	std::string Messages; // "LINE:COLUMN: text", those of warnings with "warning" before the text
};

inline FAnalysedText AnalyseText(
	const std::string& Text, EStage Stage = EStage::Compute, const std::string& Entry = "Main")
{
	std::vector<FDiagnostic> Errors;
	const FTree Tree = Parse(Text, "/Test.usf", Errors);
	FAnalysisOptions Options;
	Options.EntryPoint = Entry;
	Options.Stage = Stage;
	Options.VirtualPath = "/Test.usf";
	Options.UniformBuffers = {{"View", {"PreExposure"}}};
	FAnalysis Analysis;
	if (Errors.empty())
	{
		Analysis = Analyse(Tree, Options);
	}
	Errors.insert(Errors.end(), Analysis.Errors.begin(), Analysis.Errors.end());
	Errors.insert(Errors.end(), Analysis.Warnings.begin(), Analysis.Warnings.end());
	FAnalysedText Result;
	for (const FDiagnostic& Error : Errors)
	{
		Result.Messages += (Result.Messages.empty() ? "" : "\n") + std::to_string(Error.Line) + ":" +
						   std::to_string(Error.Column) + ": " +
						   (Error.Severity == ESeverity::Warning ? "warning " : "") + Error.Message;
	}
	Result.Program = Analysis.Program ? FProgramPrinter(*Analysis.Program).Print() : "";
	return Result;
}

/** The text of the messages' line numbers: Before stands in line 8, Body from line 12 on. */
inline std::string MakeComputeText(const std::string& Before, const std::string& Body)
{
	return "//\nRWStructuredBuffer<float4> Out;\nRWTexture2D<float4> RW;\nTexture2D<float4> T;\nSamplerState S;\n"
		   "float Weight;\nfloat View_PreExposure;\n" +
		   Before + "\n[numthreads(1, 1, 1)]\nvoid Main(uint2 P : SV_DispatchThreadID)\n{\n\t" + Body + "\n}\n";
}

/** Lines of the program without its usual resources and the head of the entry. */
inline void ExpectMain(const std::string& Before, const std::string& Body, const std::string& Expected)
{
	const FAnalysedText Result = AnalyseText(MakeComputeText(Before, Body));
	std::string Program;
	size_t At = 0;
	while (At < Result.Program.size())
	{
		const size_t End = Result.Program.find('\n', At);
		const std::string Line = Result.Program.substr(At, End - At);
		const bool bUsual = Line.starts_with("void Main(") ||
							(Line.starts_with("resource ") && (Line.ends_with(" Out") || Line.ends_with(" RW") ||
																  Line.ends_with(" T") || Line.ends_with(" S")));
		Program += bUsual ? "" : Line + "\n";
		At = End + 1;
	}
	EXPECT_EQ(Program, Expected) << Result.Messages;
}

} // namespace Drydock::Hlsl
