// Short vectors, matrices and arrays of uniform or lane values: plain structs of components, so that the compiler keeps
// each component in a register of its own.
#pragma once

#include "LanesTypes.h"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

/** n components, 2..4. Components default to garbage, as locals in C++ do. */
template<typename T, int n>
struct TVec
{
	static_assert(n >= 2 && n <= 4);
	T E[n];

	TVec() = default;
	DRYDOCK_LANES_INLINE TVec(const T& X, const T& Y) requires(n == 2)
		: E{X, Y}
	{
	}
	DRYDOCK_LANES_INLINE TVec(const T& X, const T& Y, const T& Z) requires(n == 3)
		: E{X, Y, Z}
	{
	}
	DRYDOCK_LANES_INLINE TVec(const T& X, const T& Y, const T& Z, const T& W) requires(n == 4)
		: E{X, Y, Z, W}
	{
	}

	/** Uniform to varying. */
	template<CUniform U>
	requires(CLanes<T>) DRYDOCK_LANES_INLINE TVec(const TVec<U, n>& Other)
	{
		E[0] = T(Other.E[0]);
		E[1] = T(Other.E[1]);
		if constexpr (n > 2)
		{
			E[2] = T(Other.E[2]);
		}
		if constexpr (n > 3)
		{
			E[3] = T(Other.E[3]);
		}
	}

	DRYDOCK_LANES_INLINE const T& operator[](int i) const { return E[i]; }
	DRYDOCK_LANES_INLINE T& operator[](int i) { return E[i]; }
};

/** Matrix of Columns columns of Rows components, as SPIR-V counts them. */
template<typename T, int Columns, int Rows>
struct TMat
{
	TVec<T, Rows> E[Columns];

	TMat() = default;
	template<CUniform U>
	requires(CLanes<T>) DRYDOCK_LANES_INLINE TMat(const TMat<U, Columns, Rows>& Other)
	{
		for (int i = 0; i < Columns; ++i)
		{
			E[i] = TVec<T, Rows>(Other.E[i]);
		}
	}
	/** From its columns. */
	template<typename... U>
	requires(sizeof...(U) == Columns && Columns > 1) DRYDOCK_LANES_INLINE TMat(const U&... InColumns)
		: E{TVec<T, Rows>(InColumns)...}
	{
	}

	DRYDOCK_LANES_INLINE const TVec<T, Rows>& operator[](int i) const { return E[i]; }
	DRYDOCK_LANES_INLINE TVec<T, Rows>& operator[](int i) { return E[i]; }
};

/** Fixed array of anything. A varying index goes through Extract and Insert. */
template<typename T, int n>
struct TArray
{
	T E[n];

	DRYDOCK_LANES_INLINE const T& operator[](int i) const { return E[i]; }
	DRYDOCK_LANES_INLINE T& operator[](int i) { return E[i]; }
};

template<int N, typename T, int n>
struct TVaryingOf<N, TVec<T, n>>
{
	using Type = TVec<Varying<N, T>, n>;
};
template<int N, typename T, int C, int R>
struct TVaryingOf<N, TMat<T, C, R>>
{
	using Type = TMat<Varying<N, T>, C, R>;
};
template<int N, typename T, int n>
struct TVaryingOf<N, TArray<T, n>>
{
	using Type = TArray<Varying<N, T>, n>;
};

