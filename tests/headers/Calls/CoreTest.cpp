// Calls of Core: containers, text, time, console variables, threads. A little past 500 lines: a list, a row for each
// call.
#include "Calls.h"

#include "Async/Async.h"
#include "Async/ParallelFor.h"
#include "CoreMinimal.h"
#include "HAL/CriticalSection.h"
#include "HAL/IConsoleManager.h"
#include "HAL/PlatformTime.h"
#include "Logging/MessageLog.h"
#include "Logging/StructuredLog.h"
#include "Misc/App.h"
#include "Misc/CoreDelegates.h"
#include "Misc/DateTime.h"
#include "Misc/FileHelper.h"
#include "Misc/Paths.h"
#include "Misc/ScopeLock.h"
#include "Misc/TVariant.h"
#include "Modules/ModuleManager.h"

namespace
{

constexpr Calls::EArea Area = Calls::EArea::Core;

DEFINE_LOG_CATEGORY_STATIC(LogCallsTest, Log, All);
TAutoConsoleVariable<int32> CVarWhole(TEXT("r.Calls.Whole"), 3, TEXT("Help"), ECVF_RenderThreadSafe);
TAutoConsoleVariable<float> CVarReal(TEXT("r.Calls.Real"), 0.5f, TEXT("Help"), ECVF_Default);
TAutoConsoleVariable<bool> CVarSwitch(TEXT("r.Calls.Switch"), true, TEXT("Help"));
TAutoConsoleVariable<FString> CVarText(TEXT("r.Calls.Text"), TEXT("a"), TEXT("Help"));
int32 GCallsRef = 2;
FAutoConsoleVariableRef CVarRef(TEXT("r.Calls.Ref"), GCallsRef, TEXT("Help"));
FAutoConsoleCommand CommandPlain(TEXT("Calls.Plain"), TEXT("Help"), FConsoleCommandDelegate::CreateLambda([] {}));

enum class EFlags : uint32
{
	None = 0,
	First = 1,
	Second = 2,
};
ENUM_CLASS_FLAGS(EFlags)

struct FShared : TSharedFromThis<FShared>
{
	int32 Value = 1;
};

DECLARE_DELEGATE_RetVal_OneParam(int32, FOneDelegate, int32);
DECLARE_MULTICAST_DELEGATE_OneParam(FManyDelegate, int32);

} // namespace

