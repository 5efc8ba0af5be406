// Integers of 64 bits and doubles in the kernels of a float, and 16-bit values: the lane types and functions that only
// shaders with such types need. A 16-bit value is computed in the lanes of its 32-bit relative and made narrow again
// after each operation: integers wrap, a float16_t is rounded to nearest even. Included by generated code only, where
// the shader uses them. Source: D3D11 functional specification 3.1 and 22.11; IEEE 754 binary16.
#pragma once

#include "Lanes.h"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** int64 or uint64 per lane. Arithmetic wraps: it is done on unsigned vectors. */
template<typename Scalar, int N>
struct TInt64
{
	using FRaw = TRaw<Scalar, N>;
	using FUnsigned = TRaw<uint64_t, N>;
	using FBits = TRaw<int64_t, N>;
	FRaw V;

	TInt64() = default;
	DRYDOCK_LANES_INLINE explicit TInt64(FRaw InV)
		: V(InV)
	{
	}
	DRYDOCK_LANES_INLINE TInt64(Scalar X)
		: V(Broadcast<Scalar, N>(X))
	{
	}
	DRYDOCK_LANES_INLINE Scalar operator[](int Lane) const { return V[Lane]; }

	static DRYDOCK_LANES_INLINE TMask<N> MakeMask(FBits B)
	{
		return TMask<N>(__builtin_convertvector(B, TRaw<int32_t, N>));
	}

	friend DRYDOCK_LANES_INLINE TInt64 operator+(TInt64 A, TInt64 B)
	{
		return TInt64(FRaw(FUnsigned(A.V) + FUnsigned(B.V)));
	}
	friend DRYDOCK_LANES_INLINE TInt64 operator-(TInt64 A, TInt64 B)
	{
		return TInt64(FRaw(FUnsigned(A.V) - FUnsigned(B.V)));
	}
	friend DRYDOCK_LANES_INLINE TInt64 operator*(TInt64 A, TInt64 B)
	{
		return TInt64(FRaw(FUnsigned(A.V) * FUnsigned(B.V)));
	}
	friend DRYDOCK_LANES_INLINE TInt64 operator-(TInt64 A) { return TInt64(FRaw(-FUnsigned(A.V))); }
	friend DRYDOCK_LANES_INLINE TInt64 operator&(TInt64 A, TInt64 B) { return TInt64(A.V & B.V); }
	friend DRYDOCK_LANES_INLINE TInt64 operator|(TInt64 A, TInt64 B) { return TInt64(A.V | B.V); }
	friend DRYDOCK_LANES_INLINE TInt64 operator^(TInt64 A, TInt64 B) { return TInt64(A.V ^ B.V); }
	friend DRYDOCK_LANES_INLINE TInt64 operator~(TInt64 A) { return TInt64(~A.V); }
	friend DRYDOCK_LANES_INLINE TMask<N> operator<(TInt64 A, TInt64 B) { return MakeMask(FBits(A.V < B.V)); }
	friend DRYDOCK_LANES_INLINE TMask<N> operator>(TInt64 A, TInt64 B) { return MakeMask(FBits(A.V > B.V)); }
	friend DRYDOCK_LANES_INLINE TMask<N> operator<=(TInt64 A, TInt64 B) { return MakeMask(FBits(A.V <= B.V)); }
	friend DRYDOCK_LANES_INLINE TMask<N> operator>=(TInt64 A, TInt64 B) { return MakeMask(FBits(A.V >= B.V)); }
	friend DRYDOCK_LANES_INLINE TMask<N> operator==(TInt64 A, TInt64 B) { return MakeMask(FBits(A.V == B.V)); }
	friend DRYDOCK_LANES_INLINE TMask<N> operator!=(TInt64 A, TInt64 B) { return MakeMask(FBits(A.V != B.V)); }
	friend DRYDOCK_LANES_INLINE TInt64 Select(TMask<N> C, TInt64 A, TInt64 B)
	{
		return TInt64(FRaw(__builtin_convertvector(C.V, FBits) < 0 ? A.V : B.V));
	}
};
template<int N>
using TLong = TInt64<int64_t, N>;
template<int N>
using TUlong = TInt64<uint64_t, N>;

