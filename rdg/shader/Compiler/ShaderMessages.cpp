// Looks up the lines that messages are about.
#include "ShaderMessages.h"

#include "HlslTokens.h"
#include "LeftOutStages.h"
#include "RegularFile.h"
#include "ShaderDirectories.h"
#include "ShaderSource.h"
#include "SpirvFile.h"
#include "TextTools.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

namespace Drydock
{

namespace
{

constexpr size_t MaxShown = 8;        // errors with their line
constexpr size_t MaxLineLength = 200; // of one that is shown
constexpr int MaxListedLines = 5;

/** Functions of HLSL that a name may have meant. Source: Microsoft, "Intrinsic functions" of HLSL. */
const std::vector<std::string> Intrinsics = {"abs", "acos", "all", "any", "asfloat", "asin", "asint", "asuint", "atan",
	"atan2", "ceil", "clamp", "clip", "cos", "cosh", "countbits", "cross", "ddx", "ddy", "degrees", "determinant",
	"distance", "dot", "exp", "exp2", "faceforward", "firstbithigh", "firstbitlow", "floor", "fmod", "frac", "frexp",
	"fwidth", "isfinite", "isinf", "isnan", "ldexp", "length", "lerp", "log", "log10", "log2", "mad", "max", "min",
	"modf", "mul", "normalize", "pow", "radians", "rcp", "reflect", "refract", "reversebits", "round", "rsqrt",
	"saturate", "sign", "sin", "sincos", "sinh", "smoothstep", "sqrt", "step", "tan", "tanh", "transpose", "trunc",
	"GroupMemoryBarrierWithGroupSync", "InterlockedAdd", "InterlockedAnd", "InterlockedExchange", "InterlockedMax",
	"InterlockedMin", "InterlockedOr"};

/** The text between the first two quotes. */
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

/** And of what is declared: the second of two words that follow each other. */
std::vector<std::string> ListDeclared(const FHlslText& Text)
{
	static const std::set<std::string> Statements = {"return", "else", "case", "goto", "do"};
	std::vector<std::string> Names;
	for (size_t At = 1; At < Text.Size(); ++At)
	{
		const bool bType = Text.IsWord(At - 1) || Text.Is(At - 1, ">");
		if (Text.IsWord(At) && bType && !Statements.count(Text[At - 1].Text) && !Text.Is(At + 1, "("))
		{
			Names.push_back(Text[At].Text);
		}
	}
	return Names;
}

/** The file among those mapped that declares a function; empty when none does. */
std::string FindDeclaringFile(const std::string& Function)
{
	namespace fs = std::filesystem;
	std::set<std::string> Found; // the first by name, whatever the order on disk
	for (const FShaderDirectory& Directory : GetShaderDirectories())
	{
		std::error_code Error;
		for (fs::recursive_directory_iterator It(Directory.Real, Error), End; !Error && It != End; It.increment(Error))
		{
			std::error_code Ignored;
			const std::string Text = It->path().extension() == ".ush" && It->is_regular_file(Ignored)
										 ? ReadRegularFile(It->path().string()).Bytes.value_or("")
										 : std::string();
			if (Text.find(Function + "(") == std::string::npos)
			{
				continue;
			}
			const std::string Virtual =
				Directory.Virtual + "/" + It->path().lexically_relative(Directory.Real).generic_string();
			const std::vector<std::string> Functions = ListFunctions(FHlslText(NormalizeShaderText(Text), Virtual));
			if (std::ranges::find(Functions, Function) != Functions.end())
			{
				Found.insert(Virtual);
			}
		}
	}
	return Found.empty() ? std::string() : *Found.begin();
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
			if (!Follows(Each, Result) && !Join(Each, Result))
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
	/** The one message with the reason, if a line with errors uses something that is left out: all other errors of the
	 * front end follow from it. */
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

	/** Whether Error is about an operator, or nothing that has a name, in a line that had an error before: it comes
	 * from that. */
	static bool Follows(const FDiagnostic& Error, const std::vector<FDiagnostic>& Earlier)
	{
		const std::string Thing = GetQuoted(Error.Message);
		const bool bNamed = !Thing.empty() && (std::isalpha(static_cast<unsigned char>(Thing[0])) || Thing[0] == '_');
		return Error.Code == 6010 && Error.Line > 0 && !bNamed && Error.Message.starts_with('\'') &&
			   std::ranges::any_of(Earlier, [&Error](const FDiagnostic& Each)
				   { return Each.Code == 6010 && Each.File == Error.File && Each.Line == Error.Line; });
	}

	/** Whether Error says of another line what one of Earlier said: a name that is not there. */
	bool Join(const FDiagnostic& Error, const std::vector<FDiagnostic>& Earlier)
	{
		const bool bUnknown =
			Error.Code == 6010 && Error.Line > 0 && Error.Message.find("unknown variable") != std::string::npos;
		const auto Same = std::ranges::find_if(
			Earlier, [&](const FDiagnostic& Each) { return bUnknown && Each.Message == Error.Message; });
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
			const bool bMember = Behind != std::string::npos && Line[Behind] == '.';
			if (!bMember || IsOfValue(Line, Behind))
			{
				SuggestDeclared(Error, Name);
			}
			else
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
		else if (Error.Code == 6010 && Error.Message.find("no matching overloaded function") != std::string::npos)
		{
			SuggestFunction(Error, Name);
		}
		else if (const size_t None = Error.Message.find(": there is no such function");
				 Error.Code == 6010 && None != std::string::npos)
		{
			if (const std::string File = FindDeclaringFile(Name); !File.empty())
			{
				Error.Message.resize(None);
				Error.Message += "; it is declared in " + File + ", which is not included";
			}
		}
		else if (Error.Code == 6011 && !IsSpirvFile(Request.VirtualPath) &&
				 Error.Message.find("did you mean") == std::string::npos)
		{
			Error.Message += SuggestName(Request.EntryPoint, ListFunctions(Flatten()));
		}
	}

	/** Whether a call or components follow behind the point: members of a value, not of a uniform buffer. */
	static bool IsOfValue(const std::string& Line, size_t Point)
	{
		const size_t First = std::min(Line.find_first_not_of(" \t", Point + 1), Line.size());
		size_t End = First;
		while (End < Line.size() && IsWordCharacter(Line[End]))
		{
			++End;
		}
		const std::string Member = Line.substr(First, End - First);
		const size_t Next = Line.find_first_not_of(" \t", End);
		const bool bCall = Next != std::string::npos && Line[Next] == '(';
		return bCall || (Member.size() <= 4 && Member.find_first_not_of("xyzwrgba") == std::string::npos);
	}

	void SuggestDeclared(FDiagnostic& Error, const std::string& Name)
	{
		const std::string Nearest = FindNearestName(Name, ListDeclared(Flatten()));
		Error.Message += Nearest.empty() || Nearest == Name ? std::string() : "; did you mean " + Nearest + "?";
	}

	/** A function of that name that is elsewhere, or one of a similar name that is here. */
	void SuggestFunction(FDiagnostic& Error, const std::string& Name)
	{
		std::vector<std::string> Functions = ListFunctions(Flatten());
		Functions.insert(Functions.end(), Intrinsics.begin(), Intrinsics.end());
		if (std::ranges::find(Functions, Name) != Functions.end())
		{
			return; // it is there, with other arguments
		}
		const std::string File = FindDeclaringFile(Name);
		const std::string Nearest = File.empty() ? FindNearestName(Name, Functions) : std::string();
		Error.Message += !File.empty()      ? "; it is declared in " + File + ", which is not included"
						 : !Nearest.empty() ? "; did you mean " + Nearest + "?"
											: std::string();
	}

	FHlslText Flatten() const { return FHlslText(FlattenShader(Request).Text, Request.VirtualPath); }

	/** Empty where there is no such line. */
	std::string GetLine(const std::string& File, int Line)
	{
		const auto [Known, bNew] = Texts.emplace(File, std::vector<std::string>());
		if (bNew)
		{
			Known->second = SplitText(ReadShaderText(File, Request));
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