TEST(CallsOfCore, Containers)
{
	TArray<int32> Array = {3, 1, 2};
	CALL("TArray, Num", Array.Num() == 3);
	CALL("TArray::Add", Array.Add(4) == 3);
	CALL("TArray::Add_GetRef, Emplace_GetRef, AddDefaulted_GetRef",
		[&]
		{
			TArray<int32> A;
			A.Add_GetRef(1) = 5;
			A.Emplace_GetRef(2) = 6;
			A.AddDefaulted_GetRef() = 7;
			return A == TArray<int32>{5, 6, 7};
		}());
	CALL("TArray::Emplace", Array.Emplace(5) == 4);
	CALL("TArray::AddUnique", Array.AddUnique(5) == 4);
	CALL("TArray::AddDefaulted, AddZeroed, AddUninitialized",
		[&]
		{
			TArray<int32> A;
			A.AddDefaulted();
			A.AddZeroed(2);
			A.AddUninitialized(1);
			return A.Num() == 4 && A[1] == 0;
		}());
	CALL("TArray operator[]", Array[0] == 3);
	CALL("TArray::Last, Top", Array.Last() == 5 && Array.Top() == 5);
	CALL("TArray::Contains, Find, IndexOfByKey",
		Array.Contains(1) && Array.Find(2) == 2 && Array.IndexOfByKey(2) == 2 && Array.Find(9) == INDEX_NONE);
	CALL("TArray::FindByPredicate, ContainsByPredicate, IndexOfByPredicate, FilterByPredicate",
		*Array.FindByPredicate([](int32 V) { return V > 3; }) == 4 &&
			Array.ContainsByPredicate([](int32 V) { return V == 2; }) &&
			Array.IndexOfByPredicate([](int32 V) { return V == 1; }) == 1 &&
			Array.FilterByPredicate([](int32 V) { return V > 3; }).Num() == 2);
	CALL("TArray::Remove, RemoveAt, RemoveAll, RemoveSingle, RemoveAtSwap",
		[&]
		{
			TArray<int32> A = {1, 2, 2, 3, 4};
			A.Remove(2);
			A.RemoveAt(0);
			A.RemoveSingle(4);
			A.Add(7);
			A.RemoveAtSwap(0);
			return A == TArray<int32>{7} && A.RemoveAll([](int32) { return true; }) == 1;
		}());
	CALL("TArray::Insert",
		[&]
		{
			TArray<int32> A = {1, 3};
			A.Insert(2, 1);
			return A[1] == 2;
		}());
	CALL("TArray::Append",
		[&]
		{
			TArray<int32> A = {1};
			A.Append({2, 3});
			A.Append(A);
			return A.Num() == 6;
		}());
	CALL("TArray::Empty, Reset, IsEmpty",
		[&]
		{
			TArray<int32> A = {1};
			A.Reset();
			const bool bEmpty = A.IsEmpty();
			A.Empty();
			return bEmpty;
		}());
	CALL("TArray::SetNum, SetNumUninitialized, SetNumZeroed",
		[&]
		{
			TArray<int32> A;
			A.SetNum(2);
			A.SetNumUninitialized(3);
			A.SetNumZeroed(5);
			return A.Num() == 5 && A[4] == 0;
		}());
	CALL("TArray::Reserve, Max, Shrink",
		[&]
		{
			TArray<int32> A;
			A.Reserve(8);
			const bool b = A.Max() >= 8;
			A.Shrink();
			return b;
		}());
	CALL("TArray::Init",
		[&]
		{
			TArray<int32> A;
			A.Init(7, 2);
			return A[1] == 7;
		}());
	CALL("TArray::GetData, GetTypeSize", *Array.GetData() == 3 && Array.GetTypeSize() == 4);
	CALL("TArray::IsValidIndex", Array.IsValidIndex(4) && !Array.IsValidIndex(5));
	CALL("TArray::Sort, StableSort",
		[&]
		{
			TArray<int32> A = {3, 1, 2};
			A.Sort();
			A.Sort([](int32 L, int32 R) { return L > R; });
			A.StableSort();
			return A[0] == 1;
		}());
	CALL("TArray::Pop, Push",
		[&]
		{
			TArray<int32> A = {1, 2};
			A.Push(3);
			return A.Pop() == 3;
		}());
	CALL("TArray::Swap",
		[&]
		{
			TArray<int32> A = {1, 2};
			A.Swap(0, 1);
			return A[0] == 2;
		}());
	CALL("TArray range for",
		[&]
		{
			int32 Sum = 0;
			for (const int32 V : Array)
			{
				Sum += V;
			}
			return Sum == 15;
		}());
	CALL("TArrayView, MakeArrayView, TConstArrayView",
		MakeArrayView(Array).Num() == 5 && TConstArrayView<int32>(Array)[1] == 1);
	CALL("TInlineAllocator", TArray<int32, TInlineAllocator<4>>{1, 2}.Num() == 2);
	TMap<FString, int32> Map;
	CALL("TMap::Add", Map.Add(TEXT("a"), 1) == 1);
	CALL("TMap::Find", *Map.Find(TEXT("a")) == 1 && Map.Find(TEXT("b")) == nullptr);
	CALL("TMap::FindOrAdd", (Map.FindOrAdd(TEXT("b")) = 2) == 2);
	CALL("TMap::FindRef", Map.FindRef(TEXT("b")) == 2 && Map.FindRef(TEXT("c")) == 0);
	CALL("TMap::FindChecked, operator[]", Map.FindChecked(TEXT("b")) == 2 && Map[TEXT("b")] == 2);
	CALL("TMap::Contains, Num, IsEmpty", Map.Contains(TEXT("a")) && Map.Num() == 2 && !Map.IsEmpty());
	CALL("TMap::Emplace, Remove",
		[&]
		{
			TMap<int32, int32> M;
			M.Emplace(1, 2);
			return M.Remove(1) == 1;
		}());
	CALL("TMap range for, Key, Value",
		[&]
		{
			int32 Sum = 0;
			for (const TPair<FString, int32>& Pair : Map)
			{
				Sum += Pair.Value + Pair.Key.Len();
			}
			return Sum == 5;
		}());
	CALL("TMap::GetKeys, GenerateValueArray",
		[&]
		{
			TArray<FString> Keys;
			Map.GetKeys(Keys);
			TArray<int32> Values;
			Map.GenerateValueArray(Values);
			return Keys.Num() == 2 && Values.Num() == 2;
		}());
	CALL("TMap::Empty, Reset",
		[&]
		{
			TMap<int32, int32> M = {{1, 2}};
			M.Reset();
			M.Empty();
			return M.Num() == 0;
		}());
	CALL("TMap::CreateIterator",
		[&]
		{
			for (auto It = Map.CreateIterator(); It; ++It)
			{
				if (It.Value() == 1)
				{
					It.RemoveCurrent();
				}
			}
			return Map.Num() == 1;
		}());
	TSet<int32> Set = {1, 2};
	CALL("TSet::Add, Contains, Num", (Set.Add(3), Set.Contains(3)) && Set.Num() == 3);
	CALL("TSet::Remove, Find, Array", Set.Remove(3) == 1 && *Set.Find(1) == 1 && Set.Array().Num() == 2);
	CALL("TSet::Union, Intersect", Set.Union(TSet<int32>{7}).Num() == 3 && Set.Intersect(TSet<int32>{1}).Num() == 1);
	CALL("TPair, TTuple, MakeTuple", MakeTuple(1, 2.0f).Get<0>() == 1 && TPair<int32, int32>(1, 2).Value == 2);
	TStaticArray<int32, 3> Static;
	Static[1] = 4;
	CALL("TStaticArray", Static.Num() == 3 && Static[1] == 4);
	CALL("TBitArray",
		[&]
		{
			TBitArray<> Bits(false, 8);
			Bits[3] = true;
			return Bits.Num() == 8 && bool(Bits[3]);
		}());
	TOptional<int32> Optional;
	CALL("TOptional, IsSet, GetValue, Get, Reset",
		!Optional.IsSet() && (Optional = 3).GetValue() == 3 && Optional.Get(1) == 3 && (Optional.Reset(), !Optional));
	CALL("TVariant", TVariant<int32, float>(TInPlaceType<float>(), 2.0f).Get<float>() == 2.0f);
	CALL("TUniquePtr, MakeUnique", *MakeUnique<int32>(3) == 3);
	CALL("TSharedPtr, MakeShared, IsValid, Get, Reset",
		[&]
		{
			TSharedPtr<FShared> P = MakeShared<FShared>();
			const bool b = P.IsValid() && P.Get()->Value == 1;
			P.Reset();
			return b && !P;
		}());
	CALL("TSharedRef, TSharedFromThis::AsShared", MakeShared<FShared>()->AsShared()->Value == 1);
	CALL("TSharedPtr<T, ESPMode::ThreadSafe>, MakeShareable",
		TSharedPtr<FShared, ESPMode::ThreadSafe>(MakeShareable(new FShared)).IsValid());
	CALL("TWeakPtr::Pin",
		[&]
		{
			TSharedPtr<FShared> P = MakeShared<FShared>();
			const TWeakPtr<FShared> W = P;
			const bool b = W.Pin().IsValid() && W.IsValid();
			P.Reset();
			return b && !W.Pin();
		}());
	CALL("StaticCastSharedPtr, StaticCastSharedRef",
		StaticCastSharedPtr<FShared>(TSharedPtr<FShared>(MakeShared<FShared>()))->Value == 1);
	CALL(
		"TFunction, TUniqueFunction, TFunctionRef", TFunction<int32(int32)>([](int32 V) { return V + 1; })(1) == 2 &&
														[](TFunctionRef<int32()> F)
															{
																return F();
															}([] { return 3; }) == 3);
	CALL("MoveTemp, Forward, Swap",
		[&]
		{
			int32 A = 1, B = 2;
			Swap(A, B);
			return MoveTemp(A) == 2;
		}());
	CALL("UE_ARRAY_COUNT",
		[&]
		{
			const int32 Values[3] = {};
			return UE_ARRAY_COUNT(Values) == 3 && Values[0] == 0;
		}());
	CALL("ENUM_CLASS_FLAGS, EnumHasAnyFlags, EnumHasAllFlags, EnumAddFlags",
		EnumHasAnyFlags(EFlags::First | EFlags::Second, EFlags::First) &&
			!EnumHasAllFlags(EFlags::First, EFlags::First | EFlags::Second));
	CALL("GetTypeHash, HashCombine", GetTypeHash(3) == GetTypeHash(3) && HashCombine(1, 2) == HashCombine(1, 2));
	CALL("FMemory::Memcpy, Memzero, Memset, Memcmp",
		[&]
		{
			int32 A = 1, B = 2;
			FMemory::Memcpy(&A, &B, 4);
			FMemory::Memzero(&B, 4);
			FMemory::Memset(&B, 0, 4);
			return A == 2 && FMemory::Memcmp(&A, &B, 4) != 0;
		}());
	CALL("FMemory::Malloc, Free",
		[&]
		{
			void* P = FMemory::Malloc(4);
			FMemory::Free(P);
			return P != nullptr;
		}());
	CALL("ON_SCOPE_EXIT",
		[&]
		{
			int32 V = 0;
			{
				ON_SCOPE_EXIT
				{
					V = 1;
				};
			}
			return V == 1;
		}());
	CALL("static_assert of sizes: int32, uint8, TCHAR", sizeof(int32) == 4 && sizeof(uint8) == 1);
	CALL("FOneDelegate::CreateLambda, BindLambda, IsBound, Execute",
		FOneDelegate::CreateLambda([](int32 V) { return V + 1; }).Execute(1) == 2);
	CALL("Delegate::ExecuteIfBound, Unbind",
		[&]
		{
			FSimpleDelegate D;
			D.BindLambda([] {});
			const bool b = D.ExecuteIfBound();
			D.Unbind();
			return b && !D.IsBound();
		}());
	CALL("Multicast delegate: AddLambda, Broadcast, Remove, Clear",
		[&]
		{
			int32 Sum = 0;
			FManyDelegate D;
			const FDelegateHandle H = D.AddLambda([&](int32 V) { Sum += V; });
			D.Broadcast(2);
			D.Remove(H);
			D.Broadcast(3);
			D.Clear();
			return Sum == 2;
		}());
}

