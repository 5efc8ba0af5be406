// Memory that threads share: stores to groupshared arrays, and atomics on these, on buffers and on textures. Lanes act
// one after the other, in ascending order; where nobody sees the order, a buffer gets what a tile did to it at once.
// Included by generated code only.
#pragma once

#include "LanesResources.h"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** Lanes are at elements side by side, as neighbouring threads mostly are. */
template<int N>
DRYDOCK_LANES_INLINE bool IsRun(TInt<N> Index)
{
	return AllLanes(Index == TInt<N>(Index.V[0]) + LaneIndex<N>());
}

/** Elements[Index] of an array that all lanes share; the index per lane and in range. */
template<int N, CUniform T>
DRYDOCK_LANES_INLINE auto PickShared(const T* Elements, TInt<N> Index)
{
	decltype(PickElement(Elements, Index)) Result;
	if constexpr (sizeof(Result.V) == N * sizeof(T))
	{
		if (IsRun(Index))
		{
			__builtin_memcpy(&Result.V, Elements + Index.V[0], sizeof(Result.V));
			return Result;
		}
	}
	return PickElement(Elements, Index);
}

/** Elements[Index] = Value in the lanes of the mask, of an array that all lanes share. */
template<int N, CUniform T, CLanes V>
DRYDOCK_LANES_INLINE void PutShared(TMask<N> Mask, T* Elements, TInt<N> Index, V Value)
{
	if constexpr (sizeof(Value.V) == N * sizeof(T))
	{
		if (IsRun(Index))
		{
			V New;
			__builtin_memcpy(&New.V, Elements + Index.V[0], sizeof(New.V));
			Assign(Mask, New, Value);
			__builtin_memcpy(Elements + Index.V[0], &New.V, sizeof(New.V));
			return;
		}
	}
	for (int Lane = 0; Lane < N; ++Lane)
	{
		if (Mask[Lane])
		{
			Elements[Index.V[Lane]] = T(Value.V[Lane]);
		}
	}
}
template<int N, CUniform T, CLanes V>
DRYDOCK_LANES_INLINE void PutShared(TMask<N> Mask, T* Elements, int32_t Index, V Value)
{
	PutShared(Mask, Elements, TInt<N>(Index), Value);
}

/** f(Lane) for the lanes of the mask, in ascending order. */
template<int N, typename F>
DRYDOCK_LANES_INLINE void ForEachLane(TMask<N> Mask, F f)
{
	for (TLaneBits<N> Bits = MaskBits(Mask); Bits; Bits &= Bits - 1)
	{
		f(__builtin_ctzll(Bits));
	}
}

/** Some pack has a lane that runs. */
template<int N, int32_t Count>
DRYDOCK_LANES_INLINE bool AnyPack(const TMask<N> (&Packs)[Count])
{
	TMask<N> Any = Packs[0];
	for (int32_t i = 1; i < Count; ++i)
	{
		Any = Any | Packs[i];
	}
	return AnyLane(Any);
}

/** Addresses of the numbers that the lanes of an atomic operation change; null: outside, nothing happens and 0 is
 * returned. bOwn: no other thread of the machine can reach it meanwhile. */
template<typename T, int N>
struct TAtomicShared
{
	using FBits = T;
	static constexpr bool bOwn = true;
	T* Elements;
	TInt<N> Index;

	DRYDOCK_LANES_INLINE T* Find(int Lane) const { return Elements + Index.V[Lane]; }
};
template<int N, typename T>
DRYDOCK_LANES_INLINE auto AtomicShared(T* Elements, TInt<N> Index)
{
	using FBits = std::make_unsigned_t<T>;
	static_assert(sizeof(T) == 4 || sizeof(T) == 8);
	return TAtomicShared<FBits, N>{reinterpret_cast<FBits*>(Elements), Index};
}

/** T: uint32_t or uint64_t. */
template<typename T, int N>
struct TAtomicBytes
{
	using FBits = T;
	static constexpr bool bOwn = false;
	const FKernelBuffer& Buffer;
	TUint<N> Offset;

	DRYDOCK_LANES_INLINE TUint<N> GetWords() const { return TUint<N>(Offset.V >> 2); }
	DRYDOCK_LANES_INLINE T* Find(int Lane) const
	{
		const uint32_t At = Offset.V[Lane];
		const bool bInside = At < Buffer.SizeInBytes && Buffer.SizeInBytes - At >= sizeof(T);
		return bInside ? reinterpret_cast<T*>(Buffer.Data + At) : nullptr;
	}
};
template<typename T, int N>
DRYDOCK_LANES_INLINE TAtomicBytes<T, N> AtomicBytes(const FKernelBuffer& Buffer, TUint<N> Offset)
{
	return {Buffer, Offset};
}

