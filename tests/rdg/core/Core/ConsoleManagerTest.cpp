// Console variables keep to their types, precedence, callbacks, listing and checked setting.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "CoreMinimal.h"
#include "HAL/ConsoleVariableTools.h"

using testing::HasSubstr;

namespace
{

TAutoConsoleVariable<int32> CVarInt(TEXT("r.CoreTest.Int"), 1, TEXT("An int."), ECVF_RenderThreadSafe);
TAutoConsoleVariable<float> CVarFloat(TEXT("r.CoreTest.Float"), 0.5f, TEXT("A float."));
TAutoConsoleVariable<bool> CVarBool(TEXT("r.CoreTest.Bool"), false, TEXT("A ") TEXT("bool."));
TAutoConsoleVariable<FString> CVarString(TEXT("r.CoreTest.String"), TEXT("none"), TEXT("Some text."));
float GReference = 2.0f;
FAutoConsoleVariableRef CVarReference(TEXT("r.CoreTest.Reference"), GReference, TEXT("A C++ float."));

/** Every test starts and ends with defaults, and sees what is logged. */
struct ConsoleManager : testing::Test
{
	void SetUp() override
	{
		OldHandler = Drydock::SetLogHandler(
			[this](const TCHAR*, ELogVerbosity::Type, const std::string& Text) { Log += Text + "\n"; });
	}
	void TearDown() override
	{
		Drydock::ResetConsoleVariables();
		Drydock::SetLogHandler(OldHandler);
	}

	static IConsoleVariable* Find(const TCHAR* Name) { return IConsoleManager::Get().FindConsoleVariable(Name); }

	Drydock::FLogHandler OldHandler;
	std::string Log;
	FString Error;
};

} // namespace

TEST_F(ConsoleManager, StartsWithDefaults)
{
	EXPECT_EQ(1, CVarInt.GetValueOnRenderThread());
	EXPECT_EQ(0.5f, CVarFloat.GetValueOnAnyThread());
	EXPECT_FALSE(CVarBool.GetValueOnGameThread());
	EXPECT_STREQ("none", *CVarString.GetValueOnAnyThread());
}

TEST_F(ConsoleManager, FindsNamesWithoutCase)
{
	EXPECT_EQ(CVarInt.AsVariable(), Find(TEXT("R.CORETEST.int")));
	EXPECT_EQ(nullptr, Find(TEXT("r.CoreTest.Nothing")));
}

TEST_F(ConsoleManager, CodeSetsBetweenGraphs)
{
	Find(TEXT("r.CoreTest.Int"))->Set(0);
	EXPECT_EQ(0, CVarInt.GetValueOnRenderThread());
	Find(TEXT("r.CoreTest.Int"))->Set(5);
	EXPECT_EQ(5, CVarInt->GetInt());
	EXPECT_EQ(ECVF_SetByCode, CVarInt->GetFlags() & ECVF_SetByMask);
}

TEST_F(ConsoleManager, ConvertsNumbersToTheType)
{
	CVarInt->Set(2.9f);
	CVarFloat->Set(3);
	CVarBool->Set(7);
	EXPECT_EQ(2, CVarInt->GetInt());
	EXPECT_EQ(3.0f, CVarFloat->GetFloat());
	EXPECT_TRUE(CVarBool->GetBool());
	EXPECT_EQ(1, CVarBool->GetInt());
}

TEST_F(ConsoleManager, HugeNumbersStayInRange)
{
	CVarInt->Set(1e20f);
	EXPECT_EQ(MAX_int32, CVarInt->GetInt());
	CVarFloat->Set(1e20f);
	EXPECT_EQ(MAX_int32, CVarFloat->GetInt());
}

TEST_F(ConsoleManager, TextGivesAndTakesValues)
{
	CVarFloat->Set(TEXT("0.25"));
	CVarBool->Set(TEXT("True"));
	EXPECT_STREQ("0.25", *CVarFloat->GetString());
	EXPECT_STREQ("true", *CVarBool->GetString());
	EXPECT_STREQ("0.5", *CVarFloat->GetDefaultValue());
}

