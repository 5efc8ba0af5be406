// Integer operations that C++ leaves undefined and Direct3D defines: division by zero gives all ones, shift counts use
// their low five bits, overflow wraps. Source: D3D11 functional specification 22.11, 22.12.
#pragma once

#include "LanesMath.h"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

namespace Impl
{

DRYDOCK_LANES_INLINE int32_t Divide(int32_t A, int32_t B)
{
	return B == 0 ? -1 : B == -1 ? int32_t(0u - uint32_t(A)) : A / B;
}
DRYDOCK_LANES_INLINE uint32_t Divide(uint32_t A, uint32_t B)
{
	return B == 0 ? 0xFFFFFFFFu : A / B;
}
DRYDOCK_LANES_INLINE int32_t Remainder(int32_t A, int32_t B)
{
	return B == 0 ? -1 : B == -1 ? 0 : A % B;
}
DRYDOCK_LANES_INLINE uint32_t Remainder(uint32_t A, uint32_t B)
{
	return B == 0 ? 0xFFFFFFFFu : A % B;
}
DRYDOCK_LANES_INLINE int32_t Modulo(int32_t A, int32_t B)
{
	const int32_t R = Remainder(A, B);
	return B != 0 && R != 0 && (R < 0) != (B < 0) ? R + B : R;
}
DRYDOCK_LANES_INLINE uint32_t Modulo(uint32_t A, uint32_t B)
{
	return Remainder(A, B);
}

// No vector unit divides integers, but doubles: numbers of 32 bits and their quotients are exact in them. All of it
// wraps.

/** X + More, which is 0 or 0.5. */
template<int N>
DRYDOCK_LANES_INLINE TRaw<double, N> ToDoubles(TUint<N> X, double More)
{
	// The bits of 2^52 with X in the lowest ones are 2^52 + X.
	return TRaw<double, N>(__builtin_convertvector(X.V, TRaw<uint64_t, N>) | 0x4330000000000000) - (0x1p52 - More);
}
template<int N>
DRYDOCK_LANES_INLINE TRaw<double, N> InverseOf(TUint<N> X)
{
	return 1.0 / ToDoubles(X, 0.0);
}
DRYDOCK_LANES_INLINE double InverseOf(uint32_t X)
{
	return 1.0 / double(X);
}

/** X / Y, where Y is not 0. (X + 0.5) / Y is at least 0.5 / Y from every whole number, and its rounding errors are far
 * less; 0.5 less than that it is rounded to the whole number below, which is left in the low bits. */
template<int N, CScalar D>
DRYDOCK_LANES_INLINE TUint<N> Divide(TUint<N> X, D Y)
{
	if constexpr (CUniform<D>)
	{
		if (__builtin_constant_p(Y) && (Y & (Y - 1)) == 0)
		{
			return TUint<N>(X.V >> __builtin_ctz(Y | 0x80000000u));
		}
	}
	const TRaw<double, N> Bits = (ToDoubles(X, 0.5) * InverseOf(Y) - 0.5) + 0x1.8p52;
	return TUint<N>(__builtin_convertvector(TRaw<uint64_t, N>(Bits), TRaw<uint32_t, N>));
}

/** 0 - X where all bits of Negative are set, X where none is; of unsigned numbers. */
template<CScalar T>
DRYDOCK_LANES_INLINE T NegateIf(T Negative, T X)
{
	return (X ^ Negative) - Negative;
}
DRYDOCK_LANES_INLINE int32_t SignOf(int32_t X)
{
	return X >> 31;
}
template<int N>
DRYDOCK_LANES_INLINE TInt<N> SignOf(TInt<N> X)
{
	return TInt<N>(X.V >> 31);
}
template<int N, CScalar D>
DRYDOCK_LANES_INLINE TInt<N> Divide(TInt<N> X, D Y)
{
	const TUint<N> SignX = AsUint(SignOf(X));
	const auto SignY = AsUint(SignOf(Y));
	const TUint<N> Quotient = Divide(NegateIf(SignX, AsUint(X)), NegateIf(SignY, AsUint(Y)));
	return AsInt(NegateIf(SignX ^ TUint<N>(SignY), Quotient));
}

template<CLanes T, CScalar D>
DRYDOCK_LANES_INLINE T DivideLanes(T X, D Y)
{
	return Select(Y == D(0), T(-1), Divide(X, Y));
}
template<CLanes T, CScalar D>
DRYDOCK_LANES_INLINE T RemainderLanes(T X, D Y)
{
	return Select(Y == D(0), T(-1), X - Divide(X, Y) * T(Y));
}
template<CLanes T, CScalar D>
DRYDOCK_LANES_INLINE T ModuloLanes(T X, D Y)
{
	const T Rest = RemainderLanes(X, Y);
	if constexpr (std::is_same_v<T, decltype(AsUint(X))>)
	{
		return Rest;
	}
	else
	{
		return Select(Rest != T(0) && (Rest ^ T(Y)) < T(0), Rest + T(Y), Rest);
	}
}

} // namespace Impl

