// Conversions between lane types with Direct3D's rules: float to integer truncates, saturates and maps NaN to 0;
// integer to float rounds to nearest even. Bit casts, half packing. Source: D3D11 functional specification 3.2.2.
#pragma once

#include "LanesVectors.h"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** Lanes that stand for a uniform value when it goes through lane code, so that uniform and varying agree bit for bit.
 */
template<typename T>
struct TWide
{
	using Type = T;
};
template<>
struct TWide<float>
{
	using Type = TReal<float, 4>;
};
template<>
struct TWide<double>
{
	using Type = TReal<double, 2>;
};
template<>
struct TWide<int32_t>
{
	using Type = TInt<4>;
};
template<>
struct TWide<uint32_t>
{
	using Type = TUint<4>;
};
template<>
struct TWide<bool>
{
	using Type = TMask<4>;
};
template<typename T>
DRYDOCK_LANES_INLINE typename TWide<T>::Type Widen(T X)
{
	return typename TWide<T>::Type(X);
}

namespace Convert
{

template<typename Real, int N>
DRYDOCK_LANES_INLINE TReal<Real, N> Real_(TInt<N> X)
{
	return TReal<Real, N>(__builtin_convertvector(X.V, TRaw<Real, N>));
}

/** Both halves are exact in float, so their sum is rounded once. */
template<typename Real, int N>
DRYDOCK_LANES_INLINE TReal<Real, N> Real_(TUint<N> X)
{
	using FSigned = TRaw<int32_t, N>;
	const TRaw<Real, N> High = __builtin_convertvector(FSigned(X.V >> 16), TRaw<Real, N>);
	const TRaw<Real, N> Low = __builtin_convertvector(FSigned(X.V & 0xFFFFu), TRaw<Real, N>);
	return TReal<Real, N>(High * Real(65536) + Low);
}

template<typename Real, int N>
DRYDOCK_LANES_INLINE TReal<Real, N> Real_(TMask<N> X)
{
	return Select(X, TReal<Real, N>(Real(1)), TReal<Real, N>(Real(0)));
}

template<typename Real, int N>
DRYDOCK_LANES_INLINE TInt<N> Int(TReal<Real, N> X)
{
	const TReal<Real, N> Limit = Real(2147483648.0);
	const TMask<N> High = X >= Limit;
	const TMask<N> Low = X < -Limit;
	const TMask<N> Fits = X == X && !High && !Low;
	const TReal<Real, N> Safe = Select(Fits, X, TReal<Real, N>(Real(0)));
	const TInt<N> Whole(__builtin_convertvector(Safe.V, TRaw<int32_t, N>));
	return Select(High, TInt<N>(0x7FFFFFFF), Select(Low, TInt<N>(-0x7FFFFFFF - 1), Whole));
}

template<typename Real, int N>
DRYDOCK_LANES_INLINE TUint<N> Uint(TReal<Real, N> X)
{
	const TReal<Real, N> Half = Real(2147483648.0);
	const TMask<N> Upper = X >= Half;
	const TMask<N> Over = X >= TReal<Real, N>(Real(4294967296.0));
	const TReal<Real, N> Positive = Select(X > TReal<Real, N>(Real(0)) && !Over, X, TReal<Real, N>(Real(0)));
	const TReal<Real, N> Safe = Select(Upper && !Over, Positive - Half, Positive);
	const TRaw<uint32_t, N> Whole = TRaw<uint32_t, N>(__builtin_convertvector(Safe.V, TRaw<int32_t, N>));
	const TUint<N> Result = Select(Upper, TUint<N>(Whole) + TUint<N>(0x80000000u), TUint<N>(Whole));
	return Select(Over, TUint<N>(0xFFFFFFFFu), Result);
}

/** Exact for every half: a denormal one is its mantissa times 2^-24, computed without denormal floats. */
template<int N>
DRYDOCK_LANES_INLINE TReal<float, N> HalfToFloat(TUint<N> Bits)
{
	using FFloat = TRaw<float, N>;
	using FInt = TRaw<int32_t, N>;
	const FInt Half = FInt(Bits.V);
	const FInt Sign = (Half & 0x8000) << 16;
	const FInt Exponent = Half & 0x7C00;
	const FInt Mantissa = Half & 0x03FF;
	const FInt Normal = ((Half & 0x7FFF) << 13) + (112 << 23);
	const FInt Special = (Mantissa << 13) | 0x7F800000 | ((Mantissa != 0) & 0x00400000); // a NaN becomes quiet
	const FInt Small = FInt(FFloat(__builtin_convertvector(Mantissa, FFloat) * 0x1p-24f));
	FInt Result = Exponent == 0 ? Small : Normal;
	Result = Exponent == 0x7C00 ? Special : Result;
	return TReal<float, N>(FFloat(Result | Sign));
}

/** Round to nearest even; overflow from 65520 is infinity; a NaN keeps the top of its payload and becomes quiet. */
template<int N>
DRYDOCK_LANES_INLINE TUint<N> FloatToHalf(TReal<float, N> X)
{
	using FFloat = TRaw<float, N>;
	using FInt = TRaw<int32_t, N>;
	const FInt Bits = FInt(X.V);
	const FInt Sign = (Bits >> 16) & 0x8000;
	const FInt Magnitude = Bits & 0x7FFFFFFF;
	const FInt Normal = (Magnitude - (112 << 23) + 0x0FFF + ((Magnitude >> 13) & 1)) >> 13;
	// Adding 0.5 lines the unit of a denormal half (2^-24) up with the last bit of the float and rounds there.
	const FInt Small = FInt(FFloat(FFloat(Magnitude) + 0.5f)) - FInt(FFloat{} + 0.5f);
	const FInt Nan = ((Magnitude >> 13) & 0x03FF) | 0x7E00;
	FInt Half = Magnitude < (113 << 23) ? Small : Normal;
	Half = Magnitude >= 0x477FF000 ? (FInt{} + 0x7C00) : Half;
	Half = Magnitude > 0x7F800000 ? Nan : Half;
	return TUint<N>(TRaw<uint32_t, N>(Half | Sign));
}

} // namespace Convert

