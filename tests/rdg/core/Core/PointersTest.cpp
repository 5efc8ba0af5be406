// Shared, weak, unique and counted pointers, optionals, functions, delegates and objects behave as the engine's.
#include <gtest/gtest.h>

#include "CoreMinimal.h"
#include "UObject/Object.h"

namespace
{

struct FCounted : FRefCountedObject
{
	explicit FCounted(int32* InDeaths)
		: Deaths(InDeaths)
	{
	}
	~FCounted() override { ++*Deaths; }

	int32* Deaths;
};

struct FBase
{
	virtual ~FBase() = default;
	int32 Value = 1;
};

struct FDerived : FBase, TSharedFromThis<FDerived>
{
	int32 Add(int32 A, int32 B) { return Value + A * B; }
	int32 Get() const { return Value; }
};

DECLARE_DELEGATE_RetVal_OneParam(int32, FTestDelegate, int32) DECLARE_MULTICAST_DELEGATE_OneParam(FTestEvent, int32)

	int32 Twice(int32 Value)
{
	return 2 * Value;
}

} // namespace

TEST(RefCountPtr, DeletesWithTheLastReference)
{
	int32 Deaths = 0;
	TRefCountPtr<FCounted> A = new FCounted(&Deaths);
	TRefCountPtr<FCounted> B = A;
	EXPECT_EQ(2u, A.GetRefCount());
	A.SafeRelease();
	EXPECT_EQ(0, Deaths);
	B = nullptr;
	EXPECT_EQ(1, Deaths);
}

TEST(RefCountPtr, SurvivesSelfAssignment)
{
	int32 Deaths = 0;
	TRefCountPtr<FCounted> A = new FCounted(&Deaths);
	const TRefCountPtr<FCounted>& Alias = A;
	A = Alias;
	EXPECT_EQ(0, Deaths);
	EXPECT_EQ(1u, A.GetRefCount());
}

TEST(RefCountPtr, MovesWithoutCounting)
{
	int32 Deaths = 0;
	TRefCountPtr<FCounted> A = new FCounted(&Deaths);
	TRefCountPtr<FRefCountBase> B = MoveTemp(A);
	EXPECT_FALSE(A.IsValid());
	EXPECT_EQ(1u, B.GetRefCount());
}

TEST(SharedPtr, SharesAndWatches)
{
	TSharedPtr<FDerived> Pointer = MakeShared<FDerived>();
	const TWeakPtr<FBase> Weak = Pointer;
	EXPECT_EQ(1, Pointer.GetSharedReferenceCount());
	EXPECT_TRUE(Weak.IsValid());
	Pointer.Reset();
	EXPECT_FALSE(Weak.Pin().IsValid());
}

TEST(SharedPtr, CastsBothWays)
{
	const TSharedPtr<FBase> Base = MakeShared<FDerived>();
	const TSharedPtr<FDerived> Derived = StaticCastSharedPtr<FDerived>(Base);
	EXPECT_EQ(Base.Get(), Derived.Get());
	EXPECT_EQ(2, Base.GetSharedReferenceCount());
}

TEST(SharedPtr, ReferencesAreNeverNull)
{
	EXPECT_THROW(TSharedPtr<FBase>().ToSharedRef(), Drydock::FCheckFailure);
	EXPECT_THROW(*TSharedPtr<FBase>(), Drydock::FCheckFailure);
}

TEST(SharedPtr, MovingAReferenceLeavesItValid)
{
	TSharedRef<FBase> A = MakeShareable(new FBase);
	const TSharedRef<FBase> B = MoveTemp(A);
	EXPECT_EQ(&A.Get(), &B.Get());
}

TEST(SharedPtr, AsSharedIsTheSameOwner)
{
	const TSharedRef<FDerived> Object = MakeShared<FDerived>();
	const TSharedRef<FDerived> Again = Object->AsShared();
	EXPECT_EQ(2, Object.GetSharedReferenceCount());
	EXPECT_EQ(Object, Again);
}

TEST(UniquePtr, ReleasesAndConverts)
{
	TUniquePtr<FBase> Base = MakeUnique<FDerived>();
	FBase* Raw = Base.Release();
	EXPECT_FALSE(Base.IsValid());
	Base.Reset(Raw);
	EXPECT_EQ(1, Base->Value);
}

TEST(Optional, UnsetValueFails)
{
	TOptional<int32> Value;
	EXPECT_FALSE(Value.IsSet());
	EXPECT_EQ(5, Value.Get(5));
	EXPECT_THROW(Value.GetValue(), Drydock::FCheckFailure);
	Value = 3;
	EXPECT_EQ(3, *Value);
}

TEST(Function, CopiesShareNothing)
{
	TFunction<int32()> A = [Count = 0]() mutable
	{
		return ++Count;
	};
	TFunction<int32()> B = A;
	EXPECT_EQ(1, A());
	EXPECT_EQ(1, B());
	EXPECT_THROW(TFunction<int32()>()(), Drydock::FCheckFailure);
}

TEST(Function, UniqueFunctionHoldsMoveOnly)
{
	TUniqueFunction<int32()> Function = [Value = MakeUnique<int32>(4)]
	{
		return *Value;
	};
	EXPECT_EQ(4, Function());
}