/** f applied to each component. f is a function object; the results make the vector. */
template<typename F, typename A, int n>
DRYDOCK_LANES_INLINE auto Map(F f, const TVec<A, n>& a)
{
	using R = decltype(f(a.E[0]));
	if constexpr (n == 2)
	{
		return TVec<R, 2>(f(a.E[0]), f(a.E[1]));
	}
	else if constexpr (n == 3)
	{
		return TVec<R, 3>(f(a.E[0]), f(a.E[1]), f(a.E[2]));
	}
	else
	{
		return TVec<R, 4>(f(a.E[0]), f(a.E[1]), f(a.E[2]), f(a.E[3]));
	}
}
template<typename F, typename A, typename B, int n>
DRYDOCK_LANES_INLINE auto Map(F f, const TVec<A, n>& a, const TVec<B, n>& b)
{
	using R = decltype(f(a.E[0], b.E[0]));
	if constexpr (n == 2)
	{
		return TVec<R, 2>(f(a.E[0], b.E[0]), f(a.E[1], b.E[1]));
	}
	else if constexpr (n == 3)
	{
		return TVec<R, 3>(f(a.E[0], b.E[0]), f(a.E[1], b.E[1]), f(a.E[2], b.E[2]));
	}
	else
	{
		return TVec<R, 4>(f(a.E[0], b.E[0]), f(a.E[1], b.E[1]), f(a.E[2], b.E[2]), f(a.E[3], b.E[3]));
	}
}
template<typename F, typename A, typename B, typename C, int n>
DRYDOCK_LANES_INLINE auto Map(F f, const TVec<A, n>& a, const TVec<B, n>& b, const TVec<C, n>& c)
{
	using R = decltype(f(a.E[0], b.E[0], c.E[0]));
	if constexpr (n == 2)
	{
		return TVec<R, 2>(f(a.E[0], b.E[0], c.E[0]), f(a.E[1], b.E[1], c.E[1]));
	}
	else if constexpr (n == 3)
	{
		return TVec<R, 3>(f(a.E[0], b.E[0], c.E[0]), f(a.E[1], b.E[1], c.E[1]), f(a.E[2], b.E[2], c.E[2]));
	}
	else
	{
		return TVec<R, 4>(
			f(a.E[0], b.E[0], c.E[0]), f(a.E[1], b.E[1], c.E[1]), f(a.E[2], b.E[2], c.E[2]), f(a.E[3], b.E[3], c.E[3]));
	}
}

/** X in every component. */
template<int n, typename T>
DRYDOCK_LANES_INLINE TVec<T, n> Splat(const T& X)
{
	if constexpr (n == 2)
	{
		return TVec<T, 2>(X, X);
	}
	else if constexpr (n == 3)
	{
		return TVec<T, 3>(X, X, X);
	}
	else
	{
		return TVec<T, 4>(X, X, X, X);
	}
}

/** Swizzle<2, 1, 0>(v) is v.zyx. */
template<int... I, typename T, int n>
DRYDOCK_LANES_INLINE TVec<T, int(sizeof...(I))> Swizzle(const TVec<T, n>& V)
{
	return TVec<T, int(sizeof...(I))>(V.E[I]...);
}

// Operators per component: vector with vector, vector with scalar, scalar with vector.
#define DRYDOCK_LANES_VECTOR_OPERATOR(Op) \
	template<typename A, typename B, int n> \
	DRYDOCK_LANES_INLINE auto operator Op(const TVec<A, n>& a, const TVec<B, n>& b) \
	{ \
		using R = decltype(a.E[0] Op b.E[0]); \
		TVec<R, n> r; \
		r.E[0] = a.E[0] Op b.E[0]; \
		r.E[1] = a.E[1] Op b.E[1]; \
		if constexpr (n > 2) \
		{ \
			r.E[2] = a.E[2] Op b.E[2]; \
		} \
		if constexpr (n > 3) \
		{ \
			r.E[3] = a.E[3] Op b.E[3]; \
		} \
		return r; \
	} \
	template<typename A, CScalar S, int n> \
	DRYDOCK_LANES_INLINE auto operator Op(const TVec<A, n>& a, const S& s) \
	{ \
		return a Op Splat<n>(s); \
	} \
	template<typename B, CScalar S, int n> \
	DRYDOCK_LANES_INLINE auto operator Op(const S& s, const TVec<B, n>& b) \
	{ \
		return Splat<n>(s) Op b; \
	}
