// Permutation dimensions of a shader class and the domain that they span. An id is a mixed-radix number whose first
// dimension varies fastest: id = id0 + count0 * (id1 + count1 * (...)). Source: engine ShaderPermutation.h.
#pragma once

#include "CoreMinimal.h"
#include "ShaderCore.h"

#include <tuple>
#include <type_traits>
#include <utility>

/** A dimension that is a flag: ids and define values are 0 and 1. */
struct FShaderPermutationBool
{
	using Type = bool;

	static constexpr int32 PermutationCount = 2;
	static constexpr bool IsMultiDimensional = false;

	static int32 ToDimensionValueId(Type Value) { return Value ? 1 : 0; }
	static Type FromDimensionValueId(int32 Id) { return Id == 1; }
	static bool ToDefineValue(Type Value) { return Value; }
};

/** A dimension of Size consecutive values from FirstValue on: id = value - FirstValue. */
template<typename TType, int32 Size, int32 FirstValue = 0>
struct TShaderPermutationInt
{
	using Type = TType;

	static constexpr int32 PermutationCount = Size;
	static constexpr bool IsMultiDimensional = false;
	static constexpr Type MinValue = static_cast<Type>(FirstValue);
	static constexpr Type MaxValue = static_cast<Type>(FirstValue + Size - 1);

	static int32 ToDimensionValueId(Type Value)
	{
		const int32 Id = static_cast<int32>(Value) - FirstValue;
		checkf(Id >= 0 && Id < Size, TEXT("permutation value %d is outside %d..%d"), static_cast<int32>(Value),
			FirstValue, FirstValue + Size - 1);
		return Id;
	}

	static Type FromDimensionValueId(int32 Id) { return static_cast<Type>(Id + FirstValue); }
	static int32 ToDefineValue(Type Value) { return ToDimensionValueId(Value) + FirstValue; }
};

/** A dimension of listed values. Ids run backward: the first value has id count - 1, the last has id 0. */
template<int32... Values>
struct TShaderPermutationSparseInt
{
	static_assert(sizeof...(Values) > 0, "SHADER_PERMUTATION_SPARSE_INT needs at least one value");

	using Type = int32;

	static constexpr int32 PermutationCount = sizeof...(Values);
	static constexpr bool IsMultiDimensional = false;

	static int32 ToDimensionValueId(Type Value)
	{
		for (int32 Index = 0; Index < PermutationCount; ++Index)
		{
			if (List[Index] == Value)
			{
				return PermutationCount - 1 - Index;
			}
		}
		checkf(false, TEXT("%d is none of the values of the sparse permutation"), Value);
		return 0;
	}

	static Type FromDimensionValueId(int32 Id)
	{
		checkf(Id >= 0 && Id < PermutationCount, TEXT("sparse permutation id %d is outside 0..%d"), Id,
			PermutationCount - 1);
		return List[PermutationCount - 1 - Id];
	}

	static int32 ToDefineValue(Type Value)
	{
		ToDimensionValueId(Value);
		return Value;
	}

private:
	static constexpr int32 List[] = {Values...};
};

/** The product of dimensions; itself usable as a dimension of another domain. Default: every dimension at its id 0. */
template<typename... TDimensions>
class TShaderPermutationDomain
{
public:
	using Type = TShaderPermutationDomain<TDimensions...>;

	static constexpr int32 PermutationCount = (1 * ... * TDimensions::PermutationCount);
	static constexpr bool IsMultiDimensional = true;

	TShaderPermutationDomain()
		: TShaderPermutationDomain(0)
	{
	}

	explicit TShaderPermutationDomain(int32 PermutationId)
	{
		checkf(PermutationId >= 0 && PermutationId < PermutationCount, TEXT("permutation id %d is outside 0..%d"),
			PermutationId, PermutationCount - 1);
		[[maybe_unused]] int32 Rest = PermutationId;
		ForEachDimension(
			[&Rest]<typename TDimension>(auto& Value)
			{
				Value = TDimension::FromDimensionValueId(Rest % TDimension::PermutationCount);
				Rest /= TDimension::PermutationCount;
			});
	}

