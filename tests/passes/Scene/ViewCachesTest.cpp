// Caches of a view: one object of each type, let go by a frame that does not use it.
#include <gtest/gtest.h>

#include "SceneViewState.h"

namespace
{

struct FNumber
{
	int Value = 7;
};

struct FOther
{
	int Value = 8;
};

} // namespace

TEST(ViewCaches, AreFoundByTheNextFrame)
{
	FSceneViewState State(0);
	State.BeginFrame({});
	State.FindOrMakeCache<FNumber>().Value = 1;
	EXPECT_TRUE(State.EndFrame().bHasCaches);
	State.BeginFrame({});
	EXPECT_EQ(1, State.FindOrMakeCache<FNumber>().Value);
}

TEST(ViewCaches, AFrameThatDoesNotUseOneLetsGoOfIt)
{
	FSceneViewState State(0);
	State.BeginFrame({});
	State.FindOrMakeCache<FNumber>().Value = 1;
	State.EndFrame();
	State.BeginFrame({});
	EXPECT_FALSE(State.EndFrame().bHasCaches);
	State.BeginFrame({});
	EXPECT_EQ(7, State.FindOrMakeCache<FNumber>().Value);
}

TEST(ViewCaches, TypesHaveOneEach)
{
	FSceneViewState State(0);
	State.BeginFrame({});
	State.FindOrMakeCache<FNumber>().Value = 1;
	EXPECT_EQ(8, State.FindOrMakeCache<FOther>().Value);
	EXPECT_EQ(1, State.FindOrMakeCache<FNumber>().Value);
}