template<typename Scalar, int N>
inline constexpr bool TIsLanes<TInt64<Scalar, N>> = true;
template<int N>
struct TVaryingOf<N, int64_t>
{
	using Type = TLong<N>;
};
template<int N>
struct TVaryingOf<N, uint64_t>
{
	using Type = TUlong<N>;
};

template<typename T>
concept CWide = CUniform<T> &&(std::is_same_v<T, int64_t> || std::is_same_v<T, uint64_t>);

/** f of each lane, in lanes of Scalar. */
template<typename Scalar, int N, typename F>
DRYDOCK_LANES_INLINE Varying<N, Scalar> MapLanes(F f)
{
	Varying<N, Scalar> Result;
	for (int Lane = 0; Lane < N; ++Lane)
	{
		Result.V[Lane] = f(Lane);
	}
	return Result;
}

// Functions of uniforms, and the same of lanes, one after the other where vector units have no such operation.
#define DRYDOCK_LANES_WIDE_UNARY(Name, Expression) \
	template<CWide T> \
	DRYDOCK_LANES_INLINE T Name(T x) \
	{ \
		return Expression; \
	} \
	template<typename T, int N> \
	DRYDOCK_LANES_INLINE TInt64<T, N> Name(TInt64<T, N> a) \
	{ \
		return MapLanes<T, N>([&](int Lane) { return Name(T(a.V[Lane])); }); \
	}
#define DRYDOCK_LANES_WIDE_BINARY(Name, Expression) \
	template<CWide T> \
	DRYDOCK_LANES_INLINE T Name(T x, T y) \
	{ \
		return Expression; \
	} \
	template<typename T, int N> \
	DRYDOCK_LANES_INLINE TInt64<T, N> Name(TInt64<T, N> a, TInt64<T, N> b) \
	{ \
		return MapLanes<T, N>([&](int Lane) { return Name(T(a.V[Lane]), T(b.V[Lane])); }); \
	}

namespace Impl
{

template<CWide T>
DRYDOCK_LANES_INLINE T ReverseBits(T X)
{
	uint64_t V = uint64_t(X);
	V = ((V >> 1) & 0x5555555555555555u) | ((V & 0x5555555555555555u) << 1);
	V = ((V >> 2) & 0x3333333333333333u) | ((V & 0x3333333333333333u) << 2);
	V = ((V >> 4) & 0x0F0F0F0F0F0F0F0Fu) | ((V & 0x0F0F0F0F0F0F0F0Fu) << 4);
	return T(__builtin_bswap64(V));
}
/** As FindMsb of 32 bits. */
template<CWide T>
DRYDOCK_LANES_INLINE T HighestBit(T X)
{
	const uint64_t V = uint64_t(X < T(0) ? T(~X) : X);
	return V ? T(63 - __builtin_clzll(V)) : T(-1);
}

} // namespace Impl

