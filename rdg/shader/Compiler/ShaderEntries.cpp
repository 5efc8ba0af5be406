// Finds entry points by their attributes and semantics, and cuts a text into what each of them needs.
#include "ShaderEntries.h"

#include "RegularFile.h"
#include "ShaderDirectories.h"
#include "ShaderSource.h"
#include "SpirvFile.h"
#include "TextTools.h"

#include <algorithm>
#include <optional>
#include <unordered_map>

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

/** The stage of an entry point; nothing for other functions. */
std::optional<EShaderStage> FindStage(const FHlslText& Text, const FFunctionText& Function)
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
	for (size_t At = Function.Parameters; At < Function.Body; ++At)
	{
		if (ToLowerCase(Text[At].Text).starts_with("sv_target"))
		{
			return EShaderStage::Pixel;
		}
	}
	return std::nullopt;
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
	for (const FFunctionText& Function : ListFunctionTexts(Text))
	{
		if (const std::optional<EShaderStage> Stage = FindStage(Text, Function))
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
	for (const FFunctionText& Function : ListFunctionTexts(Text))
	{
		const std::string& Name = Text[Function.Name].Text;
		if (Mentions[Name] > 1 || !FindStage(Text, Function))
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
