// Vector and matrix intrinsics: sums run over the components in order, unfused. Source: HLSL reference; drydock.
#pragma once

#include "LanesMath.h"

namespace Drydock::Lanes
{
inline namespace DRYDOCK_LANES_SET
{

template<typename A, typename B, int n>
DRYDOCK_LANES_INLINE auto Dot(const TVec<A, n>& a, const TVec<B, n>& b)
{
	auto Sum = a.E[0] * b.E[0] + a.E[1] * b.E[1];
	if constexpr (n > 2)
	{
		Sum = Sum + a.E[2] * b.E[2];
	}
	if constexpr (n > 3)
	{
		Sum = Sum + a.E[3] * b.E[3];
	}
	return Sum;
}

template<typename A, typename B>
DRYDOCK_LANES_INLINE auto Cross(const TVec<A, 3>& a, const TVec<B, 3>& b)
{
	using R = decltype(a.E[0] * b.E[0]);
	return TVec<R, 3>(
		a.E[1] * b.E[2] - a.E[2] * b.E[1], a.E[2] * b.E[0] - a.E[0] * b.E[2], a.E[0] * b.E[1] - a.E[1] * b.E[0]);
}

template<typename T, int n>
DRYDOCK_LANES_INLINE auto Length(const TVec<T, n>& v)
{
	return Sqrt(Dot(v, v));
}
template<CScalar T>
DRYDOCK_LANES_INLINE auto Length(T x)
{
	return Abs(x);
}
template<typename A, typename B>
DRYDOCK_LANES_INLINE auto Distance(const A& a, const B& b)
{
	return Length(a - b);
}

/** v * (1 / length): the zero vector gives NaN, as in Direct3D. */
template<typename T, int n>
DRYDOCK_LANES_INLINE auto Normalize(const TVec<T, n>& v)
{
	return v * InverseSqrt(Dot(v, v));
}

template<typename I, typename N_, int n>
DRYDOCK_LANES_INLINE auto Reflect(const TVec<I, n>& Incident, const TVec<N_, n>& Normal)
{
	const auto Twice = Dot(Normal, Incident) + Dot(Normal, Incident);
	return Incident - Normal * Twice;
}
template<typename I, typename N_, typename S, int n>
DRYDOCK_LANES_INLINE auto Refract(const TVec<I, n>& Incident, const TVec<N_, n>& Normal, const S& Eta)
{
	const auto Cosine = Dot(Normal, Incident);
	using T = Meet<S, std::remove_cvref_t<decltype(Cosine)>>;
	const T EtaV = T(Eta);
	const T Zero = T(0);
	const T One = T(1);
	const auto K = One - EtaV * EtaV * (One - Cosine * Cosine);
	const auto Bent = Incident * EtaV - Normal * (EtaV * Cosine + Sqrt(Max(K, Zero)));
	return Select(K < Zero, Splat<n>(Zero), Bent);
}
template<typename A, typename B, typename C, int n>
DRYDOCK_LANES_INLINE auto FaceForward(const TVec<A, n>& Normal, const TVec<B, n>& Incident, const TVec<C, n>& Reference)
{
	const auto Facing = Dot(Reference, Incident);
	using T = std::remove_cvref_t<decltype(Facing)>;
	return Select(Facing < T(0), Normal, -Normal);
}

/** Over the components of a bool vector. */
template<typename T, int n>
DRYDOCK_LANES_INLINE T Any(const TVec<T, n>& v)
{
	T Result = v.E[0] || v.E[1];
	for (int i = 2; i < n; ++i)
	{
		Result = Result || v.E[i];
	}
	return Result;
}
template<typename T, int n>
DRYDOCK_LANES_INLINE T All(const TVec<T, n>& v)
{
	T Result = v.E[0] && v.E[1];
	for (int i = 2; i < n; ++i)
	{
		Result = Result && v.E[i];
	}
	return Result;
}

/** Matrix times column vector: the sum of columns. */
template<typename A, typename B, int C, int R>
DRYDOCK_LANES_INLINE auto Mul(const TMat<A, C, R>& M, const TVec<B, C>& V)
{
	auto Sum = M.E[0] * V.E[0];
	for (int i = 1; i < C; ++i)
	{
		Sum = Sum + M.E[i] * V.E[i];
	}
	return Sum;
}
/** Row vector times matrix: a dot product per column. */
template<typename A, typename B, int C, int R>
DRYDOCK_LANES_INLINE auto Mul(const TVec<B, R>& V, const TMat<A, C, R>& M)
{
	TVec<decltype(Dot(V, M.E[0])), C> Result;
	for (int i = 0; i < C; ++i)
	{
		Result.E[i] = Dot(V, M.E[i]);
	}
	return Result;
}
template<typename A, typename B, int C, int K, int R>
DRYDOCK_LANES_INLINE auto Mul(const TMat<A, K, R>& L, const TMat<B, C, K>& M)
{
	TMat<decltype(L.E[0].E[0] * M.E[0].E[0]), C, R> Result;
	for (int i = 0; i < C; ++i)
	{
		Result.E[i] = Mul(L, M.E[i]);
	}
	return Result;
}
template<typename A, CScalar S, int C, int R>
DRYDOCK_LANES_INLINE auto Mul(const TMat<A, C, R>& M, S s)
{
	TMat<decltype(M.E[0].E[0] * s), C, R> Result;
	for (int i = 0; i < C; ++i)
	{
		Result.E[i] = M.E[i] * s;
	}
	return Result;
}
template<typename A, int C, int R>
DRYDOCK_LANES_INLINE TMat<A, R, C> Transpose(const TMat<A, C, R>& M)
{
	TMat<A, R, C> Result;
	for (int i = 0; i < R; ++i)
	{
		for (int j = 0; j < C; ++j)
		{
			Result.E[i].E[j] = M.E[j].E[i];
		}
	}
	return Result;
}
template<typename A, typename B, int C, int R>
DRYDOCK_LANES_INLINE auto OuterProduct(const TVec<A, R>& Column, const TVec<B, C>& Row)
{
	TMat<decltype(Column.E[0] * Row.E[0]), C, R> Result;
	for (int i = 0; i < C; ++i)
	{
		Result.E[i] = Column * Row.E[i];
	}
	return Result;
}

template<typename T>
DRYDOCK_LANES_INLINE T Determinant(const TMat<T, 2, 2>& M)
{
	return M.E[0].E[0] * M.E[1].E[1] - M.E[0].E[1] * M.E[1].E[0];
}
template<typename T>
DRYDOCK_LANES_INLINE T Determinant(const TMat<T, 3, 3>& M)
{
	return Dot(M.E[0], Cross(M.E[1], M.E[2]));
}
template<typename T>
DRYDOCK_LANES_INLINE T Determinant(const TMat<T, 4, 4>& M)
{
	// Laplace over the first two columns: six 2x2 minors against their complements.
	const auto Minor = [&M](int Column, int Row0, int Row1)
	{
		return M.E[Column].E[Row0] * M.E[Column + 1].E[Row1] - M.E[Column].E[Row1] * M.E[Column + 1].E[Row0];
	};
	return Minor(0, 0, 1) * Minor(2, 2, 3) - Minor(0, 0, 2) * Minor(2, 1, 3) + Minor(0, 0, 3) * Minor(2, 1, 2) +
		   Minor(0, 1, 2) * Minor(2, 0, 3) - Minor(0, 1, 3) * Minor(2, 0, 2) + Minor(0, 2, 3) * Minor(2, 0, 1);
}

namespace Impl
{

// Element at a varying index: one masked pick per element, so that nothing outside the array is ever read.
template<int N, typename T, typename I>
DRYDOCK_LANES_INLINE Varying<N, T> PickFrom(const T* Elements, int Count, const I& Index)
{
	Varying<N, T> Result = Vary<N>(Elements[Count - 1]);
	for (int i = 0; i < Count - 1; ++i)
	{
		Assign(Index == I(i), Result, Vary<N>(Elements[i]));
	}
	return Result;
}

} // namespace Impl

/** Component or element at a varying index; out of range gives the last one. */
template<int N, typename T, int n>
DRYDOCK_LANES_INLINE auto Extract(const TVec<T, n>& V, const TInt<N>& Index)
{
	return Impl::PickFrom<N>(V.E, n, Index);
}
template<int N, typename T, int n>
DRYDOCK_LANES_INLINE auto Extract(const TVec<T, n>& V, const TUint<N>& Index)
{
	return Impl::PickFrom<N>(V.E, n, Index);
}
template<int N, typename T, int n>
DRYDOCK_LANES_INLINE auto Extract(const TArray<T, n>& A, const TInt<N>& Index)
{
	return Impl::PickFrom<N>(A.E, n, Index);
}
template<int N, typename T, int n>
DRYDOCK_LANES_INLINE auto Extract(const TArray<T, n>& A, const TUint<N>& Index)
{
	return Impl::PickFrom<N>(A.E, n, Index);
}

/** Writes one component or element at a varying index in the lanes of the mask; out of range is dropped. */
template<typename C, typename P, typename I, typename V>
DRYDOCK_LANES_INLINE void Insert(C Mask, P& Place, const I& Index, const V& Value)
{
	for (int i = 0; i < int(sizeof(Place.E) / sizeof(Place.E[0])); ++i)
	{
		Assign((Index == I(i)) && Mask, Place.E[i], Value);
	}
}

} // namespace DRYDOCK_LANES_SET
} // namespace Drydock::Lanes
