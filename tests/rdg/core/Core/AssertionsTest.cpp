// A failed check or ensure leaves behind what it should.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Misc/AssertionMacros.h"

using testing::HasSubstr;

namespace
{

std::string GetFailure(const std::function<void()>& Function)
{
	try
	{
		Function();
	}
	catch (const Drydock::FCheckFailure& Failure)
	{
		return Failure.what();
	}
	return "";
}

/** Collects ensures for the length of a test. */
struct FEnsureRecorder
{
	FEnsureRecorder()
		: Old(Drydock::SetEnsureHandler([this](const std::string& Text) { Messages.push_back(Text); }))
	{
	}
	~FEnsureRecorder() { Drydock::SetEnsureHandler(Old); }

	std::vector<std::string> Messages;
	Drydock::FEnsureHandler Old;
};

} // namespace

TEST(Assertions, CheckThatHoldsDoesNothing)
{
	EXPECT_EQ("", GetFailure([] { check(1 + 1 == 2); }));
}

TEST(Assertions, FailedCheckNamesExpressionFileAndLine)
{
	const int Line = __LINE__ + 1;
	const std::string Text = GetFailure([] { check(2 < 1); });
	EXPECT_EQ(
		std::string("Assertion failed: 2 < 1 [File:") + __FILE__ + "] [Line: " + std::to_string(Line) + "]", Text);
}

TEST(Assertions, CheckfFormatsItsMessage)
{
	EXPECT_THAT(GetFailure([] { checkf(false, "%s is %d", "seven", 7); }), HasSubstr("] seven is 7"));
}

TEST(Assertions, FailedCheckPrintsOnStderr)
{
	testing::internal::CaptureStderr();
	GetFailure([] { checkf(false, "the pass Blur"); });
	EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("Assertion failed: false"));
}

TEST(Assertions, CheckEvaluatesOnce)
{
	int Count = 0;
	check(++Count > 0);
	EXPECT_EQ(1, Count);
}

TEST(Assertions, VerifyEvaluatesOnce)
{
	int Count = 0;
	verify(++Count > 0);
	EXPECT_EQ(1, Count);
}

TEST(Assertions, CheckIsOneStatementBeforeElse)
{
	bool bElse = false;
	if (bElse)
		check(true);
	else
		bElse = true;
	EXPECT_TRUE(bElse);
}

TEST(Assertions, CheckNoEntryFails)
{
	EXPECT_THAT(GetFailure([] { checkNoEntry(); }), HasSubstr("should never be called"));
}

TEST(Assertions, EnsureYieldsTheValue)
{
	FEnsureRecorder Recorder;
	EXPECT_TRUE(ensure(1 == 1));
	EXPECT_FALSE(ensure(1 == 2));
	EXPECT_EQ(1u, Recorder.Messages.size());
}

TEST(Assertions, EnsureNamesTheExpression)
{
	FEnsureRecorder Recorder;
	ensureMsgf(1 == 2, "because %d", 3);
	ASSERT_EQ(1u, Recorder.Messages.size());
	EXPECT_THAT(Recorder.Messages[0], testing::StartsWith("Ensure condition failed: 1 == 2 [File:"));
	EXPECT_THAT(Recorder.Messages[0], testing::EndsWith("] because 3"));
}

TEST(Assertions, EnsurePrintsOncePerSite)
{
	testing::internal::CaptureStderr();
	for (int Index = 0; Index < 3; ++Index)
	{
		ensureMsgf(Index < 0, "site A");
	}
	ensureMsgf(false, "site B");
	const std::string Text = testing::internal::GetCapturedStderr();
	EXPECT_EQ(2, std::count(Text.begin(), Text.end(), '\n'));
}

TEST(Assertions, EnsureAlwaysPrintsEveryTime)
{
	testing::internal::CaptureStderr();
	for (int Index = 0; Index < 3; ++Index)
	{
		ensureAlwaysMsgf(Index < 0, "again");
	}
	const std::string Text = testing::internal::GetCapturedStderr();
	EXPECT_EQ(3, std::count(Text.begin(), Text.end(), '\n'));
}

TEST(Assertions, EnsuresAreCounted)
{
	FEnsureRecorder Recorder;
	const uint64 Before = Drydock::GetEnsureCount();
	for (int Index = 0; Index < 3; ++Index)
	{
		ensure(Index == 0);
	}
	EXPECT_EQ(Before + 2, Drydock::GetEnsureCount());
}
