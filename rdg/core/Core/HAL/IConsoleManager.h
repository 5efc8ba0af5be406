// Console variables: named switches with a type, a default and help. Names ignore case. Who sets a variable matters: a
// setter of lower priority than the last one is ignored with a warning, so that a command line beats a config whichever
// comes first. Values may be read by any thread at any time. Source: engine HAL/IConsoleManager.h; what is drydock's
// own is in HAL/ConsoleVariableTools.h.
#pragma once

#include "Containers/Array.h"
#include "Containers/UnrealString.h"
#include "Delegates/Delegate.h"
#include "HAL/ConsoleVariableData.h"
#include "Misc/EnumClassFlags.h"

/** Low bits: what the variable is. High byte: who set it, rising in priority. */
enum EConsoleVariableFlags : uint32
{
	ECVF_FlagMask = 0x0000ffff,
	ECVF_Default = 0x0,
	ECVF_Cheat = 0x1,
	ECVF_ReadOnly = 0x4,
	ECVF_Unregistered = 0x8,
	ECVF_CreatedFromIni = 0x10,
	ECVF_RenderThreadSafe = 0x20,
	ECVF_Scalability = 0x40,
	ECVF_ScalabilityGroup = 0x80,
	ECVF_Preview = 0x100,
	ECVF_ExcludeFromPreview = 0x200,
	ECVF_NotSimulated = 0x8000, // drydock's own: known by name and default only, nothing reads it yet

	ECVF_SetFlagMask = 0x00ff0000,
	ECVF_Set_NoSinkCall_Unsafe = 0x00010000,

	ECVF_SetByMask = 0xff000000,
	ECVF_SetByConstructor = 0x00000000,
	ECVF_SetByScalability = 0x01000000,
	ECVF_SetByGameSetting = 0x02000000,
	ECVF_SetByProjectSetting = 0x03000000,
	ECVF_SetBySystemSettingsIni = 0x04000000,
	ECVF_SetByPluginLowPriority = 0x05000000,
	ECVF_SetByDeviceProfile = 0x06000000,
	ECVF_SetByPluginHighPriority = 0x07000000,
	ECVF_SetByGameOverride = 0x08000000,
	ECVF_SetByConsoleVariablesIni = 0x09000000,
	ECVF_SetByHotfix = 0x0a000000,
	ECVF_SetByPreview = 0x0b000000,
	ECVF_SetByCommandline = 0x0c000000,
	ECVF_SetByCode = 0x0d000000,
	ECVF_SetByConsole = 0x0e000000,
};
ENUM_CLASS_FLAGS(EConsoleVariableFlags)

class IConsoleVariable;
class IConsoleCommand;
class UWorld;

using FConsoleVariableDelegate = TDelegate<void(IConsoleVariable*)>;
using FConsoleVariableMulticastDelegate = TMulticastDelegate<void(IConsoleVariable*)>;
using FConsoleCommandDelegate = TDelegate<void()>;
using FConsoleCommandWithArgsDelegate = TDelegate<void(const TArray<FString>&)>;
using FConsoleCommandWithWorldDelegate = TDelegate<void(UWorld*)>;
using FConsoleCommandWithWorldAndArgsDelegate = TDelegate<void(const TArray<FString>&, UWorld*)>;

namespace Drydock
{

/** The world that commands get: GWorld sets it. Null in a program without a world. */
DRYDOCK_API UWorld*& GetConsoleWorld();

} // namespace Drydock

/** A variable or a command. */
class DRYDOCK_API IConsoleObject
{
public:
	virtual ~IConsoleObject() = default;

	virtual const TCHAR* GetHelp() const = 0;
	virtual void SetHelp(const TCHAR* Help) = 0;
	virtual EConsoleVariableFlags GetFlags() const = 0;
	virtual void SetFlags(EConsoleVariableFlags Flags) = 0;
	bool TestFlags(EConsoleVariableFlags Flags) const { return (GetFlags() & Flags) != ECVF_Default; }

