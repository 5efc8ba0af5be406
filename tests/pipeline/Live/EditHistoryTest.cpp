// States of a session under edits, undone, done again, reset, and told by the record.
#include <gtest/gtest.h>

#include "Live/EditHistory.h"
#include "Live/LiveErrors.h"

using namespace Drydock;

namespace
{

using EMove = FEditHistory::EMove;

std::vector<FConfigEdit> MakeEdit(const std::string& Value, const std::string& Pointer = "/a")
{
	return {{Pointer, Value}};
}

std::string MakeLine(const std::vector<FConfigEdit>& Edits, const std::string& Drag = "")
{
	return "{\"edits\": [" + WriteEdit(Edits[0]) + "]" + (Drag.empty() ? "" : ", \"drag\": \"" + Drag + "\"") + "}";
}

void Edit(FEditHistory& History, const std::vector<FConfigEdit>& Edits, const std::string& Drag = "")
{
	History.Take(History.Edit(Edits), EMove::Forward, MakeLine(Edits, Drag), FEditHistory::MakeDrag(Drag, Edits));
}

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
	EXPECT_THROW(History.Undo(), FError);
	Edit(History, MakeEdit("1"));
	Edit(History, MakeEdit("2"));
	const uint64_t Revision = History.GetRevision();
	History.Take(History.Undo(), EMove::Undo, "{\"undo\": true}");
	EXPECT_EQ("{\"a\": 1}", History.GetText());
	EXPECT_GT(History.GetRevision(), Revision);
	EXPECT_TRUE(History.CanRedo());
	History.Take(History.Redo(), EMove::Redo, "{\"redo\": true}");
	EXPECT_EQ("{\"a\": 2}", History.GetText());
	EXPECT_THROW(History.Redo(), FError);
	History.Take(History.Undo(), EMove::Undo, "{\"undo\": true}");
	Edit(History, MakeEdit("3"));
	EXPECT_FALSE(History.CanRedo());
	History.Take(History.Undo(), EMove::Undo, "{\"undo\": true}");
	EXPECT_EQ("{\"a\": 1}", History.GetText());
}

TEST(EditHistory, ADragIsOneStep)
{
	FEditHistory History("c.json", "{\"a\": 0}");
	Edit(History, MakeEdit("1"));
	for (const char* const Value : {"2", "3", "4"})
	{
		Edit(History, MakeEdit(Value), "d1");
	}
	Edit(History, MakeEdit("5"), "d2");
	EXPECT_EQ(4, std::ranges::count(History.GetRecord(), '\n')); // the start, the edit and the drags
	History.Take(History.Undo(), EMove::Undo, "{\"undo\": true}");
	EXPECT_EQ("{\"a\": 4}", History.GetText());
	Edit(History, MakeEdit("6"), "d1"); // it was let go
	History.Take(History.Undo(), EMove::Undo, "{\"undo\": true}");
	EXPECT_EQ("{\"a\": 4}", History.GetText());
	History.Take(History.Undo(), EMove::Undo, "{\"undo\": true}");
	EXPECT_EQ("{\"a\": 1}", History.GetText());
}

TEST(EditHistory, ResetGivesTheStartsValue)
{
	FEditHistory History("c.json", "{\"a\": 0, \"b\": [1]}");
	Edit(History, MakeEdit("1"));
	Edit(History, MakeEdit("2", "/c"));
	Edit(History, MakeEdit("3", "/b/0"));
	EXPECT_EQ("{\"a\": 0, \"b\": [3], \"c\": 2}", History.Reset("/a"));
	EXPECT_EQ("{\"a\": 1, \"b\": [3]}", History.Reset("/c"));
	EXPECT_EQ("{\"a\": 1, \"b\": [1], \"c\": 2}", History.Reset("/b"));
	EXPECT_EQ(History.GetText(), History.Reset("/nowhere"));
	EXPECT_EQ(History.GetStart(), History.Reset(std::nullopt));
}

TEST(EditHistory, TheRecordGivesTheSameState)
{
	FEditHistory History("c.json", "{\"a\": 0} // é \\ \"\n");
	Edit(History, MakeEdit("1"));
	Edit(History, MakeEdit("2"), "d");
	Edit(History, MakeEdit("3"), "d");
	History.Take(History.Undo(), EMove::Undo, "{\"undo\": true}");
	History.Take(History.Redo(), EMove::Redo, "{\"redo\": true}");
	Edit(History, MakeEdit("4", "/b"));
	History.Take(History.Reset("/a"), EMove::Forward, "{\"reset\": \"/a\"}");
	History.Take("{\"b\": 5, \"a\": 7}", EMove::Forward, R"({"text": "{\"b\": 5, \"a\": 7}"})");
	Edit(History, MakeEdit("6", "/c"));
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
		Edit(History, MakeEdit(Number % 2 == 0 ? Long : "1", Number % 2 == 0 ? "/b" : "/a"));
	}
	EXPECT_LT(History.GetRecord().size(), 70'000'000u);
	EXPECT_EQ(History.GetText(), FEditHistory::Replay(History.GetRecord(), "s.jsonl").GetText());
	while (History.CanUndo())
	{
		History.Take(History.Undo(), EMove::Undo, "{\"undo\": true}");
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
	EXPECT_TRUE(FindMistake(Record + MakeLine(MakeEdit("1")) + "\n{\n").starts_with("s.jsonl:3: error DD1122"));
	EXPECT_EQ("", FindMistake(Record + MakeLine(MakeEdit("1")) + "\n"));
}
