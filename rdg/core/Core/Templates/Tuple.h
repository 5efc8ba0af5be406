// TPair and TTuple. Source: engine Templates/Tuple.h.
#pragma once

#include "Templates/TypeHash.h"

#include <tuple>
#include <type_traits>
#include <utility>

/** A key and its value; an element of TMap. */
template<typename InKeyType, typename InValueType>
struct TPair
{
	using KeyType = InKeyType;
	using ValueType = InValueType;

	InKeyType Key{};
	InValueType Value{};

	TPair() = default;
	template<typename A, typename B>
	requires(std::is_constructible_v<InKeyType, A&&>&& std::is_constructible_v<InValueType, B&&>)
		TPair(A&& InKey, B&& InValue)
		: Key(std::forward<A>(InKey))
		, Value(std::forward<B>(InValue))
	{
	}

	bool operator==(const TPair& Other) const { return Key == Other.Key && Value == Other.Value; }
};

template<typename KeyType, typename ValueType>
uint32 GetTypeHash(const TPair<KeyType, ValueType>& Pair)
{
	return HashCombine(GetTypeHash(Pair.Key), GetTypeHash(Pair.Value));
}

template<typename A, typename B>
TPair<std::decay_t<A>, std::decay_t<B>> MakePair(A&& Key, B&& Value)
{
	return {std::forward<A>(Key), std::forward<B>(Value)};
}

/** Elements by Get<Index>(). */
template<typename... Types>
class TTuple
{
public:
	TTuple() = default;
	explicit TTuple(Types... Values)
		: Data(std::move(Values)...)
	{
	}

	template<SIZE_T Index>
	auto& Get()
	{
		return std::get<Index>(Data);
	}
	template<SIZE_T Index>
	const auto& Get() const
	{
		return std::get<Index>(Data);
	}

	bool operator==(const TTuple& Other) const = default;

private:
	std::tuple<Types...> Data;
};

template<typename... Types>
TTuple<std::decay_t<Types>...> MakeTuple(Types&&... Values)
{
	return TTuple<std::decay_t<Types>...>(std::forward<Types>(Values)...);
}
