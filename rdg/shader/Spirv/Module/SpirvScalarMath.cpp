// Computes single scalars as Direct3D rules. Source: D3D11 functional specification, section 3 (conversions, NaN rules,
// shifts by five bits).
#include "SpirvScalarMath.h"

#include "Lanes.h"

#include <cmath>

namespace Drydock
{

using namespace Spirv;

namespace
{

// A NaN loses against a number; of two equal operands (zeros) the second is taken.
template<typename Real>
Real MinNumber(Real A, Real B)
{
	return B != B ? A : A < B ? A : B;
}

template<typename Real>
Real MaxNumber(Real A, Real B)
{
	return B != B ? A : A > B ? A : B;
}

template<typename Real>
uint32_t FloatToUint(Real X)
{
	return !(X > 0) ? 0 : X >= Real(4294967296.0) ? 0xFFFFFFFFu : uint32_t(X);
}

template<typename Real>
uint32_t FloatToInt(Real X)
{
	return X != X                    ? 0
		   : X >= Real(2147483648.0) ? 0x7FFFFFFFu
		   : X < Real(-2147483648.0) ? 0x80000000u
									 : uint32_t(int32_t(X));
}

// D3D has no signed division: by zero, all bits are set as in its udiv, and the most negative number wraps.
uint32_t DivideInt(int32_t A, int32_t B)
{
	return B == 0 ? ~0u : uint32_t(int64_t(A) / B);
}

uint32_t RemainderInt(int32_t A, int32_t B)
{
	return B == 0 ? ~0u : uint32_t(int64_t(A) % B);
}

} // namespace

template<typename Real>
bool EvaluateOperation(uint16_t Op, const TSpirvWord<Real>* Operands, TSpirvWord<Real>& Result)
{
	using FWord = TSpirvWord<Real>;
	constexpr FWord SignBit = FWord(1) << (8 * sizeof(Real) - 1);
	const uint32_t A = uint32_t(Operands[0]);
	const uint32_t B = uint32_t(Operands[1]);
	const Real X = ToSpirvReal<Real>(Operands[0]);
	const Real Y = ToSpirvReal<Real>(Operands[1]);
	const auto ToBits = [](Real Value)
	{
		return ToSpirvWord<Real>(Value);
	};
	const int32_t I = int32_t(A);
	const int32_t J = int32_t(B);
	// clang-format off
	switch (Op)
	{
	case OpCopyObject: Result = Operands[0]; return true;
	case OpConvertFToU: Result = FloatToUint(X); return true;
	case OpConvertFToS: Result = FloatToInt(X); return true;
	case OpConvertSToF: Result = ToBits(Real(I)); return true;
	case OpConvertUToF: Result = ToBits(Real(A)); return true;
	case OpSNegate: Result = 0u - A; return true;
	case OpFNegate: Result = Operands[0] ^ SignBit; return true;
	case OpIAdd: Result = A + B; return true;
	case OpISub: Result = A - B; return true;
	case OpIMul: Result = A * B; return true;
	case OpFAdd: Result = ToBits(X + Y); return true;
	case OpFSub: Result = ToBits(X - Y); return true;
	case OpFMul: Result = ToBits(X * Y); return true;
	case OpFDiv: Result = ToBits(X / Y); return true;
	case OpUDiv: Result = B ? A / B : 0xFFFFFFFFu; return true;
	case OpUMod: Result = B ? A % B : 0xFFFFFFFFu; return true;
	case OpSDiv: Result = DivideInt(I, J); return true;
	case OpSRem: case OpSMod: Result = RemainderInt(I, J); return true;
	case OpFRem: case OpFMod: Result = ToBits(X - Y * std::trunc(X / Y)); return true;
	case OpIsNan: Result = X != X; return true;
	case OpIsInf: Result = std::isinf(X); return true;
	case OpLogicalEqual: Result = A == B; return true;
	case OpLogicalNotEqual: Result = A != B; return true;
	case OpLogicalOr: Result = A | B; return true;
	case OpLogicalAnd: Result = A & B; return true;
	case OpLogicalNot: Result = !A; return true;
	case OpSelect: Result = Operands[0] ? Operands[1] : Operands[2]; return true;
	case OpIEqual: Result = A == B; return true;
	case OpINotEqual: Result = A != B; return true;
	case OpUGreaterThan: Result = A > B; return true;
	case OpUGreaterThanEqual: Result = A >= B; return true;
	case OpULessThan: Result = A < B; return true;
	case OpULessThanEqual: Result = A <= B; return true;
	case OpSGreaterThan: Result = I > J; return true;
	case OpSGreaterThanEqual: Result = I >= J; return true;
	case OpSLessThan: Result = I < J; return true;
	case OpSLessThanEqual: Result = I <= J; return true;
	case OpFOrdEqual: Result = X == Y; return true;
	case OpFUnordEqual: Result = !(X < Y || X > Y); return true;
	case OpFOrdNotEqual: case OpFUnordNotEqual: Result = X != Y; return true;
	case OpFOrdLessThan: Result = X < Y; return true;
	case OpFUnordLessThan: Result = !(X >= Y); return true;
	case OpFOrdGreaterThan: Result = X > Y; return true;
	case OpFUnordGreaterThan: Result = !(X <= Y); return true;
	case OpFOrdLessThanEqual: Result = X <= Y; return true;
	case OpFUnordLessThanEqual: Result = !(X > Y); return true;
	case OpFOrdGreaterThanEqual: Result = X >= Y; return true;
	case OpFUnordGreaterThanEqual: Result = !(X < Y); return true;
	case OpShiftLeftLogical: Result = A << (B & 31); return true;
	case OpShiftRightLogical: Result = A >> (B & 31); return true;
	case OpShiftRightArithmetic: Result = uint32_t(I >> (B & 31)); return true;
	case OpBitwiseOr: Result = A | B; return true;
	case OpBitwiseXor: Result = A ^ B; return true;
	case OpBitwiseAnd: Result = A & B; return true;
	case OpNot: Result = ~A; return true;
	case OpBitCount: Result = uint32_t(__builtin_popcount(A)); return true;
	case OpBitReverse:
		Result = 0;
		for (int Bit = 0; Bit < 32; ++Bit)
		{
			Result |= FWord((A >> Bit) & 1) << (31 - Bit);
		}
		return true;
	default:
		return false;
	}
	// clang-format on
}

template<typename Real>
bool EvaluateExtended(uint32_t Ext, const TSpirvWord<Real>* Operands, TSpirvWord<Real>& Result)
{
	using FWord = TSpirvWord<Real>;
	const uint32_t A = uint32_t(Operands[0]);
	const uint32_t B = uint32_t(Operands[1]);
	const uint32_t C = uint32_t(Operands[2]);
	const Real X = ToSpirvReal<Real>(Operands[0]);
	const Real Y = ToSpirvReal<Real>(Operands[1]);
	const Real Z = ToSpirvReal<Real>(Operands[2]);
	const int32_t I = int32_t(A);
	const int32_t J = int32_t(B);
	const auto Give = [&Result](Real Value)
	{
		Result = ToSpirvWord<Real>(Value);
		return true;
	};
	// clang-format off
	switch (Ext)
	{
	case ExtRound: case ExtRoundEven: return Give(std::nearbyint(X));
	case ExtTrunc: return Give(std::trunc(X));
	case ExtFloor: return Give(std::floor(X));
	case ExtCeil: return Give(std::ceil(X));
	case ExtFract: return Give(X - std::floor(X));
	case ExtFAbs: Result = Operands[0] & ~(FWord(1) << (8 * sizeof(Real) - 1)); return true;
	case ExtSqrt: return Give(std::sqrt(X));
	case ExtInverseSqrt: return Give(Real(1) / std::sqrt(X));
	case ExtFMin: case ExtNMin: return Give(MinNumber(X, Y));
	case ExtFMax: case ExtNMax: return Give(MaxNumber(X, Y));
	case ExtFClamp: case ExtNClamp: return Give(MinNumber(MaxNumber(X, Y), Z));
	case ExtFma: return Give(X * Y + Z);
	case ExtSAbs: Result = I < 0 ? 0u - A : A; return true;
	case ExtSSign: Result = I > 0 ? 1u : I < 0 ? ~0u : 0u; return true;
	case ExtUMin: Result = A < B ? A : B; return true;
	case ExtUMax: Result = A > B ? A : B; return true;
	case ExtSMin: Result = uint32_t(I < J ? I : J); return true;
	case ExtSMax: Result = uint32_t(I > J ? I : J); return true;
	case ExtUClamp:
	{
		const uint32_t Low = A > B ? A : B;
		Result = Low < C ? Low : C;
		return true;
	}
	case ExtSClamp:
	{
		const int32_t Low = I > J ? I : J;
		Result = uint32_t(Low < int32_t(C) ? Low : int32_t(C));
		return true;
	}
	case ExtFindILsb: Result = A ? uint32_t(__builtin_ctz(A)) : ~0u; return true;
	case ExtFindUMsb: Result = A ? uint32_t(31 - __builtin_clz(A)) : ~0u; return true;
	case ExtFindSMsb:
	{
		const uint32_t Magnitude = I < 0 ? ~A : A;
		Result = Magnitude ? uint32_t(31 - __builtin_clz(Magnitude)) : ~0u;
		return true;
	}
	// The library's own functions.
	case ExtFSign: return Give(Lanes::Sign(X));
	case ExtRadians: return Give(Lanes::Radians(X));
	case ExtDegrees: return Give(Lanes::Degrees(X));
	case ExtSin: return Give(Lanes::Sin(X));
	case ExtCos: return Give(Lanes::Cos(X));
	case ExtTan: return Give(Lanes::Tan(X));
	case ExtAsin: return Give(Lanes::Asin(X));
	case ExtAcos: return Give(Lanes::Acos(X));
	case ExtAtan: return Give(Lanes::Atan(X));
	case ExtSinh: return Give(Lanes::Sinh(X));
	case ExtCosh: return Give(Lanes::Cosh(X));
	case ExtTanh: return Give(Lanes::Tanh(X));
	case ExtAtan2: return Give(Lanes::Atan2(X, Y));
	case ExtPow: return Give(Lanes::Pow(X, Y));
	case ExtExp: return Give(Lanes::Exp(X));
	case ExtLog: return Give(Lanes::Log(X));
	case ExtExp2: return Give(Lanes::Exp2(X));
	case ExtLog2: return Give(Lanes::Log2(X));
	case ExtFMix: return Give(Lanes::Mix(X, Y, Z));
	case ExtStep: return Give(Lanes::Step(X, Y));
	case ExtSmoothStep: return Give(Lanes::SmoothStep(X, Y, Z));
	default:
		return false;
	}
	// clang-format on
}

template bool EvaluateOperation<float>(uint16_t, const uint64_t*, uint64_t&);
template bool EvaluateOperation<double>(uint16_t, const uint64_t*, uint64_t&);
template bool EvaluateExtended<float>(uint32_t, const uint64_t*, uint64_t&);
template bool EvaluateExtended<double>(uint32_t, const uint64_t*, uint64_t&);

} // namespace Drydock
