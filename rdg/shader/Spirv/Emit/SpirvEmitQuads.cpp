// Emits pixel shaders that run by quads: a pack of N lanes is N / 2 columns of two rows. Lanes of `e` run; those of
// `Live` have pixels to draw that nothing has discarded, the others help them.
#include "SpirvEmitter.h"

namespace Drydock
{

using namespace Spirv;

namespace
{

const char* GetDerivative(uint16_t Op)
{
	return Op == OpDPdx || Op == OpDPdxCoarse       ? "Ddx"
		   : Op == OpDPdy || Op == OpDPdyCoarse     ? "Ddy"
		   : Op == OpFwidth || Op == OpFwidthCoarse ? "Fwidth"
		   : Op == OpDPdxFine                       ? "DdxFine"
		   : Op == OpDPdyFine                       ? "DdyFine"
													: "FwidthFine";
}

} // namespace

std::vector<FEmitScalar> FSpirvEmitter::LoadQuadInput(const FSpirvVariable& Variable)
{
	switch (Variable.BuiltIn)
	{
	case BuiltInFragCoord:
		return {{"ToReal<Real>(X) + R(Real(0.5f))", Float, true, -1},
			{"ToReal<Real>(Y) + R(Real(0.5f))", Float, true, -1}, {"Real(0.0f)", Float, false, -1},
			{"Real(1.0f)", Float, false, -1}};
	case BuiltInFrontFacing:
		return {{"true", ESpirvType::Bool, false, -1}};
	default:
		break;
	}
	return LoadInterpolant(Variable, "InterpolateQuads<Real>(", ", X, Y0)");
}

/** A call of a function that tells the level of a texture at the coordinates in operand 1. */
std::string FSpirvEmitter::QuadLevelOf(const FSpirvInstruction& I, const std::string& Function)
{
	const auto Pair = Definitions.find(I.Operands[0]);
	if (Pair == Definitions.end() || Pair->second->Op != OpSampledImage)
	{
		Module.Fail("SPIR-V: a sample without its texture and sampler", &I);
	}
	const uint32_t Dim = ImageTypeOf(I.Operands[0]).Dim;
	const uint32_t Count = Dim == Dim2D ? 2 : 3; // without an array's layer
	return Function + (Dim == DimCube ? "<true>" : "<false>") + "(e, " + HandleOf(Pair->second->Operands[0]) + ", " +
		   Coordinates(I, 1, Count, true, 0) + ")";
}

bool FSpirvEmitter::EmitQuads(const FSpirvInstruction& I)
{
	if (!Module.bQuads)
	{
		return false;
	}
	const auto Each = [&](size_t Operand, const std::string& Head, const std::string& Rest)
	{
		for (uint32_t i = 0; i < SizeOf(I.Result); ++i)
		{
			const ESpirvType Kind = Module.GetScalarKind(I.Type, i);
			Define(I.Result, i,
				{Head + "(e, " + UseAs(Scalar(I.Operands[Operand], i), Kind, true) + Rest + ")", Kind, true, -1});
		}
	};
	switch (I.Op)
	{
	case OpDemote:
		Line("Live = Live & !e;");
		return true;
	case OpGroupNonUniformQuadBroadcast:
		Each(1, "ReadQuadLane", ", " + UseAs(Scalar(I.Operands[2], 0), Uint, true));
		return true;
	case OpGroupNonUniformQuadSwap:
	{
		const uint32_t Direction = Module.GetConstantScalar(I.Operands[2]); // along x, along y, both
		Each(1, "ReadQuadAcross", Direction == 0 ? ", true, false" : Direction == 1 ? ", false, true" : ", true, true");
		return true;
	}
	case OpImageQueryLod:
	{
		const std::string Level = QuadLevelOf(I, "QuadLevel");
		const FSpirvInstruction& Pair = *Definitions.at(I.Operands[0]);
		const std::string Name = "w" + std::to_string(I.Result);
		Line("const auto " + Name + " = DescribeLevel(" + HandleOf(Pair.Operands[0]) + ", " +
			 HandleOf(Pair.Operands[1]) + ", " + Level + ");");
		for (uint32_t i = 0; i < SizeOf(I.Result); ++i)
		{
			Define(I.Result, i, {Name + "[" + std::to_string(i) + "]", Float, true, -1});
		}
		return true;
	}
	default:
		if (!IsSpirvDerivative(I.Op))
		{
			return false;
		}
		Each(0, GetDerivative(I.Op), "");
		return true;
	}
}

/** Puts the loops around the code of a pack. Code that is the same over a tile stands before them; no code is kept for
 * a row. */
std::string FSpirvEmitter::EmitQuadRun()
{
	std::string Text;
	for (const FDeclaration& D : Declarations)
	{
		Text += "\t" + D.Type + " " + D.Name + (D.Size ? "[" + std::to_string(D.Size) + "]" : std::string()) +
				D.Initial + ";\n";
	}
	return "\tconst uint32_t LoopTurns = GetLoopTurns(Args);\n\t(void)LoopTurns;\n" + Handles + TileText +
		   "\tfor (int32_t Y0 = Tile.MinY & ~1; Y0 < Tile.MaxY; Y0 += 2)\n"
		   "\tfor (int32_t X0 = Tile.MinX & ~1; X0 < Tile.MaxX; X0 += N / 2)\n\t{\n"
		   "\tconst I X = I(X0) + PackColumn<N>();\n"
		   "\tconst I Y = I(Y0) + PackRow<N>();\n"
		   "\tM e = X < I((Tile.MaxX + 1) & ~1);\n"
		   "\tM Live = X >= I(Tile.MinX) & X < I(Tile.MaxX) & Y >= I(Tile.MinY) & Y < I(Tile.MaxY);\n" +
		   Text + Body + "\t}\n";
}

} // namespace Drydock