template<typename Real, CScalar T>
DRYDOCK_LANES_INLINE auto ToReal(T X)
{
	if constexpr (std::is_same_v<T, bool>)
	{
		return X ? Real(1) : Real(0);
	}
	else if constexpr (CUniform<T>)
	{
		return Real(X);
	}
	else if constexpr (std::is_floating_point_v<std::remove_cvref_t<decltype(X.V[0])>>)
	{
		return X;
	}
	else
	{
		return Convert::Real_<Real>(X);
	}
}

template<CUniform T>
DRYDOCK_LANES_INLINE int32_t ToInt(T X)
{
	if constexpr (std::is_floating_point_v<T>)
	{
		return Convert::Int(Widen(X))[0];
	}
	else
	{
		return int32_t(X);
	}
}
template<typename Real, int N>
DRYDOCK_LANES_INLINE TInt<N> ToInt(TReal<Real, N> X)
{
	return Convert::Int(X);
}
template<int N>
DRYDOCK_LANES_INLINE TInt<N> ToInt(TInt<N> X)
{
	return X;
}
template<int N>
DRYDOCK_LANES_INLINE TInt<N> ToInt(TUint<N> X)
{
	return TInt<N>(TRaw<int32_t, N>(X.V));
}
template<int N>
DRYDOCK_LANES_INLINE TInt<N> ToInt(TMask<N> X)
{
	return TInt<N>(X.V & 1);
}

template<CUniform T>
DRYDOCK_LANES_INLINE uint32_t ToUint(T X)
{
	if constexpr (std::is_floating_point_v<T>)
	{
		return Convert::Uint(Widen(X))[0];
	}
	else
	{
		return uint32_t(X);
	}
}
template<typename Real, int N>
DRYDOCK_LANES_INLINE TUint<N> ToUint(TReal<Real, N> X)
{
	return Convert::Uint(X);
}
template<int N>
DRYDOCK_LANES_INLINE TUint<N> ToUint(TUint<N> X)
{
	return X;
}
template<int N>
DRYDOCK_LANES_INLINE TUint<N> ToUint(TInt<N> X)
{
	return TUint<N>(TRaw<uint32_t, N>(X.V));
}
template<int N>
DRYDOCK_LANES_INLINE TUint<N> ToUint(TMask<N> X)
{
	return TUint<N>(TRaw<uint32_t, N>(X.V & 1));
}

/** Not equal to zero; NaN is true. */
template<CScalar T>
DRYDOCK_LANES_INLINE auto ToBool(T X)
{
	if constexpr (std::is_same_v<T, bool> || !requires { X != T(0); })
	{
		return X;
	}
	else
	{
		return X != T(0);
	}
}
template<int N>
DRYDOCK_LANES_INLINE TMask<N> ToBool(TMask<N> X)
{
	return X;
}