	virtual IConsoleVariable* AsVariable() { return nullptr; }
	virtual IConsoleCommand* AsCommand() { return nullptr; }
	virtual bool IsVariableBool() const { return false; }
	virtual bool IsVariableInt() const { return false; }
	virtual bool IsVariableFloat() const { return false; }
	virtual bool IsVariableString() const { return false; }
	/** Null unless the variable has that type. */
	virtual TConsoleVariableData<bool>* AsVariableBool() { return nullptr; }
	virtual TConsoleVariableData<int32>* AsVariableInt() { return nullptr; }
	virtual TConsoleVariableData<float>* AsVariableFloat() { return nullptr; }
	virtual TConsoleVariableData<FString>* AsVariableString() { return nullptr; }
};

class DRYDOCK_API IConsoleVariable : public IConsoleObject
{
public:
	/** Sets from text. Text that does not read as the type counts as 0 or false; TrySetConsoleVariable checks. */
	virtual void Set(const TCHAR* Text, EConsoleVariableFlags SetBy = ECVF_SetByCode) = 0;
	void Set(const FString& Text, EConsoleVariableFlags SetBy = ECVF_SetByCode) { Set(*Text, SetBy); }
	/** Sets from a number; it is converted to the variable's type. */
	void Set(bool Value, EConsoleVariableFlags SetBy = ECVF_SetByCode) { SetNumber(Value ? 1.0 : 0.0, SetBy); }
	void Set(int32 Value, EConsoleVariableFlags SetBy = ECVF_SetByCode) { SetNumber(Value, SetBy); }
	void Set(float Value, EConsoleVariableFlags SetBy = ECVF_SetByCode) { SetNumber(Value, SetBy); }
	void Set(double Value, EConsoleVariableFlags SetBy = ECVF_SetByCode) { SetNumber(Value, SetBy); }
	template<typename T>
	void SetWithCurrentPriority(T Value)
	{
		Set(Value, GetFlags() & ECVF_SetByMask);
	}

	virtual bool GetBool() const = 0;
	virtual int32 GetInt() const = 0;
	virtual float GetFloat() const = 0;
	virtual FString GetString() const = 0;
	virtual FString GetDefaultValue() const = 0;

	/** Runs after the value was set, by whom ever. */
	virtual FConsoleVariableMulticastDelegate& OnChangedDelegate() = 0;
	void SetOnChangedCallback(const FConsoleVariableDelegate& Callback)
	{
		OnChangedDelegate().Clear();
		OnChangedDelegate().Add(Callback);
	}

	/** Back to the default, as if never set; runs the callbacks if the value was another. Drydock's own. */
	virtual void ResetToDefault() = 0;
	/** Value and setter as they were once, whoever set it since; runs the callbacks if the value was another. Drydock's
	 *  own. */
	virtual void Restore(const FString& Text, EConsoleVariableFlags SetBy) = 0;

protected:
	virtual void SetNumber(double Value, EConsoleVariableFlags SetBy) = 0;
};

class DRYDOCK_API IConsoleCommand : public IConsoleObject
{
public:
	virtual bool Execute(const TArray<FString>& Arguments) = 0;
};

using FConsoleObjectVisitor = TDelegate<void(const TCHAR* Name, IConsoleObject* Object)>;

/** Names a sink, to take it away again. */
using FConsoleVariableSinkHandle = FDelegateHandle;

/** All console objects of the process. There from the first use on, so that static variables may register. */
class DRYDOCK_API IConsoleManager : private FNoncopyable
{
public:
	static IConsoleManager& Get();

