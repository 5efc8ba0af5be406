// Whose code runs, what becomes of what it throws, and how a crash is told.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "CodeErrors.h"
#include "CodeScope.h"
#include "CoreMinimal.h"
#include "FaultHandlers.h"
#include "HAL/ConsoleVariableTools.h"

#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <thread>

using namespace Drydock;
using testing::HasSubstr;

namespace
{

const FCodeOwner GHook{.Plugin = "libTint.so", .Callback = "SetupView of extension FTint"};
const FCodeOwner GPass{
	.Plugin = "libTint.so", .Callback = "SetupView of extension FTint", .Pass = "Tint", .File = "Tint.cpp", .Line = 12};
const FCodeOwner GOwnPass{.Pass = "Bloom"};

/** The message that Function ends in as Owner's code. */
template<typename TFunction>
FDiagnostic GetMessage(const FCodeOwner& Owner, TFunction Function, EExitCode ExitCode)
{
	try
	{
		CallCode(Owner, Function);
	}
	catch (const FError& Error)
	{
		EXPECT_EQ(ExitCode, Error.GetExitCode());
		EXPECT_EQ(1u, Error.GetDiagnostics().size());
		return Error.GetDiagnostics()[0];
	}
	ADD_FAILURE() << "nothing came out";
	return {};
}

/** A graph's message that a call of drydock throws. */
[[noreturn]] void Refuse(const std::string& Where)
{
	throw FError({ESeverity::Error, 2006, "the parameter is null", {}, 0, 0, Where}, ExitUsage);
}

} // namespace

TEST(CodeScope, WordsAreThoseOfTheInnermostScope)
{
	EXPECT_STREQ("", GetRunningWords().Text);
	{
		const FCodeScope Outer(GHook);
		EXPECT_STREQ("plugin libTint.so, SetupView of extension FTint", GetRunningWords().Text);
		EXPECT_TRUE(GetRunningWords().bForeign);
		{
			const FCodeScope Inner(GOwnPass);
			EXPECT_STREQ("pass Bloom", GetRunningWords().Text);
			EXPECT_FALSE(IsForeignCodeRunning());
		}
		EXPECT_STREQ("plugin libTint.so, SetupView of extension FTint", GetRunningWords().Text);
		std::thread([] { EXPECT_EQ(nullptr, GetRunningCode()); }).join();
	}
	EXPECT_STREQ("", GetRunningWords().Text);
}

TEST(CodeScope, LongWordsAreCut)
{
	const FCodeOwner Long{.Plugin = std::string(3000, 'x')};
	const FCodeScope Scope(Long);
	EXPECT_EQ(sizeof(GetRunningWords().Text) - 1, std::string(GetRunningWords().Text).size());
}

TEST(CodeScope, WhatAPluginMakesIsThePlugins)
{
	EXPECT_FALSE(MakeCodeOwner("module Tint").IsForeign());
	const FCodeScope Scope(GHook);
	EXPECT_EQ("plugin libTint.so, module Tint", MakeCodeOwner("module Tint").Describe());
}

TEST(CodeScope, ResultsAndReferencesComeOut)
{
	int Value = 7;
	EXPECT_EQ(&Value, &CallCode(GHook, [&]() -> int& { return Value; }));
}

TEST(CodeScope, AnExceptionIsAMessageWithItsTypeAndWords)
{
	const FDiagnostic Message = GetMessage(
		GPass, []() { throw std::out_of_range("there is no fourth"); }, ExitPlugin);
	EXPECT_EQ(
		"Tint.cpp:12: error DD2087 at plugin libTint.so, SetupView of extension FTint, pass Tint: the plugin threw "
		"std::out_of_range: there is no fourth",
		Message.ToString());
	EXPECT_THAT(GetMessage(
					GHook, [] { throw 7; }, ExitPlugin)
					.Message,
		HasSubstr("threw int"));
}

TEST(CodeScope, AFailedCheckOfDrydocksIsACallThatCannotBeDone)
{
	testing::internal::CaptureStderr();
	const FDiagnostic Message = GetMessage(
		GHook, [] { checkf(GHook.Line == 3, TEXT("there are %d"), 2); }, ExitUsage);
	EXPECT_EQ(ErrorPluginCall, Message.Code);
	EXPECT_THAT(Message.Message, HasSubstr("Assertion failed: GHook.Line == 3"));
	EXPECT_THAT(Message.Message, HasSubstr("there are 2"));
	EXPECT_EQ("", testing::internal::GetCapturedStderr()) << "said once, by whoever catches it";
}

