// Keeps the registry of console objects. Source: interface of the engine's HAL/IConsoleManager.h.
#include "HAL/ConsoleVariable.h"
#include "HAL/IConsoleManager.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace
{

using namespace Drydock;
using namespace Drydock::Private;

class FConsoleCommand final : public IConsoleCommand
{
public:
	FConsoleCommand(const TCHAR* InHelp, FConsoleCommandWithArgsDelegate InCommand, EConsoleVariableFlags InFlags)
		: Help(InHelp)
		, Command(std::move(InCommand))
		, Flags(InFlags)
	{
	}

	const TCHAR* GetHelp() const override { return *Help; }
	void SetHelp(const TCHAR* InHelp) override { Help = InHelp; }
	EConsoleVariableFlags GetFlags() const override { return Flags; }
	void SetFlags(EConsoleVariableFlags InFlags) override { Flags = InFlags; }
	IConsoleCommand* AsCommand() override { return this; }
	bool Execute(const TArray<FString>& Arguments) override { return Command.ExecuteIfBound(Arguments); }

private:
	FString Help;
	FConsoleCommandWithArgsDelegate Command;
	EConsoleVariableFlags Flags;
};

/** Whether any variable has changed since the sinks ran last. */
std::atomic<bool> GVariablesChanged{false};

} // namespace

struct IConsoleManager::FState
{
	struct FNameLess
	{
		bool operator()(const FString& A, const FString& B) const { return FCString::Stricmp(*A, *B) < 0; }
	};

	struct FRegistration
	{
		std::unique_ptr<IConsoleObject> Object;
		int32 Count = 1; // how often it was registered
	};

	mutable std::recursive_mutex Mutex;
	std::map<FString, FRegistration, FNameLess> Objects;
	std::vector<std::unique_ptr<IConsoleObject>> Nameless; // variables that lost their name to another one
	std::vector<FConsoleCommandDelegate> Sinks;

	template<typename T>
	IConsoleVariable* Register(
		const TCHAR* Name, const T& Default, const TCHAR* Help, EConsoleVariableFlags Flags, T* Reference = nullptr)
	{
		std::lock_guard Lock(Mutex);
		auto Variable = std::make_unique<TConsoleVariable<T>>(Name, Default, Help, Flags);
		if (Reference != nullptr)
		{
			Variable->SetReference(*Reference);
		}
		IConsoleVariable* Result = Variable.get();
		auto Found = Objects.find(Name);
		const bool bRealOne = (Flags & ECVF_NotSimulated) == ECVF_Default;
		if (Found != Objects.end() && bRealOne && Found->second.Object->TestFlags(ECVF_NotSimulated))
		{
			TakeOverFrom(*Found->second.Object->AsVariable(), *Variable);
			Nameless.push_back(std::move(Found->second.Object));
			Objects.erase(Found);
			Found = Objects.end();
		}
		if (Found == Objects.end())
		{
			Objects[Name].Object = std::move(Variable);
			return Result;
		}
		// One variable cannot write through to two places, so references do not share.
		auto* Existing = dynamic_cast<TConsoleVariable<T>*>(Found->second.Object.get());
		if (Existing != nullptr && Reference == nullptr)
		{
			++Found->second.Count;
			return Existing;
		}
		if (bRealOne)
		{
			UE_LOG(LogConsoleManager, Error,
				"Console object named '%s' already exists; the new one cannot be found by its name", Name);
		}
		Nameless.push_back(std::move(Variable));
		return Result;
	}

	/** A value that was set before the code that reads it was there. */
	static void TakeOverFrom(const IConsoleVariable& Old, IConsoleVariable& New)
	{
		const EConsoleVariableFlags SetBy = Old.GetFlags() & ECVF_SetByMask;
		if (SetBy != ECVF_SetByConstructor && DoesConsoleVariableTake(New, *Old.GetString()))
		{
			New.Set(Old.GetString(), SetBy);
		}
	}
};

void Drydock::Private::NoteConsoleVariableChange()
{
	GVariablesChanged = true;
}

IConsoleManager& IConsoleManager::Get()
{
	static IConsoleManager Manager;
	return Manager;
}

IConsoleManager::IConsoleManager()
	: State(new FState)
{
}

IConsoleManager::~IConsoleManager()
{
	delete State;
}

IConsoleVariable* IConsoleManager::RegisterConsoleVariable(
	const TCHAR* Name, bool Default, const TCHAR* Help, EConsoleVariableFlags Flags)
{
	return State->Register(Name, Default, Help, Flags);
}

