// Finds what lacks in the compiler's log, and tells it.
#include "Patch/PluginErrors.h"

#include "Patch/MissingBases.h"
#include "Patch/MissingNames.h"
#include "RangeTools.h"
#include "Text/TextFile.h"
#include "TextTools.h"

#include <algorithm>
#include <filesystem>

namespace Drydock
{

namespace
{

namespace Files = std::filesystem;

constexpr size_t MostErrorLines = 12;
constexpr size_t MostFollowing = 8;

/** A line about a texture of the graph that is given as one of the RHI; empty: none. */
std::string AdviseOnTextures(const std::vector<FCompilerMessage>& Others)
{
	const bool bGraphTexture = std::ranges::any_of(Others,
		[](const FCompilerMessage& Error) {
			return Error.Text.find("FRDGTexture") != std::string::npos &&
				   Error.Text.find("FRHITexture") != std::string::npos;
		});
	return bGraphTexture ? "  a texture of the graph is a parameter by SHADER_PARAMETER_RDG_TEXTURE "
						   "(SHADER_PARAMETER_TEXTURE takes an FRHITexture*)\n"
						 : "";
}

/** A line about the errors that base classes cause which lack; empty: none. */
std::string DescribeFollowing(const std::vector<FCompilerMessage>& Following, const std::vector<std::string>& Notes)
{
	std::vector<FCompilerMessage> Ignored;
	std::vector<FMissingName> Members = FindMissingNames(Following, Notes, Ignored);
	std::erase_if(Members, [](const FMissingName& Name) { return Name.Kind != "name"; });
	std::string Names;
	for (size_t Index = 0; Index < std::min(Members.size(), MostFollowing); ++Index)
	{
		Names += (Names.empty() ? ": " : ", ") + Members[Index].Name;
	}
	return Following.empty() ? ""
							 : "  " + std::to_string(Following.size()) +
								   " more errors, which may follow from the missing base classes" + Names +
								   (Members.size() > MostFollowing ? ", ...\n" : "\n");
}

/** The end of a message: missing names as a table, what follows from base classes, other errors, what was left out. */
std::string DescribeErrors(const std::vector<FMissingName>& Missing, const std::vector<FCompilerMessage>& Following,
	const std::vector<FCompilerMessage>& Others, const std::vector<std::string>& Notes)
{
	const bool bOne = Missing.size() == 1;
	std::string Text = "does not compile:";
	if (!Missing.empty())
	{
		Text += " " + std::to_string(Missing.size()) + (bOne ? " name is" : " names are") + " missing here\n" +
				FormatMissingNames(Missing, "  ") + DescribeFollowing(Following, Notes) +
				(Others.empty() ? "" : "  other errors, which may follow from these:\n");
	}
	Text += Missing.empty() ? "\n" : "";
	for (size_t Index = 0; Index < std::min(Others.size(), MostErrorLines); ++Index)
	{
		const FCompilerMessage& Other = Others[Index];
		Text += "  " + Other.File + (Other.Line > 0 ? ":" + std::to_string(Other.Line) : "") + ": " + Other.Text + "\n";
	}
	if (Others.size() > MostErrorLines)
	{
		Text += "  and " + std::to_string(Others.size() - MostErrorLines) + " more\n";
	}
	for (const std::string& Note : Notes)
	{
		Text += Note.starts_with("left out") ? "  " + Note + "\n" : "";
	}
	return Text;
}

} // namespace

std::string AdviseOnCompositionGraph(const std::string& Text)
{
	for (const char* const Name : {"TRenderingCompositePassBase", "FRenderingCompositePass", "FPostprocessContext"})
	{
		if (Text.find(Name) != Text.npos)
		{
			return std::string(Name) +
				   " belongs to UE4's composition graph, which Unreal 5 does not have: write a function that adds the "
				   "pass with an FRDGBuilder and takes and returns an FScreenPassTexture, as in "
				   "docs/articles/red-post-process.md";
		}
	}
	return "";
}

std::string DescribePluginErrors(const std::string& Folder, const std::vector<std::string>& Notes,
	const std::string& Log, const std::string& JoinedLog)
{
	std::vector<FCompilerMessage> Following;
	std::vector<FCompilerMessage> Others;
	std::vector<FCompilerMessage> Ignored;
	const auto ReadLines = [&](const std::string& File)
	{
		return SplitText(TryReadTextFile((Files::path(Folder) / File).string()).value_or(""));
	};
	const auto Find = [&](const std::string& Text, std::vector<FCompilerMessage>& OutFollowing,
						  std::vector<FCompilerMessage>& OutOthers)
	{
		std::vector<FCompilerMessage> Errors = ReadCompilerMessages(Text, ECompilerMessage::Error, Folder);
		NameMissingBases(Errors, ReadLines, OutFollowing);
		return FindMissingNames(Errors, Notes, OutOthers);
	};
	std::vector<FMissingName> Missing = Find(Log, Following, Others);
	const std::vector<FMissingName> JoinedMissing = Find(JoinedLog, Ignored, Ignored);
	if (!JoinedMissing.empty())
	{
		std::erase_if(Missing,
			[&](const FMissingName& Name) { return !Contains(JoinedMissing, Name.Name, &FMissingName::Name); });
	}
	// g++ names a base class that is a template in the source line that it quotes, not in the error.
	const std::string Graph = AdviseOnCompositionGraph(Log);
	return DescribeErrors(Missing, Following, Others, Notes) + AdviseOnTextures(Others) +
		   (Graph.empty() ? "" : "  " + Graph + "\n");
}

} // namespace Drydock