	/** A name that is taken by a variable of the same type gives that one; of another type, an error on stderr and a
	 *  variable that the console does not find. A variable that is ECVF_NotSimulated gives its name to any other. */
	IConsoleVariable* RegisterConsoleVariable(
		const TCHAR* Name, bool Default, const TCHAR* Help, EConsoleVariableFlags Flags = ECVF_Default);
	IConsoleVariable* RegisterConsoleVariable(
		const TCHAR* Name, int32 Default, const TCHAR* Help, EConsoleVariableFlags Flags = ECVF_Default);
	IConsoleVariable* RegisterConsoleVariable(
		const TCHAR* Name, float Default, const TCHAR* Help, EConsoleVariableFlags Flags = ECVF_Default);
	IConsoleVariable* RegisterConsoleVariable(
		const TCHAR* Name, const TCHAR* Default, const TCHAR* Help, EConsoleVariableFlags Flags = ECVF_Default);
	IConsoleVariable* RegisterConsoleVariable(
		const TCHAR* Name, const FString& Default, const TCHAR* Help, EConsoleVariableFlags Flags = ECVF_Default)
	{
		return RegisterConsoleVariable(Name, *Default, Help, Flags);
	}
	/** The value lives in Value, which must outlive the registration and holds the default now. */
	IConsoleVariable* RegisterConsoleVariableRef(
		const TCHAR* Name, bool& Value, const TCHAR* Help, EConsoleVariableFlags Flags = ECVF_Default);
	IConsoleVariable* RegisterConsoleVariableRef(
		const TCHAR* Name, int32& Value, const TCHAR* Help, EConsoleVariableFlags Flags = ECVF_Default);
	IConsoleVariable* RegisterConsoleVariableRef(
		const TCHAR* Name, float& Value, const TCHAR* Help, EConsoleVariableFlags Flags = ECVF_Default);
	IConsoleVariable* RegisterConsoleVariableRef(
		const TCHAR* Name, FString& Value, const TCHAR* Help, EConsoleVariableFlags Flags = ECVF_Default);
	IConsoleCommand* RegisterConsoleCommand(const TCHAR* Name, const TCHAR* Help,
		const FConsoleCommandDelegate& Command, EConsoleVariableFlags Flags = ECVF_Default);
	IConsoleCommand* RegisterConsoleCommand(const TCHAR* Name, const TCHAR* Help,
		const FConsoleCommandWithArgsDelegate& Command, EConsoleVariableFlags Flags = ECVF_Default);
	IConsoleCommand* RegisterConsoleCommand(const TCHAR* Name, const TCHAR* Help,
		const FConsoleCommandWithWorldAndArgsDelegate& Command, EConsoleVariableFlags Flags = ECVF_Default);
	/** Must be called as often as the object was registered. The pointer is stale after the last time. */
	void UnregisterConsoleObject(IConsoleObject* Object, bool bKeepState = true);
	void UnregisterConsoleObject(const TCHAR* Name, bool bKeepState = true)
	{
		UnregisterConsoleObject(FindConsoleObject(Name), bKeepState);
	}

	/** Null if there is none of that name and kind. */
	IConsoleObject* FindConsoleObject(const TCHAR* Name, bool bTrackFrequentCalls = true) const;
	IConsoleVariable* FindConsoleVariable(const TCHAR* Name, bool bTrackFrequentCalls = true) const;
	TConsoleVariableData<bool>* FindTConsoleVariableDataBool(const TCHAR* Name) const;
	TConsoleVariableData<int32>* FindTConsoleVariableDataInt(const TCHAR* Name) const;
	TConsoleVariableData<float>* FindTConsoleVariableDataFloat(const TCHAR* Name) const;
	TConsoleVariableData<FString>* FindTConsoleVariableDataString(const TCHAR* Name) const;
	bool IsNameRegistered(const TCHAR* Name) const { return FindConsoleObject(Name) != nullptr; }

	/** Visits in alphabetical order. */
	void ForEachConsoleObjectThatStartsWith(const FConsoleObjectVisitor& Visitor, const TCHAR* Prefix = TEXT("")) const;
	void ForEachConsoleObjectThatContains(const FConsoleObjectVisitor& Visitor, const TCHAR* Part) const;

	/** "Name Value" and "Name=Value" set a variable as the console, "Name" logs its value and who set it, "Name ?" its
	 *  help as well, "Name Arguments" runs a command. A value that does not fit the type is an error and changes
	 *  nothing. False if there is no such object. */
	bool ProcessUserConsoleInput(const TCHAR* Input);