TEST(CodeScope, AGraphsMessageGetsTheWordsOnce)
{
	const FDiagnostic Hook = GetMessage(
		GHook, [] { CallCode(GHook, [] { Refuse("CreateSRV"); }); }, ExitUsage);
	EXPECT_EQ("plugin libTint.so, SetupView of extension FTint, CreateSRV", Hook.Where);
	const FDiagnostic Pass = GetMessage(
		GPass, [] { Refuse("pass Tint, parameter Input"); }, ExitUsage);
	EXPECT_EQ("plugin libTint.so, SetupView of extension FTint, pass Tint, parameter Input", Pass.Where);
	EXPECT_EQ(12, Pass.Line);
}

TEST(CodeScope, DrydocksOwnExceptionsComeOutAsTheyAre)
{
	EXPECT_THROW(CallCode(GOwnPass, [] { throw std::runtime_error("ours"); }), std::runtime_error);
	EXPECT_EQ("CreateSRV", GetMessage(
							   GOwnPass, [] { Refuse("CreateSRV"); }, ExitUsage)
							   .Where);
}

// Faults --------------------------------------------------------------------------------------------------------------

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

namespace
{

template<typename TFunction>
void CrashAs(const FCodeOwner& Owner, TFunction Function)
{
	InstallFaultHandlers();
	const FCodeScope Scope(Owner);
	Function();
}

void Write()
{
	volatile int* volatile Nowhere = reinterpret_cast<int*>(8);
	*Nowhere = 1;
}

} // namespace

TEST(FaultDeathTest, APluginsEndsWithItsWordsAndCode)
{
	EXPECT_EXIT(CrashAs(GPass, Write), testing::ExitedWithCode(ExitPlugin),
		"^error DD2086 at plugin libTint.so, SetupView of extension FTint, pass Tint: the plugin crashed: segmentation "
		"fault \\(SIGSEGV\\) at address 0x8");
	EXPECT_EXIT(CrashAs(GHook, [] { std::exit(0); }), testing::ExitedWithCode(ExitPlugin), "the plugin called exit");
}

TEST(FaultDeathTest, OneOutsideAPluginIsDrydocksFault)
{
	EXPECT_EXIT(CrashAs(GOwnPass, Write), testing::ExitedWithCode(ExitInternal),
		"^drydock crashed in pass Bloom: it crashed: segmentation fault .*; this is drydock's fault");
	EXPECT_EXIT(CrashAs(GHook, [] { CrashAs(GOwnPass, [] { std::abort(); }); }), testing::ExitedWithCode(ExitInternal),
		"^drydock crashed in pass Bloom: it called abort; this is drydock's fault");
}

TEST(FaultDeathTest, TheProgramsOwnEndIsNone)
{
	GTEST_FLAG_SET(death_test_style, "threadsafe"); // exit waits for threads of libraries, which a fork does not have
	EXPECT_EXIT(
		{
			CrashAs(GHook, [] {});
			std::exit(3);
		},
		testing::ExitedWithCode(3), "^$");
}

TEST(FaultDeathTest, ASignalFromOutsideDoesWhatItAlwaysDoes)
{
	EXPECT_EXIT(CrashAs(GHook,
					[]
					{
						const std::string Kill = "kill -SEGV " + std::to_string(getpid());
						[[maybe_unused]] const int Status = std::system(Kill.c_str());
					}),
		testing::KilledBySignal(SIGSEGV), "^$");
}

#endif

TEST(FaultDeathTest, APluginThatDoesNotComeBackEndsTheProgram)
{
	GTEST_FLAG_SET(death_test_style, "threadsafe"); // the watcher is a thread
	EXPECT_EXIT(
		{
			const FScopedConsoleVariable Seconds(TEXT("r.Drydock.PluginSeconds"), 0.5f);
			CallCode(GHook, [] { std::this_thread::sleep_for(std::chrono::seconds(30)); });
		},
		testing::ExitedWithCode(ExitPlugin),
		"error DD2089 at plugin libTint.so, SetupView of extension FTint: the plugin has not come back for 0.5 s");
}

TEST(CodeScope, DrydocksOwnWorkIsNotThePluginsSilence)
{
	const FScopedConsoleVariable Seconds(TEXT("r.Drydock.PluginSeconds"), 0.5f);
	CallCode(GHook,
		[]
		{
			const FCodeScope Own(GOwnPass);
			std::this_thread::sleep_for(std::chrono::milliseconds(1500));
		});
}
