// The four lane types: TReal, TInt, TUint and TMask, on the vector extensions of GCC and Clang (no intrinsics header:
// it would cost a third of a shader's compile time).
#pragma once

#include <cstdint>
#include <type_traits>

#define DRYDOCK_LANES_INLINE inline __attribute__((always_inline))

// Each instruction set has its own namespace, so that the linker can never hand AVX-512 code to a machine without it.
#if defined(__AVX512F__) && defined(__AVX512DQ__) && defined(__AVX512BW__) && defined(__AVX512VL__)
#define DRYDOCK_LANES_SET SetV4
#define DRYDOCK_LANES_LEVEL 4
#elif defined(__AVX2__) && defined(__F16C__) && defined(__FMA__)
#define DRYDOCK_LANES_SET SetV3
#define DRYDOCK_LANES_LEVEL 3
#elif defined(__SSE4_1__)
#define DRYDOCK_LANES_SET SetV2
#define DRYDOCK_LANES_LEVEL 2
#else
#define DRYDOCK_LANES_SET SetPlain
#define DRYDOCK_LANES_LEVEL 1
#endif

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

template<typename Scalar, int N>
struct TPack
{
	typedef Scalar FVector __attribute__((vector_size(sizeof(Scalar) * N)));
};

/** Raw vector of N scalars. */
template<typename Scalar, int N>
using TRaw = typename TPack<Scalar, N>::FVector;

/** All lanes equal. Subtraction of +0 keeps every value as it is, -0 included; addition would not. */
template<typename Scalar, int N>
DRYDOCK_LANES_INLINE TRaw<Scalar, N> Broadcast(Scalar X)
{
	return X - TRaw<Scalar, N>{};
}

/** A bool per lane, kept as int32 -1 or 0. */
template<int N>
struct TMask
{
	using FRaw = TRaw<int32_t, N>;
	FRaw V;

	TMask() = default;
	DRYDOCK_LANES_INLINE explicit TMask(FRaw InV)
		: V(InV)
	{
	}
	DRYDOCK_LANES_INLINE TMask(bool b)
		: V(Broadcast<int32_t, N>(-int32_t(b)))
	{
	}
	DRYDOCK_LANES_INLINE bool operator[](int Lane) const { return V[Lane] != 0; }

	friend DRYDOCK_LANES_INLINE TMask operator&(TMask A, TMask B) { return TMask(A.V & B.V); }
	friend DRYDOCK_LANES_INLINE TMask operator|(TMask A, TMask B) { return TMask(A.V | B.V); }
	friend DRYDOCK_LANES_INLINE TMask operator^(TMask A, TMask B) { return TMask(A.V ^ B.V); }
	friend DRYDOCK_LANES_INLINE TMask operator&&(TMask A, TMask B) { return TMask(A.V & B.V); }
	friend DRYDOCK_LANES_INLINE TMask operator||(TMask A, TMask B) { return TMask(A.V | B.V); }
	friend DRYDOCK_LANES_INLINE TMask operator!(TMask A) { return TMask(~A.V); }
	friend DRYDOCK_LANES_INLINE TMask operator~(TMask A) { return TMask(~A.V); }
	friend DRYDOCK_LANES_INLINE TMask operator==(TMask A, TMask B) { return TMask(~(A.V ^ B.V)); }
	friend DRYDOCK_LANES_INLINE TMask operator!=(TMask A, TMask B) { return TMask(A.V ^ B.V); }
};

/** int32 per lane. Arithmetic wraps: it is done on unsigned vectors. */
template<int N>
struct TInt
{
	using FRaw = TRaw<int32_t, N>;
	using FUnsigned = TRaw<uint32_t, N>;
	FRaw V;

	TInt() = default;
	DRYDOCK_LANES_INLINE explicit TInt(FRaw InV)
		: V(InV)
	{
	}
	DRYDOCK_LANES_INLINE TInt(int32_t X)
		: V(Broadcast<int32_t, N>(X))
	{
	}
	DRYDOCK_LANES_INLINE int32_t operator[](int Lane) const { return V[Lane]; }

