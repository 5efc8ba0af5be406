// Lanes: the vocabulary in which a compiled shader is written. One value holds the same variable of N neighbouring
// threads (pixels); the C++ of a kernel is generated from SPIR-V, so everything here is a plain function with an
// unambiguous name. Follows the rules of Direct3D 11 (functional specification, sections 3 and 7), not those of C.
//
// Vocabulary. Real is float or double, N the lanes (float 4, 8, 16; double 2, 4, 8). "Uniform" values are plain Real,
// int32_t, uint32_t and bool: the same in all lanes. They convert implicitly to their varying type, and operators mix.
//
//   Types         TReal<Real, N>, TInt<N>, TUint<N>, TMask<N> (bool); X.V is the GCC vector, X[i] reads a lane
//                 TVec<T, n> n = 2..4, T any type above, V[i] is a component, TVec<T, 3>(a, b, c), Splat<3>(x)
//                 TMat<T, Columns, Rows> M[i] is a column (as in SPIR-V); TArray<T, n> A[i] with a known index
//                 Varying<N, T> names the varying type of a uniform T; Vary<N>(x) makes one; First(x) is lane 0
//   Lanes         LaneIndex<N>() = 0, 1, 2..; AnyLane, AllLanes, CountLanes (Mask or bool)
//   Masks         & | ^ ! && || == != on masks and bools; Select(Condition, A, B) with Condition a mask, a bool or a
//                 TVec of them; Assign(Mask or bool, Place, Value) writes only the lanes of the mask (all types above)
//   Operators     Real: + - * / unary -; Int, Uint: + - * & | ^ ~ unary -, all wrapping; comparisons give masks.
//                 All work per component on TVec, and between a TVec and a scalar. Never / or % on integers:
//                 IntDivide, IntRemainder (sign of the dividend), IntModulo (sign of the divisor), ShiftLeft,
//                 ShiftRight (arithmetic on Int, logical on Uint), Add, Subtract, Multiply, Negate (wrapping on
//                 uniforms too)
//   Conversions   ToReal<Real>(x), ToInt(x), ToUint(x), ToBool(x) from any scalar or TVec; AsReal<Real>, AsInt, AsUint
//                 keep the bits of a 32-bit value (double goes through float32)
//   Arithmetic    Abs Sign Floor Ceil Round RoundEven Trunc Frac Sqrt InverseSqrt Min Max Clamp Saturate Mix Step
//                 SmoothStep FMod (x - y floor(x/y)) FRem (x - y trunc(x/y)) Fma (HLSL's mad: rounded twice)
//                 Fused (x y + z rounded once) Ldexp IsNan IsInf IsFinite Degrees Radians; integer: Abs Sign Min Max
//                 Clamp BitCount BitReverse FindLsb FindMsb BitFieldExtract BitFieldInsert
//   Elementary    Exp2 Log2 Exp Log Pow Sin Cos Tan Asin Acos Atan Atan2 Sinh Cosh Tanh
//   Vectors       Dot Cross Length Distance Normalize Reflect Refract FaceForward Any All (components);
//                 Mul(M, V) Mul(V, M) Mul(M, M) Mul(M, x) Transpose Determinant OuterProduct
//                 Extract(VecOrArray, Index), Insert(Mask, Place, Index, Value): any index, never foreign memory
//   Packing       UnpackHalf2<Real>(Uint) PackHalf2(Vec2), as SPIR-V's UnpackHalf2x16 and PackHalf2x16
//   Resources     see LanesResources.h: SampleLevel2D/2DArray/3D, Gather2D, Load2D/2DArray/3D (+ Uint),
//   StoreTexture2D.. ,
//                 StoreTarget, TextureSize2D/3D, TextureLevels, LoadBufferReal/Int/Uint, StoreBufferReal/Int/Uint,
//                 LoadTyped, StoreTyped, BufferElements, ReadConstant, Interpolate
//
// Uniform scalars run the same code as lanes: an interpreter that calls these functions with plain float, int32_t and
// uint32_t, and TSampling<float, 1> for textures, is a model of the compiled shader, bit for bit.
#pragma once

#include "ShaderKernel.h"

#include "LanesTypes.h"
#include "LanesVectors.h"
#include "LanesMath.h"
#include "LanesInteger.h"
#include "LanesGeometry.h"
#include "LanesPow.h"
#include "LanesResources.h"