// Division by zero gives all ones, overflow wraps, shifts use the low six bits of their count.
DRYDOCK_LANES_WIDE_BINARY(IntDivide, y == T(0) ? T(-1) : std::is_signed_v<T> && y == T(-1) ? T(0) - x : x / y)
DRYDOCK_LANES_WIDE_BINARY(IntRemainder, y == T(0) ? T(-1) : std::is_signed_v<T> && y == T(-1) ? T(0) : x % y)
DRYDOCK_LANES_WIDE_BINARY(ShiftLeft, T(uint64_t(x) << (y & 63)))
DRYDOCK_LANES_WIDE_BINARY(ShiftRight, x >> (y & 63))
DRYDOCK_LANES_WIDE_BINARY(Min, x < y ? x : y)
DRYDOCK_LANES_WIDE_BINARY(Max, x > y ? x : y)
DRYDOCK_LANES_WIDE_UNARY(Abs, x < T(0) ? T(0) - x : x)
DRYDOCK_LANES_WIDE_UNARY(Sign, T(x > T(0)) - T(x < T(0)))
DRYDOCK_LANES_WIDE_UNARY(BitCount, T(__builtin_popcountll(uint64_t(x))))
DRYDOCK_LANES_WIDE_UNARY(BitReverse, Impl::ReverseBits(x))
DRYDOCK_LANES_WIDE_UNARY(FindLsb, x ? T(__builtin_ctzll(uint64_t(x))) : T(-1))
DRYDOCK_LANES_WIDE_UNARY(FindMsb, Impl::HighestBit(x))
template<typename T, int N>
DRYDOCK_LANES_INLINE TInt64<T, N> ShiftLeft(TInt64<T, N> X, T Count)
{
	return ShiftLeft(X, TInt64<T, N>(Count));
}
template<typename T, int N>
DRYDOCK_LANES_INLINE TInt64<T, N> ShiftRight(TInt64<T, N> X, T Count)
{
	return ShiftRight(X, TInt64<T, N>(Count));
}
#undef DRYDOCK_LANES_WIDE_UNARY
#undef DRYDOCK_LANES_WIDE_BINARY

template<CWide T>
DRYDOCK_LANES_INLINE T Clamp(T X, T Low, T High)
{
	return Min(Max(X, Low), High);
}
template<typename T, int N>
DRYDOCK_LANES_INLINE TInt64<T, N> Clamp(TInt64<T, N> X, TInt64<T, N> Low, TInt64<T, N> High)
{
	return Min(Max(X, Low), High);
}

/** Integers of any width: a signed one is extended with its sign, an unsigned one with zeros, a longer one is cut. */
template<typename To, CUniform T>
DRYDOCK_LANES_INLINE To Resize(T X)
{
	return To(X);
}
template<typename To, CLanes T>
DRYDOCK_LANES_INLINE auto Resize(T X)
{
	constexpr int N = sizeof(X.V) / sizeof(X.V[0]);
	return Varying<N, To>(__builtin_convertvector(X.V, TRaw<To, N>));
}
template<CScalar T>
DRYDOCK_LANES_INLINE auto AsLong(T X)
{
	return Resize<int64_t>(X);
}
template<CScalar T>
DRYDOCK_LANES_INLINE auto AsUlong(T X)
{
	return Resize<uint64_t>(X);
}
template<typename T, int N>
DRYDOCK_LANES_INLINE TUint<N> AsUint(TInt64<T, N> X)
{
	return Resize<uint32_t>(X);
}

/** The low 16 bits of an integer, extended by its own kind of sign. */
template<CScalar T>
DRYDOCK_LANES_INLINE auto WrapShort(T X)
{
	return ShiftRight(ShiftLeft(AsInt(X), 16), 16);
}
template<CScalar T>
DRYDOCK_LANES_INLINE auto WrapUshort(T X)
{
	return AsUint(X) & 0xFFFFu;
}

namespace Impl
{

/** Direct3D's rule: truncates, saturates, NaN is 0. */
template<typename To, typename From>
DRYDOCK_LANES_INLINE To ConvertScalar(From X)
{
	if constexpr (std::is_floating_point_v<To> || !std::is_floating_point_v<From>)
	{
		return To(X);
	}
	else
	{
		constexpr From Above = From(uint64_t(1) << (8 * sizeof(To) - 2)) * (std::is_signed_v<To> ? From(2) : From(4));
		constexpr To Highest = To(~uint64_t(0) >> (64 - 8 * sizeof(To) + std::is_signed_v<To>));
		constexpr From Lowest = std::is_signed_v<To> ? -Above : From(0);
		return X != X ? To(0) : X >= Above ? Highest : X <= Lowest ? To(Lowest) : To(X);
	}
}

template<typename T>
struct TStored
{
	using Type = T;
};
template<>
struct TStored<int16_t>
{
	using Type = int32_t;
};
template<>
struct TStored<uint16_t>
{
	using Type = uint32_t;
};
/** The type in which lanes hold a number of memory's type. */
template<typename T>
using Stored = typename TStored<T>::Type;

} // namespace Impl