	/** Sinks run together after variables have changed, not once for each: when CallAllConsoleVariableSinks is called
	 *  (by drydock before each run), and only if one has changed since. */
	FConsoleVariableSinkHandle RegisterConsoleVariableSink_Handle(const FConsoleCommandDelegate& Command);
	void UnregisterConsoleVariableSink_Handle(FConsoleVariableSinkHandle Handle);
	void CallAllConsoleVariableSinks();

private:
	IConsoleManager();
	~IConsoleManager();

	struct FState;
	FState* State;
};

/** A registration that ends with this object. */
class FAutoConsoleObject : private FNoncopyable
{
protected:
	explicit FAutoConsoleObject(IConsoleObject* InTarget)
		: Target(InTarget)
	{
	}
	virtual ~FAutoConsoleObject() { IConsoleManager::Get().UnregisterConsoleObject(Target); }

	IConsoleObject* GetTarget() const { return Target; }

private:
	IConsoleObject* Target;
};

namespace Drydock::Private
{

/** The data of a variable of that type; a failed check for any other. */
template<typename T>
TConsoleVariableData<T>* GetConsoleVariableData(IConsoleObject& Object)
{
	TConsoleVariableData<T>* Data = nullptr;
	if constexpr (std::is_same_v<T, bool>)
	{
		Data = Object.AsVariableBool();
	}
	else if constexpr (std::is_same_v<T, int32>)
	{
		Data = Object.AsVariableInt();
	}
	else if constexpr (std::is_same_v<T, float>)
	{
		Data = Object.AsVariableFloat();
	}
	else
	{
		static_assert(std::is_same_v<T, FString>, "A console variable is bool, int32, float or FString");
		Data = Object.AsVariableString();
	}
	check(Data != nullptr);
	return Data;
}

} // namespace Drydock::Private

/** `static TAutoConsoleVariable<int32> CVarX(TEXT("r.X"), 1, TEXT("help"), ECVF_RenderThreadSafe);`
 *  T is bool, int32, float or FString. */
template<typename T>
class TAutoConsoleVariable : public FAutoConsoleObject
{
public:
	TAutoConsoleVariable(
		const TCHAR* Name, const T& Default, const TCHAR* Help, EConsoleVariableFlags Flags = ECVF_Default)
		: FAutoConsoleObject(IConsoleManager::Get().RegisterConsoleVariable(Name, Default, Help, Flags))
		, Data(Drydock::Private::GetConsoleVariableData<T>(*GetTarget()))
	{
	}
	TAutoConsoleVariable(const TCHAR* Name, const T& Default, const TCHAR* Help,
		const FConsoleVariableDelegate& Callback, EConsoleVariableFlags Flags = ECVF_Default)
		: TAutoConsoleVariable(Name, Default, Help, Flags)
	{
		AsVariable()->SetOnChangedCallback(Callback);
	}

	T GetValueOnGameThread() const { return Data->GetValueOnGameThread(); }
	T GetValueOnRenderThread() const { return Data->GetValueOnRenderThread(); }
	T GetValueOnAnyThread(bool = false) const { return Data->GetValueOnAnyThread(); }
	T Get() const { return Data->GetValueOnAnyThread(); }
	IConsoleVariable* AsVariable() const { return GetTarget()->AsVariable(); }
	IConsoleVariable* operator->() const { return AsVariable(); }
	IConsoleVariable& operator*() const { return *AsVariable(); }

private:
	TConsoleVariableData<T>* Data;
};

/** A variable whose value is a plain C++ one: bool, int32, float or FString. */
class FAutoConsoleVariableRef : public FAutoConsoleObject
{
public:
	template<typename T>
	FAutoConsoleVariableRef(const TCHAR* Name, T& Value, const TCHAR* Help, EConsoleVariableFlags Flags = ECVF_Default)
		: FAutoConsoleObject(IConsoleManager::Get().RegisterConsoleVariableRef(Name, Value, Help, Flags))
	{
	}
	template<typename T>
	FAutoConsoleVariableRef(const TCHAR* Name, T& Value, const TCHAR* Help, const FConsoleVariableDelegate& Callback,
		EConsoleVariableFlags Flags = ECVF_Default)
		: FAutoConsoleVariableRef(Name, Value, Help, Flags)
	{
		AsVariable()->SetOnChangedCallback(Callback);
	}

