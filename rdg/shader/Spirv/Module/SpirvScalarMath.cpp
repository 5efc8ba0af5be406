// Computes single scalars as Direct3D rules. Source: D3D11 functional specification, section 3 (conversions, NaN rules,
// shifts by five bits).
#include "SpirvScalarMath.h"

#include "Lanes.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

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

/** TBits: uint32_t or uint64_t. D3D has no signed division: by zero, all bits are set as in its udiv, and the most
 * negative number wraps. */
template<typename TBits>
bool EvaluateInteger(uint16_t Op, TBits A, TBits B, uint64_t& Result)
{
	using FSigned = std::make_signed_t<TBits>;
	constexpr int NumBits = 8 * sizeof(TBits);
	const FSigned I = FSigned(A);
	const FSigned J = FSigned(B);
	const bool bWraps = J == -1; // the one division that leaves the range, and its neighbours that do not
	// clang-format off
	switch (Op)
	{
	case OpSNegate: Result = TBits(0) - A; return true;
	case OpIAdd: Result = A + B; return true;
	case OpISub: Result = A - B; return true;
	case OpIMul: Result = A * B; return true;
	case OpUDiv: Result = B ? A / B : ~TBits(0); return true;
	case OpUMod: Result = B ? A % B : ~TBits(0); return true;
	case OpSDiv: Result = J == 0 ? ~TBits(0) : bWraps ? TBits(0) - A : TBits(I / J); return true;
	case OpSRem: case OpSMod: Result = J == 0 ? ~TBits(0) : bWraps ? TBits(0) : TBits(I % J); return true;
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
	case OpShiftLeftLogical: Result = A << (B & (NumBits - 1)); return true;
	case OpShiftRightLogical: Result = A >> (B & (NumBits - 1)); return true;
	case OpShiftRightArithmetic: Result = TBits(I >> (B & (NumBits - 1))); return true;
	case OpBitwiseOr: Result = A | B; return true;
	case OpBitwiseXor: Result = A ^ B; return true;
	case OpBitwiseAnd: Result = A & B; return true;
	case OpNot: Result = ~A; return true;
	case OpBitCount: Result = uint64_t(__builtin_popcountll(A)); return true;
	case OpBitReverse:
		Result = 0;
		for (int Bit = 0; Bit < NumBits; ++Bit)
		{
			Result |= uint64_t((A >> Bit) & 1) << (NumBits - 1 - Bit);
		}
		return true;
	default:
		return false;
	}
	// clang-format on
}

template<typename TBits>
bool EvaluateExtendedInteger(uint32_t Ext, TBits A, TBits B, TBits C, uint64_t& Result)
{
	using FSigned = std::make_signed_t<TBits>;
	const FSigned I = FSigned(A);
	const FSigned J = FSigned(B);
	const TBits Magnitude = I < 0 && Ext == ExtFindSMsb ? ~A : A;
	// clang-format off
	switch (Ext)
	{
	case ExtSAbs: Result = I < 0 ? TBits(0) - A : A; return true;
	case ExtSSign: Result = I > 0 ? TBits(1) : I < 0 ? ~TBits(0) : TBits(0); return true;
	case ExtUMin: Result = A < B ? A : B; return true;
	case ExtUMax: Result = A > B ? A : B; return true;
	case ExtSMin: Result = I < J ? A : B; return true;
	case ExtSMax: Result = I > J ? A : B; return true;
	case ExtUClamp: Result = A > B ? A : B; Result = Result < C ? Result : C; return true;
	case ExtSClamp: Result = I > J ? A : B; Result = FSigned(Result) < FSigned(C) ? Result : C; return true;
	case ExtFindILsb: Result = A ? TBits(__builtin_ctzll(A)) : ~TBits(0); return true;
	case ExtFindUMsb: case ExtFindSMsb:
		Result = Magnitude ? TBits(63 - __builtin_clzll(Magnitude)) : ~TBits(0);
		return true;
	default:
		return false;
	}
	// clang-format on
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
	const auto Ones = [](uint64_t Count)
	{
		return uint32_t((uint64_t(1) << std::min<uint64_t>(Count, 32)) - 1);
	};
	// clang-format off
	switch (Op)
	{
	case OpBitFieldInsert:
		Result = (A & ~(Ones(Operands[3]) << (Operands[2] & 31))) | ((B & Ones(Operands[3])) << (Operands[2] & 31));
		return true;
	case OpBitFieldUExtract: Result = (A >> (B & 31)) & Ones(Operands[2]); return true;
	case OpBitFieldSExtract:
		Result = (A >> (B & 31)) & Ones(Operands[2]);
		Result |= Operands[2] && Operands[2] < 32 && Result >> (Operands[2] - 1) & 1 ? ~Ones(Operands[2]) : 0u;
		return true;
	case OpCopyObject: Result = Operands[0]; return true;
	case OpConvertFToU: Result = FloatToUint(X); return true;
	case OpConvertFToS: Result = FloatToInt(X); return true;
	case OpConvertSToF: Result = ToBits(Real(I)); return true;
	case OpConvertUToF: Result = ToBits(Real(A)); return true;
	case OpFNegate: Result = Operands[0] ^ SignBit; return true;
	case OpFAdd: Result = ToBits(X + Y); return true;
	case OpFSub: Result = ToBits(X - Y); return true;
	case OpFMul: Result = ToBits(X * Y); return true;
	case OpFDiv: Result = ToBits(X / Y); return true;
	case OpFRem: case OpFMod: Result = ToBits(X - Y * std::trunc(X / Y)); return true;
	case OpIsNan: Result = X != X; return true;
	case OpIsInf: Result = std::isinf(X); return true;
	case OpLogicalEqual: Result = A == B; return true;
	case OpLogicalNotEqual: Result = A != B; return true;
	case OpLogicalOr: Result = A | B; return true;
	case OpLogicalAnd: Result = A & B; return true;
	case OpLogicalNot: Result = !A; return true;
	case OpSelect: Result = Operands[0] ? Operands[1] : Operands[2]; return true;
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
	default:
		return EvaluateInteger(Op, A, B, Result);
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
	case ExtAsinh: return Give(Lanes::Asinh(X));
	case ExtAcosh: return Give(Lanes::Acosh(X));
	case ExtAtanh: return Give(Lanes::Atanh(X));
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
		return EvaluateExtendedInteger(Ext, A, B, C, Result);
	}
	// clang-format on
}

bool EvaluateLong(uint16_t Op, const uint64_t* Operands, uint64_t& Result)
{
	return EvaluateInteger(Op, Operands[0], Operands[1], Result);
}

bool EvaluateExtendedLong(uint32_t Ext, const uint64_t* Operands, uint64_t& Result)
{
	return EvaluateExtendedInteger(Ext, Operands[0], Operands[1], Operands[2], Result);
}

template bool EvaluateOperation<float>(uint16_t, const uint64_t*, uint64_t&);
template bool EvaluateOperation<double>(uint16_t, const uint64_t*, uint64_t&);
template bool EvaluateExtended<float>(uint32_t, const uint64_t*, uint64_t&);
template bool EvaluateExtended<double>(uint32_t, const uint64_t*, uint64_t&);

} // namespace Drydock
