// Computes single scalars as Direct3D rules. Source: D3D11 functional specification, section 3 (conversions, NaN rules,
// shifts by five bits).
#include "SpirvScalarMath.h"

#include "Lanes.h"

#include <cmath>
#include <cstring>

namespace Drydock
{

using namespace Spirv;

float ToFloat(uint32_t Bits)
{
	float Value;
	std::memcpy(&Value, &Bits, 4);
	return Value;
}

uint32_t ToBits(float Value)
{
	uint32_t Bits;
	std::memcpy(&Bits, &Value, 4);
	return Bits;
}

namespace
{

// A NaN loses against a number; of two equal operands (zeros) the second is taken.
float MinNumber(float A, float B)
{
	return B != B ? A : A < B ? A : B;
}

float MaxNumber(float A, float B)
{
	return B != B ? A : A > B ? A : B;
}

uint32_t FloatToUint(float X)
{
	return !(X > 0) ? 0 : X >= 4294967296.0f ? 0xFFFFFFFFu : uint32_t(X);
}

uint32_t FloatToInt(float X)
{
	return X != X ? 0 : X >= 2147483648.0f ? 0x7FFFFFFFu : X < -2147483648.0f ? 0x80000000u : uint32_t(int32_t(X));
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

bool EvaluateOperation(uint16_t Op, const uint32_t* Operands, uint32_t& Result)
{
	const uint32_t A = Operands[0];
	const uint32_t B = Operands[1];
	const float X = ToFloat(A);
	const float Y = ToFloat(B);
	const int32_t I = int32_t(A);
	const int32_t J = int32_t(B);
	// clang-format off
	switch (Op)
	{
	case OpCopyObject: case OpBitcast: Result = A; return true;
	case OpConvertFToU: Result = FloatToUint(X); return true;
	case OpConvertFToS: Result = FloatToInt(X); return true;
	case OpConvertSToF: Result = ToBits(float(I)); return true;
	case OpConvertUToF: Result = ToBits(float(A)); return true;
	case OpSNegate: Result = 0u - A; return true;
	case OpFNegate: Result = A ^ 0x80000000u; return true;
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
	case OpSelect: Result = A ? B : Operands[2]; return true;
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
			Result |= ((A >> Bit) & 1) << (31 - Bit);
		}
		return true;
	default:
		return false;
	}
	// clang-format on
}

bool EvaluateExtended(uint32_t Ext, const uint32_t* Operands, uint32_t& Result)
{
	const uint32_t A = Operands[0];
	const float X = ToFloat(A);
	const float Y = ToFloat(Operands[1]);
	const float Z = ToFloat(Operands[2]);
	const int32_t I = int32_t(A);
	const int32_t J = int32_t(Operands[1]);
	const auto Real = [&Result](float Value)
	{
		Result = ToBits(Value);
		return true;
	};
	// clang-format off
	switch (Ext)
	{
	case ExtRound: case ExtRoundEven: return Real(std::nearbyint(X));
	case ExtTrunc: return Real(std::trunc(X));
	case ExtFloor: return Real(std::floor(X));
	case ExtCeil: return Real(std::ceil(X));
	case ExtFract: return Real(X - std::floor(X));
	case ExtFAbs: Result = A & 0x7FFFFFFFu; return true;
	case ExtSqrt: return Real(std::sqrt(X));
	case ExtInverseSqrt: return Real(1.0f / std::sqrt(X));
	case ExtFMin: case ExtNMin: return Real(MinNumber(X, Y));
	case ExtFMax: case ExtNMax: return Real(MaxNumber(X, Y));
	case ExtFClamp: case ExtNClamp: return Real(MinNumber(MaxNumber(X, Y), Z));
	case ExtFma: return Real(X * Y + Z);
	case ExtSAbs: Result = I < 0 ? 0u - A : A; return true;
	case ExtSSign: Result = I > 0 ? 1u : I < 0 ? ~0u : 0u; return true;
	case ExtUMin: Result = A < Operands[1] ? A : Operands[1]; return true;
	case ExtUMax: Result = A > Operands[1] ? A : Operands[1]; return true;
	case ExtSMin: Result = uint32_t(I < J ? I : J); return true;
	case ExtSMax: Result = uint32_t(I > J ? I : J); return true;
	case ExtUClamp:
	{
		const uint32_t Low = A > Operands[1] ? A : Operands[1];
		Result = Low < Operands[2] ? Low : Operands[2];
		return true;
	}
	case ExtSClamp:
	{
		const int32_t Low = I > J ? I : J;
		Result = uint32_t(Low < int32_t(Operands[2]) ? Low : int32_t(Operands[2]));
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
	case ExtFSign: return Real(Lanes::Sign(X));
	case ExtRadians: return Real(Lanes::Radians(X));
	case ExtDegrees: return Real(Lanes::Degrees(X));
	case ExtSin: return Real(Lanes::Sin(X));
	case ExtCos: return Real(Lanes::Cos(X));
	case ExtTan: return Real(Lanes::Tan(X));
	case ExtAsin: return Real(Lanes::Asin(X));
	case ExtAcos: return Real(Lanes::Acos(X));
	case ExtAtan: return Real(Lanes::Atan(X));
	case ExtSinh: return Real(Lanes::Sinh(X));
	case ExtCosh: return Real(Lanes::Cosh(X));
	case ExtTanh: return Real(Lanes::Tanh(X));
	case ExtAtan2: return Real(Lanes::Atan2(X, Y));
	case ExtPow: return Real(Lanes::Pow(X, Y));
	case ExtExp: return Real(Lanes::Exp(X));
	case ExtLog: return Real(Lanes::Log(X));
	case ExtExp2: return Real(Lanes::Exp2(X));
	case ExtLog2: return Real(Lanes::Log2(X));
	case ExtFMix: return Real(Lanes::Mix(X, Y, Z));
	case ExtStep: return Real(Lanes::Step(X, Y));
	case ExtSmoothStep: return Real(Lanes::SmoothStep(X, Y, Z));
	default:
		return false;
	}
	// clang-format on
}

} // namespace Drydock