TEST(CallsOfCore, Text)
{
	const FString Text = TEXT("Hello World");
	CALL("TEXT", FString(TEXT("a")) == TEXT("a"));
	CALL("FString::Printf", FString::Printf(TEXT("%d %s %.2f"), 3, TEXT("b"), 0.5f) == TEXT("3 b 0.50"));
	CALL("FString::FromInt", FString::FromInt(-3) == TEXT("-3"));
	CALL("FString::SanitizeFloat", FString::SanitizeFloat(0.5) == TEXT("0.5"));
	CALL("FString operator+, +=", FString(TEXT("a")) + TEXT("b") + FString::FromInt(1) == TEXT("ab1"));
	CALL("FString operator*", FString(*Text) == Text);
	CALL("FString operator/", FString(TEXT("a")) / TEXT("b") == TEXT("a/b"));
	CALL("FString::Len, IsEmpty", Text.Len() == 11 && FString().IsEmpty());
	CALL("FString::Contains", Text.Contains(TEXT("world")));
	CALL("FString::Equals", Text.Equals(TEXT("hello world"), ESearchCase::IgnoreCase));
	CALL("FString::StartsWith, EndsWith", Text.StartsWith(TEXT("Hello")) && Text.EndsWith(TEXT("World")));
	CALL(
		"FString::Find, FindChar", Text.Find(TEXT("World")) == 6 &&
									   [&]
									   {
										   int32 I = 0;
										   return Text.FindChar('W', I) && I == 6;
									   }());
	CALL("FString::Replace", Text.Replace(TEXT("World"), TEXT("You")) == TEXT("Hello You"));
	CALL("FString::Left, Right, Mid, RightChop, LeftChop",
		Text.Left(5) == TEXT("Hello") && Text.Right(5) == TEXT("World") && Text.Mid(6, 3) == TEXT("Wor") &&
			Text.RightChop(6) == TEXT("World") && Text.LeftChop(6) == TEXT("Hello"));
	CALL("FString::Split",
		[&]
		{
			FString L, R;
			return Text.Split(TEXT(" "), &L, &R) && R == TEXT("World");
		}());
	CALL("FString::ParseIntoArray",
		[&]
		{
			TArray<FString> Parts;
			return Text.ParseIntoArray(Parts, TEXT(" ")) == 2 && Parts[1] == TEXT("World");
		}());
	CALL("FString::ToUpper, ToLower", Text.ToUpper() == TEXT("HELLO WORLD") && Text.ToLower() == TEXT("hello world"));
	CALL("FString::TrimStartAndEnd", FString(TEXT(" a ")).TrimStartAndEnd() == TEXT("a"));
	CALL("FString::IsNumeric", FString(TEXT("12")).IsNumeric() && !Text.IsNumeric());
	CALL("FString::Join", FString::Join(TArray<FString>{TEXT("a"), TEXT("b")}, TEXT(",")) == TEXT("a,b"));
	CALL("FString::Append, AppendChar, AppendInt",
		[&]
		{
			FString S;
			S.Append(TEXT("a"));
			S.AppendChar('b');
			S.AppendInt(3);
			return S == TEXT("ab3");
		}());
	CALL("FCString::Atoi, Atof, Strcmp", FCString::Atoi(TEXT("12")) == 12 && FCString::Atof(TEXT("0.5")) == 0.5f &&
											 FCString::Strcmp(TEXT("a"), TEXT("a")) == 0);
	CALL("LexToString", LexToString(3) == TEXT("3"));
	CALL("FName, ToString, IsNone, NAME_None",
		FName(TEXT("A")).ToString() == TEXT("A") && FName().IsNone() && FName() == NAME_None);
	CALL("FName(Text, Number)", FName(TEXT("A"), 3).GetNumber() == 3);
	CALL("FText::FromString, ToString, LOCTEXT", FText::FromString(TEXT("a")).ToString() == TEXT("a"));
	CALL("FText::AsNumber, Format",
		FText::Format(FText::FromString(TEXT("{0}!")), FText::AsNumber(3)).ToString() == TEXT("3!"));
	CALL("TCHAR_TO_UTF8, TCHAR_TO_ANSI, UTF8_TO_TCHAR",
		std::string(TCHAR_TO_UTF8(*Text)) == "Hello World" && FString(UTF8_TO_TCHAR("a")) == TEXT("a"));
	CALL("FPaths::Combine", FPaths::Combine(TEXT("a"), TEXT("b")) == TEXT("a/b"));
	CALL("FPaths::GetBaseFilename, GetExtension, GetPath, GetCleanFilename",
		FPaths::GetBaseFilename(TEXT("a/b.c")) == TEXT("b") && FPaths::GetExtension(TEXT("a/b.c")) == TEXT("c") &&
			FPaths::GetPath(TEXT("a/b.c")) == TEXT("a") && FPaths::GetCleanFilename(TEXT("a/b.c")) == TEXT("b.c"));
	CALL("FPaths::FileExists, DirectoryExists",
		!FPaths::FileExists(TEXT("/nowhere")) && FPaths::DirectoryExists(TEXT("/tmp")));
	CALL("FPaths::ConvertRelativePathToFull", FPaths::ConvertRelativePathToFull(TEXT("/a/../b")) == TEXT("/b"));
	CALL("FPaths::ProjectDir, ProjectPluginsDir, ProjectContentDir, ProjectSavedDir",
		!FPaths::ProjectDir().IsEmpty() && !FPaths::ProjectPluginsDir().IsEmpty() &&
			!FPaths::ProjectContentDir().IsEmpty() && !FPaths::ProjectSavedDir().IsEmpty());
	CALL("FPaths::EngineDir", !FPaths::EngineDir().IsEmpty());
	CALL("FFileHelper::SaveStringToFile, LoadFileToString, LoadFileToArray",
		[&]
		{
			const TCHAR* const File = TEXT("/tmp/drydock_calls.txt");
			FString Read;
			TArray<uint8> Bytes;
			return FFileHelper::SaveStringToFile(TEXT("abc"), File) && FFileHelper::LoadFileToString(Read, File) &&
				   Read == TEXT("abc") && FFileHelper::LoadFileToArray(Bytes, File) && Bytes.Num() == 3;
		}());
	CALL("FFileHelper::SaveArrayToFile",
		[&]
		{
			const TCHAR* const File = TEXT("/tmp/drydock_calls.bin");
			TArray<uint8> Bytes = {1, 0, 255};
			TArray<uint8> Read;
			return FFileHelper::SaveArrayToFile(Bytes, File) &&
				   FFileHelper::SaveArrayToFile(Bytes, File, &IFileManager::Get(), FILEWRITE_Append) &&
				   FFileHelper::LoadFileToArray(Read, File) && Read.Num() == 6 && Read[5] == 255;
		}());
	FMessageLog(TEXT("Blueprint")).Info(FText::FromString(TEXT("a")));
	CALL("FMessageLog::Info, Warning, Error", true);
	COMPILES("FArchive (nobody makes one)", FArchive Archive; int32 Number = 0; Archive << Number);
	UE_LOG(LogCallsTest, Verbose, TEXT("%d %s"), 3, *Text);
	UE_CLOG(false, LogTemp, Error, TEXT("never"));
	UE_LOGFMT(LogTemp, Verbose, "{0}", 3);
	CALL("UE_LOG, UE_CLOG, UE_LOGFMT, DEFINE_LOG_CATEGORY_STATIC, LogTemp", true);
	check(true);
	checkf(true, TEXT("%d"), 3);
	checkSlow(true);
	CALL("check, checkf, checkSlow, ensure, ensureMsgf, verify", ensure(true) && ensureMsgf(true, TEXT("a")));
	COMPILES("checkNoEntry, unimplemented, UE_DEPRECATED", checkNoEntry());
}

