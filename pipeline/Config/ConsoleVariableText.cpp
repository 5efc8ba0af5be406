// Formats console variables for people and for machines.
#include "Config/ConsoleVariableText.h"

#include "Text/GlobPattern.h"
#include "Text/JsonWriter.h"

#include <algorithm>
#include <array>
#include <sstream>

namespace Drydock
{

namespace
{

std::string ToLower(std::string Text)
{
	std::transform(Text.begin(), Text.end(), Text.begin(),
		[](char Character)
		{ return static_cast<char>(Character >= 'A' && Character <= 'Z' ? Character - 'A' + 'a' : Character); });
	return Text;
}

std::string Quote(const FConsoleVariableInfo& Info, const FString& Value)
{
	return Info.Type == "FString" ? "\"" + std::string(*Value) + "\"" : std::string(*Value);
}

using FRow = std::array<std::string, 5>;

FRow MakeRow(const FConsoleVariableInfo& Info)
{
	return {*Info.Name, *Info.Type, Quote(Info, Info.Value), Quote(Info, Info.Default), *Info.SetBy};
}

} // namespace

std::vector<FConsoleVariableInfo> FilterConsoleVariables(
	const std::vector<FConsoleVariableInfo>& Infos, const std::string& Filter)
{
	const std::string Wanted = ToLower(Filter);
	const bool bPattern = Wanted.find_first_of("*?") != std::string::npos;
	std::vector<FConsoleVariableInfo> Found;
	for (const FConsoleVariableInfo& Info : Infos)
	{
		const std::string Name = ToLower(*Info.Name);
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

std::string WrapText(const std::string& Text, size_t Columns, const std::string& Indent)
{
	std::string Wrapped;
	std::istringstream Lines(Text);
	for (std::string Line; std::getline(Lines, Line);)
	{
		std::string Current;
		std::istringstream Words(Line);
		for (std::string Word; Words >> Word;)
		{
			if (!Current.empty() && Indent.size() + Current.size() + 1 + Word.size() > Columns)
			{
				Wrapped += Indent + Current + "\n";
				Current.clear();
			}
			Current += (Current.empty() ? "" : " ") + Word;
		}
		Wrapped += Current.empty() ? "\n" : Indent + Current + "\n";
	}
	return Wrapped;
}

std::string FormatConsoleVariables(const std::vector<FConsoleVariableInfo>& Infos)
{
	std::vector<FRow> Rows = {{"name", "type", "value", "default", "set by"}};
	std::transform(Infos.begin(), Infos.end(), std::back_inserter(Rows), MakeRow);
	std::array<size_t, 5> Widths = {};
	for (const FRow& Row : Rows)
	{
		for (size_t Column = 0; Column < Row.size(); ++Column)
		{
			Widths[Column] = std::max(Widths[Column], Row[Column].size());
		}
	}
	std::string Text;
	for (size_t Index = 0; Index < Rows.size(); ++Index)
	{
		std::string Line;
		for (size_t Column = 0; Column < Rows[Index].size(); ++Column)
		{
			const std::string& Cell = Rows[Index][Column];
			const bool bLast = Column + 1 == Rows[Index].size();
			Line += Cell + (bLast ? "" : std::string(Widths[Column] - Cell.size() + 2, ' '));
		}
		Text += Line + "\n";
		if (Index > 0)
		{
			Text += WrapText(*Infos[Index - 1].Help, ConsoleListColumns, "    ");
		}
	}
	return Text;
}

std::string FormatConsoleVariableHelp(const FConsoleVariableInfo& Info)
{
	const std::string Name = *Info.Name;
	return "HELP for '" + Name + "':\n" + WrapText(*Info.Help, ConsoleListColumns, "") + "\n" + Name + " = \"" +
		   *Info.Value + "\"      LastSetBy: " + *Info.SetBy + "\ntype " + *Info.Type + ", default " +
		   Quote(Info, Info.Default) + "\n";
}

std::string FormatConsoleVariablesAsJson(const std::vector<FConsoleVariableInfo>& Infos)
{
	FJsonWriter Writer;
	Writer.BeginArray();
	for (const FConsoleVariableInfo& Info : Infos)
	{
		Writer.BeginObject(true);
		Writer.Member("name", *Info.Name);
		Writer.Member("type", *Info.Type);
		Writer.Member("value", *Info.Value);
		Writer.Member("default", *Info.Default);
		Writer.Member("setBy", *Info.SetBy);
		Writer.Member("simulated", !Info.bNotSimulated);
		Writer.Member("help", *Info.Help);
		Writer.EndObject();
	}
	Writer.EndArray();
	return Writer.GetText();
}

} // namespace Drydock
