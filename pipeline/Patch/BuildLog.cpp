// Reads logs of builds line by line.
#include "Patch/BuildLog.h"

#include "Patch/LogLines.h"
#include "RangeTools.h"
#include "TextTools.h"

#include <algorithm>
#include <optional>
#include <regex>
#include <tuple>

namespace Drydock
{

namespace
{

std::string GetPathFrom(const std::string& File, const std::string& Folder)
{
	const std::string Start = Folder + "/";
	return !Folder.empty() && File.starts_with(Start) ? File.substr(Start.size()) : File;
}

/** "file:41:7: fatal error: text", "file:41: undefined reference to `f()'", "ld: multiple definition of `f()'". */
std::optional<FCompilerMessage> ReadCompilerMessage(const std::string& WholeLine, ECompilerMessage Kind)
{
	static const std::regex Compiler("^\\s*(.*?):(\\d+)(?::\\d+)?: (?:fatal )?(error|warning): (.*)$");
	static const std::regex Linker("((undefined reference to|multiple definition of) .*)$");
	static const std::regex Place("([^\\s:]+):(\\d+): $");
	const std::string Line = CutLine(WholeLine);
	std::smatch Match;
	if (std::regex_match(Line, Match, Compiler))
	{
		const bool bWanted = (Match[3] == "error") == (Kind == ECompilerMessage::Error);
		return bWanted ? std::optional(
							 FCompilerMessage{.File = Match[1], .Line = ReadLineNumber(Match[2]), .Text = Match[4]})
					   : std::nullopt;
	}
	if (Kind == ECompilerMessage::Error && std::regex_search(Line, Match, Linker))
	{
		FCompilerMessage Message{.Text = Match[1]};
		const std::string Before = Match.prefix();
		if (std::regex_search(Before, Match, Place))
		{
			Message.File = Match[1];
			Message.Line = ReadLineNumber(Match[2]);
		}
		return Message;
	}
	return std::nullopt;
}

} // namespace

std::vector<FBuildStep> ReadBuildSteps(const std::string& Log)
{
	static const std::regex Begin("^\\[ *\\d+(?:/\\d+|%)\\] (.*)$");
	std::vector<FBuildStep> Steps;
	for (const std::string& Line : SplitText(Log))
	{
		const std::string Cut = CutLine(Line);
		std::smatch Match;
		if (std::regex_match(Cut, Match, Begin))
		{
			Steps.push_back({Match[1], ""});
		}
		else if (!Steps.empty())
		{
			Steps.back().Output += Line + "\n";
		}
	}
	return Steps;
}

std::string WriteBuildSteps(const std::vector<FBuildStep>& Steps)
{
	std::string Text;
	for (size_t Index = 0; Index < Steps.size(); ++Index)
	{
		Text += "[" + std::to_string(Index + 1) + "/" + std::to_string(Steps.size()) + "] " + Steps[Index].Name + "\n" +
				Steps[Index].Output;
	}
	return Text;
}

std::vector<FBuildStep> MergeBuildSteps(const std::vector<FBuildStep>& Before, const std::vector<FBuildStep>& Now)
{
	std::vector<FBuildStep> Merged;
	std::copy_if(Before.begin(), Before.end(), std::back_inserter(Merged),
		[&Now](const FBuildStep& Old)
		{ return std::ranges::none_of(Now, [&Old](const FBuildStep& New) { return New.Name == Old.Name; }); });
	Merged.insert(Merged.end(), Now.begin(), Now.end());
	return Merged;
}

std::vector<FCompilerMessage> ReadCompilerMessages(
	const std::string& Text, ECompilerMessage Kind, const std::string& Folder)
{
	std::vector<FCompilerMessage> Messages;
	for (const std::string& Line : SplitText(Text))
	{
		std::optional<FCompilerMessage> Message = ReadCompilerMessage(Line, Kind);
		if (!Message)
		{
			continue;
		}
		Message->File = GetPathFrom(Message->File, Folder);
		AddUnique(Messages, *Message);
	}
	// Sources are compiled side by side. The plugin's files go before others, and before no file at all.
	const auto GetPlace = [](const FCompilerMessage& Message)
	{
		return std::tuple(Message.File.empty() || Message.File[0] == '/', Message.File, Message.Line);
	};
	std::ranges::stable_sort(Messages, {}, GetPlace);
	return Messages;
}

} // namespace Drydock