/** To: float, double or an integer of any width, which gives its name to the rule; 16 bits are held in 32. */
template<typename To, CUniform From>
DRYDOCK_LANES_INLINE Impl::Stored<To> ConvertTo(From X)
{
	return Impl::ConvertScalar<To>(X);
}
template<typename To, CLanes From>
DRYDOCK_LANES_INLINE auto ConvertTo(From X)
{
	constexpr int N = sizeof(X.V) / sizeof(X.V[0]);
	using FScalar = std::remove_cvref_t<decltype(X.V[0])>;
	return MapLanes<Impl::Stored<To>, N>([&](int Lane) { return Impl::ConvertScalar<To>(FScalar(X.V[Lane])); });
}

/** Runs f, arithmetic of doubles, with denormals, which Direct3D keeps in doubles: a kernel of floats flushes them. f
 * takes its numbers by reference, and the empty statements may change them: so nothing of it moves past these. */
template<typename Real, typename F>
DRYDOCK_LANES_INLINE auto KeepDenormals(const F& f)
{
	constexpr uint32_t FlushBits = sizeof(Real) == 4 ? 0x8040 : 0; // MXCSR: flush to zero, denormals are zero
	const uint32_t Mode = __builtin_ia32_stmxcsr();
	__builtin_ia32_ldmxcsr(Mode & ~FlushBits);
	asm volatile("" : : "r"(&f) : "memory");
	auto Result = f();
	asm volatile("" : : "r"(&Result) : "memory");
	__builtin_ia32_ldmxcsr(Mode);
	return Result;
}

template<int N>
DRYDOCK_LANES_INLINE TUlong<N> DoubleBits(TReal<double, N> X)
{
	return TUlong<N>(TRaw<uint64_t, N>(X.V));
}
DRYDOCK_LANES_INLINE uint64_t DoubleBits(double X)
{
	return __builtin_bit_cast(uint64_t, X);
}
template<int N>
DRYDOCK_LANES_INLINE TReal<double, N> DoubleOfBits(TUlong<N> X)
{
	return TReal<double, N>(TRaw<double, N>(X.V));
}
DRYDOCK_LANES_INLINE double DoubleOfBits(uint64_t X)
{
	return __builtin_bit_cast(double, X);
}

/** The nearest float16_t, to even where two are as near; overflow from 65520 is infinity, denormals are kept, each NaN
 * becomes 0x7E00. */
template<typename Real, int N>
DRYDOCK_LANES_INLINE TReal<Real, N> RoundHalf(TReal<Real, N> X)
{
	using FBits = typename TReal<Real, N>::FBits;
	using FBit = std::conditional_t<sizeof(Real) == 4, int32_t, int64_t>;
	constexpr int Mantissa = sizeof(Real) == 4 ? 23 : 52;
	constexpr int Dropped = Mantissa - 10;
	constexpr FBit Low = (FBit(1) << Dropped) - 1;
	constexpr FBit Infinity = __builtin_bit_cast(FBit, Real(__builtin_inf()));
	constexpr Real Unit = sizeof(Real) == 4 ? Real(0.5) : Real(268435456); // the last bit of a sum with it is 2^-24
	const FBits Sign = FBits(X.V) & (FBit(1) << (8 * sizeof(Real) - 1));
	const FBits Magnitude = FBits(X.V) ^ Sign;
	const FBits Normal = (Magnitude + (Low >> 1) + ((Magnitude >> Dropped) & 1)) & ~Low;
	const FBits Small = FBits(TRaw<Real, N>((TRaw<Real, N>(Magnitude) + Unit) - Unit));
	FBits Result = Magnitude < __builtin_bit_cast(FBit, Real(0x1p-14)) ? Small : Normal;
	Result = Magnitude >= __builtin_bit_cast(FBit, Real(65520)) ? (FBits{} + Infinity) : Result;
	Result = Magnitude > Infinity ? (FBits{} + (Infinity | FBit(1) << (Mantissa - 1))) : (Result | Sign);
	return TReal<Real, N>(TRaw<Real, N>(Result));
}
template<CUniform Real>
DRYDOCK_LANES_INLINE Real RoundHalf(Real X)
{
	return RoundHalf(TReal<Real, 16 / sizeof(Real)>(X))[0];
}