	friend DRYDOCK_LANES_INLINE TInt operator+(TInt A, TInt B) { return TInt(FRaw(FUnsigned(A.V) + FUnsigned(B.V))); }
	friend DRYDOCK_LANES_INLINE TInt operator-(TInt A, TInt B) { return TInt(FRaw(FUnsigned(A.V) - FUnsigned(B.V))); }
	friend DRYDOCK_LANES_INLINE TInt operator*(TInt A, TInt B) { return TInt(FRaw(FUnsigned(A.V) * FUnsigned(B.V))); }
	friend DRYDOCK_LANES_INLINE TInt operator-(TInt A) { return TInt(FRaw(-FUnsigned(A.V))); }
	friend DRYDOCK_LANES_INLINE TInt operator&(TInt A, TInt B) { return TInt(A.V & B.V); }
	friend DRYDOCK_LANES_INLINE TInt operator|(TInt A, TInt B) { return TInt(A.V | B.V); }
	friend DRYDOCK_LANES_INLINE TInt operator^(TInt A, TInt B) { return TInt(A.V ^ B.V); }
	friend DRYDOCK_LANES_INLINE TInt operator~(TInt A) { return TInt(~A.V); }
	friend DRYDOCK_LANES_INLINE TMask<N> operator<(TInt A, TInt B) { return TMask<N>(FRaw(A.V < B.V)); }
	friend DRYDOCK_LANES_INLINE TMask<N> operator>(TInt A, TInt B) { return TMask<N>(FRaw(A.V > B.V)); }
	friend DRYDOCK_LANES_INLINE TMask<N> operator<=(TInt A, TInt B) { return TMask<N>(FRaw(A.V <= B.V)); }
	friend DRYDOCK_LANES_INLINE TMask<N> operator>=(TInt A, TInt B) { return TMask<N>(FRaw(A.V >= B.V)); }
	friend DRYDOCK_LANES_INLINE TMask<N> operator==(TInt A, TInt B) { return TMask<N>(FRaw(A.V == B.V)); }
	friend DRYDOCK_LANES_INLINE TMask<N> operator!=(TInt A, TInt B) { return TMask<N>(FRaw(A.V != B.V)); }
	friend DRYDOCK_LANES_INLINE TInt Select(TMask<N> C, TInt A, TInt B) { return TInt(FRaw(C.V < 0 ? A.V : B.V)); }
};

/** uint32 per lane. */
template<int N>
struct TUint
{
	using FRaw = TRaw<uint32_t, N>;
	using FSigned = TRaw<int32_t, N>;
	FRaw V;

	TUint() = default;
	DRYDOCK_LANES_INLINE explicit TUint(FRaw InV)
		: V(InV)
	{
	}
	DRYDOCK_LANES_INLINE TUint(uint32_t X)
		: V(Broadcast<uint32_t, N>(X))
	{
	}
	DRYDOCK_LANES_INLINE uint32_t operator[](int Lane) const { return V[Lane]; }

	friend DRYDOCK_LANES_INLINE TUint operator+(TUint A, TUint B) { return TUint(A.V + B.V); }
	friend DRYDOCK_LANES_INLINE TUint operator-(TUint A, TUint B) { return TUint(A.V - B.V); }
	friend DRYDOCK_LANES_INLINE TUint operator*(TUint A, TUint B) { return TUint(A.V * B.V); }
	friend DRYDOCK_LANES_INLINE TUint operator-(TUint A) { return TUint(-A.V); }
	friend DRYDOCK_LANES_INLINE TUint operator&(TUint A, TUint B) { return TUint(A.V & B.V); }
	friend DRYDOCK_LANES_INLINE TUint operator|(TUint A, TUint B) { return TUint(A.V | B.V); }
	friend DRYDOCK_LANES_INLINE TUint operator^(TUint A, TUint B) { return TUint(A.V ^ B.V); }
	friend DRYDOCK_LANES_INLINE TUint operator~(TUint A) { return TUint(~A.V); }
	friend DRYDOCK_LANES_INLINE TMask<N> operator<(TUint A, TUint B) { return TMask<N>(FSigned(A.V < B.V)); }
	friend DRYDOCK_LANES_INLINE TMask<N> operator>(TUint A, TUint B) { return TMask<N>(FSigned(A.V > B.V)); }
	friend DRYDOCK_LANES_INLINE TMask<N> operator<=(TUint A, TUint B) { return TMask<N>(FSigned(A.V <= B.V)); }
	friend DRYDOCK_LANES_INLINE TMask<N> operator>=(TUint A, TUint B) { return TMask<N>(FSigned(A.V >= B.V)); }
	friend DRYDOCK_LANES_INLINE TMask<N> operator==(TUint A, TUint B) { return TMask<N>(FSigned(A.V == B.V)); }
	friend DRYDOCK_LANES_INLINE TMask<N> operator!=(TUint A, TUint B) { return TMask<N>(FSigned(A.V != B.V)); }
	friend DRYDOCK_LANES_INLINE TUint Select(TMask<N> C, TUint A, TUint B) { return TUint(FRaw(C.V < 0 ? A.V : B.V)); }
};

