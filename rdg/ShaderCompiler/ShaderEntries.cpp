// Entry points are told by their attributes and semantics.
#include "ShaderEntries.h"

#include "RegularFile.h"
#include "ShaderDirectories.h"
#include "ShaderSource.h"
#include "SpirvFile.h"
#include "TextTools.h"

#include <algorithm>
#include <optional>

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

/** Nothing: it is no entry point. */
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
	: Rest(FlattenShader(Request).Text, Request.VirtualPath)
{
	const FHlslTokens& All = Rest.Tokens;
	std::map<std::string, size_t> Mentions;
	for (const FHlslToken& Token : All)
	{
		++Mentions[Token.Text];
	}
	FHlslTokens Kept;
	size_t Next = 0;
	for (const FFunctionText& Function : ListFunctionTexts(Rest))
	{
		size_t First = Function.Name;
		while (First > Next && !Rest.Is(First - 1, "}") && !Rest.Is(First - 1, ";") && All[First - 1].Text[0] != '#')
		{
			--First;
		}
		const size_t End = std::min(Rest.FindClose(Function.Body) + 1, Rest.Size());
		const bool bDirective = std::any_of(All.begin() + std::ptrdiff_t(First), All.begin() + std::ptrdiff_t(End),
			[](const FHlslToken& Token) { return Token.Text[0] == '#'; });
		const std::string& Name = All[Function.Name].Text;
		if (First < Next || bDirective || Mentions[Name] > 1 || !FindStage(Rest, Function))
		{
			continue;
		}
		Kept.insert(Kept.end(), All.begin() + std::ptrdiff_t(Next), All.begin() + std::ptrdiff_t(First));
		Own[Name] = {Kept.size(), {All.begin() + std::ptrdiff_t(First), All.begin() + std::ptrdiff_t(End)}};
		Next = End;
	}
	Kept.insert(Kept.end(), All.begin() + std::ptrdiff_t(Next), All.end());
	Rest.Tokens = std::move(Kept);
	Rest.Match();
}

std::string FEntryTexts::GetText(const std::string& Entry) const
{
	const auto Found = Own.find(Entry);
	if (Found == Own.end())
	{
		return {};
	}
	FHlslText Text = Rest;
	const auto& [At, Tokens] = Found->second;
	Text.Tokens.insert(Text.Tokens.begin() + std::ptrdiff_t(At), Tokens.begin(), Tokens.end());
	return Text.Join();
}

} // namespace Drydock