TEST(CallsOfCore, VariablesTimeAndThreads)
{
	CALL("TAutoConsoleVariable<int32>::GetValueOnAnyThread", CVarWhole.GetValueOnAnyThread() == 3);
	CALL("TAutoConsoleVariable<float>::GetValueOnRenderThread", CVarReal.GetValueOnRenderThread() == 0.5f);
	CALL("TAutoConsoleVariable<bool>::GetValueOnGameThread", CVarSwitch.GetValueOnGameThread());
	CALL("TAutoConsoleVariable<FString>", CVarText.GetValueOnAnyThread() == TEXT("a"));
	CALL("TAutoConsoleVariable operator->, GetInt, GetFloat, GetBool, Set",
		[&]
		{
			CVarWhole->Set(4);
			const bool b = CVarWhole->GetInt() == 4 && CVarWhole->GetBool() && CVarReal->GetFloat() == 0.5f;
			CVarWhole->Set(3);
			return b;
		}());
	CALL("FAutoConsoleVariableRef", GCallsRef == 2 && CVarRef->GetInt() == 2);
	CALL("FAutoConsoleCommand", IConsoleManager::Get().FindConsoleObject(TEXT("Calls.Plain")) != nullptr);
	CALL("FAutoConsoleCommandWithWorldAndArgs",
		[]
		{
			static FAutoConsoleCommandWithWorldAndArgs C(TEXT("Calls.World"), TEXT("Help"),
				FConsoleCommandWithWorldAndArgsDelegate::CreateLambda([](const TArray<FString>&, UWorld*) {}));
			return true;
		}());
	CALL("FAutoConsoleCommandWithWorld",
		[]
		{
			static FAutoConsoleCommandWithWorld C(
				TEXT("Calls.World2"), TEXT("Help"), FConsoleCommandWithWorldDelegate::CreateLambda([](UWorld*) {}));
			return true;
		}());
	CALL("IConsoleManager::FindConsoleVariable",
		IConsoleManager::Get().FindConsoleVariable(TEXT("r.Calls.Real"))->GetFloat() == 0.5f);
	CALL("IConsoleManager::FindTConsoleVariableDataInt, FindTConsoleVariableDataFloat",
		IConsoleManager::Get().FindTConsoleVariableDataInt(TEXT("r.Calls.Whole"))->GetValueOnAnyThread() == 3 &&
			IConsoleManager::Get().FindTConsoleVariableDataFloat(TEXT("r.Calls.Real"))->GetValueOnAnyThread() == 0.5f);
	CALL("IConsoleManager::RegisterConsoleVariable, UnregisterConsoleObject",
		[]
		{
			IConsoleVariable* const V =
				IConsoleManager::Get().RegisterConsoleVariable(TEXT("r.Calls.New"), 5, TEXT("Help"));
			const bool b = V->GetInt() == 5;
			IConsoleManager::Get().UnregisterConsoleObject(V);
			return b;
		}());
	CALL("IConsoleVariable::SetOnChangedCallback",
		[&]
		{
			int32 Num = 0;
			CVarWhole->SetOnChangedCallback(FConsoleVariableDelegate::CreateLambda([&](IConsoleVariable*) { ++Num; }));
			CVarWhole->Set(7);
			CVarWhole->SetOnChangedCallback(FConsoleVariableDelegate());
			CVarWhole->Set(3);
			return Num == 1;
		}());
	CALL("ECVF_RenderThreadSafe, ECVF_Default, ECVF_Scalability, ECVF_Cheat, ECVF_ReadOnly, ECVF_SetByCode",
		ECVF_RenderThreadSafe != ECVF_Default && ECVF_Scalability != ECVF_Cheat && ECVF_ReadOnly != ECVF_SetByCode);
	CALL("IsInRenderingThread, IsInGameThread, IsInParallelRenderingThread",
		IsInGameThread() || IsInRenderingThread() || IsInParallelRenderingThread());
	CALL("FCriticalSection, FScopeLock",
		[&]
		{
			FCriticalSection Section;
			FScopeLock Lock(&Section);
			return true;
		}());
	CALL("ParallelFor",
		[&]
		{
			std::atomic<int32> Sum = 0;
			ParallelFor(4, [&](int32 Index) { Sum += Index; });
			return Sum == 6;
		}());
	CALL("AsyncTask",
		[&]
		{
			int32 V = 0;
			AsyncTask(ENamedThreads::GameThread, [&] { V = 1; });
			return V == 1;
		}());
	CALL("FPlatformTime::Seconds, Cycles64", FPlatformTime::Seconds() > 0.0 && FPlatformTime::Cycles64() > 0);
	CALL("FDateTime::Now, UtcNow, FTimespan",
		FMath::Abs((FDateTime::Now() - FDateTime::Now()).GetTotalSeconds()) < 60.0 &&
			FDateTime::UtcNow().GetYear() > 2000);
	CALL("FTimespan::FromSeconds", FTimespan::FromSeconds(90).GetTotalMinutes() == 1.5);
	CALL("FApp::GetCurrentTime, GetDeltaTime, CanEverRender, IsGame",
		FApp::GetDeltaTime() >= 0.0 && FApp::CanEverRender() && FApp::GetCurrentTime() >= 0.0);
	CALL("FModuleManager::Get, IsModuleLoaded", !FModuleManager::Get().IsModuleLoaded(TEXT("Nowhere")));
	COMPILES("FModuleManager::LoadModuleChecked, GetModulePtr",
			 FModuleManager::LoadModuleChecked<IModuleInterface>(TEXT("A"));
			 FModuleManager::GetModulePtr<IModuleInterface>(TEXT("A")));
	CALL("FCoreDelegates::OnPostEngineInit, OnBeginFrame, OnEndFrame",
		[]
		{
			const FDelegateHandle H = FCoreDelegates::OnPostEngineInit.AddLambda([] {});
			FCoreDelegates::OnPostEngineInit.Remove(H);
			return H.IsValid();
		}());
	CALL("FCoreDelegates::GetOnPostEngineInit",
		[]
		{
			const FDelegateHandle H = FCoreDelegates::GetOnPostEngineInit().AddLambda([] {});
			FCoreDelegates::GetOnPostEngineInit().Remove(H);
			return H.IsValid();
		}());
	COMPILES("TRACE_CPUPROFILER_EVENT_SCOPE, SCOPE_CYCLE_COUNTER, QUICK_SCOPE_CYCLE_COUNTER",
			 TRACE_CPUPROFILER_EVENT_SCOPE(Calls);
			 QUICK_SCOPE_CYCLE_COUNTER(STAT_Calls));
	CALL("WITH_EDITOR, UE_BUILD_SHIPPING, ENGINE_MAJOR_VERSION, ENGINE_MINOR_VERSION, UE_VERSION_OLDER_THAN",
		WITH_EDITOR == 0 && ENGINE_MAJOR_VERSION == 5 && UE_VERSION_OLDER_THAN(9, 0, 0));
	CALL("PLATFORM_WINDOWS, PLATFORM_LINUX", PLATFORM_LINUX == 1 && PLATFORM_WINDOWS == 0);
	CALL("FORCEINLINE, LIKELY, UNLIKELY", LIKELY(true) && !UNLIKELY(false));
}