/** float or double per lane. */
template<typename Real, int N>
struct TReal
{
	static_assert(std::is_floating_point_v<Real>);
	using FRaw = TRaw<Real, N>;
	using FBits = TRaw<std::conditional_t<sizeof(Real) == 4, int32_t, int64_t>, N>; // what a comparison of FRaw gives
	FRaw V;

	TReal() = default;
	DRYDOCK_LANES_INLINE explicit TReal(FRaw InV)
		: V(InV)
	{
	}
	DRYDOCK_LANES_INLINE TReal(Real X)
		: V(Broadcast<Real, N>(X))
	{
	}
	DRYDOCK_LANES_INLINE Real operator[](int Lane) const { return V[Lane]; }

	static DRYDOCK_LANES_INLINE TMask<N> MakeMask(FBits B)
	{
		if constexpr (sizeof(Real) == 4)
		{
			return TMask<N>(B);
		}
		else
		{
			return TMask<N>(__builtin_convertvector(B, TRaw<int32_t, N>));
		}
	}

	friend DRYDOCK_LANES_INLINE TReal operator+(TReal A, TReal B) { return TReal(A.V + B.V); }
	friend DRYDOCK_LANES_INLINE TReal operator-(TReal A, TReal B) { return TReal(A.V - B.V); }
	friend DRYDOCK_LANES_INLINE TReal operator*(TReal A, TReal B) { return TReal(A.V * B.V); }
	friend DRYDOCK_LANES_INLINE TReal operator/(TReal A, TReal B) { return TReal(A.V / B.V); }
	friend DRYDOCK_LANES_INLINE TReal operator-(TReal A) { return TReal(-A.V); }
	friend DRYDOCK_LANES_INLINE TMask<N> operator<(TReal A, TReal B) { return MakeMask(A.V < B.V); }
	friend DRYDOCK_LANES_INLINE TMask<N> operator>(TReal A, TReal B) { return MakeMask(A.V > B.V); }
	friend DRYDOCK_LANES_INLINE TMask<N> operator<=(TReal A, TReal B) { return MakeMask(A.V <= B.V); }
	friend DRYDOCK_LANES_INLINE TMask<N> operator>=(TReal A, TReal B) { return MakeMask(A.V >= B.V); }
	friend DRYDOCK_LANES_INLINE TMask<N> operator==(TReal A, TReal B) { return MakeMask(A.V == B.V); }
	friend DRYDOCK_LANES_INLINE TMask<N> operator!=(TReal A, TReal B) { return MakeMask(A.V != B.V); }
	friend DRYDOCK_LANES_INLINE TReal Select(TMask<N> C, TReal A, TReal B)
	{
		if constexpr (sizeof(Real) == 4)
		{
			return TReal(FRaw(C.V < 0 ? A.V : B.V));
		}
		else
		{
			return TReal(FRaw(__builtin_convertvector(C.V, FBits) < 0 ? A.V : B.V));
		}
	}
};

template<int N>
DRYDOCK_LANES_INLINE TMask<N> Select(TMask<N> C, TMask<N> A, TMask<N> B)
{
	return TMask<N>((C.V & A.V) | (~C.V & B.V));
}

// The kinds of types.
template<typename T>
inline constexpr bool TIsLanes = false;
template<int N>
inline constexpr bool TIsLanes<TMask<N>> = true;
template<int N>
inline constexpr bool TIsLanes<TInt<N>> = true;
template<int N>
inline constexpr bool TIsLanes<TUint<N>> = true;
template<typename Real, int N>
inline constexpr bool TIsLanes<TReal<Real, N>> = true;
template<typename T>
concept CUniform = std::is_arithmetic_v<T>;
template<typename T>
concept CLanes = TIsLanes<T>;
template<typename T>
concept CScalar = CUniform<T> || CLanes<T>;

template<int N, typename T>
struct TVaryingOf
{
	using Type = T;
};
template<int N>
struct TVaryingOf<N, bool>
{
	using Type = TMask<N>;
};
template<int N>
struct TVaryingOf<N, int32_t>
{
	using Type = TInt<N>;
};
template<int N>
struct TVaryingOf<N, uint32_t>
{
	using Type = TUint<N>;
};
template<int N>
struct TVaryingOf<N, float>
{
	using Type = TReal<float, N>;
};
template<int N>
struct TVaryingOf<N, double>
{
	using Type = TReal<double, N>;
};

