// TVariant: a value of one of several types. Source: engine Misc/TVariant.h.
#pragma once

#include "Misc/AssertionMacros.h"

#include <utility>
#include <variant>

/** The first type of a variant that may hold nothing. */
struct FEmptyVariantState
{
	bool operator==(const FEmptyVariantState&) const = default;
};

/** Names the type that a variant is made with. */
template<typename T>
struct TInPlaceType
{
};

/** Holds its first type's default at first. Each type stands in the list once. */
template<typename... Types>
class TVariant : public std::variant<Types...>
{
	using FBase = std::variant<Types...>;

public:
	TVariant() = default;
	template<typename T, typename... ArgumentTypes>
	explicit TVariant(TInPlaceType<T>&&, ArgumentTypes&&... Arguments)
		: FBase(std::in_place_type<T>, std::forward<ArgumentTypes>(Arguments)...)
	{
	}

	template<typename T>
	bool IsType() const
	{
		return std::holds_alternative<T>(*this);
	}
	/** Null if it holds another type. */
	template<typename T>
	T* TryGet()
	{
		return std::get_if<T>(static_cast<FBase*>(this));
	}
	template<typename T>
	const T* TryGet() const
	{
		return const_cast<TVariant*>(this)->template TryGet<T>();
	}
	/** A check if it holds another type. */
	template<typename T>
	T& Get()
	{
		check(IsType<T>());
		return *TryGet<T>();
	}
	template<typename T>
	const T& Get() const
	{
		return const_cast<TVariant*>(this)->template Get<T>();
	}
	template<typename T>
	void Set(std::type_identity_t<T> Value)
	{
		FBase::template emplace<T>(std::move(Value));
	}
	template<typename T, typename... ArgumentTypes>
	void Emplace(ArgumentTypes&&... Arguments)
	{
		FBase::template emplace<T>(std::forward<ArgumentTypes>(Arguments)...);
	}
	/** Place of the type that it holds, from 0. */
	SIZE_T GetIndex() const { return FBase::index(); }
};

/** Calls Function with the value that each variant holds. */
template<typename FunctionType, typename... Types>
decltype(auto) Visit(FunctionType&& Function, const TVariant<Types...>& Variant)
{
	return std::visit(std::forward<FunctionType>(Function), static_cast<const std::variant<Types...>&>(Variant));
}