template<CUniform T>
DRYDOCK_LANES_INLINE uint32_t AsUint(T X)
{
	if constexpr (std::is_floating_point_v<T>)
	{
		return __builtin_bit_cast(uint32_t, float(X));
	}
	else
	{
		return uint32_t(X);
	}
}
template<typename Real, int N>
DRYDOCK_LANES_INLINE TUint<N> AsUint(TReal<Real, N> X)
{
	return TUint<N>(TRaw<uint32_t, N>(__builtin_convertvector(X.V, TRaw<float, N>)));
}
template<int N>
DRYDOCK_LANES_INLINE TUint<N> AsUint(TInt<N> X)
{
	return ToUint(X);
}
template<int N>
DRYDOCK_LANES_INLINE TUint<N> AsUint(TUint<N> X)
{
	return X;
}
template<CScalar T>
DRYDOCK_LANES_INLINE auto AsInt(T X)
{
	return ToInt(AsUint(X));
}
template<typename Real, CUniform T>
DRYDOCK_LANES_INLINE Real AsReal(T X)
{
	return Real(__builtin_bit_cast(float, AsUint(X)));
}
template<typename Real, CLanes T>
DRYDOCK_LANES_INLINE auto AsReal(T X)
{
	constexpr int N = sizeof(AsUint(X).V) / 4;
	return TReal<Real, N>(__builtin_convertvector(TRaw<float, N>(AsUint(X).V), TRaw<Real, N>));
}

#define DRYDOCK_LANES_VECTOR_CONVERSION(Name) \
	template<typename T, int n> \
	DRYDOCK_LANES_INLINE auto Name(const TVec<T, n>& V) \
	{ \
		return Map([](const T& x) { return Name(x); }, V); \
	}
DRYDOCK_LANES_VECTOR_CONVERSION(ToInt)
DRYDOCK_LANES_VECTOR_CONVERSION(ToUint)
DRYDOCK_LANES_VECTOR_CONVERSION(ToBool)
DRYDOCK_LANES_VECTOR_CONVERSION(AsInt)
DRYDOCK_LANES_VECTOR_CONVERSION(AsUint)
#undef DRYDOCK_LANES_VECTOR_CONVERSION
template<typename Real, typename T, int n>
DRYDOCK_LANES_INLINE auto ToReal(const TVec<T, n>& V)
{
	return Map([](const T& x) { return ToReal<Real>(x); }, V);
}
template<typename Real, typename T, int n>
DRYDOCK_LANES_INLINE auto AsReal(const TVec<T, n>& V)
{
	return Map([](const T& x) { return AsReal<Real>(x); }, V);
}

/** Low half first (f16tof32 of each half of the word). */
template<typename Real, int N>
DRYDOCK_LANES_INLINE TVec<TReal<Real, N>, 2> UnpackHalf2(TUint<N> X)
{
	const TReal<float, N> Low = Convert::HalfToFloat(X & TUint<N>(0xFFFFu));
	const TReal<float, N> High = Convert::HalfToFloat(TUint<N>(X.V >> 16));
	return TVec<TReal<Real, N>, 2>(TReal<Real, N>(__builtin_convertvector(Low.V, TRaw<Real, N>)),
		TReal<Real, N>(__builtin_convertvector(High.V, TRaw<Real, N>)));
}
template<typename Real>
DRYDOCK_LANES_INLINE TVec<Real, 2> UnpackHalf2(uint32_t X)
{
	return First(UnpackHalf2<Real>(TUint<4>(X)));
}

/** Double rounds to float first. */
template<typename Real, int N>
DRYDOCK_LANES_INLINE TUint<N> PackHalf2(const TVec<TReal<Real, N>, 2>& V)
{
	const TReal<float, N> Low(__builtin_convertvector(V.E[0].V, TRaw<float, N>));
	const TReal<float, N> High(__builtin_convertvector(V.E[1].V, TRaw<float, N>));
	return TUint<N>(Convert::FloatToHalf(Low).V | (Convert::FloatToHalf(High).V << 16));
}
template<CUniform Real>
DRYDOCK_LANES_INLINE uint32_t PackHalf2(const TVec<Real, 2>& V)
{
	return PackHalf2(TVec<TReal<Real, 4>, 2>(V))[0];
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
