// Dates, texts, numbered names, variants, structured logs, tasks and the application say what the engine's do.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "Async/Async.h"
#include "CoreMinimal.h"
#include "Logging/StructuredLog.h"
#include "Misc/App.h"
#include "Misc/TVariant.h"

TEST(DateTime, CountsDaysAndWritesThem)
{
	const FDateTime Date(2024, 2, 29, 14, 3, 5, 250);
	EXPECT_EQ(638448121852500000, Date.GetTicks());
	EXPECT_EQ(2024, Date.GetYear());
	EXPECT_EQ(2, Date.GetMonth());
	EXPECT_EQ(29, Date.GetDay());
	EXPECT_EQ(1709215385, Date.ToUnixTimestamp());
	EXPECT_EQ(FString("2024.02.29-14.03.05"), Date.ToString());
	EXPECT_EQ(FString("2024-02-29T14:03:05.250Z"), Date.ToIso8601());
	EXPECT_EQ(FDateTime(1970, 1, 1), FDateTime::FromUnixTimestamp(0));
	EXPECT_EQ(FDateTime(2024, 3, 1, 2, 3, 5, 250), Date + FTimespan::FromHours(12.0));
	EXPECT_EQ(86400.0, (FDateTime(2024, 3, 1) - FDateTime(2024, 2, 29)).GetTotalSeconds());
	EXPECT_THROW(FDateTime(2023, 2, 29), Drydock::FCheckFailure);
	EXPECT_GT(FDateTime::UtcNow(), FDateTime(2020, 1, 1));
	EXPECT_LE((FDateTime::Now() - FDateTime::UtcNow()).GetTotalHours(), 15.0);
	EXPECT_EQ(90.5, FTimespan::FromSeconds(90.5).GetTotalSeconds());
	EXPECT_EQ(30, FTimespan::FromSeconds(90.5).GetSeconds());
}

#define LOCTEXT_NAMESPACE "Everyday"

TEST(Text, FormatsByPlace)
{
	const FText Text = FText::Format(LOCTEXT("Key", "{1} before {0}, `{0} {7}"), 2.5, INVTEXT("one"));
	EXPECT_EQ(FString("one before 2.5, {0} {7}"), Text.ToString());
	EXPECT_TRUE(FText::GetEmpty().IsEmpty());
	EXPECT_TRUE(FText::FromName(FName("A")).EqualTo(FText::FromString("A")));
	EXPECT_EQ(FString("12"), FText::AsNumber(12).ToString());
	EXPECT_EQ(FString("named"), NSLOCTEXT("Space", "Key", "named").ToString());
}

#undef LOCTEXT_NAMESPACE

TEST(Name, NumbersAreWrittenBehindTheName)
{
	const FName Third(TEXT("Light"), 3);
	EXPECT_EQ(FString("Light_2"), Third.ToString());
	EXPECT_EQ(FName("Light_2"), Third);
	EXPECT_EQ(3, Third.GetNumber());
	EXPECT_EQ(FString("Light"), Third.GetPlainNameString());
	EXPECT_EQ(FName("Light"), FName(Third, NAME_NO_NUMBER_INTERNAL));
	EXPECT_EQ(FName("Light_7"), FName(FName("Light"), NAME_EXTERNAL_TO_INTERNAL(7)));
	EXPECT_EQ(0, FName("Light").GetNumber());
	// Leading zeros, and numbers that do not fit, are part of the name.
	EXPECT_EQ(0, FName("Light_02").GetNumber());
	EXPECT_EQ(0, FName("Light_99999999999").GetNumber());
	EXPECT_EQ(0, FName("_5").GetNumber());
}

TEST(Variant, HoldsOneOfItsTypes)
{
	TVariant<FEmptyVariantState, int32, FString> Variant;
	EXPECT_TRUE(Variant.IsType<FEmptyVariantState>());
	Variant.Set<FString>("text");
	EXPECT_EQ(2u, Variant.GetIndex());
	EXPECT_EQ(FString("text"), Variant.Get<FString>());
	EXPECT_EQ(nullptr, Variant.TryGet<int32>());
	EXPECT_THROW(Variant.Get<int32>(), Drydock::FCheckFailure);
	Variant.Emplace<int32>(4);
	EXPECT_EQ(4, Variant.Get<int32>());
	const TVariant<int32, float> Number(TInPlaceType<float>(), 2.5f);
	EXPECT_EQ(5.0, Visit([](auto Value) { return 2.0 * Value; }, Number));
}

