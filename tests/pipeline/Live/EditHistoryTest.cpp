// States of a session under edits, undone, done again, reset, and told by the record.
#include <gtest/gtest.h>

#include "Live/EditHistory.h"
#include "Live/LiveErrors.h"

using namespace Drydock;

namespace
{

std::string MakeEdits(const std::string& Value, const std::string& Pointer = "/a", const std::string& Drag = "")
{
	return "{\"edits\": [{\"set\": \"" + Pointer + "\", \"value\": " + Value + "}]" +
		   (Drag.empty() ? "" : ", \"drag\": \"" + Drag + "\"") + "}";
}

FEditHistory::FNext Plan(const FEditHistory& History, const std::string& Change)
{
	std::vector<FDiagnostic> Faults;
	bool bSyntaxError = false;
	return History.Plan(ParseJson(Change, "", Faults, bSyntaxError));
}

void Take(FEditHistory& History, const std::string& Change)
{
	History.Take(Plan(History, Change));
}

const std::string Undo = "{\"undo\": true}";
const std::string Redo = "{\"redo\": true}";

std::string FindMistake(const std::string& Record)
{
	try
	{
		FEditHistory::Replay(Record, "s.jsonl");
	}
	catch (const FError& Error)
	{
		EXPECT_EQ(int(ErrorBadRecord), Error.GetDiagnostics().front().Code);
		return Error.GetDiagnostics().front().ToString();
	}
	return "";
}

} // namespace

TEST(EditHistory, StepsAreUndoneAndDoneAgain)
{
	FEditHistory History("c.json", "{\"a\": 0}");
	EXPECT_FALSE(History.CanUndo());
	EXPECT_THROW(Plan(History, Undo), FError);
	Take(History, MakeEdits("1"));
	Take(History, MakeEdits("2"));
	const uint64_t Revision = History.GetRevision();
	Take(History, Undo);
	EXPECT_EQ("{\"a\": 1}", History.GetText());
	EXPECT_GT(History.GetRevision(), Revision);
	EXPECT_TRUE(History.CanRedo());
	Take(History, Redo);
	EXPECT_EQ("{\"a\": 2}", History.GetText());
	EXPECT_THROW(Plan(History, Redo), FError);
	Take(History, Undo);
	Take(History, MakeEdits("3"));
	EXPECT_FALSE(History.CanRedo());
	Take(History, Undo);
	EXPECT_EQ("{\"a\": 1}", History.GetText());
}

TEST(EditHistory, ADragIsOneStep)
{
	FEditHistory History("c.json", "{\"a\": 0}");
	Take(History, MakeEdits("1"));
	for (const char* const Value : {"2", "3", "4"})
	{
		Take(History, MakeEdits(Value, "/a", "d1"));
	}
	Take(History, MakeEdits("5", "/a", "d2"));
	EXPECT_EQ(4, std::ranges::count(History.GetRecord(), '\n')); // the start, the edit and the drags
	Take(History, Undo);
	EXPECT_EQ("{\"a\": 4}", History.GetText());
	Take(History, MakeEdits("6", "/a", "d1")); // it was let go
	Take(History, Undo);
	EXPECT_EQ("{\"a\": 4}", History.GetText());
	Take(History, Undo);
	EXPECT_EQ("{\"a\": 1}", History.GetText());
}

TEST(EditHistory, ResetGivesTheStartsValue)
{
	FEditHistory History("c.json", "{\"a\": 0, \"b\": [1]}");
	Take(History, MakeEdits("1"));
	Take(History, MakeEdits("2", "/c"));
	Take(History, MakeEdits("3", "/b/0"));
	EXPECT_EQ("{\"a\": 0, \"b\": [3], \"c\": 2}", Plan(History, R"({"reset": "/a"})").Text);
	EXPECT_EQ("{\"a\": 1, \"b\": [3]}", Plan(History, R"({"reset": "/c"})").Text);
	EXPECT_EQ("{\"a\": 1, \"b\": [1], \"c\": 2}", Plan(History, R"({"reset": "/b"})").Text);
	EXPECT_EQ(History.GetText(), Plan(History, R"({"reset": "/nowhere"})").Text);
	EXPECT_EQ(History.GetStart(), Plan(History, R"({"reset": true})").Text);
}

TEST(EditHistory, TheRecordGivesTheSameState)
{
	FEditHistory History("c.json", "{\"a\": 0} // é \\ \"\n");
	Take(History, MakeEdits("1"));
	Take(History, MakeEdits("2", "/a", "d"));
	Take(History, MakeEdits("3", "/a", "d"));
	Take(History, Undo);
	Take(History, Redo);
	Take(History, MakeEdits("4", "/b"));
	Take(History, R"({"reset": "/a"})");
	Take(History, R"({"text": "{\"b\": 5, \"a\": 7}"})");
	Take(History, MakeEdits("6", "/c"));
	const FEditHistory Again = FEditHistory::Replay(History.GetRecord(), "s.jsonl");
	EXPECT_EQ(History.GetText(), Again.GetText());
	EXPECT_EQ(History.GetStart(), Again.GetStart());
	EXPECT_EQ("c.json", Again.GetFile());
	EXPECT_EQ(History.GetRecord(), Again.GetRecord());
}

TEST(EditHistory, AFloodLeavesTheStartAndTheStateOfNow)
{
	FEditHistory History("c.json", "{\"a\": 0}");
	const std::string Long = '"' + std::string(1'000'000, 'x') + '"';
	for (int Number = 0; Number < 50; ++Number)
	{
		Take(History, MakeEdits(Number % 2 == 0 ? Long : "1", Number % 2 == 0 ? "/b" : "/a"));
	}
	EXPECT_LT(History.GetRecord().size(), 70'000'000u);
	EXPECT_EQ(History.GetText(), FEditHistory::Replay(History.GetRecord(), "s.jsonl").GetText());
	while (History.CanUndo())
	{
		Take(History, Undo);
		ASSERT_EQ(History.GetText(), FEditHistory::Replay(History.GetRecord(), "s.jsonl").GetText());
	}
	EXPECT_EQ("{\"a\": 0}", History.GetText());
}

TEST(EditHistory, AMistakeOfTheRecordIsNamedByItsLine)
{
	FEditHistory History("c.json", "{\"a\": 0}");
	const std::string Record = History.GetRecord();
	EXPECT_NE("", FindMistake(""));
	EXPECT_NE("", FindMistake("{}"));
	EXPECT_NE("", FindMistake("not JSON"));
	EXPECT_TRUE(FindMistake(Record + "{\"undo\": true}\n").starts_with("s.jsonl:2: error DD1122"));
	EXPECT_TRUE(FindMistake(Record + "{\"redo\": true}\n").starts_with("s.jsonl:2: error DD1122"));
	EXPECT_TRUE(FindMistake(Record + "{\"edits\": []}\n").starts_with("s.jsonl:2: error DD1122"));
	EXPECT_TRUE(FindMistake(Record + MakeEdits("1") + "\n{\n").starts_with("s.jsonl:3: error DD1122"));
	EXPECT_EQ("", FindMistake(Record + MakeEdits("1") + "\n"));
}