	IConsoleVariable* AsVariable() const { return GetTarget()->AsVariable(); }
	IConsoleVariable* operator->() const { return AsVariable(); }
	IConsoleVariable& operator*() const { return *AsVariable(); }
};

/** A variable of the type of its default (bool, int32, float or text), without typed reads. */
class FAutoConsoleVariable : public FAutoConsoleObject
{
public:
	template<typename T>
	FAutoConsoleVariable(
		const TCHAR* Name, const T& Default, const TCHAR* Help, EConsoleVariableFlags Flags = ECVF_Default)
		: FAutoConsoleObject(IConsoleManager::Get().RegisterConsoleVariable(Name, Default, Help, Flags))
	{
	}
	template<typename T>
	FAutoConsoleVariable(const TCHAR* Name, const T& Default, const TCHAR* Help,
		const FConsoleVariableDelegate& Callback, EConsoleVariableFlags Flags = ECVF_Default)
		: FAutoConsoleVariable(Name, Default, Help, Flags)
	{
		AsVariable()->SetOnChangedCallback(Callback);
	}

	IConsoleVariable* AsVariable() const { return GetTarget()->AsVariable(); }
	IConsoleVariable* operator->() const { return AsVariable(); }
	IConsoleVariable& operator*() const { return *AsVariable(); }
};

/** A sink that ends with this object. */
class FAutoConsoleVariableSink : private FNoncopyable
{
public:
	explicit FAutoConsoleVariableSink(const FConsoleCommandDelegate& Command)
		: Handle(IConsoleManager::Get().RegisterConsoleVariableSink_Handle(Command))
	{
	}
	~FAutoConsoleVariableSink() { IConsoleManager::Get().UnregisterConsoleVariableSink_Handle(Handle); }

private:
	FConsoleVariableSinkHandle Handle;
};

class FAutoConsoleCommand : public FAutoConsoleObject
{
public:
	FAutoConsoleCommand(const TCHAR* Name, const TCHAR* Help, const FConsoleCommandDelegate& Command,
		EConsoleVariableFlags Flags = ECVF_Default)
		: FAutoConsoleObject(IConsoleManager::Get().RegisterConsoleCommand(Name, Help, Command, Flags))
	{
	}
	FAutoConsoleCommand(const TCHAR* Name, const TCHAR* Help, const FConsoleCommandWithArgsDelegate& Command,
		EConsoleVariableFlags Flags = ECVF_Default)
		: FAutoConsoleObject(IConsoleManager::Get().RegisterConsoleCommand(Name, Help, Command, Flags))
	{
	}
};

class FAutoConsoleCommandWithWorld : public FAutoConsoleObject
{
public:
	FAutoConsoleCommandWithWorld(const TCHAR* Name, const TCHAR* Help, const FConsoleCommandWithWorldDelegate& Command,
		EConsoleVariableFlags Flags = ECVF_Default)
		: FAutoConsoleObject(IConsoleManager::Get().RegisterConsoleCommand(Name, Help,
			  FConsoleCommandWithWorldAndArgsDelegate::CreateLambda(
				  [Command](const TArray<FString>&, UWorld* World) { Command.ExecuteIfBound(World); }),
			  Flags))
	{
	}
};

class FAutoConsoleCommandWithWorldAndArgs : public FAutoConsoleObject
{
public:
	FAutoConsoleCommandWithWorldAndArgs(const TCHAR* Name, const TCHAR* Help,
		const FConsoleCommandWithWorldAndArgsDelegate& Command, EConsoleVariableFlags Flags = ECVF_Default)
		: FAutoConsoleObject(IConsoleManager::Get().RegisterConsoleCommand(Name, Help, Command, Flags))
	{
	}
};