/** The 16 bits of a value that is a float16_t. */
template<typename Real, int N>
DRYDOCK_LANES_INLINE TUint<N> HalfBits(TReal<Real, N> X)
{
	return Convert::FloatToHalf(TReal<float, N>(__builtin_convertvector(X.V, TRaw<float, N>)));
}
template<CUniform Real>
DRYDOCK_LANES_INLINE uint32_t HalfBits(Real X)
{
	return HalfBits(TReal<Real, 4>(X))[0];
}
template<typename Real, int N>
DRYDOCK_LANES_INLINE TReal<Real, N> HalfOfBits(TUint<N> Bits)
{
	return TReal<Real, N>(__builtin_convertvector(Convert::HalfToFloat(Bits).V, TRaw<Real, N>));
}
template<typename Real>
DRYDOCK_LANES_INLINE Real HalfOfBits(uint32_t Bits)
{
	return HalfOfBits<Real>(TUint<4>(Bits))[0];
}

/** A number of memory's type T at a byte offset; outside of the buffer 0. */
template<typename T>
DRYDOCK_LANES_INLINE Impl::Stored<T> LoadBufferOf(const FKernelBuffer& Buffer, uint32_t Offset)
{
	T Value = 0;
	if (Offset < Buffer.SizeInBytes && Buffer.SizeInBytes - Offset >= sizeof(T))
	{
		__builtin_memcpy(&Value, Buffer.Data + Offset, sizeof(T));
	}
	return Value;
}
template<typename T, int N>
DRYDOCK_LANES_INLINE auto LoadBufferOf(const FKernelBuffer& Buffer, TUint<N> Offset)
{
	return MapLanes<Impl::Stored<T>, N>([&](int Lane) { return LoadBufferOf<T>(Buffer, uint32_t(Offset.V[Lane])); });
}
/** As StoreBufferUint. */
template<typename T, int N, CLanes V>
DRYDOCK_LANES_INLINE void StoreBufferOf(TMask<N> Mask, const FKernelBuffer& Buffer, TUint<N> Offset, V Value)
{
	for (int Lane = 0; Lane < N; ++Lane)
	{
		const uint32_t At = Offset.V[Lane];
		if (Mask[Lane] && At < Buffer.SizeInBytes && Buffer.SizeInBytes - At >= sizeof(T))
		{
			const T Bits = T(Value.V[Lane]);
			__builtin_memcpy(Buffer.Data + At, &Bits, sizeof(T));
		}
	}
}

/** A constant of memory's type T. */
template<typename T>
DRYDOCK_LANES_INLINE Impl::Stored<T> ReadConstantOf(const uint8_t* Data, uint32_t Offset)
{
	T Value;
	__builtin_memcpy(&Value, Data + Offset, sizeof(T));
	return Value;
}
template<typename T, int N>
DRYDOCK_LANES_INLINE auto ReadConstantOf(const uint8_t* Data, TInt<N> Offset)
{
	return MapLanes<Impl::Stored<T>, N>([&](int Lane) { return ReadConstantOf<T>(Data, uint32_t(Offset.V[Lane])); });
}

/** Elements[Index], the index per lane and in range. */
template<int N, CWide T>
DRYDOCK_LANES_INLINE auto PickElement(const T* Elements, TInt<N> Index)
{
	return MapLanes<T, N>([&](int Lane) { return Elements[Index.V[Lane]]; });
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