IConsoleVariable* IConsoleManager::RegisterConsoleVariable(
	const TCHAR* Name, int32 Default, const TCHAR* Help, EConsoleVariableFlags Flags)
{
	return State->Register(Name, Default, Help, Flags);
}

IConsoleVariable* IConsoleManager::RegisterConsoleVariable(
	const TCHAR* Name, float Default, const TCHAR* Help, EConsoleVariableFlags Flags)
{
	return State->Register(Name, Default, Help, Flags);
}

IConsoleVariable* IConsoleManager::RegisterConsoleVariable(
	const TCHAR* Name, const TCHAR* Default, const TCHAR* Help, EConsoleVariableFlags Flags)
{
	return State->Register(Name, FString(Default), Help, Flags);
}

IConsoleVariable* IConsoleManager::RegisterConsoleVariableRef(
	const TCHAR* Name, bool& Value, const TCHAR* Help, EConsoleVariableFlags Flags)
{
	return State->Register(Name, Value, Help, Flags, &Value);
}

IConsoleVariable* IConsoleManager::RegisterConsoleVariableRef(
	const TCHAR* Name, int32& Value, const TCHAR* Help, EConsoleVariableFlags Flags)
{
	return State->Register(Name, Value, Help, Flags, &Value);
}

IConsoleVariable* IConsoleManager::RegisterConsoleVariableRef(
	const TCHAR* Name, float& Value, const TCHAR* Help, EConsoleVariableFlags Flags)
{
	return State->Register(Name, Value, Help, Flags, &Value);
}

IConsoleVariable* IConsoleManager::RegisterConsoleVariableRef(
	const TCHAR* Name, FString& Value, const TCHAR* Help, EConsoleVariableFlags Flags)
{
	return State->Register(Name, Value, Help, Flags, &Value);
}

IConsoleCommand* IConsoleManager::RegisterConsoleCommand(
	const TCHAR* Name, const TCHAR* Help, const FConsoleCommandDelegate& Command, EConsoleVariableFlags Flags)
{
	return RegisterConsoleCommand(Name, Help,
		FConsoleCommandWithArgsDelegate::CreateLambda([Command](const TArray<FString>&) { Command.ExecuteIfBound(); }),
		Flags);
}

IConsoleCommand* IConsoleManager::RegisterConsoleCommand(const TCHAR* Name, const TCHAR* Help,
	const FConsoleCommandWithWorldAndArgsDelegate& Command, EConsoleVariableFlags Flags)
{
	return RegisterConsoleCommand(Name, Help,
		FConsoleCommandWithArgsDelegate::CreateLambda([Command](const TArray<FString>& Arguments)
			{ Command.ExecuteIfBound(Arguments, Drydock::GetConsoleWorld()); }),
		Flags);
}

UWorld*& Drydock::GetConsoleWorld()
{
	static UWorld* World = nullptr;
	return World;
}

IConsoleCommand* IConsoleManager::RegisterConsoleCommand(
	const TCHAR* Name, const TCHAR* Help, const FConsoleCommandWithArgsDelegate& Command, EConsoleVariableFlags Flags)
{
	std::lock_guard Lock(State->Mutex);
	auto Object = std::make_unique<FConsoleCommand>(Help, Command, Flags);
	IConsoleCommand* Result = Object.get();
	if (State->Objects.contains(Name))
	{
		UE_LOG(LogConsoleManager, Error,
			"Console object named '%s' already exists; the new one cannot be found by its name", Name);
		State->Nameless.push_back(std::move(Object));
		return Result;
	}
	State->Objects[Name].Object = std::move(Object);
	return Result;
}

void IConsoleManager::UnregisterConsoleObject(IConsoleObject* Object, bool)
{
	std::lock_guard Lock(State->Mutex);
	for (auto It = State->Objects.begin(); It != State->Objects.end(); ++It)
	{
		if (It->second.Object.get() == Object)
		{
			if (--It->second.Count == 0)
			{
				State->Objects.erase(It);
			}
			return;
		}
	}
	std::erase_if(State->Nameless, [Object](const auto& Other) { return Other.get() == Object; });
}

IConsoleObject* IConsoleManager::FindConsoleObject(const TCHAR* Name, bool) const
{
	std::lock_guard Lock(State->Mutex);
	const auto Found = State->Objects.find(Name);
	return Found == State->Objects.end() ? nullptr : Found->second.Object.get();
}