/** The varying type of a uniform scalar, TVec, TMat or TArray; a varying type is its own. */
template<int N, typename T>
using Varying = typename TVaryingOf<N, T>::Type;

/** X in every lane. */
template<int N, typename T>
DRYDOCK_LANES_INLINE Varying<N, T> Vary(const T& X)
{
	return Varying<N, T>(X);
}

// The type two operands meet in.
template<typename A, typename B>
struct TMeet;
template<typename A>
struct TMeet<A, A>
{
	using Type = A;
};
template<CLanes A, CUniform B>
struct TMeet<A, B>
{
	using Type = A;
};
template<CUniform A, CLanes B>
struct TMeet<A, B>
{
	using Type = B;
};
template<typename A, typename B>
using Meet = typename TMeet<A, B>::Type;

/** Mask and two uniform values. */
template<int N, CUniform S>
DRYDOCK_LANES_INLINE auto Select(TMask<N> C, S A, S B)
{
	return Select(C, Vary<N>(A), Vary<N>(B));
}

/** Uniform condition. */
template<CScalar A, CScalar B>
DRYDOCK_LANES_INLINE Meet<A, B> Select(bool C, A X, B Y)
{
	return C ? Meet<A, B>(X) : Meet<A, B>(Y);
}

/** Bit i is lane i. */
template<int N>
using TLaneBits = std::conditional_t<(N > 32), uint64_t, uint32_t>;

template<int N>
DRYDOCK_LANES_INLINE TLaneBits<N> MaskBits(TMask<N> M)
{
#if DRYDOCK_LANES_LEVEL >= 4
	if constexpr (N == 16)
	{
		return uint16_t(__builtin_ia32_cvtd2mask512(M.V));
	}
#endif
#if DRYDOCK_LANES_LEVEL >= 3
	if constexpr (N == 8)
	{
		return uint32_t(__builtin_ia32_movmskps256(TRaw<float, 8>(M.V)));
	}
#endif
#if DRYDOCK_LANES_LEVEL >= 2
	if constexpr (N == 4)
	{
		return uint32_t(__builtin_ia32_movmskps(TRaw<float, 4>(M.V)));
	}
#endif
	TLaneBits<N> Bits = 0;
	for (int Lane = 0; Lane < N; ++Lane)
	{
		Bits |= TLaneBits<N>(M.V[Lane] & 1) << Lane;
	}
	return Bits;
}

template<int N>
DRYDOCK_LANES_INLINE bool AnyLane(TMask<N> M)
{
	return MaskBits(M) != 0;
}
template<int N>
DRYDOCK_LANES_INLINE bool AllLanes(TMask<N> M)
{
	return MaskBits(M) == TLaneBits<N>(~uint64_t(0) >> (64 - N));
}
template<int N>
DRYDOCK_LANES_INLINE uint32_t CountLanes(TMask<N> M)
{
	return uint32_t(__builtin_popcountll(MaskBits(M)));
}
DRYDOCK_LANES_INLINE bool AnyLane(bool b)
{
	return b;
}
DRYDOCK_LANES_INLINE bool AllLanes(bool b)
{
	return b;
}
DRYDOCK_LANES_INLINE uint32_t CountLanes(bool b)
{
	return b;
}

constexpr int32_t LaneIndices[64] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22,
	23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51,
	52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63};

/** 0, 1, 2, ..: of a table, since at -O1 a loop over the lanes would stay a loop. */
template<int N>
DRYDOCK_LANES_INLINE TInt<N> LaneIndex()
{
	static_assert(N <= 64);
	TInt<N> Result;
	__builtin_memcpy(&Result, LaneIndices, sizeof(Result));
	return Result;
}

template<CLanes T>
DRYDOCK_LANES_INLINE auto First(T X)
{
	return X[0];
}
template<CUniform T>
DRYDOCK_LANES_INLINE T First(T X)
{
	return X;
}

/** Place = Value in the lanes of the mask; the other lanes keep what they hold. */
template<int N, CLanes T, CScalar S>
DRYDOCK_LANES_INLINE void Assign(TMask<N> M, T& Place, S Value)
{
	Place = Select(M, T(Value), Place);
}
template<CScalar T, CScalar S>
DRYDOCK_LANES_INLINE void Assign(bool b, T& Place, S Value)
{
	Place = b ? T(Value) : Place;
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
