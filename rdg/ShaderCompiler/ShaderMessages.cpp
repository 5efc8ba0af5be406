// Looks up the lines that messages are about.
#include "ShaderMessages.h"

#include "HlslTokens.h"
#include "LeftOutStages.h"
#include "RegularFile.h"
#include "ShaderDirectories.h"
#include "ShaderSource.h"
#include "SpirvFile.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <sstream>

namespace Drydock
{

namespace
{

constexpr size_t MaxShown = 8;        // errors with their line
constexpr size_t MaxLineLength = 200; // of one that is shown
constexpr int MaxListedLines = 5;

/** What stands between the first two quotes. */
std::string GetQuoted(const std::string& Message)
{
	const size_t Open = Message.find('\'');
	const size_t Close = Open == std::string::npos ? Open : Message.find('\'', Open + 1);
	return Close == std::string::npos ? std::string() : Message.substr(Open + 1, Close - Open - 1);
}

/** Names of what is declared with a parenthesis outside of all braces. */
std::vector<std::string> ListFunctions(const FHlslText& Text)
{
	std::vector<std::string> Names;
	for (size_t At = 1; At < Text.Size(); ++At)
	{
		if (Text.IsWord(At) && Text.Is(At + 1, "(") && Text.IsWord(At - 1))
		{
			Names.push_back(Text[At].Text);
		}
		At = std::max(At, Text.FindClose(At));
	}
	return Names;
}

class FExplainer
{
public:
	explicit FExplainer(const FShaderCompileRequest& InRequest)
		: Request(InRequest)
	{
	}

	FError Run(const FError& Error)
	{
		if (std::optional<FDiagnostic> LeftOut = FindLeftOut(Error))
		{
			Show(*LeftOut);
			return FError(*LeftOut, Error.GetExitCode());
		}
		std::vector<FDiagnostic> Result;
		for (const FDiagnostic& Each : Error.GetDiagnostics())
		{
			if (!Join(Each, Result))
			{
				Result.push_back(Each);
			}
		}
		for (size_t i = 0; i < Result.size(); ++i)
		{
			const auto Lines = OtherLines.find(i);
			Explain(Result[i]);
			Result[i].Message += Lines == OtherLines.end() ? std::string() : Lines->second + ")";
			if (i < MaxShown)
			{
				Show(Result[i]);
			}
		}
		return FError(std::move(Result), Error.GetExitCode());
	}

private:
	/** The one message that says why, where a line with errors has words of what is left out: whatever else the front
	 * end says comes from that. */
	std::optional<FDiagnostic> FindLeftOut(const FError& Error)
	{
		for (const FDiagnostic& Each : Error.GetDiagnostics())
		{
			const std::string Line = Each.Code / 10 == 601 || Each.Code == 6020 ? GetLine(Each.File, Each.Line) : "";
			if (const std::string Message = ExplainLeftOut(Line); !Message.empty())
			{
				return FDiagnostic{ESeverity::Error, 6020, Message, Each.File, Each.Line, Each.Column, Each.Where};
			}
		}
		return std::nullopt;
	}

	/** Whether Error says of another line what one of Earlier said: a name that is not there. */
	bool Join(const FDiagnostic& Error, const std::vector<FDiagnostic>& Earlier)
	{
		const bool bUnknown =
			Error.Code == 6010 && Error.Line > 0 && Error.Message.find("unknown variable") != std::string::npos;
		const auto Same = std::find_if(Earlier.begin(), Earlier.end(),
			[&](const FDiagnostic& Each) { return bUnknown && Each.Message == Error.Message; });
		if (Same == Earlier.end())
		{
			return false;
		}
		const size_t Index = size_t(Same - Earlier.begin());
		const int Count = ++NumOthers[Index];
		std::string& Lines = OtherLines[Index];
		Lines += Lines.empty() ? " (also in line " : Count <= MaxListedLines ? ", " : "";
		Lines += Count <= MaxListedLines ? std::to_string(Error.Line) : Count == MaxListedLines + 1 ? ", ..." : "";
		return true;
	}

