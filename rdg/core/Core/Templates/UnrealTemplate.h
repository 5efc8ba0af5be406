// Moving, forwarding and scope helpers under the engine's names. Source: engine Templates/UnrealTemplate.h,
// UnrealTypeTraits.h, ScopeExit (Misc/ScopeExit.h).
#pragma once

#include "CoreTypes.h"

#include <type_traits>
#include <utility>

/** std::move that refuses const objects and temporaries, where it would silently copy or do nothing. */
template<typename T>
constexpr std::remove_reference_t<T>&& MoveTemp(T&& Object) noexcept
{
	static_assert(std::is_lvalue_reference_v<T>, "MoveTemp called on a temporary");
	static_assert(!std::is_const_v<std::remove_reference_t<T>>, "MoveTemp called on a const object");
	return static_cast<std::remove_reference_t<T>&&>(Object);
}

/** MoveTemp for generic code: takes anything. */
template<typename T>
constexpr std::remove_reference_t<T>&& MoveTempIfPossible(T&& Object) noexcept
{
	return static_cast<std::remove_reference_t<T>&&>(Object);
}

template<typename T>
constexpr T&& Forward(std::remove_reference_t<T>& Object) noexcept
{
	return static_cast<T&&>(Object);
}

template<typename T>
constexpr T&& Forward(std::remove_reference_t<T>&& Object) noexcept
{
	return static_cast<T&&>(Object);
}

/** A prvalue copy of Object. */
template<typename T>
constexpr T CopyTemp(const T& Object)
{
	return Object;
}

template<typename T>
constexpr void Swap(T& A, T& B)
{
	std::swap(A, B);
}

template<typename T, typename U = T>
constexpr T Exchange(T& Object, U&& NewValue)
{
	return std::exchange(Object, std::forward<U>(NewValue));
}

/** Base of classes that are not copied. */
class FNoncopyable
{
protected:
	FNoncopyable() = default;
	~FNoncopyable() = default;
	FNoncopyable(const FNoncopyable&) = delete;
	FNoncopyable& operator=(const FNoncopyable&) = delete;
};

/** Sets Value for the length of a scope and puts the old value back. */
template<typename T>
class TGuardValue : private FNoncopyable
{
public:
	TGuardValue(T& InReference, const T& NewValue)
		: Reference(InReference)
		, OriginalValue(InReference)
	{
		Reference = NewValue;
	}
	~TGuardValue() { Reference = OriginalValue; }

	const T& GetOriginalValue() const { return OriginalValue; }

private:
	T& Reference;
	T OriginalValue;
};

template<typename T, typename... Arguments>
struct TIsSame
{
	static constexpr bool Value = (std::is_same_v<T, Arguments> && ...);
};

template<typename Derived, typename Base>
struct TIsDerivedFrom
{
	static constexpr bool Value = std::is_base_of_v<Base, Derived>;
	static constexpr bool IsDerived = Value;
};

template<bool bCondition, typename T = void>
using TEnableIf = std::enable_if<bCondition, T>;

template<typename T>
struct TRemoveReference
{
	using Type = std::remove_reference_t<T>;
};

template<typename Enum>
constexpr std::underlying_type_t<Enum> ToUnderlying(Enum Value)
{
	return static_cast<std::underlying_type_t<Enum>>(Value);
}

namespace Drydock
{

/** Runs a function when the scope is left. */
template<typename FunctionType>
class TScopeExit : private FNoncopyable
{
public:
	explicit TScopeExit(FunctionType&& InFunction)
		: Function(std::move(InFunction))
	{
	}
	~TScopeExit() { Function(); }

private:
	FunctionType Function;
};

struct FScopeExitSyntax
{
	template<typename FunctionType>
	TScopeExit<FunctionType> operator+(FunctionType&& Function) const
	{
		return TScopeExit<FunctionType>(std::forward<FunctionType>(Function));
	}
};

} // namespace Drydock

/** `ON_SCOPE_EXIT { ... };` runs the block when the scope is left. */
#define ON_SCOPE_EXIT const auto ANONYMOUS_VARIABLE(ScopeExit_) = ::Drydock::FScopeExitSyntax() + [&]()
