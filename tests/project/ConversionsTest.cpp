// Floating numbers become integers through ToInteger.h alone, as far as a search of the text can tell: no cast and no
// library call around what rounds.
#include <gtest/gtest.h>

#include "IncludeGraph.h"

#include <regex>
#include <sstream>

namespace
{

/** Code for lanes and the interpreter that models it convert by the shader's own rules; the casts are written there. */
const std::vector<std::string> GFolders = {"rdg/core/Core", "rdg/core/RHI", "rdg/graph/Graph", "rdg/graph/GraphUtils",
	"rdg/graph/Binding", "settings", "passes", "pipeline"};

const std::regex GCast(
	R"((static_cast<(u?int(8|16|32|64)(_t)?|int|long|unsigned|size_t)>|\b(u?int(8|16|32|64)(_t)?|int))\()"
	R"((std::(floor|ceil|round|trunc|nearbyint|rint|sqrt|log2|log10|pow|exp2)|[^()]*\.[0-9]+f?\b))");
const std::regex GCall(R"(\bl?l(round|rint)f?\()");

} // namespace

TEST(Conversions, NoCastAroundWhatRounds)
{
	for (const auto& [Path, Text] : Drydock::Test::ReadSources(DRYDOCK_TEST_SOURCE_DIR, GFolders))
	{
		std::istringstream Lines(Text);
		for (std::string Line; Path.find("ToInteger.h") == std::string::npos && std::getline(Lines, Line);)
		{
			const bool bMayCast = Line.find("cast<") != std::string::npos || Line.find("int") != std::string::npos;
			if (bMayCast && (std::regex_search(Line, GCast) || std::regex_search(Line, GCall)))
			{
				ADD_FAILURE() << Path << ": " << Line << ": convert by ToInteger, ToIndex or ToCount";
			}
		}
	}
}
