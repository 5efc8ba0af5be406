// Edits of a config's text: the right place changes, and everything else stays as it was written.
#include <gtest/gtest.h>

#include "Live/ConfigText.h"
#include "Live/LiveErrors.h"

#include <nlohmann/json.hpp>
#include <random>

using namespace Drydock;

namespace
{

using FJson = nlohmann::json;

const std::string Config = R"(// A room.
{
  "scene": { "file": "a.exr" },   // the frame

  "volumes": [
    {
      "name": "Base",
      /* all */ "Settings": {
        "BloomIntensity": 1.5,  // the default is 0.675
        "BloomThreshold": -1 // all blooms
      }
    }
  ]
}
)";

std::string Set(const std::string& Text, const std::string& Pointer, const std::string& Value)
{
	return ApplyEdits(Text, {{Pointer, Value}});
}

std::string Remove(const std::string& Text, const std::string& Pointer)
{
	return ApplyEdits(Text, {{Pointer, std::nullopt}});
}

FJson Parse(const std::string& Text)
{
	return FJson::parse(Text, nullptr, true, true);
}

std::string Replace(std::string Text, const std::string& From, const std::string& To)
{
	const size_t At = Text.find(From);
	EXPECT_NE(std::string::npos, At) << From;
	return Text.replace(At, From.size(), To);
}

/** The message of an edit that is refused. */
std::string FindMistake(const std::function<void()>& Edit)
{
	try
	{
		Edit();
	}
	catch (const FError& Error)
	{
		EXPECT_EQ(int(ErrorBadEdit), Error.GetDiagnostics().front().Code);
		EXPECT_EQ(ExitUsage, Error.GetExitCode());
		return Error.GetDiagnostics().front().Message;
	}
	return "";
}

} // namespace

TEST(ConfigText, AValueIsReplacedWhereItStands)
{
	EXPECT_EQ(Replace(Config, "1.5", "2"), Set(Config, "/volumes/0/Settings/BloomIntensity", "2"));
	EXPECT_EQ(Replace(Config, "{ \"file\": \"a.exr\" }", "[1]"), Set(Config, "/scene", "[1]"));
}

TEST(ConfigText, AMemberIsAddedBehindTheLastWithItsIndent)
{
	EXPECT_EQ(Replace(Config, "-1 // all blooms", "-1, // all blooms\n        \"X\": true"),
		Set(Config, "/volumes/0/Settings/X", "true"));
	EXPECT_EQ(Replace(Config, "\"a.exr\" }", "\"a.exr\", \"fps\": 24 }"), Set(Config, "/scene/fps", "24"));
}

TEST(ConfigText, MissingObjectsOnTheWayAreMade)
{
	const std::string Text = Set(Config, "/camera/Settings/BloomIntensity", "2.5");
	EXPECT_EQ(2.5, Parse(Text)["camera"]["Settings"]["BloomIntensity"]);
	EXPECT_EQ(Replace(Config, "  ]\n}", "  ],\n  \"camera\": {\"Settings\": {\"BloomIntensity\": 2.5}}\n}"), Text);
	EXPECT_EQ("{\"a\": {\"b\": 1}}", Set("{}", "/a/b", "1"));
	EXPECT_EQ("{\"a\": {\"b\": 1}}", Set("{\"a\": {}}", "/a/b", "1"));
}

TEST(ConfigText, ARemovedMemberTakesItsLineAndItsCommentAlong)
{
	EXPECT_EQ(Replace(Config, "\n        \"BloomIntensity\": 1.5,  // the default is 0.675", ""),
		Remove(Config, "/volumes/0/Settings/BloomIntensity"));
	EXPECT_EQ(Replace(Config, ",  // the default is 0.675\n        \"BloomThreshold\": -1 // all blooms",
				  "  // the default is 0.675"),
		Remove(Config, "/volumes/0/Settings/BloomThreshold"));
	EXPECT_EQ("{\"a\": 1}", Remove("{\"a\": 1, \"b\": 2}", "/b"));
	EXPECT_EQ("{\"b\": 2}", Remove("{\"a\": 1, \"b\": 2}", "/a"));
	EXPECT_EQ("{}", Remove("{\"a\": [1, 2]}", "/a"));
}

TEST(ConfigText, ArraysGrowAtTheirEnd)
{
	EXPECT_EQ("[1, 2]", Set("[1]", "/-", "2"));
	EXPECT_EQ("[1, 2]", Set("[1]", "/1", "2"));
	EXPECT_EQ("[2]", Remove("[1, 2]", "/0"));
	EXPECT_EQ("[3, 2]", Set("[1, 2]", "/0", "3"));
	EXPECT_NE("", FindMistake([] { Set("[1]", "/2", "2"); }));
	EXPECT_NE("", FindMistake([] { Set("[1]", "/x", "2"); }));
	EXPECT_NE("", FindMistake([] { Set("[1]", "/99999999999999999999", "2"); }));
}

