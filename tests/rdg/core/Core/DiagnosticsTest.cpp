// Diagnostics, suggestions, log lines, paths and modules read as they should.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "CoreMinimal.h"
#include "Diagnostics.h"
#include "Interfaces/IPluginManager.h"
#include "Misc/CoreDelegates.h"
#include "Misc/Paths.h"
#include "Modules/ModuleManager.h"

#include <algorithm>
#include <cctype>
#include <functional>
#include <map>
#include <random>

using Drydock::FDiagnostic;
using Drydock::FindNearestName;

namespace
{

DEFINE_LOG_CATEGORY_STATIC(LogCoreTest, Log, All);

struct FLogRecorder
{
	FLogRecorder()
		: Old(Drydock::SetLogHandler([this](const TCHAR* Category, ELogVerbosity::Type, const std::string& Text)
			  { Lines.push_back(std::string(Category) + "|" + Text); }))
	{
	}
	~FLogRecorder() { Drydock::SetLogHandler(Old); }

	std::vector<std::string> Lines;
	Drydock::FLogHandler Old;
};

/** Tells when it starts and hears the end of the engine's start. */
struct FTestModule : IModuleInterface
{
	static inline std::string Trace;

	void StartupModule() override
	{
		Trace += "start ";
		FCoreDelegates::GetOnPostEngineInit().AddRaw(this, &FTestModule::OnPostEngineInit);
	}
	void ShutdownModule() override { Trace += "shutdown "; }
	void OnPostEngineInit() { Trace += "init "; }
};

} // namespace

TEST(Diagnostics, TextHasPositionCodeAndPlace)
{
	const FDiagnostic Diagnostic{
		Drydock::ESeverity::Error, 1012, "unknown setting", "configs/a.json", 12, 7, "/volumes/0"};
	EXPECT_EQ("configs/a.json:12:7: error DD1012 at /volumes/0: unknown setting", Diagnostic.ToString());
}

TEST(Diagnostics, TextOfAShaderLineIsThatOfACompiler)
{
	EXPECT_EQ("/P/X.usf:12: error: wrong [DD6010]",
		(FDiagnostic{Drydock::ESeverity::Error, 6010, "wrong", "/P/X.usf", 12}.ToString()));
}

TEST(Diagnostics, TextLeavesOutWhatIsUnknown)
{
	EXPECT_EQ("warning: odd", (FDiagnostic{Drydock::ESeverity::Warning, 0, "odd"}.ToString()));
	EXPECT_EQ("a.exr: error DD5001: truncated",
		(FDiagnostic{Drydock::ESeverity::Error, 5001, "truncated", "a.exr"}.ToString()));
	EXPECT_EQ("a.usf:3: note: here", (FDiagnostic{Drydock::ESeverity::Note, 0, "here", "a.usf", 3}.ToString()));
}

TEST(Diagnostics, ErrorCarriesAllItsMessages)
{
	const Drydock::FError Error(
		{{Drydock::ESeverity::Error, 1, "a"}, {Drydock::ESeverity::Error, 2, "b"}}, Drydock::ExitUsage);
	EXPECT_STREQ("error DD1: a\nerror DD2: b", Error.what());
	EXPECT_EQ(2, Error.GetExitCode());
	EXPECT_EQ(2u, Error.GetDiagnostics().size());
}

TEST(NearestName, TakesTheLeastEdits)
{
	EXPECT_EQ(
		"BloomIntensity", FindNearestName("BloomIntensty", {"BloomThreshold", "BloomIntensity", "BloomToonIntensity"}));
}

TEST(NearestName, IgnoresCaseAndCountsExchangesAsOne)
{
	EXPECT_EQ("Bloom", FindNearestName("BLOOM", {"Blood", "Bloom"}));
	EXPECT_EQ("abc", FindNearestName("acb", {"abc"}));
}

TEST(NearestName, IsEmptyWhenNothingIsNear)
{
	EXPECT_EQ("", FindNearestName("Vignette", {"Bloom", "Exposure"}));
	EXPECT_EQ("", FindNearestName("ab", {"ac"}));
	EXPECT_EQ("", FindNearestName("Bloom", {}));
}

namespace
{

/** Edits from A to B, case aside, by trying every way from the ends. */
int MeasureDistance(const std::string& A, const std::string& B)
{
	std::map<std::pair<size_t, size_t>, int> Known;
	const std::function<int(size_t, size_t)> Measure = [&](size_t I, size_t J) -> int
	{
		if (I == 0 || J == 0)
		{
			return int(I + J);
		}
		if (const auto Found = Known.find({I, J}); Found != Known.end())
		{
			return Found->second;
		}
		const auto Same = [&](size_t At, size_t Other)
		{
			return std::tolower(A[At - 1]) == std::tolower(B[Other - 1]);
		};
		int Least = std::min(Measure(I - 1, J), Measure(I, J - 1)) + 1;
		Least = std::min(Least, Measure(I - 1, J - 1) + (Same(I, J) ? 0 : 1));
		if (I > 1 && J > 1 && Same(I, J - 1) && Same(I - 1, J))
		{
			Least = std::min(Least, Measure(I - 2, J - 2) + 1);
		}
		return Known[{I, J}] = Least;
	};
	return Measure(A.size(), B.size());
}

} // namespace

