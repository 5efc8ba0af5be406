// Callables: TFunction (copyable owner), TUniqueFunction (move-only owner), TFunctionRef (borrows for a call).
// Source: engine Templates/Function.h.
#pragma once

#include "Misc/AssertionMacros.h"

#include <functional>
#include <memory>
#include <type_traits>
#include <utility>

template<typename Signature>
class TFunction;
template<typename Signature>
class TUniqueFunction;
template<typename Signature>
class TFunctionRef;

template<typename ReturnType, typename... ArgumentTypes>
class TFunction<ReturnType(ArgumentTypes...)>
{
public:
	TFunction(std::nullptr_t = nullptr) {}
	template<typename FunctorType>
	requires(!std::is_same_v<std::decay_t<FunctorType>, TFunction> &&
			 std::is_invocable_r_v<ReturnType, std::decay_t<FunctorType>&, ArgumentTypes...>)
		TFunction(FunctorType&& Functor)
		: Function(std::forward<FunctorType>(Functor))
	{
	}

	ReturnType operator()(ArgumentTypes... Arguments) const
	{
		checkf(IsSet(), "Attempting to call an unbound TFunction!");
		return Function(std::forward<ArgumentTypes>(Arguments)...);
	}

	bool IsSet() const { return static_cast<bool>(Function); }
	explicit operator bool() const { return IsSet(); }
	void Reset() { Function = nullptr; }

	friend bool operator==(const TFunction& A, std::nullptr_t) { return !A.IsSet(); }

private:
	std::function<ReturnType(ArgumentTypes...)> Function;
};

template<typename ReturnType, typename... ArgumentTypes>
class TUniqueFunction<ReturnType(ArgumentTypes...)>
{
public:
	TUniqueFunction(std::nullptr_t = nullptr) {}
	template<typename FunctorType>
	requires(!std::is_same_v<std::decay_t<FunctorType>, TUniqueFunction> &&
			 std::is_invocable_r_v<ReturnType, std::decay_t<FunctorType>&, ArgumentTypes...>)
		TUniqueFunction(FunctorType&& Functor)
		: Function(
			  std::make_unique<TFunctor<std::decay_t<FunctorType>>>(std::in_place, std::forward<FunctorType>(Functor)))
	{
	}

	ReturnType operator()(ArgumentTypes... Arguments) const
	{
		checkf(IsSet(), "Attempting to call an unbound TUniqueFunction!");
		return Function->Call(std::forward<ArgumentTypes>(Arguments)...);
	}

	bool IsSet() const { return Function != nullptr; }
	explicit operator bool() const { return IsSet(); }
	void Reset() { Function.reset(); }

private:
	struct IFunctor
	{
		virtual ~IFunctor() = default;
		virtual ReturnType Call(ArgumentTypes... Arguments) = 0;
	};

	template<typename FunctorType>
	struct TFunctor final : IFunctor
	{
		template<typename SourceType>
		TFunctor(std::in_place_t, SourceType&& Source)
			: Functor(std::forward<SourceType>(Source))
		{
		}
		ReturnType Call(ArgumentTypes... Arguments) override
		{
			return Functor(std::forward<ArgumentTypes>(Arguments)...);
		}

		FunctorType Functor;
	};

	std::unique_ptr<IFunctor> Function;
};

/** The callable must outlive the reference: for arguments only. */
template<typename ReturnType, typename... ArgumentTypes>
class TFunctionRef<ReturnType(ArgumentTypes...)>
{
public:
	template<typename FunctorType>
	requires(!std::is_same_v<std::decay_t<FunctorType>, TFunctionRef> &&
			 std::is_invocable_r_v<ReturnType, FunctorType&, ArgumentTypes...>) TFunctionRef(FunctorType&& InFunctor)
	{
		using FunctorPointer = std::add_pointer_t<std::remove_reference_t<FunctorType>>;
		if constexpr (std::is_function_v<std::remove_reference_t<FunctorType>>)
		{
			Functor = reinterpret_cast<void*>(&InFunctor);
		}
		else
		{
			Functor = const_cast<void*>(static_cast<const void*>(std::addressof(InFunctor)));
		}
		Thunk = [](void* Pointer, ArgumentTypes... Arguments) -> ReturnType
		{
			return (*reinterpret_cast<FunctorPointer>(Pointer))(std::forward<ArgumentTypes>(Arguments)...);
		};
	}

	ReturnType operator()(ArgumentTypes... Arguments) const
	{
		return Thunk(Functor, std::forward<ArgumentTypes>(Arguments)...);
	}

private:
	void* Functor;
	ReturnType (*Thunk)(void*, ArgumentTypes...);
};
