// TOptional: a value or nothing. Reading an unset one is a failed check. Source: engine Misc/Optional.h.
#pragma once

#include "Misc/AssertionMacros.h"

#include <optional>

struct FNullOpt
{
};
inline constexpr FNullOpt NullOpt{};

template<typename T>
class TOptional
{
public:
	using ElementType = T;

	TOptional() = default;
	TOptional(FNullOpt) {}
	TOptional(const T& InValue)
		: Data(InValue)
	{
	}
	TOptional(T&& InValue)
		: Data(std::move(InValue))
	{
	}

	bool IsSet() const { return Data.has_value(); }
	explicit operator bool() const { return IsSet(); }
	T& GetValue()
	{
		CheckSet();
		return *Data;
	}
	const T& GetValue() const
	{
		CheckSet();
		return *Data;
	}
	/** The value, or Default if there is none. */
	T Get(T Default) const { return Data.value_or(std::move(Default)); }
	T* GetPtrOrNull() { return IsSet() ? &*Data : nullptr; }
	const T* GetPtrOrNull() const { return IsSet() ? &*Data : nullptr; }
	T& operator*() { return GetValue(); }
	const T& operator*() const { return GetValue(); }
	T* operator->() { return &GetValue(); }
	const T* operator->() const { return &GetValue(); }
	void Reset() { Data.reset(); }
	template<typename... ArgumentTypes>
	T& Emplace(ArgumentTypes&&... Arguments)
	{
		return Data.emplace(std::forward<ArgumentTypes>(Arguments)...);
	}

	friend bool operator==(const TOptional& A, const TOptional& B) { return A.Data == B.Data; }

private:
	void CheckSet() const { checkf(IsSet(), "It is an error to call GetValue() on an unset TOptional"); }

	std::optional<T> Data;
};
