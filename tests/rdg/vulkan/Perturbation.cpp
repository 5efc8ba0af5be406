// The bounds of each operation.
#include "Perturbation.h"

#include <cmath>
#include <cstring>

namespace Drydock::Test
{

using namespace Spirv;

namespace
{

/** Distance of floats near X; flushed numbers count as the smallest normal one. */
double Ulp(double X)
{
	const double Magnitude = std::max(std::fabs(X), 0x1p-126);
	return std::ldexp(1.0, std::ilogb(Magnitude) - 23);
}

/** exp2 is off by 3 + 2 |x| ulp. */
double GetExpBound(double X, double Result)
{
	return (3 + 2 * std::fabs(X)) * Ulp(Result);
}

/** log2: 3 ulp, between 0.5 and 2 an absolute 2^-21. */
double GetLogBound(double X, double Result)
{
	return X >= 0.5 && X <= 2 ? 0x1p-21 : 3 * Ulp(Result);
}

constexpr double SmallestNormal = 0x1p-126;
constexpr double LargestFlushedLog = -126; // log2 of it

/** pow is exp2(y * log2(x)). */
double GetPowBound(double X, double Y, double Result)
{
	const double Log = std::log2(X);
	const double Exponent = Y * Log;
	const double ExponentBound = std::fabs(Y) * GetLogBound(X, Log) + Ulp(Exponent);
	return GetExpBound(Exponent, Result) + std::fabs(Result) * std::expm1(ExponentBound * std::log(2.0));
}

} // namespace

FPerturbation::FPerturbation(
	TSpirvThread<float>& InThread, const FSpirvProgram& InProgram, FMoves& InMoves, double InTexels)
	: Thread(InThread)
	, Program(InProgram)
	, Moves(InMoves)
	, Texels(InTexels)
{
}

void FPerturbation::Prepare(FSpirvProgram& Program)
{
	for (FSpirvStep& Step : Program.Steps)
	{
		const bool bSample = Step.I->Op == OpImageSampleImplicitLod || Step.I->Op == OpImageSampleExplicitLod;
		const bool bReal = Step.I->Type != 0 && Program.Module.GetType(Step.I->Type).NumScalars > 0 && Step.Size > 0 &&
						   Program.Module.GetScalarKind(Step.I->Type, 0) == ESpirvType::Float;
		Step.bHook = bSample || bReal;
	}
}

float FPerturbation::Read(const FSpirvStep& Step, size_t Operand, uint32_t Index) const
{
	const uint32_t Size = Program.ArgSizes[Step.FirstArg + Operand];
	return float(Thread.GetReal(Program.Args[Step.FirstArg + Operand] + (Size == 1 ? 0 : Index)));
}

void FPerturbation::Move(const FSpirvStep& Step, uint32_t Index, double Bound)
{
	const double Value = Thread.GetReal(Step.To + Index);
	if (!std::isfinite(Value) || !std::isfinite(Bound) || !(Bound > 0)) // exp2 of an infinity is exact
	{
		return;
	}
	const float Moved = float(Value + Moves.Next() * Bound);
	Thread.GetWords()[Step.To + Index] = __builtin_bit_cast(uint32_t, Moved);
}

void FPerturbation::OnStep(const FSpirvThreadView&, const FSpirvStep& Step)
{
	if (bInside)
	{
		return;
	}
	switch (Step.I->Op)
	{
	case OpFAdd:
	case OpFSub:
	case OpFMul:
	case OpVectorTimesScalar:
	case OpMatrixTimesScalar:
	case OpConvertSToF:
	case OpConvertUToF:
	case OpDPdx:
	case OpDPdy:
	case OpDPdxFine:
	case OpDPdyFine:
	case OpDPdxCoarse:
	case OpDPdyCoarse:
		// Rounded once, and a driver may fuse a product with the sum that takes it.
		for (uint32_t i = 0; i < Step.Size; ++i)
		{
			Move(Step, i, Ulp(Thread.GetReal(Step.To + i)));
		}
		return;
	case OpFwidth: // a sum of two differences
	case OpFwidthFine:
	case OpFwidthCoarse:
		for (uint32_t i = 0; i < Step.Size; ++i)
		{
			Move(Step, i, 2 * Ulp(Thread.GetReal(Step.To + i)));
		}
		return;
	case OpFDiv:
		for (uint32_t i = 0; i < Step.Size; ++i)
		{
			Move(Step, i, 2.5 * Ulp(Thread.GetReal(Step.To + i)));
		}
		return;
	case OpFMod:
	case OpFRem:
		for (uint32_t i = 0; i < Step.Size; ++i)
		{
			Move(Step, i, 3 * Ulp(Read(Step, 0, i)));
		}
		return;
	case OpDot:
	case OpVectorTimesMatrix:
	case OpMatrixTimesVector:
	case OpMatrixTimesMatrix:
	case OpOuterProduct:
		MoveProducts(Step);
		return;
	case OpImageSampleImplicitLod:
	case OpImageSampleExplicitLod:
		SampleBeside(Step);
		return;
	case OpExtInst:
		MoveExtended(Step);
		return;
	default:
		return; // exact: moves, selections, conversions to integers, loads
	}
}

/** What came of a zero stays, or becomes Value, the farthest that it can. */
void FPerturbation::MoveFromZero(const FSpirvStep& Step, uint32_t Index, double Value)
{
	if (Moves.NextChoice())
	{
		Thread.GetWords()[Step.To + Index] = __builtin_bit_cast(uint32_t, float(Value));
	}
}

/** Sums of products in any order: each term's rounding counts by the size of the largest sum there can be. */
void FPerturbation::MoveProducts(const FSpirvStep& Step)
{
	double Largest[2] = {};
	for (size_t Operand = 0; Operand < 2; ++Operand)
	{
		for (uint32_t i = 0; i < Program.ArgSizes[Step.FirstArg + Operand]; ++i)
		{
			Largest[Operand] = std::max(Largest[Operand], double(std::fabs(Read(Step, Operand, i))));
		}
	}
	constexpr double Terms = 4;
	for (uint32_t i = 0; i < Step.Size; ++i)
	{
		Move(Step, i, Terms * Ulp(Terms * Largest[0] * Largest[1]));
	}
}

/** The same sample a little beside. Bilinear weights are then off by as much. */
void FPerturbation::SampleBeside(const FSpirvStep& Step)
{
	const uint32_t First = Program.Args[Step.FirstArg + 1];
	const uint32_t Count = std::min<uint32_t>(Program.ArgSizes[Step.FirstArg + 1], 3);
	const uint32_t Saved[3] = {uint32_t(Thread.GetBits(First)), Count > 1 ? Thread.GetBits(First + 1) : 0,
		Count > 2 ? Thread.GetBits(First + 2) : 0};
	constexpr double Size = 16; // the smaller side of a picture, GMadeSizeY
	for (uint32_t i = 0; i < std::min(Count, 2u); ++i)
	{
		const double Value = Thread.GetReal(First + i);
		const float Moved = float(Value + Moves.Next() * (Texels / Size + Ulp(Value)));
		Thread.GetWords()[First + i] = __builtin_bit_cast(uint32_t, Moved);
	}
	bInside = true;
	Thread.ExecuteStep(Step);
	bInside = false;
	for (uint32_t i = 0; i < Count; ++i)
	{
		Thread.GetWords()[First + i] = Saved[i];
	}
	for (uint32_t i = 0; i < Step.Size; ++i)
	{
		Move(Step, i, 4 * Ulp(Thread.GetReal(Step.To + i)));
	}
}

void FPerturbation::MoveExtended(const FSpirvStep& Step)
{
	constexpr size_t X = 2; // the first operand behind set and number
	for (uint32_t i = 0; i < Step.Size; ++i)
	{
		const double Result = Thread.GetReal(Step.To + i);
		const double One = Ulp(Result);
		switch (Step.I->Operands[1])
		{
		case ExtSqrt: // 1 / inversesqrt
			Move(Step, i, 5 * One);
			break;
		case ExtInverseSqrt:
			Move(Step, i, 2 * One);
			break;
		case ExtExp: // exp2(x * log2(e))
			Move(Step, i, GetExpBound(Read(Step, X, i) * 1.4427, Result) + std::fabs(Read(Step, X, i)) * One);
			break;
		case ExtExp2:
			Move(Step, i, GetExpBound(Read(Step, X, i), Result));
			break;
		case ExtLog:
		case ExtLog2:
			if (std::fabs(Read(Step, X, i)) < SmallestNormal)
			{
				MoveFromZero(Step, i, LargestFlushedLog * (Step.I->Operands[1] == ExtLog ? std::log(2.0) : 1.0));
				break;
			}
			Move(Step, i, GetLogBound(Read(Step, X, i), Result) + One);
			break;
		case ExtPow:
			if (std::fabs(Read(Step, X, i)) < SmallestNormal)
			{
				MoveFromZero(Step, i, std::exp2(LargestFlushedLog * Read(Step, X + 1, i)));
				break;
			}
			Move(Step, i, GetPowBound(Read(Step, X, i), Read(Step, X + 1, i), Result));
			break;
		case ExtSin:
		case ExtCos:
			Move(Step, i, 0x1p-11 * std::max(1.0, std::fabs(double(Read(Step, X, i))) / 3.14159));
			break;
		case ExtTan:
			Move(Step, i, 0x1p-10 * (1 + Result * Result));
			break;
		case ExtAsin:
		case ExtAcos:
		case ExtAtan:
		case ExtAtan2:
		case ExtSinh:
		case ExtCosh:
		case ExtTanh:
			Move(Step, i, 4096 * One);
			break;
		case ExtFMix:
			Move(Step, i, 3 * (Ulp(Read(Step, X, i)) + Ulp(Read(Step, X + 1, i))));
			break;
		case ExtFma:
			Move(Step, i, Ulp(double(Read(Step, X, i)) * double(Read(Step, X + 1, i))) + One);
			break;
		case ExtFract:
			Move(Step, i, Ulp(1));
			break;
		case ExtLength:
		case ExtDistance:
		case ExtNormalize:
		case ExtSmoothStep:
		case ExtRadians:
		case ExtDegrees:
			Move(Step, i, 8 * One);
			break;
		case ExtCross:
		case ExtReflect:
		case ExtRefract:
		case ExtDeterminant:
			Move(Step, i, 8 * (One + Ulp(1)));
			break;
		default: // exact: floor, min, max, clamp, abs, sign, ...
			break;
		}
	}
}

} // namespace Drydock::Test