TEST(ConfigText, NamesWithSlashesAreEscaped)
{
	const std::string Text = Set("{\"a/b\": {\"~\": 1}}", "/a~1b/~0", "2");
	EXPECT_EQ("{\"a/b\": {\"~\": 2}}", Text);
	EXPECT_EQ("2", FindPlace(Text, "/a~1b/~0"));
	EXPECT_EQ(std::nullopt, FindPlace(Text, "/a/b"));
	EXPECT_NE("", FindMistake([] { Set("{}", "/a~2", "1"); }));
	EXPECT_NE("", FindMistake([] { Set("{}", "a", "1"); }));
	EXPECT_NE("", FindMistake([] { Set("{}", "", "1"); }));
}

TEST(ConfigText, WhatCannotBeIsRefused)
{
	EXPECT_EQ("there is nothing to remove", FindMistake([] { Remove(Config, "/camera"); }));
	EXPECT_NE("", FindMistake([] { Set(Config, "/scene/file/name", "1"); }));
	const auto Read = [](const std::string& Text)
	{
		std::vector<FDiagnostic> Faults;
		bool bSyntaxError = false;
		return ReadEdits(ParseJson(Text, "", Faults, bSyntaxError));
	};
	for (const char* const Bad : {"[]", "1", "[1]", "[{}]", R"([{"set": "/a"}])", R"([{"remove": "/a", "value": 1}])",
			 R"([{"set": 1, "value": 1}])", R"([{"set": "a", "value": 1}])"})
	{
		EXPECT_NE("", FindMistake([&] { Read(Bad); })) << Bad;
	}
	const std::vector<FConfigEdit> Edits = Read(R"([{"set": "/a", "value": [1, {"b": null}]}, {"remove": "/c"}])");
	ASSERT_EQ(2u, Edits.size());
	EXPECT_EQ("[1, {\"b\": null}]", Edits[0].Value);
	EXPECT_EQ("{\"remove\": \"/c\"}", WriteEdit(Edits[1]));
	EXPECT_EQ("{\"set\": \"/a\", \"value\": [1, {\"b\": null}]}", WriteEdit(Edits[0]));
}

TEST(ConfigText, ChangesAreTheEditsBetweenTwoTexts)
{
	const std::string Before = R"({"a": 1, "b": {"c": [1, {"k": 2}], "d~/": "x"}, "e": 0} // so)";
	const std::string After = R"({"b": {"d~/": "y", "c": [1, {"k": 3}], "f": {"g": 1, "h": {}}}, "a": 1.0})";
	std::string Lines;
	for (const FConfigEdit& Change : FindChanges(Before, After))
	{
		Lines += WriteEdit(Change) + "\n";
	}
	EXPECT_EQ("{\"set\": \"/b/d~0~1\", \"value\": \"y\"}\n"
			  "{\"set\": \"/b/c/1/k\", \"value\": 3}\n"
			  "{\"set\": \"/b/f/g\", \"value\": 1}\n"
			  "{\"set\": \"/b/f/h\", \"value\": {}}\n"
			  "{\"remove\": \"/e\"}\n",
		Lines);
	EXPECT_EQ(Parse(After), Parse(ApplyEdits(Before, FindChanges(Before, After))));
	EXPECT_TRUE(FindChanges(Before, Before).empty());
}

// nlohmann's library carries out the same edits on the parsed config.
TEST(ConfigText, RandomEditsGiveTheConfigThatAnotherLibraryGives)
{
	std::mt19937 Random(7);
	const std::vector<std::string> Names = {"a", "b/c", "~d", "Settings"};
	const std::vector<std::string> Values = {"1", "-2.5e-3", "\"x // , }\"", "{}", "[]", "[1, {\"a\": 2}]",
		"{\"a\": {\"b/c\": [true, null]}, \"Settings\": {}}"};
	for (int Round = 0; Round < 200; ++Round)
	{
		std::string Text = Round % 2 == 0 ? Config : "{ // nothing\n}";
		FJson Expected = Parse(Text);
		for (int Step = 0; Step < 12; ++Step)
		{
			FJson::json_pointer Pointer;
			for (unsigned Depth = 0; Depth <= Random() % 3; ++Depth)
			{
				Pointer /= Names[Random() % Names.size()];
			}
			const std::string Value = Values[Random() % Values.size()];
			const bool bThere = Expected.contains(Pointer);
			const bool bRemove = bThere && Random() % 3 == 0;
			try
			{
				Text = bRemove ? Remove(Text, Pointer.to_string()) : Set(Text, Pointer.to_string(), Value);
			}
			catch (const FError&)
			{
				EXPECT_FALSE(bThere) << Pointer << "\n" << Text; // the way leads through what is not an object
				continue;
			}
			if (bRemove)
			{
				FJson& Parent = Expected[Pointer.parent_pointer()];
				Parent.erase(Pointer.back());
			}
			else
			{
				Expected[Pointer] = Parse(Value);
			}
			ASSERT_EQ(Expected, Parse(Text)) << Text;
		}
	}
}