TEST(StructuredLog, FieldsAreFilledInOrderOrByName)
{
	std::vector<std::string> Lines;
	const Drydock::FLogHandler Before = Drydock::SetLogHandler(
		[&Lines](const TCHAR*, ELogVerbosity::Type, const std::string& Text) { Lines.push_back(Text); });
	UE_LOGFMT(LogTemp, Warning, "plain {{braces}} {Missing}");
	UE_LOGFMT(LogTemp, Warning, "{A} of {B}: {C}", 3, FString("four"), TEXT("five"));
	UE_LOGFMT(LogTemp, Warning, "{A} of {B}, {A}", ("B", 2.5f), ("A", true));
	UE_LOGFMT(LogTemp, Warning, "{Name}", FName("It"));
	Drydock::SetLogHandler(Before);
	EXPECT_EQ(
		(std::vector<std::string>{"plain {braces} {Missing}", "3 of four: five", "true of 2.5, true", "It"}), Lines);
}

TEST(Async, ATaskIsOverWhenTheCallReturns)
{
	int32 Ran = 0;
	AsyncTask(ENamedThreads::GameThread, [&Ran] { ++Ran; });
	AsyncTask(ENamedThreads::AnyBackgroundThreadNormalTask, [&Ran] { ++Ran; });
	EXPECT_EQ(2, Ran);
}

// As plugins wait for a readback.
TEST(Async, ATaskThatStartsItselfUntilSomethingHasHappenedWaitsForTheEndOfTheFrame)
{
	struct FPoll
	{
		bool bReady = false;
		bool bDone = false;
		int32 Looks = 0;

		void Look()
		{
			++Looks;
			bDone = bReady;
			if (!bReady)
			{
				AsyncTask(ENamedThreads::AnyThread, [this] { Look(); });
			}
		}
	} Poll;
	AsyncTask(ENamedThreads::AnyThread, [&Poll] { Poll.Look(); });
	EXPECT_FALSE(Poll.bDone);
	const int32 Before = Poll.Looks;
	Drydock::RunWaitingTasks();
	EXPECT_EQ(Before + 1, Poll.Looks);
	Poll.bReady = true;
	Drydock::RunWaitingTasks();
	EXPECT_TRUE(Poll.bDone);
	const int32 After = Poll.Looks;
	Drydock::RunWaitingTasks();
	EXPECT_EQ(After, Poll.Looks);
}

TEST(Async, TasksWithinTasksAreOverWhenTheCallReturns)
{
	int32 Ran = 0;
	AsyncTask(ENamedThreads::AnyBackgroundThreadNormalTask, [&Ran]
		{ AsyncTask(ENamedThreads::GameThread, [&Ran] { AsyncTask(ENamedThreads::AnyThread, [&Ran] { ++Ran; }); }); });
	EXPECT_EQ(1, Ran);
}

TEST(App, HasNoUserAndTheTimeThatItIsGiven)
{
	EXPECT_TRUE(FApp::CanEverRender());
	EXPECT_TRUE(FApp::IsUnattended());
	EXPECT_DOUBLE_EQ(1.0 / 30.0, FApp::GetFixedDeltaTime());
	FApp::SetCurrentTime(2.0);
	FApp::UpdateLastTime();
	FApp::SetCurrentTime(2.5);
	FApp::SetDeltaTime(0.5);
	EXPECT_EQ(2.5, FApp::GetCurrentTime());
	EXPECT_EQ(2.0, FApp::GetLastTime());
	EXPECT_EQ(0.5, FApp::GetDeltaTime());
	EXPECT_EQ(FApp::HasProjectName(), *FApp::GetProjectName() != '\0');
}

TEST(ConsoleCommand, WorldAndArgumentsReachIt)
{
	TArray<FString> Seen;
	UWorld* World = reinterpret_cast<UWorld*>(&Seen);
	{
		const FAutoConsoleCommandWithWorldAndArgs Command(TEXT("Test.Everyday"), TEXT("Help"),
			FConsoleCommandWithWorldAndArgsDelegate::CreateLambda(
				[&](const TArray<FString>& Arguments, UWorld* InWorld)
				{
					Seen = Arguments;
					World = InWorld;
				}));
		IConsoleManager::Get().ProcessUserConsoleInput(TEXT("Test.Everyday one 2"));
	}
	EXPECT_EQ((TArray<FString>{"one", "2"}), Seen);
	EXPECT_EQ(Drydock::GetConsoleWorld(), World);
	EXPECT_FALSE(IConsoleManager::Get().IsNameRegistered(TEXT("Test.Everyday")));
}