TEST_F(ConsoleManager, LowerPriorityIsIgnoredWithAWarning)
{
	CVarInt->Set(2, ECVF_SetByCommandline);
	CVarInt->Set(3, ECVF_SetByProjectSetting);
	EXPECT_EQ(2, CVarInt->GetInt());
	EXPECT_THAT(Log, HasSubstr("'r.CoreTest.Int' with 'SetByProjectSetting' was ignored"));
	EXPECT_THAT(Log, HasSubstr("'SetByCommandline'. Value remains '2'"));
}

TEST_F(ConsoleManager, SameAndHigherPrioritySet)
{
	CVarInt->Set(2, ECVF_SetByScalability);
	CVarInt->Set(3, ECVF_SetByScalability);
	CVarInt->Set(4, ECVF_SetByConsole);
	EXPECT_EQ(4, CVarInt->GetInt());
	EXPECT_EQ("", Log);
}

TEST_F(ConsoleManager, PrioritiesRiseAsInTheEngine)
{
	const EConsoleVariableFlags Rising[] = {ECVF_SetByConstructor, ECVF_SetByScalability, ECVF_SetByGameSetting,
		ECVF_SetByProjectSetting, ECVF_SetBySystemSettingsIni, ECVF_SetByDeviceProfile, ECVF_SetByConsoleVariablesIni,
		ECVF_SetByCommandline, ECVF_SetByCode, ECVF_SetByConsole};
	for (SIZE_T Index = 1; Index < UE_ARRAY_COUNT(Rising); ++Index)
	{
		EXPECT_LT(static_cast<uint32>(Rising[Index - 1]), static_cast<uint32>(Rising[Index]));
	}
}

TEST_F(ConsoleManager, CallbackRunsAfterTheSet)
{
	int32 Seen = 0;
	CVarInt->SetOnChangedCallback(
		FConsoleVariableDelegate::CreateLambda([&Seen](IConsoleVariable* Variable) { Seen = Variable->GetInt(); }));
	CVarInt->Set(8);
	EXPECT_EQ(8, Seen);
	Drydock::ResetConsoleVariables();
	EXPECT_EQ(1, Seen);
	CVarInt->OnChangedDelegate().Clear();
}

TEST_F(ConsoleManager, IgnoredSetRunsNoCallback)
{
	int32 Calls = 0;
	CVarInt->Set(2, ECVF_SetByConsole);
	CVarInt->SetOnChangedCallback(FConsoleVariableDelegate::CreateLambda([&Calls](IConsoleVariable*) { ++Calls; }));
	CVarInt->Set(3, ECVF_SetByCode);
	EXPECT_EQ(0, Calls);
	CVarInt->OnChangedDelegate().Clear();
}

TEST_F(ConsoleManager, ReferenceWritesThroughAndReadsBack)
{
	CVarReference->Set(4.5f);
	EXPECT_EQ(4.5f, GReference);
	GReference = 6.0f;
	EXPECT_EQ(6.0f, CVarReference->GetFloat());
	Drydock::ResetConsoleVariables();
	EXPECT_EQ(2.0f, GReference);
}

TEST_F(ConsoleManager, TypedDataIsFoundByItsTypeOnly)
{
	EXPECT_EQ(
		0.5f, IConsoleManager::Get().FindTConsoleVariableDataFloat(TEXT("r.CoreTest.Float"))->GetValueOnRenderThread());
	EXPECT_EQ(nullptr, IConsoleManager::Get().FindTConsoleVariableDataInt(TEXT("r.CoreTest.Float")));
}

TEST_F(ConsoleManager, SameNameAndTypeShareOneVariable)
{
	TAutoConsoleVariable<int32> Second(TEXT("r.CoreTest.Int"), 9, TEXT("Again."));
	EXPECT_EQ(CVarInt.AsVariable(), Second.AsVariable());
	EXPECT_EQ(1, Second.GetValueOnAnyThread());
}

TEST_F(ConsoleManager, SameNameOfAnotherTypeIsAnError)
{
	TAutoConsoleVariable<float> Second(TEXT("r.CoreTest.Int"), 9.0f, TEXT("Again."));
	EXPECT_THAT(Log, HasSubstr("'r.CoreTest.Int' already exists"));
	EXPECT_EQ(9.0f, Second.GetValueOnAnyThread());
	EXPECT_EQ(CVarInt.AsVariable(), Find(TEXT("r.CoreTest.Int")));
}