/** Addresses in a typed buffer of 32-bit integers. */
template<int N>
struct TAtomicElement
{
	using FBits = uint32_t;
	static constexpr bool bOwn = false;
	const FKernelBuffer& Buffer;
	TUint<N> Index;

	DRYDOCK_LANES_INLINE TUint<N> GetWords() const { return Index; }
	DRYDOCK_LANES_INLINE uint32_t* Find(int Lane) const
	{
		const uint32_t At = Index.V[Lane];
		const bool bInside = HoldsWords(Buffer.Storage) && At < Buffer.SizeInBytes / 4;
		return bInside ? reinterpret_cast<uint32_t*>(Buffer.Data) + At : nullptr;
	}
};
template<int N>
DRYDOCK_LANES_INLINE TAtomicElement<N> AtomicElement(const FKernelBuffer& Buffer, TUint<N> Index)
{
	return {Buffer, Index};
}

/** Addresses in a texture of 32-bit integers; the last of three coordinates is depth or layer. */
template<int N, int Count>
struct TAtomicTexel
{
	using FBits = uint32_t;
	static constexpr bool bOwn = false;
	const FKernelTexture& Texture;
	const TVec<TInt<N>, Count> At;

	DRYDOCK_LANES_INLINE uint32_t* Find(int Lane) const
	{
		const FKernelMip& Mip = Texture.Mips[0];
		const int32_t X = At.E[0].V[Lane];
		const int32_t Y = At.E[1].V[Lane];
		const int32_t Z = Count == 3 ? At.E[Count - 1].V[Lane] : 0;
		const bool bInside = HoldsWords(Texture.Storage) && uint32_t(X) < uint32_t(Mip.SizeX) &&
							 uint32_t(Y) < uint32_t(Mip.SizeY) && uint32_t(Z) < uint32_t(Mip.SizeZ);
		return bInside ? reinterpret_cast<uint32_t*>(Mip.Data + Z * Mip.SlicePitch + int64_t(Y) * Mip.RowPitch) + X
					   : nullptr;
	}
};
template<int N, int Count>
DRYDOCK_LANES_INLINE TAtomicTexel<N, Count> AtomicTexel(const FKernelTexture& Texture, const TVec<TInt<N>, Count>& At)
{
	return {Texture, At};
}

// The operations, on numbers and on lanes of them. Nothing: a value that leaves what it is applied to.
struct FAtomicAdd
{
	static constexpr uint32_t Nothing = 0;
	template<typename T>
	DRYDOCK_LANES_INLINE static T Apply(T Old, T Value, T)
	{
		return Old + Value;
	}
};
struct FAtomicAnd
{
	static constexpr uint32_t Nothing = 0xFFFFFFFFu;
	template<typename T>
	DRYDOCK_LANES_INLINE static T Apply(T Old, T Value, T)
	{
		return Old & Value;
	}
};
struct FAtomicOr
{
	static constexpr uint32_t Nothing = 0;
	template<typename T>
	DRYDOCK_LANES_INLINE static T Apply(T Old, T Value, T)
	{
		return Old | Value;
	}
};
struct FAtomicXor
{
	static constexpr uint32_t Nothing = 0;
	template<typename T>
	DRYDOCK_LANES_INLINE static T Apply(T Old, T Value, T)
	{
		return Old ^ Value;
	}
};
struct FAtomicExchange
{
	template<typename T>
	static T Apply(T, T Value, T)
	{
		return Value;
	}
};
struct FAtomicCompareExchange
{
	template<typename T>
	static T Apply(T Old, T Value, T Compare)
	{
		return Old == Compare ? Value : Old;
	}
};
/** Minimum of numbers of 32 or 64 bits, with or without a sign. */
template<typename TNumber>
struct FAtomicMin
{
	using FBits = std::make_unsigned_t<TNumber>;
	static constexpr FBits Sign = std::is_signed_v<TNumber> ? FBits(FBits(1) << (8 * sizeof(FBits) - 1)) : 0;
	static constexpr FBits Nothing = FBits(~Sign);
	template<typename T>
	DRYDOCK_LANES_INLINE static T Apply(T Old, T Value, T)
	{
		return Select((Value ^ T(Sign)) < (Old ^ T(Sign)), Value, Old);
	}
};
template<typename TNumber>
struct FAtomicMax
{
	using FBits = std::make_unsigned_t<TNumber>;
	static constexpr FBits Sign = FAtomicMin<TNumber>::Sign;
	static constexpr FBits Nothing = Sign;
	template<typename T>
	DRYDOCK_LANES_INLINE static T Apply(T Old, T Value, T)
	{
		return Select((Value ^ T(Sign)) > (Old ^ T(Sign)), Value, Old);
	}
};

