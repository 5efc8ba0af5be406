// The stored value of a console variable: read without a lock, except for text. Source: engine HAL/IConsoleManager.h
// (TConsoleVariableData).
#pragma once

#include "Containers/UnrealString.h"

#include <atomic>
#include <mutex>

template<typename T>
class TConsoleVariableData
{
public:
	explicit TConsoleVariableData(const T& InValue)
		: Value(InValue)
	{
	}

	// One value for all threads: rendering happens where the game runs.
	T GetValueOnGameThread() const { return GetValueOnAnyThread(); }
	T GetValueOnRenderThread() const { return GetValueOnAnyThread(); }
	T GetValueOnAnyThread(bool = false) const
	{
		return Reference != nullptr ? *Reference : Value.load(std::memory_order_relaxed);
	}

	void SetValue(const T& NewValue)
	{
		Value.store(NewValue, std::memory_order_relaxed);
		if (Reference != nullptr)
		{
			*Reference = NewValue;
		}
	}
	/** Makes InReference the place of the value; code may write to it without notice. */
	void SetReference(T* InReference) { Reference = InReference; }
	T* GetReference() const { return Reference; }

private:
	std::atomic<T> Value;
	T* Reference = nullptr;
};

template<>
class TConsoleVariableData<FString>
{
public:
	explicit TConsoleVariableData(const FString& InValue)
		: Value(InValue)
	{
	}

	FString GetValueOnGameThread() const { return GetValueOnAnyThread(); }
	FString GetValueOnRenderThread() const { return GetValueOnAnyThread(); }
	FString GetValueOnAnyThread(bool = false) const
	{
		std::lock_guard Lock(Mutex);
		return Reference != nullptr ? *Reference : Value;
	}

	void SetValue(const FString& NewValue)
	{
		std::lock_guard Lock(Mutex);
		Value = NewValue;
		if (Reference != nullptr)
		{
			*Reference = NewValue;
		}
	}
	void SetReference(FString* InReference) { Reference = InReference; }
	FString* GetReference() const { return Reference; }

private:
	mutable std::mutex Mutex;
	FString Value;
	FString* Reference = nullptr;
};
