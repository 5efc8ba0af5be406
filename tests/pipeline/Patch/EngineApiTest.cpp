// The table of names by version: every row of the header is data, and compilers' sentences by it are found.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Patch/EngineApi.h"

#include <fstream>
#include <iterator>
#include <regex>

using namespace Drydock;
using testing::ElementsAre;

TEST(EngineApi, EveryRowOfTheHeaderIsListed)
{
	std::ifstream File(DRYDOCK_TEST_SOURCE_DIR "/rdg/core/Core/Misc/EngineApi.h");
	const std::string Header(std::istreambuf_iterator<char>(File), {});
	const std::regex Row("#define DRYDOCK_API_[A-Za-z0-9]+ ");
	EXPECT_EQ(std::distance(std::sregex_iterator(Header.begin(), Header.end(), Row), std::sregex_iterator()),
		static_cast<std::ptrdiff_t>(GetEngineApi().size()));
	for (const FEngineApiRow& Each : GetEngineApi())
	{
		EXPECT_TRUE(Each.Minor >= 1 && Each.Minor <= 8) << Each.Name;
		EXPECT_NE(std::string::npos, Header.find("\"" + std::string(Each.Name) + "\"")) << Each.Name;
		EXPECT_EQ(std::string(Each.Kind) == "deprecated", *Each.Instead != '\0') << Each.Name;
	}
}

TEST(EngineApi, SentencesOfCompilersAreFoundOnceWithTheirPlace)
{
	EXPECT_THAT(
		FindVersionMessages(
			"A.cpp:12:7: error: 'F' is unavailable: engine 5.4 does not have F::F, which is there from 5.7 on\n"
			"A.cpp:13:7: error: 'F' is unavailable: engine 5.4 does not have F::F, which is there from 5.7 on\n"
			"A.cpp:14:7: warning: 'G' is deprecated: engine 5.8 deprecates G: use H [-Wdeprecated-declarations]\n"
			"A.cpp:15:7: error: 'Nothing' was not declared in this scope\n"),
		ElementsAre("A.cpp:12: engine 5.4 does not have F::F, which is there from 5.7 on",
			"A.cpp:14: engine 5.8 deprecates G: use H"));
	// An override is found in a template: the place is where the extension is made.
	EXPECT_THAT(FindVersionMessages("A.cpp:20:3:   required from here\n/x/SceneViewExtension.h:9:1: error: 'F' is "
									"unavailable: engine 5.4 does not have F::F, which is there from 5.7 on\n"),
		ElementsAre("A.cpp:20: engine 5.4 does not have F::F, which is there from 5.7 on"));
	EXPECT_THAT(
		FindVersionMessages("/x/SceneViewExtension.h:9:1: error: 'F' is unavailable: engine 5.4 does not have F::F, "
							"which is there from 5.7 on\n/x/SceneViewExtension.h:30:3: note: in instantiation of "
							"function template specialization 'X<T>' requested here\nA.cpp:20:3: note: in "
							"instantiation of function template specialization 'Y<T>' requested here\n"),
		ElementsAre("A.cpp:20: engine 5.4 does not have F::F, which is there from 5.7 on"));
}