TEST(NearestName, IsTheFirstOfTheNearestByTheWholeTableOfDistances)
{
	std::mt19937 Random(1);
	const auto Draw = [&](size_t Most)
	{
		std::string Name(Random() % (Most + 1), ' ');
		for (char& Letter : Name)
		{
			Letter = "abcA"[Random() % 4];
		}
		return Name;
	};
	for (int Round = 0; Round < 3000; ++Round)
	{
		const std::string Name = Draw(9);
		std::vector<std::string> Candidates(Random() % 6);
		for (std::string& Candidate : Candidates)
		{
			Candidate = Draw(9);
		}
		std::string Nearest;
		int Least = 1000;
		for (const std::string& Candidate : Candidates)
		{
			const int Distance = MeasureDistance(Name, Candidate);
			if (3 * Distance <= int(std::max(Name.size(), Candidate.size())) && Distance < Least)
			{
				Nearest = Candidate;
				Least = Distance;
			}
		}
		ASSERT_EQ(Nearest, FindNearestName(Name, Candidates)) << "round " << Round << ", " << Name;
	}
}

TEST(Log, LinesCarryCategoryAndText)
{
	FLogRecorder Recorder;
	UE_LOG(LogCoreTest, Warning, TEXT("%s has %d mips"), *FString("Blur"), 3);
	EXPECT_THAT(Recorder.Lines, testing::ElementsAre("LogCoreTest|Blur has 3 mips"));
}

TEST(Log, VerboseLinesAreHeldBack)
{
	FLogRecorder Recorder;
	UE_LOG(LogCoreTest, Verbose, TEXT("suppressed by the category"));
	UE_LOG(LogTemp, Verbose, TEXT("suppressed for all"));
	UE_CLOG(false, LogTemp, Error, TEXT("not true"));
	EXPECT_TRUE(Recorder.Lines.empty());
}

TEST(Log, VerbosityOpensForAll)
{
	FLogRecorder Recorder;
	Drydock::SetLogVerbosity(ELogVerbosity::Verbose);
	UE_LOG(LogTemp, Verbose, TEXT("now"));
	Drydock::SetLogVerbosity(ELogVerbosity::Log);
	EXPECT_THAT(Recorder.Lines, testing::ElementsAre("LogTemp|now"));
}

TEST(Log, GoesToStderr)
{
	testing::internal::CaptureStderr();
	UE_LOG(LogTemp, Warning, TEXT("careful"));
	EXPECT_EQ("LogTemp: Warning: careful\n", testing::internal::GetCapturedStderr());
}

TEST(Log, FatalIsAFailedCheck)
{
	EXPECT_THROW(UE_LOG(LogTemp, Fatal, TEXT("the end")), Drydock::FCheckFailure);
}

TEST(Paths, CombineUsesOneSlash)
{
	EXPECT_STREQ("a/b/c.usf", *FPaths::Combine(FString("a/"), TEXT("b"), TEXT("/c.usf")));
	EXPECT_STREQ("a/c", *FPaths::Combine(TEXT("a"), TEXT(""), TEXT("c")));
}

TEST(Paths, TakesNamesApart)
{
	EXPECT_STREQ("Blur.usf", *FPaths::GetCleanFilename("/Engine/Private/Blur.usf"));
	EXPECT_STREQ("Blur", *FPaths::GetBaseFilename("/Engine/Private/Blur.usf"));
	EXPECT_STREQ("/Engine/Private", *FPaths::GetPath("/Engine/Private/Blur.usf"));
	EXPECT_STREQ("usf", *FPaths::GetExtension("Blur.usf"));
	EXPECT_STREQ("", *FPaths::GetExtension("Blur"));
}

TEST(Paths, NormalizesDots)
{
	EXPECT_STREQ("/a/c", *FPaths::ConvertRelativePathToFull("/a/b", "../c"));
	EXPECT_FALSE(FPaths::FileExists("/nowhere/at/all"));
}

TEST(Modules, StartOnceAndHearTheEngineOnce)
{
	FTestModule::Trace.clear();
	{
		const Drydock::FModuleRegistration Registration(
			"CoreTestModule", []() -> IModuleInterface* { return new FTestModule; });
		EXPECT_FALSE(FModuleManager::Get().IsModuleLoaded("CoreTestModule"));
		FModuleManager::Get().StartupPendingModules();
		FModuleManager::Get().StartupPendingModules();
		EXPECT_TRUE(FModuleManager::Get().IsModuleLoaded("CoreTestModule"));
	}
	EXPECT_EQ("start init shutdown ", FTestModule::Trace);
}

TEST(Modules, UnknownOnesAreNull)
{
	EXPECT_EQ(nullptr, FModuleManager::Get().LoadModule("CoreTestNobody"));
	EXPECT_THROW(FModuleManager::Get().LoadModuleChecked("CoreTestNobody"), Drydock::FCheckFailure);
}

TEST(Plugins, AreFoundByName)
{
	IPluginManager::Get().RegisterPlugin("CoreTestPlugin", "/plugins/core");
	EXPECT_STREQ("/plugins/core", *IPluginManager::Get().FindPlugin(TEXT("coretestplugin"))->GetBaseDir());
	EXPECT_FALSE(IPluginManager::Get().FindPlugin(TEXT("CoreTestOther")).IsValid());
}

TEST(Version, ComparesWithTheDefault)
{
	EXPECT_EQ(5, ENGINE_MAJOR_VERSION);
	EXPECT_TRUE(UE_VERSION_OLDER_THAN(ENGINE_MAJOR_VERSION, ENGINE_MINOR_VERSION + 1, 0));
	EXPECT_TRUE(UE_VERSION_NEWER_THAN_OR_EQUAL(ENGINE_MAJOR_VERSION, ENGINE_MINOR_VERSION, 0));
	EXPECT_TRUE(UE_VERSION_OLDER_THAN(6, 0, 0));
}