DRYDOCK_LANES_VECTOR_OPERATOR(+)
DRYDOCK_LANES_VECTOR_OPERATOR(-)
DRYDOCK_LANES_VECTOR_OPERATOR(*)
DRYDOCK_LANES_VECTOR_OPERATOR(/)
DRYDOCK_LANES_VECTOR_OPERATOR(&)
DRYDOCK_LANES_VECTOR_OPERATOR(|)
DRYDOCK_LANES_VECTOR_OPERATOR(^)
DRYDOCK_LANES_VECTOR_OPERATOR(&&)
DRYDOCK_LANES_VECTOR_OPERATOR(||)
DRYDOCK_LANES_VECTOR_OPERATOR(<)
DRYDOCK_LANES_VECTOR_OPERATOR(>)
DRYDOCK_LANES_VECTOR_OPERATOR(<=)
DRYDOCK_LANES_VECTOR_OPERATOR(>=)
DRYDOCK_LANES_VECTOR_OPERATOR(==)
DRYDOCK_LANES_VECTOR_OPERATOR(!=)
#undef DRYDOCK_LANES_VECTOR_OPERATOR

template<typename T, int n>
DRYDOCK_LANES_INLINE TVec<T, n> operator-(const TVec<T, n>& V)
{
	return Map([](const T& x) { return T(-x); }, V);
}
template<typename T, int n>
DRYDOCK_LANES_INLINE TVec<T, n> operator~(const TVec<T, n>& V)
{
	return Map([](const T& x) { return T(~x); }, V);
}
template<typename T, int n>
DRYDOCK_LANES_INLINE TVec<T, n> operator!(const TVec<T, n>& V)
{
	return Map([](const T& x) { return T(!x); }, V);
}

/** Per component; the condition may be one for all or one per component. */
template<typename C, typename A, typename B, int n>
DRYDOCK_LANES_INLINE auto Select(const TVec<C, n>& c, const TVec<A, n>& a, const TVec<B, n>& b)
{
	return Map([](const C& x, const A& y, const B& z) { return Select(x, y, z); }, c, a, b);
}
template<CScalar C, typename A, typename B, int n>
DRYDOCK_LANES_INLINE auto Select(const C& c, const TVec<A, n>& a, const TVec<B, n>& b)
{
	return Select(Splat<n>(c), a, b);
}

template<typename C, typename T, typename S, int n>
DRYDOCK_LANES_INLINE void Assign(C c, TVec<T, n>& Place, const TVec<S, n>& Value)
{
	Assign(c, Place.E[0], Value.E[0]);
	Assign(c, Place.E[1], Value.E[1]);
	if constexpr (n > 2)
	{
		Assign(c, Place.E[2], Value.E[2]);
	}
	if constexpr (n > 3)
	{
		Assign(c, Place.E[3], Value.E[3]);
	}
}
template<typename C, typename T, typename S, int Columns, int Rows>
DRYDOCK_LANES_INLINE void Assign(C c, TMat<T, Columns, Rows>& Place, const TMat<S, Columns, Rows>& Value)
{
	for (int i = 0; i < Columns; ++i)
	{
		Assign(c, Place.E[i], Value.E[i]);
	}
}
template<typename C, typename T, typename S, int n>
DRYDOCK_LANES_INLINE void Assign(C c, TArray<T, n>& Place, const TArray<S, n>& Value)
{
	for (int i = 0; i < n; ++i)
	{
		Assign(c, Place.E[i], Value.E[i]);
	}
}

template<typename T, int n>
DRYDOCK_LANES_INLINE auto First(const TVec<T, n>& V)
{
	return Map([](const T& x) { return First(x); }, V);
}

/** Component or element at a uniform index; out of range gives the last one (never foreign memory). */
template<typename T, int n>
DRYDOCK_LANES_INLINE T Extract(const TVec<T, n>& V, int32_t Index)
{
	return V.E[uint32_t(Index) < uint32_t(n) ? Index : n - 1];
}
template<typename T, int n>
DRYDOCK_LANES_INLINE T Extract(const TArray<T, n>& A, int32_t Index)
{
	return A.E[uint32_t(Index) < uint32_t(n) ? Index : n - 1];
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