#define DRYDOCK_LANES_DIVISION(Name, Function) \
	template<CScalar A, CScalar B> \
	DRYDOCK_LANES_INLINE auto Name(A a, B b) \
	{ \
		using T = Meet<A, B>; \
		if constexpr (CUniform<T>) \
		{ \
			return Impl::Function(T(a), T(b)); \
		} \
		else \
		{ \
			return Impl::Function##Lanes(T(a), b); \
		} \
	} \
	template<typename A, typename B, int n> \
	DRYDOCK_LANES_INLINE auto Name(const TVec<A, n>& a, const TVec<B, n>& b) \
	{ \
		return Map([](const A& c, const B& d) { return Name(c, d); }, a, b); \
	}
DRYDOCK_LANES_DIVISION(IntDivide, Divide)
DRYDOCK_LANES_DIVISION(IntRemainder, Remainder)
DRYDOCK_LANES_DIVISION(IntModulo, Modulo)
#undef DRYDOCK_LANES_DIVISION

DRYDOCK_LANES_BINARY(Add, x + y)
DRYDOCK_LANES_BINARY(Subtract, x - y)
DRYDOCK_LANES_BINARY(Multiply, x* y)
DRYDOCK_LANES_UNARY(Negate, -x)

// The count may be signed or unsigned, whatever the base is.
#define DRYDOCK_LANES_SHIFT(Name, Operator) \
	template<CLanes T, CScalar C> \
	DRYDOCK_LANES_INLINE T Name(T Base, C Count) \
	{ \
		using FCount = std::conditional_t<std::is_same_v<C, int32_t> || std::is_same_v<C, uint32_t>, T, C>; \
		using FRaw = decltype(Base.V); \
		if constexpr (CUniform<C>) \
		{ \
			return T(FRaw(Base.V Operator int(Count & 31))); \
		} \
		else \
		{ \
			return T(FRaw(Base.V Operator(FRaw(FCount(Count).V) & 31))); \
		} \
	} \
	template<CUniform T, CScalar C> \
	DRYDOCK_LANES_INLINE auto Name(T Base, C Count) \
	{ \
		if constexpr (CUniform<C>) \
		{ \
			return First(Name(Widen(Base), Count)); \
		} \
		else \
		{ \
			return Name(Varying<int(sizeof(C) / 4), T>(Base), Count); \
		} \
	} \
	template<typename A, typename B, int n> \
	DRYDOCK_LANES_INLINE auto Name(const TVec<A, n>& a, const TVec<B, n>& b) \
	{ \
		return Map([](const A& c, const B& d) { return Name(c, d); }, a, b); \
	}
DRYDOCK_LANES_SHIFT(ShiftLeft, <<)
DRYDOCK_LANES_SHIFT(ShiftRight, >>) // arithmetic on int, logical on uint
#undef DRYDOCK_LANES_SHIFT

/** Count bits of Base from Offset; a uint is extended with zeros, an int with its top bit. Count 0 gives 0. */
template<CScalar T, CScalar O, CScalar C>
DRYDOCK_LANES_INLINE auto BitFieldExtract(T Base, O Offset, C Count)
{
	const auto Unused = Subtract(32u, ToUint(Count));
	const auto Field = ShiftRight(ShiftLeft(Base, Subtract(Unused, ToUint(Offset))), Unused);
	using R = std::remove_cvref_t<decltype(Field)>;
	return Select(Count == C(0), R(0), Field);
}
template<typename T, CScalar O, CScalar C, int n>
DRYDOCK_LANES_INLINE auto BitFieldExtract(const TVec<T, n>& V, O Offset, C Count)
{
	return Map([&](const T& x) { return BitFieldExtract(x, Offset, Count); }, V);
}

/** Base with Count bits from Offset replaced by the low bits of Inserted. */
template<CScalar T, CScalar I, CScalar O, CScalar C>
DRYDOCK_LANES_INLINE auto BitFieldInsert(T Base, I Inserted, O Offset, C Count)
{
	const auto Ones = ShiftRight(Select(Count == C(0), 0u, 0xFFFFFFFFu), Subtract(32u, ToUint(Count)));
	const auto Field = ShiftLeft(Ones, Offset);
	const auto Result = (ToUint(Base) & ~Field) | (ToUint(ShiftLeft(Inserted, Offset)) & Field);
	if constexpr (std::is_same_v<decltype(ToUint(Base)), T>)
	{
		return Result;
	}
	else
	{
		return AsInt(Result);
	}
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
