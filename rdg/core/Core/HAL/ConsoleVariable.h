// The one implementation of a console variable, by type of value. Private to Core.
#pragma once

#include "HAL/ConsoleVariableTools.h"
#include "Logging/LogMacros.h"
#include "Math/UnrealMathUtility.h"

namespace Drydock::Private
{

/** The next CallAllConsoleVariableSinks has something to tell. */
void NoteConsoleVariableChange();

inline bool ToValue(const TCHAR* Text, std::type_identity<bool>)
{
	return FString(Text).ToBool();
}
inline int32 ToValue(const TCHAR* Text, std::type_identity<int32>)
{
	// The words of a bool are good for an int too, as in the engine.
	return FString(Text) == "true" ? 1 : FCString::Atoi(Text);
}
inline float ToValue(const TCHAR* Text, std::type_identity<float>)
{
	return FString(Text) == "true" ? 1.0f : FCString::Atof(Text);
}
inline FString ToValue(const TCHAR* Text, std::type_identity<FString>)
{
	return FString(Text);
}

inline bool ToValue(double Number, std::type_identity<bool>)
{
	return Number != 0.0;
}
inline int32 ToValue(double Number, std::type_identity<int32>)
{
	// Casting what an int32 cannot hold is undefined.
	return FMath::IsNaN(Number) ? 0 : static_cast<int32>(FMath::Clamp(Number, -2147483648.0, 2147483647.0));
}
inline float ToValue(double Number, std::type_identity<float>)
{
	return static_cast<float>(Number);
}
inline FString ToValue(double Number, std::type_identity<FString>)
{
	return LexToString(Number);
}

inline double ToNumber(double Value)
{
	return Value;
}
inline double ToNumber(const FString& Value)
{
	return FCString::Atod(*Value);
}

template<typename T>
class TConsoleVariable final : public IConsoleVariable
{
public:
	TConsoleVariable(const TCHAR* InName, const T& InDefault, const TCHAR* InHelp, EConsoleVariableFlags InFlags)
		: Name(InName)
		, Help(InHelp != nullptr ? InHelp : "")
		, Flags((InFlags & ECVF_FlagMask) | ECVF_SetByConstructor)
		, Default(InDefault)
		, Data(InDefault)
	{
	}

	void SetReference(T& Value) { Data.SetReference(&Value); }

	const TCHAR* GetHelp() const override { return *Help; }
	void SetHelp(const TCHAR* InHelp) override { Help = InHelp; }
	EConsoleVariableFlags GetFlags() const override { return Flags; }
	void SetFlags(EConsoleVariableFlags InFlags) override { Flags = InFlags; }
	IConsoleVariable* AsVariable() override { return this; }

	bool IsVariableBool() const override { return std::is_same_v<T, bool>; }
	bool IsVariableInt() const override { return std::is_same_v<T, int32>; }
	bool IsVariableFloat() const override { return std::is_same_v<T, float>; }
	bool IsVariableString() const override { return std::is_same_v<T, FString>; }
	TConsoleVariableData<bool>* AsVariableBool() override { return GetData<bool>(); }
	TConsoleVariableData<int32>* AsVariableInt() override { return GetData<int32>(); }
	TConsoleVariableData<float>* AsVariableFloat() override { return GetData<float>(); }
	TConsoleVariableData<FString>* AsVariableString() override { return GetData<FString>(); }

	using IConsoleVariable::Set;
	void Set(const TCHAR* Text, EConsoleVariableFlags SetBy) override
	{
		SetValue(ToValue(Text, std::type_identity<T>()), SetBy);
	}

	bool GetBool() const override
	{
		if constexpr (std::is_same_v<T, FString>)
		{
			return GetValue().ToBool();
		}
		else
		{
			return GetValue() != T(0);
		}
	}
	int32 GetInt() const override { return ToValue(ToNumber(GetValue()), std::type_identity<int32>()); }
	float GetFloat() const override { return static_cast<float>(ToNumber(GetValue())); }
	FString GetString() const override { return LexToString(GetValue()); }
	FString GetDefaultValue() const override { return LexToString(Default); }
	FConsoleVariableMulticastDelegate& OnChangedDelegate() override { return OnChanged; }

	void ResetToDefault() override { Assign(Default, ECVF_SetByConstructor); }
	void Restore(const FString& Text, EConsoleVariableFlags SetBy) override
	{
		Assign(ToValue(*Text, std::type_identity<T>()), SetBy);
	}

protected:
	void SetNumber(double Number, EConsoleVariableFlags SetBy) override
	{
		SetValue(ToValue(Number, std::type_identity<T>()), SetBy);
	}

private:
	T GetValue() const { return Data.GetValueOnAnyThread(); }

	static bool IsSame(const T& A, const T& B)
	{
		if constexpr (std::is_same_v<T, FString>)
		{
			return A.Equals(B);
		}
		else
		{
			return A == B;
		}
	}

	template<typename U>
	TConsoleVariableData<U>* GetData()
	{
		if constexpr (std::is_same_v<T, U>)
		{
			return &Data;
		}
		else
		{
			return nullptr;
		}
	}

	/** Whatever the priorities. */
	void Assign(const T& NewValue, EConsoleVariableFlags SetBy)
	{
		Flags = (Flags & ~ECVF_SetByMask) | (SetBy & ECVF_SetByMask);
		if (!IsSame(GetValue(), NewValue))
		{
			Data.SetValue(NewValue);
			Broadcast(SetBy);
		}
	}

	void SetValue(const T& NewValue, EConsoleVariableFlags SetBy)
	{
		const FString Refusal = DescribeRefusedSet(*Name, *this, SetBy);
		if (!Refusal.IsEmpty())
		{
			UE_LOG(LogConsoleManager, Warning, "%s", *Refusal);
			return;
		}
		Flags = (Flags & ~ECVF_SetByMask) | (SetBy & ECVF_SetByMask);
		Data.SetValue(NewValue);
		Broadcast(SetBy);
	}

	void Broadcast(EConsoleVariableFlags SetBy)
	{
		if ((SetBy & ECVF_Set_NoSinkCall_Unsafe) == ECVF_Default)
		{
			NoteConsoleVariableChange();
			OnChanged.Broadcast(this);
		}
	}

	FString Name;
	FString Help;
	EConsoleVariableFlags Flags;
	T Default;
	TConsoleVariableData<T> Data;
	FConsoleVariableMulticastDelegate OnChanged;
};

} // namespace Drydock::Private