TEST(Function, ReferenceCallsTheOriginal)
{
	int32 Count = 0;
	const auto Call = [](TFunctionRef<void(int32)> Function)
	{
		Function(3);
	};
	Call([&Count](int32 Value) { Count += Value; });
	EXPECT_EQ(3, Count);
	EXPECT_EQ(8, TFunctionRef<int32(int32)>(Twice)(4));
}

TEST(Delegate, PayloadFollowsTheArguments)
{
	FDerived Object;
	const FTestDelegate Delegate = FTestDelegate::CreateRaw(&Object, &FDerived::Add, 10);
	EXPECT_EQ(1 + 3 * 10, Delegate.Execute(3));
}

TEST(Delegate, BindsConstMethodsLambdasAndFunctions)
{
	const FDerived Object;
	EXPECT_EQ(1, TDelegate<int32()>::CreateRaw(&Object, &FDerived::Get).Execute());
	EXPECT_EQ(7, FTestDelegate::CreateLambda([](int32 A, int32 B) { return A + B; }, 5).Execute(2));
	EXPECT_EQ(6, FTestDelegate::CreateStatic(&Twice).Execute(3));
}

TEST(Delegate, UnboundFailsOrDoesNothing)
{
	FTestDelegate Delegate;
	EXPECT_FALSE(Delegate.IsBound());
	EXPECT_FALSE(Delegate.ExecuteIfBound(1));
	EXPECT_THROW(Delegate.Execute(1), Drydock::FCheckFailure);
}

TEST(Delegate, SharedBindingEndsWithItsObject)
{
	TSharedPtr<FDerived> Object = MakeShared<FDerived>();
	const FTestDelegate Delegate = FTestDelegate::CreateSP(Object, &FDerived::Add, 2);
	EXPECT_EQ(7, Delegate.Execute(3));
	Object.Reset();
	EXPECT_FALSE(Delegate.IsBound());
}

TEST(Delegate, WeakLambdaEndsWithItsObject)
{
	TUniquePtr<UObject> Object = MakeUnique<UObject>();
	const FTestDelegate Delegate = FTestDelegate::CreateWeakLambda(Object.Get(), [](int32 Value) { return Value; });
	EXPECT_TRUE(Delegate.IsBound());
	Object.Reset();
	EXPECT_FALSE(Delegate.IsBound());
}

TEST(Delegate, PassesReferencesAndMoveOnlyArguments)
{
	int32 Count = 0;
	TDelegate<void(int32&)>::CreateLambda([](int32& Value) { ++Value; }).Execute(Count);
	EXPECT_EQ(1, Count);
	const auto Take = TDelegate<int32(TUniquePtr<int32>)>::CreateLambda([](TUniquePtr<int32> Value) { return *Value; });
	EXPECT_EQ(9, Take.Execute(MakeUnique<int32>(9)));
}

TEST(Delegate, MayUnbindItselfWhileItRuns)
{
	FTestDelegate Delegate;
	Delegate.BindLambda(
		[&Delegate, Text = FString("kept")](int32)
		{
			Delegate.Unbind();
			return Text.Len();
		});
	EXPECT_EQ(4, Delegate.Execute(0));
	EXPECT_FALSE(Delegate.IsBound());
}

TEST(MulticastDelegate, CallsTheLastAddedFirst)
{
	FTestEvent Event;
	FString Order;
	Event.AddLambda([&Order](int32) { Order += "a"; });
	Event.AddLambda([&Order](int32) { Order += "b"; });
	Event.Broadcast(0);
	EXPECT_STREQ("ba", *Order);
}

TEST(MulticastDelegate, RemovesByHandleAndObject)
{
	FTestEvent Event;
	int32 Calls = 0;
	const FDelegateHandle Handle = Event.AddLambda([&Calls](int32) { ++Calls; });
	EXPECT_TRUE(Event.Remove(Handle));
	EXPECT_FALSE(Event.Remove(Handle));
	Event.Broadcast(0);
	EXPECT_EQ(0, Calls);
}

TEST(MulticastDelegate, MayAddWhileItRuns)
{
	FTestEvent Event;
	int32 Calls = 0;
	Event.AddLambda([&](int32) { Event.AddLambda([&Calls](int32) { ++Calls; }); });
	Event.Broadcast(0);
	EXPECT_EQ(0, Calls);
	Event.Broadcast(0);
	EXPECT_EQ(1, Calls);
}

TEST(Object, WeakPointerNoticesTheEnd)
{
	TWeakObjectPtr<UObject> Weak;
	{
		UObject Object;
		Weak = &Object;
		EXPECT_EQ(&Object, Weak.Get());
	}
	EXPECT_EQ(nullptr, Weak.Get());
}

TEST(Template, ScopeExitAndGuardRestore)
{
	int32 Value = 1;
	{
		TGuardValue<int32> Guard(Value, 2);
		ON_SCOPE_EXIT
		{
			EXPECT_EQ(2, Value);
		};
	}
	EXPECT_EQ(1, Value);
}
