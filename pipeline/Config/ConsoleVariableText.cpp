// Formats console variables for people and for machines.
#include "Config/ConsoleVariableText.h"

#include "Text/GlobPattern.h"
#include "Text/JsonWriter.h"
#include "Text/TextTable.h"
#include "TextTools.h"

#include <algorithm>
#include <sstream>

namespace Drydock
{

namespace
{

std::string Quote(const FConsoleVariableInfo& Info, const FString& Value)
{
	return Info.Type == "FString" ? "\"" + std::string(*Value) + "\"" : std::string(*Value);
}

std::vector<std::string> MakeRow(const FConsoleVariableInfo& Info)
{
	return {*Info.Name, *Info.Type, Quote(Info, Info.Value), Quote(Info, Info.Default), *Info.SetBy};
}

/** The width of help texts, on a terminal of that width. */
size_t GetHelpColumns(int Width)
{
	return Width > 0 ? std::min(static_cast<size_t>(Width), ConsoleListColumns) : ConsoleListColumns;
}

} // namespace

std::vector<FConsoleVariableInfo> FilterConsoleVariables(
	const std::vector<FConsoleVariableInfo>& Infos, const std::string& Filter)
{
	const std::string Wanted = ToLowerCase(Filter);
	const bool bPattern = Wanted.find_first_of("*?") != std::string::npos;
	std::vector<FConsoleVariableInfo> Found;
	for (const FConsoleVariableInfo& Info : Infos)
	{
		const std::string Name = ToLowerCase(*Info.Name);
		if (Name == Wanted)
		{
			return {Info};
		}
		if (bPattern ? MatchesPattern(Wanted, Name) : Name.find(Wanted) != std::string::npos)
		{
			Found.push_back(Info);
		}
	}
	return Found;
}

std::string WrapText(
	const std::string& Text, size_t Columns, const std::string& Indent, const std::optional<std::string>& FirstIndent)
{
	std::string Wrapped;
	for (const std::string& Line : SplitText(Text))
	{
		std::string Current;
		std::istringstream Words(Line);
		for (std::string Word; Words >> Word;)
		{
			if (!Current.empty() && Current.size() + 1 + Word.size() > Columns)
			{
				Wrapped += Current + "\n";
				Current.clear();
			}
			const std::string Before = Wrapped.empty() ? FirstIndent.value_or(Indent) : Indent;
			Current += (Current.empty() ? Before : " ") + Word;
		}
		Wrapped += Current + "\n";
	}
	return Wrapped;
}

std::string FormatConsoleVariables(const std::vector<FConsoleVariableInfo>& Infos, int Width)
{
	// Names are not wrapped: each row is a line.
	FTextTable Table{
		std::vector<FTextColumn>(5, {ETextColumn::Name}), {{"name", "type", "value", "default", "set by"}}};
	std::transform(Infos.begin(), Infos.end(), std::back_inserter(Table.Rows), MakeRow);
	const std::vector<std::string> Lines = SplitText(Table.Format(Width));
	std::string Text;
	for (size_t Index = 0; Index < Lines.size(); ++Index)
	{
		Text += Lines[Index] + "\n";
		if (Index > 0)
		{
			Text += WrapText(*Infos[Index - 1].Help, GetHelpColumns(Width), "    ");
		}
	}
	return Text;
}

std::string FormatConsoleVariableHelp(const FConsoleVariableInfo& Info, int Width)
{
	const std::string Name = *Info.Name;
	return "HELP for '" + Name + "':\n" + WrapText(*Info.Help, GetHelpColumns(Width), "") + "\n" + Name + " = \"" +
		   *Info.Value + "\"      LastSetBy: " + *Info.SetBy + "\ntype " + *Info.Type + ", default " +
		   Quote(Info, Info.Default) + "\n";
}

std::string FormatConsoleVariablesAsJson(const std::vector<FConsoleVariableInfo>& Infos)
{
	FJsonWriter Writer('[');
	for (const FConsoleVariableInfo& Info : Infos)
	{
		Writer.Object({{"name", *Info.Name}, {"type", *Info.Type}, {"value", *Info.Value}, {"default", *Info.Default},
			{"setBy", *Info.SetBy}, {"simulated", !Info.bNotSimulated}, {"help", *Info.Help}});
	}
	return Writer.GetText();
}

} // namespace Drydock
