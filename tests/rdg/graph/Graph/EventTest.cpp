// Names, scopes, the blackboard.
#include <gtest/gtest.h>

#include "GraphTestBuilder.h"

using namespace Drydock;

namespace
{

struct FFrameTextures
{
	FRDGTextureRef Color = nullptr;
	int32 Count = 0;
};

DECLARE_GPU_STAT(TestStat)

/** Scope of the pass "A". */
std::string GetScope(FGraphTest& Graph)
{
	return Graph.Builder->Compile().FindPass("A")->Scope;
}

} // namespace

RDG_REGISTER_BLACKBOARD_STRUCT(FFrameTextures);

TEST(Event, NamesAreFormatted)
{
	EXPECT_STREQ("Blur 640x360 (Low)", RDG_EVENT_NAME("Blur %dx%d (%s)", 640, 360, TEXT("Low")).GetTCHAR());
	EXPECT_STREQ("Plain", FRDGEventName(TEXT("Plain")).GetTCHAR());
}

TEST(Event, APassIsListedUnderItsScopes)
{
	FGraphTest Graph;
	{
		RDG_EVENT_SCOPE(*Graph.Builder, "Frame %d", 3);
		RDG_EVENT_SCOPE(*Graph.Builder, "Bloom")
		Graph.Pass("A").Writes("X");
	}
	EXPECT_EQ("Frame 3/Bloom", GetScope(Graph));
}

TEST(Event, AClosedScopeIsGone)
{
	FGraphTest Graph;
	{
		RDG_EVENT_SCOPE(*Graph.Builder, "Bloom");
	}
	Graph.Pass("A").Writes("X");
	EXPECT_EQ("", GetScope(Graph));
}

TEST(Event, AConditionalScopeFollowsItsCondition)
{
	FGraphTest Graph;
	{
		RDG_EVENT_SCOPE_CONDITIONAL(*Graph.Builder, false, "No");
		RDG_EVENT_SCOPE_CONDITIONAL(*Graph.Builder, true, "Yes");
		Graph.Pass("A").Writes("X");
	}
	EXPECT_EQ("Yes", GetScope(Graph));
}

TEST(Event, ScopesInsideAFinalOneAreNotRecorded)
{
	FGraphTest Graph;
	{
		RDG_EVENT_SCOPE_FINAL(*Graph.Builder, "Outer");
		RDG_EVENT_SCOPE(*Graph.Builder, "Inner");
		Graph.Pass("A").Writes("X");
	}
	EXPECT_EQ("Outer", GetScope(Graph));
}

TEST(Event, UnlessEventsAreInMode2)
{
	const FScopedConsoleVariable All(TEXT("r.RDG.Events"), 2);
	FGraphTest Graph;
	{
		RDG_EVENT_SCOPE_FINAL(*Graph.Builder, "Outer");
		RDG_EVENT_SCOPE(*Graph.Builder, "Inner");
		Graph.Pass("A").Writes("X");
	}
	EXPECT_EQ("Outer/Inner", GetScope(Graph));
}

TEST(Event, SwitchedOffNoScopeIsRecorded)
{
	const FScopedConsoleVariable Off(TEXT("r.RDG.Events"), 0);
	FGraphTest Graph;
	{
		RDG_EVENT_SCOPE(*Graph.Builder, "Bloom");
		Graph.Pass("A").Writes("X");
	}
	EXPECT_EQ("", GetScope(Graph));
}

TEST(Event, StatScopesCompileWithAndWithoutSemicolon)
{
	FGraphTest Graph;
	RDG_GPU_STAT_SCOPE(*Graph.Builder, TestStat)
	RDG_GPU_STAT_SCOPE(*Graph.Builder, TestStat);
	RDG_CSV_STAT_EXCLUSIVE_SCOPE(*Graph.Builder, TestStat);
	Graph.Pass("A").Writes("X");
	EXPECT_EQ("", GetScope(Graph));
}

TEST(Blackboard, HoldsWhatWasCreated)
{
	FGraphTest Graph;
	Graph.Builder->Blackboard.Create<FFrameTextures>().Count = 5;
	EXPECT_EQ(5, Graph.Builder->Blackboard.Get<FFrameTextures>()->Count);
	EXPECT_EQ(5, Graph.Builder->Blackboard.GetChecked<FFrameTextures>().Count);
}

TEST(Blackboard, HoldsNothingAtFirst)
{
	FGraphTest Graph;
	EXPECT_EQ(nullptr, Graph.Builder->Blackboard.Get<FFrameTextures>());
	EXPECT_THROW(Graph.Builder->Blackboard.GetChecked<FFrameTextures>(), FCheckFailure);
}

TEST(Blackboard, CreatingTwiceIsACheck)
{
	FGraphTest Graph;
	Graph.Builder->Blackboard.Create<FFrameTextures>();
	EXPECT_THROW(Graph.Builder->Blackboard.Create<FFrameTextures>(), FCheckFailure);
}

TEST(Blackboard, GetOrCreateKeepsWhatIsThere)
{
	FGraphTest Graph;
	Graph.Builder->Blackboard.GetOrCreate<FFrameTextures>().Count = 5;
	EXPECT_EQ(5, Graph.Builder->Blackboard.GetOrCreate<FFrameTextures>().Count);
	Graph.Builder->Blackboard.GetMutable<FFrameTextures>()->Count = 6;
	EXPECT_EQ(6, Graph.Builder->Blackboard.Get<FFrameTextures>()->Count);
}

TEST(Blackboard, CreateTakesTheMembers)
{
	FGraphTest Graph;
	EXPECT_EQ(7, Graph.Builder->Blackboard.Create<FFrameTextures>(nullptr, 7).Count);
}