TEST_F(ConsoleManager, VariableOfAScopeGoesWithIt)
{
	{
		TAutoConsoleVariable<int32> Local(TEXT("r.CoreTest.Local"), 1, TEXT("Local."));
		EXPECT_NE(nullptr, Find(TEXT("r.CoreTest.Local")));
	}
	EXPECT_EQ(nullptr, Find(TEXT("r.CoreTest.Local")));
}

TEST_F(ConsoleManager, ListIsSortedAndComplete)
{
	CVarInt->Set(3, ECVF_SetByCommandline);
	const TArray<Drydock::FConsoleVariableInfo> List = Drydock::ListConsoleVariables(TEXT("r.coretest."));
	ASSERT_EQ(5, List.Num());
	EXPECT_STREQ("r.CoreTest.Bool", *List[0].Name);
	EXPECT_STREQ("A bool.", *List[0].Help);
	EXPECT_STREQ("int32", *List[2].Type);
	EXPECT_STREQ("3", *List[2].Value);
	EXPECT_STREQ("1", *List[2].Default);
	EXPECT_STREQ("Commandline", *List[2].SetBy);
	EXPECT_STREQ("r.CoreTest.String", *List[4].Name);
}

TEST_F(ConsoleManager, CheckedSetTakesWhatFits)
{
	EXPECT_TRUE(Drydock::TrySetConsoleVariable("r.coretest.int", "-12", ECVF_SetByCommandline, Error));
	EXPECT_TRUE(Drydock::TrySetConsoleVariable("r.CoreTest.Float", "+1.5e-3", ECVF_SetByCommandline, Error));
	EXPECT_TRUE(Drydock::TrySetConsoleVariable("r.CoreTest.Bool", "On", ECVF_SetByCommandline, Error));
	EXPECT_TRUE(Drydock::TrySetConsoleVariable("r.CoreTest.String", "any text", ECVF_SetByCommandline, Error));
	EXPECT_EQ(-12, CVarInt->GetInt());
	EXPECT_EQ(1.5e-3f, CVarFloat->GetFloat());
	EXPECT_TRUE(CVarBool->GetBool());
	EXPECT_STREQ("any text", *CVarString->GetString());
}

TEST_F(ConsoleManager, CheckedSetNamesTheExpectedType)
{
	EXPECT_FALSE(Drydock::TrySetConsoleVariable("r.CoreTest.Int", "1.5", ECVF_SetByCommandline, Error));
	EXPECT_STREQ("console variable r.CoreTest.Int expects an int32: a whole number, not \"1.5\"", *Error);
	EXPECT_EQ(1, CVarInt->GetInt());
}

TEST_F(ConsoleManager, CheckedSetRefusesNonsense)
{
	for (const TCHAR* Text : {"", "abc", "1x", "nan", "inf", "99999999999999999999"})
	{
		EXPECT_FALSE(Drydock::TrySetConsoleVariable("r.CoreTest.Int", Text, ECVF_SetByCommandline, Error)) << Text;
	}
	for (const TCHAR* Text : {"", "abc", "1x", "nan", "inf", "1e99"})
	{
		EXPECT_FALSE(Drydock::TrySetConsoleVariable("r.CoreTest.Float", Text, ECVF_SetByCommandline, Error)) << Text;
	}
	EXPECT_FALSE(Drydock::TrySetConsoleVariable("r.CoreTest.Bool", "2", ECVF_SetByCommandline, Error));
}

TEST_F(ConsoleManager, UnknownNameGetsASuggestion)
{
	EXPECT_FALSE(Drydock::TrySetConsoleVariable("r.CoreTest.Flaot", "1", ECVF_SetByCommandline, Error));
	EXPECT_STREQ("unknown console variable r.CoreTest.Flaot; did you mean r.CoreTest.Float?", *Error);
}

TEST_F(ConsoleManager, ScopedValuePutsBackValueAndPriority)
{
	CVarInt->Set(3, ECVF_SetByProjectSetting);
	{
		const Drydock::FScopedConsoleVariable Scoped(TEXT("r.CoreTest.Int"), 7);
		EXPECT_EQ(7, CVarInt->GetInt());
	}
	EXPECT_EQ(3, CVarInt->GetInt());
	EXPECT_EQ(ECVF_SetByProjectSetting, CVarInt->GetFlags() & ECVF_SetByMask);
}

