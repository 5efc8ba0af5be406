// Finds entry points by their attributes and semantics, and cuts a text into what each of them needs.
#include "ShaderEntries.h"

#include "RegularFile.h"
#include "ShaderDirectories.h"
#include "ShaderSource.h"
#include "SpirvFile.h"
#include "TextTools.h"

#include <algorithm>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>

namespace Drydock
{

std::vector<FFunctionText> ListFunctionTexts(const FHlslText& Text)
{
	std::vector<FFunctionText> Functions;
	for (size_t At = 1; At < Text.Size(); ++At)
	{
		const bool bHead = Text.IsWord(At) && Text.Is(At + 1, "(") && Text.IsWord(At - 1);
		size_t Body = bHead ? Text.FindClose(At + 1) + 1 : Text.Size();
		while (bHead && Body < Text.Size() && !Text.Is(Body, "{") && !Text.Is(Body, ";"))
		{
			++Body; // a semantic
		}
		if (bHead && Text.Is(Body, "{"))
		{
			Functions.push_back({At, At + 1, Body});
			At = Text.FindClose(Body);
			continue;
		}
		At = std::max(At, Text.FindClose(At));
	}
	return Functions;
}

namespace
{

bool IsTarget(const std::string& Word)
{
	const std::string Lower = ToLowerCase(Word);
	return Lower.starts_with("sv_target") || Lower.starts_with("sv_depth");
}

bool IsPosition(const std::string& Word)
{
	return ToLowerCase(Word).starts_with("sv_position");
}

/** The names of structs that hold what a pixel shader writes, and of those that hold what it reads. */
struct FEntryStructs
{
	explicit FEntryStructs(const FHlslText& Text)
	{
		for (size_t At = 0; At + 2 < Text.Size(); ++At)
		{
			const size_t Close = Text.Is(At, "struct") && Text.Is(At + 2, "{") ? Text.FindClose(At + 2) : At;
			for (size_t Index = At + 2; Index < std::min(Close, Text.Size()); ++Index)
			{
				const std::string& Word = Text[Index].Text;
				for (auto& [Structs, bHas] :
					{std::pair(&Targets, IsTarget(Word)), std::pair(&Positions, IsPosition(Word))})
				{
					if (bHas || Structs->contains(Word))
					{
						Structs->insert(Text[At + 1].Text);
					}
				}
			}
		}
	}

	std::set<std::string> Targets;
	std::set<std::string> Positions;
};

/** A pixel shader without targets, which discards or writes by other ways: void, with a position and without outputs.
 */
bool TakesPosition(const FHlslText& Text, const FFunctionText& Function, const FEntryStructs& Structs)
{
	bool bPosition = false;
	bool bOut = !Text.Is(Function.Name - 1, "void");
	for (size_t At = Function.Name + 1; At < Function.Body; ++At)
	{
		bPosition = bPosition || IsPosition(Text[At].Text) || Structs.Positions.contains(Text[At].Text);
		bOut = bOut || Text.Is(At, "out") || Text.Is(At, "inout");
	}
	return bPosition && !bOut;
}

/** The stage of an entry point; nothing for other functions. A function with a struct of targets, or with a position
 * alone, is an entry where nothing calls it. */
std::optional<EShaderStage> FindStage(
	const FHlslText& Text, const FFunctionText& Function, const FEntryStructs& Structs)
{
	const size_t Head = Function.Name - 1; // its type, behind the attributes
	const size_t Opens = Head >= 5 && Text.Is(Head - 1, "]") ? Head - 1 : 0;
	for (size_t At = Opens; At > 0 && !Text.Is(At, "}") && !Text.Is(At, ";"); --At)
	{
		if (Text[At].Text == "numthreads")
		{
			return EShaderStage::Compute;
		}
	}
	bool bStruct = false;
	for (size_t At = Head; At < Function.Body; ++At)
	{
		if (IsTarget(Text[At].Text))
		{
			return EShaderStage::Pixel;
		}
		bStruct = bStruct || Structs.Targets.contains(Text[At].Text);
	}
	bStruct = bStruct || TakesPosition(Text, Function, Structs);
	const bool bEntry = bStruct && std::ranges::count(Text.Tokens, Text[Function.Name].Text, &FHlslToken::Text) == 1;
	return bEntry ? std::optional(EShaderStage::Pixel) : std::nullopt;
}

} // namespace

std::vector<FShaderEntry> FindShaderEntries(const FShaderCompileRequest& Request)
{
	std::vector<FShaderEntry> Entries;
	if (IsSpirvFile(Request.VirtualPath))
	{
		const FFileBytes Read = ReadRegularFile(FindShaderFile(Request.VirtualPath));
		for (const auto& [Name, Stage] : ListSpirvEntries(Read.Bytes.value_or(""), Request))
		{
			Entries.push_back({Name, Stage});
		}
		return Entries;
	}
	const FHlslText Text(FlattenShader(Request).Text, Request.VirtualPath);
	const FEntryStructs Structs(Text);
	for (const FFunctionText& Function : ListFunctionTexts(Text))
	{
		if (const std::optional<EShaderStage> Stage = FindStage(Text, Function, Structs))
		{
			Entries.push_back({Text[Function.Name].Text, *Stage});
		}
	}
	return Entries;
}

FEntryTexts::FEntryTexts(const FShaderCompileRequest& Request)
{
	const FHlslText Text(FlattenShader(Request).Text, Request.VirtualPath);
	std::unordered_map<std::string, size_t> Mentions;
	for (const FHlslToken& Token : Text.Tokens)
	{
		++Mentions[Token.Text];
	}
	size_t Next = 0;
	const auto Add = [&](const std::string& Entry, size_t End)
	{
		FHlslText Part("", "");
		Part.Files = Text.Files;
		Part.Tokens.assign(Text.Tokens.begin() + ptrdiff_t(Next), Text.Tokens.begin() + ptrdiff_t(End));
		Parts.emplace_back(Entry, Part.Join());
		Next = End;
	};
	const FEntryStructs Structs(Text);
	for (const FFunctionText& Function : ListFunctionTexts(Text))
	{
		const std::string& Name = Text[Function.Name].Text;
		if (Mentions[Name] > 1 || !FindStage(Text, Function, Structs))
		{
			continue;
		}
		size_t First = Function.Name;
		while (First > Next && !Text.Is(First - 1, "}") && !Text.Is(First - 1, ";") && Text[First - 1].Text[0] != '#')
		{
			--First;
		}
		Add("", First);
		Add(Name, std::min(Text.FindClose(Function.Body) + 1, Text.Size()));
	}
	Add("", Text.Size());
}

std::string FEntryTexts::GetText(const std::string& Entry) const
{
	std::string Text;
	bool bFound = false;
	for (const auto& [Name, Part] : Parts)
	{
		Text += Name.empty() || Name == Entry ? Part : "";
		bFound = bFound || Name == Entry;
	}
	return bFound ? Text : std::string();
}

} // namespace Drydock
