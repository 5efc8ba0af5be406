// Reads messages as FDiagnostic writes them, and run.json.
#include "Matrix/MatrixRunReport.h"

#include "Patch/LogLines.h"
#include "RangeTools.h"
#include "Text/Json.h"
#include "TextTools.h"

#include <regex>

namespace Drydock
{

namespace
{

/** The number of "DD2070"; 0: it is none. */
int ParseCode(const std::string& Text)
{
	return Text.size() == 6 && Text.starts_with("DD") ? std::atoi(Text.c_str() + 2) : 0;
}

/** "configs/a.json:12:7: error DD1012 at /volumes/0: text", or a shader's line "X.usf:12: error: text [DD6010]". */
bool ReadError(const std::string& WholeLine, FMatrixMessage& OutMessage)
{
	static const std::regex Plain("^(?:(.*?):(?:(\\d+):)?(?:\\d+:)? )?error (DD\\d{4})(?: at (.*?))?: (.*)$");
	static const std::regex Shader("^(.*?):(\\d+): error: (.*) \\[(DD\\d{4})\\]$");
	const std::string Line = CutLine(WholeLine);
	std::smatch Match;
	const auto GetLine = [&Match]
	{
		return ReadLineNumber(Match[2]);
	};
	if (std::regex_match(Line, Match, Shader))
	{
		OutMessage = {ParseCode(Match[4]), Match[1], GetLine(), "", Match[3]};
		return true;
	}
	if (std::regex_match(Line, Match, Plain))
	{
		OutMessage = {ParseCode(Match[3]), Match[1], GetLine(), Match[4], Match[5]};
		return true;
	}
	return false;
}

std::vector<FMatrixPass> ReadPasses(const FJsonValue& Root)
{
	std::vector<FMatrixPass> Passes;
	for (const FJsonValue& Value : Root.GetElements("passes"))
	{
		const FJsonValue* const Executed = Value.Find("executed");
		FMatrixPass Pass{.Name = Value.GetString("name"),
			.bExecuted = Executed != nullptr && Executed->Bool,
			.Shader = Value.GetString("shader")};
		if (const FJsonValue* const Written = Value.Find("written"))
		{
			for (const FJsonMember& Texture : Written->Members)
			{
				Pass.Written.emplace_back(Texture.Key, Texture.Value.String);
			}
		}
		Passes.push_back(std::move(Pass));
	}
	return Passes;
}

} // namespace

FMatrixMessage FindFirstError(const std::string& Output)
{
	FMatrixMessage Message;
	for (const std::string& Line : SplitText(Output))
	{
		FMatrixMessage Found;
		if (ReadError(Line, Found))
		{
			return Found;
		}
		Message.Text = Line.empty() ? Message.Text : Line;
	}
	return Message;
}

FMatrixRun ReadMatrixRun(int ExitCode, const std::string& Output, const std::string& RunJson)
{
	FMatrixRun Run;
	Run.ExitCode = ExitCode;
	if (!Run.Ran())
	{
		Run.FirstError = FindFirstError(Output);
		return Run;
	}
	std::vector<FDiagnostic> Ignored;
	bool bSyntaxError = false;
	const FJsonValue Root = ParseJson(RunJson, "run.json", Ignored, bSyntaxError);
	for (const FJsonValue& Warning : Root.GetElements("warnings"))
	{
		if (Warning.GetString("severity") != "note")
		{
			Run.Warnings.push_back({.Code = ParseCode(Warning.GetString("code")),
				.Where = Warning.GetString("where"),
				.Text = Warning.GetString("message")});
		}
	}
	for (const FJsonValue& Call : Root.GetElements("extensionCalls"))
	{
		const std::string Extension = Call.GetString("extension");
		AddUnique(Run.Extensions, Extension);
	}
	Run.Passes = ReadPasses(Root);
	return Run;
}

} // namespace Drydock