TEST_F(ConsoleManager, CommandsReceiveTheirArguments)
{
	FString Received;
	FAutoConsoleCommand Command(TEXT("CoreTest.Command"), TEXT("A command."),
		FConsoleCommandWithArgsDelegate::CreateLambda(
			[&Received](const TArray<FString>& Arguments) { Received = FString::Join(Arguments, "|"); }));
	EXPECT_TRUE(IConsoleManager::Get().ProcessUserConsoleInput(TEXT("coretest.command a  b")));
	EXPECT_STREQ("a|b", *Received);
	EXPECT_FALSE(IConsoleManager::Get().ProcessUserConsoleInput(TEXT("CoreTest.Nothing")));
}

TEST_F(ConsoleManager, ConsoleInputBeatsEveryone)
{
	CVarFloat->Set(2.0f, ECVF_SetByCode);
	EXPECT_TRUE(IConsoleManager::Get().ProcessUserConsoleInput(TEXT("r.CoreTest.Float 8")));
	EXPECT_EQ(8.0f, CVarFloat->GetFloat());
}

TEST_F(ConsoleManager, ConsoleInputTakesAnEqualsSign)
{
	EXPECT_TRUE(IConsoleManager::Get().ProcessUserConsoleInput(TEXT(" r.CoreTest.Int = 6 ")));
	EXPECT_EQ(6, CVarInt->GetInt());
	EXPECT_TRUE(IConsoleManager::Get().ProcessUserConsoleInput(TEXT("r.CoreTest.String=\"two words\"")));
	EXPECT_STREQ("two words", *CVarString->GetString());
}

TEST_F(ConsoleManager, BareNameLogsTheValueAndItsSetter)
{
	CVarInt->Set(3, ECVF_SetByCommandline);
	EXPECT_TRUE(IConsoleManager::Get().ProcessUserConsoleInput(TEXT("r.CoreTest.Int")));
	EXPECT_EQ("r.CoreTest.Int = \"3\"      LastSetBy: Commandline\n", Log);
}

TEST_F(ConsoleManager, QuestionMarkLogsTheHelp)
{
	EXPECT_TRUE(IConsoleManager::Get().ProcessUserConsoleInput(TEXT("r.CoreTest.Bool ?")));
	EXPECT_EQ("HELP for 'r.CoreTest.Bool':\nA bool.\nr.CoreTest.Bool = \"false\"      LastSetBy: Constructor\n", Log);
}

TEST_F(ConsoleManager, ConsoleInputOfAnotherTypeChangesNothing)
{
	EXPECT_TRUE(IConsoleManager::Get().ProcessUserConsoleInput(TEXT("r.CoreTest.Int many")));
	EXPECT_EQ(1, CVarInt->GetInt());
	EXPECT_THAT(Log, HasSubstr("r.CoreTest.Int expects an int32"));
}

TEST_F(ConsoleManager, AutoVariableHasTheTypeOfItsDefault)
{
	FAutoConsoleVariable Number(TEXT("r.CoreTest.AutoFloat"), 1.5f, TEXT("A float."), ECVF_RenderThreadSafe);
	FAutoConsoleVariable Text(TEXT("r.CoreTest.AutoText"), TEXT("abc"), TEXT("A text."));
	EXPECT_TRUE(Number->IsVariableFloat());
	EXPECT_TRUE(Text->IsVariableString());
	EXPECT_EQ(1.5f, Find(TEXT("r.CoreTest.AutoFloat"))->GetFloat());
}

TEST_F(ConsoleManager, ReferencesOfEveryTypeWriteThrough)
{
	int32 Int = 1;
	bool bBool = false;
	FString Text = "old";
	FAutoConsoleVariableRef IntVariable(TEXT("r.CoreTest.RefInt"), Int, TEXT("An int."));
	FAutoConsoleVariableRef BoolVariable(TEXT("r.CoreTest.RefBool"), bBool, TEXT("A bool."));
	FAutoConsoleVariableRef TextVariable(TEXT("r.CoreTest.RefText"), Text, TEXT("A text."));
	IntVariable->Set(7);
	BoolVariable->Set(true);
	TextVariable->Set(TEXT("new"));
	EXPECT_EQ(7, Int);
	EXPECT_TRUE(bBool);
	EXPECT_STREQ("new", *Text);
}

