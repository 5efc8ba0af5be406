// Emits wave operations. A wave is a pack: the mask of the lanes that run says who takes part.
#include "SpirvEmitter.h"

#include <algorithm>

namespace Drydock
{

using namespace Spirv;

namespace
{

constexpr uint32_t Reduce = 0; // SPIR-V's group operation

struct FWaveArithmetic
{
	uint16_t Op;
	const char* Name;
	ESpirvType Kind;
	const char* Identity;
	const char* LongIdentity; // of 64 bits
};

// clang-format off
constexpr FWaveArithmetic Arithmetic[] = {
	{OpGroupNonUniformIAdd, "FWaveAdd", Uint, "0u", "0"},
	{OpGroupNonUniformFAdd, "FWaveAdd", ESpirvType::Float, "Real(0)", "0"},
	{OpGroupNonUniformIMul, "FWaveMultiply", Uint, "1u", "1"},
	{OpGroupNonUniformFMul, "FWaveMultiply", ESpirvType::Float, "Real(1)", "1"},
	{OpGroupNonUniformSMin, "FWaveMin", Int, "int32_t(2147483647)", "~uint64_t(0) >> 1"},
	{OpGroupNonUniformUMin, "FWaveMin", Uint, "~0u", "~uint64_t(0)"},
	{OpGroupNonUniformFMin, "FWaveMin", ESpirvType::Float, "Real(__builtin_inff())", "__builtin_inf()"},
	{OpGroupNonUniformSMax, "FWaveMax", Int, "(-2147483647 - 1)", "uint64_t(1) << 63"},
	{OpGroupNonUniformUMax, "FWaveMax", Uint, "0u", "0"},
	{OpGroupNonUniformFMax, "FWaveMax", ESpirvType::Float, "Real(-__builtin_inff())", "-__builtin_inf()"},
	{OpGroupNonUniformBitwiseAnd, "FWaveAnd", Uint, "~0u", "~uint64_t(0)"},
	{OpGroupNonUniformBitwiseOr, "FWaveOr", Uint, "0u", "0"},
	{OpGroupNonUniformBitwiseXor, "FWaveXor", Uint, "0u", "0"},
};
// clang-format on

} // namespace

bool FSpirvEmitter::EmitWaveArithmetic(const FSpirvInstruction& I)
{
	const auto A = std::ranges::find(Arithmetic, I.Op, &FWaveArithmetic::Op);
	if (A == std::end(Arithmetic))
	{
		return false;
	}
	const bool bReduce = I.Operands[1] == Reduce;
	for (uint32_t i = 0; i < SizeOf(I.Result); ++i)
	{
		const FEmitScalar Operand = Scalar(I.Operands[2], i);
		const ESpirvType Kind = A->Kind == Int    ? GetSpirvSigned(Operand.Kind)
								: A->Kind == Uint ? GetSpirvUnsigned(Operand.Kind)
												  : Operand.Kind;
		const bool bLong = GetSpirvBytes(Kind) == 8;
		const std::string Identity = bLong ? TypeName(Kind, false) + "(" + A->LongIdentity + ")" : A->Identity;
		const std::string Head = std::string(bReduce ? "WaveReduce<" : "WavePrefix<") + A->Name + ">(e, ";
		const std::string Rest = bReduce ? ")" : ", " + Identity + ")";
		Define(I.Result, i, {WithDenormals(Kind, Head + UseAs(Operand, Kind, true) + Rest), Kind, true, -1});
	}
	return true;
}

bool FSpirvEmitter::EmitWaves(const FSpirvInstruction& I)
{
	if (!IsSpirvWave(I.Op))
	{
		return false;
	}
	if (EmitWaveArithmetic(I))
	{
		return true;
	}
	const auto Operand = [this, &I](size_t At, uint32_t Index, ESpirvType Kind)
	{
		return UseAs(Scalar(I.Operands[At], Index), Kind, true);
	};
	const auto Each = [&](const std::string& Head, const std::string& Rest)
	{
		for (uint32_t i = 0; i < SizeOf(I.Result); ++i)
		{
			const ESpirvType Kind = Module.GetScalarKind(I.Type, i);
			Define(I.Result, i, {Head + Operand(1, i, Kind) + Rest + ")", Kind, true, -1});
		}
	};
	switch (I.Op)
	{
	case OpGroupNonUniformElect:
		Define(I.Result, 0, {"WaveIsFirst(e)", Bool, true, -1});
		return true;
	case OpGroupNonUniformAll:
		Define(I.Result, 0, {"WaveAllTrue(e, " + Operand(1, 0, Bool) + ")", Bool, true, -1});
		return true;
	case OpGroupNonUniformAny:
		Define(I.Result, 0, {"WaveAnyTrue(e, " + Operand(1, 0, Bool) + ")", Bool, true, -1});
		return true;
	case OpGroupNonUniformAllEqual:
	{
		std::string Text;
		for (uint32_t i = 0; i < SizeOf(I.Operands[1]); ++i)
		{
			const ESpirvType Kind = Module.GetScalarKind(Module.GetValueTypeId(I.Operands[1]), i);
			Text += (i ? " & " : "") + ("WaveAllEqual(e, " + Operand(1, i, Kind) + ")");
		}
		Define(I.Result, 0, {Text, Bool, true, -1});
		return true;
	}
	case OpGroupNonUniformBroadcast:
	case OpGroupNonUniformShuffle:
		Each("WaveRead(e, ", ", " + Operand(2, 0, Uint));
		return true;
	case OpGroupNonUniformBroadcastFirst:
		Each("WaveReadFirst(e, ", "");
		return true;
	case OpGroupNonUniformBallot:
		for (uint32_t i = 0; i < 4; ++i)
		{
			const std::string Text =
				i < 2 ? "WaveBallot(e, " + Operand(1, 0, Bool) + ", " + std::to_string(i) + ")" : "U(0u)";
			Define(I.Result, i, {Text, Uint, true, -1});
		}
		return true;
	case OpGroupNonUniformBallotBitCount:
		Define(I.Result, 0,
			{"WaveCountBits(" + Operand(2, 0, Uint) + ", " + Operand(2, 1, Uint) + ", " +
					(I.Operands[1] == Reduce ? "false)" : "true)"),
				Uint, true, -1});
		return true;
	case OpGroupNonUniformQuadBroadcast:
		Each("QuadRead(e, ", ", " + Operand(2, 0, Uint) + ", false");
		return true;
	case OpGroupNonUniformQuadSwap:
		Each("QuadRead(e, ", ", " + Operand(2, 0, Uint) + " + U(1u), true");
		return true;
	default:
		Module.Fail(GetSpirvOpName(I.Op) + " is not supported on the CPU tier", &I);
	}
}

} // namespace Drydock