/** Returns the previous value. */
template<typename TOperation, typename T>
DRYDOCK_LANES_INLINE T ApplyAtomic(T* Place, T Value, T Compare)
{
	if constexpr (std::is_same_v<TOperation, FAtomicAdd>)
	{
		return __atomic_fetch_add(Place, Value, __ATOMIC_RELAXED);
	}
	T Old = __atomic_load_n(Place, __ATOMIC_RELAXED);
	while (!__atomic_compare_exchange_n(
		Place, &Old, TOperation::Apply(Old, Value, Compare), true, __ATOMIC_RELAXED, __ATOMIC_RELAXED))
	{
	}
	return Old;
}

/** Returns the previous values, by lane. */
template<typename TOperation, int N, typename TPlaces, CLanes V>
DRYDOCK_LANES_INLINE V Atomic(TMask<N> Mask, const TPlaces& Places, V Value, V Compare)
{
	using FBits = typename TPlaces::FBits;
	static_assert(sizeof(V) == N * sizeof(FBits));
	V Result(FBits(0));
	ForEachLane(Mask,
		[&](int Lane)
		{
			FBits* const Place = Places.Find(Lane);
			if constexpr (TPlaces::bOwn)
			{
				const FBits Old = *Place;
				*Place = TOperation::Apply(Old, FBits(Value.V[Lane]), FBits(Compare.V[Lane]));
				Result.V[Lane] = Old;
			}
			else if (Place)
			{
				Result.V[Lane] = ApplyAtomic<TOperation>(Place, FBits(Value.V[Lane]), FBits(Compare.V[Lane]));
			}
		});
	return Result;
}

/** Collects a tile's atomics of one kind on a buffer that they alone change and whose old values nobody reads; any
 * order gives one result. The buffer's first words get the result when the tile is done, once and not for each thread,
 * and threads of the machine do not wait for each other's. */
template<typename TOperation, int N>
class TTileAtomics
{
public:
	DRYDOCK_LANES_INLINE TTileAtomics(const FKernelBuffer& Buffer, bool bIntegers)
		: Memory(reinterpret_cast<uint32_t*>(Buffer.Data))
		, NumWords(!bIntegers                          ? 0
				   : Buffer.SizeInBytes / 4 < Capacity ? Buffer.SizeInBytes / 4
													   : Capacity)
	{
		for (uint32_t i = 0; i < NumWords; i += N)
		{
			const TUint<N> Nothing(TOperation::Nothing);
			__builtin_memcpy(Words + i, &Nothing.V, sizeof(Nothing.V));
		}
	}

	template<typename TPlaces>
	DRYDOCK_LANES_INLINE void Apply(TMask<N> Mask, const TPlaces& Places, TUint<N> Value)
	{
		const TUint<N> Index = Places.GetWords();
		if (IsRun(AsInt(Index)) && NumWords >= N && Index.V[0] <= NumWords - N)
		{
			TUint<N> New;
			__builtin_memcpy(&New.V, Words + Index.V[0], sizeof(New.V));
			Assign(Mask, New, TOperation::Apply(New, Value, Value));
			__builtin_memcpy(Words + Index.V[0], &New.V, sizeof(New.V));
			return;
		}
		ForEachLane(Mask,
			[&](int Lane)
			{
				const uint32_t i = Index.V[Lane];
				const uint32_t Number = Value.V[Lane];
				if (i < NumWords)
				{
					Words[i] = TOperation::Apply(Words[i], Number, Number);
				}
				else if (uint32_t* const Place = Places.Find(Lane))
				{
					ApplyAtomic<TOperation>(Place, Number, Number);
				}
			});
	}

	DRYDOCK_LANES_INLINE void Finish() const
	{
		for (uint32_t i = 0; i < NumWords; ++i)
		{
			if (Words[i] != TOperation::Nothing)
			{
				ApplyAtomic<TOperation>(Memory + i, Words[i], Words[i]);
			}
		}
	}

private:
	static constexpr uint32_t Capacity = 1024;
	uint32_t* Memory;
	uint32_t NumWords;
	uint32_t Words[Capacity];
};

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