TEST_F(ConsoleManager, SinkRunsOnceAfterAllChanges)
{
	int32 Calls = 0;
	FAutoConsoleVariableSink Sink(FConsoleCommandDelegate::CreateLambda([&Calls]() { ++Calls; }));
	CVarInt->Set(2);
	CVarFloat->Set(2.0f);
	IConsoleManager::Get().CallAllConsoleVariableSinks();
	EXPECT_EQ(1, Calls);
	IConsoleManager::Get().CallAllConsoleVariableSinks();
	EXPECT_EQ(1, Calls);
}

TEST_F(ConsoleManager, SinkEndsWithItsObject)
{
	int32 Calls = 0;
	{
		FAutoConsoleVariableSink Sink(FConsoleCommandDelegate::CreateLambda([&Calls]() { ++Calls; }));
	}
	CVarInt->Set(2);
	IConsoleManager::Get().CallAllConsoleVariableSinks();
	EXPECT_EQ(0, Calls);
}

TEST_F(ConsoleManager, SnapshotPutsBackValuesAndSetters)
{
	CVarInt->Set(3, ECVF_SetByProjectSetting);
	{
		const Drydock::FConsoleVariableSnapshot Snapshot;
		CVarInt->Set(9, ECVF_SetByConsole);
		CVarFloat->Set(9.0f, ECVF_SetByCode);
		CVarString->Set(TEXT("changed"));
	}
	EXPECT_EQ(3, CVarInt->GetInt());
	EXPECT_EQ(ECVF_SetByProjectSetting, CVarInt->GetFlags() & ECVF_SetByMask);
	EXPECT_EQ(0.5f, CVarFloat->GetFloat());
	EXPECT_EQ(ECVF_SetByConstructor, CVarFloat->GetFlags() & ECVF_SetByMask);
	EXPECT_STREQ("none", *CVarString->GetString());
}

TEST_F(ConsoleManager, PlaceholderGivesItsNameToTheRealOne)
{
	FAutoConsoleVariable Placeholder(TEXT("r.CoreTest.Later"), 2, TEXT("Not simulated."), ECVF_NotSimulated);
	EXPECT_TRUE(Drydock::ListConsoleVariables(TEXT("r.CoreTest.Later"))[0].bNotSimulated);
	Find(TEXT("r.CoreTest.Later"))->Set(3, ECVF_SetByCommandline);
	TAutoConsoleVariable<float> Real(TEXT("r.CoreTest.Later"), 1.0f, TEXT("Simulated."));
	EXPECT_EQ(Real.AsVariable(), Find(TEXT("r.CoreTest.Later")));
	EXPECT_EQ(3.0f, Real.GetValueOnAnyThread());
	EXPECT_EQ("", Log);
}

TEST_F(ConsoleManager, PlaceholderLeavesTheRealOneAlone)
{
	TAutoConsoleVariable<float> Real(TEXT("r.CoreTest.First"), 1.0f, TEXT("Simulated."));
	FAutoConsoleVariable Placeholder(TEXT("r.CoreTest.First"), 2, TEXT("Not simulated."), ECVF_NotSimulated);
	EXPECT_EQ(Real.AsVariable(), Find(TEXT("r.CoreTest.First")));
	EXPECT_EQ("", Log);
}

TEST_F(ConsoleManager, VisitsNamesByStartAndByPart)
{
	std::string Names;
	const FConsoleObjectVisitor Visitor =
		FConsoleObjectVisitor::CreateLambda([&Names](const TCHAR* Name, IConsoleObject*) { Names += Name; });
	IConsoleManager::Get().ForEachConsoleObjectThatStartsWith(Visitor, TEXT("R.coretest.B"));
	IConsoleManager::Get().ForEachConsoleObjectThatContains(Visitor, TEXT("CORETEST.ref"));
	EXPECT_EQ("r.CoreTest.Boolr.CoreTest.Reference", Names);
}

TEST_F(ConsoleManager, UnregistersByName)
{
	IConsoleManager::Get().RegisterConsoleVariable(TEXT("r.CoreTest.Gone"), 1, TEXT("Goes."));
	IConsoleManager::Get().UnregisterConsoleObject(TEXT("r.CoreTest.Gone"));
	EXPECT_FALSE(IConsoleManager::Get().IsNameRegistered(TEXT("r.CoreTest.Gone")));
}
