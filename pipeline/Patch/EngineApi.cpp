// Lists the rows of the table by giving its macros another meaning.
#include "Patch/EngineApi.h"

#include "Misc/EngineApi.h"
#include "RangeTools.h"
#include "TextTools.h"

#include <regex>

#undef DRYDOCK_FROM
#undef DRYDOCK_UNTIL
#undef DRYDOCK_DEPRECATED
#define DRYDOCK_FROM(Minor, Certainty, Name) \
	{ \
		"from", Minor, #Certainty, Name \
	}
#define DRYDOCK_UNTIL(Minor, Certainty, Name) \
	{ \
		"until", Minor, #Certainty, Name \
	}
#define DRYDOCK_DEPRECATED(Minor, Certainty, Name, Instead) \
	{ \
		"deprecated", Minor, #Certainty, Name, Instead \
	}

namespace Drydock
{

const std::vector<FEngineApiRow>& GetEngineApi()
{
	static const std::vector<FEngineApiRow> Rows = {DRYDOCK_API_GetFlags, DRYDOCK_API_PostCreateSceneRenderer,
		DRYDOCK_API_PostTLASBuild, DRYDOCK_API_PreRenderBasePass, DRYDOCK_API_SubscribeWithView, DRYDOCK_API_Subscribe,
		DRYDOCK_API_BeforeDOF, DRYDOCK_API_AfterDOF, DRYDOCK_API_TranslucencyAfterDOF, DRYDOCK_API_ReplacingTonemapper,
		DRYDOCK_API_SMAA, DRYDOCK_API_CopyFromSlice, DRYDOCK_API_CopyFromSliceOverride, DRYDOCK_API_FTexture2DRHIRef,
		DRYDOCK_API_GetOnPostEngineInit, DRYDOCK_API_OnPostEngineInit, DRYDOCK_API_RHICreateTexture};
	return Rows;
}

std::vector<std::string> FindVersionMessages(const std::string& CompilerOutput)
{
	static const std::regex Message(
		"^(.*?:\\d+)(?::\\d+)?: (?:error|warning): .*(engine 5\\.\\d+ (?:does not have|deprecates) [^\\[\\]]*)");
	// An override is found where the extension is made: "A.cpp:12:3:   required from here", "note: in instantiation".
	static const std::regex Required(
		"^(.*?:\\d+)(?::\\d+)?: +(?:required from here|note: in instantiation .* requested here)");
	const auto IsOurs = [](const std::string& Place)
	{
		return Place.find("SceneViewExtension.h:") != std::string::npos;
	};
	std::vector<std::string> Places;
	std::vector<std::string> Sentences;
	std::string Here; // g++ names it before the error, clang behind it
	for (const std::string& Line : SplitText(CompilerOutput))
	{
		std::smatch Match;
		if (std::regex_search(Line, Match, Required))
		{
			Here = Match[1].str() + ":";
			if (!Places.empty() && IsOurs(Places.back()))
			{
				Places.back() = Here;
			}
		}
		else if (std::regex_search(Line, Match, Message))
		{
			const std::string Sentence = Trim(Match[2].str());
			if (std::ranges::find(Sentences, Sentence) == Sentences.end())
			{
				Places.push_back(IsOurs(Match[1].str() + ":") && !Here.empty() ? Here : Match[1].str() + ":");
				Sentences.push_back(Sentence);
			}
		}
	}
	std::vector<std::string> Messages;
	for (size_t Index = 0; Index < Places.size(); ++Index)
	{
		Messages.push_back(Places[Index].substr(0, Places[Index].find_last_not_of(':') + 1) + ": " + Sentences[Index]);
	}
	return Messages;
}

} // namespace Drydock