IConsoleVariable* IConsoleManager::FindConsoleVariable(const TCHAR* Name, bool) const
{
	IConsoleObject* Object = FindConsoleObject(Name);
	return Object != nullptr ? Object->AsVariable() : nullptr;
}

TConsoleVariableData<bool>* IConsoleManager::FindTConsoleVariableDataBool(const TCHAR* Name) const
{
	IConsoleObject* Object = FindConsoleObject(Name);
	return Object != nullptr ? Object->AsVariableBool() : nullptr;
}

TConsoleVariableData<int32>* IConsoleManager::FindTConsoleVariableDataInt(const TCHAR* Name) const
{
	IConsoleObject* Object = FindConsoleObject(Name);
	return Object != nullptr ? Object->AsVariableInt() : nullptr;
}

TConsoleVariableData<float>* IConsoleManager::FindTConsoleVariableDataFloat(const TCHAR* Name) const
{
	IConsoleObject* Object = FindConsoleObject(Name);
	return Object != nullptr ? Object->AsVariableFloat() : nullptr;
}

TConsoleVariableData<FString>* IConsoleManager::FindTConsoleVariableDataString(const TCHAR* Name) const
{
	IConsoleObject* Object = FindConsoleObject(Name);
	return Object != nullptr ? Object->AsVariableString() : nullptr;
}

void IConsoleManager::ForEachConsoleObjectThatStartsWith(
	const FConsoleObjectVisitor& Visitor, const TCHAR* Prefix) const
{
	std::lock_guard Lock(State->Mutex);
	for (const auto& [Name, Registration] : State->Objects)
	{
		if (Name.StartsWith(Prefix))
		{
			Visitor.Execute(*Name, Registration.Object.get());
		}
	}
}

void IConsoleManager::ForEachConsoleObjectThatContains(const FConsoleObjectVisitor& Visitor, const TCHAR* Part) const
{
	std::lock_guard Lock(State->Mutex);
	for (const auto& [Name, Registration] : State->Objects)
	{
		if (Name.Contains(Part))
		{
			Visitor.Execute(*Name, Registration.Object.get());
		}
	}
}

FConsoleVariableSinkHandle IConsoleManager::RegisterConsoleVariableSink_Handle(const FConsoleCommandDelegate& Command)
{
	std::lock_guard Lock(State->Mutex);
	State->Sinks.push_back(Command);
	return Command.GetHandle();
}

void IConsoleManager::UnregisterConsoleVariableSink_Handle(FConsoleVariableSinkHandle Handle)
{
	std::lock_guard Lock(State->Mutex);
	std::erase_if(State->Sinks,
		[Handle](const FConsoleCommandDelegate& Sink) { return Handle.IsValid() && Sink.GetHandle() == Handle; });
}

void IConsoleManager::CallAllConsoleVariableSinks()
{
	std::vector<FConsoleCommandDelegate> Sinks;
	{
		std::lock_guard Lock(State->Mutex);
		if (!GVariablesChanged.exchange(false))
		{
			return;
		}
		Sinks = State->Sinks;
	}
	for (const FConsoleCommandDelegate& Sink : Sinks)
	{
		Sink.ExecuteIfBound();
	}
}

bool IConsoleManager::ProcessUserConsoleInput(const TCHAR* Input)
{
	FString Name;
	FString Value;
	SplitConsoleInput(Input, Name, Value);
	IConsoleObject* Object = FindConsoleObject(*Name);
	if (Object == nullptr)
	{
		return false;
	}
	if (IConsoleCommand* Command = Object->AsCommand())
	{
		TArray<FString> Words;
		Value.ParseIntoArray(Words, " ");
		return Command->Execute(Words);
	}
	const IConsoleVariable& Variable = *Object->AsVariable();
	FString Error;
	if (Value.IsEmpty())
	{
		UE_LOG(LogConsoleManager, Display, "%s", *DescribeConsoleVariable(*Name, Variable));
	}
	else if (Value == "?")
	{
		UE_LOG(LogConsoleManager, Display, "HELP for '%s':\n%s\n%s", *Name, Variable.GetHelp(),
			*DescribeConsoleVariable(*Name, Variable));
	}
	else if (!TrySetConsoleVariable(*Name, *Value, ECVF_SetByConsole, Error))
	{
		UE_LOG(LogConsoleManager, Error, "%s", *Error);
	}
	return true;
}
