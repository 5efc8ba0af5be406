// Arithmetic of all vector types, computed by GLM: every type here names the GLM type it has the layout of. The right
// operand converts as it does for the engine's member operators, so that Viewport / FIntPoint gives what it gives
// there.
#pragma once

#include "Math/MathFwd.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <bit>
#include <concepts>
#include <type_traits>

namespace UE::Math
{

template<typename V>
concept CVector = requires
{
	typename V::GlmType;
	typename V::FReal;
}
&&sizeof(V) == sizeof(typename V::GlmType);

template<typename V, typename = typename V::GlmType>
struct TSame
{
	using Type = V;
};

/** V, not deduced from, and no type at all if V is not a vector: clang before 16 substitutes the parameters before it
 * checks the concept. */
template<typename V>
using TOperand = typename TSame<V>::Type;

template<CVector V>
constexpr typename V::GlmType ToGlm(const V& Vector)
{
	return std::bit_cast<typename V::GlmType>(Vector);
}

template<CVector V>
constexpr V FromGlm(const typename V::GlmType& Vector)
{
	return std::bit_cast<V>(Vector);
}

template<CVector V>
constexpr V operator+(const V& A, const TOperand<V>& B)
{
	return FromGlm<V>(ToGlm(A) + ToGlm(B));
}
template<CVector V>
constexpr V operator-(const V& A, const TOperand<V>& B)
{
	return FromGlm<V>(ToGlm(A) - ToGlm(B));
}
template<CVector V>
constexpr V operator*(const V& A, const TOperand<V>& B)
{
	return FromGlm<V>(ToGlm(A) * ToGlm(B));
}
template<CVector V>
constexpr V operator/(const V& A, const TOperand<V>& B)
{
	return FromGlm<V>(ToGlm(A) / ToGlm(B));
}
template<CVector V>
constexpr V operator+(const V& A, typename V::FReal B)
{
	return FromGlm<V>(ToGlm(A) + B);
}
template<CVector V>
constexpr V operator-(const V& A, typename V::FReal B)
{
	return FromGlm<V>(ToGlm(A) - B);
}
template<CVector V>
constexpr V operator*(const V& A, typename V::FReal B)
{
	return FromGlm<V>(ToGlm(A) * B);
}
template<CVector V>
constexpr V operator*(typename V::FReal A, const V& B)
{
	return FromGlm<V>(A * ToGlm(B));
}
template<CVector V>
constexpr V operator/(const V& A, typename V::FReal B)
{
	return FromGlm<V>(ToGlm(A) / B);
}
template<CVector V>
requires std::is_signed_v<typename V::FReal>
constexpr V operator-(const V& A)
{
	return FromGlm<V>(-ToGlm(A));
}

template<CVector V>
requires std::is_integral_v<typename V::FReal>
constexpr V operator%(const V& A, typename V::FReal B)
{
	return FromGlm<V>(ToGlm(A) % B);
}
template<CVector V>
requires std::is_integral_v<typename V::FReal>
constexpr V operator>>(const V& A, typename V::FReal B)
{
	return FromGlm<V>(ToGlm(A) >> B);
}
template<CVector V>
requires std::is_integral_v<typename V::FReal>
constexpr V operator<<(const V& A, typename V::FReal B)
{
	return FromGlm<V>(ToGlm(A) << B);
}

template<CVector V>
constexpr V& operator+=(V& A, const TOperand<V>& B)
{
	return A = A + B;
}
template<CVector V>
constexpr V& operator-=(V& A, const TOperand<V>& B)
{
	return A = A - B;
}
template<CVector V>
constexpr V& operator*=(V& A, const TOperand<V>& B)
{
	return A = A * B;
}
template<CVector V>
constexpr V& operator/=(V& A, const TOperand<V>& B)
{
	return A = A / B;
}
template<CVector V>
constexpr V& operator*=(V& A, typename V::FReal B)
{
	return A = A * B;
}
template<CVector V>
constexpr V& operator/=(V& A, typename V::FReal B)
{
	return A = A / B;
}

} // namespace UE::Math