	void Explain(FDiagnostic& Error)
	{
		const std::string Name = GetQuoted(Error.Message);
		if (Error.Code == 6010 && Error.Message.find("unknown variable") != std::string::npos)
		{
			const std::string Line = GetLine(Error.File, Error.Line);
			const size_t At = FindWord(Line, Name);
			const size_t Behind = At == std::string::npos ? At : Line.find_first_not_of(" \t", At + Name.size());
			if (Behind != std::string::npos && Line[Behind] == '.')
			{
				std::vector<std::string> Known;
				std::string List;
				for (const FShaderUniformBuffer& Buffer : Request.UniformBuffers)
				{
					Known.push_back(Buffer.Name);
					List += (List.empty() ? "" : ", ") + Buffer.Name;
				}
				const std::string Nearest = FindNearestName(Name, Known);
				Error.Message += ", and no uniform buffer of that name is registered" +
								 (Nearest.empty() ? std::string() : "; did you mean " + Nearest + "?") +
								 (List.empty() || !Nearest.empty() ? std::string() : "; there are " + List);
			}
		}
		else if (Error.Code == 6011 && !IsSpirvFile(Request.VirtualPath))
		{
			const FShaderSource Source = FlattenShader(Request);
			const std::string Nearest =
				FindNearestName(Request.EntryPoint, ListFunctions(FHlslText(Source.Text, Request.VirtualPath)));
			Error.Message += Nearest.empty() ? std::string() : "; did you mean " + Nearest + "?";
		}
	}

	/** Empty where there is no such line. */
	std::string GetLine(const std::string& File, int Line)
	{
		const auto [Known, bNew] = Texts.emplace(File, std::vector<std::string>());
		if (bNew)
		{
			const auto Generated = std::find_if(Request.GeneratedFiles.begin(), Request.GeneratedFiles.end(),
				[&](const std::pair<std::string, std::string>& Each) { return Each.first == File; });
			const std::string Real = FindShaderFile(File);
			const std::string Bytes = Generated != Request.GeneratedFiles.end() ? Generated->second
									  : Real.empty()                            ? std::string()
													 : ReadRegularFile(Real).Bytes.value_or("");
			std::istringstream Stream(NormalizeShaderText(Bytes));
			for (std::string Text; std::getline(Stream, Text);)
			{
				Known->second.push_back(Text);
			}
		}
		const bool bThere = Line > 0 && size_t(Line) <= Known->second.size();
		return bThere ? Known->second[size_t(Line) - 1] : std::string();
	}

	void Show(FDiagnostic& Error)
	{
		const std::string Line = Error.Line > 0 ? GetLine(Error.File, Error.Line) : std::string();
		const size_t First = Line.find_first_not_of(" \t");
		if (First == std::string::npos || Line.size() > MaxLineLength)
		{
			return;
		}
		const size_t Found = FindWord(Line, GetQuoted(Error.Message));
		const size_t Column = Error.Column > 0 && size_t(Error.Column) <= Line.size() ? size_t(Error.Column) - 1
							  : Found != std::string::npos                            ? Found
																					  : First;
		std::string Caret = Line.substr(0, Column); // tabs stay tabs, so that the caret stands below its letter
		std::replace_if(
			Caret.begin(), Caret.end(), [](char c) { return c != '\t'; }, ' ');
		const std::string Number = std::to_string(Error.Line);
		Error.Message +=
			"\n  " + Number + " | " + Line + "\n  " + std::string(Number.size(), ' ') + " | " + Caret + "^";
		if (const std::string Real = FindShaderFile(Error.File); !Real.empty())
		{
			Error.Message += "\n  " + Real + ":" + Number + ":" + std::to_string(Column + 1);
		}
	}

	const FShaderCompileRequest& Request;
	std::map<std::string, std::vector<std::string>> Texts; // lines by virtual path
	std::map<size_t, std::string> OtherLines;              // of joined errors
	std::map<size_t, int> NumOthers;
};

} // namespace

FError ExplainShaderErrors(const FError& Error, const FShaderCompileRequest& Request)
{
	return FExplainer(Request).Run(Error);
}

} // namespace Drydock
