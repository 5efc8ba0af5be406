// Verbs that fail with --json: stdout is a JSON of messages, the exit code what it is without. The verbs are those that
// the parser has.
#include "../ProgramTestUtils.h"

#include "Program/CommandLine.h"
#include "Program/ProgramModel.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

using namespace ProgramTest;
using namespace Drydock;

namespace
{

static_assert(sizeof(DRYDOCK_TEST_BINARY_DIR) > 1); // which files that name it are given: the program is there

/** A mistake for each verb with --json, and its exit code. A verb that is new has to be added. */
const std::map<std::string, std::pair<std::string, int>> Mistakes = {
	{"run", {"broken.json", 2}},
	{"check", {"broken.json", 2}},
	{"blend", {"broken.json", 2}},
	{"graph", {"broken.json", 2}},
	{"probe", {"broken.json 1,1", 2}},
	{"trace", {"broken.json --pass X --pixel 1,1", 2}},
	{"prove", {"broken.json", 2}},
	{"hazards", {"broken.json --pass X", 2}},
	{"lint", {"no_such.usf", 3}},
	{"study", {"broken.json", 2}},
	{"flicker", {"broken.json", 2}},
	{"sweep plan", {"broken.json --out plan", 2}},
	{"sweep status", {"no_such_folder", 2}},
	{"diff", {"no_such.png no_such_either.png", 3}},
	{"explain", {"broken.json", 2}},
	{"list", {"hooks broken.json", 2}},
	{"settings import", {"broken.txt", 2}},
	{"settings plan", {"NoSuchSettng", 2}},
	{"import", {"no_such.exr --out new.exr", 3}},
	{"new", {"1stPatch", 2}},
	{"overlay diff", {"no_such_folder", 2}},
	{"build", {"no_such_folder", 2}},
	{"matrix", {"no_such_folder", 2}},
	{"vet", {"no_such_folder", 2}},
};

bool TakesJson(const FVerbModel& Verb)
{
	return std::any_of(Verb.Options.begin(), Verb.Options.end(),
		[](const FOptionModel& Option) { return Option.GetName() == "--json"; });
}

class FailureJson : public testing::Test
{
protected:
	FailureJson()
	{
		Folder.Write("broken.json", "{\n  \"scene\": {\"file\": \"scene.exr\"},\n  \"camra\": {}\n}");
		Folder.Write("broken.txt", "(BloomIntensity=)");
	}

	/** Without what goes to stderr. */
	FOutcome Call(const std::string& Arguments) const { return Folder.Call(Arguments + " 2> /dev/null #"); }

	const FProgramFolder Folder{"failures"};
};

} // namespace

TEST_F(FailureJson, EveryVerbThatHasJsonPrintsItsMessages)
{
	size_t NumVerbs = 0;
	for (const FVerbModel& Verb : MakeProgramModel())
	{
		if (!TakesJson(Verb))
		{
			continue;
		}
		++NumVerbs;
		ASSERT_EQ(1u, Mistakes.count(Verb.Name)) << "say what is a mistake for " << Verb.Name;
		const auto& [Arguments, ExitCode] = Mistakes.at(Verb.Name);
		const FOutcome Plain = Call(Verb.Name + " " + Arguments);
		const FOutcome Json = Call(Verb.Name + " " + Arguments + " --json");
		EXPECT_EQ(ExitCode, Plain.ExitCode) << Verb.Name;
		EXPECT_EQ(ExitCode, Json.ExitCode) << Verb.Name;
		const nlohmann::json Printed = nlohmann::json::parse(Json.Printed, nullptr, false);
		ASSERT_TRUE(Printed.is_object() && Printed.contains("messages")) << Verb.Name << "\n" << Json.Printed;
		ASSERT_FALSE(Printed.at("messages").empty()) << Verb.Name;
		for (const nlohmann::json& Message : Printed.at("messages"))
		{
			for (const char* const Key : {"severity", "code", "text", "file", "pointer", "where", "nearest"})
			{
				EXPECT_TRUE(Message.at(Key).is_string()) << Verb.Name << " " << Key;
			}
			EXPECT_TRUE(Message.at("line").is_number_integer() && Message.at("column").is_number_integer())
				<< Verb.Name;
			EXPECT_THAT(Message.at("code").get<std::string>(), testing::MatchesRegex("DD[0-9]+")) << Verb.Name;
			EXPECT_NE("", Message.at("text")) << Verb.Name;
		}
	}
	EXPECT_EQ(Mistakes.size(), NumVerbs); // none that is gone
}

TEST_F(FailureJson, AMistakeInAConfigHasItsPlaceAndTheNearestName)
{
	const nlohmann::json Message = nlohmann::json::parse(Call("run broken.json --json").Printed).at("messages").at(0);
	EXPECT_EQ("error", Message.at("severity"));
	EXPECT_EQ("broken.json", Message.at("file"));
	EXPECT_EQ(3, Message.at("line"));
	EXPECT_EQ(3, Message.at("column"));
	EXPECT_EQ("/camra", Message.at("pointer"));
	EXPECT_EQ("camera", Message.at("nearest"));
}

TEST_F(FailureJson, SoHasAMistakeInTheArguments)
{
	const FOutcome Outcome = Call("run broken.json --precison float --json");
	EXPECT_EQ(2, Outcome.ExitCode);
	const nlohmann::json Message = nlohmann::json::parse(Outcome.Printed).at("messages").at(0);
	EXPECT_EQ("--precision", Message.at("nearest"));
	EXPECT_EQ("", Message.at("pointer"));
}

TEST_F(FailureJson, WithoutTheOptionStdoutStaysEmpty)
{
	EXPECT_EQ("", Call("run broken.json").Printed);
	EXPECT_EQ("", Call("explain broken.json").Printed);
}

TEST_F(FailureJson, MessagesForPeopleStandOnStderrAllTheSame)
{
	EXPECT_THAT(Folder.Call("run broken.json --json 2>&1 > /dev/null #").Printed,
		testing::HasSubstr("broken.json:3:3: error DD1005"));
}