	/** TDimension must be one of this domain's own dimensions. */
	template<typename TDimension>
	void Set(typename TDimension::Type Value)
	{
		std::get<IndexOf<TDimension>()>(Values) = Value;
	}

	template<typename TDimension>
	const typename TDimension::Type& Get() const
	{
		return std::get<IndexOf<TDimension>()>(Values);
	}

	int32 ToDimensionValueId() const
	{
		int32 Id = 0;
		[[maybe_unused]] int32 Stride = 1;
		const_cast<TShaderPermutationDomain*>(this)->ForEachDimension(
			[&Id, &Stride]<typename TDimension>(const auto& Value)
			{
				Id += Stride * TDimension::ToDimensionValueId(Value);
				Stride *= TDimension::PermutationCount;
			});
		return Id;
	}

	static int32 ToDimensionValueId(const Type& Domain) { return Domain.ToDimensionValueId(); }
	static Type FromDimensionValueId(int32 PermutationId) { return Type(PermutationId); }

	/** Sets each dimension's define. */
	void ModifyCompilationEnvironment(FShaderCompilerEnvironment& OutEnvironment) const
	{
		const_cast<TShaderPermutationDomain*>(this)->ForEachDimension(
			[&OutEnvironment]<typename TDimension>(const auto& Value)
			{
				if constexpr (TDimension::IsMultiDimensional)
				{
					Value.ModifyCompilationEnvironment(OutEnvironment);
				}
				else
				{
					OutEnvironment.SetDefine(TDimension::DefineName, TDimension::ToDefineValue(Value));
				}
			});
	}

	bool operator==(const TShaderPermutationDomain& Other) const
	{
		return ToDimensionValueId() == Other.ToDimensionValueId();
	}

private:
	template<typename TDimension>
	static constexpr size_t IndexOf()
	{
		static_assert((std::is_same_v<TDimension, TDimensions> + ... + 0) == 1,
			"this dimension is not (or twice) in the permutation domain");
		size_t Index = 0;
		(void)((std::is_same_v<TDimension, TDimensions> || (++Index, false)) || ...);
		return Index;
	}

	template<typename TFunction>
	void ForEachDimension(TFunction&& Function)
	{
		[&]<size_t... Indices>(std::index_sequence<Indices...>)
		{
			(Function.template operator()<TDimensions>(std::get<Indices>(Values)), ...);
		}
		(std::make_index_sequence<sizeof...(TDimensions)>());
	}

	std::tuple<typename TDimensions::Type...> Values;
};

using FShaderPermutationNone = TShaderPermutationDomain<>;

/** `class FUseBloomDim : SHADER_PERMUTATION_BOOL("USE_BLOOM");` */
#define SHADER_PERMUTATION_BOOL(InDefineName) \
public \
	FShaderPermutationBool \
	{ \
	public: \
		static constexpr const TCHAR* DefineName = TEXT(InDefineName); \
	}

/** Values 0..Count-1. */
#define SHADER_PERMUTATION_INT(InDefineName, Count) \
public \
	TShaderPermutationInt<int32, Count> \
	{ \
	public: \
		static constexpr const TCHAR* DefineName = TEXT(InDefineName); \
	}

/** Values Start..Start+Count-1. */
#define SHADER_PERMUTATION_RANGE_INT(InDefineName, Start, Count) \
public \
	TShaderPermutationInt<int32, Count, Start> \
	{ \
	public: \
		static constexpr const TCHAR* DefineName = TEXT(InDefineName); \
	}

#define SHADER_PERMUTATION_SPARSE_INT(InDefineName, ...) \
public \
	TShaderPermutationSparseInt<__VA_ARGS__> \
	{ \
	public: \
		static constexpr const TCHAR* DefineName = TEXT(InDefineName); \
	}

/** The enum class must end with MAX. */
#define SHADER_PERMUTATION_ENUM_CLASS(InDefineName, EnumName) \
public \
	TShaderPermutationInt<EnumName, static_cast<int32>(EnumName::MAX)> \
	{ \
	public: \
		static constexpr const TCHAR* DefineName = TEXT(InDefineName); \
	}
